"""Read rooms that a brief names by a pronoun: "a waiting area for dogs plus a second one just for cats"."""

from dataclasses import replace

from mansion_language import singular
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.told_by_size import COMPARATIVES

__all__ = ["further_ones"]

_FURTHER = frozenset({"second", "third", "fourth", "another", "further", "smaller", "larger", "separate", "different"})
_JOINTS = frozenset({",", "and", "plus", "&", "+", "with", ";", "as"})


def further_ones(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return a room for each "a second one", "another one for cats" that follows a room in its sentence."""
    found: list[Phrase] = []
    for index in range(len(reading.tokens)):
        elided = reading.word(index + 1) == "for" and reading.word(index) in ("another", "second", "further")
        one = reading.word(index) == "one" and reading.word(index - 1) in _FURTHER
        if not (elided or one) or index in reading.taken:
            continue
        begin = index - one
        told = one and reading.word(index - 1) in COMPARATIVES and reading.word(index - 2) == "the"
        begin -= told or reading.word(begin - 1) in ("a", "an")
        if reading.word(begin - 1) not in _JOINTS or reading.word(index + 1) in FLOOR_WORDS:
            continue
        before = _one_of_several(reading, phrases, begin) if told else _before(reading, phrases, begin)
        if before is None:
            continue
        last, user = _user(reading, index + 1)
        reading.take(begin, last)
        again = replace(
            before, first=begin, begin=begin, noun_end=last, last=last, count=1, counted=True, plural=False, areas=()
        )
        if told:
            size = reading.word(index - 1)
            label = f"{size} {singular(before.label)}"
            again = replace(again, head="room", building="")
            found.append(replace(again, name=f"{size}_{before.name}", label=label, counted=False, determiner="the"))
            continue
        head = before.name.rpartition("_")[2] if not user else _kind(before)
        label = reading.span(before.begin, before.noun_end).words
        named = replace(again, name=f"{user}_{head}"[:60], label=f"{label} for {user}s") if user else again
        found.append(replace(named, determiner="a"))
    return found


def _before(reading: Reading, phrases: list[Phrase], index: int) -> Phrase | None:
    """Return the room named last before a token in its sentence, if it is one room close by."""
    near = [
        p for p in phrases if p.last <= index and reading.sentence[p.first] == reading.sentence[index] and p.room_type
    ]
    last = max(near, key=lambda phrase: phrase.first, default=None)
    if last is None or reading.word(last.last) == "for":
        return None  # "an ablution room for men and another for women" is read with who uses it
    return last if index - last.last <= 8 and last.head == "room" else None


def _one_of_several(reading: Reading, phrases: list[Phrase], index: int) -> Phrase | None:
    """Return the rooms that "the larger one" is one of: the last ones of its sentence that are counted."""
    sentence = reading.sentence[index]
    return next(
        (
            phrase
            for phrase in sorted(phrases, key=lambda phrase: -phrase.first)
            if phrase.last <= index and reading.sentence[phrase.first] == sentence and phrase.room_type
            if phrase.head in ("room", "building") and phrase.counted and (phrase.count or 0) > 1
        ),
        None,
    )


def _kind(phrase: Phrase) -> str:
    """Return the name of a room without its user: "waiting_area" of "dog_waiting_area"."""
    words = phrase.label.lower().partition(" for ")[0].split()
    return "_".join(word for word in words if word.isalnum())


def _user(reading: Reading, index: int) -> tuple[int, str]:
    """Return where "just for cats" ends that begins at a token, and for what."""
    at = index + (reading.word(index) in ("just", "only", "solely", "reserved", "meant"))
    noun = at + 1 + (reading.word(at + 1) in ("the", "our"))
    named = reading.word(at) == "for" and reading.kind(noun) == "word" and reading.word(noun) not in FUNCTION_WORDS
    return (noun + 1, reading.word(noun)) if named else (index, "")
