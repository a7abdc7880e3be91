#!/usr/bin/env python3
"""Compares the files of one part in two formats: does each find its twin first, and how far is it,
relative to the nearest other part?

    mdbd-index models --db parts.db
    compare_formats.py parts.db step stl [--signature mdbd-fused]

Parts are files of the same name, but for the ending, in the same folder. The distances are those of
mdbd-query, which must be on PATH or in $MDBD_QUERY.
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys


def query(database, identifier, signature="mdbd-100"):
    """All models of the database, the nearest first: their ids, paths and distances."""
    program = os.environ.get("MDBD_QUERY", "mdbd-query")
    command = [program, "--id", str(identifier), "--top", "1000000", "--json", "--db", database,
               "--signature", signature]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    return [(match["id"], pathlib.Path(match["path"]), match["distance"])
            for match in answer["matches"]]


def find_models(database, ending):
    """Ids of the models of an ending, by path without ending."""
    return {path.with_suffix(""): identifier
            for identifier, path, _ in query(database, first_id(database))
            if path.suffix.lower() == "." + ending}


def first_id(database):
    for identifier in range(1, 1_000_000):
        try:
            query(database, identifier)
            return identifier
        except subprocess.CalledProcessError:
            continue
    sys.exit("no model in the database")


def compare(database, left, right, signature):
    """For each part in both formats: the rank of its twin, its distance, and that of the nearest
    other part."""
    twins = find_models(database, right)
    for part, identifier in sorted(find_models(database, left).items()):
        if part not in twins:
            continue
        matches = [(path.with_suffix(""), distance)
                   for _, path, distance in query(database, identifier, signature)
                   if path.suffix.lower() == "." + right]
        rank = next(i for i, (path, _) in enumerate(matches, 1) if path == part)
        displacement = next(distance for path, distance in matches if path == part)
        nearest = min(distance for path, distance in matches if path != part)
        yield part, rank, displacement, nearest


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database")
    parser.add_argument("left")
    parser.add_argument("right")
    parser.add_argument("--signature", default="mdbd-100")
    arguments = parser.parse_args()
    rows = list(compare(arguments.database, arguments.left, arguments.right, arguments.signature))
    if not rows:
        sys.exit("no part in both formats")
    print("rank,displacement,nearest_other,part")
    for part, rank, displacement, nearest in rows:
        print(f"{rank},{displacement:.6g},{nearest:.6g},{part}")
    ratios = [d / n if n > 0 else float("inf") for _, _, d, n in rows]
    print(f"{len(rows)} parts; twin first: {sum(rank == 1 for _, rank, _, _ in rows)}; "
          f"displacement at most a tenth of the nearest other: {sum(r <= 0.1 for r in ratios)}; "
          f"median displacement {statistics.median(d for _, _, d, _ in rows):.3g}, "
          f"of the nearest other {statistics.median(n for _, _, _, n in rows):.3g}, "
          f"of their ratio {statistics.median(ratios):.3g}", file=sys.stderr)


if __name__ == "__main__":
    main()
