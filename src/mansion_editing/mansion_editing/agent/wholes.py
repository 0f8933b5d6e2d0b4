"""Sentences that are one wish as a whole: nothing but these things, two things change places, a place spoken of."""

import re
from dataclasses import replace
from typing import Final

from mansion_editing.agent.facts import AbsentFact, Fact, MoveFact, ObjectFact, Scope, Thing
from mansion_editing.agent.phrases import Phrase, read_phrase, read_place
from mansion_editing.agent.scopes import moved
from mansion_editing.state import SceneState

__all__ = ["exchanged", "only_things", "whole_of"]

_BUT: Final = r"(?:but|except(?: for)?|besides|other than|apart from|aside from|save(?: for)?)"
_MODAL: Final = r"(?:should|must|may|shall|has to|have to|ought to|is to|can)"
_STAND: Final = r"(?: (?:be|is|are|lie|lies|stand|stands|remain|remains|stay|stays)(?: left)?)?"
_ASK: Final = (
    r"(?:(?:make sure|ensure|see to it)(?: that)? |(?:i|we) (?:want|need|would like) |"
    r"there (?:is|are|should be|must be|has to be) |have |leave |put |keep )*"
)

_WHOLE: Final = tuple(
    (kind, re.compile(f"^{pattern}$", re.IGNORECASE))
    for kind, pattern in (
        ("only", rf"{_ASK}nothing (?:else )?{_BUT} (?P<x>[^,]+?)(?: {_MODAL})?{_STAND} (?:on|in|inside) (?P<y>[^,]+?)"),
        ("only", rf"{_ASK}nothing (?:else )?(?:on|in|inside) (?P<y>[^,]+?),? {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"{_ASK}(?P<x>[^,]+?),? (?:and|but) nothing else,?(?: {_MODAL})?{_STAND} (?:on|in|inside) "
                 rf"(?P<y>[^,]+?)"),
        ("only", rf"{_ASK}(?P<x>[^,]+?)(?: {_MODAL})?{_STAND} (?:on|in|inside) (?P<y>[^,]+?),? (?:and|but) nothing "
                 rf"else"),
        ("only", rf"{_ASK}(?P<y>(?:the |f\d)[^,]+?) (?:{_MODAL} )?(?:hold|have|carry|contain|bear)s? (?:only|nothing "
                 rf"{_BUT}|just) "
                 r"(?P<x>(?:an?|the) [^,]+?)(?: on it| in it)?"),
        ("only", rf"the only (?:things?|objects?|items?) (?:on|in|inside) (?P<y>[^,]+?) (?:{_MODAL} be|is|are) "
                 rf"(?P<x>[^,]+?)"),
        ("only", rf"(?:remove|clear|take|delete) (?:everything|all|anything|whatever is)(?: else)?(?: \w+)? (?:from|"
                 rf"off|out of|on|in) "
                 rf"(?P<y>[^,]+?),? {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"(?:remove|clear|take|delete) (?:everything|all|anything) {_BUT} (?P<x>[^,]+?) (?:from|off|out of)"
                 rf" (?P<y>[^,]+?)"),
        ("only", r"(?:clear|empty|tidy(?: up)?|clean(?: up)?)(?: off)? (?P<y>[^,]+?),? (?:but|and) (?:leave|keep|"
                 r"spare) (?P<x>[^,]+?)"
                 r"(?: (?:where (?:it is|they are)|there|alone|on it|in it|untouched|in place))?"),
        ("only", rf"(?:clear|empty)(?: off)? (?P<y>[^,]+?),? {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"(?P<y>[^,]+?) (?:{_MODAL} be|is) (?:completely )?(?:empty|bare|clear) {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"{_BUT} (?P<x>[^,]+?), (?P<y>[^,]+?) (?:{_MODAL} be|is) (?:completely )?(?:empty|bare|clear)"),
        ("only", r"(?:only |just )?(?P<x>[^,]+?) on (?P<y>[^,]+?), (?:and )?(?:all|every) other (?:objects?|things?|"
                 r"items?)(?: \w+)? "
                 rf"(?:{_MODAL} )?(?:disappear|go|vanish|be removed|be gone)"),
        ("exchange", r"(?:swap|exchange|trade|switch) (?P<x>.+? (?:on|in|from|off|at) .+?) (?:and|with|for) (?P<z>the"
                     r" .+? (?:on|in|from|off|at) .+)"),
        ("exchange", rf"(?P<x>.+? (?:on|in) .+?) and (?P<z>the .+? (?:on|in) .+?) (?:{_MODAL} )?(?:be )?(?:trade|swap"
                     rf"|change|exchange|switch)d?"
                     r"(?: places?| positions?)?"),
        ("mention", r"(?P<y>.+?) (?:is|are|looks?|seems?) (?:a bit |rather |much |far )?too \w+"),
        ("mention", r"(?:i|we) (?:want|would like|need) (?:someone|somebody|people|one|guests|the robot) (?:to be "
                    r"able )?to (?:sit|work|eat|"
                    r"sleep|read|rest|relax|cook|study)(?: down)? (?P<y>(?:in|on|at) .+)"),
        ("some", r"(?P<n>one|two|three|four) of (?:them|these|those) (?:\w+ to |should |must )?(?:be |is |are )"
                 r"(?P<v>\w+)"),
    )
)  # fmt: skip


def whole_of(sentence: str) -> tuple[str, dict[str, str]] | None:
    """Return kind and parts of a sentence that is one wish as a whole, None for others."""
    for kind, pattern in _WHOLE:
        match = pattern.match(sentence)
        if match:
            return kind, match.groupdict()
    return None


def only_things(state: SceneState, words: str, place: str) -> tuple[list[Fact], Phrase]:
    """Return the facts of ``a mug and two books`` being all that is on a receptacle, and what `it` is then."""
    where = read_place(state, f"on {place}").where
    things = [read_phrase(state, part).thing for part in re.split(r",? and |, ", re.sub(r"^(?:only|just) ", "", words))]
    facts: list[Fact] = [AbsentFact(Thing("", 0), where, tuple(replace(t, count=0) for t in things))]
    for thing in things:
        exact = thing.count > 0
        one = replace(thing, count=max(1, thing.count), every=False)
        facts.append(ObjectFact(one, where, exact))
    carrier = Thing(where.receptacle, 1, where.colour)
    return facts, Phrase(carrier, Scope("room", "", where.rooms, where.floor), True)


def exchanged(state: SceneState, one: str, other: str) -> list[Fact] | None:
    """Return two things that change places as two moves; None where one of them is nowhere in particular."""
    first, second = read_phrase(state, one), read_phrase(state, other)
    if not (first.where.receptacle and second.where.receptacle):
        return None
    return [
        MoveFact(moved(first.thing), first.where, second.where),
        MoveFact(moved(second.thing), second.where, first.where),
    ]
