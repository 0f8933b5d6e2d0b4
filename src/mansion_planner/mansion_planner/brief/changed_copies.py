"""Give a storey the rooms of another one that it differs from in part: "level 3 the same but with three offices"."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from mansion_planner.brief.facts import FloorRef, ObjectFact, RoomFact, Span
from mansion_planner.brief.reading import Place, Reading

__all__ = ["ChangedCopy", "find_changed_copies", "read_changed_copies"]

_LIKE = frozenset({"same", "identical", "like", "as", "repeat", "copy", "equal", "ditto", "similar"})
_CHANGES = frozenset({"but", "except", "plus", "with", "without", "save", "minus", "only", "additionally", "apart"})
_BETWEEN = frozenset(
    """
    the is are has have of a an again as to it that just exactly in plan layout programme rooms room below above one
    storey floor level before under on there we want and thing what
    """.split()
)
_MARKS = frozenset({",", ":", "-", "–", "("})
_MORE = frozenset({"additional", "extra", "another", "further", "more", "additionally"})
_REACH = 5


@dataclass(frozen=True)
class ChangedCopy:
    """A storey that is told to be like another one, changes aside.

    Attributes
    ----------
    base : int
        Number of the storey that it is like.
    first, last : int
        Tokens that say so, `last` exclusive: those up to the changes.
    end : int
        The token after the changes.
    """

    storey: FloorRef
    base: int
    first: int
    last: int
    end: int


def find_changed_copies(reading: Reading, places: list[Place]) -> list[ChangedCopy]:
    """Return such storeys; the other storey that each is told from is taken from `places`: it holds nothing here."""
    found: list[ChangedCopy] = []
    for index in range(len(reading.tokens)):
        copy = _copy_at(reading, places, index) if reading.word(index) in _LIKE else None
        if copy is None or any(copy.storey.first == other.storey.first for other in found):
            continue
        found.append(copy)
        reading.take(copy.first, copy.last)
        reading.differing.update(range(copy.first, copy.last))
        places[:] = [p for p in places if not copy.first < p.first < copy.last or p.first == copy.first]
    return found


def read_changed_copies(reading: Reading, copies: Sequence[ChangedCopy]) -> None:
    """State for such a storey the rooms and the furniture of the other one that its own statement does not replace."""
    for copy in copies:
        span = reading.span(copy.first, copy.last)
        _give_rooms(reading, copy, span)
        _give_furniture(reading, copy, span)


def _single(place: Place) -> bool:
    return len(place.refs) == 1 and place.refs[0].kind == "number"


def _copy_at(reading: Reading, places: Sequence[Place], index: int) -> ChangedCopy | None:
    """Return the storey that a word at a token tells to be like another one, but for what follows."""
    sentence = reading.sentence[index]
    here = [p for p in places if p.last <= index and reading.sentence[p.first] == sentence and _single(p)]
    if not here or not (index - here[-1].last <= _REACH or here[-1].heading):
        return None
    told = reading.words(here[-1].last, index)
    if not set(told) <= _BETWEEN | _LIKE | _MARKS:
        return None
    at, base = index + 1, 0
    while at < len(reading.tokens) and reading.word(at) not in _CHANGES:
        named = next((p for p in places if p.first <= at < p.last and _single(p)), None)
        if named is not None:
            base, at = named.refs[0].first, named.last
            continue
        again = _named_by_ordinal(reading, places, at)
        if again:
            base, at = again, at + 1
            continue
        if reading.word(at) not in _BETWEEN | _LIKE | _MARKS or reading.breaks(at):
            return None
        at += 1
    storey = here[-1].refs[0]
    if not base:
        before = [p for p in places if p.last <= here[-1].first and p.refs[-1].kind in ("number", "range")]
        base = before[-1].refs[-1].last if before else 0
    if at >= len(reading.tokens) or not base or base == storey.first:
        return None
    end = at
    while not reading.breaks(end):
        end += 1
    return ChangedCopy(FloorRef("number", storey.first, storey.first, storey.span), base, here[-1].first, at, end)


def _named_by_ordinal(reading: Reading, places: Sequence[Place], index: int) -> int:
    """Return the storey that "the second" at a token means, which was named with its noun before; 0 for none."""
    if reading.kind(index) != "ordinal":
        return 0
    named = [
        p for p in places
        if p.last <= index and _single(p) and reading.word(index) in reading.words(p.first, p.last)
    ]  # fmt: skip
    return named[-1].refs[0].first if named else 0


def _is_on(floors: tuple[FloorRef, ...], storey: int) -> bool:
    """Whether references mean one storey alone."""
    return len(floors) == 1 and floors[0].kind in ("number", "range") and floors[0].first == floors[0].last == storey


def _give_rooms(reading: Reading, copy: ChangedCopy, span: Span) -> None:
    """Add the rooms of the other storey that the statement has no other number of, and takes none of away."""
    facts = reading.facts
    own = [(n, room) for n, room in enumerate(facts.rooms) if _is_on(room.floors, copy.storey.first)]
    removed = {name for name, ref, _ in facts.excluded_on if ref.first == copy.storey.first}
    changes = (reading.tokens[copy.last].start, reading.tokens[copy.end - 1].end)
    removed |= {name for name, where in facts.excluded if changes[0] <= where.start < changes[1]}
    given: list[RoomFact] = []
    for room in [room for room in facts.rooms if _is_on(room.floors, copy.base)]:
        again = [(n, other) for n, other in own if other.name == room.name or other.room_type == room.room_type]
        if again:
            number, other = again[0]
            if _is_more(reading, other) and room.count is not None and other.count is not None:
                facts.rooms[number] = replace(other, count=room.count + other.count)
        elif room.room_type not in removed and room.name not in removed:
            given.append(replace(room, floors=(copy.storey,), span=span))
    facts.rooms += given
    for name in removed:
        facts.excluded[:] = [
            (other, where)
            for other, where in facts.excluded
            if other != name or not changes[0] <= where.start < changes[1]
        ]


def _is_more(reading: Reading, room: RoomFact) -> bool:
    """Whether a room is told as one more: "plus an additional archive"."""
    first = next((n for n, token in enumerate(reading.tokens) if token.start >= room.span.start), 0)
    return not _MORE.isdisjoint(reading.words(max(first - 2, 0), first + 2))


def _give_furniture(reading: Reading, copy: ChangedCopy, span: Span) -> None:
    """Add the furniture of rooms that both storeys have."""
    facts = reading.facts
    on_base = {room.name for room in facts.rooms if _is_on(room.floors, copy.base)}
    given: list[ObjectFact] = []
    for number, wanted in enumerate(facts.objects):
        told = _is_on(wanted.floors, copy.base) or (not wanted.floors and wanted.room in on_base)
        if not told or wanted.each or wanted.excluded:
            continue
        if not wanted.floors:
            facts.objects[number] = replace(
                wanted, floors=(FloorRef("number", copy.base, copy.base, copy.storey.span),)
            )
        own = any(
            other.category == wanted.category and _is_on(other.floors, copy.storey.first) for other in facts.objects
        )
        if not own:
            given.append(replace(wanted, floors=(copy.storey,), span=span))
    facts.objects += given
