"""The house JSON of each floor, as the world is now.

Step 1 of the UseElevator card: what the robot holds leaves the house of one floor and enters that of another.
"""

import json
from math import cos, radians, sin
from typing import Any, TypeAlias

from mansion_geometry.thor.house_format import AGENT_HEIGHT, object_nodes, thor_euler, thor_heading, thor_point, upright
from mansion_msgs_py.shapes import Point3
from mansion_msgs_py.world import ObjectState, Pose2D
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.floor_exports import HOUSE, exported, made
from mansion_skills.world.objects import placed_at
from mansion_skills.world.world import World

__all__ = ["Houses"]

Json: TypeAlias = dict[str, Any]

HAND_AHEAD, HAND_HEIGHT = 0.45, 1.1
"""Where what is held enters a floor's house, to be picked up there; metres from the agent's axis and above ground."""


class Houses:
    """The houses of a building, exported or made here, and the objects that AI2-THOR has assets for.

    Parameters
    ----------
    building : LoadedBuilding

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when a floor has no ``house.json`` and none can be made here.
    """

    def __init__(self, building: LoadedBuilding) -> None:
        self._houses = {floor: _read(building, floor) for floor in building.floors}
        self._nodes: dict[str, Json] = {}
        for house in self._houses.values():
            for node in object_nodes(house["objects"]):
                self._nodes[node["id"]] = node

    def __contains__(self, name: str) -> bool:
        return name in self._nodes

    def arranged(self, world: World, floor: int, pose: Pose2D, carried: str | None = None) -> Json:
        """Return a floor's house with the objects and doors of this moment.

        Parameters
        ----------
        world : World
        floor : int
        pose : Pose2D
            Where the agent will stand.
        carried : str, optional
            What its hand brings along; it is put at the hand's height before the pose, to be picked up there.

        Returns
        -------
        dict
            A new house; the exported one is not changed.
        """
        base = self._houses[floor]
        layers = {room["id"]: room.get("layer") for room in base["rooms"]}
        made: dict[str, Json] = {}
        roots: list[Json] = []
        states = world.objects.on_floor(floor)
        if carried is not None:
            states = [*states, *_in_hand(world, floor, pose, carried)]
        by_id = {state.id: state for state in states}
        for state in states:
            self._add(state, by_id, made, roots, layers)
        metadata = {**base["metadata"], "agent": {**base["metadata"]["agent"], **_agent(pose)}}
        doors = [_door(door, world.doors.get(door["id"])) for door in base["doors"]]
        return {**base, "objects": roots, "doors": doors, "metadata": metadata}

    def _add(
        self,
        state: ObjectState,
        states: dict[str, ObjectState],
        made: dict[str, Json],
        roots: list[Json],
        layers: dict[str, Any],
    ) -> Json | None:
        """Add an object after what carries it; ``None`` for what AI2-THOR lacks and what would then hang in the air."""
        if state.id in made:
            return made[state.id]
        node = self._nodes.get(state.id)
        if node is None or state.position is None:
            return None
        siblings = roots
        if state.parent is not None:
            carrier = self._add(states[state.parent], states, made, roots, layers)
            if carrier is None:
                return None
            siblings = carrier["children"]
        made[state.id] = _placed(node, state, layers)
        siblings.append(made[state.id])
        return made[state.id]


def _read(building: LoadedBuilding, floor: int) -> Json:
    file = exported(building, floor, HOUSE)
    if file is None:
        (data,) = made(building, floor, HOUSE).values()
    else:
        data = file.read_bytes()
    house: Json = json.loads(data)
    return house


def _placed(node: Json, state: ObjectState, layers: dict[str, Any]) -> Json:
    """Return an object's node where its state says."""
    assert state.position is not None
    made = {
        **node,
        "position": thor_point(*state.position),
        "rotation": thor_euler(state.rotation),
        "roomId": state.room or node.get("roomId"),
        "children": [],
    }
    layer = layers.get(state.room or "")
    if layer is not None:
        made["layer"] = layer
    if "open" in state.states:
        made["openness"] = float(bool(state.states["open"]))
    if "on" in state.states:
        made["isOn"] = bool(state.states["on"])
    return made


def _in_hand(world: World, floor: int, pose: Pose2D, carried: str) -> list[ObjectState]:
    """Return what is held, with what it carries, as if it hung before the agent."""
    room = world.view(floor).map.room_at(pose.x, pose.y)
    yaw = radians(pose.yaw)
    place = (round(pose.x + HAND_AHEAD * cos(yaw), 4), round(pose.y + HAND_AHEAD * sin(yaw), 4), HAND_HEIGHT)
    return placed_at(
        world.objects,
        world.objects.state(carried),
        floor=floor,
        room=room,
        position=place,
        rotation=round((pose.yaw - 90.0) % 360.0, 6),
    )


def _agent(pose: Pose2D) -> Json:
    place: Point3 = (pose.x, pose.y, AGENT_HEIGHT)
    return {"position": thor_point(*place), "rotation": upright(thor_heading(pose.yaw))}


def _door(door: Json, is_open: bool | None) -> Json:
    return door if is_open is None else {**door, "openness": float(is_open)}
