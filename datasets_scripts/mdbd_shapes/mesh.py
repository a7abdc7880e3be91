"""The triangle mesh that solids produce, families assemble and writers store."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

Point = tuple[float, float, float]
Point2 = tuple[float, float]
Triangle = tuple[int, int, int]


@dataclass
class Mesh:
    """Vertices and triangles, counter-clockwise seen from outside."""

    vertices: list[Point] = field(default_factory=list)
    triangles: list[Triangle] = field(default_factory=list)

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Mesh:
        """A copy shifted by (x, y, z)."""
        return Mesh([(a + x, b + y, c + z) for a, b, c in self.vertices], list(self.triangles))


def joined(parts: Iterable[Mesh]) -> Mesh:
    """One mesh of several parts; each part stays a closed surface of its own."""
    whole = Mesh()
    for part in parts:
        first = len(whole.vertices)
        whole.vertices += part.vertices
        whole.triangles += [(a + first, b + first, c + first) for a, b, c in part.triangles]
    return whole
