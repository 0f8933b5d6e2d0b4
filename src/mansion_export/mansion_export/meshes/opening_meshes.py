"""Door frames, door leaves and windows as nodes of a model; leaves of one size share a mesh."""

from collections.abc import Iterator

import numpy as np

from mansion_export.meshes.door_sides import swing_side
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_geometry.building_models import ASIDE, JAMB, OPEN_ANGLE
from mansion_geometry.doorways import LEAFLESS, depth_of_doors
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import Door, FloorScene, Window
from mansion_msgs_py.shapes import Segment

__all__ = ["door_parts", "leaf_parts", "window_parts"]

LEAF = 0.045
TRIM = 0.1
"""Breadth of the trims around a lift's door, metres."""

SEAM = 0.012
"""Breadth of the dark edge of a sliding panel, metres: closed, two panels are seen to be two."""

PROUD = 0.01
"""Metres by which frames stand out from the wall's faces, so that no faces coincide."""

SLAT = 0.44
"""Height of a slat, metres."""

GROOVE = 0.012
"""Between two slats, metres."""

THICKNESS = 0.05
"""Thickness of a slat, metres."""

ROLL = 0.26
"""Height of the roll of an open door, metres."""


def door_parts(scene: FloorScene) -> Iterator[Part]:
    """Yield the frame of each door, then all leaves, open or closed as the scene has them."""
    depths = depth_of_doors(scene)
    for door in scene.doors:
        if door.kind == "open":
            continue
        x, y, rotation, length = _base(door.segment)
        deep = depths[door.id]
        name = f"door_frame:{length:.3f}x{door.height:.3f}x{deep:.3f}:{door.kind}"
        node = Node(door.id, name, "doors", (x, y, 0.0), rotation)
        material = _frame_material(door)
        surfaces = _frame(length, door.height, deep, material)
        if door.kind == "sliding":
            surfaces.append(boxes_surface(_portal(length, door.height, deep), material))
        yield node, surfaces
    yield from leaf_parts(scene)


def _base(segment: Segment) -> tuple[float, float, float, float]:
    (ax, ay), (bx, by) = segment
    rotation = float(np.degrees(np.arctan2(by - ay, bx - ax)))
    return ax, ay, rotation, float(np.hypot(bx - ax, by - ay))


def _frame_material(door: Door) -> Material:
    if door.kind == "frame":
        return named("brushed_steel")
    steel = ("sliding", "glazed", "entrance", "balcony", "garage")
    return named("painted_steel" if door.kind in steel else "painted_wood")


def _frame(length: float, height: float, deep: float, material: Material) -> list[Surface]:
    wide = deep + 2 * PROUD
    boxes = [
        Box((JAMB / 2, 0.0, height / 2), (JAMB, wide, height)),
        Box((length - JAMB / 2, 0.0, height / 2), (JAMB, wide, height)),
        Box((length / 2, 0.0, height - JAMB / 2), (length - 2 * JAMB, wide, JAMB)),
    ]
    return [boxes_surface(boxes, material)]


def _portal(length: float, height: float, deep: float) -> list[Box]:
    """Return broad trims around a lift's opening on both faces of the wall."""
    boxes = []
    for side in (-1, 1):
        y = side * (deep / 2 + PROUD)
        boxes += [
            Box((-TRIM / 2, y, (height + TRIM) / 2), (TRIM, 2 * PROUD, height + TRIM)),
            Box((length + TRIM / 2, y, (height + TRIM) / 2), (TRIM, 2 * PROUD, height + TRIM)),
            Box((length / 2, y, height + TRIM / 2), (length, 2 * PROUD, TRIM)),
        ]
    return boxes


def leaf_parts(scene: FloorScene) -> list[Part]:
    """Return the leaves of a floor's doors, their origin on the hinge and x towards the other jamb."""
    rooms = {room.id: room.polygon for room in scene.rooms}
    rooms |= {core.id: core.polygon for core in scene.cores}
    leaves: list[Part] = []
    for door in scene.doors:
        if door.kind in LEAFLESS:
            continue
        if door.kind == "garage":
            leaves.append(_slats(door))
        elif door.kind == "sliding" or door.hinge == "none":
            leaves += _panels(door)
        else:
            leaves += _hung(door, swing_side(door, rooms))
    return leaves


def _slats(door: Door) -> Part:
    """Return a garage door's slats, in the plane of the wall."""
    x, y, rotation, length = _base(door.segment)
    width, height = length - 2 * JAMB, door.height - JAMB - 0.01
    ux, uy = float(np.cos(np.radians(rotation))), float(np.sin(np.radians(rotation)))
    name = f"garage_door:{width:.3f}x{height:.3f}:{'open' if door.is_open else 'closed'}"
    place = (x + ux * JAMB, y + uy * JAMB, 0.01)
    node = Node(f"{door.id}/leaf", name, "doors", place, rotation)
    return node, _garage_slats(width, height, door)


def _panels(door: Door) -> list[Part]:
    """Return two sliding panels; open ones stand before the wall on both sides."""
    x, y, rotation, length = _base(door.segment)
    width = length / 2 - JAMB
    ux, uy = np.cos(np.radians(rotation)), np.sin(np.radians(rotation))
    name = f"door_panel:{width:.3f}x{door.height:.3f}:{door.kind}"
    found: list[Part] = []
    for i, closed in enumerate((JAMB, length / 2)):
        aside = (-width if i == 0 else width) * ASIDE if door.is_open else 0.0
        at = closed + aside
        place = (x + float(ux) * at, y + float(uy) * at, 0.01)
        node = Node(f"{door.id}/leaf_{i + 1}", name, "doors", place, rotation)
        found.append((node, _leaf(width, door.height - JAMB - 0.01, door.kind, handle=False)))
    return found


def _hung(door: Door, side: int) -> list[Part]:
    """Return leaves that turn on their hinges into the room of the swing."""
    x, y, rotation, length = _base(door.segment)
    both = door.hinge == "both" or door.kind == "double"
    width = (length - 2 * JAMB) / (2 if both else 1)
    ends = (False, True) if both else (door.hinge == "end",)
    angle = OPEN_ANGLE if door.is_open else 0.0
    ux, uy = float(np.cos(np.radians(rotation))), float(np.sin(np.radians(rotation)))
    name = f"door_leaf:{width:.3f}x{door.height:.3f}:{door.kind}"
    found: list[Part] = []
    for i, at_end in enumerate(ends):
        along = length - JAMB if at_end else JAMB
        turn = rotation + (180.0 - side * angle if at_end else side * angle)
        place = (x + ux * along, y + uy * along, 0.01)
        suffix = f"leaf_{i + 1}" if both else "leaf"
        node = Node(f"{door.id}/{suffix}", name, "doors", place, turn)
        found.append((node, _leaf(width, door.height - JAMB - 0.01, door.kind, handle=True)))
    return found


def _leaf(width: float, height: float, kind: str, *, handle: bool) -> list[Surface]:
    surfaces = []
    if kind in ("glazed", "entrance", "balcony"):
        rail, frame = 0.09, named("painted_steel")
        bars = [
            Box((rail / 2, 0.0, height / 2), (rail, LEAF, height)),
            Box((width - rail / 2, 0.0, height / 2), (rail, LEAF, height)),
            Box((width / 2, 0.0, rail / 2), (width - 2 * rail, LEAF, rail)),
            Box((width / 2, 0.0, height - rail / 2), (width - 2 * rail, LEAF, rail)),
        ]
        pane = Box((width / 2, 0.0, height / 2), (width - 2 * rail, 0.01, height - 2 * rail))
        surfaces += [boxes_surface(bars, frame), boxes_surface([pane], named("glass"))]
    else:
        steel = kind == "sliding"
        edge = SEAM if steel else 0.0
        body = Box((width / 2, 0.0, height / 2), (width - 2 * edge, LEAF, height))
        surfaces.append(boxes_surface([body], named("brushed_steel" if steel else "light_wood")))
        if steel:
            edges = [Box((x, 0.0, height / 2), (edge, LEAF, height)) for x in (edge / 2, width - edge / 2)]
            surfaces.append(boxes_surface(edges, named("rubber")))
    if handle:
        grips = [Box((width - 0.1, side * (LEAF / 2 + 0.025), 1.02), (0.12, 0.02, 0.02)) for side in (-1, 1)]
        surfaces.append(boxes_surface(grips, named("brushed_steel")))
    return surfaces


def window_parts(scene: FloorScene) -> Iterator[Part]:
    """Yield windows: frame, mullions, glass, a sill board inside and a ledge of stone outside."""
    walls = {wall.id: wall for wall in scene.walls}
    home = default_knowledge().groups.is_dwelling(scene.building_type)
    frame = named("painted_wood" if home else "painted_steel")
    for window in scene.windows:
        x, y, rotation, length = _base(window.segment)
        wall = walls.get(window.wall)
        deep = wall.thickness if wall is not None else 0.2
        inward = 1.0 if wall is None or wall.left == window.room else -1.0
        name = f"window:{length:.3f}x{window.height:.3f}x{deep:.3f}:{inward:+.0f}"
        node = Node(window.id, name, "windows", (x, y, window.sill), rotation, room=window.room)
        yield node, _window(window, length, deep, inward, frame)


def _window(window: Window, length: float, deep: float, inward: float, frame: Material) -> list[Surface]:
    height, bar = window.height, 0.05
    bars = [
        Box((bar / 2, 0.0, height / 2), (bar, 0.07, height)),
        Box((length - bar / 2, 0.0, height / 2), (bar, 0.07, height)),
        Box((length / 2, 0.0, bar / 2), (length - 2 * bar, 0.07, bar)),
        Box((length / 2, 0.0, height - bar / 2), (length - 2 * bar, 0.07, bar)),
    ]
    fields = max(1, round(length / 1.2))
    bars += [Box((length * i / fields, 0.0, height / 2), (bar, 0.06, height - 2 * bar)) for i in range(1, fields)]
    board = Box((length / 2, inward * (deep / 2 + 0.02), -0.01), (length + 0.1, 0.12, 0.03))
    ledge = Box((length / 2, -inward * deep / 2, -0.015), (length + 0.1, 0.12, 0.05))
    pane = Box((length / 2, 0.0, height / 2), (length - bar, 0.012, height - bar))
    return [
        boxes_surface(bars, frame),
        boxes_surface([board], named("painted_wood")),
        boxes_surface([ledge], named("stone_paving")),
        boxes_surface([pane], named("glass")),
    ]


def _garage_slats(width: float, height: float, door: Door) -> list[Surface]:
    """Return the door's surfaces, its lower left corner at the origin, x along the opening.

    Parameters
    ----------
    width, height : float
        Width and height of the opening inside its frame, metres.
    door : Door
        Open or closed; an open one is a roll below the head of the opening.
    """
    if door.is_open:
        roll = Box((width / 2, 0.0, height - ROLL / 2), (width, 4 * THICKNESS, ROLL))
        return [boxes_surface([roll], named("brushed_steel"))]
    count = max(1, round(height / SLAT))
    step = height / count
    slats = [Box((width / 2, 0.0, (i + 0.5) * step), (width, THICKNESS, step - GROOVE)) for i in range(count)]
    core = Box((width / 2, 0.0, height / 2), (width, THICKNESS - 2 * GROOVE, height))
    grip = [Box((width / 2, side * (THICKNESS / 2 + 0.015), 0.7 * step), (0.22, 0.03, 0.03)) for side in (-1, 1)]
    return [boxes_surface(slats, named("signal_white")), boxes_surface([core, *grip], named("painted_steel"))]
