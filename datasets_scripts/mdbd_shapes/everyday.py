"""Families of everyday things. Each function draws one model's parameters from a generator.

Parts of a model that meet overlap a little, so that the solid has no gaps.
"""

from __future__ import annotations

import math
from random import Random

from .mesh import Mesh, Point, Point2, joined
from .polygon import circle, ellipse, rounded_rectangle
from .solids import beam, cylinder, extrude, revolve, rounded_box, sphere, sweep
from .transforms import turned


def _corners(width: float, depth: float) -> list[Point2]:
    return [(sx * width / 2, sy * depth / 2) for sx in (-1, 1) for sy in (-1, 1)]


def _leg_section(rng: Random, width: float) -> list[Point2]:
    if rng.random() < 0.5:
        return circle(width / 2, 14)
    return rounded_rectangle(width, width, 0.2 * width, 3)


def _chair_back(rng: Random, width: float, seat: float, depth: float, height: float) -> list[Mesh]:
    """Upright parts at the rear of the seat, leaning backwards."""
    lean = rng.uniform(0.05, 0.25) * height
    rear, top = depth / 2 - 0.03, seat + height

    def at(x: float, share: float) -> Point:
        return (x, rear + lean * share, seat + height * share)

    style = rng.choice(("panel", "slats", "ladder", "cross"))
    post = rng.uniform(0.035, 0.05)
    bar = circle(post / 2, 12)
    reach = width / 2 - post
    parts = []
    if style == "panel":
        panel = rounded_box((width - 0.02, post, height * 1.05), post * 0.45)
        tilt = turned(panel, "x", -math.atan2(lean, height))
        return [tilt.moved(0.0, rear + lean / 2, seat + height / 2)]
    for x in (-reach, reach):
        parts.append(beam(bar, (x, rear, seat - 0.02), at(x, 1.0), 6))
    rail = rounded_rectangle(post, 0.09, 0.015, 3)
    parts.append(beam(rail, at(-reach - 0.02, 0.94), at(reach + 0.02, 0.94), 6))
    if style == "slats":
        count = rng.randint(3, 6)
        for k in range(1, count + 1):
            x = reach * (2.0 * k / (count + 1) - 1.0)
            parts.append(beam(circle(0.012, 10), (x, rear, seat - 0.01), at(x, 0.93), 5))
    elif style == "ladder":
        for k in range(rng.randint(2, 4)):
            share = 0.25 + 0.2 * k
            rung = rounded_rectangle(0.02, 0.05, 0.008, 3)
            parts.append(beam(rung, at(-reach, share), at(reach, share), 5))
    else:
        for a, b in ((-reach, reach), (reach, -reach)):
            parts.append(beam(circle(0.013, 10), at(a, 0.05), at(b, 0.93), 6))
    return parts


def _arm_rests(rng: Random, width: float, seat: float, depth: float) -> list[Mesh]:
    height = rng.uniform(0.18, 0.25)
    parts = []
    for side in (-1, 1):
        x = side * (width / 2 - 0.02)
        front = -depth / 2 + rng.uniform(0.04, 0.08)
        parts.append(beam(circle(0.016, 10), (x, front, seat - 0.01), (x, front, seat + height), 5))
        pad = rounded_rectangle(0.05, 0.026, 0.01, 3)
        parts.append(
            beam(pad, (x, front - 0.04, seat + height), (x, depth / 2 + 0.02, seat + height), 6)
        )
    return parts


def chair(rng: Random) -> Mesh:
    width, depth = rng.uniform(0.40, 0.55), rng.uniform(0.38, 0.50)
    seat, thickness = rng.uniform(0.40, 0.50), rng.uniform(0.03, 0.07)
    leg = rng.uniform(0.030, 0.050)
    splay = rng.choice((0.0, 0.0, rng.uniform(0.04, 0.10)))
    taper = rng.uniform(0.55, 1.0)
    top = seat - 0.6 * thickness
    section = _leg_section(rng, leg)
    parts = [
        rounded_box((width, depth, thickness), 0.45 * thickness).moved(z=seat - thickness / 2)
    ]
    feet = []
    for x, y in _corners(width - 1.6 * leg, depth - 1.6 * leg):
        foot = (x + math.copysign(splay, x), y + math.copysign(splay, y), 0.0)
        feet.append(foot)
        parts.append(beam(section, (x, y, top), foot, 6, taper))
    if rng.random() < 0.4:
        share = rng.uniform(0.3, 0.5)
        for a, b in ((0, 1), (2, 3)):
            ends = []
            for x, y, _ in (feet[a], feet[b]):
                sx, sy = math.copysign(splay * share, x), math.copysign(splay * share, y)
                ends.append((x - sx, y - sy, share * seat))
            parts.append(beam(circle(0.25 * leg, 8), ends[0], ends[1], 5))
    parts += _chair_back(rng, width, seat, depth, rng.uniform(0.35, 0.60))
    if rng.random() < 0.4:
        parts += _arm_rests(rng, width, seat, depth)
    return joined(parts)


def table(rng: Random) -> Mesh:
    height, thickness = rng.uniform(0.45, 0.78), rng.uniform(0.025, 0.06)
    width = rng.uniform(0.9, 1.8)
    depth = width * rng.uniform(0.45, 0.8)
    round_top = rng.random() < 0.4
    if round_top:
        depth = width = rng.uniform(0.7, 1.2)
        plate = cylinder(width / 2, height - thickness, height, 48, 0.2 * thickness)
    else:
        plate = rounded_box((width, depth, thickness), 0.3 * thickness, 2, 6)
        plate = plate.moved(z=height - thickness / 2)
    top = height - 0.5 * thickness
    if round_top and rng.random() < 0.6:
        column = rng.uniform(0.03, 0.06)
        foot = rng.uniform(0.25, 0.4) * width
        base = [(foot, 0.0), (foot, 0.02), (column * 1.4, 0.06), (column, 0.12)]
        stem = [(column, 0.25 * height), (column * 1.2, 0.5 * height), (column, 0.75 * height)]
        return joined([plate, revolve([*base, *stem, (column * 2.5, top)], 32)])
    inset = 0.7 if round_top else 0.9
    leg = rng.uniform(0.045, 0.09)
    section, taper = _leg_section(rng, leg), rng.uniform(0.5, 1.0)
    spots = _corners(inset * width - leg, inset * depth - leg)
    parts = [plate] + [beam(section, (x, y, top), (x, y, 0.0), 8, taper) for x, y in spots]
    if rng.random() < 0.5:
        apron = rounded_rectangle(0.022, rng.uniform(0.06, 0.10), 0.006, 3)
        z = height - thickness - 0.03
        for a, b, drop in ((0, 1, 0.0), (2, 3, 0.0), (0, 2, 0.004), (1, 3, 0.004)):
            parts.append(beam(apron, (*spots[a], z - drop), (*spots[b], z - drop), 6))
    return joined(parts)


def _smooth(knots: list[Point2], steps: int) -> list[Point2]:
    """A Catmull-Rom curve through knots of (radius, z)."""
    ends = [knots[0], *knots, knots[-1]]
    curve = []
    for k in range(1, len(ends) - 2):
        p0, p1, p2, p3 = ends[k - 1 : k + 3]
        for j in range(steps):
            t = j / steps
            weights = (
                -0.5 * t + t * t - 0.5 * t**3,
                1.0 - 2.5 * t * t + 1.5 * t**3,
                0.5 * t + 2.0 * t * t - 1.5 * t**3,
                -0.5 * t * t + 0.5 * t**3,
            )
            pieces = list(zip(weights, (p0, p1, p2, p3)))
            curve.append((sum(w * p[0] for w, p in pieces), sum(w * p[1] for w, p in pieces)))
    return [*curve, knots[-1]]


def _vessel(outside: list[Point2], wall: float, floor: float, segments: int) -> Mesh:
    """A hollow body open at the top, one watertight surface; outside runs upwards."""
    rim = outside[-1][1]
    inside = [(r - wall, z) for r, z in reversed(outside) if z > floor + wall]
    lip = (outside[-1][0] - wall / 2, rim + 0.4 * wall)
    bottom = (inside[-1][0] * 0.85, floor)
    return revolve([*outside, lip, *inside, bottom, (0.0, floor)], segments)


def mug(rng: Random) -> Mesh:
    height, radius = rng.uniform(0.8, 1.3), rng.uniform(0.35, 0.5)
    wall = rng.uniform(0.10, 0.16) * radius
    flare = rng.uniform(-0.06, 0.12)
    knots = [(radius * (1.0 + flare * (z - 0.5)), z * height) for z in (0.05, 0.3, 0.6, 0.9, 1.0)]
    foot = (knots[0][0] - 0.04 * height, 0.0)
    body = _vessel([foot, *_smooth(knots, 3)], wall, wall * 1.2, 48)
    lower, upper = rng.uniform(0.18, 0.28) * height, rng.uniform(0.72, 0.85) * height
    reach, grip = rng.uniform(0.28, 0.42), rng.uniform(0.05, 0.075)
    squareness = rng.uniform(0.5, 1.0)
    path, count = [], 24
    for k in range(count + 1):
        t = math.pi * (k / count - 0.5)
        bow = math.copysign(abs(math.sin(t)) ** squareness, t)
        z = (lower + upper) / 2 + bow * (upper - lower) / 2
        edge = radius * (1.0 + flare * (z / height - 0.5)) - 0.5 * wall
        path.append((edge + reach * math.cos(t) ** squareness, 0.0, z))
    section = ellipse(grip * rng.uniform(1.0, 1.4), grip, 12)
    return joined([body, sweep(section, path, (0.0, 1.0, 0.0))])


def vase(rng: Random) -> Mesh:
    height = rng.uniform(1.2, 2.2)
    foot, belly = rng.uniform(0.18, 0.32), rng.uniform(0.38, 0.60)
    neck, lip = rng.uniform(0.12, 0.24), rng.uniform(0.20, 0.40)
    waist, throat = rng.uniform(0.30, 0.5), rng.uniform(0.72, 0.85)
    knots = [
        (foot, 0.0),
        (foot * 1.02, 0.04 * height),
        (0.5 * (foot + belly), 0.16 * height),
        (belly, waist * height),
        (0.5 * (belly + neck), 0.5 * (waist + throat) * height),
        (neck, throat * height),
        (lip, height),
    ]
    wall = rng.uniform(0.04, 0.06)
    body = _vessel(_smooth(knots, 5), wall, 2.0 * wall, 40)
    if rng.random() < 0.35:
        parts = [body]
        for side in (0.0, math.pi):
            path = []
            for k in range(19):
                t = math.pi * (k / 18 - 0.5)
                rise = 0.5 + 0.5 * math.sin(t)
                z = height * (waist + (throat - waist) * rise)
                edge = belly + (neck - belly) * rise - 0.5 * wall
                path.append((edge + 0.28 * math.cos(t), 0.0, z))
            parts.append(turned(sweep(circle(0.035, 10), path, (0.0, 1.0, 0.0)), "z", side))
        return joined(parts)
    return body


def bottle(rng: Random) -> Mesh:
    height, radius = rng.uniform(1.6, 2.6), rng.uniform(0.28, 0.45)
    neck = radius * rng.uniform(0.28, 0.45)
    shoulder, collar = rng.uniform(0.50, 0.65) * height, rng.uniform(0.74, 0.84) * height
    arc = []
    for k in range(1, 10):
        t = k / 10
        blend = 0.5 - 0.5 * math.cos(math.pi * t)
        arc.append((radius + (neck - radius) * blend, shoulder + (collar - shoulder) * t))
    body = [(0.85 * radius, 0.0), (radius, 0.08 * radius)]
    body += [(radius, shoulder * k / 6) for k in range(1, 7)]
    ring = neck * rng.uniform(1.15, 1.3)
    mouth = [
        (neck, collar), (neck, 0.95 * height), (ring, 0.955 * height), (ring, 0.985 * height),
        (neck, 0.99 * height), (neck, height),
    ]
    outside = revolve([*body, *arc, *mouth], 40)
    if rng.random() < 0.5:
        cap = cylinder(ring * 1.1, 0.94 * height, 1.03 * height, 40, 0.1 * neck)
        return joined([outside, cap])
    return outside


def goblet(rng: Random) -> Mesh:
    height = rng.uniform(1.4, 2.2)
    base, stem = rng.uniform(0.32, 0.45), rng.uniform(0.04, 0.08)
    bowl, rim = rng.uniform(0.35, 0.50), rng.uniform(0.28, 0.48)
    start = rng.uniform(0.40, 0.55)
    knob = stem * rng.uniform(1.0, 2.2)
    lower = _smooth(
        [
            (base * 0.6, 0.05 * height),
            (stem * 1.2, 0.12 * height),
            (stem, 0.5 * start * height),
            (knob, 0.7 * start * height),
            (stem, 0.9 * start * height),
        ],
        4,
    )
    upper = _smooth(
        [
            (stem, 0.9 * start * height),
            (0.75 * bowl, (start + 0.08) * height),
            (bowl, (start + 0.5 * (1.0 - start)) * height),
            (rim, height),
        ],
        6,
    )
    foot = [(base, 0.0), (base, 0.03 * height)]
    wall = rng.uniform(0.035, 0.055)
    return _vessel([*foot, *lower, *upper[1:]], wall, (start + 0.05) * height, 44)


def lamp(rng: Random) -> Mesh:
    height, pole = rng.uniform(1.2, 2.4), rng.uniform(0.03, 0.05)
    base = rng.uniform(0.25, 0.40)
    foot = [(base, 0.0), (base, 0.04), (0.6 * base, 0.08), (pole, 0.14)]
    column = revolve([*foot, (pole, 0.5 * height), (pole, height)], 28)
    bottom, top = rng.uniform(0.35, 0.55), rng.uniform(0.15, 0.33)
    low, high = height * rng.uniform(0.68, 0.75), height * rng.uniform(0.97, 1.03)
    wall = rng.uniform(0.03, 0.045)
    steps = [k / 5 for k in range(6)]
    outer = [(bottom + (top - bottom) * t, low + (high - low) * t) for t in steps]
    shade = revolve([*outer, *((r - wall, z) for r, z in reversed(outer))], 40, closed=True)
    z = low + 0.5 * (high - low)
    reach = 0.5 * (bottom + top) - 0.5 * wall
    parts = [column, shade]
    for k in range(3):
        c, s = math.cos(2.0 * math.pi * k / 3), math.sin(2.0 * math.pi * k / 3)
        start, end = (0.5 * pole * c, 0.5 * pole * s, z), (reach * c, reach * s, z)
        parts.append(beam(circle(0.4 * pole, 8), start, end, 4))
    if rng.random() < 0.5:
        parts.append(sphere(2.2 * pole, 16).moved(z=height))
    return joined(parts)


def hammer(rng: Random) -> Mesh:
    length, grip = rng.uniform(1.4, 2.2), rng.uniform(0.06, 0.09)
    shares = [k / 16 for k in range(17)]
    path = [(0.0, 0.0, length * t) for t in shares]
    scales = [1.0 - 0.35 * math.exp(-(((t - 0.65) / 0.2) ** 2)) for t in shares]
    handle = sweep(ellipse(grip * 1.3, grip, 18), path, (0.0, 1.0, 0.0), scales)
    block, face = rng.uniform(0.18, 0.24), rng.uniform(0.11, 0.15)
    z = length - 0.25 * block
    reach = rng.uniform(0.28, 0.40)
    centre = rounded_box((1.4 * block, block, block), 0.15 * block).moved(z=z)
    striker = turned(cylinder(face, 0.3 * block, reach, 28, 0.15 * face), "y", math.pi / 2)
    parts = [handle, centre, striker.moved(z=z)]
    if rng.random() < 0.5:
        # The peen tapers to an edge.
        wedge = rounded_rectangle(0.8 * block, 0.8 * block, 0.1 * block, 3)
        tail = beam(wedge, (-0.5 * block, 0.0, z), (-1.3 * reach, 0.0, z), 8, rng.uniform(0.2, 0.4))
        parts.append(tail)
    else:
        bend = rng.uniform(0.5, 0.9)
        for side in (-1, 1):
            claw = []
            for k in range(11):
                t = k / 10
                x, drop = -0.5 * block - reach * t, bend * reach * t * t
                claw.append((x, side * block * (0.22 + 0.15 * t), z - drop))
            prong = ellipse(0.16 * block, 0.26 * block, 12)
            parts.append(sweep(prong, claw, scales=[1.0 - 0.06 * k for k in range(11)]))
    return joined(parts)


def _star(rng: Random, points: int, outer: float, inner: float) -> list[Point2]:
    turn = rng.uniform(0.0, math.pi)
    outline = []
    for k in range(2 * points):
        r, t = (inner if k % 2 else outer), turn + math.pi * k / points
        outline.append((r * math.cos(t), r * math.sin(t)))
    return outline


def stool(rng: Random) -> Mesh:
    """A swivel stool: round seat, column, and a foot with several spokes."""
    height, seat = rng.uniform(0.6, 0.9), rng.uniform(0.18, 0.24)
    thickness, column = rng.uniform(0.05, 0.09), rng.uniform(0.025, 0.04)
    top = cylinder(seat, height - thickness, height, 40, 0.35 * thickness)
    spokes, reach = rng.randint(4, 6), rng.uniform(0.24, 0.32)
    hub = extrude(_star(rng, spokes, 2.4 * column, 1.8 * column), 0.05).moved(z=0.08)
    parts = [top, cylinder(column, 0.09, height - 0.5 * thickness, 24), hub]
    for k in range(spokes):
        t = 2.0 * math.pi * k / spokes
        start = (0.3 * column * math.cos(t), 0.3 * column * math.sin(t), 0.105)
        end = (reach * math.cos(t), reach * math.sin(t), 0.05)
        bar = rounded_rectangle(0.045, 0.035, 0.008, 2)
        parts.append(beam(bar, start, end, 6, rng.uniform(0.5, 0.8)))
        parts.append(sphere(0.03, 12).moved(end[0], end[1], 0.03))
    if rng.random() < 0.5:
        parts.append(_foot_ring(rng.uniform(0.12, 0.17), 0.35 * height, column))
    return joined(parts)


def _foot_ring(radius: float, z: float, column: float) -> Mesh:
    section = [(radius + x, z + y) for x, y in circle(0.012, 10)]
    ring = revolve(section, 36, closed=True)
    spokes = []
    for k in range(4):
        c, s = math.cos(math.pi * k / 2), math.sin(math.pi * k / 2)
        start, end = (0.5 * column * c, 0.5 * column * s, z), (radius * c, radius * s, z)
        spokes.append(beam(circle(0.008, 8), start, end, 3))
    return joined([ring, *spokes])
