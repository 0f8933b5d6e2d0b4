"""``DIR/state/SESSION/world.json``: a session's world across restarts of the server."""

import re
import shutil
from pathlib import Path

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.world import WorldState

__all__ = [
    "DEFAULT_SESSION",
    "check_session",
    "forget_overlay",
    "load_overlay",
    "overlay_path",
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
    return building / "state" / check_session(session) / "world.json"


def save_overlay(path: Path, state: WorldState, *, durable: bool = True) -> None:
    """Write the overlay whole, or leave the former one: complete before it takes the name.

    Parameters
    ----------
    path : Path
    state : WorldState
    durable : bool
        Sync to the disk first, so that it also outlives a loss of power; a killed process loses nothing either way.
    """
    write_atomic(path, encode_bytes(state), durable=durable, mode=0o600)


def load_overlay(path: Path) -> WorldState | None:
    """Return the overlay of a former run, or ``None``; remains of an interrupted write are removed."""
    for remains in sorted(path.parent.glob(".world.*")):
        remains.unlink(missing_ok=True)
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


def forget_overlay(path: Path) -> None:
    """Remove a session's overlay."""
    shutil.rmtree(path.parent, ignore_errors=True)
