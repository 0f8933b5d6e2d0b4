"""Judge what a reader states of a brief against the brief's facts, before anything is planned or built.

A fact counts as met when the statements alone meet it. Lists of facts are not complete, so a statement is judged only
where a fact of its kind speaks of the same thing: it is right when it agrees with the fact, wrong when it does not, and
unlisted when no fact speaks of it. Precision is taken over the judged statements.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from score_facts import STAIRS, Fact, close, counted, names

from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, FloorRef, RoomFact

__all__ = ["KINDS", "Score", "judge"]

KINDS = (
    "floors", "total_area", "floor_area", "building_type", "room", "room_area", "absent", "adjacent", "not_adjacent",
    "object", "vertical",
)  # fmt: skip
"""Kinds of facts that are scored; `floors_range` counts as `floors` and `room_areas` as `room_area`."""

_NAMED_STOREYS = {"bungalow": 1, "duplex": 2, "triplex": 3}
_AREAS = {"total_area": "area", "floor_area": "floor_area"}
Score = Counter[tuple[str, str]]
"""How often (kind, verdict) occurs; verdicts are ``facts``, ``met``, ``right``, ``wrong`` and ``unlisted``."""


@dataclass(frozen=True)
class _Rooms:
    """Rooms that a reading states: what they are called, how many on which storey (``None``: anywhere)."""

    text: str
    counts: Mapping[int | None, int]
    area: float | None
    uncounted: bool


class _Stated:
    """A reading with its storeys made numbers: 1 is the ground, 0 is below it."""

    def __init__(self, facts: BriefFacts) -> None:
        self.facts = facts
        self.storeys = self._storeys()
        self.rooms = [rooms for room in facts.rooms for rooms in self._rooms(room)]
        for use in facts.uses:
            floors = self.resolve(use.floors)
            text = f"{use.building_type} | {use.span.words}"
            self.rooms.append(_Rooms(text, dict.fromkeys(floors, use.count or 1), None, use.count is None))
        self.equal = [self.resolve((copy.first,)) for copy in facts.copies]

    def _storeys(self) -> int:
        facts = self.facts
        if facts.floors:
            return int(facts.floors[0].value)
        named = [_NAMED_STOREYS[word] for word, _ in facts.size if word in _NAMED_STOREYS]
        if named:
            return named[0]
        refs = [ref for room in facts.rooms for ref in room.floors]
        numbers = [ref.last for ref in refs if ref.kind in ("number", "range")]
        higher = 2 if any(ref.kind in ("upper", "top") for ref in refs) else 0
        middle = 3 if any(ref.kind == "middle" for ref in refs) else 0
        return max([higher, middle, *numbers])

    def resolve(self, refs: tuple[FloorRef, ...]) -> list[int]:
        """Return the numbers of the storeys that are meant."""
        top = max(self.storeys, 1)
        meant: set[int] = set()
        for ref in refs:
            meant |= {
                "number": lambda r: {r.first},
                "range": lambda r: set(range(r.first, r.last + 1)),
                "top": lambda r: set(range(top - max(r.first, 1) + 1, top + 1)),
                "below_top": lambda r: {top - max(r.first, 1)},
                "every": lambda r: set(range(1, top + 1)),
                "upper": lambda r: set(range(2, min(top, r.first + 1 if r.first else top) + 1)) or {2},
                "basement": lambda r: {0},
                "roof": lambda r: {top},
                "lower": lambda r: {1},
                "middle": lambda r: set(range(2, top)),
                "odd": lambda r: set(range(1, top + 1, 2)),
                "even": lambda r: set(range(2, top + 1, 2)),
                "not_top": lambda r: set(range(1, top)),
            }[ref.kind](ref)
        return sorted(meant)

    def _rooms(
        self, room: RoomFact, times: int = 1, floors: tuple[FloorRef, ...] = (), *, each: bool = False
    ) -> Iterator[_Rooms]:
        places = self.resolve(room.floors or floors)
        number = (2 if room.count is None else room.count) * times
        each = each or room.each or any(ref.kind == "every" for ref in room.floors)
        counts: dict[int | None, int] = {None: number}
        if places:
            share, rest = divmod(number, len(places))
            counts = {floor: number if each else share + (at < rest) for at, floor in enumerate(places)}
        elif self.storeys == 1:
            counts = {1: number}
        text = " | ".join((room.name, room.label, room.room_type))
        yield _Rooms(text, counts, room.area, room.count is None)
        for own in room.suite:
            yield from self._rooms(own, number, room.floors, each=each)

    def find(self, options: list[str]) -> list[_Rooms]:
        """Return the rooms that one of the phrases names."""
        return [rooms for rooms in self.rooms if names(rooms.text, options)]

    def number_of(self, options: list[str], floor: object) -> tuple[int, bool]:
        """Return how many such rooms are stated on a storey or in all, and whether the number is open."""
        found = self.find(options)
        if floor is None:
            return sum(sum(rooms.counts.values()) for rooms in found), any(rooms.uncounted for rooms in found)
        where = {"ground": 1, "top": max(self.storeys, 1), "basement": 0, "lowest": 0 if self.facts.basements else 1}
        wanted = max(int(where.get(str(floor), floor)), 0)  # type: ignore[call-overload]
        here = [rooms for rooms in found if wanted in rooms.counts]
        if not here:
            twins = {other for group in self.equal if wanted in group for other in group}
            other = next((f for f in sorted(twins) if any(f in rooms.counts for rooms in found)), None)
            wanted, here = other, [rooms for rooms in found if other is not None and other in rooms.counts]
        return sum(rooms.counts[wanted] for rooms in here), any(rooms.uncounted for rooms in here)  # type: ignore[index]

    def pairs(self, *, apart: bool) -> list[tuple[str, str]]:
        """Return the names of rooms that are stated to be side by side, or apart."""
        relations: list[AdjacencyFact] = self.facts.apart if apart else self.facts.adjacent
        found = [(f"{r.first} | {r.first_name}", f"{r.second} | {r.second_name}") for r in relations]
        if not apart:
            for room in self.facts.rooms:
                mine = f"{room.name} | {room.label} | {room.room_type}"
                found += [(mine, f"{own.name} | {own.label} | {own.room_type}") for own in room.suite]
        return found

    def excluded(self) -> list[str]:
        """Return what is stated to be unwanted, everywhere or on some storeys."""
        facts = self.facts
        return [
            *(f"{kind} | {span.words}" for kind, span in facts.excluded),
            *(f"{kind} | {span.words}" for kind, _, span in facts.excluded_on),
            *(kind.removeprefix("no_") for kind, _ in facts.vertical if kind.startswith("no_")),
        ]

    def vertical(self) -> set[str]:
        """Return the cores that are stated: ``stair``, ``elevator``, ``no_stair``, ``no_elevator``."""
        return {kind for kind, _ in self.facts.vertical}


def judge(reading: BriefFacts, facts: list[Fact]) -> tuple[Score, list[tuple[Fact, bool]]]:
    """Return the counts of verdicts, and for each fact whether the reading meets it."""
    stated = _Stated(reading)
    score: Score = Counter()
    verdicts = []
    for fact in facts:
        kind = {"floors_range": "floors", "room_areas": "room_area"}.get(fact["kind"], fact["kind"])
        if kind not in KINDS:
            continue
        ok = _met(fact, stated)
        verdicts.append((fact, ok))
        score[kind, "facts"] += 1
        score[kind, "met"] += ok
    for kind, verdict in _judged(stated, facts, verdicts):
        score[kind, verdict] += 1
    return score, verdicts


def _met(fact: Fact, stated: _Stated) -> bool:
    kind = fact["kind"]
    if kind in ("floors", "floors_range"):
        low, high = (fact["value"], fact["value"]) if kind == "floors" else (fact["min"], fact["max"])
        return bool(low <= stated.storeys <= high)
    if kind in _AREAS:
        given = [quantity.value for quantity in getattr(stated.facts, _AREAS[kind])[:1]]
        if kind == "total_area" and not given and stated.facts.floor_area:
            given = [stated.facts.floor_area[0].value * max(stated.storeys, 1)]
        return any(close(value, fact) for value in given)
    if kind == "building_type":
        return names(_building(stated), fact["any_of"])
    if kind == "room":
        return _room_met(fact, stated)
    if kind == "room_area":
        found = stated.find(fact["any_of"])
        return any(rooms.area is not None and close(rooms.area, fact) for rooms in found)
    if kind == "room_areas":
        have = sorted(rooms.area for rooms in stated.find(fact["any_of"]) if rooms.area is not None)
        want = sorted(fact["values"])
        slack = fact.get("tolerance", 0.1)
        return len(have) == len(want) and all(abs(x - y) <= slack * y for x, y in zip(have, want))
    if kind in ("adjacent", "not_adjacent"):
        return any(_joins(pair, fact) for pair in stated.pairs(apart=kind == "not_adjacent"))
    return _met_otherwise(fact, stated)


def _met_otherwise(fact: Fact, stated: _Stated) -> bool:
    """Go on from `_met`: what is unwanted, furniture, cores."""
    kind = fact["kind"]
    if kind == "absent":
        unwanted = any(names(text, fact["any_of"]) for text in stated.excluded()) or bool(stated.facts.only)
        stairs = set(fact["any_of"]) <= STAIRS and "no_stair" in stated.vertical()
        return stairs or (unwanted and not stated.find(fact["any_of"]))
    if kind == "object":
        return _object_met(fact, stated)
    has = stated.vertical()
    return {
        "stair": "stair" in has,
        "elevator": "elevator" in has and "no_elevator" not in has,
        "no_elevator": "no_elevator" in has,
        "stair_and_elevator": {"stair", "elevator"} <= has and "no_elevator" not in has,
    }[fact["value"]]


def _building(stated: _Stated) -> str:
    facts = stated.facts
    named = [f"{kind} | {span.words}" for kind, span in facts.building[:1]]
    return " | ".join([*named, facts.building_name, *(span.words for span in facts.building_span)])


def _room_met(fact: Fact, stated: _Stated) -> bool:
    number, open_number = stated.number_of(fact["any_of"], fact.get("floor"))
    if fact["count"] == 0:
        said = bool(stated.find(fact["any_of"])) or any(names(text, fact["any_of"]) for text in stated.excluded())
        return number == 0 and said
    return counted(number, fact["count"]) and not (open_number and isinstance(fact["count"], int))


def _object_met(fact: Fact, stated: _Stated) -> bool:
    things = [
        thing
        for thing in stated.facts.objects
        if names(f"{thing.words} | {thing.category}", fact["any_of"])
        and (not fact.get("room") or not thing.room or names(f"{thing.room} | {thing.room_type}", fact["room"]))
    ]
    wanted = [thing for thing in things if not thing.excluded and (thing.room or not fact.get("room"))]
    if fact["count"] == 0:
        return not wanted and bool(things)
    number = 0
    for thing in wanted:
        rooms = stated.number_of([thing.room], None)[0] if thing.room and thing.each else 1
        number += (2 if thing.count is None else thing.count) * max(rooms, 1)
    return counted(number, fact["count"])


def _joins(pair: tuple[str, str], fact: Fact) -> bool:
    return any(names(x, fact["a"]) and names(y, fact["b"]) for x, y in (pair, pair[::-1]))


def _judged(stated: _Stated, facts: list[Fact], verdicts: list[tuple[Fact, bool]]) -> Iterator[tuple[str, str]]:
    """Yield the kind of each statement and whether it is right, wrong or unlisted."""
    yield from _judged_wholes(stated, facts, verdicts)
    rooms = [(fact, ok) for fact, ok in verdicts if fact["kind"] in ("room", "absent")]
    for room in stated.rooms:
        near = [ok for fact, ok in rooms if names(room.text, fact["any_of"])]
        yield "room", _verdict(near)
        if room.area is not None:
            areas = [f for f in facts if f["kind"] in ("room_area", "room_areas") and names(room.text, f["any_of"])]
            yield "room_area", _verdict([_area_agrees(room.area, fact) for fact in areas])
    for apart, kind in ((False, "adjacent"), (True, "not_adjacent")):
        for pair in stated.pairs(apart=apart):
            hits = [f["kind"] == kind for f in facts if f["kind"] in ("adjacent", "not_adjacent") and _joins(pair, f)]
            yield kind, _verdict(hits)
    for text in stated.excluded():
        if text in ("stair", "elevator"):
            continue
        hits = [f["kind"] == "absent" or f["count"] == 0 for f, _ in rooms if names(text, f["any_of"])]
        yield "absent", _verdict(hits)
    things = [(fact, ok) for fact, ok in verdicts if fact["kind"] == "object"]
    for thing in stated.facts.objects:
        near = [ok for fact, ok in things if names(f"{thing.words} | {thing.category}", fact["any_of"])]
        yield "object", _verdict(near)


def _judged_wholes(stated: _Stated, facts: list[Fact], verdicts: list[tuple[Fact, bool]]) -> Iterator[tuple[str, str]]:
    """Yield the verdicts on what is stated of the whole building."""
    met = {kind: [ok for fact, ok in verdicts if fact["kind"] == kind] for kind in (*KINDS, "floors_range")}
    if stated.storeys:
        yield "floors", _verdict(met["floors"] + met["floors_range"])
    for kind, name in _AREAS.items():
        if getattr(stated.facts, name):
            others = [f for f in facts if f["kind"] in ("room_area", *_AREAS) and f["kind"] != kind]
            mistaken = any(close(getattr(stated.facts, name)[0].value, fact) for fact in others)
            yield kind, _verdict(met[kind] or ([False] if mistaken else []))
    if stated.facts.building or stated.facts.building_name:
        yield "building_type", _verdict(met["building_type"])
    cores = [fact["value"] for fact in facts if fact["kind"] == "vertical"]
    for core in sorted(stated.vertical()):
        opposite = core.removeprefix("no_") if core.startswith("no_") else f"no_{core}"
        agrees = [True for value in cores if core in (value, *(value.split("_and_")))]
        clashes = [False for value in cores if opposite in (value, *(value.split("_and_")))]
        yield "vertical", _verdict(agrees or clashes)


def _area_agrees(area: float, fact: Fact) -> bool:
    values = fact["values"] if fact["kind"] == "room_areas" else [fact["value"]]
    return any(abs(area - value) <= fact.get("tolerance", 0.1) * value for value in values)


def _verdict(hits: list[bool]) -> str:
    """A statement is right when it agrees with one fact that speaks of it."""
    return "unlisted" if not hits else "right" if any(hits) else "wrong"
