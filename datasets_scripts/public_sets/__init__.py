"""Fetching public shape collections and laying them out as one folder for each class."""
