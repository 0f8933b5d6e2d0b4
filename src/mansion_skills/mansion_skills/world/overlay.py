"""``DIR/state/SESSION/world.json``: a session's world across restarts of the server."""

import os
import re
import tempfile
from pathlib import Path

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import WorldState

__all__ = ["load_overlay", "overlay_path", "save_overlay"]

DEFAULT_SESSION = "default"
_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,63}")


def overlay_path(building: Path, session: str) -> Path:
    """Return where a session's overlay lives.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a session name that cannot be a folder's.
    """
    if not _NAME.fullmatch(session):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"session {session!r}: use letters, digits, '_', '-' and '.', 64 at most",
            path="$.session",
        )
    return building / "state" / session / "world.json"


def save_overlay(path: Path, state: WorldState) -> None:
    """Write the overlay whole, or leave the former one: synced to disk before it takes the name."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=".world.", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(encode_bytes(state))
            stream.flush()
            os.fsync(stream.fileno())
        Path(name).replace(path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def load_overlay(path: Path) -> WorldState | None:
    """Return the overlay of a former run, or ``None``."""
    try:
        return decode(WorldState, path.read_bytes())
    except FileNotFoundError:
        return None
