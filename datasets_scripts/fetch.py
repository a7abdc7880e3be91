#!/usr/bin/env python3
"""Fetches a public shape collection and lays it out as one folder for each class.

Downloads go through part files and are taken up again after an interruption; archives are unpacked
without leaving their folder; the result appears under its name only when it is complete. No address
could be tried when this was written, and no published checksums are known: see --list.
"""

from __future__ import annotations

import argparse
import shutil
import sys
from collections import Counter
from pathlib import Path

from public_sets.archives import unpack
from public_sets.download import digest, download_any, read_sums, verify
from public_sets.errors import FetchError
from public_sets.layouts import SPLITS, Placement, Tree, folder_name
from public_sets.table import SETS, UNVERIFIED, Archive, PublicSet


def print_list() -> None:
    for chosen in SETS.values():
        print(chosen.name, chosen.title, f"page: {chosen.page}", sep="\n  ")
        print(f"  licence: {chosen.licence}")
        for archive in chosen.archives:
            checksum = archive.checksum or "no published checksum known"
            print(f"  {archive.name}: {' or '.join(archive.urls)} ({checksum})")
        if chosen.by_hand:
            print(f"  by hand only: {chosen.by_hand}; then --from FILE or FOLDER")
    print(f"\n{UNVERIFIED}")


class Workshop:
    """The folder beside OUT that holds downloads and half-finished work."""

    def __init__(self, out: Path):
        self.out = out
        self.root = out.with_name(f".{out.name}.fetch")
        self.downloads = self.root / "downloads"
        self.unpacked = self.root / "unpacked"
        self.result = self.root / "result"

    def begin(self) -> None:
        if self.out.exists() and (not self.out.is_dir() or any(self.out.iterdir())):
            raise FetchError(f"{self.out} exists and is not an empty folder: choose another name")
        self.clear()
        self.downloads.mkdir(parents=True, exist_ok=True)

    def clear(self) -> None:
        """Removes half-finished work; downloads stay, to be taken up again."""
        for folder in (self.unpacked, self.result):
            shutil.rmtree(folder, ignore_errors=True)
        for folder in (self.downloads, self.root):
            if folder.is_dir() and not any(folder.iterdir()):
                folder.rmdir()

    def finish(self) -> None:
        if self.out.exists():
            self.out.rmdir()
        self.result.rename(self.out)
        shutil.rmtree(self.root)


def download_all(chosen: PublicSet, options: argparse.Namespace, folder: Path) -> list[Path]:
    """Downloads what is not there yet."""
    if chosen.by_hand:
        raise FetchError(
            f"{chosen.name} cannot be downloaded by a script: {chosen.by_hand}; get it by hand "
            f"from {chosen.page} and run again with --from FILE or --from FOLDER"
        )
    several = len(chosen.archives) > 1
    files = []
    for archive in chosen.archives:
        urls = archive.urls
        if options.mirror:
            urls = (f"{options.mirror.rstrip('/')}/{archive.name}",)
        target = folder / archive.name
        advice = "and run again with --from FILE"
        if several:
            advice = f"as {archive.name} into one folder with the set's other archives and run "
            advice += "again with --from FOLDER"
        if not target.exists():
            download_any(urls, target, options.max_size, advice)
        files.append(target)
    return files


def local_files(chosen: PublicSet, source: Path) -> list[Path]:
    """The archives that --from names: one file, or a folder with the set's archives. Empty if it is
    a folder that was unpacked by hand."""
    if not source.exists():
        raise FetchError(f"{source} does not exist")
    names = [archive.name for archive in chosen.archives]
    if source.is_file():
        if len(names) > 1:
            needed = ", ".join(names)
            raise FetchError(f"{chosen.name} has several files: put {needed} into one folder")
        return [source]
    present = [source / name for name in names if (source / name).is_file()]
    if present and len(present) < len(names):
        missing = ", ".join(name for name in names if not (source / name).is_file())
        raise FetchError(f"{source} lacks {missing}")
    return present


def verify_all(chosen: PublicSet, files: list[Path], sums: dict[str, str]) -> list[str]:
    """Checks what has a known checksum; returns the sha256 of every file for the record."""
    known = {archive.name: archive.checksum for archive in chosen.archives if archive.checksum}
    known |= sums
    lines = []
    for path in files:
        if path.name in known:
            verify(path, known[path.name])
        lines.append(f"{digest(path, 'sha256')}  {path.name}")
    return lines


def unpack_all(chosen: PublicSet, files: list[Path], folder: Path, limit: int) -> list[Tree]:
    archives = chosen.archives or (Archive("", ()),)
    trees = []
    for archive, path in zip(archives, files, strict=True):
        target = folder / path.name
        if path.suffix == ".csv":
            target.mkdir(parents=True)
            shutil.copy(path, target)
        else:
            unpack(path, target, limit)
        trees.append(Tree(target, archive.label))
    return trees


def place_all(placements: list[Placement], result: Path, keep: bool) -> Counter[str]:
    """Moves the models to their places, or copies them to keep the originals. A name that is taken
    in its class gets a number."""
    transfer = shutil.copyfile if keep else shutil.move
    counts: Counter[str] = Counter()
    for placement in placements:
        folder = result / folder_name(placement.label)
        folder.mkdir(parents=True, exist_ok=True)
        target, number = folder / placement.name, 1
        while target.exists():
            number += 1
            stem, ending = Path(placement.name).stem, Path(placement.name).suffix
            target = folder / f"{stem}_{number}{ending}"
        transfer(placement.source, target)
        counts[folder.name] += 1
    return counts


def fetch(chosen: PublicSet, options: argparse.Namespace) -> None:
    workshop = Workshop(options.out)
    workshop.begin()
    try:
        if options.source:
            files = local_files(chosen, options.source)
        else:
            files = download_all(chosen, options, workshop.downloads)
        record = verify_all(chosen, files, read_sums(options.sums) if options.sums else {})
        if files:
            trees = unpack_all(chosen, files, workshop.unpacked, options.max_size)
        else:
            trees = [Tree(options.source)]
        placements = chosen.layout(trees, options.split)
        counts = place_all(placements, workshop.result, keep=not files)
        if not counts:
            raise FetchError(f"no models of {chosen.name} were found: is this the right archive?")
        heading = [chosen.title, f"page: {chosen.page}", f"licence: {chosen.licence}"]
        heading += [f"split: {options.split}"] if chosen.has_splits else []
        text = "\n".join(heading + record) + "\n"
        (workshop.result / "SOURCE.txt").write_text(text, encoding="utf-8")
        workshop.finish()
    finally:
        workshop.clear()
    print(
        f"{chosen.name}: {counts.total()} models, {len(counts)} classes in {options.out}",
        file=sys.stderr,
    )


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description="Fetch a public shape collection and lay it out as one folder for each class.",
        epilog="examples: fetch.py coseg_large data/coseg_large; "
        "fetch.py psb data/psb --split train --from ~/Downloads/psb_v1.zip",
    )
    parser.add_argument("set", metavar="SET", nargs="?", help=f"one of {', '.join(SETS)}")
    parser.add_argument("out", metavar="OUT", nargs="?", type=Path, help="folder to create")
    parser.add_argument("--list", action="store_true", help="show the sets, addresses and licences")
    parser.add_argument(
        "--from",
        dest="source",
        type=Path,
        metavar="PATH",
        help="use what is there instead of downloading: the archive, a folder with the set's "
        "archives, or a folder unpacked by hand",
    )
    parser.add_argument("--mirror", metavar="URL", help="download from URL/ARCHIVE instead")
    parser.add_argument(
        "--sums", type=Path, metavar="FILE", help="check against a list made by sha256sum or md5sum"
    )
    parser.add_argument("--split", choices=SPLITS, default="all", help="half of psb and modelnet*")
    parser.add_argument(
        "--max-size",
        type=float,
        default=100.0,
        metavar="GIB",
        help="refuse archives that are larger or unpack to more (default 100)",
    )
    options = parser.parse_args(arguments)
    if options.list:
        return options
    if not options.max_size > 0.0:
        parser.error("--max-size must be positive")
    options.max_size = int(options.max_size * 2**30)
    if options.set is None or options.out is None:
        parser.error("SET and OUT are needed (or --list)")
    if options.set not in SETS:
        parser.error(f"unknown set {options.set}: choose one of {', '.join(SETS)}")
    if options.split != "all" and not SETS[options.set].has_splits:
        parser.error(f"{options.set} has no training and test halves")
    return options


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    if options.list:
        print_list()
        return 0
    try:
        fetch(SETS[options.set], options)
    except (FetchError, OSError) as error:
        print(f"fetch.py: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("fetch.py: interrupted; run again to continue", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
