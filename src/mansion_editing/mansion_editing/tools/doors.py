"""SetState of doors: open or closed in the initial state of a floor."""

import msgspec

from mansion_editing.state import SceneState
from mansion_geometry.doorways import LEAFLESS
from mansion_msgs_py.editing.objects import SetStateArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene

__all__ = ["door_swung"]


def door_swung(state: SceneState, args: SetStateArgs) -> tuple[int, FloorScene] | None:
    """Return the floor of a door, by its id, with its scene as it is once the door is open or closed; else None.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without `open`, ``INFEASIBLE`` for what has no leaf and for a lift's door.
    """
    for floor in state.floors:
        scene = state.scenes[floor]
        at = next((number for number, door in enumerate(scene.doors) if door.id == args.object_id), None)
        if at is None:
            continue
        door = scene.doors[at]
        if args.open is None or args.on is not None:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, "a door is open or closed: give open", path="$.open")
        if door.kind in LEAFLESS:
            raise MansionError(ErrorCode.INFEASIBLE, f"{door.id} has no leaf to open or close", path="$.open")
        if door.kind == "sliding":
            raise MansionError(ErrorCode.INFEASIBLE, f"{door.id} is a lift's door, which the lift opens", path="$.open")
        doors = [*scene.doors[:at], msgspec.structs.replace(door, is_open=args.open), *scene.doors[at + 1 :]]
        return floor, msgspec.structs.replace(scene, doors=doors)
    return None
