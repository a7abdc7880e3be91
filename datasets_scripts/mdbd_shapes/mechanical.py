"""Families of mechanical parts. Each function draws one model's parameters from a generator."""

from __future__ import annotations

import math
from collections.abc import Callable
from random import Random

from .mesh import Mesh, Point, Point2, joined
from .polygon import circle, rounded_rectangle
from .solids import cylinder, extrude, loft, revolve, rounded_box, sphere, sweep, sweep_tube, tube
from .transforms import turned


def _hexagon_radius(angle: float) -> float:
    """Distance from the centre to a hexagon whose flats are at distance 1."""
    third = math.pi / 3
    return 1.0 / math.cos((angle % third) - third / 2)


def _shaped_ring(radius: Callable[[float], float], z: float, segments: int) -> list[Point]:
    """A ring of points whose radius depends on the angle."""
    ring = []
    for k in range(segments):
        t = 2.0 * math.pi * k / segments
        ring.append((radius(t) * math.cos(t), radius(t) * math.sin(t), z))
    return ring


def _hexagon_ring(flat: float, z: float, segments: int, limit: float = 9.0) -> list[Point]:
    """A hexagon whose corners are cut off at limit times the half width over flats."""
    return _shaped_ring(lambda t: flat * min(limit, _hexagon_radius(t)), z, segments)


def _thread(radius: float, start: float, end: float, pitch: float) -> list[Point2]:
    """Thread-like ridges on a shank, from start up to end."""
    count = max(2, round((end - start) / pitch))
    step = (end - start) / count
    profile = []
    for k in range(count):
        z = start + k * step
        profile += [(radius, z + 0.3 * step), (radius - 0.5 * pitch, z + 0.8 * step)]
    return profile


def bolt(rng: Random) -> Mesh:
    radius = 0.5
    flat, head = rng.uniform(0.80, 0.95), rng.uniform(0.6, 0.8)
    length = rng.uniform(2.0, 6.0)
    plain = length * rng.choice((0.02, rng.uniform(0.2, 0.5)))
    pitch = rng.uniform(0.14, 0.22)
    # The thread points downwards from the head, so it is built upside down and then turned over.
    tip = length - 0.15
    profile = [(radius, -0.3 * head), (radius, 0.5 * plain), (radius, plain)]
    profile += _thread(radius, plain, tip, pitch)
    profile += [(radius - 0.5 * pitch, tip), (radius - 0.5 * pitch - 0.12, length)]
    parts = [revolve(profile, 36)]
    if rng.random() < 0.25:
        parts.append(_socket_head(flat, head, rng))
    else:
        rings = [_hexagon_ring(flat, -head, 48, 1.0), _hexagon_ring(flat, -0.85 * head, 48, 1.1547)]
        rings += [_hexagon_ring(flat, 0.0, 48)]
        parts.append(loft(rings))
        if rng.random() < 0.4:
            collar = flat * rng.uniform(1.25, 1.4)
            parts.append(cylinder(collar, -0.12, 0.06, 48, 0.04))
    return turned(joined(parts), "x", math.pi)


def _socket_head(radius: float, height: float, rng: Random) -> Mesh:
    """A round head with a hexagonal socket, one surface; its top faces downwards."""
    socket, depth = rng.uniform(0.40, 0.50) * radius, 0.55 * height
    rings = [
        _hexagon_ring(socket, -height + depth, 48),
        _hexagon_ring(socket, -height, 48),
        [(x, y, -height) for x, y in circle(radius - 0.08, 48)],
        [(x, y, -height + 0.08) for x, y in circle(radius, 48)],
        [(x, y, 0.0) for x, y in circle(radius, 48)],
    ]
    return loft(rings)


def nut(rng: Random) -> Mesh:
    flat = 1.0
    bore = flat * rng.uniform(0.52, 0.64)
    height = flat * rng.uniform(0.6, 1.3)
    segments, bevel = 72, 0.08
    rings = [_hexagon_ring(flat, 0.0, segments, 1.0), _hexagon_ring(flat, bevel, segments)]
    rings += [_hexagon_ring(flat, height / 2, segments)]
    rings += [_hexagon_ring(flat, height - bevel, segments)]
    rings += [_hexagon_ring(flat, height, segments, 1.0)]
    inside = [(bore + 0.07, height), *reversed(_thread(bore + 0.05, 0.05, height - 0.05, 0.14))]
    rings += [[(x, y, z) for x, y in circle(r, segments)] for r, z in [*inside, (bore + 0.07, 0.0)]]
    body = loft(rings, closed=True)
    if rng.random() < 0.35:
        collar = tube(bore + 0.03, flat * rng.uniform(1.3, 1.5), -0.12, 0.04, segments, 0.05)
        return joined([body, collar])
    return body


def washer(rng: Random) -> Mesh:
    outer = 1.0
    inner = rng.uniform(0.42, 0.62)
    height = rng.uniform(0.08, 0.2)
    style = rng.choice(("flat", "flat", "cone", "split"))
    if style == "flat":
        return tube(inner, outer, 0.0, height, 90, 0.25 * height)
    if style == "cone":
        rise = rng.uniform(0.12, 0.3)
        shares = [k / 4 for k in range(5)]
        below = [(inner + (outer - inner) * t, rise * (1.0 - t)) for t in shares]
        above = [(r, z + height) for r, z in reversed(below)]
        return revolve([*below, *above], 72, closed=True)
    gap, lift, count = rng.uniform(0.06, 0.15), rng.uniform(0.5, 1.0) * height, 80
    middle = 0.5 * (inner + outer)
    path = []
    for k in range(count + 1):
        t = gap + (2.0 * math.pi - 2.0 * gap) * k / count
        path.append((middle * math.cos(t), middle * math.sin(t), lift * k / count))
    width = outer - inner
    return sweep(rounded_rectangle(width, 0.6 * width, 0.08, 2), path)


def _tooth(phase: float, root: float, tip: float, softness: float) -> float:
    """Radius of a gear's outline at a phase of 0 to 1 within one tooth."""
    distance = abs(phase - 0.5) * 2.0
    top, foot = 0.5 - softness, 0.5 + softness
    if distance <= top:
        return tip
    if distance >= foot:
        return root
    return tip + (root - tip) * (distance - top) / (foot - top)


def gear(rng: Random) -> Mesh:
    teeth = rng.randint(10, 22)
    tip = 1.0
    root = tip - rng.uniform(2.2, 2.8) / (teeth + 2.0)
    width = rng.uniform(0.2, 0.5)
    bore = rng.uniform(0.15, 0.3)
    helix = rng.choice((0.0, 0.0, rng.uniform(0.1, 0.3)))
    per_tooth = 8
    segments = teeth * per_tooth
    softness = rng.uniform(0.15, 0.25)

    def outline(z: float, turn: float) -> list[Point]:
        ring = []
        for k in range(segments):
            t = 2.0 * math.pi * k / segments + turn
            r = _tooth((k % per_tooth) / per_tooth, root, tip, softness)
            ring.append((r * math.cos(t), r * math.sin(t), z))
        return ring

    def round_ring(radius: float, z: float, turn: float) -> list[Point]:
        steps = [2.0 * math.pi * k / segments + turn for k in range(segments)]
        return [(radius * math.cos(t), radius * math.sin(t), z) for t in steps]

    layers = 5 if helix else 3
    rings = []
    for k in range(layers):
        share = k / (layers - 1)
        rings.append(outline(width * share, helix * share))
    hub, rim = bore + rng.uniform(0.1, 0.2), root - rng.uniform(0.08, 0.14)
    web = width * rng.choice((0.0, rng.uniform(0.2, 0.3)))
    stand = rng.choice((0.0, rng.uniform(0.1, 0.3)))
    top = [(rim, width), (rim - 0.02, width - web), (hub + 0.02, width - web), (hub, width + stand)]
    bottom = [(bore, 0.0), (hub, 0.0), (hub + 0.02, web), (rim - 0.02, web), (rim, 0.0)]
    # One ring of the bore for each turn, so that the strips do not shear over the whole width.
    rings += [round_ring(r, z, helix) for r, z in [*top, (bore, width + stand)]]
    rings += [round_ring(bore, 0.5 * (width + stand), 0.5 * helix)]
    rings += [round_ring(r, z, 0.0) for r, z in bottom]
    return loft(rings, closed=True)


def _plate(rng: Random, length: float, width: float, thickness: float, first: float) -> Mesh:
    """A plate in the x-y plane from x = 0 with a row or a grid of holes beyond x = first."""
    outline = [(x + length / 2, y) for x, y in rounded_rectangle(length, width, 0.12 * width, 6)]
    space = length - first
    radius = min(width, 1.2 * space) * rng.uniform(0.09, 0.12)
    if rng.random() < 0.5:
        spots = [(first + space * k / 3, 0.0) for k in (1, 2)]
    else:
        spots = [(first + space * k / 3, side * 0.25 * width) for k in (1, 2) for side in (-1, 1)]
    return extrude(outline, thickness, [circle(radius, 20, spot) for spot in spots])


def bracket(rng: Random) -> Mesh:
    width, thickness = rng.uniform(0.7, 1.2), rng.uniform(0.10, 0.16)
    length, height = rng.uniform(1.0, 1.8), rng.uniform(0.9, 1.6)
    foot = _plate(rng, length, width, thickness, 2.0 * thickness)
    wall = turned(_plate(rng, height, width, thickness, 2.0 * thickness), "y", -math.pi / 2)
    # Each plate ends inside the other, so that no two faces coincide at the corner.
    inset = 0.15 * thickness
    parts = [foot.moved(x=inset), wall.moved(x=thickness, z=inset)]
    bead = rounded_box((1.6 * thickness, 0.98 * width, 1.6 * thickness), 0.4 * thickness, 3, 4)
    parts.append(bead.moved(thickness, 0.0, thickness))
    style = rng.choice(("plain", "one rib", "two ribs"))
    reach = rng.uniform(0.35, 0.6) * min(length, height)
    rib = [(0.3 * thickness, 0.3 * thickness), (reach, 0.3 * thickness), (reach, thickness * 1.1)]
    rib += [(thickness * 1.1, reach), (0.3 * thickness, reach)]
    across = 0.8 * thickness
    spots = {"plain": [], "one rib": [0.0], "two ribs": [-0.42 * width, 0.42 * width]}[style]
    for y in spots:
        parts.append(turned(extrude(rib, across), "x", math.pi / 2).moved(y=y + across / 2))
    return joined(parts)


def _elbow_path(bend: float, radius: float, straight: float, steps: int) -> list[Point]:
    """A straight piece along x, an arc that turns by bend, and another straight piece."""
    path = [(-straight, 0.0, 0.0), (-0.5 * straight, 0.0, 0.0)]
    for k in range(steps + 1):
        t = bend * k / steps
        path.append((radius * math.sin(t), radius * (1.0 - math.cos(t)), 0.0))
    x, y, _ = path[-1]
    for share in (0.5, 1.0):
        reach = straight * share
        path.append((x + reach * math.cos(bend), y + reach * math.sin(bend), 0.0))
    return path


def pipe_elbow(rng: Random) -> Mesh:
    outer = 0.5
    inner = outer * rng.uniform(0.70, 0.82)
    bend = math.radians(rng.choice((45.0, 60.0, 90.0, 90.0, 90.0)) + rng.uniform(-4.0, 4.0))
    radius, straight = rng.uniform(0.8, 1.6), rng.uniform(0.3, 1.0)
    path = _elbow_path(bend, radius, straight, 14)
    parts = [sweep_tube(inner, outer, 36, path)]
    style = rng.choice(("plain", "sleeve", "flange"))
    if style != "plain":
        reach = outer * (1.2 if style == "sleeve" else rng.uniform(1.5, 1.8))
        depth = 0.25 if style == "sleeve" else 0.12
        ring = turned(tube(0.5 * (inner + outer), reach, -0.02, depth, 36, 0.02), "y", math.pi / 2)
        parts.append(ring.moved(x=-straight))
        x, y, _ = path[-1]
        parts.append(turned(ring, "z", bend + math.pi).moved(x, y))
    return joined(parts)


def flange(rng: Random) -> Mesh:
    outer, bore = 1.0, rng.uniform(0.28, 0.42)
    thickness = rng.uniform(0.12, 0.22)
    neck = bore + rng.uniform(0.08, 0.13)
    holes = rng.choice((4, 4, 6, 8))
    ring, hole = 0.5 * (neck + 0.1 + outer), rng.uniform(0.06, 0.1)
    spots = [
        (ring * math.cos(t), ring * math.sin(t))
        for t in (2.0 * math.pi * (k + 0.5) / holes for k in range(holes))
    ]
    openings = [circle(bore, 40), *(circle(hole, 18, spot) for spot in spots)]
    plate = extrude(circle(outer, 64), thickness, openings)
    height = thickness + rng.uniform(0.2, 0.9)
    weld = neck * rng.uniform(0.9, 1.0)
    # The neck's own bore is a hair wider, so that the two surfaces do not coincide.
    clear = bore * 1.01
    profile = [
        (clear, 0.3 * thickness), (neck + 0.1, 0.3 * thickness), (neck + 0.1, thickness + 0.02),
        (neck, thickness + 0.12), (weld, height), (clear, height),
    ]
    parts = [plate, revolve(profile, 40, closed=True)]
    if rng.random() < 0.4:
        parts.append(tube(clear, 0.5 * (neck + ring), -0.05, 0.4 * thickness, 40, 0.01))
    return joined(parts)


def bearing(rng: Random) -> Mesh:
    outer, bore = 1.0, rng.uniform(0.35, 0.55)
    width = rng.uniform(0.25, 0.45)
    gap = outer - bore
    ball = min(0.24 * gap, 0.42 * width)
    middle, wall = bore + 0.5 * gap, 0.62 * ball
    groove = [math.pi * (k / 8 - 0.5) * 0.62 for k in range(9)]
    hollow = 1.02 * ball
    inner_race = [(middle - hollow * math.cos(t), hollow * math.sin(t)) for t in groove]
    outer_race = [(middle + hollow * math.cos(t), hollow * math.sin(t)) for t in reversed(groove)]
    low, high, bevel = -width / 2, width / 2, 0.12 * wall
    inner_edge, outer_edge = inner_race[0][0], outer_race[0][0]
    inner = [(bore, low + bevel), (bore + bevel, low), (inner_edge, low), *inner_race]
    inner += [(inner_edge, high), (bore + bevel, high), (bore, high - bevel)]
    cup = [(outer, low + bevel), (outer, high - bevel), (outer - bevel, high), (outer_edge, high)]
    cup += [*outer_race, (outer_edge, low), (outer - bevel, low)]
    rings = [revolve(inner, 48, closed=True), revolve(cup, 48, closed=True)]
    count = min(rng.randint(7, 11), int(math.pi / math.asin(1.15 * ball / middle)))
    body = cylinder(1.03 * ball, -0.4 * width, 0.4 * width, 16, 0.1 * ball)
    body = sphere(1.06 * ball, 14) if rng.random() < 0.75 else body
    rollers = []
    for k in range(count):
        t = 2.0 * math.pi * k / count
        rollers.append(body.moved(middle * math.cos(t), middle * math.sin(t)))
    return joined([*rings, *rollers])


def spring(rng: Random) -> Mesh:
    coils, wire = rng.randint(4, 8), rng.uniform(0.06, 0.12)
    pitch = wire * rng.uniform(3.0, 5.0)
    radius, end = rng.uniform(0.45, 0.7), rng.uniform(0.7, 1.0)
    per_coil = 26
    path = []
    for k in range(coils * per_coil + 1):
        t = 2.0 * math.pi * k / per_coil
        r = radius * (1.0 + (end - 1.0) * k / (coils * per_coil))
        path.append((r * math.cos(t), r * math.sin(t), pitch * k / per_coil))
    return sweep(circle(wire, 10), path)


def pulley(rng: Random) -> Mesh:
    outer, bore = 1.0, rng.uniform(0.14, 0.22)
    grooves, pitch = rng.randint(1, 3), rng.uniform(0.22, 0.32)
    depth = rng.uniform(0.14, 0.22)
    width = grooves * pitch + 0.08
    rim = [(outer, 0.0)]
    for k in range(grooves):
        z = 0.04 + k * pitch
        for share, low in ((0.05, 0.0), (0.38, 1.0), (0.62, 1.0), (0.95, 0.0)):
            rim.append((outer - depth * low, z + share * pitch))
    rim.append((outer, width))
    hub, inside = bore + rng.uniform(0.12, 0.2), outer - depth - rng.uniform(0.1, 0.16)
    web = width * rng.choice((0.0, rng.uniform(0.2, 0.35)))
    stand = rng.choice((0.0, rng.uniform(0.1, 0.3)))
    faces = [(inside, width), (inside - 0.02, width - web), (hub + 0.02, width - web)]
    faces += [(hub, width + stand), (bore, width + stand)]
    faces += [(bore, 0.5 * width), (bore, 0.0), (hub, 0.0)]
    faces += [(hub + 0.02, web), (inside - 0.02, web), (inside, 0.0)]
    return revolve([*rim, *faces], 56, closed=True)
