"""The generated demo collection: closed, outward, deterministic, in all formats."""

from __future__ import annotations

import contextlib
import hashlib
import io
import math
import os
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path
from random import Random

from mesh_readers import most_faces_at_an_edge, open_edges, parts, read_soup, volume

SCRIPTS = Path(__file__).resolve().parents[2] / "datasets_scripts"
sys.path.insert(0, str(SCRIPTS))

import generate_demo  # noqa: E402
from mdbd_shapes.families import FAMILIES  # noqa: E402
from mdbd_shapes.polygon import circle, triangulate  # noqa: E402
from mdbd_shapes.transforms import random_rotation  # noqa: E402


def run(*arguments: object) -> tuple[int, str]:
    """Runs the script in this process; returns its exit code and what it says."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        try:
            code = generate_demo.main([str(a) for a in arguments])
        except SystemExit as stop:
            code = int(stop.code or 0)
    return code, said.getvalue()


def tree_hash(folder: Path) -> str:
    total = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        total.update(str(path.relative_to(folder)).encode())
        if path.is_file():
            total.update(path.read_bytes())
    return total.hexdigest()


class Collection(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.scratch = tempfile.TemporaryDirectory()
        cls.root = Path(cls.scratch.name)
        cls.models = cls.root / "models"
        cls.query = cls.root / "chair.ply"
        cls.code, cls.said = run(cls.models, "--query", cls.query)
        cls.files = sorted(p for p in cls.models.rglob("*") if p.is_file())

    @classmethod
    def tearDownClass(cls) -> None:
        cls.scratch.cleanup()

    def test_has_enough_families_and_models(self) -> None:
        self.assertEqual(self.code, 0)
        labels = Counter(path.parent.name for path in self.files)
        self.assertGreaterEqual(len(labels), 12)
        self.assertEqual(set(labels), set(FAMILIES))
        self.assertTrue(all(count == 10 for count in labels.values()))
        self.assertIn(f"{len(labels)} families, {len(self.files)} models", self.said)

    def test_every_file_is_a_closed_outward_mesh(self) -> None:
        for path in [*self.files, self.query]:
            with self.subTest(path.name):
                soup = read_soup(path)
                self.assertTrue(500 <= len(soup) <= 6000, len(soup))
                self.assertTrue(all(math.isfinite(x) for t in soup for p in t for x in p))
                self.assertTrue(all(len(set(t)) == 3 for t in soup), "a triangle without area")
                self.assertEqual(open_edges(soup), 0)
                self.assertEqual(most_faces_at_an_edge(soup), 2)
                self.assertTrue(all(volume(part) > 0.0 for part in parts(soup)))

    def test_mixes_all_formats(self) -> None:
        kinds = Counter()
        for path in self.files:
            head = path.read_bytes()[:40]
            kinds[path.suffix] += 1
            if path.suffix == ".ply":
                kinds[head.split()[2].decode()] += 1
            if path.suffix == ".stl":
                kinds["solid" if head.startswith(b"solid") else "binary stl"] += 1
        expected = {".off", ".obj", ".ply", ".stl", "ascii", "binary_little_endian"}
        self.assertEqual(set(kinds), expected | {"binary_big_endian", "solid", "binary stl"})
        self.assertGreaterEqual(min(kinds.values()), 20)

    def test_no_model_occurs_twice(self) -> None:
        areas = set()
        for path in [*self.files, self.query]:
            soup = read_soup(path)
            size = max(math.dist(soup[0][0], p) for t in soup for p in t)
            areas.add((len(soup), round(sum(map(volume, parts(soup))) / size**3, 4)))
        self.assertGreater(len(areas), 0.97 * len(self.files))

    def test_sizes_differ_widely(self) -> None:
        sizes = []
        for path in self.files[::5]:
            xs = [p[0] for t in read_soup(path) for p in t]
            sizes.append(max(xs) - min(xs))
        self.assertGreater(max(sizes), 50.0 * min(sizes))

    def test_same_seed_same_bytes_whatever_the_hash_seed(self) -> None:
        again = self.root / "again"
        environment = os.environ | {"PYTHONHASHSEED": "12345"}
        command = [sys.executable, "-B", SCRIPTS / "generate_demo.py", again]
        subprocess.run(command, env=environment, check=True, capture_output=True)
        self.assertEqual(tree_hash(self.models), tree_hash(again))

    def test_other_seed_other_models(self) -> None:
        other = self.root / "other"
        self.assertEqual(run(other, "--seed", 2, "--per-family", 1)[0], 0)
        for path in other.rglob("*.*"):
            same = self.models / path.relative_to(other)
            self.assertNotEqual(path.read_bytes(), same.read_bytes())


class Usage(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)

    def test_refuses_a_folder_that_is_not_empty(self) -> None:
        (self.root / "mine.txt").write_text("mine")
        code, said = run(self.root)
        self.assertEqual(code, 1)
        self.assertIn("not empty", said)
        self.assertEqual([p.name for p in self.root.iterdir()], ["mine.txt"])
        self.assertEqual(run(self.root, "--force", "--per-family", 1)[0], 0)
        self.assertTrue((self.root / "mine.txt").exists())

    def test_refuses_a_file_as_folder(self) -> None:
        (self.root / "file").write_text("")
        code, said = run(self.root / "file")
        self.assertEqual(code, 1)
        self.assertIn("not a folder", said)

    def test_wrong_usage(self) -> None:
        out = self.root / "out"
        for arguments in (
            [],
            [out, "--per-family", 0],
            [out, "--query", "chair.step"],
            [out, "--query", out / "chair.ply"],
        ):
            with self.subTest(arguments):
                self.assertEqual(run(*arguments)[0], 2)
        self.assertFalse(out.exists())

    def test_query_format_follows_the_ending(self) -> None:
        for ending in (".off", ".obj", ".ply", ".stl"):
            query = self.root / f"chair{ending}"
            out = self.root / ending[1:]
            self.assertEqual(run(out, "--per-family", 1, "--query", query)[0], 0)
            self.assertEqual(open_edges(read_soup(query)), 0)


class Geometry(unittest.TestCase):
    def test_triangulation_covers_a_plate_with_holes(self) -> None:
        outline = circle(2.0, 40)
        holes = [circle(0.3, 12, (x, y)) for x in (-0.8, 0.0, 0.8) for y in (-0.8, 0.1, 0.8)]
        loops = [outline] + [hole[::-1] for hole in holes]
        points = [p for loop in loops for p in loop]
        area = 0.0
        for a, b, c in triangulate(outline, loops[1:]):
            (ax, ay), (bx, by), (cx, cy) = points[a], points[b], points[c]
            part = 0.5 * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))
            self.assertGreater(part, 0.0)
            area += part
        expected = 0.0
        for loop in loops:
            for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
                expected += 0.5 * (ax * by - ay * bx)
        self.assertAlmostEqual(area, expected, places=12)

    def test_triangulation_refuses_a_hole_outside(self) -> None:
        with self.assertRaises(ValueError):
            triangulate(circle(1.0, 12), [circle(0.2, 8, (3.0, 0.0))[::-1]])

    def test_random_rotations_are_rotations_and_even(self) -> None:
        rng = Random("rotations")
        mean = [0.0, 0.0, 0.0]
        for _ in range(4000):
            rows = random_rotation(rng)
            for i in range(3):
                for j in range(3):
                    dot = sum(rows[i][k] * rows[j][k] for k in range(3))
                    self.assertAlmostEqual(dot, float(i == j), places=12)
            (a, b, c), (d, e, f), (g, h, i) = rows
            turn = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
            self.assertAlmostEqual(turn, 1.0, places=12)
            mean = [m + rows[k][2] ** 2 / 4000 for k, m in enumerate(mean)]
        for value in mean:  # the squares of a direction's coordinates average to a third
            self.assertAlmostEqual(value, 1.0 / 3.0, delta=0.03)


if __name__ == "__main__":
    unittest.main()
