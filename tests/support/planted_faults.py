"""Faults to plant in the files of a sound building, each with the kind by which the check must find it."""

import itertools
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from shapely import Polygon

__all__ = ["PLANTED", "Json", "Plant", "change", "plant_in", "standing"]

Json = dict[str, Any]
Plant = Callable[[Json], None]


def change(file: Path, edit: Plant) -> None:
    """Edit the JSON of a file."""
    value = json.loads(file.read_text(encoding="utf-8"))
    edit(value)
    file.write_text(json.dumps(value), encoding="utf-8")


def plant_in(building: Path, plant: Plant) -> None:
    """Plant a fault in a building: in ``building.json`` or in a storey, whichever it is for."""
    change(building / ("building.json" if plant in OF_THE_INDEX else SCENE), plant)


SCENE: Final = "floors/floor_2/scene.json"
"""The storey that gets faults; it has another above or below it."""


def standing(value: Json) -> Json:
    """A thing on the floor of a room that is no passage, and that carries nothing."""
    carriers = {thing.get("parent") for thing in value["objects"]}
    ends = {room["id"] for room in value["rooms"] if "corridor" not in room["id"]}
    ends -= {room["id"] for room in value["rooms"] if room["kind"] == "main"}
    return next(
        thing
        for thing in value["objects"]
        if thing.get("mount", "floor") == "floor"
        and thing["size"][2] > 0.4
        and thing["id"] not in carriers
        and thing["room"] in ends
    )


def first_door(value: Json) -> Json:
    return next(door for door in value["doors"] if door["kind"] in ("single", "glazed", "doorway"))


def move(thing: Json, dx: float, dy: float, dz: float = 0.0) -> None:
    x, y, z = thing["position"]
    thing["position"] = [x + dx, y + dy, z + dz]


def outside(value: Json) -> None:
    move(standing(value), 400.0, 0.0)


def floating(value: Json) -> None:
    move(standing(value), 0.0, 0.0, 0.5)


def doubled_id(value: Json) -> None:
    value["objects"][1]["id"] = value["objects"][0]["id"]


def foreign_id(value: Json) -> None:
    value["walls"][0]["id"] = "wall_without_floor"


def overlapping(value: Json) -> None:
    one = standing(value)
    other = dict(one, id=one["id"] + "_again")
    value["objects"].append(other)


def blocked_door(value: Json) -> None:
    thing, door = standing(value), first_door(value)
    (x0, y0), (x1, y1) = door["segment"]
    thing["position"] = [(x0 + x1) / 2, (y0 + y1) / 2, thing["position"][2]]
    thing["room"] = door["rooms"][0]


def lost_parent(value: Json) -> None:
    small = next(thing for thing in value["objects"] if thing.get("parent"))
    small["parent"] = "F2/nowhere/table_1"


def off_the_table(value: Json) -> None:
    small = next(thing for thing in value["objects"] if thing.get("mount") == "surface")
    move(small, 0.0, 0.0, 0.4)


def door_off_its_wall(value: Json) -> None:
    door = first_door(value)
    door["segment"] = [[x + 0.7, y + 0.7] for x, y in door["segment"]]


def narrow_door(value: Json) -> None:
    door = first_door(value)
    (x0, y0), (x1, y1) = door["segment"]
    door["segment"] = [[x0, y0], [(x0 + x1) / 2, (y0 + y1) / 2]]
    door["width"] = math.dist(*door["segment"])


def missing_door(value: Json) -> None:
    value["doors"].remove(first_door(value))


def window_inside(value: Json) -> None:
    inner = next(wall for wall in value["walls"] if not wall.get("exterior"))
    value["windows"][0]["wall"] = inner["id"]


def shifted_core(value: Json) -> None:
    core = value["cores"][0]
    core["polygon"] = [[x + 0.5, y] for x, y in core["polygon"]]


def core_without_door(value: Json) -> None:
    value["cores"][0]["door"] = "F2/door_none"


def steep_stair(value: Json) -> None:
    stair = next(core for core in value["cores"] if core["type"] == "stair")
    stair["details"]["riser"] = 0.24


def missing_room(value: Json) -> None:
    asked = (room for room in value["rooms"] if room["kind"] == "Entities" and "corridor" not in room["id"])
    value["rooms"].remove(next(asked))


def swollen(room: Json) -> list[list[float]]:
    """The outline of a room with its right side a metre further out."""
    right = max(x for x, _ in room["polygon"])
    return [[x + 1.0 if x == right else x, y] for x, y in room["polygon"]]


def swollen_room(value: Json) -> None:
    room, polygon = next(
        (room, swollen(room))
        for room, other in itertools.permutations(value["rooms"], 2)
        if room["kind"] == "Entities" and Polygon(swollen(room)).intersection(Polygon(other["polygon"])).area > 0.5
    )
    room["polygon"] = polygon


def gap_in_walls(value: Json) -> None:
    longest = max(value["walls"], key=lambda wall: math.dist(*wall["segment"]))
    value["walls"].remove(longest)


def buried_spawn(value: Json) -> None:
    value["spawn"].update(x=-50.0, y=-50.0)


def wrong_elevation(value: Json) -> None:
    value["elevation"] += 1.0


def other_building(value: Json) -> None:
    value["building_id"] = "somebody-elses"


def stair(value: Json) -> Json:
    return next(core["details"] for core in value["cores"] if core["type"] == "stair")


def lift(value: Json) -> Json:
    return next(core["details"] for core in value["cores"] if core["type"] == "elevator")


def removed_tread(value: Json) -> None:
    del stair(value)["treads"][3]


def removed_flights(value: Json) -> None:
    stair(value).update(treads=[], landings=[])


def narrow_flights(value: Json) -> None:
    for low, high in stair(value)["treads"]:
        across = max((0, 1), key=lambda axis: high[axis] - low[axis])
        high[across] = low[across] + 0.3


def landing_elsewhere(value: Json) -> None:
    for corner in stair(value)["landings"][0]:
        corner[0] += 8.0


def scattered_treads(value: Json) -> None:
    low, high = stair(value)["treads"][2]
    across = max((0, 1), key=lambda axis: high[axis] - low[axis])
    for corner in (low, high):
        corner[across] += 1.2


def no_opening_above(value: Json) -> None:
    stair(value)["ceiling_opening"] = []


def no_opening_below(value: Json) -> None:
    stair(value)["floor_opening"] = []


def closed_shaft(value: Json) -> None:
    lift(value)["ceiling_opening"] = []


def cabin_elsewhere(value: Json) -> None:
    for corner in lift(value)["cabin"]:
        corner[0] += 40.0


def lost_button(value: Json) -> None:
    del lift(value)["buttons"][0]


def sill_below_the_floor(value: Json) -> None:
    value["windows"][0]["sill"] = -0.4


def unknown_asset(value: Json) -> None:
    standing(value)["asset"] = "flying_saucer_1"


def light_elsewhere(value: Json) -> None:
    next(light for light in value["lights"] if light["kind"] != "directional")["position"][0] = 300.0


def room_of_its_own(value: Json) -> Json:
    """Return a room that is neither a core nor the hub."""
    return next(room for room in value["rooms"] if room["kind"] == "Entities")


def misstated_area(value: Json) -> None:
    room_of_its_own(value)["area"] += 5.0


def interior_beyond_the_room(value: Json) -> None:
    room = room_of_its_own(value)
    room["net_polygon"] = [[x + 0.8, y + 0.8] for x, y in room["net_polygon"]]


def room_off_its_storey(value: Json) -> None:
    room = room_of_its_own(value)
    for ring in ("polygon", "net_polygon"):
        room[ring] = [[x + 300.0, y] for x, y in room[ring]]


def doubled_room(value: Json) -> None:
    value["rooms"].append(dict(room_of_its_own(value)))


def light_of_no_room(value: Json) -> None:
    next(light for light in value["lights"] if light.get("room"))["room"] = "F2/nowhere"


def light_above_the_ceiling(value: Json) -> None:
    next(light for light in value["lights"] if light["kind"] != "directional")["position"][2] = 30.0


def door_to_nowhere(value: Json) -> None:
    door = first_door(value)
    door["rooms"] = [door["rooms"][0], "F2/nowhere"]


def door_of_other_rooms(value: Json) -> None:
    far = max(value["rooms"], key=lambda room: math.dist(room["polygon"][0], first_door(value)["segment"][0]))
    door = first_door(value)
    door["rooms"] = [door["rooms"][0], far["id"]]


def misstated_width(value: Json) -> None:
    first_door(value)["width"] += 0.3


def door_in_no_wall(value: Json) -> None:
    first_door(value)["wall"] = "F2/wall_none"


def door_above_its_wall(value: Json) -> None:
    first_door(value)["height"] = 9.0


def window_in_no_wall(value: Json) -> None:
    value["windows"][0]["wall"] = "F2/wall_none"


def window_of_another_room(value: Json) -> None:
    window = value["windows"][0]
    window["room"] = next(room["id"] for room in value["rooms"] if room["id"] != window["room"])


def window_above_its_wall(value: Json) -> None:
    value["windows"][0]["height"] = 9.0


def two_windows_in_one_place(value: Json) -> None:
    value["windows"].append(dict(value["windows"][0], id="F2/window_again"))


def core_off_the_storey(value: Json) -> None:
    core = value["cores"][0]
    core["polygon"] = [[x + 200.0, y] for x, y in core["polygon"]]


def entrance_in_the_shaft(value: Json) -> None:
    core = value["cores"][0]
    middle = Polygon(core["polygon"]).centroid
    core["entrance"][:2] = [middle.x, middle.y]


def core_of_other_storeys(value: Json) -> None:
    value["cores"][0]["floors"] = [1]


def core_of_one_storey_more(value: Json) -> None:
    value["cores"][0]["floors"].append(9)


def low_risers(value: Json) -> None:
    stair(value)["riser"] = 0.1


def short_goings(value: Json) -> None:
    for low, high in stair(value)["treads"]:
        along = min((0, 1), key=lambda axis: high[axis] - low[axis])
        high[along] = low[along] + 0.12


def cabin_larger_than_its_shaft(value: Json) -> None:
    cabin = lift(value)["cabin"]
    for axis in (0, 1):
        middle = sum(corner[axis] for corner in cabin) / len(cabin)
        for corner in cabin:
            corner[axis] = middle + 1.8 * (corner[axis] - middle)


def thing_of_another_room(value: Json) -> None:
    thing = standing(value)
    thing["room"] = next(room["id"] for room in value["rooms"] if room["id"] != thing["room"])


def thing_of_no_room(value: Json) -> None:
    standing(value)["room"] = "F2/nowhere"


def thing_through_the_ceiling(value: Json) -> None:
    thing = standing(value)
    thing["size"][2] += 5.0
    thing["position"][2] += 2.5


def beside_the_table(value: Json) -> None:
    move(next(thing for thing in value["objects"] if thing.get("mount") == "surface"), 1.5, 1.5)


def endless_thing(value: Json) -> None:
    value["objects"] = [dict(standing(value), id=f"F2/thing_{number}") for number in range(20_001)]


def fewer_rooms(index: Json) -> None:
    index["floors"][1]["rooms"] -= 1


def more_objects(index: Json) -> None:
    index["floors"][1]["objects"] += 1


def other_area(index: Json) -> None:
    index["floors"][1]["area"] += 3.0


def other_elevation(index: Json) -> None:
    index["floors"][1]["elevation"] += 1.0


def other_height(index: Json) -> None:
    index["floors"][1]["height"] += 1.0


def other_label(index: Json) -> None:
    index["floors"][1]["label"] = "attic"


def other_sum(index: Json) -> None:
    index["checks"]["objects"] += 1


def more_storeys_than_asked(index: Json) -> None:
    index["request"]["floors"] = 9


def other_area_than_asked(index: Json) -> None:
    index["request"]["floor_area"] = 900.0


def file_that_is_missing(index: Json) -> None:
    index["floors"][1]["files"]["house"] = "floors/floor_2/none.json"


def report_that_is_missing(index: Json) -> None:
    index["files"]["report"] = "none.json"


OF_THE_INDEX: Final = (
    fewer_rooms,
    more_objects,
    other_area,
    other_elevation,
    other_height,
    other_label,
    other_sum,
    more_storeys_than_asked,
    other_area_than_asked,
    file_that_is_missing,
    report_that_is_missing,
)
"""Faults of ``building.json``; the others are of a storey."""

PLANTED: Final[list[tuple[Plant, str]]] = [
    (outside, "OBJECT_OUTSIDE"),
    (floating, "OBJECT_FLOATS"),
    (doubled_id, "ID"),
    (foreign_id, "ID"),
    (overlapping, "OBJECT_OVERLAP"),
    (blocked_door, "DOOR_BLOCKED"),
    (lost_parent, "OBJECT_PARENT"),
    (off_the_table, "OBJECT_FLOATS"),
    (door_off_its_wall, "DOOR_WALL"),
    (narrow_door, "DOOR_NARROW"),
    (missing_door, "DOOR_MISSING"),
    (missing_door, "ROOM_UNREACHABLE"),
    (window_inside, "WINDOW_WALL"),
    (shifted_core, "CORE_SHIFTED"),
    (core_without_door, "CORE_DOOR"),
    (steep_stair, "STAIR_RISER"),
    (missing_room, "ROOM_MISSING"),
    (missing_room, "COVERAGE"),
    (swollen_room, "ROOM_OVERLAP"),
    (gap_in_walls, "WALL_GAP"),
    (buried_spawn, "SPAWN"),
    (wrong_elevation, "ELEVATION"),
    (other_building, "BUILDING_ID"),
    (removed_tread, "STAIR_STEPS"),
    (removed_flights, "STAIR_STEPS"),
    (narrow_flights, "STAIR_NARROW"),
    (landing_elsewhere, "STAIR_OUTSIDE"),
    (scattered_treads, "STAIR_STEPS"),
    (no_opening_above, "CORE_OPENING"),
    (no_opening_below, "CORE_OPENING"),
    (closed_shaft, "CORE_OPENING"),
    (cabin_elsewhere, "LIFT_CABIN"),
    (lost_button, "LIFT_BUTTONS"),
    (sill_below_the_floor, "WINDOW_SILL"),
    (unknown_asset, "OBJECT_ASSET"),
    (light_elsewhere, "LIGHT_OUTSIDE"),
    (misstated_area, "ROOM_AREA"),
    (interior_beyond_the_room, "ROOM_NET"),
    (room_off_its_storey, "ROOM_OUTSIDE"),
    (doubled_room, "ID"),
    (light_of_no_room, "LIGHT_ROOM"),
    (light_above_the_ceiling, "LIGHT_OUTSIDE"),
    (door_to_nowhere, "DOOR_ROOMS"),
    (door_of_other_rooms, "DOOR_ROOMS"),
    (misstated_width, "DOOR_WIDTH"),
    (door_in_no_wall, "DOOR_WALL"),
    (door_above_its_wall, "DOOR_WALL"),
    (window_in_no_wall, "WINDOW_WALL"),
    (window_of_another_room, "WINDOW_ROOM"),
    (window_above_its_wall, "WINDOW_WALL"),
    (two_windows_in_one_place, "OPENINGS_OVERLAP"),
    (core_off_the_storey, "CORE_OUTSIDE"),
    (entrance_in_the_shaft, "CORE_ENTRANCE"),
    (core_of_other_storeys, "CORE_FLOORS"),
    (core_of_one_storey_more, "CORE_FLOORS"),
    (low_risers, "STAIR_RISER"),
    (short_goings, "STAIR_GOING"),
    (cabin_larger_than_its_shaft, "LIFT_CABIN"),
    (thing_of_another_room, "OBJECT_OUTSIDE"),
    (thing_of_no_room, "OBJECT_ROOM"),
    (thing_through_the_ceiling, "OBJECT_OUTSIDE"),
    (beside_the_table, "OBJECT_PARENT"),
    (endless_thing, "FILE"),
    (fewer_rooms, "COUNT"),
    (more_objects, "COUNT"),
    (other_area, "COUNT"),
    (other_elevation, "COUNT"),
    (other_height, "COUNT"),
    (other_label, "COUNT"),
    (other_sum, "COUNT"),
    (more_storeys_than_asked, "FLOOR_COUNT"),
    (other_area_than_asked, "AREA"),
    (file_that_is_missing, "FILE"),
    (report_that_is_missing, "FILE"),
]
"""Each fault with the kind that must be among those found."""
