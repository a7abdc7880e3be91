#!/usr/bin/env python3
"""Judges duplicates that were found in a folder made by make_copies.py.

    mdbd-query --duplicates --json --db copies.db | judge_copies.py OUT

Tells, for each kind of copy, in how many cases it is in one group with its original, and which pairs
of a group are no copies of one model.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from itertools import combinations
from pathlib import Path


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("folder", metavar="OUT", type=Path, help="the folder that make_copies.py made")
    folder = parser.parse_args().folder.resolve()
    groups = [[Path(model["path"]) for model in group["models"]] for group in json.load(sys.stdin)["groups"]]
    group_of = {path: number for number, group in enumerate(groups) for path in group}

    found, made, missed = Counter(), Counter(), []
    models = sorted(path for path in folder.iterdir() if path.is_dir())
    whole = 0
    for model in models:
        original = group_of.get(model / "original.off")
        files = [path for path in sorted(model.iterdir()) if path.stem != "original"]
        lost = [path for path in files if original is None or group_of.get(path) != original]
        made.update(path.stem for path in files)
        found.update(path.stem for path in files if path not in lost)
        missed += [str(path.relative_to(folder)) for path in lost]
        whole += not lost
    mixed = [sorted({path.parent.name for path in group}) for group in groups]
    false_pairs = sum(
        a.parent != b.parent for group in groups for a, b in combinations(group, 2)
    )
    for kind in sorted(made):
        print(f"{kind:12}{found[kind]:4} of {made[kind]}")
    print(f"whole groups {whole} of {len(models)}; {false_pairs} false pairs in groups")
    for names in mixed:
        if len(names) > 1:
            print("false group: " + ", ".join(names))
    print("missed: " + ", ".join(missed))
    return 0


if __name__ == "__main__":
    sys.exit(main())
