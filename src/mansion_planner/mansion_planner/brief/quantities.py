"""Read the numbers of a brief: storeys, basements and occupants."""

from mansion_planner.brief.facts import FloorRef, OccupantFact, Quantity, UseFact
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["read_floor_counts", "read_occupants"]

_STOREY_ADJECTIVES = frozenset(
    {"full", "whole", "habitable", "residential", "office", "guest", "typical", "upper", "additional",
     "more", "storied", "underground", "basement", "parking", "subterranean", "identical", "main", "above",
     "equal", "different", "separate", "small", "large", "big", "classroom", "hotel", "retail"}
)  # fmt: skip
_BELOW = frozenset({"underground", "basement", "subterranean", "below"})
_NAMED = {"duplex": 2, "triplex": 3, "bungalow": 1}
_PEOPLE = frozenset(
    {
        "people", "person", "resident", "occupant", "pupil", "student", "child", "employee", "worker", "guest",
        "patient", "adult", "inhabitant", "staff", "bed", "teacher", "kid", "user", "visitor", "elderly", "tenant",
        "inmate", "firefighter", "officer", "diner", "seat", "roommate", "friend", "desk", "colleague", "developer",
        "lodger",
    }
)  # fmt: skip


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
    if reading.word(index - 1) in ("top", "first", "last", "bottom", "lower", "upper", "remaining", "other"):
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
    mention = next((reading.mention_at[i] for i in (last + 1, last + 2) if i in reading.mention_at), None)
    if mention is None or not mention.building:
        return mention is not None
    name = "apartment_building" if mention.building == "flat" else mention.building
    floors: tuple[FloorRef, ...] = ()
    if any(reading.word(i) in ("above", "over", "on", "atop") for i in range(mention.last, mention.last + 2)):
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
    elif word == "g" and reading.word(index + 1) in ("+", "plus") and reading.kind(index + 2) == "number":
        value = reading.tokens[index + 2].value + 1
        reading.facts.floors.append(Quantity(value, reading.span(index, index + 3)))
        reading.take(index, index + 3)
    elif word in ("small", "compact", "tiny", "little", "modest", "mini"):
        reading.facts.size.append(("small", span))
    elif word in ("large", "big", "spacious", "huge", "vast", "generous", "giant", "sprawling"):
        reading.facts.size.append(("large", span))


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
        if reading.word(last) in _PEOPLE and (last not in reading.mention_at or reading.word(last) in ("bed",)):
            if reading.word(last) == "desk" or (reading.word(last) == "bed" and reading.word(last + 1) == "room"):
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
        elif reading.word(index - 1) == "of" and reading.word(index - 2) in ("family", "household", "couple", "group"):
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
