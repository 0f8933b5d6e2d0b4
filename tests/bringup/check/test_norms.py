"""Each rule of building finds a planted deviation, is silent where it holds, and gives way to the brief."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import msgspec
import pytest

from mansion_bringup.check.norms import Deviation, check_norms
from mansion_knowledge.norms import load_norms
from mansion_msgs_py.building import Building
from mansion_msgs_py.program import AreaSummary, BuildingProgram, FloorProgram, VerticalConnectivity
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import Door, FloorScene, LiftDetails, SceneCore, SceneObject, SceneRoom, StairDetails, Window
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.wishes import Wish, WishKind, WishValue

Box = tuple[float, float, float, float]
Line = tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True)
class Floor:
    """A storey drawn by hand: rooms by id (type and box), doors, glass and things by room, cores with their details."""

    rooms: dict[str, tuple[str, Box]]
    doors: Sequence[tuple[str, str | None, Line]] = ()
    glass: dict[str, float] = field(default_factory=dict)
    things: dict[str, Sequence[str]] = field(default_factory=dict)
    cores: dict[str, Box] = field(default_factory=dict)
    details: dict[str, StairDetails | LiftDetails] = field(default_factory=dict)
    ceiling: float = 2.8


def ring(box: Box, inset: float = 0.0) -> Ring:
    x0, y0, x1, y1 = box[0] + inset, box[1] + inset, box[2] - inset, box[3] - inset
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def drawn(floor: Floor, number: int, floors: int) -> FloorScene:
    def named(name: str) -> str:
        return name if name in floor.cores else f"F{number}/{name}"

    boxes = [box for _, box in floor.rooms.values()]
    hull = (min(b[0] for b in boxes), min(b[1] for b in boxes), max(b[2] for b in boxes), max(b[3] for b in boxes))
    doors = [
        Door(
            id=f"F{number}/door_{index}", kind="single" if other else "entrance", segment=line,
            rooms=(named(one), named(other) if other else None),
            width=abs(line[0][0] - line[1][0]) + abs(line[0][1] - line[1][1]), height=2.1,
        )
        for index, (one, other, line) in enumerate(floor.doors)
    ]  # fmt: skip
    return FloorScene(
        building_id="drawn", floor=number, floors=floors, label=str(number), elevation=3.0 * (number - 1), height=3.0,
        outline=ring(hull), walls=[], doors=doors,
        rooms=[
            SceneRoom(id=named(name), room_type=kind, kind="Entities", polygon=ring(box), net_polygon=ring(box, 0.1),
                      area=(box[2] - box[0]) * (box[3] - box[1]), ceiling_height=floor.ceiling)
            for name, (kind, box) in floor.rooms.items()
        ],
        windows=[
            Window(id=f"F{number}/window_{name}", wall="w", room=named(name), segment=((0, 0), (area, 0)), sill=0.9,
                   height=1.0)
            for name, area in floor.glass.items()
        ],
        objects=[
            SceneObject(id=f"{named(name)}/{category}_{index}", room=named(name), category=category, asset=category,
                        position=(floor.rooms[name][1][0] + 0.5, floor.rooms[name][1][1] + 0.5, 0.4), rotation=0.0,
                        size=(0.4, 0.6, 0.8))
            for name, things in floor.things.items() for index, category in enumerate(things)
        ],
        cores=[
            SceneCore(id=name, type="stair" if "stair" in name else "elevator", polygon=ring(box),
                      door=next((d.id for d in doors if name in d.rooms), ""), entrance=(0, 0, 0),
                      floors=list(range(1, floors + 1)), details=floor.details.get(name))
            for name, box in floor.cores.items()
        ],
    )  # fmt: skip


def deviations(kind: str, *floors: Floor, wishes: Sequence[Wish] = ()) -> list[Deviation]:
    scenes = [drawn(floor, number, len(floors)) for number, floor in enumerate(floors, 1)]
    program = BuildingProgram(
        building_id="drawn", reasoning="", vertical_connectivity=VerticalConnectivity(method="none"),
        floors=[
            FloorProgram(index=scene.floor, requirement="", gross_floor_area=100.0, rooms=[],
                         area_summary=AreaSummary(sum_rooms=0, reserve_ratio=0, fits_within_gfa=True))
            for scene in scenes
        ],
        building_type=kind,
    )  # fmt: skip
    building = Building(
        building_id="drawn", request=BuildRequest(description="drawn by hand"), program=program, floors=[], cores=[],
        seed=0, wishes=list(wishes),
    )  # fmt: skip
    return check_norms(building, scenes)


def rules(kind: str, *floors: Floor, wishes: Sequence[Wish] = ()) -> set[str]:
    """Return the rules that do not hold, as deviations or as advice."""
    return {item.rule for item in deviations(kind, *floors, wishes=wishes) if not item.caused_by}


def across(x: float, y: float, width: float = 1.0) -> Line:
    """A door in a wall along x."""
    return ((x, y), (x + width, y))


HALL = {"reading_room": ("reading_room", (0.0, 0.0, 20.0, 20.0))}
TWO_TOILETS = {"men": ("restroom", (0.0, 20.0, 4.0, 24.0)), "women": ("restroom", (4.0, 20.0, 8.0, 24.0))}
TO_TOILETS = [("reading_room", "men", across(1, 20)), ("reading_room", "women", across(5, 20))]
CLOSETS = {"men": ["toilet_stall"], "women": ["toilet_stall"]}
LIBRARY = Floor({**HALL, **TWO_TOILETS}, [*TO_TOILETS, ("reading_room", None, across(9, 0)),
                                          ("reading_room", None, across(1, 0))], things=CLOSETS)  # fmt: skip


def library(**changes: object) -> Floor:
    return Floor(**{name: changes.get(name, getattr(LIBRARY, name)) for name in LIBRARY.__dataclass_fields__})


def long_corridor(length: float, exits: Sequence[float], *, width: float = 2.0, rooms: int = 1) -> Floor:
    """A storey of a school: a corridor with exits at some places along it, and classrooms at its side."""
    step = length / rooms
    classes = {f"classroom_{n}": ("classroom", (step * n, width, step * (n + 1), width + 7)) for n in range(rooms)}
    corridor: tuple[str, Box] = ("corridor", (0.0, 0.0, length, width))
    doors: list[tuple[str, str | None, Line]] = [("corridor", None, across(x, 0)) for x in exits]
    doors += [("corridor", name, across(box[0] + 0.5, width)) for name, (_, box) in classes.items()]
    return Floor({"corridor": corridor, **classes}, doors)


def upstairs(below: Floor, *, lift: bool) -> tuple[Floor, Floor]:
    cores: dict[str, Box] = {"stair_1": (20.0, 0.0, 23.0, 6.0)}
    if lift:
        cores["elevator_1"] = (20.0, 6.0, 22.0, 8.0)
    to_stair = [*below.doors, ("reading_room", "stair_1", ((20.0, 1.0), (20.0, 2.0)))]
    return library(doors=to_stair, cores=cores), library(doors=to_stair[-1:] + TO_TOILETS, cores=cores)


def room(kind: str, box: Box, glass: float) -> Floor:
    return Floor({"room": (kind, box)}, [("room", None, across(0.5, 0))], {"room": glass})


def pair(one: str, other: str) -> Floor:
    rooms = {"one": (one, (0.0, 0.0, 8.0, 6.0)), "other": (other, (0.0, 6.0, 8.0, 10.0))}
    return Floor(rooms, [("one", "other", across(2, 6)), ("one", None, across(2, 0))])


def hotel(things: Sequence[str]) -> Floor:
    rooms = {"hotel_room": ("hotel_room", (0.0, 0.0, 5.0, 4.0)), "bathroom": ("bathroom", (5.0, 0.0, 7.0, 3.0))}
    return Floor(rooms, [("hotel_room", "bathroom", ((5.0, 1.0), (5.0, 1.9)))], things={"bathroom": things})


def stacked(shift: float) -> tuple[Floor, Floor]:
    return tuple(
        Floor({"hallway": ("hallway", (0.0, 0.0, 20.0, 2.0)), "bathroom": ("bathroom", (x, 2.0, x + 3, 5.0))},
              [("hallway", "bathroom", across(x + 1, 2))])
        for x in (0.0, shift)
    )  # type: ignore[return-value]  # fmt: skip


def ward(width: float) -> Floor:
    rooms = {"ward": ("hospital_ward", (0.0, 0.0, 8.0, 8.0)), "corridor": ("corridor", (0.0, 8.0, 8.0, 11.0))}
    return Floor(rooms, [("corridor", "ward", across(2, 8, width))])


def flight(width: float, going: float, riser: float) -> Floor:
    """A storey with a stair up from it."""
    box: Box = (8.0, 0.0, 11.0, 6.0)
    stair = StairDetails(form="dog_leg", risers=18, riser=riser, going=going, width=width, floor_landing=ring(box))
    return Floor({"lobby": ("lobby", (0.0, 0.0, 8.0, 8.0))}, [("lobby", "stair_1", ((8.0, 1.0), (8.0, 2.0)))],
                 cores={"stair_1": box}, details={"stair_1": stair})  # fmt: skip


GOOD_FLIGHT = flight(1.2, 0.28, 0.175)


def lift(width: float, depth: float) -> Floor:
    """A storey with a lift whose door is on its west side."""
    cabin = ((8.0, 0.0, 0.0), (8.0 + depth, width, 2.2))
    details = LiftDetails(cabin=cabin, facing=180.0, call_panel=(0, 0, 1), button_panel=(0, 0, 1), buttons=[])
    return Floor({"lobby": ("lobby", (0.0, 0.0, 8.0, 8.0))}, cores={"elevator_1": (8.0, 0.0, 10.0, 2.0)},
                 details={"elevator_1": details})  # fmt: skip


def dormitory(toilets: int, showers: int) -> Floor:
    """Two rooms with twelve beds, and what they share."""
    rooms: dict[str, tuple[str, Box]] = {
        "corridor": ("corridor", (0.0, 0.0, 30.0, 2.0)),
        "dorm_1": ("hostel_dorm", (0.0, 2.0, 10.0, 8.0)),
        "dorm_2": ("hostel_dorm", (10.0, 2.0, 20.0, 8.0)),
        "restroom": ("restroom", (20.0, 2.0, 25.0, 8.0)),
        "showers": ("shower_area", (25.0, 2.0, 30.0, 8.0)),
    }
    doors = [("corridor", name, across(box[0] + 1, 2)) for name, (_, box) in rooms.items() if name != "corridor"]
    beds = ["bunk_bed"] * 3
    things = {
        "dorm_1": beds,
        "dorm_2": beds,
        "restroom": ["toilet_stall"] * toilets,
        "showers": ["shower_cabin"] * showers,
    }
    return Floor(rooms, [*doors, ("corridor", None, ((0.0, 0.5), (0.0, 1.5)))], things=things)


def chain(*kinds: str) -> Floor:
    """Rooms in a row, each reached through the one before it, the first from the open."""
    rooms: dict[str, tuple[str, Box]] = {
        f"room_{n}": (kind, (0.0, 5.0 * n, 6.0, 5.0 * n + 5)) for n, kind in enumerate(kinds)
    }
    doors: list[tuple[str, str | None, Line]] = [("room_0", None, across(1, 0))]
    doors += [(f"room_{n - 1}", f"room_{n}", across(1, 5.0 * n)) for n in range(1, len(kinds))]
    return Floor(rooms, doors)


def assembly(size: float, doors: Sequence[Line]) -> Floor:
    """One room of an assembly, with doors to a lobby in front of it."""
    rooms: dict[str, tuple[str, Box]] = {
        "hall": ("assembly_hall", (0.0, 4.0, size, 4.0 + size)),
        "lobby": ("lobby", (0.0, 0.0, size, 4.0)),
    }
    return Floor(rooms, [("lobby", "hall", line) for line in doors] + [("lobby", None, across(1, 0))])


CUPBOARDS = {"men": ("restroom", (0.0, 20.0, 1.2, 22.0)), "women": ("restroom", (4.0, 20.0, 5.2, 22.0))}

BARE = library(rooms=HALL, doors=[], things={})

HOME_FIXTURES = {"home_toilet": "toilet", "home_bath": "shower_cabin", "home_sink": "kitchen_sink_unit"}
BARE_HOME = Floor({"room": ("studio_room", (0, 0, 6, 5))}, [("room", None, across(1, 0))])


def furnished_home(thing: str) -> Floor:
    return Floor(BARE_HOME.rooms, BARE_HOME.doors, things={"room": [thing]})


CASES: list[tuple[str, str, tuple[Floor, ...], tuple[Floor, ...]]] = [
    ("water_closets_men", "library_building", (library(things={"women": ["toilet"]}),), (LIBRARY,)),
    ("water_closets_women", "library_building",
     (library(rooms={**LIBRARY.rooms, "stacks": ("reading_room", (0, -20, 20, 0))}),), (LIBRARY,)),
    ("separate_toilets", "library_building",
     (library(rooms={**HALL, "men": TWO_TOILETS["men"]}, things={"men": ["toilet"]}, doors=LIBRARY.doors[:1]),),
     (LIBRARY,)),
    ("accessible_toilet", "library_building", (library(rooms={**HALL, **CUPBOARDS}),), (LIBRARY,)),
    ("public_toilet", "library_building", (library(rooms=HALL, doors=[], things={}),), (LIBRARY,)),
    ("sleeping_unit_shower", "hotel", (hotel(["toilet"]),), (hotel(["toilet", "shower_cabin"]),)),
    ("exits", "school", (long_corridor(30, [1.0], rooms=3),), (long_corridor(30, [1.0, 28.0], rooms=3),)),
    ("single_exit_travel", "school", (room("storage", (0, 0, 40, 4), 1.0),), (room("storage", (0, 0, 20, 4), 1.0),)),
    ("travel_distance", "school", (long_corridor(140, [1.0, 4.0], rooms=9),),
     (long_corridor(60, [1.0, 58.0], rooms=6),)),
    ("dead_end", "school", (long_corridor(40, [1.0, 6.0], rooms=4),), (long_corridor(40, [1.0, 37.0], rooms=4),)),
    ("lift", "library_building", upstairs(LIBRARY, lift=False), upstairs(LIBRARY, lift=True)),
    ("corridor_width", "school", (long_corridor(20, [1.0], width=1.5),), (long_corridor(20, [1.0], width=2.4),)),
    ("door_width", "hospital", (ward(0.9),), (ward(1.2),)),
    ("outer_wall", "house", (Floor({"room": ("bedroom", (0, 0, 4, 4))}),), (room("bedroom", (0, 0, 4, 4), 2.0),)),
    ("window_share", "house", (room("bedroom", (0, 0, 4, 4), 0.6),), (room("bedroom", (0, 0, 4, 4), 1.6),)),
    ("room_area", "house", (room("bedroom", (0, 0, 2.5, 2.5), 1.0),), (room("bedroom", (0, 0, 3, 3), 1.0),)),
    ("room_dimension", "house", (room("bedroom", (0, 0, 2, 6), 1.5),), (room("bedroom", (0, 0, 3, 4), 1.5),)),
    ("proportion", "house", (room("bedroom", (0, 0, 3, 10), 3.0),), (room("bedroom", (0, 0, 3, 5), 3.0),)),
    ("wet_stack", "house", stacked(12.0), stacked(1.0)),
    ("kitchen_of_dining", "restaurant_building", (pair("restaurant", "storage"),),
      (pair("restaurant", "commercial_kitchen"),)),
    ("toilet_food_door", "restaurant_building", (pair("restroom", "commercial_kitchen"),),
      (pair("restroom", "restaurant"),)),
    ("service_door", "restaurant_building", (pair("restaurant", "cold_storage"),),
      (pair("restaurant", "commercial_kitchen"),)),
    ("secure_door", "police_station", (pair("lobby", "holding_cell"),), (pair("lobby", "interview_room"),)),
    ("circulation_share", "house", (pair("hallway", "living_room"),), (pair("living_room", "kitchen"),)),
    ("washbasins", "library_building", (library(things={"men": ["toilet_stall"]}),),
     (library(things={"men": ["washbasin"]}),)),
    ("toilet_washbasin", "house", (room("toilet", (0, 0, 2, 2), 0.3),),
     (Floor({"room": ("toilet", (0, 0, 2, 2))}, things={"room": ["pedestal_sink"]}),)),
    ("toilet_storey", "library_building", (LIBRARY, BARE, BARE),
     (LIBRARY, BARE)),
    ("service_sink", "library_building", (LIBRARY,), (library(things={"men": ["utility_sink"]}),)),
    ("accessible_toilet_size", "library_building", (room("accessible_toilet", (0, 0, 1.4, 4.0), 0.3),),
     (room("accessible_toilet", (0, 0, 1.8, 2.5), 0.3),)),
    ("unit_toilet", "hotel", (hotel(["shower_cabin"]),), (hotel(["toilet"]),)),
    ("dwelling_kitchen", "apartment_building", (room("apartment", (0, 0, 5, 5), 3.0),),
     (Floor({"room": ("apartment", (0, 0, 5, 5))}, [("room", None, across(1, 0))],
            things={"room": ["kitchen_sink_unit"]}),)),
    *((rule, "house", (BARE_HOME,), (furnished_home(thing),)) for rule, thing in HOME_FIXTURES.items()),
    ("shared_toilets", "hostel", (dormitory(1, 2),), (dormitory(2, 2),)),
    ("shared_showers", "hostel", (dormitory(2, 1),), (dormitory(2, 2),)),
    ("exit_separation", "school", (long_corridor(60, [1.0, 4.0], rooms=6),),
     (long_corridor(60, [1.0, 58.0], rooms=6),)),
    ("exit_width", "library_building",
     (library(doors=[("reading_room", None, across(1, 0, 0.1)), ("reading_room", None, across(9, 0, 0.1))]),),
     (LIBRARY,)),
    ("room_exits", "community_center", (assembly(10, [across(1, 4)]),), (assembly(10, [across(1, 4), across(8, 4)]),)),
    ("way_out_through_sleeping", "house", (chain("hallway", "bedroom", "bedroom"),),
     (chain("hallway", "bedroom", "walk_in_closet"),)),
    ("way_out_through_stores", "office", (chain("lobby", "storage", "private_office"),),
     (chain("lobby", "private_office", "storage"),)),
    ("toilet_through_bedroom", "house", (chain("hallway", "bedroom", "bathroom"),),
     (chain("hallway", "bathroom"),)),
    ("lift_cabin", "office", (lift(1.6, 1.2),), (lift(1.3, 1.6),)),
    ("stair_width", "office", (flight(0.9, 0.28, 0.175),), (GOOD_FLIGHT,)),
    ("stair_riser", "office", (flight(1.2, 0.28, 0.195),), (GOOD_FLIGHT,)),
    ("stair_going", "office", (flight(1.2, 0.25, 0.19),), (GOOD_FLIGHT,)),
    ("work_window", "office", (room("private_office", (0, 0, 4, 5), 1.0),),
     (room("private_office", (0, 0, 4, 5), 2.4),)),
    ("workplace_area", "office",
     (Floor({"room": ("private_office", (0, 0, 4, 3))}, things={"room": ["office_desk"] * 2}),),
     (Floor({"room": ("private_office", (0, 0, 4, 3))}, things={"room": ["office_desk"]}),)),
    ("cell_area", "police_station", (room("holding_cell", (0, 0, 2, 3), 0.3),),
     (room("holding_cell", (0, 0, 3, 3), 0.3),)),
    ("ceiling_height", "house", (Floor({"room": ("bedroom", (0, 0, 4, 4))}, ceiling=2.2),),
     (Floor({"room": ("storage", (0, 0, 4, 4))}, ceiling=2.2),)),
    ("sports_changing", "sports_center", (room("sports_hall", (0, 0, 9, 9), 9.0),),
     (pair("sports_hall", "changing_room"),)),
    ("pool_showers", "swimming_center", (pair("indoor_pool", "changing_room"),), (pair("indoor_pool", "shower_area"),)),
    ("operating_recovery", "hospital", (room("operating_room", (0, 0, 6, 6), 0.0),),
     (pair("operating_room", "recovery_room"),)),
    ("toilet_dining_door", "restaurant_building", (pair("restaurant", "restroom"),), (pair("lobby", "restroom"),)),
    ("garage_bedroom_door", "house", (pair("garage", "bedroom"),), (pair("garage", "hallway"),)),
    ("sterile_door", "hospital", (pair("waiting_room", "operating_room"),), (pair("corridor", "operating_room"),)),
    ("court_door", "courthouse", (pair("lobby", "judges_chamber"),), (pair("courtroom", "judges_chamber"),)),
]  # fmt: skip


@pytest.mark.parametrize(("rule", "kind", "bad", "sound"), CASES, ids=[case[0] for case in CASES])
def test_a_planted_deviation_is_found_and_a_sound_case_is_silent(
    rule: str, kind: str, bad: tuple[Floor, ...], sound: tuple[Floor, ...]
) -> None:
    assert rule in rules(kind, *bad)
    assert rule not in rules(kind, *sound)


def test_every_rule_has_a_case() -> None:
    assert {case[0] for case in CASES} == set(load_norms().rules)


def test_a_deviation_names_rule_place_and_source() -> None:
    found = next(item for item in deviations("school", long_corridor(30, [1.0], rooms=3)) if item.rule == "exits")
    assert str(found) == (
        "exits floor 1: 1 exit; asked: 2 for 111 occupants, as above 49 "
        "(International Building Code 2018, 1006.3.2 and tables 1006.3.2 and 1006.3.3(2))"
    )
    assert (found.severity, found.floor, found.room) == ("deviation", 1, "")


def test_a_deviation_of_a_room_names_its_storey_and_the_room() -> None:
    rooms = {"room": ("bedroom", (0.0, 0.0, 2.5, 2.5))}
    found = next(
        item for item in deviations("house", Floor(rooms), Floor(rooms)) if item.rule == "room_area" and item.floor == 2
    )
    assert (found.where, found.floor, found.room) == ("F2/room", 2, "F2/room")


def test_advice_says_so_and_does_not_count() -> None:
    found = next(item for item in deviations("house", *stacked(12.0)) if item.rule == "wet_stack")
    assert found.severity == "advice"
    assert not found.counts
    assert str(found).startswith("advice: wet_stack F2/bathroom: ")


def test_a_crowded_storey_needs_three_exits() -> None:
    crowded = library(rooms={"hall": ("assembly_hall", (0.0, 0.0, 40.0, 20.0))}, doors=[
        ("hall", None, across(1, 0)), ("hall", None, across(38, 0))], things={})  # fmt: skip
    found = [item for item in deviations("community_center", crowded) if item.rule == "exits"]
    assert [(item.found, item.asked) for item in found] == [("2 exits", "3 for 571 occupants, as above 500")]


def test_a_shop_for_few_customers_has_one_toilet_for_all() -> None:
    rooms = {"shop": ("shop", (0.0, 0.0, 10.0, 10.0)), "toilet": ("toilet", (0.0, 10.0, 2.0, 12.0))}
    doors: list[tuple[str, str | None, Line]] = [("shop", "toilet", across(0.5, 10)), ("shop", None, across(5, 0))]
    sound = Floor(rooms, doors, things={"toilet": ["toilet", "washbasin"]})
    assert {"water_closets_men", "water_closets_women"}.isdisjoint(rules("shop_building", sound))
    assert "water_closets_women" in rules("shop_building", Floor(rooms, doors))


def test_rooms_behind_a_sleeping_room_may_be_reached_through_it() -> None:
    suite = chain("corridor", "hotel_suite", "living_room")
    assert "way_out_through_stores" not in rules("hotel", suite)


def wished(kind: WishKind, value: WishValue, rooms: Sequence[str] = ()) -> Wish:
    return Wish(
        id="wish_1", text="in these words", span=(0, 5), kind=kind, value=value, status="met", rooms=list(rooms)
    )


@pytest.mark.parametrize(
    ("rule", "kind", "floors", "wish"),
    [
        ("lift", "library_building", upstairs(LIBRARY, lift=False), wished("elevator", WishValue(unwanted=True))),
        ("exits", "school", (long_corridor(30, [1.0], rooms=3),), wished("stair", WishValue(count=1))),
        ("room_area", "house", (room("bedroom", (0, 0, 2.5, 2.5), 1.0),),
         wished("room", WishValue(type="bedroom", area=6.0), ["F1/room"])),
        ("separate_toilets", "library_building", CASES[2][2], wished("room", WishValue(type="restroom", count=1))),
    ],
)  # fmt: skip
def test_what_the_brief_asks_for_does_not_count(rule: str, kind: str, floors: tuple[Floor, ...], wish: Wish) -> None:
    assert rule in rules(kind, *floors)
    assert rule not in rules(kind, *floors, wishes=[wish])
    found = deviations(kind, *floors, wishes=[wish])
    assert {item.caused_by for item in found if item.rule == rule} == {"in these words"}


def test_a_wish_that_was_not_met_causes_nothing() -> None:
    wish = msgspec.structs.replace(wished("elevator", WishValue(unwanted=True)), status="not_met")
    assert "lift" in rules("library_building", *upstairs(LIBRARY, lift=False), wishes=[wish])


LONG = {"storage": ("storage", (0.0, 0.0, 40.0, 4.0))}


def test_two_exits_that_are_apart_make_a_way_long_enough_for_two() -> None:
    one, far, near = ("storage", None, across(1, 0)), ("storage", None, across(30, 0)), ("storage", None, across(3, 0))
    assert "single_exit_travel" in rules("school", Floor(LONG, [one]))
    assert not {"single_exit_travel", "exit_separation"} & rules("school", Floor(LONG, [one, far]))
    assert "exit_separation" in rules("school", Floor(LONG, [one, near]))
