"""Rooms that are there to walk through."""

from mansion_knowledge import default_knowledge, is_class
from mansion_msgs_py.scene import SceneRoom

__all__ = ["is_circulation"]


def is_circulation(room: SceneRoom) -> bool:
    """Whether a room is there to walk through, so that it keeps its width and its place."""
    return is_class(room.room_type, "circulation") or default_knowledge().room(room.room_type).zone == "circulation"
