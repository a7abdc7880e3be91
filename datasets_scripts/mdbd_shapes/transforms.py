"""Rotations, and the random pose that every model of the collection gets."""

from __future__ import annotations

import math
from random import Random

from .mesh import Mesh, Point

Matrix = tuple[Point, Point, Point]


def rotation_about(axis: str, angle: float) -> Matrix:
    """Rotation by an angle in radians about the axis "x", "y" or "z"."""
    c, s = math.cos(angle), math.sin(angle)
    if axis == "x":
        return ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c))
    if axis == "y":
        return ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c))
    return ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))


def random_rotation(rng: Random) -> Matrix:
    """A rotation drawn uniformly from SO(3): Shoemake's random unit quaternion."""
    u, v, w = rng.random(), 2.0 * math.pi * rng.random(), 2.0 * math.pi * rng.random()
    a, b = math.sqrt(1.0 - u), math.sqrt(u)
    x, y, z, r = a * math.sin(v), a * math.cos(v), b * math.sin(w), b * math.cos(w)
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * r), 2 * (x * z + y * r)),
        (2 * (x * y + z * r), 1 - 2 * (x * x + z * z), 2 * (y * z - x * r)),
        (2 * (x * z - y * r), 2 * (y * z + x * r), 1 - 2 * (x * x + y * y)),
    )


def rotated(mesh: Mesh, matrix: Matrix, scale: float = 1.0) -> Mesh:
    """A copy rotated about the origin and scaled."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    turned = [
        (
            scale * (a * x + b * y + c * z),
            scale * (d * x + e * y + f * z),
            scale * (g * x + h * y + i * z),
        )
        for x, y, z in mesh.vertices
    ]
    return Mesh(turned, list(mesh.triangles))


def turned(mesh: Mesh, axis: str, angle: float) -> Mesh:
    """A copy rotated by an angle in radians about a coordinate axis."""
    return rotated(mesh, rotation_about(axis, angle))


def random_pose(mesh: Mesh, rng: Random, smallest: float = 0.1, largest: float = 100.0) -> Mesh:
    """A copy in a random position: any rotation, a scale drawn evenly on a logarithmic scale, and a
    shift of at most two diameters, so that single-precision files keep the details."""
    scale = math.exp(rng.uniform(math.log(smallest), math.log(largest)))
    posed = rotated(mesh, random_rotation(rng), scale)
    diameter = max(
        max(v[k] for v in posed.vertices) - min(v[k] for v in posed.vertices) for k in range(3)
    )
    reach = 2.0 * diameter
    return posed.moved(*(rng.uniform(-reach, reach) for _ in range(3)))
