"""Tell noun phrases that only speak of who writes, of what is left behind, and of what stands around the building."""

from dataclasses import replace

from mansion_planner.brief.building import MADE_INTO
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["without_bystanders"]

_STANDS = frozenset("stand sit lie located situated".split())
_SITES = frozenset("it building site house plot".split())
_LEADS = frozenset("around beside behind near opposite in on at next along off above below between".split())
_BESIDE = frozenset("between beside opposite near behind facing to from on at".split())


def without_bystanders(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return phrases of which those that name no part of the building are of an unknown head.

    "I am a vet", "we move out of our old villa", "the rented room is too small", "it will stand between the church and
    the inn", "the top storey houses the archive".
    """
    sites = _site_tokens(reading)
    return [
        replace(phrase, head="unknown", building="", room_type="") if _is_bystander(reading, phrase, sites) else phrase
        for phrase in phrases
    ]


def _is_bystander(reading: Reading, phrase: Phrase, sites: set[int]) -> bool:
    if phrase.head not in ("room", "building"):
        return False
    lead = reading.words(max(phrase.first - 4, 0), phrase.begin)
    writer = any(lead[at : at + 3] in (("i", "am", "a"), ("i", "am", "an")) for at in range(len(lead)))
    left = any(lead[at : at + 2] == ("out", "of") for at in range(len(lead))) and "move" in reading.words(
        max(phrase.first - 6, 0), phrase.first
    )
    outgrown = (
        phrase.determiner == "the"
        and not phrase.counted
        and reading.words(phrase.last, phrase.last + 2) in (("is", "too"), ("was", "too"), ("has", "become"))
    )
    verb = (
        phrase.last - phrase.begin == 1
        and reading.tokens[phrase.begin].text in ("house", "houses")
        and reading.plural(phrase.begin)
        and reading.word(phrase.last) in ("the", "a", "an", "our", "all")
    )
    fled = not {"leaving", "fleeing", "escaping"}.isdisjoint(reading.words(max(phrase.begin - 2, 0), phrase.noun_end))
    made = reading.word(phrase.last) in MADE_INTO and reading.word(phrase.last + 1) in ("into", "to")
    return (
        made
        or fled
        or writer
        or left
        or outgrown
        or verb
        or (phrase.first in sites and phrase.determiner in ("the", ""))
    )


def _site_tokens(reading: Reading) -> set[int]:
    """Return the tokens that say what the building stands beside: "it will stand between the church and the inn"."""
    found: set[int] = set()
    for index in range(len(reading.tokens)):
        if reading.word(index) not in _STANDS:
            continue
        start = index
        while start > 0 and reading.sentence[start - 1] == reading.sentence[index]:
            start -= 1
        before = reading.words(start, index)
        if index - start > 5 or _SITES.isdisjoint(before[:3]) or before[0] in _LEADS:
            continue  # "around it sit six offices" is about rooms
        at = index + 1
        while at < len(reading.tokens) and not reading.breaks(at) and reading.word(at) not in ("should", "with", "has"):
            at += 1
        if not _BESIDE.isdisjoint(reading.words(index + 1, at)):
            found.update(range(index + 1, at))
    return found
