"""AI2-THOR's runtime assets: boxes that no build of it contains, and a house of one empty room to put them in.

The form of a runtime asset is that of ``Thor.Procedural.Data`` (``SerializableCollider``, ``PhysicalProperties``,
``ObjectAnnotations``), by which Objaverse's assets are loaded, too.
"""

from typing import Any, Final, TypeAlias

import numpy as np

from mansion_export.thor.house import house
from mansion_geometry.thor.house_format import thor_euler, thor_point
from mansion_msgs_py.scene import FloorScene, SceneRoom, SpawnPose, Wall
from mansion_msgs_py.shapes import Point, Point3

__all__ = ["box_asset", "box_node", "empty_house"]

Json: TypeAlias = dict[str, Any]

HALF_ROOM: Final = 4.0
"""Half the side of the empty room, metres."""

_DIGITS: Final = 6
"""Digits of coordinates, finer than in a house that is built: the physics compares them."""

_ROOM: Final = "room"

_CORNERS: Final = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) / 2.0

_TRIANGLES: Final = (
    *(0, 3, 1, 0, 2, 3, 4, 7, 6, 4, 5, 7, 0, 5, 4, 0, 1, 5),
    *(2, 7, 3, 2, 6, 7, 0, 6, 2, 0, 4, 6, 1, 7, 5, 1, 3, 7),
)
"""Faces over `_CORNERS`, clockwise from outside: Unity's front."""


def box_asset(name: str, size: Point3, *, mass: float, fixed: bool) -> Json:
    """Return the argument ``asset`` of ``CreateRuntimeAsset``: a box around the origin, its collider the same.

    Parameters
    ----------
    name : str
        Its asset id.
    size : (x, y, z)
        In the floor's frame, metres.
    mass : float
        Kilograms.
    fixed : bool
        Neither falls nor is pushed.
    """
    points = _CORNERS * np.array(size)
    vertices = [thor_point(x, y, z, _DIGITS) for x, y, z in points.tolist()]
    outward = points / np.linalg.norm(points, axis=1, keepdims=True)
    triangles = list(_TRIANGLES)
    return {
        "name": name,
        "vertices": vertices,
        "normals": [thor_point(x, y, z, _DIGITS) for x, y, z in outward.tolist()],
        "triangles": triangles,
        "uvs": [{"x": 0.0, "y": 0.0} for _ in vertices],
        "colliders": [{"vertices": vertices, "triangles": triangles}],
        "physicalProperties": {
            "mass": round(mass, 5),
            "drag": 0.0,
            "angularDrag": 0.05,
            "useGravity": not fixed,
            "isKinematic": fixed,
        },
        "annotations": {
            "objectType": "Undefined",
            "primaryProperty": "Static" if fixed else "CanPickup",
            "secondaryProperties": [],
        },
        "receptacleCandidate": False,
    }


def box_node(room: Json, name: str, center: Point3, size: Point3, rotation: float, *, fixed: bool) -> Json:
    """Return the object that places the runtime asset `name` in a room of a house.

    Parameters
    ----------
    room : dict
        An entry of the house's ``rooms``.
    name : str
        Asset id, and id of the object.
    center, size : (x, y, z)
        In the floor's frame, metres.
    rotation : float
        Degrees counter-clockwise about z.
    fixed : bool
    """
    return {
        "id": name,
        "assetId": name,
        "position": thor_point(*center, _DIGITS),
        "rotation": thor_euler(rotation),
        "size": thor_point(*size, _DIGITS),
        "kinematic": fixed,
        "roomId": room["id"],
        "layer": room["layer"],
        "children": [],
    }


def empty_house() -> Json:
    """Return a house of one empty room around the origin; the agent stands in a corner."""
    side = HALF_ROOM
    ring: list[Point] = [(-side, -side), (side, -side), (side, side), (-side, side)]
    walls = [
        Wall(
            id=f"wall_{number}",
            segment=(ring[number], ring[(number + 1) % 4]),
            thickness=0.1,
            height=3.0,
            exterior=True,
            left=_ROOM,
        )
        for number in range(4)
    ]
    room = SceneRoom(
        id=_ROOM, room_type="living_room", kind="main", polygon=ring, net_polygon=ring, area=4 * side * side
    )
    return house(
        FloorScene(
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
            spawn=SpawnPose(x=1.0 - side, y=1.0 - side, yaw=90.0, room=_ROOM),
        )
    )
