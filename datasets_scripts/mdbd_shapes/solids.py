"""Closed, outward-oriented solids. Nearly all are lofts: rings of points joined by strips."""

from __future__ import annotations

import math
from collections.abc import Sequence

from .mesh import Mesh, Point, Point2, Triangle
from .polygon import circle, triangulate


def _strip(lower: list[int], upper: list[int]) -> list[Triangle]:
    """Triangles between two rings of equal length, or between a ring and a single point."""
    count = max(len(lower), len(upper))
    triangles: list[Triangle] = []
    for k in range(count):
        a, b = lower[k % len(lower)], lower[(k + 1) % len(lower)]
        c, d = upper[(k + 1) % len(upper)], upper[k % len(upper)]
        if a != b:
            triangles.append((a, b, c))
        if c != d:
            triangles.append((a, c, d))
    return triangles


def loft(rings: Sequence[Sequence[Point]], closed: bool = False) -> Mesh:
    """Joins rings of equal length, each counter-clockwise seen from the side of the next one. A
    ring of one point is a tip. An open loft is closed by its end tips or by fans about the centres
    of its end rings; a closed one joins its last ring to its first: a ring-shaped solid."""
    sections = [list(ring) for ring in rings]
    if not closed:
        for end, at in ((sections[0], 0), (sections[-1], len(sections) + 1)):
            if len(end) > 1:
                centre = tuple(sum(p[k] for p in end) / len(end) for k in range(3))
                sections.insert(at, [centre])
    mesh = Mesh()
    numbers: list[list[int]] = []
    for section in sections:
        numbers.append(list(range(len(mesh.vertices), len(mesh.vertices) + len(section))))
        mesh.vertices += section
    if closed:
        numbers.append(numbers[0])
    for lower, upper in zip(numbers, numbers[1:]):
        mesh.triangles += _strip(lower, upper)
    return mesh


def _ring(radius: float, z: float, segments: int) -> list[Point]:
    if radius == 0.0:
        return [(0.0, 0.0, z)]
    return [(x, y, z) for x, y in circle(radius, segments)]


def revolve(profile: Sequence[Point2], segments: int, closed: bool = False) -> Mesh:
    """Turns a profile of (radius, z) about the z axis. An open profile runs upwards along the
    outside (and on, into a hollow, if it has one); a closed one runs once around, counter-clockwise
    in the (radius, z) plane, and makes a ring."""
    return loft([_ring(r, z, segments) for r, z in profile], closed)


def cylinder(radius: float, bottom: float, top: float, segments: int, bevel: float = 0.0) -> Mesh:
    """A cylinder about the z axis, with bevelled edges if bevel is positive."""
    if bevel <= 0.0:
        return revolve([(radius, bottom), (radius, top)], segments)
    r = radius - bevel
    profile = [(r, bottom), (radius, bottom + bevel), (radius, top - bevel), (r, top)]
    return revolve(profile, segments)


def tube(
    inner: float, outer: float, bottom: float, top: float, segments: int, bevel: float
) -> Mesh:
    """A ring of rectangular section with bevelled outer edges, about the z axis."""
    profile = [
        (inner, bottom),
        (outer - bevel, bottom),
        (outer, bottom + bevel),
        (outer, top - bevel),
        (outer - bevel, top),
        (inner, top),
    ]
    return revolve(profile, segments, closed=True)


def sphere(radius: float, segments: int) -> Mesh:
    """A sphere about the origin with half as many parallels as meridians."""
    rows = segments // 2
    steps = [math.pi * (k / rows - 0.5) for k in range(1, rows)]
    body = [(radius * math.cos(t), radius * math.sin(t)) for t in steps]
    return revolve([(0.0, -radius), *body, (0.0, radius)], segments)


def extrude(
    outline: Sequence[Point2], height: float, holes: Sequence[Sequence[Point2]] = ()
) -> Mesh:
    """A plate between z = 0 and z = height. Outline and holes are counter-clockwise."""
    loops = [list(outline)] + [list(reversed(hole)) for hole in holes]
    points = [p for loop in loops for p in loop]
    cap = triangulate(loops[0], loops[1:])
    count = len(points)
    mesh = Mesh([(x, y, 0.0) for x, y in points] + [(x, y, height) for x, y in points])
    mesh.triangles = [(a, c, b) for a, b, c in cap]
    mesh.triangles += [(a + count, b + count, c + count) for a, b, c in cap]
    first = 0
    for loop in loops:
        lower = list(range(first, first + len(loop)))
        mesh.triangles += _strip(lower, [i + count for i in lower])
        first += len(loop)
    return mesh


def _rounded_steps(half: float, radius: float, corner: int, middle: int) -> list[float]:
    """Grid lines of one axis of a rounded box, dense at the edges."""
    flat = half - radius
    edge = [flat + radius * math.tan(math.pi / 4 * k / corner) for k in range(corner + 1)]
    inner = [flat * (2.0 * k / middle - 1.0) for k in range(1, middle)]
    return [-e for e in reversed(edge)] + inner + edge


def rounded_box(size: Point, radius: float, corner: int = 2, middle: int = 3) -> Mesh:
    """A box about the origin with round edges: corner steps around an edge, middle between."""
    half = [s / 2 for s in size]
    axes = [_rounded_steps(h, radius, corner, middle) for h in half]
    mesh = Mesh()
    known: dict[tuple[int, int, int], int] = {}

    def vertex(grid: tuple[int, int, int]) -> int:
        if grid not in known:
            p = [axes[k][grid[k]] for k in range(3)]
            core = [max(-half[k] + radius, min(half[k] - radius, p[k])) for k in range(3)]
            away = [p[k] - core[k] for k in range(3)]
            stretch = radius / math.sqrt(sum(a * a for a in away))
            known[grid] = len(mesh.vertices)
            mesh.vertices.append(tuple(core[k] + stretch * away[k] for k in range(3)))
        return known[grid]

    last = len(axes[0]) - 1
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, last):
            for i in range(last):
                for j in range(last):
                    quad = []
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        grid = [side, side, side]
                        grid[u], grid[v] = i + di, j + dj
                        quad.append(vertex((grid[0], grid[1], grid[2])))
                    a, b, c, d = quad if side else reversed(quad)
                    mesh.triangles += [(a, b, c), (a, c, d)]
    return mesh


def _unit(v: Sequence[float]) -> Point:
    length = math.sqrt(sum(c * c for c in v))
    return (v[0] / length, v[1] / length, v[2] / length)


def _crossed(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _frames(path: Sequence[Point], up: Point) -> list[tuple[Point, Point]]:
    """At each point of a path the directions of the section's x and y; y is kept close to up."""
    frames = []
    for k in range(len(path)):
        before, after = path[max(k - 1, 0)], path[min(k + 1, len(path) - 1)]
        ahead = _unit([after[i] - before[i] for i in range(3)])
        side = _unit(_crossed(up, ahead))
        frames.append((side, _crossed(ahead, side)))
    return frames


def _swept(
    section: Sequence[Point2], path: Sequence[Point], up: Point, scales: Sequence[float]
) -> list[list[Point]]:
    rings = []
    for centre, (side, upward), scale in zip(path, _frames(path, up), scales):
        ring = []
        for x, y in section:
            ring.append(
                tuple(centre[i] + scale * (x * side[i] + y * upward[i]) for i in range(3))
            )
        rings.append(ring)
    return rings


def sweep(
    section: Sequence[Point2],
    path: Sequence[Point],
    up: Point = (0.0, 0.0, 1.0),
    scales: Sequence[float] | None = None,
) -> Mesh:
    """Moves a counter-clockwise section along a path, with flat ends. The path is nowhere parallel
    to up and bends less than the section is wide; scales, one for each point, widen the section."""
    return loft(_swept(section, path, up, scales or [1.0] * len(path)))


def sweep_tube(
    inner: float, outer: float, segments: int, path: Sequence[Point], up: Point = (0.0, 0.0, 1.0)
) -> Mesh:
    """A pipe along a path, open at both ends."""
    ones = [1.0] * len(path)
    outside = _swept(circle(outer, segments), path, up, ones)
    inside = _swept(circle(inner, segments), path, up, ones)
    return loft(outside + inside[::-1], closed=True)


def beam(
    section: Sequence[Point2], start: Point, end: Point, steps: int, taper: float = 1.0
) -> Mesh:
    """A straight bar between two points whose section is taper times as wide at its end."""
    shares = [k / steps for k in range(steps + 1)]
    path = [tuple(start[i] + (end[i] - start[i]) * t for i in range(3)) for t in shares]
    scales = [1.0 + (taper - 1.0) * t for t in shares]
    along = [abs(end[i] - start[i]) for i in range(3)]
    up = (0.0, 1.0, 0.0) if along[2] == max(along) else (0.0, 0.0, 1.0)
    return sweep(section, path, up, scales)
