"""A storey of a given plan as the planner's storey, so that a description may ask for furniture in its rooms."""

from dataclasses import replace

from mansion_knowledge import BuildingType
from mansion_planner.given_plan.floors import GivenFloor
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["planned_storey"]


def planned_storey(floor: GivenFloor, use: BuildingType) -> Storey:
    """Return a storey with its rooms as planned rooms, its main room as the hub."""
    rooms = [
        PlannedRoom(
            id=room.id, kind=room.type, area=room.area, least=room.area, most=room.area, stated=True,
            base=_base(room.id), label=room.name,
        )
        for room in floor.storey.rooms
        if not room.core and room is not floor.main
    ]  # fmt: skip
    hub = replace(floor.main.type, name=floor.main.id)
    return Storey(index=floor.storey.index, role="single", use=use, hub=hub, rooms=tuple(rooms))


def _base(name: str) -> str:
    stem, _, number = name.rpartition("_")
    return stem if stem and number.isdigit() else name
