"""The boxes of a placement as AI2-THOR's runtime assets in a room of their own.

The form of a runtime asset is that of ``Thor.Procedural.Data`` (``SerializableCollider``, ``PhysicalProperties``,
``ObjectAnnotations``), which Objaverse's assets are loaded by too.
"""

from dataclasses import dataclass
from typing import Any, Final, TypeAlias

import numpy as np

from mansion_editing.physics.overlap import depth, upright
from mansion_editing.physics.problem import PosedBox, SettleProblem, mass
from mansion_export.thor import house
from mansion_geometry.thor.house_format import thor_euler, thor_point
from mansion_msgs_py.scene import FloorScene, SceneRoom, SpawnPose, Wall
from mansion_msgs_py.shapes import Point, Point3

__all__ = ["BODY", "Body", "house_of", "runtime_asset", "thor_bodies", "thor_shift"]

Json: TypeAlias = dict[str, Any]

BODY: Final = "body"
"""Name of the object that is let go."""

HALF_ROOM: Final = 4.0
"""Half the side of the room, metres; the agent stands in a corner, the body is over the middle."""

FALL: Final = 1.0
"""What falls off falls this far, metres."""

DIGITS: Final = 6
LAPPED: Final = 1e-3
"""Metres by which two boxes may be in each other at the start and still be let go."""

CORNERS: Final = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2.0

TRIANGLES: Final = (
    *(0, 3, 1, 0, 2, 3, 4, 7, 6, 4, 5, 7, 0, 5, 4, 0, 1, 5),
    *(2, 7, 3, 2, 6, 7, 0, 6, 2, 0, 4, 6, 1, 7, 5, 1, 3, 7),
)
"""Faces over `CORNERS`, clockwise from outside: Unity's front."""


@dataclass(frozen=True)
class Body:
    """A box with a name, and whether it stays where it is."""

    name: str
    box: PosedBox
    fixed: bool


def thor_shift(problem: SettleProblem) -> Point3:
    """Return what takes the problem over the middle of the room, clear of its floor."""
    boxes = [problem.body, *problem.support, *problem.shell, *problem.neighbours.values()]
    lowest = min(box.center[2] - box.size[2] / 2 for box in boxes)
    x, y, _ = problem.body.center
    return -x, -y, FALL - lowest


def thor_bodies(problem: SettleProblem) -> list[Body]:
    """Return the bodies of a problem, the one that is let go first.

    Notes
    -----
    A neighbour may stand within a box that stands for a hollow part of the receptacle. AI2-THOR has no collision
    classes that would let it; such a neighbour is fixed.
    """
    fixed = [upright(*box) for box in problem.shell]
    bodies = [Body(BODY, problem.body, False)]
    for kind, boxes in (("support", problem.support), ("shell", problem.shell)):
        bodies += [Body(f"{kind}_{number}", box, True) for number, box in enumerate(boxes)]
    for number, box in enumerate(problem.neighbours.values()):
        lapped = any(depth(upright(*box), other) > LAPPED for other in fixed)
        bodies.append(Body(f"neighbour_{number}", box, lapped))
    return bodies


def runtime_asset(body: Body) -> Json:
    """Return the argument ``asset`` of ``CreateRuntimeAsset``: a box around the origin, its collider the same."""
    points = CORNERS * np.array(body.box.size)
    vertices = [thor_point(x, y, z, DIGITS) for x, y, z in points.tolist()]
    outward = points / np.linalg.norm(points, axis=1, keepdims=True)
    triangles = list(TRIANGLES)
    return {
        "name": body.name,
        "vertices": vertices,
        "normals": [thor_point(x, y, z, DIGITS) for x, y, z in outward.tolist()],
        "triangles": triangles,
        "uvs": [{"x": 0.0, "y": 0.0} for _ in vertices],
        "colliders": [{"vertices": vertices, "triangles": triangles}],
        "physicalProperties": {
            "mass": round(mass(body.box), 5),
            "drag": 0.0,
            "angularDrag": 0.05,
            "useGravity": not body.fixed,
            "isKinematic": body.fixed,
        },
        "annotations": {
            "objectType": "Undefined",
            "primaryProperty": "Static" if body.fixed else "CanPickup",
            "secondaryProperties": [],
        },
        "receptacleCandidate": False,
    }


def house_of(bodies: list[Body], shift: Point3) -> Json:
    """Return a house of one room with the bodies in it, each shifted."""
    made = house(_room())
    layer = made["rooms"][0]["layer"]
    made["objects"] = [_node(body, shift, layer) for body in bodies]
    return made


def _node(body: Body, shift: Point3, layer: str) -> Json:
    x, y, z = (value + way for value, way in zip(body.box.center, shift, strict=True))
    w, d, h = body.box.size
    return {
        "id": body.name,
        "assetId": body.name,
        "position": thor_point(x, y, z, DIGITS),
        "rotation": thor_euler(body.box.rotation),
        "size": thor_point(w, d, h, DIGITS),
        "kinematic": body.fixed,
        "roomId": "room",
        "layer": layer,
        "children": [],
    }


def _room() -> FloorScene:
    """Return a floor that is one empty room around the origin."""
    side = HALF_ROOM
    ring: list[Point] = [(-side, -side), (side, -side), (side, side), (-side, side)]
    walls = [
        Wall(
            id=f"wall_{number}",
            segment=(ring[number], ring[(number + 1) % 4]),
            thickness=0.1,
            height=3.0,
            exterior=True,
            left="room",
        )
        for number in range(4)
    ]
    room = SceneRoom(
        id="room", room_type="living_room", kind="main", polygon=ring, net_polygon=ring, area=4 * side * side
    )
    return FloorScene(
        building_id="placement",
        floor=1,
        floors=1,
        label="1",
        elevation=0.0,
        height=3.2,
        outline=ring,
        rooms=[room],
        walls=walls,
        doors=[],
        spawn=SpawnPose(x=1.0 - side, y=1.0 - side, yaw=90.0, room="room"),
    )
