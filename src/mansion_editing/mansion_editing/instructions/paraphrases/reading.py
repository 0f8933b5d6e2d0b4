"""Read an instruction; one that is not understood as it stands, in other words and without what only tells."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_editing.instructions.paraphrases.listed_articles import with_article_for_each
from mansion_editing.instructions.paraphrases.owned_furniture import with_room_after
from mansion_editing.instructions.paraphrases.patterns import (
    CLAUSE_START,
    DETERMINERS,
    in_plain_words,
    in_running_text,
    without_idioms,
)
from mansion_editing.instructions.paraphrases.remarks import without_remarks
from mansion_editing.instructions.paraphrases.titles import without_titles
from mansion_editing.instructions.paraphrases.trailing_rooms import with_room_first
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import GERUNDS, PARTICIPLES, VERB_WORDS
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, UNRECORDED, VAGUE
from mansion_editing.instructions.sentences.accounting import brought_beside_empty
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Instruction,
    Keep,
    Mention,
    Move,
    Place,
    Rename,
    Rooms,
    Statement,
    Things,
)
from mansion_editing.instructions.syntax.main_points import MainPoints, main_points
from mansion_editing.instructions.syntax.marks import without_arrows
from mansion_editing.instructions.syntax.pairs.joining import without_misread_pairs
from mansion_editing.state import SceneState

__all__ = ["read_in_other_words", "reworded", "with_known_verbs"]

_MOST_REMARKS = 2
_MOST_READINGS = 20
"""How often one instruction is read."""
_MIDDLE_OF_IT: Final = re.compile(r"\b(middle|centre|center|corner) of it\b", re.IGNORECASE)
"""What only a room is meant by, which the clause before names."""
_SOME_ALREADY: Final = re.compile(r"\balready\b", re.IGNORECASE)
_FIXING: Final = re.compile(r"(fix|sort|change|mend) (that|it|this)\b", re.IGNORECASE)
"""What is to be put right, which the clause before tells."""
_STATE_AT_END: Final = re.compile(
    r"(?:\band|,) (?:the |our |my )?(?!(?:so|from|later|early|move|go|carry)\b)[a-z -]+ "
    r"(?:on|off|open|closed|shut)[.!]?$",
    re.IGNORECASE,
)
"""A thing and the state that it shall be in, as the last of what notes ask for."""
_WONDERING: Final = re.compile(r"(who|why|how come|what on earth)\b", re.IGNORECASE)
"""Words that begin a question which nobody wants answered."""
_CORRECTION: Final = re.compile(
    r"(?:\.\.\.|…|\s-|,|\.)\s*(?:(?:no|oh|oops|er|um)\b,? )*"
    r"(?:sorry, |no,? wait|wait,? no|scratch that|i mean(?:t)? |or rather |make that |forget (?:that|it)\b)",
    re.IGNORECASE,
)
"""Words by which what was said just before is taken back."""


def read_in_other_words(text: str, state: SceneState, brief: str = "") -> Instruction:
    """Read what an instruction says, in other words where it is not understood as it stands.

    What can be understood in two ways stays so: other words would only hide one of them.

    Returns
    -------
    Instruction
        With `read_as` where it was put in other words, and a passed-over `Mention` of each clause that was left out;
        where no wording is understood, what was read of the instruction's own.
    """
    lexicon = Lexicon(state)
    plainly = with_room_after(without_idioms(with_room_first(without_titles(text, lexicon), lexicon)), lexicon)
    plainly = without_misread_pairs(plainly, lexicon)
    first = read_instruction(plainly, state, brief)
    if plainly != text:
        first, text = msgspec.structs.replace(first, read_as=plainly), plainly
    if first.undecided:
        return first
    points = tuple(main_points(in_running_text(text), lexicon))
    clear = first if _is_clear(first, text) else None
    if clear is not None and not _acts_on(points, clear):
        return clear
    for number, said in enumerate(_wordings(text, lexicon, points, tuple(state.floors))):
        if number >= _MOST_READINGS:
            break
        if clear is not None and not said.remarks:
            continue
        read = read_instruction(said.text, state, brief)
        doubtful = bool(said.remarks) and (_only_keeps(read) or _may_ask(said, state, brief))
        doubtful = doubtful or (bool(points and points[0].remarks) and not said.remarks and _lacks_antecedent(read))
        told = [Mention(quote=remark) for remark in said.remarks]
        doubtful = doubtful or bool(brought_beside_empty([*told, *read.statements], lexicon))
        if _is_clear(read, said.text) and not doubtful:
            left = [Mention(quote=remark, passed_over=True) for remark in said.remarks]
            asked = _counting_those_there(read.statements, said.remarks)
            found = msgspec.structs.replace(read, statements=[*asked, *left], read_as=said.text)
            if said.remarks or not _acts_on(points, found):
                return found
            clear = found
    if clear is not None:
        return clear
    taken_back = "" if first.not_understood else _taken_back(first, text)
    return msgspec.structs.replace(first, not_understood=[taken_back]) if taken_back else first


def _may_ask(said: MainPoints, state: SceneState, brief: str) -> bool:
    """Whether a clause that was left out would be understood as a request if it stood alone."""
    for remark in said.remarks:
        if remark not in said.described and not _WONDERING.match(remark):
            if _STATE_AT_END.search(remark):
                return True
            alone = read_instruction(remark, state, brief)
            if not alone.not_understood and not _only_keeps(alone):
                return True
    return False


def _only_keeps(read: Instruction) -> bool:
    """Whether all that was read is that things stay, so that what was left out would be all that is asked for."""
    return all(isinstance(one, Mention | Keep) for one in read.statements)


def _acts_on(points: Sequence[MainPoints], read: Instruction) -> bool:
    """Whether something was read as asked for by a clause that only says what there is."""
    asked = [
        in_running_text(one.quote).strip(" .,!?") for one in read.statements if not isinstance(one, Mention | Keep)
    ]
    described = points[0].described if points else ()
    return any(quote and quote in remark for quote in asked for remark in described)


def _is_clear(read: Instruction, text: str) -> bool:
    """Whether a text was understood, and nothing is left of a correction or of what a pronoun takes up of a remark."""
    if read.not_understood or _taken_back(read, text):
        return False
    if any(isinstance(one, Rename) and one.room == Rooms() for one in read.statements):
        return False  # "their room"
    if any(isinstance(one, Move) and one.place == Place() and _FIXING.match(one.quote) for one in read.statements):
        return False
    if any(_is_at_bare_number(one) for one in read.statements) or _MIDDLE_OF_IT.search(text):
        return False
    asked = next((one for one in read.statements if not isinstance(one, Mention)), None)
    things = getattr(asked, "things", None)
    bare = isinstance(things, Things) and things.refers in ("last", "others") and not things.noun
    return not (bare and isinstance(read.statements[0], Mention))


def _counting_those_there(statements: Sequence[Statement], remarks: Sequence[str]) -> list[Statement]:
    """Return ``put a lamp on each desk`` as a lamp being on each, where a remark says that some have one already."""
    if not any(_SOME_ALREADY.search(remark) for remark in remarks):
        return list(statements)
    return [
        Ensure(things=one.things, place=one.place, each=True, quote=one.quote)
        if isinstance(one, Add) and one.each and one.things.amount.kind == "some"
        else one
        for one in statements
    ]


def _lacks_antecedent(read: Instruction) -> bool:
    """Whether the first thing that is asked for is only ``them``, which the clause that is left out named."""
    asked = next((one for one in read.statements if not isinstance(one, Mention)), None)
    things = getattr(asked, "things", None)
    return isinstance(things, Things) and things.refers == "last" and not things.noun


_IN_FIGURE: Final = re.compile(r"\bin \d+(?!\w|\.\d)(?! \w)")


def _is_at_bare_number(statement: Statement) -> bool:
    """Whether a statement is about things in ``2``, the number of a room that was only told of."""
    goal = getattr(statement, "place", None)
    at_it = goal.anchor if isinstance(goal, Place) else None
    if at_it is not None and at_it.refers == "last" and not at_it.noun and _IN_FIGURE.search(statement.quote):
        return True
    things = getattr(statement, "things", None)
    place = things.place if isinstance(things, Things) else None
    anchor = None if place is None else place.anchor
    return anchor is not None and anchor.refers == "last" and not anchor.noun and anchor.amount.number > 1


def _taken_back(read: Instruction, text: str) -> str:
    """Return the words by which something is taken back that was read as asked for all the same; empty for none."""
    for correction in _CORRECTION.finditer(text):
        ends = ((text.find(one.quote) + len(one.quote), one) for one in read.statements if one.quote in text)
        before = [(end, one) for end, one in ends if end <= correction.start() + 1]
        last = max(before, key=lambda pair: pair[0])[1] if before else None
        if last is not None and not isinstance(last, Mention):
            return correction[0].strip(" .-…,")
    return ""


def reworded(text: str, lexicon: Lexicon) -> str:
    """Return a text in the plain words of what it asks for."""
    running = with_article_for_each(without_arrows(in_running_text(text)), lexicon)
    return without_misread_pairs(with_known_verbs(in_plain_words(running), lexicon), lexicon)


def _wordings(
    text: str, lexicon: Lexicon, points: Sequence[MainPoints], floors: tuple[int, ...]
) -> Iterator[MainPoints]:
    """Yield an instruction in other words, then its main points, then also without one remark, and without two."""
    plain = reworded(text, lexicon)
    if plain != text:
        yield MainPoints(plain, ())
    known = {text, plain}
    own = (replace(said, text=reworded(said.text, lexicon)) for said in points)
    for said in (*own, *main_points(plain, lexicon)):
        if said.text not in known:
            known.add(said.text)
            yield said
    shorter = [MainPoints(plain, ())]
    for _ in range(_MOST_REMARKS):
        longer, shorter = shorter, []
        for said in longer[:_MOST_READINGS]:
            for left in without_remarks(said.text, lexicon, floors):
                again = reworded(left.text, lexicon)
                if again not in known:
                    known.add(again)
                    remarks = (*said.remarks, left.remark)
                    shorter.append(MainPoints(again, remarks, remarks))
                    yield shorter[-1]


_OBJECTS: Final = rf"(?:(?:{DETERMINERS})\b(?: [\w'-]+)*?|it|them|both)"
_ORDER: Final = re.compile(
    rf"{CLAUSE_START}(?P<verb>[a-z]{{3,}})(?P<particle> (?:up|down|over|across|back|in|away|off|out))?"
    rf" (?P<object>{_OBJECTS})(?P<rest>(?: [^.!?;\n]*)?)(?=[.!?;\n]|$)",
    re.IGNORECASE,
)
_NEW: Final = re.compile(r"(?:an?|another|some|two|three|four|five|six|seven|eight|nine|ten|\d+)\b", re.IGNORECASE)
_GOAL: Final = re.compile(r"\b(?:to|into|onto|towards)\b")
_LEAVING: Final = re.compile(r"\b(?:away|out|off)\b(?! of\b)", re.IGNORECASE)
_RESTING: Final = re.compile(r"\b(?:on|in|at|by|next to|beside|under|near|between|behind|against|in front of)\b")
_NOT_VERBS: Final = FUNCTION_WORDS | VAGUE | UNRECORDED | VERB_WORDS | GERUNDS.keys()
_OTHER: Final = frozenset(
    "use see hear watch leave keep let ask tell know think hope wish count mind forget remember wait stay look like "
    "love hate follow read write learn try avoid imagine ignore print show delete destroy fly sail kill eat drink "
    "sing paint clean wash polish repair fix mend break burn dance play hide block touch check inspect measure weigh "
    "without despite during because although unless until while since before after only never".split()
)
"""Words that name another deed, or none."""


def with_known_verbs(text: str, lexicon: Lexicon) -> str:
    """Return a text in which orders with unknown verbs are put as ``put``, ``move`` and ``remove``.

    New things at a place are put there; things that are known and have a goal are moved to it. What is only known to be
    at a place is left as it is said: nothing tells what shall become of it.
    """

    def known(match: re.Match[str]) -> str:
        verb = match["verb"].lower()
        if verb in _NOT_VERBS or verb in _OTHER or (verb,) in PARTICIPLES or verb.endswith(("ing", "ed", "s")):
            return match.group()
        if lexicon.is_object((verb,)) or lexicon.is_room((verb,)):
            return match.group()
        deed = _deed(match["object"], f"{match['particle'] or ''} {match['rest']}")
        return f"{deed} {match['object']}{match['rest']}" if deed else match.group()

    return _ORDER.sub(known, text)


def _deed(named: str, rest: str) -> str:
    """Return the verb that what follows an unknown one stands for; empty where that is not certain."""
    first = rest.split(" and ")[0].split(",")[0]
    if _NEW.match(named):
        return "put" if _RESTING.search(first) or _GOAL.search(first) else ""
    return "move" if _GOAL.search(first) else ""
