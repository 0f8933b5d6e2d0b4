"""Checks that this is the building asked for: floors, areas, footprint, rooms, copies."""

from collections.abc import Iterator, Sequence

from shapely import Polygon

from mansion_bringup.check.fault import Fault
from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.wishes import AREA_TOLERANCE
from mansion_msgs_py.wording import counted

__all__ = ["check_request"]


FOOTPRINT_TOLERANCE = 1e-3


def check_request(building: Building, layouts: Sequence[FloorLayout], scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield what differs between the request, the program and the floors."""
    yield from _numbers(building, scenes)
    yield from _footprint(building, scenes)
    yield from _rooms(building, scenes)
    yield from _copies(building, layouts)


def _numbers(building: Building, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    request = building.request
    above = [scene for scene in scenes if scene.floor >= 1]
    if request.floors is not None and len(above) != request.floors:
        yield Fault("FLOOR_COUNT", "building", f"{counted(len(above), 'floor')}, asked for {request.floors}")
    numbers = [scene.floor for scene in scenes]
    if numbers != [floor.index for floor in building.program.floors]:
        yield Fault("FLOOR_COUNT", "building", f"floors {numbers} are not those of the program")
    if any(scene.floors != len(scenes) for scene in scenes):
        yield Fault("FLOOR_COUNT", "building", "a scene states another number of floors")
    areas = {scene.floor: Polygon(scene.outline, scene.holes).area for scene in scenes}
    total = sum(areas.values())
    downgraded = any("area" in wish.wish for wish in building.program.downgrades)
    if request.footprint is not None or downgraded:
        return
    if request.area is not None and abs(total - request.area) > AREA_TOLERANCE * request.area:
        yield Fault("AREA", "building", f"{total:.0f} m2, asked for {request.area:.0f}")
    if request.floor_area is not None:
        mean = total / max(1, len(areas))
        if abs(mean - request.floor_area) > AREA_TOLERANCE * request.floor_area:
            yield Fault("AREA", "building", f"{mean:.0f} m2 a floor, asked {request.floor_area:.0f}")


def _footprint(building: Building, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    footprint = building.request.footprint
    if footprint is None:
        return
    asked = Polygon(footprint.boundary, footprint.holes).buffer(0)
    for scene in scenes:
        outline = Polygon(scene.outline, scene.holes)
        if outline.difference(asked).area > FOOTPRINT_TOLERANCE * asked.area:
            yield Fault("FOOTPRINT", f"floor {scene.floor}", "goes beyond the footprint asked for")


def _rooms(building: Building, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    for floor, scene in zip(building.program.floors, scenes):
        there = {room.id for room in scene.rooms}
        for room in floor.rooms:
            name = f"F{scene.floor}/{room.id}"
            if name not in there:
                yield Fault("ROOM_MISSING", name, "is in the program but not on the floor")
        fitted = sum(room.area_estimate for room in floor.rooms) <= floor.gross_floor_area
        if not fitted or not floor.area_summary.fits_within_gfa:
            yield Fault("AREA", f"floor {scene.floor}", "rooms exceed the gross floor area")


def _copies(building: Building, layouts: Sequence[FloorLayout]) -> Iterator[Fault]:
    by_floor = {layout.floor: layout for layout in layouts}
    for floor in building.program.floors:
        if floor.copy is None:
            continue
        if floor.copy not in by_floor:
            yield Fault("COPY", f"floor {floor.index}", f"copies floor {floor.copy}, which does not exist")
        elif by_floor[floor.index].rooms != by_floor[floor.copy].rooms:
            yield Fault("COPY", f"floor {floor.index}", f"differs from floor {floor.copy}")
