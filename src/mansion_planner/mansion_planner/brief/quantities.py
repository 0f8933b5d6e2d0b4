"""Read the numbers of a brief: storeys, basements, areas and occupants."""

from mansion_planner.brief.facts import FloorRef, OccupantFact, Quantity, Span, UseFact
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["AREA_UNITS", "area_at", "read_areas", "read_floor_counts", "read_occupants"]

SQUARE_FOOT = 0.09290304
"""Square metres in a square foot, exactly."""

AREA_UNITS = {"m2": 1.0, "m²": 1.0, "m^2": 1.0, "sqm": 1.0, "sm": 1.0,
              "ft2": SQUARE_FOOT, "ft²": SQUARE_FOOT, "sqft": SQUARE_FOOT, "sf": SQUARE_FOOT}  # fmt: skip
_METRES = frozenset({"m", "metre", "meter", "mt", "mtr"})
_FEET = frozenset({"ft", "foot", "feet"})

_STOREY_ADJECTIVES = frozenset(
    {"full", "whole", "habitable", "residential", "office", "guest", "typical", "upper", "additional",
     "more", "storied", "underground", "basement", "parking", "subterranean", "identical", "main", "above",
     "equal", "different", "separate", "small", "large", "big", "classroom", "hotel", "retail"}
)  # fmt: skip
_BELOW = frozenset({"underground", "basement", "subterranean", "below"})
_NAMED = {"duplex": 2, "triplex": 3, "bungalow": 1}
_PEOPLE = frozenset(
    [
        "people",
        "person",
        "resident",
        "occupant",
        "pupil",
        "student",
        "child",
        "employee",
        "worker",
        "guest",
        "patient",
        "adult",
        "inhabitant",
        "staff",
        "bed",
        "teacher",
        "kid",
        "user",
        "visitor",
        "elderly",
        "tenant",
        "inmate",
        "firefighter",
        "officer",
        "diner",
        "seat",
        "roommate",
        "friend",
        "desk",
        "colleague",
        "developer",
        "lodger",
    ]
)


def read_floor_counts(reading: Reading) -> None:
    """Read how many storeys and basements there are to be."""
    for index in range(len(reading.tokens)):
        _floor_count_at(reading, index)
        _named_count_at(reading, index)
    facts = reading.facts
    basement = [i for i in range(len(reading.tokens)) if reading.word(i) in ("basement", "cellar")]
    basement = [i for i in basement if i not in reading.taken and not _negated(reading, i)]
    if not facts.basements and basement:
        facts.basements.append(Quantity(1.0, reading.span(basement[0], basement[0] + 1)))


def _negated(reading: Reading, index: int) -> bool:
    return any(reading.word(index - back) in ("no", "without", "not") for back in (1, 2, 3))


def _floor_count_at(reading: Reading, index: int) -> None:
    if reading.kind(index) != "number" or index in reading.taken:
        return
    if reading.word(index - 1) in (
        "top",
        "first",
        "last",
        "bottom",
        "lower",
        "upper",
        "remaining",
        "other",
    ):
        return
    value = reading.tokens[index].value
    last = index + 1
    if reading.word(last) in ("and", "to", "or", "–") and reading.kind(last + 1) == "number":
        value, last = _range(value, reading.tokens[last + 1].value), last + 2
    elif reading.kind(last) == "number" and reading.word(last + 1) in FLOOR_WORDS:
        value, last = _range(value, reading.tokens[last].value), last + 1
    if reading.word(index - 1) in ("and", "to", "or", "–") and reading.kind(index - 2) == "number":
        return
    adjectives: list[str] = []
    while reading.word(last) in _STOREY_ADJECTIVES and len(adjectives) < 2:
        adjectives.append(reading.word(last))
        last += 1
    if reading.word(last) not in FLOOR_WORDS or value != int(value):
        return
    if reading.word(index - 1) in FLOOR_WORDS and reading.kind(last) == "word":
        return
    last += 1
    if reading.word(last) in ("height", "high"):
        last += 1
    below = bool(_BELOW & set(adjectives)) or (
        reading.word(last) in ("below", "underground", "under") and reading.word(last + 1) != "the"
    )
    span = reading.span(index, last)
    if below:
        reading.facts.basements.append(Quantity(value, span))
    elif reading.word(last) == "of" and _use_of_storeys(reading, index, last, int(value)):
        return
    elif "upper" in adjectives or "additional" in adjectives or "more" in adjectives:
        reading.facts.floors.append(Quantity(value + 1, span))
    else:
        reading.facts.floors.append(Quantity(value, span))
    reading.take(index, last)


def _range(low: float, high: float) -> float:
    return float(int((low + high) / 2)) if low < high else high


def _use_of_storeys(reading: Reading, index: int, last: int, count: int) -> bool:
    """Read "three floors of apartments" as a use of storeys, whatever the building's total is."""
    mention = next(
        (reading.mention_at[i] for i in (last + 1, last + 2) if i in reading.mention_at), None
    )
    if mention is None or not mention.building:
        return mention is not None
    name = "apartment_building" if mention.building == "flat" else mention.building
    floors: tuple[FloorRef, ...] = ()
    if any(
        reading.word(i) in ("above", "over", "on", "atop")
        for i in range(mention.last, mention.last + 2)
    ):
        floors = (FloorRef("range", 2, count + 1, reading.span(index, mention.last)),)
    reading.facts.uses.append(UseFact(name, floors, reading.span(index, mention.last), count))
    reading.take(index, mention.last)
    return True


def _named_count_at(reading: Reading, index: int) -> None:
    word = reading.word(index)
    span = reading.span(index, index + 1)
    if word in _NAMED and index not in reading.taken:
        reading.facts.size.append((word, span))
    elif word in ("high", "mid", "low") and reading.word(index + 1) in ("rise", "riser"):
        reading.facts.size.append((f"{word}_rise", reading.span(index, index + 2)))
        reading.take(index, index + 2)
    elif word in ("highrise", "midrise", "lowrise"):
        reading.facts.size.append((f"{word[:-4]}_rise", span))
    elif word in ("skyscraper", "tower"):
        reading.facts.size.append(("high_rise", span))
    elif (
        word == "g"
        and reading.word(index + 1) in ("+", "plus")
        and reading.kind(index + 2) == "number"
    ):
        value = reading.tokens[index + 2].value + 1
        reading.facts.floors.append(Quantity(value, reading.span(index, index + 3)))
        reading.take(index, index + 3)
    elif word in ("small", "compact", "tiny", "little", "modest", "mini"):
        reading.facts.size.append(("small", span))
    elif word in ("large", "big", "spacious", "huge", "vast", "generous", "giant", "sprawling"):
        reading.facts.size.append(("large", span))


def area_at(reading: Reading, index: int) -> tuple[float, int] | None:
    """Return the area that starts at token `index` in square metres, and the token after it."""
    if reading.kind(index) != "number" or reading.tokens[index].value <= 0:
        return None
    value, last = reading.tokens[index].value, index + 1
    sides = _sides_at(reading, index)
    if sides is not None:
        return sides
    word, following = reading.word(last), reading.word(last + 1)
    if word == "k" and following in AREA_UNITS:
        value, word, following, last = value * 1000, following, reading.word(last + 2), last + 1
    if word in AREA_UNITS:
        return value * AREA_UNITS[word], last + 1
    if word in ("square", "sq"):
        last += 1 + (reading.word(last + 1) == ".")
        unit = reading.word(last)
        if unit in _METRES:
            return value, last + 1
        if unit in _FEET:
            return value * SQUARE_FOOT, last + 1
    if word == "m" and reading.kind(last + 1) == "number" and reading.word(last + 1) == "2":
        return value, last + 2
    return None


def _sides_at(reading: Reading, index: int) -> tuple[float, int] | None:
    """Read "20 x 15 m" as an area."""
    link = index + 1 + (reading.word(index + 1) in _METRES)
    if reading.word(link) not in ("x", "by") or reading.kind(link + 1) != "number":
        return None
    if reading.word(link + 2) not in _METRES:
        return None
    return reading.tokens[index].value * reading.tokens[link + 1].value, link + 3


def read_areas(reading: Reading) -> None:
    """Read the areas that belong to the building or to a storey; those of rooms are read with the rooms."""
    index = 0
    while index < len(reading.tokens):
        found = None if index in reading.taken else area_at(reading, index)
        if found is None:
            index += 1
            continue
        value, last = found
        fact = Quantity(value, _with_approximation(reading, index, last))
        sides = _sides_at(reading, index) is not None and not _of_room(reading, index, last)
        if sides or _per_floor(reading, index, last):
            reading.facts.floor_area.append(fact)
            reading.take(index, last)
        elif not _of_room(reading, index, last):
            reading.facts.area.append(fact)
            reading.take(index, last)
        index = last


def _with_approximation(reading: Reading, first: int, last: int) -> Span:
    if reading.word(first - 1) in ("about", "around", "approximately", "roughly", "circa", "some"):
        first -= 1
    return reading.span(first, last)


def _per_floor(reading: Reading, first: int, last: int) -> bool:
    after = [reading.word(i) for i in range(last, last + 5)]
    for offset, word in enumerate(after[:-1]):
        if word in (",", ".", ";", "with"):
            break
        if word in ("per", "a", "each", "every", "/", "footprint", "plate"):
            follows = after[offset + 1]
            if word in ("footprint", "plate") or follows in FLOOR_WORDS or follows == "footprint":
                return True
        if (
            offset == 0
            and word in ("floor", "storey", "level")
            and after[1] in ("plate", "area", "plan")
        ):
            return True
    before = [reading.word(i) for i in range(first - 6, first)]
    text = " ".join(before)
    if any(mark in before for mark in (".", ";")):
        text = text.rsplit(".", 1)[-1].rsplit(";", 1)[-1]
    if "total floor" in text or "gross floor" in text:
        return False
    cues = ("floor area", "footprint", "floor plate", "each floor", "every floor", "per floor",
            "floor of", "storey of", "each storey", "each level", "level of", "every storey", "floor with")  # fmt: skip
    return any(cue in text for cue in cues)


def _of_room(reading: Reading, first: int, last: int) -> bool:
    """Whether the area is a room's: "a 40 m2 meeting room", "a meeting room of 40 m2"."""
    after = last
    while reading.kind(after) == "word" and after not in reading.mention_at and after < last + 3:
        if reading.word(after) in ("with", "in", "for", "on", "and", "total", "of", "building"):
            break
        after += 1
    if reading.word(last) == "of" and last + 1 in reading.mention_at:
        after = last + 1
    mention = reading.mention_at.get(after)
    if mention is not None and mention.room and not _is_head(reading, mention.first):
        return True
    unknown = reading.word(after - 1) in ("room", "hall", "area", "space", "studio", "lab", "zone")
    if unknown and after > last + 1 and mention is None:
        return True
    before = first
    while reading.word(before - 1) in (
        "of", "with", "about", "around", "at", "least", "(", "measuring", "is", "has", "approximately",
        "be", "should", "covering", "roughly", "an", "area", "size", "sized", "each", ":", "having",
        "=", "a", "must", "will", "exactly", "occupying", "minimum", "than", "more", "floor", ",", "total",
    ):  # fmt: skip
        before -= 1
    if reading.word(before) == "," or "total" in [reading.word(i) for i in range(before, first)]:
        return False
    mention = reading.mention_ending.get(before)
    return mention is not None and bool(mention.room) and not _is_head(reading, mention.first)


def _is_head(reading: Reading, first: int) -> bool:
    return any(reading.text[s.start : s.end] and s.start == reading.tokens[first].start
               for _, s in reading.facts.building)  # fmt: skip


def read_occupants(reading: Reading) -> None:
    """Read how many people the building is for."""
    for index, token in enumerate(reading.tokens):
        if token.kind != "number" or index in reading.taken or token.value < 1:
            continue
        last = index + 1
        while reading.word(last) in (
            "elderly",
            "young",
            "full",
            "time",
            "hospital",
            "school",
            "primary",
            "secondary",
            "office",
            "permanent",
            "hotel",
        ):
            last += 1
        if reading.word(last) in _PEOPLE and (
            last not in reading.mention_at or reading.word(last) in ("bed",)
        ):
            if reading.word(last) == "desk" or (
                reading.word(last) == "bed" and reading.word(last + 1) == "room"
            ):
                continue
            if (
                reading.word(last) in ("guest", "patient", "staff", "student", "kid", "child")
                and last in reading.mention_at
            ):
                continue
            if reading.word(last) == "person" and last + 1 in reading.mention_at:
                continue
            if reading.word(last) in ("teacher", "staff", "visitor") and _counted(reading):
                continue
            span = reading.span(index, last + 1)
            reading.facts.occupants.append(OccupantFact(int(token.value), reading.word(last), span))
            reading.take(index, last + 1)
        elif reading.word(index - 1) == "of" and reading.word(index - 2) in (
            "family",
            "household",
            "couple",
            "group",
        ):
            span = reading.span(index - 2, index + 1)
            reading.facts.occupants.append(OccupantFact(int(token.value), "family", span))
            reading.take(index - 2, index + 1)
    if not reading.facts.occupants:
        for index in range(len(reading.tokens)):
            if reading.word(index) == "couple" and reading.word(index - 2) in ("for",):
                span = reading.span(index, index + 1)
                reading.facts.occupants.append(OccupantFact(2, "family", span))
                reading.take(index, index + 1)
                break


def _counted(reading: Reading) -> bool:
    return bool(reading.facts.occupants)
