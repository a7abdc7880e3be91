"""Unpacking archives from the network: no path leaves the folder, no links, bounded size."""

from __future__ import annotations

import gzip
import lzma
import shutil
import stat
import subprocess
import tarfile
import zipfile
import zlib
from pathlib import Path, PurePosixPath
from typing import IO

from .errors import FetchError

CHUNK = 1 << 20
# What the standard library throws at damaged archives.
DAMAGE = (
    zipfile.BadZipFile,
    tarfile.TarError,
    gzip.BadGzipFile,
    zlib.error,
    lzma.LZMAError,
    EOFError,
    RuntimeError,
    ValueError,
)
SEVEN_ZIP_MAGIC = b"7z\xbc\xaf\x27\x1c"


class _Room:
    """The folder that an archive is unpacked into, and the bytes that are still allowed."""

    def __init__(self, archive: Path, folder: Path, limit: int):
        self.archive, self.folder, self.limit, self.left = archive, folder, limit, limit

    def place(self, name: str) -> Path:
        """Where an entry goes; refuses names that lead out of the folder."""
        path = PurePosixPath(name.replace("\\", "/"))
        outside = path.is_absolute() or not path.parts or ".." in path.parts
        if outside or ":" in path.parts[0] or "\0" in name:
            raise FetchError(f"{self.archive} is not safe to unpack: it holds the path {name!r}")
        return self.folder / path

    def take(self, count: int) -> None:
        self.left -= count
        if self.left < 0:
            size = f"{self.limit / 2**30:g} GiB"
            raise FetchError(f"{self.archive} unpacks to more than {size} (see --max-size)")

    def refuse_link(self, name: str) -> None:
        raise FetchError(f"{self.archive} is not safe to unpack: {name!r} is a link or a device")

    def write(self, name: str, source: IO[bytes]) -> None:
        target = self.place(name)
        target.parent.mkdir(parents=True, exist_ok=True)
        with target.open("wb") as file:
            while chunk := source.read(CHUNK):
                self.take(len(chunk))
                file.write(chunk)


def _unpack_zip(room: _Room) -> None:
    with zipfile.ZipFile(room.archive) as archive:
        for entry in archive.infolist():
            mode = entry.external_attr >> 16
            if stat.S_IFMT(mode) not in (0, stat.S_IFREG, stat.S_IFDIR):
                room.refuse_link(entry.filename)
            if entry.is_dir():
                room.place(entry.filename)
                continue
            with archive.open(entry) as source:
                room.write(entry.filename, source)


def _unpack_tar(room: _Room) -> None:
    with tarfile.open(room.archive) as archive:
        for entry in archive:
            if entry.name in (".", "./"):
                continue
            room.place(entry.name)
            if entry.isdir():
                continue
            if not entry.isreg():
                room.refuse_link(entry.name)
            source = archive.extractfile(entry)
            assert source is not None  # true of regular files
            room.write(entry.name, source)


def _run_seven_zip(program: str, *arguments: str) -> str:
    command = [program, *arguments, "-p"]  # an empty password instead of a question
    run = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    if run.returncode != 0:
        lines = (run.stderr or run.stdout).strip().splitlines()
        raise EOFError(lines[-1] if lines else f"7z failed with code {run.returncode}")
    return run.stdout


def _unpack_seven_zip(room: _Room) -> None:
    """7z archives need the program 7z: its listing is checked before anything is written."""
    program = next(filter(None, map(shutil.which, ("7z", "7zz", "7za"))), None)
    if program is None:
        raise FetchError(
            f"{room.archive} is a 7z archive: install 7z (Debian: p7zip-full) and run again, or "
            "unpack it by hand and run again with --from FOLDER"
        )
    listing = _run_seven_zip(program, "l", "-slt", "-ba", str(room.archive))
    for block in listing.split("\n\n"):
        entry = dict(line.split(" = ", 1) for line in block.splitlines() if " = " in line)
        if "Path" in entry:
            room.place(entry["Path"])
            if " l" in entry.get("Attributes", ""):
                room.refuse_link(entry["Path"])
            room.take(int(entry.get("Size") or 0))
    room.folder.mkdir(parents=True, exist_ok=True)
    _run_seven_zip(program, "x", "-y", f"-o{room.folder}", str(room.archive))
    for path in room.folder.rglob("*"):
        if path.is_symlink():
            room.refuse_link(path.name)


def unpack(archive: Path, folder: Path, limit: int) -> None:
    """Unpacks a zip, tar (also compressed) or 7z archive into a folder of its own, at most limit
    bytes. Throws FetchError when the archive is damaged, unsafe, too large or of no known kind."""
    room = _Room(archive, folder, limit)
    with archive.open("rb") as file:
        head = file.read(512)
    try:
        if head.startswith(SEVEN_ZIP_MAGIC):
            _unpack_seven_zip(room)
        elif head.startswith(b"PK"):
            _unpack_zip(room)
        elif b"<html" in head.lower() or b"<!doctype" in head.lower():
            raise FetchError(f"{archive} is a web page, not an archive: has its address moved?")
        else:
            _unpack_tar(room)
    except DAMAGE as e:
        raise FetchError(
            f"{archive} is damaged, cut off or of an unknown kind: {' '.join(str(e).split())}; "
            "delete it and download it again"
        ) from e
