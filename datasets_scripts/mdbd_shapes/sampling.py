"""Random points on the surface of a mesh that is read from an OFF file."""

from __future__ import annotations

import math
from itertools import accumulate
from pathlib import Path
from random import Random

from .mesh import Point

Face = tuple[int, int, int]


def read_off(path: Path) -> tuple[list[Point], list[Face]]:
    """Vertices and triangles; polygons become fans."""
    text = path.read_text(encoding="ascii").removeprefix("OFF")
    lines = (line.partition("#")[0] for line in text.splitlines())
    numbers = iter(" ".join(lines).split())
    vertex_count, face_count, _ = (int(next(numbers)) for _ in range(3))
    vertices = [tuple(float(next(numbers)) for _ in range(3)) for _ in range(vertex_count)]
    faces: list[Face] = []
    for _ in range(face_count):
        corners = [int(next(numbers)) for _ in range(int(next(numbers)))]
        faces += [(corners[0], b, c) for b, c in zip(corners[1:], corners[2:])]
    return vertices, faces


def _area(a: Point, b: Point, c: Point) -> float:
    u = [b[k] - a[k] for k in range(3)]
    v = [c[k] - a[k] for k in range(3)]
    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return 0.5 * math.hypot(*normal)


def sample_surface(
    vertices: list[Point], faces: list[Face], count: int, random: Random
) -> list[Point]:
    """Points that are uniform on the surface."""
    corners = [tuple(vertices[i] for i in face) for face in faces]
    sums = list(accumulate(_area(*corner) for corner in corners))
    points = []
    for a, b, c in random.choices(corners, cum_weights=sums, k=count):
        root, s = math.sqrt(random.random()), random.random()
        weights = (1 - root, root * (1 - s), root * s)
        points.append(tuple(weights[0] * p + weights[1] * q + weights[2] * r for p, q, r in zip(a, b, c)))
    return points
