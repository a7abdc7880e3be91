"""The public sets that the field uses.

The addresses come from public code and texts that name them as the authors' own; none could be
opened when this table was written, so any may have moved. No published checksum of these archives
could be found; a checksum that becomes known belongs into Archive.checksum.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from . import layouts
from .layouts import Placement, Tree

Layout = Callable[[list[Tree], str], list[Placement]]

UNVERIFIED = """\
These addresses are named in public code and texts as the authors' own, but they could not be tried
when this list was written, and no published checksums of these archives could be found. SOURCE.txt
in each laid-out folder records the sha256 of what was fetched; --sums FILE checks against a list of
your own."""
NOT_STATED = "research benchmark, no licence stated"


@dataclass(frozen=True)
class Archive:
    """One file of a set. Addresses are tried in turn; checksum is hexadecimal md5, sha1 or sha256,
    or empty if none is published; label is the class of all its models, if it has only one."""

    name: str
    urls: tuple[str, ...]
    label: str = ""
    checksum: str = ""


@dataclass(frozen=True)
class PublicSet:
    """A set; by_hand says why a script cannot download it, and is empty if one can."""

    name: str
    title: str
    page: str
    licence: str
    layout: Layout
    archives: tuple[Archive, ...] = ()
    by_hand: str = ""
    has_splits: bool = False


_COSEG = "http://irc.cs.sdu.edu.cn/~yunhai/public_html/ssl"


def _coseg(folder: str, label: str) -> Archive:
    return Archive(f"{label}.zip", (f"{_COSEG}/data/{folder}/shapes.zip",), label)


_PSB = "https://shape.cs.princeton.edu/benchmark"
_THINGI = "https://huggingface.co/datasets/Thingi10K/Thingi10K/resolve/v1.5.0"

_ALL = (
    PublicSet(
        "coseg",
        "Shape COSEG, the eight small sets (candelabra, chairs, four-legged, goblets, …)",
        f"{_COSEG}/ssd.htm",
        NOT_STATED,
        layouts.coseg,
        (
            _coseg("Candelabra", "candelabra"),
            _coseg("Chair", "chairs"),
            _coseg("Four-legged", "four_legged"),
            _coseg("Goblets", "goblets"),
            _coseg("Guitars", "guitars"),
            _coseg("Irons", "irons"),
            _coseg("Lampes", "lamps"),
            _coseg("Vases", "vases"),
        ),
    ),
    PublicSet(
        "coseg_large",
        "Shape COSEG, the three large sets (200 tele-aliens, 300 vases, 400 chairs)",
        f"{_COSEG}/ssd.htm",
        NOT_STATED,
        layouts.coseg,
        (
            _coseg("Tele-aliens", "tele_aliens"),
            _coseg("Large-Vases", "vases"),
            _coseg("Large-Chairs", "chairs"),
        ),
    ),
    PublicSet(
        "psb",
        "Princeton Shape Benchmark, 1,814 models, base classification",
        f"{_PSB}/",
        "research benchmark; the models' own terms apply (see the set's pages)",
        layouts.princeton,
        (
            Archive(
                "psb_v1.zip",
                (
                    f"{_PSB}/download.cgi?file=download/psb_v1.zip",
                    f"{_PSB}/download/psb_v1.zip",
                ),
            ),
        ),
        has_splits=True,
    ),
    PublicSet(
        "lpsb",
        "Labeled Princeton Segmentation Benchmark, 380 watertight models, 19 classes (needs 7z)",
        "https://people.cs.umass.edu/~kalo/papers/LabelMeshes/",
        NOT_STATED,
        layouts.lpsb,
        (
            Archive(
                "labeledDb.7z",
                ("https://people.cs.umass.edu/~kalo/papers/LabelMeshes/labeledDb.7z",),
            ),
        ),
    ),
    PublicSet(
        "modelnet10",
        "Princeton ModelNet, 10 aligned classes, 4,899 models",
        "https://modelnet.cs.princeton.edu/",
        "for academic research; copyright of the models with their authors",
        layouts.modelnet,
        (
            Archive(
                "ModelNet10.zip",
                ("http://3dvision.princeton.edu/projects/2014/3DShapeNets/ModelNet10.zip",),
            ),
        ),
        has_splits=True,
    ),
    PublicSet(
        "modelnet40",
        "Princeton ModelNet, 40 classes, 12,311 models",
        "https://modelnet.cs.princeton.edu/",
        "for academic research; copyright of the models with their authors",
        layouts.modelnet,
        (Archive("ModelNet40.zip", ("http://modelnet.cs.princeton.edu/ModelNet40.zip",)),),
        has_splits=True,
    ),
    PublicSet(
        "thingi10k",
        "Thingi10K, 10,000 models for 3D printing; classes are the authors' sub-categories",
        "https://ten-thousand-models.appspot.com/",
        "a licence for each model, see the set's tables",
        layouts.thingi10k,
        (
            Archive("Thingi10K.tar.gz", (f"{_THINGI}/Thingi10K.tar.gz",)),
            Archive("input_summary.csv", (f"{_THINGI}/metadata/input_summary.csv",)),
            Archive("contextual_data.csv", (f"{_THINGI}/metadata/contextual_data.csv",)),
        ),
    ),
    PublicSet(
        "mcgill",
        "McGill 3D Shape Benchmark, articulated and rigid models, 19 classes",
        "https://www.cim.mcgill.ca/~shape/benchMark/",
        NOT_STATED,
        layouts.by_parent,
        by_hand="its authors ask for a mail before any download",
    ),
    PublicSet(
        "esb",
        "Engineering Shape Benchmark (Purdue), 867 CAD parts",
        "https://engineering.purdue.edu/cdesign/wp/downloads/",
        NOT_STATED,
        layouts.by_parent,
        by_hand="no lasting address of its archive is known",
    ),
    PublicSet(
        "shapenet",
        "ShapeNetCore, 55 classes; folders are WordNet synset numbers",
        "https://shapenet.org/",
        "ShapeNet terms of use: non-commercial research, registration",
        layouts.shapenet,
        by_hand="it needs an account and its terms to be accepted",
    ),
    PublicSet(
        "abc",
        "ABC, a million CAD models in 100 chunks of 7z archives; no classes, folders are models",
        "https://deep-geometry.github.io/abc-dataset/",
        "Onshape terms of use for public documents; copyright with their creators",
        layouts.by_parent,
        by_hand="choose chunks from obj_v00.txt or stl2_v00.txt there, checksums are in md5.yml",
    ),
)

SETS: dict[str, PublicSet] = {s.name: s for s in _ALL}
