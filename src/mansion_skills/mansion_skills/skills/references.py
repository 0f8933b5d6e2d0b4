"""Resolve the name that a caller uses to an object or a door."""

from mansion_msgs_py.scene import Door
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import ObjectState
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["door_named", "object_named"]


def object_named(world: World, robot: RobotBody, name: object) -> ObjectState | str:
    """Return the object of that id, or the one on this floor whose id ends so; else what is wrong.

    What the robot holds counts as being on its floor.
    """
    if not isinstance(name, str) or not name.strip():
        return f"{name!r} is not the id of an object"
    wanted = name.strip()
    if wanted in world.objects:
        return world.objects.state(wanted)
    here = world.objects.on_floor(robot.floor)
    held = world.objects.held_by(robot.session)
    found = [state for state in here if state.id.endswith(f"/{wanted}")]
    if held is not None and held.endswith(f"/{wanted}"):
        found.append(world.objects.state(held))
    if len(found) == 1:
        return found[0]
    if not found:
        near = choices(wanted, (state.id for state in here), f"objects of floor {robot.floor}")
        return f"there is no object {wanted[:80]!r}; {near}"
    known = ", ".join(state.id for state in found[:5])
    return f"{len(found)} objects are called {wanted!r}: {known}"


def door_named(world: World, robot: RobotBody, name: object) -> Door | str:
    """Return the door of that id on the robot's floor, or what is wrong."""
    doors = world.view(robot.floor).doors
    if isinstance(name, str):
        for wanted in (name.strip(), f"F{robot.floor}/{name.strip()}"):
            if wanted in doors:
                return doors[wanted]
    return f"floor {robot.floor} has no door {str(name)[:80]!r}; {choices(name, doors, 'doors')}"
