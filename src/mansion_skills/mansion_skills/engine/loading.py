"""Open a building's world for a session, where a former run left it."""

from pathlib import Path

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills.building import LoadedBuilding
from mansion_skills.engine.seat import SharedWorld
from mansion_skills.world.overlay import forget_overlay, load_overlay, overlay_path, world_overlays
from mansion_skills.world.restore import restore_robot, restore_shared
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["forget_world", "open_world", "seat_robot"]


def open_world(path: Path, name: str, radius: float) -> tuple[SharedWorld, list[str]]:
    """Read a building and restore its world; also return what could not be restored."""
    world = World(LoadedBuilding(path), name, radius)
    notes = restore_shared(world)
    return SharedWorld(world), notes


def seat_robot(world: World, session: str) -> RobotBody:
    """Put a session's robot into a world, where its overlay says."""
    robot = world.add_robot(session)
    saved = load_overlay(overlay_path(world.building.path, session))
    if saved is not None and saved.world == world.name:
        restore_robot(world, saved, robot)
    return robot


def forget_world(path: Path, name: str, session: str, others: list[str]) -> None:
    """Remove the overlays of all sessions of a world.

    Raises
    ------
    MansionError
        ``CONFLICT`` while other sessions are in it.
    """
    if others:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"sessions {', '.join(others)} are in the world {name!r} too; load a world of another name",
            path="$.reset",
        )
    for file in sorted((path / "state").glob("*/world.json")):
        try:
            shared = any(state.session == file.parent.name for state in world_overlays(path, name))
        except MansionError:
            shared = file.parent.name == session
        if shared or file.parent.name == session:
            forget_overlay(file)
