"""Things, rooms and persons that clauses mention, and what a later pronoun takes up of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.words import PLURAL_PRONOUNS
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.requests import is_person
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, text_of
from mansion_language.inflection import singular

__all__ = ["Mentioned", "mentioned_in", "taken_up"]

Kind: TypeAlias = Literal["thing", "room"]


@dataclass(frozen=True)
class Mentioned:
    """A noun group of a clause.

    Attributes
    ----------
    words : str
        As it would be said again: definite, with where it is.
    noun : str
        Its nouns as they stand.
    plural : bool
        Several are meant.
    leading : bool
        It is the subject, or what "there is".
    told : bool
        Its clause only tells.
    start, end, stop : int
        Its words without those of its place, and the end of these.
    """

    kind: Kind
    words: str
    noun: str
    plural: bool
    leading: bool
    told: bool
    start: int
    end: int
    stop: int


_RESTING: Final = frozenset("be stand lie sit hang stay live leave put place rest lean find keep store".split())
_IDLE: Final = frozenset("still already just really only also currently now here there".split())
_SINGLE: Final = frozenset("a an one another this that".split())


def mentioned_in(
    clause: Clause, words: Sequence[TaggedWord], text: str, lexicon: Lexicon, *, told: bool
) -> list[Mentioned]:
    """Return the things and rooms that a clause names, in order; not those that only tell where another one is."""
    found: list[Mentioned] = []
    at = clause.start
    first = True
    first_room = words[clause.start].text in ("in", "at") and clause.form == "statement"
    inside = 0
    while at < clause.end:
        end = end_of_noun_group(words[: clause.end], at)
        if end <= at:
            at += 1
            continue
        kind = _kind(words[at:end], lexicon)
        again = words[at].text == "the" and words[end - 1].text == "one" and bool(found) and found[-1].kind == "thing"
        if again and end == at + 2:
            place = _place_after(clause, words, end)
            said = f"the {singular(found[-1].noun)} {text_of(place, text)}".strip()
            inside = max(inside, place[-1].end if place else 0)
            stop = _end_of(place, words, end)
            found.append(Mentioned("thing", said, found[-1].noun, False, False, told, at, end, stop))
            at = end
            continue
        if kind == "thing" and words[at].start < inside:
            kind = None
        if kind is not None:
            place = _place_after(clause, words, end) if kind == "thing" else ()
            inside = max(inside, place[-1].end if place else 0)
            said = _said_again(words[at:end], text) + (f" {text_of(place, text)}" if place else "")
            fronted = found[0] if found and first_room and kind == "thing" and at <= clause.verb else None
            said += f" in {fronted.words}" if fronted is not None else ""
            head = next((word for word in reversed(words[at:end]) if word.tag == "noun"), words[end - 1])
            nouns = _name(words[at:end], lexicon)
            plural = _is_plural(words[at:end], head)
            leads = first and (at <= clause.verb or clause.form == "existence" or clause.form == "fragment")
            found.append(
                Mentioned(kind, said, text_of(nouns, text), plural, leads, told, at, end, _end_of(place, words, end))
            )
        first = first and words[at].tag == "there"
        first_room = first_room and bool(found) and found[0].kind == "room"
        at = end
    return found


def _end_of(place: Sequence[TaggedWord], words: Sequence[TaggedWord], end: int) -> int:
    return end if not place else next(k for k in range(end, len(words)) if words[k] is place[-1]) + 1


def _kind(words: Sequence[TaggedWord], lexicon: Lexicon) -> Kind | None:
    """Return whether a noun group names a thing or a room; None for persons, times and what nothing is called."""
    nouns = [singular(word.text) for word in words if word.tag in ("noun", "verb")]
    if not nouns or is_person(words):
        return None
    numbered = words[-1].tag == "number" and words[-2:-1] != [] and words[-2].tag == "noun"
    if numbered and lexicon.is_room((singular(words[-2].text),)) and not lexicon.is_called((singular(words[-2].text),)):
        return "room"  # "hall 2"
    spans = [tuple(nouns[-count:]) for count in (3, 2, 1) if len(nouns) >= count]
    called = lexicon.is_own_room(spans[0]) and not lexicon.is_called(spans[0])
    if called or (any(lexicon.is_own_room(span) for span in spans) and not lexicon.is_object(spans[0])):
        return "room"
    return "thing" if any(lexicon.is_object(span) for span in spans) else None


def _name(words: Sequence[TaggedWord], lexicon: Lexicon) -> Sequence[TaggedWord]:
    """Return the words of a noun group that name its kind: the longest name that the catalogue has, else its nouns."""
    for at in range(len(words)):
        if lexicon.is_called(tuple(singular(word.text) for word in words[at:])):
            return words[at:]
    return [word for word in words if word.tag in ("noun", "verb")]


def _is_plural(words: Sequence[TaggedWord], head: TaggedWord) -> bool:
    if words[0].text in _SINGLE and not (len(words) > 1 and words[1].text == "of"):
        return False
    return singular(head.text) != head.text and not (words[0].text == "one" and words[1].text == "of")


def _said_again(words: Sequence[TaggedWord], text: str) -> str:
    """Return a noun group with ``the``, or as it stands where it is definite already."""
    first = words[0]
    text = f"{text[: first.start]}{text[first.start].lower()}{text[first.start + 1 :]}" if first.tag != "noun" else text
    if first.text in ("whose", "which", "what"):
        return f"the {text_of(words[1:], text)}"  # "whose boots are in the hall?"
    if first.tag == "possessive" or first.text in ("the", "these", "those", "both", "all", "this", "that", "every"):
        return text_of(words, text)
    numbered = first.tag == "noun" and words[-1].tag == "number"  # "room 4"
    if numbered or (len(words) > 1 and words[1].text == "of"):
        return text_of(words, text)
    single = first.text in ("a", "an", "one", "another", "some", "any", "no")
    return f"the {text_of(words[1:] if single else words, text)}"


def _place_after(clause: Clause, words: Sequence[TaggedWord], at: int) -> Sequence[TaggedWord]:
    """Return the words for where a thing is that follow its noun group, or the verb that says where it is."""
    resting = words[clause.verb].verb in _RESTING or words[clause.verb].tag == "be"
    while at < clause.end and (words[at].text in _IDLE or (at <= clause.verb + 3 and _says_where(words[at], resting))):
        at += 1
    start = at
    while at < clause.end:
        if words[at].text in ("upstairs", "downstairs"):
            at += 1
            continue
        if words[at].tag != "preposition" or words[at].text in ("for", "with", "like", "at"):
            break
        end = end_of_noun_group(words[: clause.end], at + 1)
        if end == at + 1:
            if at + 1 < clause.end and words[at + 1].tag in ("preposition", "to"):
                at += 1
                continue
            break
        at = end
        if at < clause.end and words[at].text == "of":
            continue
    return words[start:at]


def _says_where(word: TaggedWord, resting: bool) -> bool:
    """Whether a word belongs to the verb that says where its subject is: ``is``, ``has been left``, ``is standing``."""
    return resting and (word.tag in ("be", "have") or word.verb in _RESTING)


def taken_up(pronoun: str, mentions: Sequence[Mentioned], words: Sequence[TaggedWord]) -> str:
    """Return how the things of one clause are said again that a pronoun means; empty where it may mean other things.

    The subject comes first, then the only thing in the number of the pronoun; several are meant by a list too.
    """
    plural = pronoun in PLURAL_PRONOUNS
    things = [one for one in mentions if one.kind == "thing"]
    listed = _list_of(things, words)
    if len(listed) > 1:
        return f"{', '.join(one.words for one in listed[:-1])} and {listed[-1].words}" if plural else ""
    fitting = [one for one in things if one.plural == plural]
    leading = [one for one in fitting if one.leading]
    if leading:
        return leading[0].words
    return fitting[0].words if len(fitting) == 1 else ""


def _list_of(things: Sequence[Mentioned], words: Sequence[TaggedWord]) -> list[Mentioned]:
    """Return the things of the list that begins with the first one; only that one where no list does."""
    listed = list(things[:1])
    for one in things[1:]:
        between = words[listed[-1].stop : one.start]
        if not between or any(word.tag != "joint" and word.text != "," for word in between):
            break
        listed.append(one)
    return listed
