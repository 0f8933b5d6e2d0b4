"""Did the building become what its description asks for: the status of every wish, from geometry and furniture.

The words of a wish are not read: its kind, value and scope are, and the finished floors. The code is apart from that
which gives a wish its status when a building is built.
"""

import math
import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from statistics import median_high

from shapely import Polygon

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import outline_forms, shared_wall
from mansion_knowledge import is_class
from mansion_knowledge.essentials import needs_of
from mansion_knowledge.furnished_as import furnished_as
from mansion_knowledge.object_kinds import answers, seats_of_row
from mansion_knowledge.object_qualities import has_quality
from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.wishes import AREA_TOLERANCE, MOST_WORDS, Wish, WishValue

__all__ = ["check_wishes"]


ROOM_TOLERANCE = 0.06
"""Share by which the area of a room may differ from the one asked for."""

LEAST_TOLERANCE = 0.25
"""Square metres by which that of any room may."""

CEILING_TOLERANCE = 0.10
"""Metres by which a ceiling may differ from the height asked for."""

NEIGHBOURS = 1.1
"""Metres of straight wall that rooms side by side share: a door and a little on either side."""

PERSON = 2.0
"""Square metres of rooms that one person needs at the least."""

SUBSTANCES = (
    r"\b(hard)?wood(en)?\b|timber|parquet|\bplanks?\b|laminate|panelling|\bdeck(ing)?\b|herringbone|\b(oak|walnut|pine|maple"
    r"|birch|bamboo|cherry|ash|beech|mahogany)\b",
    r"carpet",
    r"\btile[sd]?\b|ceramic|porcelain|terracotta",
    r"marble",
    r"granite",
    r"\bstone\b|slate|limestone",
    r"terrazzo",
    r"concrete|cement",
    r"vinyl|\blino(leum)?\b",
    r"rubber",
    r"resin|epoxy",
    r"brick",
    r"plaster|drywall",
)
"""Patterns of the words for one substance each."""

CLUTTERED, TIDY = 5.0, 1.5
"""Things to a square metre of furniture: no fewer where clutter is wanted, no more where tidiness is."""

TOILETS = frozenset({"toilet", "restroom", "accessible_toilet"})
"""Types of rooms that are all toilets."""

PASSAGES = frozenset({"corridor", "hallway", "lobby", "stair", "elevator"})
"""Rooms that a building needs whatever is asked for."""


@dataclass(frozen=True)
class _Finished:
    """A finished building, and what its ledger asked for."""

    building: Building
    layouts: Mapping[int, FloorLayout]
    scenes: Sequence[FloorScene]

    @property
    def above(self) -> list[FloorScene]:
        return [scene for scene in self.scenes if scene.floor >= 1]

    @property
    def ledger(self) -> list[Wish]:
        return self.building.program.wishes

    def rooms(self, floors: Sequence[int] = ()) -> list[tuple[int, SceneRoom]]:
        """Return the rooms of some floors, or of all, each with its floor."""
        return [(scene.floor, room) for scene in self.scenes if _on(scene.floor, floors) for room in scene.rooms]

    def on(self, floor: int) -> FloorScene:
        """Return the scene of a storey."""
        return next(scene for scene in self.scenes if scene.floor == floor)

    def suite(self, floor: int, owner: SceneRoom) -> list[SceneRoom]:
        """Return a room of a floor with the rooms that nobody enters without passing through it."""
        scene = self.on(floor)
        beside: dict[str, list[str]] = defaultdict(list)
        for door in scene.doors:
            first, second = door.rooms
            if second is not None:
                beside[first].append(second)
                beside[second].append(first)
        entrances = [core.id for core in scene.cores]
        entrances += [door.rooms[0] for door in scene.doors if door.kind == "entrance"]
        waiting = [name for name in entrances if name != owner.id]
        passed = {owner.id, *waiting}
        while waiting:
            further = [name for name in beside[waiting.pop()] if name not in passed]
            passed.update(further)
            waiting += further
        return [owner, *(room for room in scene.rooms if room.id not in passed)]

    @cached_property
    def owned(self) -> set[str]:
        """The rooms inside the units that the ledger speaks of."""
        units = {(wish.scope.unit, wish.scope.unit_type, tuple(wish.scope.floors)) for wish in self.ledger}
        return {
            room.id
            for unit, kind, floors in units
            if unit
            for floor, owner in self.meant(unit, kind, floors)
            for room in self.suite(floor, owner)[1:]
        }

    def meant(self, name: str, kind: str, floors: Sequence[int] = ()) -> list[tuple[int, SceneRoom]]:
        """Return the rooms that people call so; where there are none, those of the type."""
        there = self.rooms(floors)
        called = [(floor, room) for floor, room in there if name in _labels(room)]
        return called or [(floor, room) for floor, room in there if kind and room.room_type == kind]


Judge = Callable[[Wish, _Finished], str]
"""Says what the building has instead of what a wish asks for; empty when it is met."""


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
    finished = _Finished(building, {layout.floor: layout for layout in layouts}, scenes)
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


def _status(wish: Wish, finished: _Finished) -> Iterator[Fault]:
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


def _taken_for(wish: Wish, finished: _Finished) -> str:
    """Say that something known stands for what is not, or which words are not heeded: it is met in part at best."""
    if wish.value.unheeded and wish.kind != "object":
        return f"it is not {' and '.join(wish.value.unheeded)}"
    stands_in = any(entry.id == wish.id and entry.reason for entry in finished.ledger)
    return "something else stands for it" if stands_in and wish.kind in ("room", "building_type", "object") else ""


def _building_type(wish: Wish, finished: _Finished) -> str:
    program = finished.building.program
    kind = program.planned_like or program.building_type
    if kind != (wish.value.type or wish.value.name):
        return f"it is a {kind}"
    area = sum(map(_gross, finished.scenes))
    return f"it has {area:.0f} m2" if wish.value.limit and not _keeps(area, wish.value) else ""


def _floors(wish: Wish, finished: _Finished) -> str:
    count = len(finished.above)
    return "" if count == wish.value.count else f"{count} storeys stand above ground"


def _basements(wish: Wish, finished: _Finished) -> str:
    count = len(finished.scenes) - len(finished.above)
    return "" if count == wish.value.count else f"{count} storeys lie below ground"


def _total_area(wish: Wish, finished: _Finished) -> str:
    counted = [[scene for scene in finished.scenes if scene.floor in wish.scope.floors]]
    counted = counted if wish.scope.floors else [finished.above, list(finished.scenes)]
    totals = [sum(map(_gross, scenes)) for scenes in counted]
    return "" if any(_fits(total, wish.value) for total in totals) else f"it has {totals[-1]:.1f} m2"


def _floor_area(wish: Wish, finished: _Finished) -> str:
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


def _outline(wish: Wish, finished: _Finished) -> str:
    ground = next((scene for scene in finished.scenes if scene.floor == 1), finished.scenes[0])
    forms = outline_forms(ground.outline, ground.holes)
    return "" if wish.value.name in forms else f"its form is {' or '.join(sorted(forms)) or 'another'}"


def _style(wish: Wish, finished: _Finished) -> str:
    styles = {scene.style for scene in finished.scenes}
    return "" if styles == {wish.value.name} else f"its style is {', '.join(sorted(styles))}"


def _use(wish: Wish, finished: _Finished) -> str:
    words = wish.value.name.replace("_", " ")
    uses = {floor.index: floor.requirement.partition(":")[0] for floor in finished.building.program.floors}
    other = [floor for floor in wish.scope.floors if not re.search(rf"\b{re.escape(words)}\b", uses.get(floor, ""))]
    return f"storeys {other} are for something else" if other or not wish.scope.floors else ""


def _copy(wish: Wish, finished: _Finished) -> str:
    group = [finished.layouts[floor].rooms for floor in wish.scope.floors if floor in finished.layouts]
    if len(group) < 2:
        return "there are not two such storeys"
    return "" if all(rooms == group[0] for rooms in group[1:]) else "the storeys differ"


def _core(wish: Wish, finished: _Finished) -> str:
    count = len({core.id for scene in finished.scenes for core in scene.cores if core.type == wish.kind})
    if wish.value.unwanted:
        return f"it has {count}" if count else ""
    return "" if count >= max(wish.value.count or 1, 1) else f"it has {count}"


def _room(wish: Wish, finished: _Finished) -> str:
    value, floors = wish.value, wish.scope.floors
    if wish.scope.unit:
        return _inside(wish, finished)
    rooms = finished.meant(value.name, value.type, floors)
    rooms = [entry for entry in rooms if entry[1].id not in finished.owned] or rooms
    names = {entry.value.name for entry in finished.ledger if entry.kind == "room"} - {value.name}
    rooms = [entry for entry in rooms if names.isdisjoint(_written(entry[1].id))] or rooms
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
    if wish.scope.each and floors:
        there = Counter(floor for floor, _ in rooms)
        each = None if None in alike else sum(count or 0 for count in alike)
        if any(there[floor] == 0 or each not in (None, there[floor]) for floor in floors):
            return f"the storeys have {[there[floor] for floor in floors]} of them"
    else:
        numbers = [count for count in alike if count is not None]
        if len(numbers) < len(alike) and len(rooms) < 2:
            return "there is one"
        missing = sum(numbers) - len(rooms)
        if len(numbers) == len(alike) and (
            missing > 0 or (missing < 0 and not (wish.scope.room or (value.type in PASSAGES and not floors)))
        ):
            return f"there are {len(rooms)}"
    if wish.scope.room:
        for owner_floor, owner in finished.meant(wish.scope.room, wish.scope.room_type, floors):
            if not any(owner_floor == floor and _side_by_side(owner, room) for floor, room in rooms):
                return f"{owner.id} has none of its own"
    if value.area is None:
        return _idle(finished, rooms)
    wanted = value.area
    areas = [
        sum(part.area for part in finished.suite(floor, room)) if value.whole else room.area for floor, room in rooms
    ]
    fitting = sum(_keeps(area, value) if value.limit else _as_large(area, wanted) for area in areas)
    needed = (value.count or 1) * (len(floors) if wish.scope.each and floors else 1) if len(alike) > 1 else len(rooms)
    if fitting < min(needed, len(rooms)):
        return f"{fitting} of {len(rooms)} have that area"
    return _idle(finished, rooms)


def _idle(finished: _Finished, rooms: Sequence[tuple[int, SceneRoom]]) -> str:
    """Say which of some rooms nobody can use for what it is: too little stands in it of what the use needs."""
    for floor, room in rooms:
        objects = [thing for thing in finished.on(floor).objects if thing.room == room.id]
        refused = [
            entry.value.type
            for entry in finished.ledger
            if entry.kind == "no_object" and entry.value.type and _covers(entry, finished, floor, room)
        ]
        scene = finished.on(floor)
        beside = [other.room_type for other in scene.rooms if other.id != room.id]
        kind = furnished_as(room.room_type, scene.building_type, room.name, beside)
        for need in needs_of(kind, (room.name, *room.aliases)):
            if all(any(answers(kind, thing.categories[0]) for kind in refused) for thing in need.things):
                continue
            if sum(need.pieces(thing.category, thing.size[0]) for thing in objects) < need.count:
                return f"{room.id} cannot be used without {need.count} x {need.name}"
        driven_into = floor == GROUND_FLOOR and is_class(room.room_type, "vehicle")
        if driven_into and not any(None in door.rooms and room.id in door.rooms for door in scene.doors):
            return f"nobody drives into {room.id}"
    return ""


def _written(room_id: str) -> tuple[str, str]:
    """Return the name that a room's id was made from, with and without a number at its end."""
    name = room_id.partition("/")[2]
    return name, re.sub(r"_\d+$", "", name)


def _inside(wish: Wish, finished: _Finished) -> str:
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
        rooms = [room for room in parts if value.name in _labels(room)]
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


def _covers(entry: Wish, finished: _Finished, floor: int, room: SceneRoom) -> bool:
    """Whether a wish of objects is about a room."""
    scope = entry.scope
    if not scope.room:
        return _on(floor, scope.floors)
    return any(other.id == room.id for _, other in finished.meant(scope.room, scope.room_type, scope.floors))


def _as_large(area: float, wanted: float) -> bool:
    return abs(area - wanted) <= max(ROOM_TOLERANCE * wanted, LEAST_TOLERANCE) + 1e-6


def _no_room(wish: Wish, finished: _Finished) -> str:
    if wish.value.type == "basement":
        return "" if len(finished.above) == len(finished.scenes) else "it has a basement"
    there = [room.id for _, room in finished.rooms(wish.scope.floors) if room.room_type == wish.value.type]
    return f"{there[0]} is one" if there else ""


def _adjacent(wish: Wish, finished: _Finished) -> str:
    beside = set(_sides(wish, finished))
    if wish.scope.each and any(room.id not in beside for _, room in finished.meant(wish.value.name, wish.value.type)):
        return "not every such room shares a wall with one"
    if beside and wish.value.door and not _is_entered(wish, finished):
        return "no door leads from one into the other"
    return "" if beside else "no two such rooms share a wall"


def _is_entered(wish: Wish, finished: _Finished) -> bool:
    """Whether a door has a room of either kind of a relation on each side."""
    first = {room.id for _, room in finished.meant(wish.value.name, wish.value.type)}
    second = {room.id for _, room in finished.meant(wish.value.other, wish.value.other_type)}
    sides = [set(door.rooms) for scene in finished.scenes for door in scene.doors]
    return any(
        len(side) == 2 and any({one, other} == side for one in first & side for other in second & side)
        for side in sides
    )


def _apart(wish: Wish, finished: _Finished) -> str:
    value = wish.value
    near = any(
        floor == other_floor and _side_by_side(first, second)
        for floor, first in _of_the_kind(value.name, value.type, finished)
        for other_floor, second in _of_the_kind(value.other, value.other_type, finished)
    )
    return "two such rooms share a wall" if near else ""


def _of_the_kind(name: str, kind: str, finished: _Finished) -> list[tuple[int, SceneRoom]]:
    """Return the rooms of a name; toilets without a name of their own are all toilets of the building."""
    if kind not in TOILETS or "_" in name:
        return finished.meant(name, kind)
    return [(floor, room) for floor, room in finished.rooms() if room.room_type in TOILETS or name in _labels(room)]


def _sides(wish: Wish, finished: _Finished) -> list[str]:
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


def _object(wish: Wish, finished: _Finished) -> str:
    counts = _things(wish, finished)
    wanted = 2 if wish.value.count is None else wish.value.count
    have = min(counts.values(), default=0) if wish.scope.each else sum(counts.values())
    if not (wish.value.type and counts and have >= wanted):
        return f"{have} of {wanted} are there"
    if wish.value.exact and wish.scope.room:
        named = _things(wish, finished, noun=wish.value.type.split("_")[-1]).values()
        there = max(named) if wish.scope.each else sum(named)
        if there > wanted:
            return f"{there} are there, more than {wanted}"
    return next((f"not as many are {word}" for word in wish.value.unheeded if not _are_so(wish, finished, word)), "")


def _are_so(wish: Wish, finished: _Finished, word: str) -> bool:
    """Whether enough of the things of a wish are as a word says; in every place where the count is for each."""
    scope = wish.scope
    rooms = {room.id for _, room in finished.meant(scope.room, scope.room_type, scope.floors)} if scope.room else None
    numbers: dict[str, list[bool]] = defaultdict(list)
    for scene in finished.scenes:
        for thing in scene.objects:
            here = thing.room in rooms if rooms is not None else _on(scene.floor, scope.floors)
            if here and wish.value.type and _called_so(thing.category, wish.value):
                place = (thing.room if scope.room else str(scene.floor)) if scope.each else ""
                numbers[place].append(has_quality(thing.category, thing.size, thing.material, word))
    wanted = 2 if wish.value.count is None else wish.value.count
    return all(sum(fitting) >= min(wanted, len(fitting)) for fitting in numbers.values())


def _no_object(wish: Wish, finished: _Finished) -> str:
    places = [place for place, count in _things(wish, finished).items() if count]
    return f"{places[0]} has one" if places else ""


def _things(wish: Wish, finished: _Finished, *, noun: str = "") -> dict[str, int]:
    """Return how many objects of the wish's category each place has: a room where one is named, a storey elsewhere.

    With a noun, those alone whose category ends in it.
    """
    scope = wish.scope
    placed: Counter[str] = Counter()
    for scene in finished.scenes:
        for thing in scene.objects:
            if noun and not (thing.category.split("_")[-1] == noun and answers(wish.value.type, thing.category)):
                continue
            if wish.value.type and _called_so(thing.category, wish.value):
                placed[thing.room] += seats_of_row(thing.category, thing.size[0])
    if scope.room:
        return {room.id: placed[room.id] for _, room in finished.meant(scope.room, scope.room_type, scope.floors)}
    return {
        f"storey {scene.floor}": sum(placed[room.id] for room in scene.rooms)
        for scene in finished.scenes
        if _on(scene.floor, scope.floors)
    }


def _called_so(category: str, value: WishValue) -> bool:
    """Whether a category is of a wish's kind, or of its noun where that kind is a special one of the noun."""
    if answers(value.type, category):
        return True
    noun = re.escape(category.split("_")[-1])
    return "_" in value.type and re.fullmatch(rf"{noun}(e?s)?", value.name) is not None


def _height(wish: Wish, finished: _Finished) -> str:
    heights = [room.ceiling_height for room in _of_type(wish, finished)]
    wanted = wish.value.height or 0.0
    if heights and all(abs(height - wanted) <= CEILING_TOLERANCE + 1e-6 for height in heights):
        return ""
    return f"ceilings are {min(heights):.2f} to {max(heights):.2f} m high" if heights else "there is no such room"


def _material(wish: Wish, finished: _Finished) -> str:
    surfaces = [
        room.wall_material if wish.value.type == "wall" else room.floor_material for room in _of_type(wish, finished)
    ]
    fitting = sum(_made_of(surface, wish.value.name) for surface in surfaces)
    return "" if 2 * fitting > len(surfaces) else f"{fitting} of {len(surfaces)} rooms have it"


def _made_of(surface: str, wanted: str) -> bool:
    """Whether one substance, or where no substance is wanted one colour, is in both texts."""
    here, there = (text.lower().replace("_", " ").replace("gray", "grey") for text in (surface, wanted))
    named = [pattern for pattern in SUBSTANCES if re.search(pattern, there)]
    if named:
        return any(re.search(pattern, here) for pattern in named)
    return any(re.search(rf"\b{re.escape(word)}\b", here) for word in there.split())


def _clutter(wish: Wish, finished: _Finished) -> str:
    own = {entry.scope.room_type for entry in finished.ledger if entry.kind == "clutter"} - {wish.scope.room_type}
    rooms = {room.id for room in _of_type(wish, finished) if room.room_type not in own}
    objects = [thing for scene in finished.scenes for thing in scene.objects if thing.room in rooms]
    carried = sum(1 for thing in objects if thing.parent)
    ground = sum(math.prod(thing.size[:2]) for thing in objects if thing.receptacle and not thing.parent)
    if not ground:
        return "nothing is there to lay things on"
    within = carried >= CLUTTERED * ground if wish.value.name == "dense" else carried <= TIDY * ground
    return "" if within else f"{carried} things lie on {ground:.1f} m2 of furniture"


def _of_type(wish: Wish, finished: _Finished) -> list[SceneRoom]:
    kind = wish.scope.room_type
    return [room for _, room in finished.rooms(wish.scope.floors) if not kind or room.room_type == kind]


def _occupants(wish: Wish, finished: _Finished) -> str:
    area = sum(room.area for _, room in finished.rooms())
    return "" if area >= PERSON * (wish.value.count or 1) else f"its rooms have {area:.0f} m2"


def _only(wish: Wish, finished: _Finished) -> str:
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
    "use": _use,
    "copy": _copy,
    "stair": _core,
    "elevator": _core,
    "room": _room,
    "no_room": _no_room,
    "adjacent": _adjacent,
    "apart": _apart,
    "object": _object,
    "no_object": _no_object,
    "height": _height,
    "material": _material,
    "clutter": _clutter,
    "occupants": _occupants,
    "only": _only,
}


def _labels(room: SceneRoom) -> set[str]:
    """Return what a room is called: its id, the same without a number, its name, its other names.

    The id of a room that is of another kind by now, and called otherwise, says nothing of it.
    """
    short = room.id.partition("/")[2]
    by_id = {short, re.sub(r"_\d+$", "", short)}
    spoken = {text.lower().replace(" ", "_") for text in (room.name, *room.aliases) if text}
    plain = {re.sub(r"[^a-z0-9]", "", text) for text in (*spoken, room.room_type)}
    apt = not room.name or any(re.sub(r"[^a-z0-9]", "", text) in plain for text in by_id)
    return spoken | by_id if apt else spoken


def _on(floor: int, floors: Sequence[int]) -> bool:
    return not floors or floor in floors
