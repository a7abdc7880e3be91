"""Two-dimensional outlines, and the triangulation of outlines with holes."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .mesh import Point2, Triangle


def circle(radius: float, count: int, centre: Point2 = (0.0, 0.0)) -> list[Point2]:
    """A regular polygon, counter-clockwise, first corner in the x direction."""
    steps = (2.0 * math.pi * k / count for k in range(count))
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in steps]


def ellipse(a: float, b: float, count: int) -> list[Point2]:
    """An ellipse with half axes a (x) and b (y), counter-clockwise."""
    return [(a * x, b * y) for x, y in circle(1.0, count)]


def rounded_rectangle(width: float, height: float, radius: float, corner: int) -> list[Point2]:
    """A rectangle about the origin with round corners of corner + 1 points, counter-clockwise."""
    points: list[Point2] = []
    for k, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        cx, cy = sx * (width / 2 - radius), sy * (height / 2 - radius)
        for j in range(corner + 1):
            t = (k + j / corner) * math.pi / 2
            points.append((cx + radius * math.cos(t), cy + radius * math.sin(t)))
    return points


def _cross(a: Point2, b: Point2, c: Point2) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _in_cone(before: Point2, corner: Point2, after: Point2, target: Point2) -> bool:
    """Whether the way from a corner to a target starts inside the polygon."""
    if _cross(before, corner, after) > 0.0:
        return _cross(corner, after, target) > 0.0 and _cross(before, corner, target) > 0.0
    return not (_cross(corner, after, target) <= 0.0 and _cross(before, corner, target) <= 0.0)


def _segments_meet(a: Point2, b: Point2, c: Point2, d: Point2) -> bool:
    """Whether two segments without a common end point cross or touch."""
    if a in (c, d) or b in (c, d):
        return False
    first = (_cross(a, b, c), _cross(a, b, d))
    second = (_cross(c, d, a), _cross(c, d, b))
    return min(first) <= 0.0 <= max(first) and min(second) <= 0.0 <= max(second)


def _bridge(
    points: Sequence[Point2], loop: list[int], hole: list[int], rest: list[int]
) -> list[int]:
    """Cuts from the loop to the hole and returns the one loop that runs around both; rest has the
    end points of the other holes' edges, which the cut must not cross."""
    start = max(range(len(hole)), key=lambda k: points[hole[k]][0])
    ring = hole[start:] + hole[:start]
    source = points[ring[0]]
    edges = [(loop[k - 1], loop[k]) for k in range(len(loop))]
    edges += [(hole[k - 1], hole[k]) for k in range(len(hole))]
    edges += [(rest[k], rest[k + 1]) for k in range(0, len(rest), 2)]
    for k in sorted(range(len(loop)), key=lambda k: math.dist(points[loop[k]], source)):
        corner = points[loop[k]]
        after = points[loop[(k + 1) % len(loop)]]
        if not _in_cone(points[loop[k - 1]], corner, after, source):
            continue
        if not any(_segments_meet(source, corner, points[i], points[j]) for i, j in edges):
            return loop[: k + 1] + ring + [ring[0]] + loop[k:]
    raise ValueError("a hole lies outside its outline or touches it")


def _is_ear(points: Sequence[Point2], loop: list[int], k: int) -> bool:
    a, b, c = (points[loop[i % len(loop)]] for i in (k - 1, k, k + 1))
    if _cross(a, b, c) <= 0.0:
        return False
    for i in loop:
        p = points[i]
        inside = _cross(a, b, p) >= 0.0 and _cross(b, c, p) >= 0.0 and _cross(c, a, p) >= 0.0
        if inside and p not in (a, b, c):
            return False
    return True


def triangulate(outline: Sequence[Point2], holes: Sequence[Sequence[Point2]]) -> list[Triangle]:
    """Ear clipping. The outline is counter-clockwise, holes are clockwise; indices count through
    the outline and then through the holes in their order. No vertex is added."""
    points = list(outline) + [p for hole in holes for p in hole]
    loop = list(range(len(outline)))
    rings, first = [], len(outline)
    for hole in holes:
        rings.append(list(range(first, first + len(hole))))
        first += len(hole)
    rings.sort(key=lambda ring: -max(points[i][0] for i in ring))
    for n, ring in enumerate(rings):
        rest = [i for r in rings[n + 1 :] for k in range(len(r)) for i in (r[k - 1], r[k])]
        loop = _bridge(points, loop, ring, rest)

    triangles: list[Triangle] = []
    k, misses = 0, 0
    while len(loop) > 3:
        if _is_ear(points, loop, k % len(loop)):
            k %= len(loop)
            triangles.append((loop[k - 1], loop[k], loop[(k + 1) % len(loop)]))
            del loop[k]
            misses = 0
        else:
            misses += 1
            if misses > len(loop):
                raise ValueError("the outline crosses itself or has corners on a line")
        k += 1
    triangles.append((loop[0], loop[1], loop[2]))
    return triangles
