"""Each desk, every office, all floors: one place for each of them."""

from dataclasses import replace

from mansion_editing.agent.facts import Scope
from mansion_editing.references import matching_objects
from mansion_editing.state import SceneState
from mansion_editing.vocabulary import colour_of
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["distributed"]


def distributed(state: SceneState, where: Scope, each: str) -> list[Scope]:
    """Return the places that a scope stands for.

    Parameters
    ----------
    each : {"", "receptacle", "room", "floor"}
        What of it is meant each for itself.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when there is none.
    """
    if each == "receptacle" and where.receptacle:
        found = [
            Scope(where.relation, item.id, (item.room,), floor, where.colour)
            for floor, item in matching_objects(state, where.receptacle, list(where.rooms) or None, where.floor)
            if where.colour in ("", colour_of(item.material))
        ]
    elif each == "room":
        found = [replace(where, rooms=(room,)) for room in where.rooms]
    elif each == "floor":
        found = [replace(where, floor=floor, rooms=_on(where.rooms, floor)) for floor in state.floors]
        found = [scope for scope in found if scope.rooms or not where.rooms]
    else:
        return [where]
    if not found:
        place = replace(where, receptacle="", colour="")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {where.receptacle or 'room'} {place}")
    return found


def _on(rooms: tuple[str, ...], floor: int) -> tuple[str, ...]:
    return tuple(room for room in rooms if room.startswith(f"F{floor}/"))
