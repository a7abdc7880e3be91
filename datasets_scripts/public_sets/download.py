"""Downloads that can be taken up again, and checksums."""

from __future__ import annotations

import hashlib
import http.client
import sys
import urllib.error
import urllib.parse
import urllib.request
from pathlib import Path

from .errors import FetchError

CHUNK = 1 << 20
TIMEOUT_SECONDS = 30
ALGORITHMS = {32: "md5", 40: "sha1", 64: "sha256"}  # by the number of hexadecimal digits


class Progress:
    """One line on a terminal, nothing elsewhere."""

    def __init__(self, name: str, total: int | None):
        self.name, self.total = name, total
        self.visible = sys.stderr.isatty()

    def show(self, done: int) -> None:
        if self.visible:
            share = f" of {self.total / 1e6:.1f}" if self.total else ""
            line = f"\r{self.name}: {done / 1e6:.1f}{share} MB "
            print(line, end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        if self.visible:
            print(file=sys.stderr)


def _reason(error: Exception) -> str:
    if isinstance(error, urllib.error.HTTPError):
        return f"it answered {error.code} {error.reason}"
    if isinstance(error, urllib.error.URLError):
        return str(error.reason)
    return str(error) or type(error).__name__


def _request(url: str, part: Path, tag: Path) -> urllib.request.Request:
    """A request for the rest of a file, if the beginning is known to belong to the same version."""
    request = urllib.request.Request(url, headers={"User-Agent": "mdbd-datasets"})
    if part.exists() and tag.exists():
        request.add_header("Range", f"bytes={part.stat().st_size}-")
        request.add_header("If-Range", tag.read_text())
    return request


def _expected_size(response: http.client.HTTPResponse, start: int) -> int | None:
    length = response.headers.get("Content-Length", "")
    return start + int(length) if length.isdigit() else None


def _receive(url: str, part: Path, tag: Path, limit: int) -> None:
    with urllib.request.urlopen(_request(url, part, tag), timeout=TIMEOUT_SECONDS) as response:
        resumed = response.status == 206
        start = part.stat().st_size if resumed else 0
        validator = response.headers.get("ETag") or response.headers.get("Last-Modified")
        tag.unlink(missing_ok=True)
        if validator and not validator.startswith("W/"):
            tag.write_text(validator)
        total = _expected_size(response, start)
        progress = Progress(part.stem, total)
        done = start
        try:
            with part.open("ab" if resumed else "wb") as file:
                while chunk := response.read(CHUNK):
                    file.write(chunk)
                    done += len(chunk)
                    if done > limit:
                        raise FetchError(f"{url} is too large (see --max-size)")
                    progress.show(done)
        finally:
            progress.close()
    if total is not None and done != total:
        raise ConnectionError(f"the connection ended after {done} of {total} bytes")


def download(url: str, target: Path, limit: int) -> None:
    """Fetches url into target by way of target.part; a part left by an earlier run is continued.
    Throws OSError or http.client.HTTPException when the address does not deliver."""
    if urllib.parse.urlsplit(url).scheme not in ("http", "https"):
        raise FetchError(f"{url} is not a web address")
    part, tag = target.with_name(target.name + ".part"), target.with_name(target.name + ".tag")
    try:
        _receive(url, part, tag, limit)
    except urllib.error.HTTPError as error:
        if error.code != 416:
            raise
        part.unlink(missing_ok=True)
        tag.unlink(missing_ok=True)
        _receive(url, part, tag, limit)
    tag.unlink(missing_ok=True)
    part.replace(target)


def download_any(urls: tuple[str, ...], target: Path, limit: int, save_as: str) -> None:
    """Tries several addresses in turn; save_as says what to do by hand if none delivers."""
    problems = []
    for url in urls:
        try:
            download(url, target, limit)
            return
        except (OSError, http.client.HTTPException) as error:
            problems.append(f"cannot reach {urllib.parse.urlsplit(url).netloc}: {_reason(error)}")
    reasons = "; ".join(dict.fromkeys(problems))
    raise FetchError(f"{reasons}; download it by hand from {' or '.join(urls)} {save_as}")


def digest(path: Path, algorithm: str) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, algorithm).hexdigest()


def verify(path: Path, expected: str) -> None:
    """Compares a file with its known checksum; the length of the checksum tells the algorithm."""
    algorithm = ALGORITHMS[len(expected)]
    actual = digest(path, algorithm)
    if actual != expected.lower():
        raise FetchError(
            f"{path} does not match its checksum: {algorithm} is {actual}, expected {expected}; "
            "delete the file and download it again"
        )


def read_sums(path: Path) -> dict[str, str]:
    """Reads a list in the manner of sha256sum or md5sum: checksum, blanks, file name."""
    sums = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        fields = line.split(None, 1)
        if not fields:
            continue
        known = len(fields) == 2 and len(fields[0]) in ALGORITHMS
        if not known or set(fields[0].lower()) - set("0123456789abcdef"):
            raise FetchError(f"{path}, line {number}: expected a checksum and a file name")
        sums[fields[1].lstrip("*").strip()] = fields[0]
    return sums
