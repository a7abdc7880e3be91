"""Small independent readers for the generated files, and checks of a triangle mesh."""

from __future__ import annotations

import struct
from collections import Counter
from pathlib import Path

Point = tuple[float, float, float]
Soup = list[tuple[Point, Point, Point]]


def _soup(points: list[Point], faces: list[list[int]]) -> Soup:
    return [(points[a], points[b], points[c]) for a, b, c in faces]


def _point(fields: list[str]) -> Point:
    x, y, z = map(float, fields)
    return (x, y, z)


def _read_off(data: bytes) -> Soup:
    lines = data.decode("ascii").splitlines()
    assert lines[0] == "OFF"
    vertices, faces, _ = map(int, lines[1].split())
    assert len(lines) == 2 + vertices + faces
    points = [_point(line.split()) for line in lines[2 : 2 + vertices]]
    rows = [list(map(int, line.split())) for line in lines[2 + vertices :]]
    assert all(row[0] == 3 for row in rows)
    return _soup(points, [row[1:] for row in rows])


def _read_obj(data: bytes) -> Soup:
    points, faces = [], []
    for line in data.decode("ascii").splitlines():
        kind, *fields = line.split()
        if kind == "v":
            points.append(_point(fields))
        else:
            assert kind == "f"
            faces.append([int(i) - 1 for i in fields])
    return _soup(points, faces)


def _read_ply(data: bytes) -> Soup:
    header, body = data.split(b"end_header\n", 1)
    fields = header.decode("ascii").split()
    encoding = fields[fields.index("format") + 1]
    vertices = int(fields[fields.index("vertex") + 1])
    faces = int(fields[fields.index("face") + 1])
    if encoding == "ascii":
        lines = body.decode("ascii").splitlines()
        points = [_point(line.split()) for line in lines[:vertices]]
        rows = [list(map(int, line.split())) for line in lines[vertices:]]
    else:
        order = {"binary_little_endian": "<", "binary_big_endian": ">"}[encoding]
        vertex, face = struct.Struct(order + "3f"), struct.Struct(order + "B3i")
        split = vertices * vertex.size
        points = list(vertex.iter_unpack(body[:split]))
        rows = [list(row) for row in face.iter_unpack(body[split:])]
    assert len(rows) == faces and all(row[0] == 3 for row in rows)
    return _soup(points, [row[1:] for row in rows])


def _read_stl(data: bytes) -> Soup:
    if data.startswith(b"solid"):
        lines = [line.split() for line in data.decode("ascii").splitlines()]
        points = [_point(fields[1:]) for fields in lines if fields[0] == "vertex"]
    else:
        count = struct.unpack_from("<I", data, 80)[0]
        assert len(data) == 84 + 50 * count
        rows = struct.iter_unpack("<12fH", data[84:])
        points = [row[k : k + 3] for row in rows for k in (3, 6, 9)]
    assert len(points) % 3 == 0
    return [(points[k], points[k + 1], points[k + 2]) for k in range(0, len(points), 3)]


def read_soup(path: Path) -> Soup:
    readers = {".off": _read_off, ".obj": _read_obj, ".ply": _read_ply, ".stl": _read_stl}
    return readers[path.suffix](path.read_bytes())


def open_edges(soup: Soup) -> int:
    """Directed edges whose opposite does not occur as often; 0 for closed oriented surfaces."""
    edges = Counter((t[k], t[(k + 1) % 3]) for t in soup for k in range(3))
    return sum(count != edges[(b, a)] for (a, b), count in edges.items())


def most_faces_at_an_edge(soup: Soup) -> int:
    edges = Counter(frozenset((t[k], t[(k + 1) % 3])) for t in soup for k in range(3))
    return max(edges.values())


def parts(soup: Soup) -> list[Soup]:
    """The surfaces of a soup that share no vertex."""
    parent: dict[Point, Point] = {}

    def root(p: Point) -> Point:
        while parent.setdefault(p, p) != p:
            parent[p] = p = parent[parent[p]]
        return p

    for a, b, c in soup:
        parent[root(a)] = root(b)
        parent[root(b)] = root(c)
    found: dict[Point, Soup] = {}
    for triangle in soup:
        found.setdefault(root(triangle[0]), []).append(triangle)
    return list(found.values())


def volume(soup: Soup) -> float:
    """Signed volume, positive for outward orientation; relative to a corner, to lose no digits."""
    ox, oy, oz = soup[0][0]
    total = 0.0
    for a, b, c in soup:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (
            (p[0] - ox, p[1] - oy, p[2] - oz) for p in (a, b, c)
        )
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6.0
