"""Give rooms what later mentions of them say: their area and their storey."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.relation_rooms import Relation
from mansion_planner.brief.storey_attachment import Attachment

__all__ = ["elsewhere_by_another_word", "give_areas_of_mentions", "place_by_mentions", "tell_rooms_within"]

_FURTHER = frozenset("second third another further additional extra".split())
"""Words for one more of a room that is named before."""


def give_areas_of_mentions(
    reading: Reading, phrases: list[Phrase], same: dict[int, int], wanted: Sequence[int]
) -> None:
    """Give a room the area that another mention of it has: "beside the live room (70 m2) ... The live room"."""
    _said_of_all(phrases, same, wanted)
    for number, named in same.items():
        phrase, room = phrases[number], phrases[named]
        if phrase.areas and not room.areas and phrase.name == room.name:
            phrases[named] = replace(room, areas=phrase.areas)
            if phrase.determiner in ("a", "an", "each", "every"):
                _give_to_all(phrases, wanted, number, phrase)


def _give_to_all(phrases: list[Phrase], wanted: Sequence[int], number: int, phrase: Phrase) -> None:
    """Give the area of "a bedroom is 22 m2" to all bedrooms that are named before."""
    for other in wanted:
        room = phrases[other]
        if other < number and room.name == phrase.name and not room.areas:
            phrases[other] = replace(room, areas=phrase.areas, limit=phrase.limit)


def _said_of_all(phrases: list[Phrase], same: dict[int, int], wanted: Sequence[int]) -> None:
    """Read "four classrooms ... six classrooms. Classrooms around 50 m2" as of all that are named before."""
    before: dict[str, list[int]] = {}
    for number in wanted:
        phrase = phrases[number]
        named = before.setdefault(phrase.name, [])
        if phrase.plural and not phrase.counted and phrase.areas and named and number not in same:
            for other in named:
                room = phrases[other]
                phrases[other] = room if room.areas else replace(room, areas=phrase.areas, limit=phrase.limit)
            same[number] = named[-1]
        elif number not in same:
            named.append(number)


def elsewhere_by_another_word(
    phrases: Sequence[Phrase], same: Mapping[int, int], attached: Mapping[int, Attachment]
) -> list[int]:
    """Return the mentions that are rooms of their own: "the living room" upstairs is no "sitting room" downstairs.

    Parameters
    ----------
    same : mapping of int to int
        For a mention that is taken for another one, the phrase that names it first.
    attached : mapping of int to Attachment
        Storeys by phrase.
    """
    return [
        number
        for number, named in same.items()
        if number in attached
        and named in attached
        and attached[number].refs != attached[named].refs
        and phrases[number].determiner == "the"
        and not _is_called_alike(phrases[number].name, phrases[named].name)
    ]


def _is_called_alike(name: str, other: str) -> bool:
    """Whether one of two names is the other in short, or has all of its words but the last."""
    return name.endswith(other) or other.endswith(name) or name.split("_")[0] == other.split("_")[0]


def tell_rooms_within(reading: Reading, phrases: Sequence[Phrase], same: Mapping[int, int]) -> None:
    """Give back the room that another is to be in: "an attic ... a drying room in the attic"."""
    for number in same:
        inner, outer = phrases[number - 1], phrases[number]
        inside = number and inner.head == outer.head == "room" and inner.last == outer.begin - 2
        if inside and reading.words(inner.last, outer.begin) == ("in", "the"):
            reading.taken.difference_update(range(outer.begin, outer.noun_end))


def place_by_mentions(
    reading: Reading,
    phrases: list[Phrase],
    attached: dict[int, Attachment],
    same: dict[int, int],
    wanted: Sequence[int],
    relations: Sequence[Relation],
) -> None:
    """Give rooms the storeys that later mentions of them name; mentions that are found so are added to `same`.

    Parameters
    ----------
    attached : dict of int to Attachment
        Storeys by phrase.
    same : dict of int to int
        For a later mention of a room, the phrase that names it first.
    wanted : sequence of int
        The phrases that name rooms of the building.
    """
    _placed_later(reading, phrases, attached, same, wanted)
    _placed_again(phrases, attached, same, relations)


def _placed_later(
    reading: Reading,
    phrases: list[Phrase],
    attached: dict[int, Attachment],
    same: dict[int, int],
    wanted: Sequence[int],
) -> None:
    """Read "wood shop, metal shop. ... Wood shop and metal shop both on level 1" as of the rooms named before."""
    rooms = [n for n in wanted if n not in same]
    for number in rooms:
        phrase = phrases[number]
        if number not in attached or phrase.counted or phrase.determiner not in ("", "the"):
            continue
        if not _FURTHER.isdisjoint(reading.words(phrase.first - 1, phrase.begin + 1)):
            continue
        unplaced = [n for n in rooms if n < number and n not in attached]
        earlier = next((n for n in unplaced if _is_later_mention(reading, phrases[n], phrase)), None)
        if earlier is not None:
            attached[earlier] = Attachment(attached[number].refs)
            same[number] = earlier
            if phrase.areas and not phrases[earlier].areas:
                phrases[earlier] = replace(phrases[earlier], areas=phrase.areas, limit=phrase.limit)


def _is_later_mention(reading: Reading, room: Phrase, phrase: Phrase) -> bool:
    """Whether a phrase has the name of one room that an earlier sentence names."""
    earlier = reading.sentence[room.first] < reading.sentence[phrase.first]
    several = phrase.plural and room.counted and (room.count or 0) > 1
    return room.name == phrase.name and earlier and (several or (room.count == 1 and not phrase.plural))


def _placed_again(
    phrases: list[Phrase], attached: dict[int, Attachment], same: Mapping[int, int], relations: Sequence[Relation]
) -> None:
    """Read "a brewery with a taproom ... the floor above is the taproom with a bar" as where the taproom is."""
    operands = {n for relation in relations for n in (*relation.lefts, *relation.rights)}
    mentioned = {n for relation in relations for n in relation.rights if phrases[n].determiner == "the"}
    for number, named in same.items():
        phrase, room = phrases[number], phrases[named]
        open_yet = named not in attached or named in mentioned  # "away from the toilets" puts them nowhere
        placed = number in attached and open_yet and number not in operands
        again = phrase.name == room.name and room.count in (1, None) and not phrase.counted and named < number
        several = phrase.plural and phrase.determiner == "the" and not phrase.counted and phrase.name == room.name
        if placed and several and (room.count or 0) > 1:
            attached[named] = Attachment(attached[number].refs)  # "three bedrooms ... all but the bedrooms downstairs"
        if placed and again:
            place = attached[number]
            attached[named] = place if room.plural else Attachment(place.refs)
