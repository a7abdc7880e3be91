#!/usr/bin/env python3
"""Generates a labelled demo collection of 3D models; the folders are the labels.

The models are parametric everyday things and mechanical parts, in random positions and sizes, as a
mixture of OFF, OBJ, PLY and STL files. The same seed gives the same files.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path
from random import Random

from mdbd_shapes.families import FAMILIES
from mdbd_shapes.mesh import Mesh
from mdbd_shapes.mesh_files import BY_ENDING, FORMATS, write_mesh
from mdbd_shapes.transforms import random_pose


class DemoError(Exception):
    """A reason to stop, worded for the user."""


def make_model(family: str, stream: str) -> Mesh:
    """One model of a family; the text seeds a generator for the shape and one for the position."""
    mesh = FAMILIES[family](Random(f"{stream}/shape"))
    return random_pose(mesh, Random(f"{stream}/pose"))


def check_output(out: Path, force: bool) -> None:
    if out.exists() and not out.is_dir():
        raise DemoError(f"{out} is not a folder")
    if out.is_dir() and any(out.iterdir()) and not force:
        raise DemoError(f"{out} is not empty: choose another folder, or add --force")


def write_collection(out: Path, seed: int, per_family: int) -> Counter[str]:
    """Writes all families and returns the number of models of each format."""
    formats: Counter[str] = Counter()
    for row, family in enumerate(FAMILIES):
        folder = out / family
        folder.mkdir(parents=True, exist_ok=True)
        for number in range(1, per_family + 1):
            ending, name, encoder = FORMATS[(row + number) % len(FORMATS)]
            mesh = make_model(family, f"{seed}/{family}/{number}")
            write_mesh(mesh, folder / f"{family}_{number:02d}{ending}", encoder)
            formats[name] += 1
    return formats


def write_query(path: Path, seed: int) -> None:
    """Writes one chair that is not in the collection."""
    path.parent.mkdir(parents=True, exist_ok=True)
    write_mesh(make_model("chair", f"{seed}/query"), path, BY_ENDING[path.suffix.lower()])


def parse_arguments(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description="Generate a labelled demo collection of 3D models; the folders are the labels.",
        epilog="example: generate_demo.py demo/models --query demo/chair.ply",
    )
    parser.add_argument("out", metavar="OUT", type=Path, help="folder to write into, new or empty")
    parser.add_argument("--seed", type=int, default=1, help="the models depend on it (default 1)")
    parser.add_argument(
        "--per-family", type=int, default=10, metavar="N", help="models of each family (default 10)"
    )
    parser.add_argument(
        "--query", type=Path, metavar="FILE", help="also write a chair that is not among them"
    )
    parser.add_argument("--force", action="store_true", help="OUT need not be empty")
    options = parser.parse_args(arguments)
    if options.per_family < 1:
        parser.error("--per-family must be at least 1")
    if options.query:
        if options.query.suffix.lower() not in BY_ENDING:
            parser.error(f"--query: the file must end in {', '.join(BY_ENDING)}")
        if options.query.resolve().is_relative_to(options.out.resolve()):
            parser.error("--query: the file must lie outside the collection")
    return options


def main(arguments: list[str] | None = None) -> int:
    options = parse_arguments(arguments)
    try:
        check_output(options.out, options.force)
        formats = write_collection(options.out, options.seed, options.per_family)
        if options.query:
            write_query(options.query, options.seed)
    except (DemoError, OSError) as error:
        print(f"generate_demo.py: {error}", file=sys.stderr)
        return 1
    mixture = ", ".join(f"{count} {name}" for name, count in sorted(formats.items()))
    print(
        f"{len(FAMILIES)} families, {formats.total()} models in {options.out} ({mixture})",
        file=sys.stderr,
    )
    if options.query:
        print(f"query: {options.query}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
