"""Canopies over the doors to the street, and the level ground before them."""

from collections.abc import Iterator, Sequence
from typing import Final

import shapely
from shapely.geometry import Polygon

from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part
from mansion_export.meshes.solids import polygon_surface
from mansion_export.presentation import main_door
from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["accent", "entrance_parts", "outer_doors", "outward", "shown_outside"]

ACCENTS: Final = ("sign_blue", "sign_green", "sign_red", "sign_slate")
"""Colours of canopies and signs."""

CANOPY: Final = 1.3
"""How far a canopy reaches out, metres."""

ASIDE: Final = 0.5
"""How far a canopy reaches beyond a door on either side, metres."""

ROOFED: Final = frozenset({"marquee", "portal", "porch"})
"""What covers the main entrance in place of a plain canopy."""

ABOVE: Final = 0.22
THICKNESS: Final = 0.12
LANDING: Final = 1.6
"""Depth of the level ground before a door, metres: a wheelchair's turning circle is 1.5 m wide."""


def outer_doors(scene: FloorScene) -> list[Door]:
    """Return the doors that lead outside on the ground floor."""
    return [door for door in scene.doors if None in door.rooms] if scene.floor == 1 else []


def outward(door: Door, outline: Polygon) -> Point:
    """Return the unit vector from an outer door to the outside."""
    (ax, ay), (bx, by) = door.segment
    length = max(shapely.LineString(door.segment).length, 1e-9)
    dx, dy = (by - ay) / length, -(bx - ax) / length
    middle = shapely.Point((ax + bx) / 2 + 0.3 * dx, (ay + by) / 2 + 0.3 * dy)
    return (-dx, -dy) if outline.contains(middle) else (dx, dy)


def shown_outside(scene: FloorScene) -> Sequence[str]:
    """Return what a building shows outside, by what people call it, else by its type."""
    groups = default_knowledge().groups
    return groups.shown_outside(scene.called or "") or groups.shown_outside(scene.building_type)


def accent(scene: FloorScene) -> Material:
    """Return the colour of a building's canopies and of its sign; homes have plain steel."""
    if default_knowledge().groups.is_dwelling(scene.building_type):
        return named("painted_steel")
    return named(ACCENTS[int(item_generator(scene.seed, scene.building_type, "accent").integers(len(ACCENTS)))])


def entrance_parts(scene: FloorScene) -> Iterator[Part]:
    """Yield a canopy over each door to the street, and the paving before it."""
    outline = Polygon(scene.outline, scene.holes)
    wall = max((wall.thickness for wall in scene.walls if wall.exterior), default=0.24)
    shown = shown_outside(scene)
    roofed = main_door(scene) if ROOFED.intersection(shown) else None
    for door in outer_doors(scene):
        if door.kind == "garage":
            continue
        out = outward(door, outline)
        name = f"{door.id}/canopy"
        base = door.height + ABOVE
        canopy = _before(door, out, wall, CANOPY, ASIDE)
        landing = _before(door, out, wall, LANDING, ASIDE)
        if door != roofed:
            yield Node(name, name, "site"), [polygon_surface(canopy, base, base + THICKNESS, accent(scene))]
        name = f"{door.id}/landing"
        yield Node(name, name, "site"), [polygon_surface(landing, -0.1, -0.01, named("stone_paving"))]


def _before(door: Door, out: Point, wall: float, depth: float, aside: float) -> Polygon:
    """Return the rectangle of a depth before a door, from the outer face of its wall on."""
    (ax, ay), (bx, by) = door.segment
    length = max(shapely.LineString(door.segment).length, 1e-9)
    ux, uy = (bx - ax) / length, (by - ay) / length
    corners = [
        (ax - aside * ux + near * out[0], ay - aside * uy + near * out[1])
        if first
        else (bx + aside * ux + near * out[0], by + aside * uy + near * out[1])
        for first, near in ((True, wall), (False, wall), (False, wall + depth), (True, wall + depth))
    ]
    return shapely.geometry.polygon.orient(Polygon(corners))
