"""Which clauses of an instruction ask for something, and which only tell."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.nouns import MATERIALS
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import PERSONS
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_editing.instructions.syntax.verb_forms import verb_forms
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import singular
from mansion_language.numbers import ORDINALS

__all__ = ["is_person", "names_something", "only_tells"]

_OBLIGING: Final = frozenset("must should shall ought".split())
_WISHING: Final = frozenset("need want like prefer require wish fancy love appreciate miss lack deserve expect".split())
_TASTES: Final = frozenset("like love prefer fancy appreciate".split())
_PLACING: Final = frozenset(
    "belong go come stay remain become join get move keep leave replace make stand live sit hang lie face".split()
)
_CHANGING: Final = frozenset("lose gain receive vanish disappear run".split())
"""Verbs by which something becomes of things and rooms: ``the office loses its sofa``."""
_RESTING: Final = frozenset("stand live sit hang lie face".split())
"""Verbs that only say where something is, without a modal."""
_STAYING: Final = frozenset(["stay", "remain"])
_MEASURING: Final = frozenset(
    "enough plenty many much few fewer less more missing needed wanted required supposed meant due short surplus "
    "superfluous redundant unwanted welcome sufficient ample nice good great lovely better best fine handy perfect "
    "useful ideal wrong use".split()
)
"""Words by which a description also says what there shall be."""
_LIMITING: Final = frozenset("only except instead exactly apart without otherwise including included excluding".split())
"""Words that may limit what another clause asks for."""
_WHOLES: Final = frozenset("all every each both any half".split())
_DEPENDING: Final = frozenset("if unless whether until wherever where that".split())
_TIMING: Final = frozenset("when whenever once".split())
"""Words that begin a time, or a condition where they name a thing: ``when the lamp is on, switch it off``."""
_CALLS: Final = frozenset("thank look guess imagine listen know see mind remember".split())
_MENDING: Final = frozenset("sort fix see remedy change solve mend correct".split())
_IT: Final = frozenset("it that this out to please right for me us now about up".split())
"""Words of orders that say no more than that something shall be put right: ``sort that out``."""
_PREPARING: Final = frozenset("roll pick grab unplug fold lift wrap disconnect pack check".split())
"""What is done with a thing before it is brought somewhere: ``roll it up and take it to the storage``."""
_MEANT_AGAIN: Final = frozenset(
    "rest remainder remaining other others lot stuff everything all half surplus excess thing object item furniture "
    "content one ones door window wall".split()
)
"""Words of subjects that mean things without their name."""
_SWITCHED: Final = frozenset("on off open closed shut lit".split())
_FINE: Final = frozenset("right correct fine ok okay alright good".split())
_WHOLES_OF: Final = frozenset("everything all whatever".split())
_DENYING: Final = frozenset(["not", "no", "never"])


def only_tells(clause: Clause, words: Sequence[TaggedWord], lexicon: Lexicon) -> bool:
    """Whether a clause describes, explains or calls out, so that nothing is left undone without it.

    A clause with a subject asks for something by what obliges or wishes, by a verb that says where its subject shall
    be, or by a number of what there shall be; otherwise its indicative tells what is, was or happens.
    """
    said = words[clause.start : clause.end]
    texts = [word.text for word in said]
    named = names_something(said, lexicon)
    counts = clause.form == "existence" or words[clause.verb].tag == "have"
    limiting = {*texts} & _LIMITING
    if counts and limiting == {"only"} and said[texts.index("only") + 1 : texts.index("only") + 2]:
        limiting = set() if said[texts.index("only") + 1].tag in ("number", "determiner") else limiting
    nothing = texts[0] == "nothing" or any(
        pair in (("nothing", "but"), ("nothing", "else")) for pair in pairwise(texts)
    )
    if named and (nothing or limiting or texts[-1] in _ALSO or {"too", "also"} & {*texts[:-1]}):
        return clause.form == "statement" and _tells_of_use(clause, words) and not _asks(clause, words, lexicon)
    if texts[:2] in (["how", "many"], ["is", "there"], ["are", "there"]) and named:
        return False
    done = words[clause.verb]
    if clause.form == "statement" and said[0].tag == "noun" and named and done.form in ("past", "participle"):
        deed = (done.verb,) in BY_WORDS and clause.verb > clause.start and not any(w.tag == "be" for w in said)
        if deed and names_something(words[clause.start : clause.verb], lexicon):
            return False  # "wardrobe added opposite"
    if clause.form == "statement" and _tells_of_number(said):
        return True
    if (said[0].tag == "noun" and (texts[0],) in BY_WORDS) or _is_misspelt(said, lexicon):
        return False  # it may be an order: "plant ...", "opn ..."
    if clause.form == "statement" and texts[0] == "what" and {*texts} & {"go", "goes", "out", "away", "leave"}:
        return False  # "what was there before can go"
    if clause.form == "statement" and texts[0] == "what":
        placed = any(word.verb in _PLACING - _RESTING for word in said)  # "what is on it moves to the hall"
        return not placed and not any(word.verb in _WISHING or word.text in _MEASURING for word in said)
    if clause.form == "question" and said[0].tag == "have" and len(said) > 2 and said[1].tag == "somebody":
        return any(word.text in ("seen", "noticed", "found", "heard") for word in said)  # "has anybody seen the cat?"
    if clause.form == "question":
        idle = not (named or {*texts} & {"you", "we"} or _takes_up(said[1:]))
        return idle or (texts[-1:] == ["you"] and len(texts) <= 3)
    if clause.form == "order":
        if said[0].verb in _PREPARING and len(said) < 5 and (_takes_up(said) or len(said) == 1) and not named:
            return True
        vague = texts[0] in _MENDING and {*texts[1:]} <= _IT and len(texts) > 1
        return vague or (texts[0] in _CALLS and not named)
    if clause.form == "dependent" and texts in (["where", "it", "belongs"], ["where", "they", "belong"]):
        return clause.after == ","
    if clause.form == "dependent":
        return texts[0] not in _DEPENDING and not (named and texts[0] in _TIMING)
    if clause.form == "fragment":
        states = {texts[-1], *(text for text in texts if text not in ("on", "up", "down", "out"))} & _STATES
        counted = any(word.tag == "number" and word.text not in ORDINALS for word in said)
        counted = counted or any(word.text in COLOUR_WORDS or word.text in MATERIALS for word in said)
        return not (named or {*texts} & (_LIMITING | _WHOLES) or states or counted or _takes_up(said))
    if _is_noted_as_done(clause, words):
        return False
    if clause.after == "but" and named and _takes_up(words[clause.subject : clause.subject + 1]):
        return False  # "but tonight it sleeps on the sofa"
    if clause.after == "so" or (texts[0] == "that" and said[0].tag != "determiner"):
        return not (named or _counts(said) or {*texts} & _LIMITING) and not _asks(clause, words, lexicon)
    return not _asks(clause, words, lexicon)


def _tells_of_number(said: Sequence[TaggedWord]) -> bool:
    """Whether ``one is there already``, ``that makes two more`` tells how many there are, or will be."""
    texts = [word.text for word in said]
    if texts[:2] in (["that", "makes"], ["which", "makes"]):
        return said[-1].tag in ("number", "adjective", "pronoun") or texts[-1] == "more"
    counted = said[0].tag in ("number", "pronoun") or texts[0] == "some"
    return counted and "already" in texts and len(said) > 2 and any(word.tag == "be" for word in said[1:3])


def _is_noted_as_done(clause: Clause, words: Sequence[TaggedWord]) -> bool:
    """Whether notes list what shall be done as done: ``desk at the window, wardrobe added opposite``."""
    subject, verb = words[clause.subject], words[clause.verb]
    listed = clause.form == "statement" and clause.after in (",", ":", "and", "-")
    done = verb.tag == "verb" and verb.form in ("past", "participle") and (verb.verb,) in BY_WORDS
    return listed and done and subject.tag == "noun" and not is_person(words[clause.subject : clause.verb])


def _is_misspelt(words: Sequence[TaggedWord], lexicon: Lexicon) -> bool:
    """Whether a word is no English one, but nearly one."""
    plain = (word for word in words if word.raw.isalpha() and word.raw.islower() and word.tag == "noun")
    names = (singular(word.text) for word in plain if not verb_forms(word.text) and word.text not in lexicon.kept)
    unknown = (name for name in names if name not in lexicon.kept and not lexicon.is_object((name,)))
    return any(lexicon.speller.nearest(name) != name for name in unknown)


def _tells_of_use(clause: Clause, words: Sequence[TaggedWord]) -> bool:
    """Whether nobody, or everybody, does something with things: ``nobody ever sits in the armchair``."""
    subject = words[clause.subject]
    return subject.tag == "somebody" and words[clause.verb].form in ("third", "past")


def _asks(clause: Clause, words: Sequence[TaggedWord], lexicon: Lexicon) -> bool:
    """Whether a clause with a subject and a finite verb may ask for something."""
    head = max(end_of_noun_group(words[: clause.subject_end], clause.subject), clause.subject + 1)
    subject, rest = words[clause.subject : head], words[clause.verb : clause.end]
    texts = [word.text for word in rest]
    counted = any(word.tag in ("number", "pronoun") for word in subject)
    again = any(singular(word.text) in _MEANT_AGAIN for word in subject)
    somebody = is_person(subject) or not (names_something(subject, lexicon) or counted or again)
    aimed = names_something(rest, lexicon) or _counts(rest) or _takes_up(rest)
    verb = rest[0]
    if (
        texts[-1] in ("along", "too")
        and {"come", "go"} & {word.verb for word in rest}
        and subject[0].text in _WHOLES_OF
    ):
        return False  # "everything on it must come along"
    main = next((word for word in rest if word.tag == "verb"), verb)
    if main.verb in _STAYING:
        return not is_person(subject)
    if verb.tag == "modal" and any(word.tag == "number" for word in subject):
        return True
    able = {"able", "reach", "get"} & {*texts}
    if verb.text in _OBLIGING and {*texts[1:]} & _SWITCHED and not is_person(subject):
        return True  # whatever it is: "the pendants should be off"
    if verb.text in _OBLIGING or (verb.tag in ("be", "have") and _is_to(rest)) or texts[:2] in _NEEDING:
        return not somebody or aimed or bool(able)
    if any(word.form == "gerund" and (word.verb,) in BY_WORDS for word in rest) and main.verb == "need":
        return True  # "it needs emptying"
    if _wishes(rest):
        return aimed and not (somebody and _does_it_oneself(rest))
    fine = verb.tag == "be" and bool({*texts[1:3]} & _FINE)
    if fine and counted and not names_something(subject, lexicon):
        return False  # "eight is right", "that one is fine as it is"
    if verb.tag == "modal":
        denied = {*texts[1:3]} & _DENYING
        return not somebody and not denied and (main.verb in _PLACING or main.form == "participle" or _measures(texts))
    coming = {*texts} & {"out", "in", "away"} and any(word.verb in ("go", "come") for word in rest)
    if coming and not is_person(subject):
        return True  # "the desk and the chair go out"
    making = main.verb == "make" and "way" not in texts
    if main.verb == "belong" and "to" in texts[1:3] and not names_something(rest, lexicon):
        return False  # "the red car belongs to Sam"
    placed = main.verb in _PLACING - _RESTING and main.form in ("third", "base") and not making
    if placed and not _goes_on_doing(rest):
        return not somebody or main.verb == "keep"
    if not somebody and ("to", "be") in pairwise(texts) and names_something(subject, lexicon):
        return True  # "the bikes are the ones to be switched off"
    if main.verb in _CHANGING and main.form in ("third", "base") and names_something(subject, lexicon):
        return not somebody
    if main.verb in ("suffice", "suggest", "insist", "ask", "propose", "recommend"):
        return True
    return _measures(texts[1:]) and (counted or not somebody or names_something(rest, lexicon))


def _wishes(rest: Sequence[TaggedWord]) -> bool:
    """Whether a predicate wishes or needs something: ``we want``, ``I'm going to need``, ``I would rather have``."""
    texts = [word.text for word in rest[:5]]
    modal = rest[0].tag == "modal"
    taste = rest[0].verb in _TASTES and rest[0].form == "third"  # "my back prefers the armchair"
    wishing = not taste and any(word.verb in _WISHING for word in rest[:5]) and not {*texts[1:3]} & _DENYING
    return wishing or (modal and bool({"rather", "do", "use", "have"} & {*texts[1:3]}) and rest[0].text in _COULD)


def _goes_on_doing(rest: Sequence[TaggedWord]) -> bool:
    """Whether something keeps happening: ``keeps tripping me up``, ``gets knocked over``."""
    doing = any(word.form in ("gerund", "participle") and word.verb != "run" for word in rest[1:3])
    return doing and rest[0].verb in ("keep", "get", "go")


def _takes_up(words: Sequence[TaggedWord]) -> bool:
    """Whether words take something up by a pronoun."""
    return any(word.tag in ("pronoun", "possessive") for word in words)


_NEEDING: Final = (["need", "to"], ["needs", "to"], ["needs", "not"])


def _is_to(rest: Sequence[TaggedWord]) -> bool:
    """Whether ``has to``, ``is to``, ``has got to`` begins a predicate."""
    texts = [word.text for word in rest[:3]]
    return texts[1:2] == ["to"] or texts[1:3] == ["got", "to"]


def _measures(texts: Sequence[str]) -> bool:
    plain = [text for at, text in enumerate(texts) if not (text == "more" and at and texts[at - 1] in ("any", "no"))]
    return bool({*plain} & _MEASURING)


def _does_it_oneself(rest: Sequence[TaggedWord]) -> bool:
    """Whether somebody wants to do something, and nothing to be there: ``wants to sit beside the animal``."""
    to = next((at for at, word in enumerate(rest) if word.tag == "to"), 0)
    return to == 1 and len(rest) > 2 and rest[2].verb not in ("have", "see", "get", "keep", "be", "put", "move")


def is_person(words: Sequence[TaggedWord]) -> bool:
    """Whether a subject is somebody."""
    heads = [word for word in words if word.tag in ("noun", "somebody", "pronoun")]
    named = [word for word in heads if word.tag == "somebody" or singular(word.text) in PEOPLE | PERSONS]
    return bool(named) and (heads[0] in named or heads[-1] in named)


def names_something(words: Sequence[TaggedWord], lexicon: Lexicon) -> bool:
    """Whether words name a thing of the catalogue or a room of the building."""
    nouns = [singular(word.text).removesuffix("'s").rstrip("'") if word.tag == "noun" else "" for word in words]
    spans = [tuple(nouns[at : at + count]) for count in (1, 2, 3) for at in range(len(nouns) - count + 1)]
    persons = {singular(word.text) for word in words if is_person([word])}
    spans = [span for span in spans if all(span) and not (len(span) == 1 and span[0] in persons)]
    return any(span[0] in _SPOTS or lexicon.is_object(span) or lexicon.is_own_room(span) for span in spans)


def _counts(words: Sequence[TaggedWord]) -> bool:
    return any(word.tag == "number" for word in words)


_STATES: Final = frozenset("on off open closed shut out away up down not no".split())
_SPOTS: Final = frozenset("floor side wall corner middle window door top row shelf ceiling".split())
_ALSO: Final = frozenset(["too", "also", "well"])
_COULD: Final = frozenset(["would", "could", "can"])
