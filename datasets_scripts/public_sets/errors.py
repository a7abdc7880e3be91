"""The one error of this package."""


class FetchError(Exception):
    """A reason to stop, worded for the user."""
