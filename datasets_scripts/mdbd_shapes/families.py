"""The families of the demo collection by name; the names are the labels."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from . import everyday, mechanical
from .mesh import Mesh

Family = Callable[[Random], Mesh]

FAMILIES: dict[str, Family] = {
    "bearing": mechanical.bearing,
    "bolt": mechanical.bolt,
    "bottle": everyday.bottle,
    "bracket": mechanical.bracket,
    "chair": everyday.chair,
    "flange": mechanical.flange,
    "gear": mechanical.gear,
    "goblet": everyday.goblet,
    "hammer": everyday.hammer,
    "lamp": everyday.lamp,
    "mug": everyday.mug,
    "nut": mechanical.nut,
    "pipe_elbow": mechanical.pipe_elbow,
    "pulley": mechanical.pulley,
    "spring": mechanical.spring,
    "stool": everyday.stool,
    "table": everyday.table,
    "vase": everyday.vase,
    "washer": mechanical.washer,
}
