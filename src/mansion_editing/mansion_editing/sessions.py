"""What running robots have touched: the overlays ``DIR/state/SESSION/world.json``."""

import math
from collections.abc import Iterable, Mapping
from pathlib import Path

from mansion_msgs_py.codec import decode
from mansion_msgs_py.editing import ObjectChange
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.world import ObjectState, WorldState

__all__ = ["refuse_touched"]


def refuse_touched(folder: Path, changes: Iterable[ObjectChange], scenes: Mapping[int, FloorScene]) -> None:
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


def _overlays(folder: Path) -> dict[str, dict[str, ObjectState]]:
    out = {}
    for file in sorted(folder.glob("state/*/world.json")):
        try:
            world = decode(WorldState, file.read_bytes())
        except FileNotFoundError:
            continue
        except MansionError as error:
            raise MansionError(
                ErrorCode.CONFLICT, f"{file} cannot be read ({error.info.message}); remove it to edit the building"
            ) from None
        touched = {state.id: state for state in world.objects}
        if world.robot.held is not None:
            held = world.robot.held
            touched.setdefault(held, ObjectState(id=held, held_by=world.session))
        out[world.session or file.parent.name] = touched
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
        f"{object_id} is in the hands of the running session {session!r}; load the building anew in that session "
        "(reset) or remove its folder below `state` first",
        details={"object": object_id, "session": session},
    )
