"""Put a world back to where its sessions left it."""

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import WorldState
from mansion_skills.world.overlay import world_overlays
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["restore_robot", "restore_shared"]


def restore_shared(world: World) -> list[str]:
    """Restore objects, doors, lifts and time from the newest overlay of the world's sessions.

    Returns
    -------
    list of str
        What was left out, because the scenes have changed since.

    Raises
    ------
    MansionError
        ``CONFLICT`` when an overlay rests on another building.
    """
    saved = world_overlays(world.building.path, world.name)
    for state in saved:
        _check_building(world, state)
    world.absent = {state.session for state in saved} - set(world.robots)
    newest = max(saved, key=lambda state: state.step, default=None)
    if newest is None:
        return []
    world.time, world.step = newest.time, newest.step
    doors = {door.id for floor in world.building.floors for door in world.building.scene(floor).doors}
    gone = [name for name in newest.doors if name not in doors]
    world.doors = {name: is_open for name, is_open in newest.doors.items() if name in doors}
    known = [state for state in newest.objects if state.id in world.objects]
    gone += [state.id for state in newest.objects if state.id not in world.objects]
    for thing in known:
        if thing.parent is not None and thing.parent not in world.objects:
            gone.append(thing.id)
        else:
            world.objects.put(thing)
    world.objects.commit()
    for entry in newest.lifts:
        if entry.lift_name in world.lifts:
            world.lifts[entry.lift_name].restore(entry, newest.queues.get(entry.lift_name, []))
    world.reload()
    return [f"{name} is no longer in the building; its state is dropped" for name in gone]


def restore_robot(world: World, saved: WorldState, robot: RobotBody) -> None:
    """Put a robot where its overlay says."""
    if saved.robot.floor not in world.building.floors:
        return
    robot.floor, robot.pose, robot.pitch = saved.robot.floor, saved.robot.pose, saved.robot.pitch
    for name, floor in saved.calls.items():
        if name in world.lifts and floor == robot.floor:
            robot.call = name


def _check_building(world: World, saved: WorldState) -> None:
    building = world.building
    older = [floor for floor in building.floors if building.scene(floor).revision < saved.revisions.get(str(floor), 0)]
    if saved.building_id != building.building_id or older:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"session {saved.session!r} was left in another state of the building (id "
            f"{saved.building_id!r}); load with reset, or remove {building.path / 'state'}",
            path="$.path",
            details={"session": saved.session, "floors": older},
        )
