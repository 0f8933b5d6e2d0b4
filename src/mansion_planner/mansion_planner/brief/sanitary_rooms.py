"""Read what sanitary rooms hold and are for: "a bathroom with shower and toilet", wash rooms, rest rooms with beds."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["by_what_else_is_named", "read_washing_fittings"]

_BATHROOMS = frozenset(
    "bathroom ensuite_bathroom accessible_toilet toilet restroom master_bathroom childrens_washroom".split()
)
_FITTINGS = frozenset("shower bath toilet wc loo walk_in_shower shower_cubicle water_closet shower_area".split())
"""Names of rooms that are things where they stand in a bathroom."""
_LISTING = frozenset({":", "(", "-", "–", "="})
_HOLDING = frozenset("with has have having containing contain including include incl hold get".split())
_BESIDE = frozenset("of about approx each and it that which fitted equipped must should to , . ) m2".split())
"""Words between a bathroom and what leads to its fittings, besides its area."""
_JOINTS = frozenset({",", "and", "&", "plus", "+", "/", "also", "both"})
_FURTHEST = 6
"""Tokens between a bathroom and what leads to its fittings, at most."""


def read_washing_fittings(reading: Reading, phrases: list[Phrase]) -> None:
    """Make furniture of the fittings that are listed after a bathroom; of a room of its own they say so.

    After "with" a fitting that has an article and is not the first is a room as well: "a bathroom with a shower, a
    toilet and a kitchen".
    """
    _read_refused_baths(reading, phrases)
    for number, room in enumerate(phrases):
        if room.head != "room" or room.room_type not in _BATHROOMS:
            continue
        start, listed = _lead(reading, room)
        last = start
        for at in range(number + 1, len(phrases) if start else 0):
            thing = phrases[at]
            gap = set(reading.words(last, thing.first))
            if not gap <= (_JOINTS if at > number + 1 else {"also", "both"}) or thing.areas:
                break
            if thing.head == "room":
                own = thing.determiner and at > number + 1 and "," in gap and thing.name not in _WET
                category, _ = furniture_of(reading.words(thing.begin, thing.noun_end))
                fitting = thing.name in _FITTINGS or thing.name.endswith("_shower")
                if not fitting or not category or (own and not listed):
                    break
                phrases[at] = replace(thing, head="object", category=category, room_type="")
            elif thing.head != "object":
                break
            last = thing.last


def _read_refused_baths(reading: Reading, phrases: list[Phrase]) -> None:
    """Make a tub of "no bath" after a bathroom that is wanted: nobody refuses what was asked for just before."""
    for number, phrase in enumerate(phrases):
        refused = phrase.name == "bath" and phrase.head == "room" and not phrase.plural
        refused = refused and (phrase.determiner == "no" or reading.word(phrase.first - 1) in ("no", "without", "not"))
        before = any(other.room_type in _BATHROOMS and other.name != "bath" for other in phrases[:number])
        if refused and before:
            phrases[number] = replace(phrase, head="object", category="bathtub", room_type="")


_WET = frozenset({"shower", "bath", "walk_in_shower"})
"""Fittings that no house has a room for besides a bathroom."""


def _lead(reading: Reading, room: Phrase) -> tuple[int, bool]:
    """Return where the fittings of a bathroom begin, 0 for nowhere, and whether they are a list."""
    for at in range(room.last, room.last + _FURTHEST):
        word = reading.word(at)
        if word in _HOLDING:
            return at + 1, False
        if word in _LISTING and reading.kind(at + 1) != "number":
            return at + 1, word != "-" or reading.tokens[at].spaced
        passed = word in _BESIDE or reading.kind(at) in ("number", "unit")
        if reading.breaks(at) or not (passed or word == "("):
            return 0, False
    return 0, False


_TO_LIE_ON = frozenset({"bed", "single_bed", "hospital_bed", "bunk_bed", "sofa", "recliner", "armchair"})


def by_what_else_is_named(phrases: Sequence[Phrase]) -> list[Phrase]:
    """Return the phrases with the wash room beside a bath and a toilet as one to wash clothes and hands in.

    A rest room with beds is one to rest in, and no lavatory.
    """
    bath = any(phrase.room_type == "bathroom" and not _is_wash_room(phrase) for phrase in phrases)
    apart = bath and any(phrase.room_type == "toilet" for phrase in phrases)
    found: list[Phrase] = []
    for number, phrase in enumerate(phrases):
        following = phrases[number + 1] if number + 1 < len(phrases) else None
        beds = following is not None and following.category in _TO_LIE_ON and following.first - phrase.last <= 2
        if apart and _is_wash_room(phrase):
            found.append(replace(phrase, room_type="laundry_room", known=False))
        elif beds and phrase.head == "room" and phrase.room_type == "restroom" and phrase.name == "rest_room":
            found.append(replace(phrase, room_type="nap_room", known=True))
        else:
            found.append(phrase)
    return found


def _is_wash_room(phrase: Phrase) -> bool:
    return phrase.head == "room" and phrase.name in ("wash_room", "washroom")
