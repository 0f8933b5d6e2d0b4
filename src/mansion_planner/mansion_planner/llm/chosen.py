"""What a floor is to hold: the model's rooms after reading, or the offline planner's."""

from dataclasses import dataclass

from mansion_knowledge import RoomType
from mansion_planner.program.model import Storey

__all__ = ["ChosenFloor", "ChosenRoom", "chosen_of_storey"]


@dataclass(frozen=True)
class ChosenRoom:
    """A room of a floor's program.

    Attributes
    ----------
    fixed : bool
        The brief states its area.
    suite_of : str
        Id of the room that it is reached through; empty for one at the hub or a corridor.
    """

    id: str
    kind: RoomType
    area: float
    fixed: bool = False
    suite_of: str = ""
    floor_material: str = ""
    wall_material: str = ""
    notes: str = ""


@dataclass(frozen=True)
class ChosenFloor:
    """A floor's hub and rooms; `copy` names the floor that it repeats."""

    index: int
    hub: ChosenRoom
    rooms: tuple[ChosenRoom, ...]
    requirement: str = ""
    copy: int | None = None


def chosen_of_storey(storey: Storey, hub_area: float) -> ChosenFloor:
    """Return what the offline planner chose for a storey."""
    rooms = []
    for top in storey.rooms:
        for room in top.each():
            owner = next((r.id for r in top.each() if any(c is room for c in r.suite)), "")
            rooms.append(ChosenRoom(room.id, room.kind, room.area, room.fixed, owner, notes=room.notes))
    hub = ChosenRoom(storey.hub.name, storey.hub, hub_area)
    return ChosenFloor(storey.index, hub, tuple(rooms), copy=storey.copy)
