"""``DIR/state/SESSION/world.json``: a session's world across restarts, written and restored."""

import re
import shutil
from pathlib import Path

from mansion_msgs_py.building_folder import file_in
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import remove_remains, write_atomic
from mansion_msgs_py.world import WorldState
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = [
    "DEFAULT_SESSION",
    "check_session",
    "forget_overlay",
    "load_overlay",
    "overlay_path",
    "remove_overlay_remains",
    "restore_robot",
    "restore_shared",
    "save_overlay",
    "world_overlays",
]

DEFAULT_SESSION = "default"
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}")


def check_session(session: str) -> str:
    """Return the name of a session, ``default`` for an empty one.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a name that can be no folder's or no ROS namespace's.
    """
    name = session or DEFAULT_SESSION
    if not _NAME.fullmatch(name):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"session {name!r}: use a letter, then letters, digits and '_', 64 at most",
            path="$.session",
        )
    return name


def overlay_path(building: Path, session: str) -> Path:
    """Return where a session's overlay lives (see `check_session`)."""
    return file_in(building, f"state/{check_session(session)}/world.json")


def save_overlay(path: Path, state: WorldState, *, durable: bool = True) -> None:
    """Write the overlay atomically: a crash leaves the former one.

    Parameters
    ----------
    path : Path
    state : WorldState
    durable : bool
        Sync to the disk first, so that it also outlives a loss of power; a killed process loses nothing either way.
    """
    write_atomic(path, encode_bytes(state), durable=durable, mode=0o600)


def load_overlay(path: Path) -> WorldState | None:
    """Return the overlay of a former run, or ``None``."""
    try:
        return decode(WorldState, path.read_bytes())
    except FileNotFoundError:
        return None


def world_overlays(building: Path, world: str) -> list[WorldState]:
    """Return the overlays of all sessions that share a world, in the order of their names."""
    found = []
    for path in sorted((building / "state").glob("*/world.json")):
        state = load_overlay(path)
        if state is not None and state.world == world:
            found.append(state)
    return found


def remove_overlay_remains(building: Path, session: str) -> None:
    """Remove what killed processes left beside a session's overlay."""
    remove_remains(overlay_path(building, session).parent)


def forget_overlay(path: Path) -> None:
    """Remove a session's overlay."""
    shutil.rmtree(path.parent, ignore_errors=True)


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
    for item in known:
        if item.parent is not None and item.parent not in world.objects:
            gone.append(item.id)
        else:
            world.objects.put(item)
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
