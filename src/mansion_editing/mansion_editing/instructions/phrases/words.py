"""Words of an instruction, and the closed classes of English that clauses and phrases are told apart by."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

from mansion_language import tokenize
from mansion_language.spelling import Speller
from mansion_language.tokens import Token

__all__ = [
    "ADVERBS",
    "ARTICLES",
    "BE",
    "BREAKS",
    "CONJUNCTIONS",
    "COURTESIES",
    "DETERMINERS",
    "FUNCTION_WORDS",
    "HAVE",
    "MODALS",
    "NEED",
    "PARTICIPLES_OF_REST",
    "PERSONS",
    "PREPOSITIONS",
    "PRONOUNS",
    "REASONS",
    "PLURAL_PRONOUNS",
    "SENTENCE_ENDS",
    "STATE_WORDS",
    "UNRECORDED",
    "VAGUE",
    "Word",
    "next_mark",
    "split_words",
    "text_at",
    "with_leading_marks",
]


@dataclass(frozen=True)
class Word:
    """A word, number, unit or mark.

    Attributes
    ----------
    text : str
        Lower case, in the singular, with its spelling mended.
    raw : str
        Lower case as it was written; of an object's id, the id.
    kind : str
        As of a `Token`, or ``id``.
    start, end : int
        Place in the text, in characters.
    value : float
        Of numbers, ordinals and levels.
    genitive : bool
        Written with 's.
    """

    text: str
    raw: str
    kind: str
    start: int
    end: int
    value: float = 0.0
    plural: bool = False
    genitive: bool = False
    capital: bool = False


ARTICLES: Final = frozenset(["a", "an", "the"])
DETERMINERS: Final = ARTICLES | frozenset(
    "this that these those my our your his her their its any some such each every all both another no enough".split()
)
PRONOUNS: Final = frozenset(["it", "them", "they", "this", "that", "these", "those"])
PLURAL_PRONOUNS: Final = frozenset("them they these those both".split())
PERSONS: Final = frozenset(
    "i we he she someone somebody anyone anybody everyone everybody people robot guest visitor client customer "
    "patient person staff user wheelchair-user kid nobody nurse employee".split()
)
BE: Final = frozenset(["is", "are", "be", "was", "were", "been", "being", "am", "stay", "remain"])
MODALS: Final = frozenset(
    ["should", "must", "shall", "will", "would", "can", "could", "may", "might", "ought", "cannot"]
)
HAVE: Final = frozenset(["have", "has", "had", "get", "gets", "contain", "hold", "include", "feature", "offer"])
NEED: Final = frozenset(["need", "needs", "want", "wants", "require", "lack", "deserve", "miss"])
CONJUNCTIONS: Final = frozenset(["and", "or", "but", "then", "plus", "while", "whereas", "&", "+", "nor", "yet", "so"])
REASONS: Final = frozenset(["because", "since", "as", "cause", "cos", "otherwise", "if", "when", "until", "unless"])
PREPOSITIONS: Final = frozenset(
    "on onto upon in into inside within at by beside besides near nearby under underneath beneath below above over "
    "behind between among from off out to towards toward around along against opposite facing with without for of "
    "alongside across through up down next close left right front middle centre center corner instead except but "
    "per atop via amid round throughout".split()
)
STATE_WORDS: Final = {
    "on": ("on", True), "off": ("on", False), "open": ("open", True), "opened": ("open", True),
    "closed": ("open", False), "shut": ("open", False), "close": ("open", False), "running": ("on", True),
    "lit": ("on", True), "unlit": ("on", False), "ajar": ("open", True),
}  # fmt: skip
PARTICIPLES_OF_REST: Final = frozenset(
    "standing lying sitting hanging resting placed put located found kept stored left mounted installed leaning "
    "positioned situated parked laid grouped gathered waiting ready available set stacked arranged provided added "
    "there present that which who".split()
)
COURTESIES: Final = frozenset(
    "please pls plz thanks thank thx kindly hi hello hey dear ok okay yes sorry alright well cheers thankyou "
    "hiya howdy hm hmm oh ah ty sir team mansion ugh wow oops damn haha lol btw fyi folks guys".split()
)
ADVERBS: Final = frozenset(
    "now also too again just really very quite quickly simply immediately asap first next finally afterwards "
    "meanwhile still already back over right straight directly exactly properly carefully completely fully "
    "entirely totally somewhere anywhere maybe perhaps instead together only else as well either once then "
    "therefore today tonight tomorrow here actually basically slightly bit little even same way thus altogether "
    "neatly nicely safely gently everywhere along though itself themselves anyway however besides".split()
)
_OF_TASTE: Final = frozenset(
    "comfy snug posh fabulous spacious roomy sleek chic trendy classy rustic vintage antique retro "
    "contemporary ergonomic lightweight chunky slim slender giant enormous massive gigantic oversized "
    "medium-sized mid-sized decorative ornate plush fluffy cuddly squishy padded practical handy reliable "
    "robust silent noisy squeaky wobbly rickety creaky shabby worn-out tatty scruffy grubby dusty filthy "
    "stained smelly stinky mouldy brand-new pristine spotless shiny sparkling cheerful colourful colorful "
    "funky quirky adorable tasteful luxurious expensive pricey inexpensive affordable delicious yummy "
    "friendly calming soothing inviting welcoming homely biggish smallish".split()
)
"""Adjectives of taste, size and wear, which no scene describes and no name of a thing has."""

UNRECORDED: Final = _OF_TASTE | frozenset(
    "nice new small large big clean fresh cosy cozy comfortable modern old fancy simple pretty beautiful lovely little "
    "tiny huge tall long wide low high round rectangular dirty tasty warm cute elegant cheap sturdy soft heavy "
    "stylish ripe smaller larger bigger taller newer nicer better softer brighter wider comfier prettier "
    "lighter".split()
)
"""Adjectives that are understood but that no scene describes."""

VAGUE: Final = _OF_TASTE | frozenset(
    "nice new small large big clean fresh full empty good proper decent spare extra additional cosy cozy comfortable "
    "modern old fancy simple plain pretty beautiful lovely little tiny huge tall short long wide narrow low high "
    "normal usual standard regular suitable matching similar different own personal certain main existing current "
    "single individual separate loose dirty tasty hot warm tidy cute elegant cheap sturdy soft heavy light dark "
    "bright stylish random correct appropriate several whole entire more other further free available ripe "
    "unused used broken cold chilled cool iced refrigerated favourite favorite old-fashioned possible actual "
    "round rectangular particular required necessary freestanding stray second-hand visible "
    "matching useless unneeded unnecessary remaining respective "
    "awful ugly horrible hideous terrible dreadful ghastly nasty tacky silly stupid damn bloody wretched boring "
    "smaller larger bigger taller newer nicer better softer brighter wider comfier prettier lighter "
    "folded gorgeous wonderful charming favourite precious trusty".split()
)
BREAKS: Final = frozenset([",", ";", ".", ":", "!", "?", "\n", "-", "(", ")", '"', "*", "/", "=", "#", "|", "[", "]"])
FUNCTION_WORDS: Final = (
    DETERMINERS | PRONOUNS | BE | MODALS | HAVE | NEED | CONJUNCTIONS | REASONS | PREPOSITIONS | COURTESIES | ADVERBS
    | frozenset(["not", "there", "i", "we", "you", "he", "she", "do", "does", "did", "let", "how", "what", "where",
                 "which", "who", "many", "much", "none", "nothing", "everything", "anything", "something", "one",
                 "most", "least", "nearest", "closest", "furthest", "farthest", "few", "half", "us", "me", "him",
                 "largest", "biggest", "smallest", "tallest", "shortest", "make", "sure", "ensure", "remove", "want"])
)  # fmt: skip

_SHORT: Final = {
    "pls": "please", "plz": "please", "u": "you", "ur": "your", "w": "with", "thx": "thanks", "bcs": "because",
    "cuz": "because", "cos": "because", "tv": "tv", "bedrm": "bedroom", "rm": "room", "flr": "floor", "ppl": "people",
    "wanna": "want", "gonna": "will", "lemme": "let", "gimme": "give", "n": "and", "&": "and", "smth": "something",
    "sth": "something", "centre": "middle", "center": "middle", "storey": "floor", "story": "floor", "level": "floor",
    "upon": "on", "onto": "onto",
    "meter": "metre", "lift": "elevator", "kid": "child", "fl": "floor", "goes": "go",
    "teh": "the", "frm": "from", "ad": "add", "al": "all", "adn": "and", "taht": "that", "hte": "the",
    **dict.fromkeys(
        "dont doesnt shouldnt isnt arent cant wont mustnt didnt hasn hasnt haven havent hadn wouldn couldn needn"
        " neednt shouldn mustn".split(),
        "not",
    ),
}  # fmt: skip
_ID: Final = re.compile(r"\b[fF]-?\d+/[A-Za-z0-9_./-]*[A-Za-z0-9_]|\b[a-z]+(?:_[a-z0-9]+)+\b")
_DOUBLE: Final = str.maketrans(dict.fromkeys("“”„«»", '"'))
_SINGLE: Final = re.compile(r"(?<![A-Za-z0-9])'([^'\n]{1,40})'(?![A-Za-z0-9])")
"""A name between single quotation marks, and no genitive."""
_DOTTED: Final = re.compile(r"\b(fl|flr|rm|no|nr|approx|ca|st|incl|mr|mrs|ms|dr|prof)\.(?=\s)", re.IGNORECASE)
"""Abbreviations whose point ends no sentence."""


def split_words(text: str, speller: Speller, kept: frozenset[str]) -> list[Word]:
    """Return the words of a text.

    Parameters
    ----------
    speller : Speller
        Knows the words that a mistake may have stood for.
    kept : frozenset of str
        English words that are no mistakes, though the speller does not know them.
    """
    text = _DOTTED.sub(r"\1 ", text)
    text = _SINGLE.sub(r'"\1"', text.replace("’", "'").replace("‘", "'").replace("`", "'").translate(_DOUBLE))
    ids = {match.start(): match for match in _ID.finditer(text)}
    hidden = _ID.sub(lambda match: "q" * len(match.group()), text)
    words = [
        Word(ids[t.start].group(), ids[t.start].group(), "id", t.start, t.end)
        if t.start in ids
        else _word(t, hidden, speller, kept)
        for t in tokenize(hidden)
    ]
    return _without_pleas(_join_codes(words))


def _without_pleas(words: list[Word]) -> list[Word]:
    """Leave out a ``please`` that stands between a thing and its place: ``a plant please, in a corner``."""
    out: list[Word] = []
    for at, word in enumerate(words):
        within = out and text_at(words, at + 1) == "," and text_at(words, at + 2) in PREPOSITIONS | {"same"}
        if word.text == "please" and within:
            out = out[:-1] if out[-1].text == "," else out
            continue
        out.append(word)
    return out


def _word(token: Token, text: str, speller: Speller, kept: frozenset[str]) -> Word:
    raw = text[token.start : token.end].lower()
    own = _SHORT.get(token.text, token.text)
    plain = token.kind == "word"
    if plain and len(own) >= 4 and own not in FUNCTION_WORDS and own not in kept and raw not in kept:
        own = speller.nearest(own)
    genitive = plain and (raw.endswith(("'s", "s'")) and not raw.startswith(("let", "it", "that", "there", "what")))
    return Word(own, raw, token.kind, token.start, token.end, token.value, token.plural, genitive, token.capital)


def _join_codes(words: list[Word]) -> list[Word]:
    """Join ``2`` and ``B`` of ``2B`` into one word."""
    joined: list[Word] = []
    for word in words:
        last = joined[-1] if joined else None
        touching = last is not None and last.end == word.start and word.kind == "word" and len(word.text) == 1
        if last is not None and touching and last.kind == "number" and last.raw.isdecimal():
            joined[-1] = replace(last, text=last.raw + word.raw, raw=last.raw + word.raw, kind="code", end=word.end)
        else:
            joined.append(word)
    return joined


def text_at(words: Sequence[Word], at: int) -> str:
    """Return the word at a place, empty before the first and beyond the last."""
    return words[at].text if 0 <= at < len(words) else ""


SENTENCE_ENDS: Final = frozenset((".", "!", "?", ";", "\n"))
"""Marks between sentences, and between main clauses that stand by themselves."""


def with_leading_marks(words: Sequence[Word]) -> Iterator[list[Word]]:
    """Yield the sentences of words, each with the mark that ends the one before it."""
    at = 0
    while at < len(words):
        end = at + 1
        while end < len(words) and words[end].text not in SENTENCE_ENDS:
            end += 1
        yield list(words[at:end])
        at = end


def next_mark(words: Sequence[Word], at: int) -> int:
    """Return the place of the first mark from a place on, or the end of the words."""
    return next((k for k in range(at, len(words)) if words[k].kind == "mark"), len(words))
