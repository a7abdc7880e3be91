#!/usr/bin/env python3
"""Makes a folder of models with ten kinds of copy of each, to judge the search for duplicates.

    make_copies.py SET OUT     SET: a folder of OFF models, one folder for each class

Every model gets a folder of its own in OUT, which holds `original.off` and its copies, each named after
its kind. Several models come from each class, so that there are near misses. judge_copies.py compares
what was found with the folders. The same --seed gives the same files.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
from pathlib import Path
from random import Random

from mdbd_shapes.sampling import read_off, sample_surface

# Copies that mdbd-perturb makes: the name of the file and the command.
PERTURBED = {
    "reexported.obj": ["convert"],
    "converted.stl": ["convert"],
    "rescaled.off": ["scale", "--factor", "25.4"],
    "mirrored.off": ["mirror"],
    "rotated.ply": ["rotate"],
    "decimated.off": ["decimate", "--keep", "50"],
    "shuffled.off": ["shuffle"],
    "subdivided.off": ["subdivide"],
}
SEEDED = {"mirror", "rotate", "shuffle"}
CLOUD_POINTS = 20_000


class CopiesError(Exception):
    """A reason to stop, worded for the user."""


def choose_models(models: Path, count: int, per_class: int, seed: int) -> list[Path]:
    """Models of as many classes as are needed, `per_class` of each; the seed says which."""
    random = Random(seed)
    classes = [sorted(folder.glob("*.off")) for folder in sorted(models.iterdir()) if folder.is_dir()]
    classes = [members for members in classes if len(members) >= per_class]
    random.shuffle(classes)
    chosen = [model for members in classes for model in random.sample(members, per_class)][:count]
    if len(chosen) < count:
        raise CopiesError(f"{models} has {len(chosen)} such models; {count} are asked for")
    return chosen


def write_cloud(model: Path, out: Path, seed: str) -> None:
    points = sample_surface(*read_off(model), CLOUD_POINTS, Random(seed))
    out.write_text("".join(f"{x:.7g} {y:.7g} {z:.7g}\n" for x, y, z in points), encoding="ascii")


def copy_model(model: Path, folder: Path, perturb: str, seed: int) -> None:
    folder.mkdir(parents=True)
    original = folder / "original.off"
    shutil.copyfile(model, original)
    shutil.copyfile(model, folder / "renamed.off")
    for name, command in PERTURBED.items():
        seeded = ["--seed", str(seed)] if command[0] in SEEDED else []
        subprocess.run([perturb, *command, *seeded, "--quiet", original, folder / name], check=True)
    write_cloud(model, folder / "cloud.xyz", f"{seed}/{model.name}")


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("models", metavar="SET", type=Path, help="OFF models, a folder for each class")
    parser.add_argument("out", metavar="OUT", type=Path, help="a new folder")
    parser.add_argument("--count", type=int, default=30, help="models to copy (default 30)")
    parser.add_argument("--per-class", type=int, default=3, help="of each class (default 3)")
    parser.add_argument("--seed", type=int, default=1, help="of what is random (default 1)")
    parser.add_argument("--perturb", default="mdbd-perturb", help="the program, if not on the PATH")
    return parser.parse_args()


def main() -> int:
    arguments = parse_arguments()
    try:
        if arguments.out.exists():
            raise CopiesError(f"{arguments.out} is there already; name a new folder")
        chosen = choose_models(arguments.models, arguments.count, arguments.per_class, arguments.seed)
        for model in chosen:
            folder = arguments.out / f"{model.parent.name}_{model.stem}"
            copy_model(model, folder, arguments.perturb, arguments.seed)
    except (CopiesError, OSError, subprocess.CalledProcessError) as error:
        print(f"make_copies.py: error: {error}", file=sys.stderr)
        return 1
    print(f"{len(chosen)} models with {len(PERTURBED) + 2} copies each in {arguments.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
