"""Read which furniture a brief wants, and in which room: "a fireplace in the living room", "each with two beds"."""

import itertools
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeAlias

from mansion_planner.brief.absences import is_nowhere_wanted
from mansion_planner.brief.facts import MaterialFact, ObjectFact
from mansion_planner.brief.furniture_words import special_kind, usually_in
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.relation_rooms import Relation
from mansion_planner.brief.room_seats import is_whole_building, places_for_people, sleeping_in_bunks
from mansion_planner.brief.some_rooms import some_rooms
from mansion_planner.brief.storey_attachment import Attachment
from mansion_planner.brief.table_seats import end_of_seats, seats_at_tables

__all__ = ["people_served", "read_furnishings"]

_INTO = frozenset(
    """
    in into inside within for per at to of
    """.split()
)
_OF = ("of",)
"""All that stands between rooms and what each of them has: "six dormitories of eight beds"."""
_EACH = frozenset({"each", "every", "all", "both", "any", "per", "either"})


def read_furnishings(
    reading: Reading,
    phrases: list[Phrase],
    attached: dict[int, Attachment],
    negated: dict[int, tuple[int, int]],
    same: dict[int, int],
    relations: Sequence[Relation] = (),
) -> list[ObjectFact]:
    """Return the wishes for furniture.

    Parameters
    ----------
    attached : dict of int to Attachment
        Storeys by phrase.
    negated : dict of int to (int, int)
        Phrases that are not wanted.
    same : dict of int to int
        Phrases that only name an earlier room again, and which.
    relations : sequence of Relation
        Which rooms lie beside which.
    """
    found = places_for_people(reading, phrases, negated)
    owners = _owners(reading, phrases, relations)
    for number, phrase in enumerate(phrases):
        if phrase.head != "object" or _passes_by(reading, phrases, number):
            continue
        if number not in negated and _covers_floor(reading, phrase, phrases[owners[number][0] or 0], owners[number]):
            continue
        named = [_named_owner(phrases, owner, same) for owner in _with_twin(phrases, owners[number])]
        for owner in _residents_rooms(reading, phrases, number, same) or named:
            placed = _placed_owner(reading, phrases, number, owner, negated)
            found.append(_furniture(reading, phrases, number, placed, attached, excluded=number in negated))
        seats = seats_at_tables(reading, phrases, number)
        if seats and number not in negated:
            last = end_of_seats(reading, phrases, number)
            span = reading.span(phrase.last, last)
            reading.take(phrase.last, last)
            seated = replace(found[-1], words=span.words, category="chair", span=span, count=seats, exact=False)
            found.append(replace(seated, noun="seats"))
    return sleeping_in_bunks(found)


def _with_twin(phrases: list[Phrase], owner: "_Owner") -> list["_Owner"]:
    """Return the owner of furniture, and before it the room for others that stands with it in one plural.

    In "locker rooms for men and women with thirty lockers each" the lockers are for either room.
    """
    room, each = owner
    twin = room - 1 if room else None
    if room is None or twin is None or not each:
        return [owner]
    one, other = phrases[twin], phrases[room]
    alike = one.head == other.head == "room" and one.room_type == other.room_type and one.name != other.name
    noun = one.name.partition("_")[2]
    split = noun and noun == other.name.partition("_")[2] and other.noun_end - other.begin == 1
    return [(twin, False), (room, False)] if alike and split else [owner]


def _covers_floor(reading: Reading, phrase: Phrase, room: Phrase, owner: "_Owner") -> bool:
    """Whether carpet is the floor of a room and not a thing in it, and state it: "the bedrooms, which have carpet"."""
    bare = not (phrase.determiner or phrase.counted or phrase.plural)
    floor = bare and phrase.category == "rug" and reading.words(phrase.begin, phrase.noun_end) == ("carpet",)
    if floor and owner[0] is not None and room.room_type:
        span = reading.span(phrase.first, phrase.last)
        reading.facts.materials.append(MaterialFact("floor", "carpet", room.room_type, span))
    return floor and owner[0] is not None and bool(room.room_type)


_Owner: TypeAlias = tuple[int | None, bool]
"""The phrase of the room that furniture is wanted in, and whether its number is for each such room."""


def _owners(reading: Reading, phrases: list[Phrase], relations: Sequence[Relation]) -> dict[int, _Owner]:
    """Return the owner of each piece of furniture, by the number of its phrase."""
    owners: dict[int, _Owner] = {}
    rooms = [
        n
        for n, phrase in enumerate(phrases)
        if phrase.head == "room"
        or (phrase.head == "building" and phrase.room_type and not is_whole_building(reading, phrase))
    ]
    for number in reversed(range(len(phrases))):
        if phrases[number].head == "object":
            owner = _shared_owner(reading, phrases, owners, number) or _owner(reading, phrases, rooms, number)
            owners[number] = _of_subject(reading, phrases, relations, owner, number)
    return owners


def _named_owner(phrases: list[Phrase], owner: _Owner, same: dict[int, int]) -> _Owner:
    """Return an owner as the phrase that names the room first: "a bedroom has a bed and a recliner"."""
    room, each = owner
    if room is None or room not in same:
        return owner
    generic = phrases[room].determiner in ("a", "an") and (phrases[same[room]].count or 2) > 1
    return same[room], each or generic


def _placed_owner(
    reading: Reading, phrases: list[Phrase], number: int, owner: _Owner, negated: dict[int, tuple[int, int]]
) -> _Owner:
    """Return an owner, or none where the room is not wanted, or where the furniture takes another's place in it."""
    room, each = owner
    if room is None:
        return owner
    listed = reading.word(phrases[room].last) in (",", "and", "or", "nor", ";")
    beside = reading.words(phrases[room].last, phrases[number].first) in ((",",), (",", "no"), (",", "without"))
    after = phrases[number + 1] if number + 1 < len(phrases) else None
    placed = (
        after is not None and after.head == "room" and _leads_into(reading.words(phrases[number].last, after.begin))
    )
    if number in negated and beside and not placed and phrases[room].last <= phrases[number].first:
        return None, False  # "herb store, no televisions"
    if room in negated and (number not in negated or listed):
        return None, each  # "excluded: a bar, televisions" are none of each
    replaced = number in negated and _replaced(reading, phrases, negated, number)
    if replaced or (number in negated and is_nowhere_wanted(reading, phrases[number])):
        return None, False
    return owner


def _furniture(
    reading: Reading,
    phrases: list[Phrase],
    number: int,
    owner: _Owner,
    attached: dict[int, Attachment],
    *,
    excluded: bool,
) -> ObjectFact:
    """Return the wish for the furniture of a phrase in the room that owns it."""
    phrase = phrases[number]
    room = phrases[owner[0]] if owner[0] is not None else None
    said = next((other for other in reversed(phrases[:number]) if other.head == "room"), None)
    again = said if room is not None and said is not None and said.room_type == room.room_type else room
    which = some_rooms(reading, room, again, phrase)
    some = which.many
    each = (owner[1] or (owner[0] in attached and attached[owner[0]].each)) and not some
    rows = _rows_of_many(reading, phrase)
    sets = _sets(reading, phrases, number)
    placed = attached.get(number) if room is None else None
    coloured = reading.word(phrase.last) == "in" and is_property(reading.word(phrase.last + 1), things=True)
    coloured = coloured and _ends_at(reading, phrase.last + 2)  # "a sofa in green"
    last = phrase.last + 2 * coloured if room is not None or coloured else _unread_place(reading, phrase)
    if last > phrase.last:
        reading.facts.unheeded.append(reading.span(phrase.last + coloured, last))
        reading.take(phrase.last, last)
    count = phrase.count and phrase.count * (some or 1)
    bare = reading.word(phrase.begin) if phrase.noun_end - phrase.begin == 1 and room is not None else ""
    return ObjectFact(
        words=phrase.label,
        category=special_kind(phrase.category, bare, room.room_type) if bare and room is not None else phrase.category,
        span=reading.span(phrase.first, last),
        count=rows or (count and count * sets if phrase.counted else people_served(reading, phrases, number) or count),
        room=room.name if room is not None else "",
        room_type=room.room_type if room is not None else "",
        each=(each and not (room is None and sets > 1)) or (placed is not None and placed.each),
        excluded=excluded,
        floors=placed.refs if placed is not None else (),
        noun=phrase.label,
        exact=phrase.counted and _NO_MORE.isdisjoint(reading.words(phrase.first, phrase.last)),
        most=phrase.counted and reading.word(phrase.first - 1) in ("only", "just", "exactly"),
        some=some,
        others=which.before,
        rows=rows,
    )


def _ends_at(reading: Reading, index: int) -> bool:
    """Whether an entry of a list or a sentence ends before a token."""
    return reading.breaks(index) or reading.word(index) in (",", "and", ")", ";", "or", "with")


def _residents_rooms(reading: Reading, phrases: list[Phrase], number: int, same: dict[int, int]) -> list[_Owner]:
    """Return the rooms of those whom a sentence is about: "Lily's room, Oskar's room. Each child has a desk"."""
    sentence = reading.sentence[phrases[number].first]
    subject = next((p for p in phrases[:number] if reading.sentence[p.first] == sentence), None)
    if subject is None or subject.head != "people" or subject.determiner not in ("each", "every"):
        return []
    return [
        (n, False)
        for n, p in enumerate(phrases[:number])
        if 0 < sentence - reading.sentence[p.first] <= _SENTENCES_BACK
        and p.label.endswith(("'s room", "’s room"))
        and n not in same
    ]


_SENTENCES_BACK = 2
"""Sentences between rooms and what is said of those who live in them, at most."""


def people_served(reading: Reading, phrases: list[Phrase], number: int) -> int:
    """Return how many people furniture in the plural is for, one piece each ("desks for 8 students"); 0 if unsaid."""
    phrase = phrases[number]
    after = phrases[number + 1] if number + 1 < len(phrases) else None
    one_each = phrase.head == "object" and phrase.plural and not phrase.counted and phrase.category in _ONE_EACH
    if after is None or not one_each or after.head != "people" or reading.words(phrase.last, after.first) != ("for",):
        return 0
    return (after.count or 0) if after.counted else 0


_ONE_EACH = frozenset({"desk", "workstation", "office_chair", "chair", "stool", "bed", "single_bed", "locker"})


def _sets(reading: Reading, phrases: list[Phrase], number: int) -> int:
    """Return of how many sets furniture is said: ten in "10 tables of four chairs", six in "6 rows of 10 desks"."""
    phrase = phrases[number]
    if phrase.counted and (rows := _rows_before(reading, phrase.first)):
        reading.take(phrase.first - 3, phrase.first)
        return rows
    if phrase.plural and not phrase.counted and _stands_in_rows(reading, phrase.first):
        reading.take(phrase.first - 2, phrase.first)
    before = phrases[number - 1] if number and phrase.counted else None
    if before is None or before.head != "object" or not before.counted or before.category == phrase.category:
        return 1
    gap = reading.words(before.last, phrase.first)
    shared = gap in (("of",), ("each", "with"), (",", "each", "with")) or (
        gap in (("with",), ("for",)) and reading.word(phrase.last) in ("each", "apiece")
    )
    return before.count or 1 if shared else 1


def _rows_of_many(reading: Reading, phrase: Phrase) -> int:
    """Return in how many rows things in the plural stand that are not counted: six in "6 rows of pallet racks"."""
    if phrase.counted or not phrase.plural or reading.word(phrase.first - 2) != "row":
        return 0
    rows = _rows_before(reading, phrase.first)
    if rows:
        reading.take(phrase.first - 3, phrase.first)
    return rows


def _rows_before(reading: Reading, index: int) -> int:
    """Return how many rows "6 rows of" before a token tells; 0 where it tells none."""
    noun = reading.word(index - 1) == "of" and reading.word(index - 2) in _ROWS
    counted = noun and reading.kind(index - 3) == "number" and 1 < reading.value(index - 3) <= _MOST_ROWS
    return int(reading.value(index - 3)) if counted else 0


def _stands_in_rows(reading: Reading, index: int) -> bool:
    """Whether "rows of" stands before a token: several of a thing, whatever their number."""
    return reading.word(index - 1) == "of" and reading.word(index - 2) == "row" and reading.plural(index - 2)


_ROWS = frozenset({"row", "group", "cluster", "island", "bank", "block", "set"})
"""Nouns for several pieces that stand together."""
_MOST_ROWS = 100


def _unread_place(reading: Reading, phrase: Phrase) -> int:
    """Return where a place that nobody knows ends right after furniture ("a stove in the main nook"), if one does."""
    index = phrase.last
    if reading.word(index) not in ("in", "on", "at", "by", "near", "under", "behind") or index in reading.taken:
        return index
    last = index + 1
    while not reading.breaks(last) and reading.kind(last) == "word" and last - index < 5 and last not in reading.taken:
        last += 1
    words = [reading.word(i) for i in range(index + 1, last)]
    if words == ["each"] and reading.word(index) == "in":
        return last  # in each of which rooms nobody says
    while words and (words[-1] in FUNCTION_WORDS or words[-1] in ("and", "or")):
        words.pop()
    return index + 1 + len(words) if any(word not in FUNCTION_WORDS for word in words) else index


_NO_MORE = frozenset({"least", "minimum", "min", "more", "less", "fewer"})
"""Words of a count that is a lower bound."""

_VEHICLES = frozenset({"van", "truck", "car", "garage_car", "bus", "motorcycle", "ambulance"})
_CARRIES = frozenset(", one of them which is for that carry carries carrying take takes taking to fit".split())
_ROOMY = frozenset("big large wide deep high long strong enough is be hold to".split())
_POINTS = frozenset({"the", "these", "those", "our", "my", "their", "his", "her", "your"})


_BROUGHT = {("come", "with"), ("arrive", "with"), ("travel", "with")}  # "visitors come with strollers"


def _passes_by(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether things are only spoken of: what a lift carries, "those are for the vehicles", "I said on the phone"."""
    phrase = phrases[number]
    before_it = reading.words(phrase.begin - 2, phrase.begin)
    if before_it in _BROUGHT or (phrase.category == "telephone" and before_it in (("on", "the"), ("over", "the"))):
        return True
    if before_it == ("with", "the") and "wall" in reading.words(phrase.begin - 4, phrase.begin):
        reading.taken.difference_update(range(phrase.first, phrase.last))
        return True  # "cells must not share a wall with the front desk"
    if reading.word(phrase.first - 1) == "for" and not phrase.counted:
        if phrase.determiner in _POINTS:
            return True
        if phrase.category in _VEHICLES:  # "an entrance for ambulances" is about who comes there
            reading.taken.difference_update(range(phrase.first, phrase.last))
            return True
    if phrase.category in ("wheelchair", "walker") and not phrase.counted:  # it is who uses one that the text speaks of
        reading.taken.difference_update(range(phrase.first, phrase.last))
        return True
    before = phrases[number - 1] if number else None
    if before is None or before.head not in ("elevator", "stair"):
        return False
    gap = reading.words(before.last, phrase.first)
    if "enough" in gap and set(gap) <= _CARRIES | _ROOMY:  # no lift is made larger: these words stay unread
        reading.taken.difference_update(range(phrase.first, phrase.last))
        return True
    carried = bool(gap) and set(gap) <= _CARRIES
    if carried and "one" in gap:
        reading.take(before.last, phrase.first)
    return carried


def _replaced(reading: Reading, phrases: list[Phrase], negated: dict[int, tuple[int, int]], number: int) -> bool:
    """Whether furniture is not wanted because the phrase before takes its place: "a shower instead of a bathtub"."""
    first = negated[number][0]
    return number > 0 and reading.words(first, first + 2) in (("instead", "of"), ("rather", "than"))


def _shared_owner(
    reading: Reading, phrases: list[Phrase], owners: dict[int, tuple[int | None, bool]], number: int
) -> tuple[int | None, bool] | None:
    """Return the room of the furniture that this one is joined to: "one desk and one wardrobe per bedroom"."""
    following = owners.get(number + 1)
    if following is None or following[0] is None or phrases[following[0]].first < phrases[number].first:
        return None
    if _led_by_room(reading, phrases, number):
        return None
    between = reading.words(phrases[number].last, phrases[number + 1].first)
    if set(between) == {","} and _shared_owner(reading, phrases, owners, number + 1) is None:
        return None  # "a fold-down desk, a washing machine in the bathroom" are entries of a list
    return following if set(between) <= {"and", ",", "&", "a", "an", "plus"} and between else None


def _of_subject(
    reading: Reading, phrases: list[Phrase], relations: Sequence[Relation], owner: tuple[int | None, bool], number: int
) -> tuple[int | None, bool]:
    """Return the room that a clause is about, where the nearest one only tells where it lies.

    "A kitchen beside the dining room and with an oven in it", "the office next to the archive has two desks".
    """
    room = owner[0]
    if room is None or phrases[room].last > phrases[number].first:
        return owner
    relation = next((r for r in relations if room in r.rights and not r.apart and r.last <= phrases[room].first), None)
    if relation is None or relation.lefts[-1] >= room or phrases[relation.lefts[-1]].last > relation.first:
        return owner
    if reading.sentence[phrases[room].first] != reading.sentence[phrases[number].first]:
        return owner
    gap = reading.words(phrases[room].last, phrases[number].first)
    if gap == (",",) and phrases[number].counted:
        return None, False  # "a cold store next to the docks, 20 pallet racks" is a list of what the building has
    inside = reading.words(phrases[number].last, phrases[number].last + 2) in (("in", "it"), ("inside", "it"))
    joined = gap[:2] == ("and", "with") or gap[:3] == (",", "and", "with") or gap[:1] in _HAS
    return (relation.lefts[-1], owner[1]) if inside or joined else owner


_HAS = (("has",), ("have",), ("contain",), ("hold",), ("get",), ("need",))


def _led_by_room(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a room has the furniture already: "a hall with five counters and two machines in the porch"."""
    before = phrases[number - 1] if number else None
    return (
        before is not None
        and before.head == "room"
        and reading.words(before.last, phrases[number].first) in (("with",), ("has",), ("have",))
    )


def _owner(reading: Reading, phrases: list[Phrase], rooms: list[int], number: int) -> tuple[int | None, bool]:
    """Return the room that furniture is wanted in, and whether its number is for each such room."""
    phrase = phrases[number]
    sentence = reading.sentence[phrase.first]
    after = next(
        (n for n in rooms if phrases[n].first >= phrase.last and reading.sentence[phrases[n].first] == sentence), None
    )
    if after is not None:
        gap = reading.words(phrase.last, phrases[after].begin)
        if len(gap) <= 6 and _leads_into(gap):
            lead = {*gap, phrases[after].determiner}
            several = phrases[after].plural and "the" not in lead and not _is_shared_out(phrase, phrases[after])
            return after, not _EACH.isdisjoint(lead) or several
    before = next(
        (
            n
            for n in reversed(rooms)
            if phrases[n].last <= phrase.first and reading.sentence[phrases[n].first] == sentence
        ),
        None,
    )
    if before is None:
        before = next(
            (
                n
                for n in reversed(rooms)
                if phrases[n].last <= phrase.first and reading.sentence[phrases[n].first] == sentence - 1
            ),
            None,
        )
        if before is None or not _continues(reading, phrase):
            return None, False
    holder = next((n for n in reversed(rooms) if n < before), None)
    if holder is not None and _is_of_holder(reading, phrases, holder, before, number):
        before = holder
    elif _is_own_entry(reading, phrases, before, number) or _is_beside_room(reading, phrases, before, number):
        return None, False
    else:
        before = _listed_with(reading, phrases, rooms, before, number)
    gap = reading.words(phrases[before].last, phrase.first)
    ahead = reading.words(max(phrases[before].first - 3, 0), phrases[before].first)
    if ("each", "of") in itertools.pairwise(ahead):
        return before, True  # "in each of the five bedrooms a wardrobe"
    each = not _EACH.isdisjoint(gap) or phrases[before].determiner in _EACH or _is_of_each(reading, phrases, number)
    return before, each or ((phrases[before].count or 2) > 1 and ("with" in gap or gap == _OF))


def _is_shared_out(thing: Phrase, rooms: Phrase) -> bool:
    """Whether a number of things is that of all rooms together: "36 workstations in three team areas"."""
    many, over = thing.count or 1, rooms.count or 1
    return thing.counted and rooms.counted and many >= 2 * over and many % over == 0


def _is_of_each(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether "each" closes furniture or what is joined to it: "one desk and one bookcase each"."""
    last = phrases[number].last
    for following in phrases[number + 1 :]:
        joint = reading.words(last, following.first)
        thing = following.head == "object" or (following.head == "room" and following.room_type in _WASHING)
        if not thing or not joint or not set(joint) <= {"and", ",", "a", "an", "&", "plus"}:
            break
        last = following.last
    return bool({"each", "apiece"} & set(reading.words(last, last + 2)))


def _is_own_entry(reading: Reading, phrases: list[Phrase], before: int, number: int) -> bool:
    """Whether furniture is an entry of a list beside a room: "a kitchen corner with fridge and stove, one desk"."""
    things = [phrase for phrase in phrases[before + 1 : number + 1] if phrase.head == "object"]
    first = things[0]
    last, thing = phrases[number - 1], phrases[number]
    apart = last.head == "object" and not last.determiner and not last.counted and thing.determiner in ("a", "an")
    if apart and reading.words(last.last, thing.first) == (",",):
        return True  # "a bathroom with shower, a bench"
    room, unusual = phrases[before], not usually_in(thing.category, phrases[before].room_type)
    led = thing.determiner in ("a", "an") or thing.counted
    if len(things) > 1 and unusual and led and _stands_alone(reading, phrases, number):
        return True  # "a spinning room with twenty bikes, a boxing ring, changing rooms"
    bare = not (room.determiner or first.determiner or room.counted or first.counted or first.plural)
    if bare and unusual and reading.words(room.last, first.first) == (",",):
        return True  # "guest toilet, cupboard under the stairs"
    listed = reading.words(phrases[before].last, first.first) == (",",) and not phrases[before].areas
    if listed and phrases[before].determiner in ("a", "an"):
        return first.determiner in ("a", "an") or first.counted  # "a kitchen corner, one bed and a desk"
    if len(things) < 3 or reading.words(phrases[before].last, first.first)[:1] != ("with",):
        return False
    pairs = itertools.pairwise(things[-12:-1])
    closed = any(reading.words(a.last, b.first)[:1] in (("and",), ("&",)) for a, b in pairs)
    return closed and reading.words(things[-2].last, phrases[number].first)[:1] == (",",)


def _stands_alone(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether commas alone stand between furniture and the things before and the room after it."""
    if number + 1 >= len(phrases) or phrases[number + 1].head != "room":
        return False
    before = reading.words(phrases[number - 1].last, phrases[number].first)
    after = reading.words(phrases[number].last, phrases[number + 1].begin)
    return before == (",",) and after[:1] == (",",)


def _is_beside_room(reading: Reading, phrases: list[Phrase], before: int, number: int) -> bool:
    """Whether furniture is named beside a room that it is not usual in: "long corridors and rows of desks"."""
    room, first = phrases[before], phrases[before + 1]
    if first.head != "object" or any(phrase.head != "object" for phrase in phrases[before + 1 : number + 1]):
        return False
    gap = [reading.word(at) for at in range(room.last, first.first) if at not in reading.taken]
    joined = gap[:1] in (["and"], ["&"], ["plus"]) and set(gap[1:]) <= {"row", "of", "a", "an"}
    return joined and not usually_in(phrases[number].category, room.room_type)


def _listed_with(reading: Reading, phrases: list[Phrase], rooms: list[int], before: int, number: int) -> int:
    """Return the room before furniture, or the one before that where the nearer is furniture too.

    In "every cell fitted with bunk, toilet and writing desk" the desk belongs to the cell, not to the toilet; in "a
    foyer with box office and popcorn counter" the counter is the foyer's.
    """
    earlier = [n for n in rooms if n < before]
    own = "own" in reading.words(phrases[before].first - 1, phrases[before].noun_end) or (
        phrases[before].determiner in ("own", "its")
    )
    gap = reading.words(phrases[before].last, phrases[number].first)
    if earlier and own and gap[:1] in ((",",), ("and",)) and set(gap) <= {",", "and", "a", "an"}:
        return earlier[-1]  # "each bedroom has its own wet room, a bed and a recliner"
    if earlier and own and phrases[number - 1].head == "object" and before < number - 1 and "with" not in gap:
        return earlier[-1]
    if not earlier or not 0 < before < number or phrases[before].determiner or phrases[before].counted:
        return before
    joined = reading.words(phrases[before].last, phrases[number].first) in (("and",), (",", "and"), (",",))
    listed = phrases[before - 1].head == "object" and reading.word(phrases[before].first - 1) in (",", "and")
    same = reading.sentence[phrases[earlier[-1]].first] == reading.sentence[phrases[number].first]
    within = before - 1 == earlier[-1] and reading.words(phrases[before - 1].last, phrases[before].begin) == ("with",)
    held = within and reading.words(phrases[before].last, phrases[number].begin) == ("and",)
    return earlier[-1] if same and ((joined and listed) or held) else before


def _is_of_holder(reading: Reading, phrases: list[Phrase], holder: int, inner: int, number: int) -> bool:
    """Whether furniture is listed beside a room that another one has: "a hall with a stage and a piano".

    In "each with a bathroom, two beds and a desk" the beds are no more in the bathroom; furniture that is usual in the
    inner room alone stays there.
    """
    outer, room, thing = phrases[holder], phrases[inner], phrases[number]
    things = phrases[inner + 1 : number + 1]
    if (
        not outer.room_type
        or any(phrase.head != "object" for phrase in things)
        or reading.knowledge.room(outer.room_type).unit
    ):
        return False
    between = (at for at in range(outer.last, room.begin) if reading.kind(at) not in ("number", "unit"))
    lead, joint = {reading.word(at) for at in between} - FLOOR_WORDS, reading.words(room.last, things[0].first)
    washing = outer.room_type == "changing_room" and room.room_type in _WASHING
    several = room.plural and not washing  # "changing rooms, each with two showers and eight lockers"
    if not lead & {"with", "has", "have"} or not lead <= _HAVING or room.determiner == "the" or several:
        return False
    listed = joint in (("and",), ("&",))
    if joint == (",",) and not _EACH.isdisjoint(lead):
        after = phrases[number + 1] if number + 1 < len(phrases) else None
        joints = [*itertools.pairwise(things), *([(thing, after)] if after is not None else [])]
        listed = any("and" in reading.words(one.last, other.first) for one, other in joints)
    if not listed:
        return False
    if room.room_type == "stage":
        return True  # it is a part of the hall
    return not (usually_in(thing.category, room.room_type) and outer.known) or usually_in(
        thing.category, outer.room_type
    )


_WASHING = frozenset({"shower_area", "toilet", "restroom"})
"""Rooms that stand in a list of what a changing room has."""
_HAVING = frozenset("with has have having a an one its own each every of on them ,".split())
"""Words between a room and one that it has, besides sizes and storeys."""


def _leads_into(gap: tuple[str, ...]) -> bool:
    """Whether the words between furniture and a room put the one into the other: "in the", "into each"."""
    return any(word in _INTO for word in gap) and not any(
        word in (",", "and", "with", ";", "next", "beside", "near", "from", "open", "opening", "close") for word in gap
    )


def _continues(reading: Reading, phrase: Phrase) -> bool:
    """Whether a sentence without a room goes on about the room before: "... a lounge. It has two sofas"."""
    index = phrase.first
    while index > 0 and reading.sentence[index - 1] == reading.sentence[phrase.first]:
        index -= 1
    return reading.word(index) in ("it", "there", "with", "put", "inside", "each", "all")
