"""Writers for OFF, OBJ, PLY and STL. Coordinates have single precision."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from pathlib import Path

from .mesh import Mesh, Point


def _text(point: Point) -> str:
    return " ".join(f"{c:.8g}" for c in point)


def off_text(mesh: Mesh) -> bytes:
    lines = ["OFF", f"{len(mesh.vertices)} {len(mesh.triangles)} 0"]
    lines += [_text(v) for v in mesh.vertices]
    lines += [f"3 {a} {b} {c}" for a, b, c in mesh.triangles]
    return ("\n".join(lines) + "\n").encode("ascii")


def obj_text(mesh: Mesh) -> bytes:
    lines = ["v " + _text(v) for v in mesh.vertices]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.triangles]
    return ("\n".join(lines) + "\n").encode("ascii")


def _ply_header(mesh: Mesh, encoding: str) -> str:
    return (
        f"ply\nformat {encoding} 1.0\n"
        f"element vertex {len(mesh.vertices)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(mesh.triangles)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )


def ply_text(mesh: Mesh) -> bytes:
    lines = [_text(v) for v in mesh.vertices]
    lines += [f"3 {a} {b} {c}" for a, b, c in mesh.triangles]
    return (_ply_header(mesh, "ascii") + "\n".join(lines) + "\n").encode("ascii")


def _ply_binary(mesh: Mesh, encoding: str, order: str) -> bytes:
    vertex, face = struct.Struct(order + "3f"), struct.Struct(order + "B3i")
    body = [vertex.pack(*v) for v in mesh.vertices]
    body += [face.pack(3, *t) for t in mesh.triangles]
    return _ply_header(mesh, encoding).encode("ascii") + b"".join(body)


def ply_little_endian(mesh: Mesh) -> bytes:
    return _ply_binary(mesh, "binary_little_endian", "<")


def ply_big_endian(mesh: Mesh) -> bytes:
    return _ply_binary(mesh, "binary_big_endian", ">")


def _normal(a: Point, b: Point, c: Point) -> Point:
    u = [b[k] - a[k] for k in range(3)]
    v = [c[k] - a[k] for k in range(3)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
    return (n[0] / length, n[1] / length, n[2] / length) if length > 0.0 else (0.0, 0.0, 0.0)


def stl_text(mesh: Mesh) -> bytes:
    lines = ["solid demo"]
    for a, b, c in (tuple(mesh.vertices[i] for i in t) for t in mesh.triangles):
        # Rounded, because the last digits of a normal of a tiny triangle are noise.
        lines.append(" facet normal " + " ".join(f"{x:.4f}" for x in _normal(a, b, c)))
        lines.append("  outer loop")
        lines += ["   vertex " + _text(p) for p in (a, b, c)]
        lines += ["  endloop", " endfacet"]
    return ("\n".join(lines + ["endsolid demo"]) + "\n").encode("ascii")


def stl_binary(mesh: Mesh) -> bytes:
    facet = struct.Struct("<12fH")
    body = [struct.pack("<80sI", b"demo collection", len(mesh.triangles))]
    for a, b, c in (tuple(mesh.vertices[i] for i in t) for t in mesh.triangles):
        normal = (round(x, 4) for x in _normal(a, b, c))
        body.append(facet.pack(*normal, *a, *b, *c, 0))
    return b"".join(body)


Encoder = Callable[[Mesh], bytes]

# The mixture: file ending, name for people, encoder.
FORMATS: tuple[tuple[str, str, Encoder], ...] = (
    (".off", "OFF", off_text),
    (".obj", "OBJ", obj_text),
    (".ply", "PLY text", ply_text),
    (".stl", "STL binary", stl_binary),
    (".ply", "PLY little-endian", ply_little_endian),
    (".stl", "STL text", stl_text),
    (".ply", "PLY big-endian", ply_big_endian),
)

# The encoder for a file that is named by its ending only.
BY_ENDING: dict[str, Encoder] = {
    ".off": off_text,
    ".obj": obj_text,
    ".ply": ply_little_endian,
    ".stl": stl_binary,
}


def write_mesh(mesh: Mesh, path: Path, encoder: Encoder) -> None:
    """Writes one file."""
    path.write_bytes(encoder(mesh))
