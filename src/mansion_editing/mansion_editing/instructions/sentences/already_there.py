"""Clauses that spare what has one already: ``where there is one already leave it``, ``skip those that have one``."""

import re
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.words import COURTESIES, Word

__all__ = ["spares_those_with_one"]

_AS_IT_IS: Final = (
    r"(?: (?:there|be|alone|untouched|unchanged|put|as (?:it|they) (?:is|are)|where (?:it|they) (?:is|are)))?"
)
_HAVING: Final = (
    r"(?:that|which|who)? ?(?:already )?(?:have|has|with|got)(?: got| already)* (?:one|an? {thing})"
    r"(?: already| there)*"
)
_THOSE: Final = r"(?:those|the one|one|who|whatever|whoever|(?:the |every |any |each )?{noun})"
_WHERE_ONE_IS: Final = (
    r"(?:where|wherever|if|when|in case) "
    r"(?:there(?: is)?(?: already)? one|one(?: is| stand| lie| hang)(?: already| there)*"
    r"|(?:it|they|(?:a|the|some) {noun}) (?:already )?(?:have|has)(?: got| already)* one)(?: already| there)*"
)
_IT: Final = r"(?:it|them|they|that|that one|this|those|these|the old one)"
_LEFT: Final = (
    rf"(?:(?:just |simply )?leave {_IT}{_AS_IT_IS}"
    rf"|{_IT}(?: can| may| should| shall| just)* (?:stay|remain){_AS_IT_IS}"
    rf"|{_IT}(?: is| are)? (?:fine|ok|okay|enough|good|alright)"
    rf"|skip {_IT}|do nothing|nothing (?:is needed|need be done|need to be done|to do)"
    r"|(?:you )?(?:do )?not (?:need|have) to do anything"
    r"|(?:no other|no second|no further|not another)(?: one)?(?: is)?(?: needed| required)?)"
)
_SECOND: Final = r"(?:a second|another|one more|a further|an extra)(?: one)?"
_NONE_MORE: Final = (
    r"(?:need|get|require) (?:nothing|none|no other|no second|no further|not another)(?: one)?|(?:have|has) one"
    rf"|(?:(?:do|does|should|shall|must|can) )?not (?:need|get|require|have) {_SECOND}"
    rf"|(?:can )?(?:do|does|go|manage) without {_SECOND}"
)
_FORMS_OF_WHERE: Final = (
    rf"{_WHERE_ONE_IS} {_LEFT}",
    rf"(?:but )?(?:not|except) {_WHERE_ONE_IS}",
    rf"(?:but )?(?:do )?not (?:add|put|place|bring|give) {_SECOND} {_WHERE_ONE_IS}",
)
_THEIRS: Final = (
    r"(?:(?:the )?{noun}(?: (?:number )?\d+)?(?:(?: and| ,|,)? (?:{noun} )?\d+)*|some|most|{those}|it|they)"
    r"(?: of them)?(?: already)? (?:have|has)(?: got)?"
    r" (?:theirs|(?:its|the|their) own(?: one)?|one of (?:its|the|their) own)(?: already| there)*"
).replace("{those}", _THOSE)
_FORMS_OF_WHICH: Final = (
    _THEIRS,
    rf"(?:leave|skip|spare|omit) {_THOSE} {_HAVING}{_AS_IT_IS}",
    rf"{_THOSE} {_HAVING} (?:(?:can |may |should )?(?:stay|remain){_AS_IT_IS}|(?:is|are) fine|{_NONE_MORE})",
)


def spares_those_with_one(words: Sequence[Word], nouns: frozenset[str], thing: str, *, several: bool) -> bool:
    """Whether all the words only say that no second one is brought to where one is.

    Parameters
    ----------
    nouns : frozenset of str
        Words for the places that are each given one.
    thing : str
        Words for what they are given.
    several : bool
        Whether there are several such places, so that words may tell which of them have one.
    """
    said = " ".join(word.text for word in words if word.text not in COURTESIES | {",", ";", "-"})
    noun = "(?:" + "|".join(re.escape(noun) for noun in sorted(nouns | {"room"})) + ")"
    forms = (*_FORMS_OF_WHERE, *(_FORMS_OF_WHICH if several else ()))
    return any(re.fullmatch(form.replace("{noun}", noun).replace("{thing}", re.escape(thing)), said) for form in forms)
