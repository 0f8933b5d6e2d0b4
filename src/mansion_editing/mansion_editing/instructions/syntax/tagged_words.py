"""Words of a text with their parts of speech, by closed classes, forms of verbs and the words around them."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal, TypeAlias

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.words import COURTESIES, MODALS, VAGUE
from mansion_editing.instructions.syntax.verb_forms import Form, verb_forms
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import singular
from mansion_language.numbers import CARDINALS, ORDINALS
from mansion_language.tokens import lower_without_accents

__all__ = ["Tag", "TaggedWord", "joined", "tagged", "text_of"]

Tag: TypeAlias = Literal[
    "mark", "determiner", "possessive", "number", "adjective", "noun", "pronoun", "somebody", "preposition", "verb",
    "modal", "be", "have", "do", "to", "not", "joint", "subordinator", "relative", "adverb", "interjection", "there",
]  # fmt: skip


@dataclass(frozen=True)
class TaggedWord:
    """A word or mark with its part of speech.

    Attributes
    ----------
    text : str
        In lower case.
    tag : str
        ``pronoun`` stands for things, ``somebody`` for persons; ``joint`` joins clauses or phrases ("and");
        ``subordinator`` begins a clause that depends on another ("because").
    verb, form : str
        The base of a verb and its form, of verbs and of participles before nouns; else empty.
    start, end : int
        Place in the text, in characters.
    raw : str
        As it is written.
    """

    text: str
    tag: Tag
    start: int
    end: int
    raw: str
    verb: str = ""
    form: Form | Literal[""] = ""

    @property
    def is_finite(self) -> bool:
        """Whether it may be the verb of a clause with a subject."""
        told = self.tag == "verb" and self.form in ("third", "past", "base")
        return told or self.tag in ("be", "have", "do", "modal")


_WORD: Final = re.compile(
    r"(?:mrs?|ms|dr|prof|st)\.(?=\s)|(?:no|nr|approx)\.(?=\s?\d)|\d+(?:[.,]\d+)?(?:st|nd|rd|th)?(?:'s\b)?|[^\W\d_]+(?:[-'][^\W\d_]+)*(?:'(?!\w))?|->|=>|→|\"[^\"\n]{1,60}\"|\S|\n",
    re.IGNORECASE,
)
_BE: Final = frozenset("is are was were am be been being".split())
_HAVE: Final = frozenset("has have had having".split())
_DO: Final = frozenset("do does did".split())
_DETERMINERS: Final = frozenset(
    "the a an this that these those all both half each every another some any no either".split()
)
_POSSESSIVES: Final = frozenset("my our your his her its their whose".split())
_PRONOUNS: Final = frozenset(
    "it they them this that these those one ones both all everything nothing anything something each another none "
    "others itself themselves mine yours ours hers theirs some any".split()
)
_SOMEBODY: Final = frozenset(
    "i we you he she us me him somebody someone anybody anyone everybody everyone nobody who whoever".split()
)
_PREPOSITIONS: Final = frozenset(
    "in on at by to into onto from of off out up down over under above below beside besides behind between among near "
    "against around round along across through towards toward with without for inside outside within upon underneath "
    "beneath opposite about per after before during until since next like except despite than via away "
    "nearest closest nearer".split()
)
_JOINTS: Final = frozenset("and & but or so then plus nor".split())
_SUBORDINATORS: Final = frozenset(
    "because since as when while if unless although though whereas once whenever until before after whether that "
    "where wherever whilst".split()
)
_RELATIVES: Final = frozenset("that which who whom whose where".split())
_ADVERBS: Final = frozenset(
    "also too again just really very quite simply immediately asap now first next finally afterwards meanwhile still "
    "already back right straight maybe perhaps instead together only even always never often ever here upstairs "
    "downstairs somewhere anywhere there therefore today tonight tomorrow yesterday rather almost nearly practically "
    "barely hardly soon later kindly actually basically honestly anyway however though well else as so far yet never "
    "once twice not-so please possibly currently about".split()
)
_BEFORE_LIGHT: Final = frozenset("more some enough the no a any every each one single all".split())
_BETWEEN: Final = frozenset("all both also never always just even still only often really".split())
"""Words between a pronoun and its verb."""
_AFTER_PRONOUNS: Final = frozenset("mark preposition be adverb".split())
_BEFORE_ONE: Final = frozenset("this that each every any".split())
_WHICH_PERIOD: Final = frozenset("last next this".split())
_PERIODS: Final = frozenset(
    "week weekend month year night evening morning afternoon spring summer autumn winter time monday tuesday wednesday "
    "thursday friday saturday sunday term season".split()
)
_SOUNDS: Final = frozenset("um uh er erm eh aw phew yeah yep nah yay hooray yuck ew gosh".split())
_BEFORE_DETERMINERS: Final = frozenset("all both half none".split())
_DETERMINED: Final = frozenset("the these those my our your his her their its of".split())
_BEFORE_ORDERS: Final = frozenset(
    "please just kindly then also now simply maybe perhaps finally first next only".split()
)
_EXCHANGING: Final = frozenset("trade swap change exchange switch swop".split())
_BEGINNING_OBJECTS: Final = frozenset("determiner possessive number pronoun somebody".split())
_PARTICLES: Final = frozenset("on off out up down away over back".split())
_AWAY: Final = frozenset("out up down away back over".split())
"""Particles of verbs that are nouns as well: ``throw out``, ``light up``; but ``light on in the hall``."""
_PARTICIPLES: Final = ("participle", "gerund")


def tagged(text: str, lexicon: Lexicon) -> list[TaggedWord]:
    """Return the words of a text in running order, contractions written out, with their parts of speech."""
    words = _with_verbs_apart([_by_class(match) for match in _WORD.finditer(text)])
    for at in range(len(words)):
        words[at] = _in_context(words, at, lexicon)
        if at and words[at].text in _PERIODS and words[at - 1].text in _WHICH_PERIOD:
            words[at - 1 : at + 1] = [replace(word, tag="adverb", verb="", form="") for word in words[at - 1 : at + 1]]
    return words


def joined(words: Sequence[TaggedWord]) -> str:
    """Return words in running text, each as it is written.

    Examples
    --------
    >>> joined([TaggedWord("hall", "noun", 0, 4, "hall"), TaggedWord("!", "mark", 4, 5, "!")])
    'hall!'
    """
    return re.sub(r" (?=[,.;:!?)]|'s?\b)|(?<=\() ", "", " ".join(word.raw for word in words))


def _with_verbs_apart(words: Sequence[TaggedWord]) -> list[TaggedWord]:
    """Return words with ``is`` apart from its subject: ``the printer's noisy``, but not ``the printer's cable``."""
    out: list[TaggedWord] = []
    for at, word in enumerate(words):
        following = words[at + 1] if at + 1 < len(words) else None
        last = at + 2 >= len(words) or words[at + 2].tag in ("mark", "joint")
        described = following is not None and following.tag in ("adjective", "adverb") and last
        if word.tag == "noun" and word.text.endswith("'s") and described:
            noun = replace(word, text=word.text[:-2], raw=word.raw[:-2], end=word.end - 2)
            out += [noun, TaggedWord("is", "be", word.end - 2, word.end, "is")]
        else:
            out.append(word)
    return out


def text_of(words: Sequence[TaggedWord], text: str) -> str:
    """Return the stretch of a text that words cover."""
    return text[words[0].start : words[-1].end] if words else ""


def _by_class(match: re.Match[str]) -> TaggedWord:
    """Return a word with the part of speech that it has by itself, a noun where no class has it."""
    text = lower_without_accents(match.group())
    return TaggedWord(text, next(_classes(text), "noun"), match.start(), match.end(), match.group())


def _is_quoted(text: str) -> bool:
    """Whether a word is a name between quotation marks."""
    return len(text) > 2 and text[0] == text[-1] == '"'


def _classes(text: str) -> Iterator[Tag]:
    if not (text[0].isalnum() or _is_quoted(text)):
        yield "mark"
    if text[0].isdigit() or text in CARDINALS or text in ORDINALS:
        yield "number"
    classes: tuple[tuple[frozenset[str], Tag], ...] = (
        (_BE, "be"), (_HAVE, "have"), (_DO, "do"), (MODALS, "modal"), (frozenset(["not"]), "not"),
        (frozenset(["to"]), "to"), (_JOINTS, "joint"), (_DETERMINERS, "determiner"), (_POSSESSIVES, "possessive"),
        (_PRONOUNS, "pronoun"), (_SOMEBODY, "somebody"), (frozenset(["there"]), "there"),
        (_PREPOSITIONS, "preposition"), (_SUBORDINATORS, "subordinator"), (_RELATIVES, "relative"),
        (_ADVERBS, "adverb"), (COURTESIES | _SOUNDS, "interjection"),
    )  # fmt: skip
    yield from (tag for words, tag in classes if text in words)
    if text in VAGUE or text in COLOUR_WORDS:
        yield "adjective"
    if text.endswith("ly") and len(text) > 4:
        yield "adverb"


def _in_context(words: Sequence[TaggedWord], at: int, lexicon: Lexicon) -> TaggedWord:
    """Return a word with the part of speech that it has beside the words around it."""
    word = words[at]
    before = words[at - 1] if at else None
    after = words[at + 1] if at + 1 < len(words) else None
    if word.text == "that" and before is not None and before.text == "so":
        return replace(word, tag="adverb")
    if word.text in ("all", "both") and before is not None and before.text in ("we", "you", "they"):
        return replace(word, tag="adverb")
    if word.text in _BEFORE_DETERMINERS and after is not None and after.text in _DETERMINED:
        return replace(word, tag="determiner")
    if word.text in ("close", "next", "ready") and after is not None and after.tag == "to":
        return replace(word, tag="adverb")
    if word.text in ("upstairs", "downstairs") and before is not None and before.tag == "determiner":
        return replace(word, tag="adjective" if after is not None and after.tag in ("noun", "adjective") else "adverb")
    if word.text == "light" and before is not None and before.text in _BEFORE_LIGHT:
        named = after is not None and after.tag in ("noun", "adjective")
        return word if named else replace(word, tag="noun")
    opens_phrase = after is not None and after.tag in ("noun", "adjective", "number")
    opens_phrase = opens_phrase and (after is None or after.text != "one" or word.text in _BEFORE_ONE)
    if word.tag == "determiner" and word.text in _PRONOUNS and not opens_phrase:
        return _that(word, before, after) if word.text == "that" else replace(word, tag="pronoun")
    if word.text == "that" and before is not None and before.tag == "noun" and after is not None:
        return replace(word, tag="relative") if verb_forms(after.text) and after.tag != "noun" else word
    if word.tag in ("adverb", "preposition") and before is not None and before.tag == "possessive":
        ends = after is None or after.tag not in ("noun", "adjective") or bool(verb_forms(after.text))
        return replace(word, tag="noun") if ends else word
    if word.tag in ("noun", "adjective", "preposition") and word.text.isalpha() and word.text != "like":
        found = _as_verb(words, at, lexicon)
        return word if found is None else found
    if word.text == "like" and before is not None and before.tag in ("modal", "somebody"):
        return replace(word, tag="verb", verb="like", form="base")
    if word.text == "her" and not opens_phrase:
        return replace(word, tag="somebody")
    existing = after is not None and (after.tag in ("be", "modal") or after.text in ("used", "seems", "has", "have"))
    asked = before is not None and before.tag == "be" and (at == 1 or words[at - 2].tag in ("mark", "joint"))
    if word.text == "there" and not existing and not asked:
        return replace(word, tag="adverb")
    if word.text == "one" and word.tag == "number" and (after is None or after.tag in _AFTER_PRONOUNS):
        return replace(word, tag="pronoun") if after is None or after.text != "of" else word
    return word


def _that(word: TaggedWord, before: TaggedWord | None, after: TaggedWord | None) -> TaggedWord:
    """Return ``that`` as a relative after a noun and before a clause, else as a pronoun."""
    goes_on = after is not None and (after.tag in ("be", "have", "modal", "somebody") or bool(verb_forms(after.text)))
    named = before is not None and before.tag in ("noun", "pronoun", "number")
    return replace(word, tag="relative" if named and goes_on else "pronoun")


def _as_verb(words: Sequence[TaggedWord], at: int, lexicon: Lexicon) -> TaggedWord | None:
    """Return a word as the form of a verb that it is here; None where it is none."""
    word = words[at]
    forms = verb_forms(word.text)
    before = words[at - 1] if at else None
    after = words[at + 1] if at + 1 < len(words) else None
    if word.text in _PREPOSITIONS:
        return None
    kinds = [form.form for form in forms]
    named = _is_name_here(words, at, lexicon)
    opens = before is None or before.tag in ("mark", "joint", "interjection", "subordinator")
    opens = opens or (before is not None and before.text in _BEFORE_ORDERS)
    if before is not None and before.verb in _EXCHANGING and word.text == "places":
        return None
    if opens and not forms and _is_order(words, at, lexicon):
        return replace(word, tag="verb", verb=word.text, form="base")
    if opens and "base" in kinds:
        object_follows = after is not None and after.tag in _BEGINNING_OBJECTS
        switched = after is not None and after.text in (_PARTICLES if word.text == "switch" else _AWAY)
        return None if named and not (object_follows or switched) else _formed(word, forms, "base")
    each_one = before is not None and before.text == "one" and at > 1 and words[at - 2].text in _BEFORE_ONE
    if each_one and "third" in kinds:
        return _formed(word, forms, "third")
    if before is not None and before.tag == "joint" and "third" in kinds and not named:
        return _formed(word, forms, "third")  # "the shredder is broken and stays off"
    if before is not None and _has_object(words, at, lexicon):
        several = singular(before.text) != before.text
        if "third" in kinds or ("base" in kinds and several):
            return _formed(word, forms, "third" if "third" in kinds else "base")
    if named and "third" in kinds and before is not None and _follows_somebody(words, at) and after is not None:
        return _formed(word, forms, "third")  # "nobody up here watches TV"
    if before is None or named:
        return None
    if "base" in kinds and words[at - 1].tag == "noun" and after is not None and after.text == "places":
        return _formed(word, forms, "base")
    people = before.text in _BETWEEN and at > 1 and words[at - 2].text in ("we", "i", "you", "they")
    if (people or before.tag in ("modal", "to", "do", "somebody", "not")) and "base" in kinds:
        return _formed(word, forms, "base")
    if "base" in kinds and _is_order_after_part(words, at):
        return _formed(word, forms, "base")
    if before.tag in ("be", "have", "adverb") or before.verb == "get" or word.text.endswith("ing"):
        best = next((kind for kind in _PARTICIPLES if kind in kinds), None)
        if best is not None:
            return _formed(word, forms, best)
    told = before.text == "," and "third" in kinds and after is not None and after.tag in ("preposition", "to")
    if told or before.tag in ("noun", "pronoun", "somebody", "adverb", "relative", "number"):
        return _after_subject(words, at, forms, before, after)
    return None


def _follows_somebody(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether only ``up here``, ``really`` stand between a person and a word."""
    start = at - 1
    while start > 0 and words[start].tag in ("adverb", "preposition") and at - start < 4:
        start -= 1
    opens = start == 0 or words[start - 1].tag in ("mark", "joint")
    return opens and words[start].tag == "somebody" and start >= 0


def _since_mark(words: Sequence[TaggedWord], at: int) -> Sequence[TaggedWord]:
    """Return the last few words before a place, since a mark or a verb."""
    start = next((k + 1 for k in range(at - 1, max(-1, at - 6), -1) if words[k].tag == "mark" or words[k].is_finite), 0)
    return words[max(start, at - 5) : at]


def _after_subject(
    words: Sequence[TaggedWord],
    at: int,
    forms: Sequence[tuple[str, Form]],
    before: TaggedWord,
    after: TaggedWord | None,
) -> TaggedWord | None:
    """Return a word after a noun as a finite verb, or a participle that goes with the noun; None for a further noun."""
    word = words[at]
    kinds = [form for _, form in forms]
    if "third" in kinds or "past" in kinds:
        return _formed(word, forms, "third" if "third" in kinds else "past")
    several = (
        any(one.text == "and" for one in _since_mark(words, at))
        or (before.tag == "number" and before.text != "one")
        or before.text in ("they", "these", "those", "both")
        or singular(before.text) != before.text
    )
    goes_on = after is None or after.tag not in ("verb", "be", "modal")
    if several and goes_on and "base" in kinds:
        return _formed(word, forms, "base")
    return _formed(word, forms, "participle") if "participle" in kinds else None


def _formed(word: TaggedWord, forms: Sequence[tuple[str, Form]], form: Form) -> TaggedWord:
    verb = next(verb for verb, kind in forms if kind == form)
    return replace(word, tag="verb", verb=verb, form=form)


def _is_name_here(words: Sequence[TaggedWord], at: int, lexicon: Lexicon) -> bool:
    """Whether a word that may be a verb names a thing here, by itself or with the word before or after it."""
    own = singular(words[at].text)
    before = words[at - 1] if at else None
    after = words[at + 1] if at + 1 < len(words) else None
    numbered = before is not None and before.tag == "number" and (before.text == "one" or before.text.isdecimal())
    others = at > 1 and words[at - 2].text in ("other", "the") and after is not None and after.tag in _BEGINNING_OBJECTS
    numbered = numbered or (before is not None and before.tag == "number" and others)
    if before is not None and before.tag in ("determiner", "possessive", "adjective", "number") and not numbered:
        return True
    if before is not None and before.tag == "noun" and lexicon.is_object((singular(before.text), own)):
        return True
    if after is not None and after.tag == "noun" and lexicon.is_called((own, singular(after.text))):
        return True
    if before is not None and before.tag in ("modal", "to", "do", "somebody", "be", "have", "not"):
        return False
    return lexicon.is_object((own,)) or lexicon.is_own_room((own,))


def _is_order(words: Sequence[TaggedWord], at: int, lexicon: Lexicon) -> bool:
    """Whether a word that begins a clause is an unknown verb with its object: ``reupholster the chair``."""
    after = words[at + 1] if at + 1 < len(words) else None
    beginning = after is not None and (after.tag in ("determiner", "possessive") or after.text in ("it", "them"))
    return beginning and words[at].tag == "noun" and not lexicon.is_object((singular(words[at].text),))


def _is_order_after_part(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether a verb follows the whole of which its object is a part: ``of the chairs in the hall take two``."""
    start = next((k for k in range(at - 1, 0, -1) if words[k - 1].tag == "mark"), 0)
    after = words[at + 1] if at + 1 < len(words) else None
    return words[start].text in ("of", "from") and after is not None and after.tag in ("number", "pronoun")


def _has_object(words: Sequence[TaggedWord], at: int, lexicon: Lexicon) -> bool:
    """Whether a word between a noun and a new noun group may only be a verb: ``the plant blocks the door``."""
    before, after = words[at - 1], words[at + 1] if at + 1 < len(words) else None
    if after is None or after.tag not in ("determiner", "possessive", "somebody", "pronoun"):
        return False
    name = (singular(before.text), singular(words[at].text))
    return before.tag == "noun" and not lexicon.is_object(name)
