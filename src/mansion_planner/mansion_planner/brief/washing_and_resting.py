"""Tell by what else a brief names what its wash rooms and rest rooms are for."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.phrase import Phrase

__all__ = ["by_what_else_is_named"]

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
