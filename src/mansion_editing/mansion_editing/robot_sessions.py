"""What robots' sessions rely on in a building, and an edit must not change."""

import math
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from mansion_msgs_py.codec import decode
from mansion_msgs_py.editing.changes import ObjectChange
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.world import ObjectState, WorldState

__all__ = ["refuse_in_session", "refuse_robots"]


def refuse_in_session(folder: Path, changes: Iterable[ObjectChange], scenes: Mapping[int, FloorScene]) -> None:
    """Refuse changes of what a session has in its overlay.

    Parameters
    ----------
    scenes : mapping
        The floors before the changes.

    Raises
    ------
    MansionError
        ``CONFLICT`` naming the object and the session.

    Notes
    -----
    An object that a robot moved, holds or switched is the session's; what is put on a receptacle concerns the
    session only when the receptacle is no longer where the scene has it.
    """
    overlays = _overlays(folder)
    if not overlays:
        return
    where = {item.id: (floor, item) for floor, s in scenes.items() for item in s.objects}
    for change in changes:
        for session, touched in overlays.items():
            if change.id in touched:
                raise _conflict(change.id, session)
            for parent in {item.parent for item in (change.before, change.after) if item}:
                state = touched.get(parent or "")
                if state is not None and _moved(state, where.get(parent or "")):
                    raise _conflict(str(parent), session)


def refuse_robots(folder: Path, floor: int) -> None:
    """Refuse to replace a floor on which a session's robot is.

    Raises
    ------
    MansionError
        ``CONFLICT`` naming the session.
    """
    for session, world in _worlds(folder):
        if world.robot.floor == floor:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"the robot of the session {session!r} is on floor {floor}; reset the building in that session, or "
                "remove its folder below `state`, first",
                details={"floor": floor, "session": session},
            )


def _worlds(folder: Path) -> Iterator[tuple[str, WorldState]]:
    """Yield the saved world of each session."""
    for file in sorted(folder.glob("state/*/world.json")):
        try:
            world = decode(WorldState, file.read_bytes())
        except FileNotFoundError:
            continue
        except MansionError as error:
            raise MansionError(
                ErrorCode.CONFLICT, f"{file} cannot be read ({error.info.message}); remove it to edit the building"
            ) from None
        yield world.session or file.parent.name, world


def _overlays(folder: Path) -> dict[str, dict[str, ObjectState]]:
    out = {}
    for session, world in _worlds(folder):
        touched = {state.id: state for state in world.objects}
        if world.robot.held is not None:
            held = world.robot.held
            touched.setdefault(held, ObjectState(id=held, held_by=world.session))
        out[session] = touched
    return out


def _moved(state: ObjectState, there: tuple[int, SceneObject] | None) -> bool:
    if there is None or state.held_by is not None:
        return True
    if state.position is None:
        return False
    floor, item = there
    return state.floor != floor or math.dist(state.position, item.position) > 1e-3


def _conflict(object_id: str, session: str) -> MansionError:
    return MansionError(
        ErrorCode.CONFLICT,
        f"{object_id} is in use by the running session {session!r}; reset the building in that session, "
        "or remove its folder below `state`, first",
        details={"object": object_id, "session": session},
    )
