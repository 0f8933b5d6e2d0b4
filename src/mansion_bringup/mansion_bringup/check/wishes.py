"""Checks that the building is what its description asks for: the status of every wish, from geometry and furniture.

The words of a wish are not read: its kind, value and scope are, and the finished floors. The code is apart from that
which gives a wish its status when a building is built.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from statistics import median_high

import msgspec
from shapely import Polygon

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.finished_building import FinishedBuilding, Judge, is_on, labels_of, written
from mansion_bringup.check.interior_wishes import INTERIOR_JUDGES
from mansion_bringup.check.shapes import is_upright, outline_forms, shared_wall
from mansion_knowledge import default_knowledge, is_class
from mansion_knowledge.essentials import needs_of
from mansion_knowledge.furnished_as import furnished_as
from mansion_knowledge.object_kinds import answers
from mansion_knowledge.places import places_of, use_of
from mansion_knowledge.room_kinds import is_one_of
from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.outside import Outside
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.wishes import AREA_TOLERANCE, MOST_WORDS, Wish, WishValue

__all__ = ["check_wishes"]


ROOM_TOLERANCE = 0.1
"""Share by which the area of a room may differ from the one asked for."""

LEAST_TOLERANCE = 0.25
"""Square metres by which that of any room may."""

NEIGHBOURS = 1.1
"""Metres of straight wall that rooms side by side share: a door and a little on either side."""

LEAST_BAY = 2.3 * 4.8
"""Least area of a place to park, square metres."""

PERSON = 2.0
"""Least area of rooms that one person needs, square metres."""

TOILETS = frozenset({"toilet", "restroom", "accessible_toilet"})
"""Types of rooms that are all toilets."""

PASSAGES = frozenset({"corridor", "hallway", "lobby", "stair", "elevator"})
"""Rooms that a building needs whatever is asked for."""


def check_wishes(
    building: Building, reported: Sequence[Wish] | None, layouts: Sequence[FloorLayout], scenes: Sequence[FloorScene]
) -> Iterator[Fault]:
    """Yield what is wrong with the ledger of a building, and each wish whose status the building does not bear out.

    Parameters
    ----------
    building : Building
    reported : sequence of Wish, optional
        Those of the report; ``None`` where it cannot be read.
    layouts, scenes : sequence
        All floors.
    """
    finished = FinishedBuilding(building, {layout.floor: layout for layout in layouts}, scenes)
    yield from _ledger(building, reported)
    known_rooms = {room.id for _, room in finished.rooms()}
    known_objects = {thing.id for scene in scenes for thing in scene.objects}
    for wish in building.wishes:
        yield from _words(wish, building.request.description)
        for name in wish.rooms:
            if name not in known_rooms:
                yield Fault("WISH_ROOM", wish.id, f"names room {name!r}, which no floor has")
        for name in wish.objects:
            if name not in known_objects:
                yield Fault("WISH_OBJECT", wish.id, f"names object {name!r}, which no floor has")
        yield from _status(wish, finished)


def _ledger(building: Building, reported: Sequence[Wish] | None) -> Iterator[Fault]:
    asked = [(wish.id, wish.text, wish.span, wish.kind, wish.value, wish.scope) for wish in building.program.wishes]
    told = [(wish.id, wish.text, wish.span, wish.kind, wish.value, wish.scope) for wish in building.wishes]
    if asked != told:
        yield Fault(
            "WISH_LEDGER", "building", f"states {len(told)} wishes that are not the {len(asked)} of the program"
        )
    if reported is not None and list(reported) != list(building.wishes):
        yield Fault("WISH_LEDGER", "report", "states other wishes than the building")


def _words(wish: Wish, description: str) -> Iterator[Fault]:
    count = len(wish.text.split())
    if count > MOST_WORDS:
        yield Fault("WISH_TEXT", wish.id, f"its text has {count} words, at most {MOST_WORDS} are allowed")
    start, end = wish.span
    if not 0 <= start <= end <= len(description):
        yield Fault("WISH_TEXT", wish.id, f"characters {start} to {end} are not in the description")


def _status(wish: Wish, finished: FinishedBuilding) -> Iterator[Fault]:
    if wish.kind == "unread" or wish.status == "not_understood":
        if wish.kind != "unread" or wish.status != "not_understood":
            yield Fault("WISH_STATUS", wish.id, f"{wish.kind} is {wish.status or 'open'}")
        return
    instead = _JUDGES[wish.kind](wish, finished) or _taken_for(wish, finished)
    if not wish.status:
        yield Fault("WISH_STATUS", wish.id, "has no status")
    elif wish.status == "met" and instead:
        yield Fault("WISH_STATUS", wish.id, f"is said to be met; {instead}")
    elif wish.status != "met" and not instead:
        yield Fault("WISH_STATUS", wish.id, f"is said to be {wish.status}; the building meets it")


def _taken_for(wish: Wish, finished: FinishedBuilding) -> str:
    """Say that something else was built in its place, or which words were ignored: it is met in part at best."""
    if wish.value.unheeded and wish.kind != "object":
        return f"it is not {' and '.join(wish.value.unheeded)}"
    stands_in = any(entry.id == wish.id and entry.reason for entry in finished.ledger)
    return "something else stands for it" if stands_in and wish.kind in ("room", "building_type", "object") else ""


def _building_type(wish: Wish, finished: FinishedBuilding) -> str:
    program = finished.building.program
    kind = program.planned_like or program.building_type
    if kind != (wish.value.type or wish.value.name):
        return f"it is a {kind}"
    area = sum(map(_gross, finished.scenes))
    return f"it has {area:.0f} m2" if wish.value.limit and not _keeps(area, wish.value) else ""


def _floors(wish: Wish, finished: FinishedBuilding) -> str:
    count = len(finished.above)
    return "" if count == wish.value.count else f"{count} storeys stand above ground"


def _basements(wish: Wish, finished: FinishedBuilding) -> str:
    count = len(finished.scenes) - len(finished.above)
    return "" if count == wish.value.count else f"{count} storeys lie below ground"


def _total_area(wish: Wish, finished: FinishedBuilding) -> str:
    counted = [[scene for scene in finished.scenes if scene.floor in wish.scope.floors]]
    counted = counted if wish.scope.floors else [finished.above, list(finished.scenes)]
    totals = [sum(map(_gross, scenes)) for scenes in counted]
    return "" if any(_fits(total, wish.value) for total in totals) else f"it has {totals[-1]:.1f} m2"


def _floor_area(wish: Wish, finished: FinishedBuilding) -> str:
    area = median_high([_gross(scene) for scene in finished.above or finished.scenes])
    return "" if _fits(area, wish.value) else f"a storey has {area:.1f} m2"


def _gross(scene: FloorScene) -> float:
    return float(Polygon(scene.outline, scene.holes).area)


def _fits(area: float, value: WishValue) -> bool:
    """Whether the area of a building or storey is near the one that is wanted, or keeps to it where it is a bound."""
    return _keeps(area, value) if value.limit else _near(area, value.area)


def _keeps(area: float, value: WishValue) -> bool:
    share = area / (value.area or 1.0)
    return share <= 1.01 if value.limit == "most" else share >= 0.99


def _near(area: float, wanted: float | None) -> bool:
    return wanted is not None and abs(area - wanted) <= AREA_TOLERANCE * wanted + 1e-6


def _outline(wish: Wish, finished: FinishedBuilding) -> str:
    ground = next((scene for scene in finished.scenes if scene.floor == 1), finished.scenes[0])
    forms = outline_forms(ground.outline, ground.holes)
    return "" if wish.value.name in forms else f"its form is {' or '.join(sorted(forms)) or 'another'}"


def _style(wish: Wish, finished: FinishedBuilding) -> str:
    styles = {scene.style for scene in finished.scenes}
    return "" if styles == {wish.value.name} else f"its style is {', '.join(sorted(styles))}"


def _facade(wish: Wish, finished: FinishedBuilding) -> str:
    walls = [wall for scene in finished.scenes for wall in scene.walls if wall.exterior]
    others = {wall.right_material for wall in walls if wall.right_material} - {wish.value.name}
    return f"its outer walls are {', '.join(sorted(others))}" if others or not walls else ""


def _roof(wish: Wish, finished: FinishedBuilding) -> str:
    top = max(finished.scenes, key=lambda scene: scene.floor)
    outside = Outside() if isinstance(top.outside, msgspec.UnsetType) else top.outside
    if wish.value.name not in ("", outside.roof) or wish.value.type not in ("", outside.covering):
        return f"its roof is {outside.roof or 'another'}, {outside.covering or 'not covered so'}"
    sloped = outside.roof not in ("", "flat")
    fits = is_upright(top.outline) and not top.holes
    return "no pitched roof fits its outline" if sloped and not fits else ""


def _grounds(wish: Wish, finished: FinishedBuilding) -> str:
    ground = next((scene for scene in finished.scenes if scene.floor == GROUND_FLOOR), finished.scenes[0])
    if wish.value.name in ("hedge", "fence"):
        outside = Outside() if isinstance(ground.outside, msgspec.UnsetType) else ground.outside
        return "" if wish.value.name in {entry.use for entry in outside.grounds} else "its plot has none"
    areas = [] if isinstance(ground.grounds, msgspec.UnsetType) else ground.grounds
    found = [area for area in areas if area.use == wish.value.name]
    if not found:
        return "its plot has none"
    building = Polygon(ground.outline)
    for area in found:
        shape = Polygon(area.polygon)
        if shape.intersection(building).area > 0.01:
            return f"its {area.use} lies under the building"
        if shape.area < area.count * LEAST_BAY:
            return f"its {area.use} of {shape.area:.0f} m2 is too small for {area.count} cars"
    places = sum(area.count for area in found)
    return f"its plot has {places} places" if places < (wish.value.count or 0) else ""


def _use(wish: Wish, finished: FinishedBuilding) -> str:
    words = wish.value.name.replace("_", " ")
    uses = {floor.index: floor.requirement.partition(":")[0] for floor in finished.building.program.floors}
    other = [floor for floor in wish.scope.floors if not re.search(rf"\b{re.escape(words)}\b", uses.get(floor, ""))]
    return f"storeys {other} are for something else" if other or not wish.scope.floors else ""


def _copy(wish: Wish, finished: FinishedBuilding) -> str:
    group = [finished.layouts[floor].rooms for floor in wish.scope.floors if floor in finished.layouts]
    if len(group) < 2:
        return "there are not two such storeys"
    return "" if all(rooms == group[0] for rooms in group[1:]) else "the storeys differ"


def _core(wish: Wish, finished: FinishedBuilding) -> str:
    count = len({core.id for scene in finished.scenes for core in scene.cores if core.type == wish.kind})
    if wish.value.unwanted:
        return f"it has {count}" if count else ""
    return "" if count >= max(wish.value.count or 1, 1) else f"it has {count}"


def _room(wish: Wish, finished: FinishedBuilding) -> str:
    value, floors = wish.value, wish.scope.floors
    if wish.scope.unit:
        return _inside(wish, finished)
    rooms = finished.meant(value.name, value.type, floors)
    rooms = [entry for entry in rooms if entry[1].id not in finished.owned] or rooms
    names = {entry.value.name for entry in finished.ledger if entry.kind == "room"} - {value.name}
    rooms = [entry for entry in rooms if names.isdisjoint(written(entry[1].id))] or rooms
    if not rooms:
        return "there is no such room where it is wanted"
    alike = [
        entry.value.count
        for entry in finished.ledger
        if entry.kind == "room"
        and entry.value.name == value.name
        and entry.scope.floors == floors
        and not entry.scope.unit
    ]
    return (
        _miscounted(wish, rooms, alike)
        or _lacks_its_own(wish, finished, rooms)
        or _wrong_areas(wish, finished, rooms, several=len(alike) > 1)
        or _idle(finished, rooms)
        or _closed(finished, rooms)
        or _of_another_rank(wish, finished, rooms)
    )


def _of_another_rank(wish: Wish, finished: FinishedBuilding, rooms: Sequence[tuple[int, SceneRoom]]) -> str:
    """Say that a room is not the largest or the smallest of its type, where it is to be that."""
    meant = {room.id: room.area for _, room in rooms}
    others = [r.area for _, r in finished.rooms() if r.room_type == wish.value.type and r.id not in meant]
    if not others or not wish.value.rank:
        return ""
    if wish.value.rank == "largest":
        within = max(others) <= min(meant.values()) + LEAST_TOLERANCE
    else:
        within = min(others) >= max(meant.values()) - LEAST_TOLERANCE
    return "" if within else f"it is not the {wish.value.rank}"


def _closed(finished: FinishedBuilding, rooms: Sequence[tuple[int, SceneRoom]]) -> str:
    """Say which open kitchen has no door and no opening but to passages and the outside."""
    for floor, kitchen in rooms:
        if kitchen.room_type != "open_kitchen":
            continue
        passages = {room.id for room in finished.on(floor).rooms if room.room_type in PASSAGES}
        doors = [set(door.rooms) - {kitchen.id, None} for door in finished.on(floor).doors if kitchen.id in door.rooms]
        if not any(beyond - passages for beyond in doors):
            return f"{kitchen.id} opens to passages alone"
    return ""


def _miscounted(wish: Wish, rooms: Sequence[tuple[int, SceneRoom]], alike: Sequence[int | None]) -> str:
    """Say how many rooms there are where that differs from the counts of all wishes that are about them."""
    value, floors = wish.value, wish.scope.floors
    if wish.scope.each and floors:
        there = Counter(floor for floor, _ in rooms)
        each = None if None in alike else sum(count or 0 for count in alike)
        wrong = any(there[floor] == 0 or each not in (None, there[floor]) for floor in floors)
        return f"the storeys have {[there[floor] for floor in floors]} of them" if wrong else ""
    numbers = [count for count in alike if count is not None]
    if len(numbers) < len(alike):
        return "there is one" if len(rooms) < 2 else ""
    missing = sum(numbers) - len(rooms)
    more_allowed = wish.scope.room or (value.type in PASSAGES and not floors)
    return f"there are {len(rooms)}" if missing > 0 or (missing < 0 and not more_allowed) else ""


def _lacks_its_own(wish: Wish, finished: FinishedBuilding, rooms: Sequence[tuple[int, SceneRoom]]) -> str:
    """Say which room is to have one of these for itself, and has none beside it."""
    if wish.scope.room:
        for owner_floor, owner in finished.meant(wish.scope.room, wish.scope.room_type, wish.scope.floors):
            if not any(owner_floor == floor and _side_by_side(owner, room) for floor, room in rooms):
                return f"{owner.id} has none of its own"
    return ""


def _wrong_areas(
    wish: Wish, finished: FinishedBuilding, rooms: Sequence[tuple[int, SceneRoom]], *, several: bool
) -> str:
    """Say how many rooms have the area asked for where they are too few; of `several` wishes each has its share."""
    value, floors = wish.value, wish.scope.floors
    wanted = value.area
    if wanted is None:
        return ""
    areas = [
        sum(part.area for part in finished.suite(floor, room)) if value.whole else room.area for floor, room in rooms
    ]
    fitting = sum(_keeps(area, value) if value.limit else _as_large(area, wanted) for area in areas)
    needed = (value.count or 1) * (len(floors) if wish.scope.each and floors else 1) if several else len(rooms)
    return f"{fitting} of {len(rooms)} have that area" if fitting < min(needed, len(rooms)) else ""


def _idle(finished: FinishedBuilding, rooms: Sequence[tuple[int, SceneRoom]]) -> str:
    """Say which of some rooms cannot be used as what it is, because furniture that its use needs is missing."""
    for floor, room in rooms:
        objects = [thing for thing in finished.on(floor).objects if thing.room == room.id]
        refused = [
            entry.value.type
            for entry in finished.ledger
            if entry.kind == "no_object" and entry.value.type and _covers(entry, finished, floor, room)
        ]
        scene = finished.on(floor)
        beside = [other.room_type for other in scene.rooms if other.id != room.id]
        kind = furnished_as(room.room_type, scene.building_type, room.name, beside, scene.called or "")
        for need in needs_of(kind, (room.name, *room.aliases)):
            if all(any(answers(kind, thing.categories[0]) for kind in refused) for thing in need.things):
                continue
            if sum(need.pieces(thing.category, thing.size[0]) for thing in objects) < need.count:
                return f"{room.id} cannot be used without {need.count} x {need.name}"
        driven_into = floor == GROUND_FLOOR and is_class(room.room_type, "vehicle")
        if driven_into and not any(None in door.rooms and room.id in door.rooms for door in scene.doors):
            return f"no vehicle can drive into {room.id}"
    return ""


def _inside(wish: Wish, finished: FinishedBuilding) -> str:
    """Say which unit does not hold what each is to hold."""
    value, scope = wish.value, wish.scope
    alike = [
        entry.value.count
        for entry in finished.ledger
        if entry.kind == "room"
        and (entry.value.name, entry.scope.unit, entry.scope.floors) == (value.name, scope.unit, scope.floors)
    ]
    units = finished.meant(scope.unit, scope.unit_type, scope.floors)
    for floor, unit in units:
        parts = finished.suite(floor, unit)
        rooms = [room for room in parts if value.name in labels_of(room)]
        rooms = rooms or [room for room in parts if room.room_type == value.type]
        several = None in alike
        if (several and len(rooms) < 2) or (not several and len(rooms) != sum(count or 0 for count in alike)):
            return f"{unit.id} has {len(rooms)}"
        needed = len(rooms) if len(alike) == 1 else min(value.count or 1, len(rooms))
        if value.area is not None and sum(_as_large(room.area, value.area) for room in rooms) < needed:
            return f"{unit.id} has them of another area"
        idle = _idle(finished, [(floor, room) for room in rooms])
        if idle:
            return idle
    return "" if units else "there is no such unit"


def _covers(entry: Wish, finished: FinishedBuilding, floor: int, room: SceneRoom) -> bool:
    """Whether a wish of objects is about a room."""
    scope = entry.scope
    if not scope.room:
        return is_on(floor, scope.floors)
    return any(other.id == room.id for _, other in finished.meant(scope.room, scope.room_type, scope.floors))


def _as_large(area: float, wanted: float) -> bool:
    return abs(area - wanted) <= max(ROOM_TOLERANCE * wanted, LEAST_TOLERANCE) + 1e-6


def _no_room(wish: Wish, finished: FinishedBuilding) -> str:
    if wish.value.type == "basement":
        return "" if len(finished.above) == len(finished.scenes) else "it has a basement"
    there = [room.id for _, room in finished.rooms(wish.scope.floors) if is_one_of(room.room_type, wish.value.type)]
    return f"{there[0]} is one" if there else ""


def _adjacent(wish: Wish, finished: FinishedBuilding) -> str:
    beside = set(_sides(wish, finished))
    if wish.scope.each and any(room.id not in beside for _, room in finished.meant(wish.value.name, wish.value.type)):
        return "not every such room shares a wall with one"
    if beside and max(Counter(_sides(wish, finished)).values()) < (wish.value.count or 1):
        return f"none lies beside {wish.value.count} of them"
    if beside and wish.value.door and not _is_entered(wish, finished):
        return "no door leads from one into the other"
    return "" if beside else "no two such rooms share a wall"


def _is_entered(wish: Wish, finished: FinishedBuilding) -> bool:
    """Whether a door has a room of either kind of a relation on each side; for each of the first where it is meant."""
    first = {room.id for _, room in finished.meant(wish.value.name, wish.value.type)}
    second = {room.id for _, room in finished.meant(wish.value.other, wish.value.other_type)}
    sides = [set(door.rooms) for scene in finished.scenes for door in scene.doors]
    if wish.scope.each:
        return all(any({one, other} in sides for other in second - {one}) for one in first)
    return any(
        len(side) == 2 and any({one, other} == side for one in first & side for other in second & side)
        for side in sides
    )


def _apart(wish: Wish, finished: FinishedBuilding) -> str:
    value = wish.value
    near = any(
        floor == other_floor and _side_by_side(first, second)
        for floor, first in _of_the_kind(value.name, value.type, finished)
        for other_floor, second in _of_the_kind(value.other, value.other_type, finished)
    )
    return "two such rooms share a wall" if near else ""


def _of_the_kind(name: str, kind: str, finished: FinishedBuilding) -> list[tuple[int, SceneRoom]]:
    """Return the rooms of a name; toilets without a name of their own are all toilets of the building."""
    if kind not in TOILETS or "_" in name:
        return finished.meant(name, kind)
    return [(floor, room) for floor, room in finished.rooms() if room.room_type in TOILETS or name in labels_of(room)]


def _sides(wish: Wish, finished: FinishedBuilding) -> list[str]:
    """Return the rooms of a relation that lie side by side."""
    value = wish.value
    return [
        first.id
        for floor, first in finished.meant(value.name, value.type)
        for other_floor, second in finished.meant(value.other, value.other_type)
        if floor == other_floor and _side_by_side(first, second)
    ]


def _side_by_side(first: SceneRoom, second: SceneRoom) -> bool:
    return first.id != second.id and shared_wall(first, second) >= NEIGHBOURS


def _occupants(wish: Wish, finished: FinishedBuilding) -> str:
    area, people = sum(room.area for _, room in finished.rooms()), wish.value.count or 1
    if area < PERSON * people:
        return f"its rooms have {area:.0f} m2"
    kind = default_knowledge().buildings.get(finished.building.program.kind)
    use = use_of(wish.value.name, "" if kind is None else kind.family)
    things = [thing for scene in finished.scenes for thing in scene.objects]
    places = sum(places_of(thing.category, thing.size[0], use) for thing in things)
    return f"{places} people have a place to {use}" if use and places < people else ""


def _only(wish: Wish, finished: FinishedBuilding) -> str:
    named = {entry.value.type for entry in finished.ledger if entry.kind == "room"} | PASSAGES
    there = finished.rooms(wish.scope.floors)
    behind = {
        inner.id
        for floor, room in there
        if room.room_type in named - PASSAGES
        for inner in finished.suite(floor, room)[1:]
    }
    further = [room.id for _, room in there if room.room_type not in named and room.id not in behind]
    return f"{further[0]} was not asked for" if further else ""


_JUDGES: Mapping[str, Judge] = {
    "building_type": _building_type,
    "floors": _floors,
    "basements": _basements,
    "total_area": _total_area,
    "floor_area": _floor_area,
    "outline": _outline,
    "style": _style,
    "facade": _facade,
    "roof": _roof,
    "grounds": _grounds,
    "use": _use,
    "copy": _copy,
    "stair": _core,
    "elevator": _core,
    "room": _room,
    "no_room": _no_room,
    "adjacent": _adjacent,
    "apart": _apart,
    **INTERIOR_JUDGES,
    "occupants": _occupants,
    "only": _only,
}
