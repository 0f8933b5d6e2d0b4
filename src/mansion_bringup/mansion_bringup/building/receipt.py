"""What became of every wish of a brief: derived from the plan, or from the finished floors where there are some."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise

import msgspec
import networkx as nx
from shapely.geometry import LineString, MultiLineString, Polygon

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.kinds import pieces
from mansion_bringup.building.outline_turns import TURNS, same_turns, turns_of
from mansion_bringup.building.substances import is_made_of
from mansion_bringup.building.usable_rooms import Equipment, equipment_of
from mansion_knowledge.object_kinds import answers
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.wishes import Wish, WishStatus
from mansion_scene.structure.floor_structure import ceiling_height

__all__ = ["receipt", "receipt_of_plan"]

_AREA = 0.1
"""Share by which an area may miss the one that is asked for and still meet it."""

_SHARED = 1.1
"""Metres of straight wall that neighbours share at least: a door and its frame, and a little."""

_CEILING = 0.1
"""Metres by which a ceiling may miss the height that is asked for and still meet it."""


@dataclass(frozen=True)
class _Room:
    """A room of a planned or finished floor."""

    floor: int
    id: str
    type: str
    names: frozenset[str]
    area: float
    height: float = 0.0
    surfaces: Mapping[str, str] = field(default_factory=dict)
    objects: Counter[str] = field(default_factory=Counter)
    object_ids: Mapping[str, Sequence[str]] = field(default_factory=dict)
    equipment: Equipment = field(default_factory=Equipment)

    @property
    def full_id(self) -> str:
        return f"F{self.floor}/{self.id}"


@dataclass(frozen=True)
class _State:
    """A building as far as its wishes go: rooms, and the pairs of their full ids that share a wall."""

    program: BuildingProgram
    rooms: Sequence[_Room]
    touching: frozenset[tuple[str, str]]
    doors: frozenset[tuple[str, str]] = frozenset()
    hubs: frozenset[str] = frozenset()

    def called(self, name: str, kind: str, floors: Sequence[int] = ()) -> list[_Room]:
        """Return the rooms of a name; where none has it, those of a type."""
        rooms = [room for room in self.rooms if not floors or room.floor in floors]
        own = [room for room in rooms if name in room.names]
        return own or [room for room in rooms if kind and room.type == kind]

    def behind(self, owner: _Room) -> list[_Room]:
        """Return the rooms of a storey that are reached through a room alone."""
        here = {room.full_id for room in self.rooms if room.floor == owner.floor}
        graph = nx.Graph(pair for pair in self.doors if pair[0].startswith(f"F{owner.floor}/"))
        graph.remove_nodes_from([owner.full_id])
        hubs = [hub for hub in self.hubs if hub in graph]
        reached = set().union(*(nx.node_connected_component(graph, hub) for hub in hubs))
        if not hubs:
            return []
        return [room for room in self.rooms if room.full_id in here - reached and room is not owner]

    @cached_property
    def private(self) -> frozenset[str]:
        """The rooms that the units of the brief have for themselves."""
        scopes = [wish.scope for wish in self.program.wishes if wish.scope.unit]
        owners = [owner for scope in scopes for owner in self.called(scope.unit, scope.unit_type, scope.floors)]
        return frozenset(room.full_id for owner in owners for room in self.behind(owner))

    def near(self, first: _Room, second: _Room) -> bool:
        """Whether two rooms share a wall."""
        return first is not second and (
            (first.full_id, second.full_id) in self.touching or (second.full_id, first.full_id) in self.touching
        )


def receipt(wishes: Iterable[Wish], program: BuildingProgram, scenes: Sequence[FloorScene]) -> list[Wish]:
    """Return the wishes with the status that the finished floors give them.

    Parameters
    ----------
    wishes : iterable of Wish
    program : BuildingProgram
    scenes : sequence of FloorScene
        All floors.
    """
    rooms = [_built_room(scene, number) for scene in scenes for number in range(len(scene.rooms))]
    state = _State(
        program,
        rooms,
        frozenset(pair for scene in scenes for pair in _touching(scene)),
        frozenset((door.rooms[0], door.rooms[1]) for scene in scenes for door in scene.doors if door.rooms[1]),
        frozenset(room.id for scene in scenes for room in scene.rooms if room.kind == "main"),
    )
    return [_judged(wish, state) for wish in wishes]


def receipt_of_plan(program: BuildingProgram, topologies: Sequence[FloorTopology]) -> list[Wish]:
    """Return a plan's wishes with the status that they are going to have if every later stage keeps to the plan."""
    rooms = [
        _Room(
            floor.index,
            room.id,
            room.room_type,
            _names(room.id, room.name, room.aliases),
            room.area_estimate,
            ceiling_height(floor.height),
            {"floor": room.floor_material, "wall": room.wall_material},
            Counter({entry.category: entry.count for entry in room.objects}),
        )
        for floor in program.floors
        for room in floor.rooms
    ]
    edges = frozenset(
        (f"F{graph.floor}/{edge.source}", f"F{graph.floor}/{edge.target}")
        for graph in topologies
        for edge in graph.edges
    )
    doors = frozenset(
        (f"F{graph.floor}/{edge.source}", f"F{graph.floor}/{edge.target}")
        for graph in topologies
        for edge in graph.edges
        if edge.kind == "access"
    )
    hubs = frozenset(f"F{graph.floor}/{node.id}" for graph in topologies for node in graph.nodes if node.type == "main")
    state = _State(program, rooms, edges, doors, hubs)
    return [_judged(wish, state) for wish in program.wishes]


def _names(identifier: str, name: str, aliases: Iterable[str]) -> frozenset[str]:
    stem, _, number = identifier.rpartition("_")
    plain = [identifier, *([stem] if number.isdigit() else []), name, *aliases]
    return frozenset(word.lower().replace(" ", "_") for word in plain if word)


def _built_names(short: str, room: SceneRoom) -> frozenset[str]:
    """Return what a finished room is called: its id too, unless an edit has made it a room of another kind."""
    own, spoken = _names(short, "", ()), _names("", room.name, room.aliases)
    told = {_letters(word) for word in (*spoken, room.room_type)}
    if room.name and told.isdisjoint(map(_letters, own)):
        return spoken
    return own | spoken


def _letters(word: str) -> str:
    return re.sub(r"[\W_]+", "", word)


def _built_room(scene: FloorScene, number: int) -> _Room:
    room = scene.rooms[number]
    short = room.id.removeprefix(f"F{scene.floor}/")
    things: dict[str, list[str]] = {}
    numbers: Counter[str] = Counter()
    objects = [entry for entry in scene.objects if entry.room == room.id]
    for entry in objects:
        things.setdefault(entry.category, []).append(entry.id)
        numbers[entry.category] += _pieces(entry)
    return _Room(
        scene.floor,
        short,
        room.room_type,
        _built_names(short, room),
        room.area,
        room.ceiling_height,
        {"floor": room.floor_material, "wall": room.wall_material},
        numbers,
        things,
        equipment_of(scene, room, objects),
    )


def _pieces(entry: SceneObject) -> int:
    """Return how many pieces an object is: the seats of a row of seats."""
    asset = load_catalogue().assets.get(entry.asset)
    return pieces(asset.category, asset) if asset is not None else 1


def _touching(scene: FloorScene) -> Iterable[tuple[str, str]]:
    """Yield the rooms that share enough straight wall for a door."""
    shapes = [(room.id, Polygon(room.polygon, room.holes)) for room in scene.rooms]
    for number, (first, shape) in enumerate(shapes):
        for second, other in shapes[number + 1 :]:
            if shape.distance(other) < 0.05 and _straight(shape, other) > _SHARED:
                yield first, second


def _straight(shape: Polygon, other: Polygon) -> float:
    """Return the length of the longest straight piece of a room's boundary that lies on another room."""
    beside = other.buffer(0.02, join_style="mitre")
    longest = 0.0
    for ring in (shape.exterior, *shape.interiors):
        corners = list(ring.simplify(0.001).coords)
        for edge in pairwise(corners):
            shared = LineString(edge).intersection(beside)
            pieces = shared.geoms if isinstance(shared, MultiLineString) else [shared]
            longest = max(longest, *(piece.length for piece in pieces))
    return longest


def _judged(wish: Wish, state: _State) -> Wish:
    if wish.kind == "unread":
        return msgspec.structs.replace(wish, status="not_understood")
    verdict = _JUDGES[wish.kind](wish, state)
    reason = verdict.reason
    if verdict.status != "not_met" and wish.reason and wish.kind in ("room", "building_type"):
        reason = f"{wish.reason}; {reason}" if reason else wish.reason
        verdict = _Verdict("partly", reason, verdict.rooms, verdict.objects)
    return msgspec.structs.replace(
        wish, status=verdict.status, reason=reason, rooms=list(verdict.rooms), objects=list(verdict.objects)
    )


@dataclass(frozen=True)
class _Verdict:
    status: WishStatus
    reason: str = ""
    rooms: Sequence[str] = ()
    objects: Sequence[str] = ()


def _met(ok: bool, reason: str, *, partly: bool = False, rooms: Sequence[str] = ()) -> _Verdict:
    return _Verdict("met", "", rooms) if ok else _Verdict("partly" if partly else "not_met", reason, rooms)


def _building_type(wish: Wish, state: _State) -> _Verdict:
    kind = wish.value.type or wish.value.name
    return _met(state.program.kind == kind, f"planned as {_words(state.program.kind)}")


def _floors(wish: Wish, state: _State) -> _Verdict:
    have = sum(floor.index >= 1 for floor in state.program.floors)
    return _met(have == wish.value.count, f"the building has {have} above ground")


def _basements(wish: Wish, state: _State) -> _Verdict:
    have = sum(floor.index < 1 for floor in state.program.floors)
    return _met(have == wish.value.count, f"the building has {have}")


def _total_area(wish: Wish, state: _State) -> _Verdict:
    wanted = wish.value.area or 0.0
    above = sum(floor.gross_floor_area for floor in state.program.floors if floor.index >= 1)
    whole = sum(floor.gross_floor_area for floor in state.program.floors)
    off = min(abs(above - wanted), abs(whole - wanted)) / max(wanted, 1.0)
    return _met(off <= _AREA, f"the building has {whole:.0f} m2", partly=off <= 2 * _AREA)


def _floor_area(wish: Wish, state: _State) -> _Verdict:
    wanted = wish.value.area or 0.0
    areas = sorted(floor.gross_floor_area for floor in state.program.floors if floor.index >= 1)
    have = areas[len(areas) // 2]
    off = abs(have - wanted) / max(wanted, 1.0)
    return _met(off <= _AREA, f"a storey has {have:.0f} m2", partly=off <= 2 * _AREA)


def _outline(wish: Wish, state: _State) -> _Verdict:
    ground = next((floor for floor in state.program.floors if floor.index == 1), state.program.floors[0])
    turns, name = turns_of(ground.outline), wish.value.name
    if name == "courtyard":
        return _met(
            bool(ground.holes) or same_turns(turns, TURNS["U"]),
            f"the outline has {len(turns)} corners and no courtyard",
        )
    ok = not ground.holes and same_turns(turns, TURNS.get(name, "LLLL"))
    if name == "square" and ok:
        xs, ys = [x for x, _ in ground.outline], [y for _, y in ground.outline]
        ok = 0.9 <= (max(xs) - min(xs)) / max(max(ys) - min(ys), 0.1) <= 1.1
    others = [form for form, word in TURNS.items() if same_turns(turns, word)]
    return _met(ok, f"the outline is {others[0]}-shaped" if others else f"the outline has {len(turns)} corners")


def _style(wish: Wish, state: _State) -> _Verdict:
    return _met(state.program.style == wish.value.name, f"the style is {_words(state.program.style)}")


def _use(wish: Wish, state: _State) -> _Verdict:
    words = rf"\b{re.escape(_words(wish.value.name))}\b"
    uses = {floor.index: floor.requirement.split(":")[0] for floor in state.program.floors}
    missing = [floor for floor in wish.scope.floors if not re.search(words, uses.get(floor, ""))]
    ok = bool(wish.scope.floors) and not missing
    return _met(ok, f"storey {_listed(missing)} has another use", partly=0 < len(missing) < len(wish.scope.floors))


def _copy(wish: Wish, state: _State) -> _Verdict:
    group = [floor for floor in state.program.floors if floor.index in wish.scope.floors]
    originals = {floor.index if floor.copy is None else floor.copy for floor in group}
    if len(group) < 2:
        return _Verdict("not_met", "there are not two such storeys")
    return _met(len(originals) == 1, "the storeys differ", partly=len(originals) < len(group))


def _core(wish: Wish, state: _State) -> _Verdict:
    have = sum(core.type == wish.kind for core in state.program.vertical_connectivity.cores)
    noun = "stair" if wish.kind == "stair" else "lift"
    if wish.value.unwanted:
        return _met(have == 0, f"the building has a {noun}: its storeys cannot be reached otherwise")
    if wish.value.count is None or have >= wish.value.count:
        storeys = sum(floor.index >= 1 for floor in state.program.floors)
        return _met(have > 0, "one storey needs none" if storeys == 1 else f"there is no {noun}")
    return _Verdict("partly" if have else "not_met", f"{have} of {wish.value.count} {noun}s have a place")


def _room(wish: Wish, state: _State) -> _Verdict:
    value, floors = wish.value, wish.scope.floors
    if wish.scope.unit:
        return _held(wish, state)
    rooms = state.called(value.name, value.type, floors)
    rooms = [room for room in rooms if room.full_id not in state.private] or rooms
    if value.whole:
        rooms = [replace(room, area=room.area + sum(other.area for other in state.behind(room))) for room in rooms]
    ids = [room.full_id for room in rooms]
    if not rooms:
        elsewhere = state.called(value.name, value.type)
        if elsewhere:
            where = _listed(sorted({room.floor for room in elsewhere}))
            return _Verdict("partly", f"on storey {where} instead", [room.full_id for room in elsewhere])
        return _Verdict("not_met", "no room of this kind found a place")
    wanted = _wanted(wish, state)
    if wish.scope.each and floors:
        counts = Counter(room.floor for room in rooms)
        short = [floor for floor in floors if counts[floor] != (value.count or max(counts[floor], 1))]
        if short:
            return _Verdict("partly", f"storey {_listed(short)} has {_listed([counts[f] for f in short])}", ids)
    elif wanted is None and len(rooms) < 2:
        return _Verdict("partly", "one room where several are asked for", ids)
    elif wanted is not None and len(rooms) != wanted:
        return _Verdict("partly", f"{len(rooms)} of {wanted}", ids)
    owners = state.called(wish.scope.room, wish.scope.room_type, floors) if wish.scope.room else []
    bare = [owner.full_id for owner in owners if not any(state.near(owner, room) for room in rooms)]
    if bare:
        return _Verdict("partly", f"{_listed(bare[:3])} has none beside it", ids)
    if value.area is not None:
        close = [room for room in rooms if _close(room.area, value.area)]
        if len(close) < min(_of_that_area(wish, state, len(rooms)), len(rooms)):
            sizes = ", ".join(f"{room.area:.0f}" for room in rooms[:4])
            return _Verdict("partly", f"{sizes} m2 instead of {value.area:.0f} m2", ids)
    lack = _unusable(rooms, state)
    return _met(not lack, lack, partly=True, rooms=ids)


def _unusable(rooms: Sequence[_Room], state: _State) -> str:
    """Say what the first rooms that cannot be used have not; empty where all can."""
    lacks = [(room.full_id, room.equipment.lack(_unwanted_in(room, state))) for room in rooms]
    return "; ".join(f"{name} {lack}" for name, lack in [entry for entry in lacks if entry[1]][:2])


def _unwanted_in(room: _Room, state: _State) -> list[str]:
    """Return the categories of which the brief wants none in a room."""
    wishes = [wish for wish in state.program.wishes if wish.kind == "no_object" and wish.value.type]
    return [wish.value.type for wish in wishes if room in _object_rooms(wish, state)]


def _held(wish: Wish, state: _State) -> _Verdict:
    """Judge what each flat or other unit is to hold: the room itself and those behind it count."""
    owners = state.called(wish.scope.unit, wish.scope.unit_type, wish.scope.floors)
    if not owners:
        return _Verdict("not_met", f"there is no {_words(wish.scope.unit)}")
    wanted, ids, other, small = _wanted(wish, state), [], [], []
    for owner in owners:
        there = [owner, *state.behind(owner)]
        rooms = [room for room in there if wish.value.name in room.names]
        rooms = rooms or [room for room in there if room.type == wish.value.type]
        ids += [room.full_id for room in rooms]
        if len(rooms) != wanted and (wanted is not None or len(rooms) < 2):
            other.append(f"{owner.full_id} has {len(rooms)}")
        close = [room for room in rooms if _close(room.area, wish.value.area)]
        needed = len(rooms) if len(_alike(wish, state)) < 2 else min(wish.value.count or 1, len(rooms))
        if len(close) < needed:
            small.append(f"{owner.full_id} has {_listed([f'{room.area:.0f}' for room in rooms])} m2")
    if other:
        return _Verdict("partly" if ids else "not_met", _listed(other[:3]), ids)
    held = [room for room in state.rooms if room.full_id in ids]
    bare = _listed(small[:3]) or _unusable(held, state)
    return _met(not bare, bare, partly=True, rooms=ids)


def _close(area: float, wanted: float | None) -> bool:
    """Whether a room has the area that is asked for, if any is."""
    return wanted is None or abs(area - wanted) <= _AREA * 1.5 * wanted


def _wanted(wish: Wish, state: _State) -> int | None:
    """How many rooms of the name the brief wants in the wish's scope, over all wishes that share both."""
    counts = [other.value.count for other in _alike(wish, state)]
    return None if any(count is None for count in counts) else sum(count or 0 for count in counts)


def _of_that_area(wish: Wish, state: _State, there: int) -> int:
    """How many rooms are to have the wish's area: all of the name, or its share where several wishes ask for some."""
    if len(_alike(wish, state)) < 2:
        return there
    storeys = len(wish.scope.floors) if wish.scope.each and wish.scope.floors else 1
    return (wish.value.count or 1) * storeys


def _alike(wish: Wish, state: _State) -> list[Wish]:
    return [
        other
        for other in state.program.wishes
        if other.kind == "room"
        and other.value.name == wish.value.name
        and (other.scope.floors, other.scope.unit) == (wish.scope.floors, wish.scope.unit)
    ]


def _no_room(wish: Wish, state: _State) -> _Verdict:
    if wish.value.type == "basement":
        return _met(all(floor.index >= 1 for floor in state.program.floors), "the building has a basement")
    rooms = [
        room
        for room in state.rooms
        if room.type == wish.value.type and (not wish.scope.floors or room.floor in wish.scope.floors)
    ]
    return _met(not rooms, f"{rooms[0].full_id if rooms else ''} is one", rooms=[room.full_id for room in rooms])


def _adjacent(wish: Wish, state: _State) -> _Verdict:
    firsts, seconds = (
        state.called(name, kind)
        for name, kind in ((wish.value.name, wish.value.type), (wish.value.other, wish.value.other_type))
    )
    pairs = [(a, b) for a in firsts for b in seconds if state.near(a, b)]
    ids = [room.full_id for pair in pairs[:1] for room in pair]
    if not firsts or not seconds:
        return _Verdict("not_met", f"there is no {_words(wish.value.name if not firsts else wish.value.other)}")
    same = any(a.floor == b.floor for a in firsts for b in seconds)
    return _met(bool(pairs), "they share no wall" if same else "they are on different storeys", rooms=ids)


def _apart(wish: Wish, state: _State) -> _Verdict:
    firsts, seconds = (
        state.called(name, kind)
        for name, kind in ((wish.value.name, wish.value.type), (wish.value.other, wish.value.other_type))
    )
    pairs = [(a, b) for a in firsts for b in seconds if state.near(a, b)]
    ids = [room.full_id for pair in pairs[:1] for room in pair]
    both = f"{_words(wish.value.name)} and {_words(wish.value.other)}"
    return _met(not pairs, f"{both} share a wall", rooms=ids)


def _object(wish: Wish, state: _State) -> _Verdict:
    if not wish.value.type:
        return _Verdict("not_met", "the catalogue has nothing of this kind")
    rooms = _object_rooms(wish, state)
    if not rooms:
        return _Verdict("not_met", f"there is no {_words(wish.scope.room)}")
    counts: Counter[object] = Counter()
    for room in rooms:
        counts[room.full_id if wish.scope.room else room.floor] += _count(wish, room)
    having = [room for room in rooms if _count(wish, room)]
    found = [name for room in having for kind, names in room.object_ids.items() if _is(kind, wish) for name in names]
    wanted = wish.value.count if wish.value.count is not None else 2
    least = min(counts.values()) if wish.scope.each else counts.total()
    status: WishStatus = "met" if least >= wanted else "partly" if having else "not_met"
    where = f" in a {'room' if wish.scope.room else 'storey'}" if wish.scope.each else ""
    reason = "" if status == "met" else f"{least} of {wanted} found a place{where}"
    most = _of_that_noun(wish, having) if wish.value.exact and wish.scope.room else 0
    if status == "met" and most > wanted:
        status, reason = "partly", f"{most} instead of {wanted} are there{where}"
    return _Verdict(status, reason, [room.full_id for room in having], found)


def _of_that_noun(wish: Wish, rooms: Sequence[_Room]) -> int:
    """Return how many objects are called by the wish's noun: in all rooms, or the most in one for a count of each."""
    noun = wish.value.type.rpartition("_")[2]
    counts = [
        sum(n for category, n in room.objects.items() if _is(category, wish) and category.rpartition("_")[2] == noun)
        for room in rooms
    ]
    return max(counts, default=0) if wish.scope.each else sum(counts)


def _no_object(wish: Wish, state: _State) -> _Verdict:
    rooms = [room for room in _object_rooms(wish, state) if _count(wish, room)]
    return _met(not rooms, f"{rooms[0].full_id if rooms else ''} has one", rooms=[room.full_id for room in rooms])


def _count(wish: Wish, room: _Room) -> int:
    return sum(count for category, count in room.objects.items() if _is(category, wish))


def _is(category: str, wish: Wish) -> bool:
    """Whether objects of a category are what a wish calls so: an office desk is a desk, a reading table a table."""
    kind, name = wish.value.type, wish.value.name
    if not kind:
        return False
    last = category.rpartition("_")[2]
    return answers(kind, category) or category.endswith(f"_{kind}") or name in (last, f"{last}s", f"{last}es")


def _object_rooms(wish: Wish, state: _State) -> list[_Room]:
    if wish.scope.room:
        return state.called(wish.scope.room, wish.scope.room_type, wish.scope.floors)
    return [room for room in state.rooms if not wish.scope.floors or room.floor in wish.scope.floors]


def _height(wish: Wish, state: _State) -> _Verdict:
    wanted = wish.value.height or 0.0
    heights = [room.height for room in _of_type(wish, state)]
    if not heights:
        return _Verdict("not_met", f"there is no {_words(wish.scope.room_type) or 'room'}")
    good = [height for height in heights if abs(height - wanted) <= _CEILING + 1e-6]
    low, high = f"{min(heights):.2f}", f"{max(heights):.2f}"
    have = low if low == high else f"{low} to {high}"
    return _met(len(good) == len(heights), f"ceilings are {have} m high", partly=bool(good))


def _material(wish: Wish, state: _State) -> _Verdict:
    rooms = _of_type(wish, state)
    surface = "wall" if wish.value.type == "wall" else "floor"
    have = [room for room in rooms if is_made_of(room.surfaces[surface], wish.value.name)]
    return _met(2 * len(have) > len(rooms), "most rooms have another material", partly=bool(have))


def _of_type(wish: Wish, state: _State) -> list[_Room]:
    """Return the rooms of the wish's storeys that have its room type; all where it names none."""
    kind, floors = wish.scope.room_type, wish.scope.floors
    return [room for room in state.rooms if kind in ("", room.type) and (not floors or room.floor in floors)]


def _occupants(wish: Wish, state: _State) -> _Verdict:
    count = wish.value.count or 1
    area = sum(room.area for room in state.rooms)
    return _met(area >= 2.0 * count, f"{area:.0f} m2 of rooms are little for {count} people")


def _only(wish: Wish, state: _State) -> _Verdict:
    named = {w.value.type for w in state.program.wishes if w.kind == "room"} | {
        "corridor",
        "hallway",
        "lobby",
        "stair",
        "elevator",
    }
    extra = [room.full_id for room in state.rooms if room.type not in named]
    return _met(not extra, f"{_listed(extra[:3])} were added", rooms=extra)


_JUDGES = {
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
    "occupants": _occupants,
    "only": _only,
}


def _words(name: str) -> str:
    return name.replace("_", " ")


def _listed(values: Sequence[object]) -> str:
    return ", ".join(str(value) for value in values)
