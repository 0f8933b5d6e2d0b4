"""Names of rooms that users may say: their own words, and what the type is called."""

from mansion_planner.program.model import PlannedRoom

__all__ = ["aliases_of"]


def aliases_of(room: PlannedRoom) -> list[str]:
    """Return the names of a room beside its label: its type where the user calls it otherwise."""
    if not room.label:
        return []
    plain = room.label.lower()
    names = [room.base.replace("_", " "), room.kind.name.replace("_", " ")]
    return list(dict.fromkeys(name for name in names if name != plain))
