"""Read how many rooms some people share: "offices for twelve, two in each", "bedrooms for six, two to a room"."""

from dataclasses import replace

from mansion_planner.brief.facts import OccupantFact
from mansion_planner.brief.phrase import PEOPLE, Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["read_shares"]

_MOST = 500
_MARKS = frozenset({",", "(", "-", "–", ";", "with", ":"})
_PRONOUNS = frozenset({"each", "every", "a", "an", "one", "per", "apiece"})
_IN_GROUPS = {"pair": 2, "two": 2, "three": 3, "four": 4}


def read_shares(reading: Reading, phrases: list[Phrase]) -> None:
    """Count the rooms that have no number by the people that they are for, and by how many share one."""
    for number, phrase in enumerate(phrases):
        end = _shares_end(reading, phrase.noun_end, phrase)
        if not end or not phrase.room_type or phrase.head not in ("room", "building") or not phrase.plural:
            continue
        people, share = _people(reading, phrase.noun_end), _share(reading, phrase.noun_end, phrase)
        many = -(-people[0] // share[0])
        if phrase.counted and phrase.count != many:
            continue
        if phrase.building == "office":
            phrase = replace(phrase, head="room", building="")
        phrases[number] = replace(phrase, count=many, counted=True)
        called = reading.word(people[1] - 1) in PEOPLE
        noun = reading.word(people[1] - 1) if called else "people"
        reading.facts.occupants.append(OccupantFact(people[0], noun, reading.span(phrase.noun_end, people[1])))
        if called:
            reading.take(people[1], end)  # what stands in the rooms is read from those that they are for
            continue
        reading.take(phrase.noun_end, end)
        phrases[number] = replace(phrases[number], last=end)


def _shares_end(reading: Reading, index: int, phrase: Phrase) -> int:
    """Return where "for twelve, two in each" ends that begins at a token after rooms; 0 where nothing such does."""
    people = _people(reading, index)
    return _share(reading, index, phrase)[1] if people[0] else 0


def _people(reading: Reading, index: int) -> tuple[int, int]:
    """Return of how many people "for twelve (people)" speaks, and where it ends; zeros for none."""
    if reading.word(index) != "for" or reading.kind(index + 1) != "number":
        return 0, 0
    value = reading.value(index + 1)
    if value != int(value) or not 2 <= value <= _MOST:
        return 0, 0
    at = index + 2
    while reading.word(at) in PEOPLE and at < index + 4:
        at += 1
    return int(value), at


def _share(reading: Reading, index: int, phrase: Phrase) -> tuple[int, int]:
    """Return how many share one room, and where that is said to its end; zeros where it is not."""
    at = _people(reading, index)[1]
    while reading.word(at) in _MARKS:
        at += 1
    if reading.word(at) == "in" and reading.word(at + 1) in _IN_GROUPS and reading.plural(at + 1):
        return _IN_GROUPS[reading.word(at + 1)], at + 2
    sharing = reading.word(at) in ("each", "every", "all") and reading.word(at + 1) in ("for", "shared")
    at += (1 + (reading.word(at + 1) == "shared") + (reading.word(at + 2) == "by")) if sharing else 0
    at += reading.word(at) in ("for", "by") and sharing
    value = reading.value(at) if reading.kind(at) == "number" else 0.0
    if value != int(value) or not 1 <= value <= 12:
        return 0, 0
    at += 1 + (reading.word(at + 1) in PEOPLE)
    if sharing:
        return int(value), at
    led = reading.word(at) in ("in", "to", "into", "sharing")
    at += led
    if reading.word(at) not in _PRONOUNS and not (led and reading.word(at) == reading.word(phrase.noun_end - 1)):
        return 0, 0
    at += 1
    nouns = {reading.word(phrase.noun_end - 1), "room", "one", "of", "them"}
    while reading.word(at) in nouns:
        at += 1
    return int(value), at + (reading.word(at) == ")")
