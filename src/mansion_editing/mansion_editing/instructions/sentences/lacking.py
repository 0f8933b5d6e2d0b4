"""What each of several lacks and is given, or has already and is spared: ``on every table that has none yet``."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import COURTESIES, Word, text_at
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Add, Amount, Ensure, Mention, Place, Relation, Statement, Things

__all__ = ["LackingSome", "end_of_presence", "given_where_none_is", "lacking_at", "spares_those_with_one"]

_DENYING: Final = frozenset("not no none without lack lacking missing".split())
_OF_LACKING: Final = _DENYING | frozenset(
    "that which where on in still yet already do does did has have had got there is are been one any it a so far of "
    "its own their them".split()
)
_MEANT: Final = frozenset("one any none it".split())
_LONGEST: Final = 9

_OF_PRESENCE: Final = frozenset(
    "where there is are already one some another other others the stand lie hang it they has have been be do does"
    .split()
)  # fmt: skip


def lacking_at(reader: ClauseReader, at: int, clause: Sequence[Statement]) -> int:
    """Return the end of ``that has none yet``, ``which do not have a lamp``; 0 where the words say something else."""
    start = at + (reader.text(at) == ",")
    if reader.text(start) not in ("that", "which", "where", "without", "lacking", "still"):
        return 0
    nouns = {word for s in clause if isinstance(s, Add | Ensure) for word in s.things.noun.split()}
    end = start
    while reader.text(end) in _OF_LACKING | nouns:
        end += 1
    said = {word.text for word in reader.words[start:end]}
    meant = said & _MEANT or (nouns and nouns <= said)
    return end if said & _DENYING and meant and end - start <= _LONGEST and _ends(reader, end) else 0


def end_of_presence(reader: ClauseReader, at: int) -> int:
    """Return the end of ``, where there is already one``, which only tells of a place; 0 for other words."""
    start = at + (reader.text(at) == ",")
    end = start
    while reader.text(end) in _OF_PRESENCE:
        end += 1
    said = {word.text for word in reader.words[start:end]}
    told = reader.text(start) == "where" and said & {"already", "other", "another"} and not said & {"not", "no"}
    return end if told and _ends(reader, end) else 0


def _ends(reader: ClauseReader, at: int) -> bool:
    return at >= len(reader.words) or reader.words[at].kind == "mark" or text_at(reader.words, at) in ("and", "please")


def given_where_none_is(clause: Sequence[Statement], *, alone: bool = False) -> list[Ensure] | None:
    """Return statements that give one to each place that has none; None where they do not say that.

    Two for each that has none, or a red one for each that has none of any colour, cannot be said as what is there
    afterwards, which is what statements are checked by.

    Parameters
    ----------
    alone : bool
        Whether the place need not be one of several.
    """
    out: list[Ensure] = []
    for statement in clause:
        if not isinstance(statement, Add | Ensure) or not (statement.each or alone):
            return None
        things = statement.things
        if things.amount.kind != "some" or things.amount.number > 1:
            return None
        if things.colour or things.material or things.states or things.size:
            return None
        one = msgspec.structs.replace(things, amount=Amount(number=1), plural=False)
        out.append(Ensure(things=one, place=statement.place, each=statement.each, quote=statement.quote))
    return out or None


_GIVING: Final = frozenset("put add give place provide bring set supply install get equip stand lay".split())
_ONE: Final = frozenset("one a an".split())
_THOSE: Final = frozenset("each both them those these".split())
_OF_GIVING: Final = _GIVING | _ONE | _THOSE | frozenset("on to in at for with of the all too also there".split())
"""Words of ``put one on each of those``, besides the name of what is given."""
_STILL: Final = frozenset("still currently yet now".split())


@dataclass(frozen=True)
class _Lack:
    """What so many of several have not."""

    things: Things
    place: Place
    number: int


class LackingSome(Progress):
    """Reads what some of several lack, and that they get it."""

    def _gives_what_some_lack(self, words: Sequence[Word], later: Sequence[Word]) -> bool:
        """Read a sentence that tells what some lack, or that they are given it; or both."""
        if self.given_later:
            self.given_later = False
            return True
        cuts = [at for at, word in enumerate(words) if word.text in (",", "-", "so", "and")]
        for at in (*cuts, len(words)):
            rest = [word for word in words[at:] if _matters(word)]
            lack = self._told_lack(words[:at])
            giving = rest or [word for word in later if _matters(word)]
            if lack is None or not _gives_one_each(giving, lack):
                continue
            self.given_later = not rest
            self.statements.append(Mention(quote=self._quote(words, 0, at)))
            quote = self._quote(giving, 0, len(giving))
            each = Ensure(things=lack.things, place=lack.place, each=True, lacking=lack.number, quote=quote)
            self.statements.append(each)
            return True
        return False

    def _told_lack(self, words: Sequence[Word]) -> _Lack | None:
        """Read ``two of the desks in the office have no monitor`` to its end."""
        reader = ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))
        holders = reader.item(reader.skip(0)) if words else None
        if holders is None or holders.is_room or not holders.phrase.plural or holders.phrase.definite:
            return None
        place = self._after_verb(reader, holders.end)
        lacking = reader.item(place, places=False) if place else None
        ends = lacking is not None and all(word.text in _STILL for word in words[lacking.end :])
        if lacking is None or not ends or lacking.is_room or lacking.phrase.noun.kind != "object":
            return None
        things = Things(noun=lacking.phrase.things().noun, colour=lacking.phrase.noun.colour)
        relation: Relation = "beside" if self.lexicon.stands(lacking.phrase.noun.words) else "on"
        whole = msgspec.structs.replace(
            holders.phrase.things(), amount=Amount(kind="all", number=0), definite=True, plural=True, each=True
        )
        where, _ = joined_places(list(holders.places))
        if where.anchor is not None or holders.phrase.amount.kind != "some" or things.colour:
            return None
        return _Lack(things, Place(relation=relation, anchor=whole, rooms=where.rooms), holders.phrase.amount.number)

    def _after_verb(self, reader: ClauseReader, at: int) -> int:
        """Return the place after ``have no``, ``lack a``, ``are without a``; 0 for other verbs."""
        while reader.text(at) in _STILL:
            at += 1
        said = (reader.text(at), reader.text(at + 1))
        if reader.text(at) == "lack":
            return at + 1
        if said in (("is", "without"), ("are", "without"), ("is", "missing"), ("are", "missing")):
            return at + 2
        negated = said == ("have", "no") or said == ("have", "not") or said == ("do", "not")
        end = at + 2
        while negated and reader.text(end) in ("have", "got", "get", "any", "a", "an"):
            end += 1
        return end if negated else 0


def _matters(word: Word) -> bool:
    return word.kind != "mark" and word.text not in COURTESIES | {"so", "and"}


def _gives_one_each(words: Sequence[Word], lack: _Lack) -> bool:
    """Whether all the words only say that those get one each: ``put one on each of those``."""
    texts = [word.text for word in words]
    noun = lack.things.noun.split()
    rest = [text for text in texts if text not in _OF_GIVING and text not in noun]
    told = texts[:1] != [] and texts[0] in _GIVING and not rest
    return told and bool({*texts} & _ONE) and bool({*texts} & _THOSE)


_AS_IT_IS: Final = (
    r"(?: (?:there|be|alone|untouched|unchanged|put|as (?:it|they) (?:is|are)|where (?:it|they) (?:is|are)))?"
)
_HAVING: Final = (
    r"(?:that|which|who)? ?(?:already )?(?:have|has|with|got)(?: got| already)* (?:one|an? {thing})"
    r"(?: already| there)*"
)
_WHOEVER: Final = r"(?:those|the one|one|who|whatever|whoever|(?:the |every |any |each )?{noun})"
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
).replace("{those}", _WHOEVER)
_FORMS_OF_WHICH: Final = (
    _THEIRS,
    rf"(?:leave|skip|spare|omit) {_WHOEVER} {_HAVING}{_AS_IT_IS}",
    rf"{_WHOEVER} {_HAVING} (?:(?:can |may |should )?(?:stay|remain){_AS_IT_IS}|(?:is|are) fine|{_NONE_MORE})",
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
