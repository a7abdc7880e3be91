"""Where the models of each public set go: one folder for each class."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from .errors import FetchError

MESH_ENDINGS = (".off", ".obj", ".ply", ".stl")
SPLITS = ("all", "train", "test")


@dataclass(frozen=True)
class Tree:
    """An unpacked archive; label is the class of all its models, or empty."""

    folder: Path
    label: str = ""


@dataclass(frozen=True)
class Placement:
    """A model file, its class, and the name that it gets in the class's folder."""

    source: Path
    label: str
    name: str


def folder_name(label: str) -> str:
    """A label as a folder name: letters, digits, dash, dot and underscore."""
    return re.sub(r"[^\w.-]+", "_", label).strip("._") or "unknown"


def meshes(tree: Tree) -> Iterator[Path]:
    """All model files of a tree in a fixed order, without the litter of some archives."""
    for path in sorted(tree.folder.rglob("*")):
        litter = path.name.startswith("._") or "__MACOSX" in path.parts
        if path.suffix.lower() in MESH_ENDINGS and not litter and path.is_file():
            yield path


def by_parent(trees: list[Tree], _split: str) -> list[Placement]:
    """The class is the tree's label or else the name of the folder that a model lies in."""
    return [
        Placement(path, tree.label or path.parent.name, path.name)
        for tree in trees
        for path in meshes(tree)
    ]


def coseg(trees: list[Tree], _split: str) -> list[Placement]:
    """One archive for each class; in a tree unpacked by hand, one top folder for each class."""
    placements = []
    for tree in trees:
        for path in meshes(tree):
            parts = path.relative_to(tree.folder).parts
            label = tree.label or (parts[0] if len(parts) > 1 else tree.folder.name)
            placements.append(Placement(path, label, path.name))
    return placements


def modelnet(trees: list[Tree], split: str) -> list[Placement]:
    """CLASS/train/x.off and CLASS/test/x.off become CLASS/x.off."""
    return [
        Placement(path, path.parent.parent.name, path.name)
        for tree in trees
        for path in meshes(tree)
        if path.parent.name in ("train", "test") and split in ("all", path.parent.name)
    ]


def shapenet(trees: list[Tree], _split: str) -> list[Placement]:
    """SYNSET/MODEL/…/x.obj becomes SYNSET/MODEL.obj; a synset is a number of eight digits."""
    placements = []
    for tree in trees:
        for path in meshes(tree):
            parts = path.relative_to(tree.folder).parts
            synset = next((k for k, part in enumerate(parts) if re.fullmatch(r"\d{8}", part)), None)
            if synset is not None and synset + 2 < len(parts):
                name = parts[synset + 1] + path.suffix.lower()
                placements.append(Placement(path, parts[synset], name))
    return placements


# The models of the segmentation benchmark are numbered, 20 for each class; 261 to 280 are unused.
LPSB_CLASSES = (
    "Human Cup Glasses Airplane Ant Chair Octopus Table Teddy Hand Plier Fish Bird Spring "
    "Armadillo Bust Mech Bearing Vase FourLeg"
).split()


def lpsb(trees: list[Tree], _split: str) -> list[Placement]:
    """The class follows from a model's number."""
    placements = []
    for tree in trees:
        for path in meshes(tree):
            number = int(path.stem) if path.stem.isdecimal() else 0
            if 1 <= number <= 20 * len(LPSB_CLASSES):
                label = LPSB_CLASSES[(number - 1) // 20]
                placements.append(Placement(path, label, path.name))
    return placements


def read_classification(path: Path) -> dict[str, list[str]]:
    """Reads a Princeton classification file (.cla): model numbers by class, no empty classes."""
    tokens = iter(path.read_text(encoding="latin-1").split())
    try:
        magic, _version = next(tokens), next(tokens)
        if magic != "PSB":
            raise FetchError(f"{path} is no classification file: it does not begin with PSB")
        class_count, _model_count = int(next(tokens)), int(next(tokens))
        classes: dict[str, list[str]] = {}
        for _ in range(class_count):
            name, _parent, count = next(tokens), next(tokens), int(next(tokens))
            models = [next(tokens) for _ in range(count)]
            if models:
                classes[name] = models
    except (StopIteration, ValueError) as error:
        raise FetchError(f"{path} is damaged or cut off") from error
    return classes


def princeton(trees: list[Tree], split: str) -> list[Placement]:
    """The base classification, training and test halves together unless one is asked for."""
    models = {path.stem: path for tree in trees for path in meshes(tree)}
    placements = []
    for half in ("train", "test") if split == "all" else (split,):
        files = sorted(p for t in trees for p in t.folder.rglob(f"{half}.cla"))
        files = [p for p in files if p.parent.name == "base"] or files
        if not files:
            raise FetchError(f"the classification {half}.cla is missing from the archive")
        for label, numbers in read_classification(files[-1]).items():
            for number in numbers:
                source = models.get(f"m{number}")
                if source is None:
                    raise FetchError(f"model m{number} ({label}) is missing from the archive")
                placements.append(Placement(source, label, source.name))
    return placements


def _table(trees: list[Tree], name: str) -> list[dict[str, str]]:
    for tree in trees:
        for path in sorted(tree.folder.rglob(name)):
            with path.open(encoding="utf-8", errors="replace", newline="") as file:
                return list(csv.DictReader(file, skipinitialspace=True))
    raise FetchError(f"{name} is missing: the classes are unknown without it")


def thingi10k(trees: list[Tree], _split: str) -> list[Placement]:
    """The class is the sub-category that a model's author chose, from the set's own tables."""
    things = {row["ID"]: row["Thing ID"] for row in _table(trees, "input_summary.csv")}
    labels = {
        row["Thing ID"]: row.get("Sub-category") or row.get("Category") or "unknown"
        for row in _table(trees, "contextual_data.csv")
    }
    return [
        Placement(path, labels.get(things.get(path.stem, ""), "unknown"), path.name)
        for tree in trees
        for path in meshes(tree)
    ]
