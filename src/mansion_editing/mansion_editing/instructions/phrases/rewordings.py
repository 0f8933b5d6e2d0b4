"""Set phrases and slips of the pen that are read as what they stand for: ``which is why``, ``switch of the light``."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile
from typing import Final, TypeAlias

from mansion_editing.instructions.phrases.words import (
    DETERMINERS,
    PREPOSITIONS,
    PRONOUNS,
    UNRECORDED,
    Word,
    next_mark,
    text_at,
)

__all__ = ["reworded"]

_GLAD: Final = (("appreciate",), ("appreciate", "it"), ("be", "happy"), ("be", "glad"), ("be", "grateful"))
_PHRASES: Final[dict[tuple[str, ...], tuple[str, ...]]] = {
    **{(who, "would", *glad, "if"): ("it", "would", "be", "good", "if") for who in ("i", "we") for glad in _GLAD},
    **{(who, "from", "now", "on"): (who,) for who in ("i", "we", "you", "please")},
    ("change", "its", "name", "to"): ("rename", "it", "to"),
    ("change", "its", "name", "into"): ("rename", "it", "to"),
    ("which", "is", "why"): ("so",),
    ("that", "is", "why"): ("so",),
    ("that", "why"): ("so",),
    ("this", "is", "why"): ("so",),
    ("for", "which", "reason"): ("so",),
    ("for", "that", "reason"): ("so",),
    ("in", "between"): ("between",),
    ("must", "to", "be"): ("must", "be"),
    ("need", "to", "go"): ("must", "go"),
    ("should", "to", "be"): ("should", "be"),
    ("not", "need", "no", "more"): ("not", "need", "anymore"),
    ("not", "needed", "no", "more"): ("not", "needed", "anymore"),
    ("nor", "the"): ("and", "the"),
    ("no", "longer", "want"): ("not", "want"),
    ("no", "longer", "need"): ("not", "need", "anymore"),
    **{("along", "with", which): ("and", which) for which in ("the", "its", "their", "all", "both")},
    **{("together", "with", which): ("and", which) for which in ("the", "its", "their", "all", "both")},
    ("bring", "the", "number"): ("increase", "the", "number"),
    ("raise", "the", "number"): ("increase", "the", "number"),
    ("still", "lack"): ("lack",),
    **{("in", its, "spot"): ("in", "its", "place") for its in ("its", "that", "their")},
    ("in", "its", "stead"): ("in", "its", "place"),
    ("in", "their", "stead"): ("in", "their", "place"),
    **{("in", "place", "of", it): ("in", "its", "place") for it in ("it", "them")},
    ("cut", "down", "to"): ("reduce", "them", "to"),
    **{(under, "no", said): ("never",) for under, said in (("under", "circumstance"), ("on", "account"))},
    ("get", "shot", "of"): ("get", "rid", "of"),
    **{("where", it, was): ("in", "its", "place") for it in ("it", "that") for was in ("was", "stood")},
    ("where", "it", "used", "to", "be"): ("in", "its", "place"),
    ("where", "it", "is", "now"): ("in", "its", "place"),
    ("in", "whichever", "corner", "is", "free"): ("in", "a", "corner"),
    ("still", "need"): ("need",),
    **{("and", "in", said): ("and",) for said in ("return", "exchange")},
    ("apart", "of"): ("apart", "from"),
    ("except", "of"): ("except", "for"),
    ("with", "the", "exception", "of"): ("except", "for"),
    ("with", "exception", "of"): ("except", "for"),
    ("a", "bit", "of"): ("some",),
    ("one", "another"): ("another",),
    ("the", "both"): ("both", "the"),
    ("one", "of", "both"): ("one", "of", "the"),
    ("as", "soon", "as", "possible"): ("asap",),
    ("as", "soon", "as", "you", "can"): ("asap",),
    ("when", "you", "have", "time"): ("asap",),
    ("when", "you", "get", "a", "chance"): ("asap",),
    ("when", "you", "get", "the", "chance"): ("asap",),
    ("if", "you", "do", "not", "mind"): ("please",),
    ("if", "you", "not", "mind"): ("please",),
    ("if", "you", "please"): ("please",),
    ("would", "you", "mind"): ("please",),
    ("may", "i", "ask", "you", "to"): ("please",),
    ("can", "i", "ask", "you", "to"): ("please",),
    ("could", "i", "ask", "you", "to"): ("please",),
    ("might", "i", "ask", "you", "to"): ("please",),
    ("be", "so", "kind", "and"): ("please",),
    ("be", "so", "good", "and"): ("please",),
    ("be", "a", "dear", "and"): ("please",),
    ("be", "so", "kind", "as", "to"): ("please",),
    ("be", "so", "good", "as", "to"): ("please",),
    ("do", "me", "a", "favour", "and"): ("please",),
    ("do", "me", "a", "favor", "and"): ("please",),
    ("do", "us", "a", "favour", "and"): ("please",),
    ("i", "would", "be", "grateful", "if", "you", "could"): ("please",),
    ("i", "would", "appreciate", "it", "if", "you", "could"): ("please",),
    ("while", "you", "are", "at", "it"): ("also",),
    ("while", "you", "at", "it"): ("also",),
    ("when", "you", "at", "it"): ("also",),
    ("while", "at", "it"): ("also",),
    ("while", "you", "there"): ("also",),
    ("beside", "of"): ("beside",),
    ("besides", "of"): ("beside",),
    ("behind", "of"): ("behind",),
    ("under", "of"): ("under",),
    ("near", "of"): ("near",),
    ("near", "by", "to"): ("near",),
    ("near", "from"): ("near",),
    ("close", "from"): ("close", "to"),
    ("next", "of"): ("next", "to"),
    ("in", "front", "from"): ("in", "front", "of"),
    ("on", "top", "from"): ("on", "top", "of"),
    ("look", "to", "the"): ("face", "the"),
    ("right", "up", "to", "it"): ("beside", "it"),
    ("right", "up", "to", "them"): ("beside", "them"),
    ("wash", "machine"): ("washing", "machine"),
    ("need", "it", "no", "more"): ("need", "it", "anymore"),
    ("need", "it", "more"): ("need", "it", "anymore"),
    ("need", "them", "more"): ("need", "them", "anymore"),
    ("please", "to"): ("please",),
    ("while", "you", "are", "there"): ("also",),
    ("at", "the", "same", "time"): ("also",),
    ("for", "the", "time", "being"): ("for", "now"),
    ("for", "the", "moment"): ("for", "now"),
    ("at", "the", "moment"): ("now",),
    ("at", "present"): ("now",),
    ("right", "now"): ("now",),
    ("in", "total"): ("in", "all"),
    ("out", "of", "the", "way"): ("away",),
    ("only", "be"): ("be", "only"),
    ("just", "be"): ("be", "only"),
    ("only", "have"): ("have", "only"),
    ("only", "contain"): ("contain", "only"),
    ("only", "hold"): ("hold", "only"),
    ("rather", "have"): ("want",),
    ("rather", "see"): ("want",),
    ("could", "do", "with"): ("need",),
    ("can", "do", "with"): ("need",),
}  # fmt: skip
"""Words, longest first where one begins another, and the words that mean the same."""
_MADE: Final[dict[str, tuple[str, ...]]] = {
    "open": ("open",), "close": ("close",), "closed": ("close",), "shut": ("close",), "on": ("switch", "on"),
    "off": ("switch", "off"), "empty": ("empty",), "clear": ("clear",), "free": ("free",),
}  # fmt: skip
"""States before their thing, and the verbs that bring them about: ``make open the window``."""

_AT_EDGES: Final = frozenset(("if", "you", modal) for modal in ("would", "can", "could"))
"""Courtesies at the beginning or the end of a sentence."""
_SEEING_TO_IT: Final = frozenset((modal, "you", "see", "to", "it") for modal in ("would", "can", "could"))
"""What a sentence ends with that has said what to see to."""

_ADVERBIALS: Final = frozenset(
    tuple(said.split())
    for said in (
        "of course|though|tho|obviously|naturally|certainly|definitely|honestly|to be honest|frankly|as always|"
        "as agreed|as discussed|as promised|as mentioned|as said|as i said|by the way|if you ask me|in my opinion|"
        "for a change|once and for all|for good|just in case|for sure|for safety|i think|i guess|i suppose|i believe|"
        "as far as i know|with immediate effect|effective immediately|first of all|last but not least|ideally|"
        "or something similar|or something like that|or the like|"
        "or similar|"
        "preferably|if at all possible|while we are at it|where possible|if that is ok|if that is okay|"
        "if there is room|if there is space|if there is enough room|if there is enough space|if there room|"
        "if there space|if there still room|if there still space|if there is still room|if there is still space|"
        "if there enough room|if there enough space|if there is any room left|if there is room left|"
        "if there is room for it|if there is space for it|if there room for it|if there space for it|if it fits|"
        "if that is possible|if it is not too much trouble|if you get the time"
    ).split("|")
)
"""What speakers add at the edge of a clause, of themselves and the occasion: ``of course``, ``as discussed``."""
_LONGEST_ADVERBIAL: Final = max(map(len, _ADVERBIALS))

_FEW: Final = frozenset("one two three four five".split())
_IN_ORDER: Final = (("after", "that"), ("after", "this"), ("in", "the", "end"), ("at", "the", "end"), ("once", "done"))
_LATER: Final = frozenset("afterwards afterward".split())
"""Words that only say that steps come in the order in which they are told."""

_LONGEST: Final = max(map(len, _PHRASES))
_TURNING: Final = frozenset("switch turn power".split())
_OUT: Final = frozenset("in into on onto".split())
_GETTING: Final = frozenset("get set".split())
_GOING: Final = frozenset("going started working".split())
_OBLIGING: Final = frozenset("must should shall has have needs need".split())
_RESTING: Final = frozenset("sit stand lie hang".split())
_ARTICLES: Final = frozenset("the a an my our".split())
_CARRYING: Final = frozenset("carry bring take move get put".split())


def reworded(words: Sequence[Word]) -> list[Word]:
    """Return words with set phrases as their plain equivalents; each new word stands where the phrase stood."""
    words = _in_running_order(_half_dozens(_exceptions_that_stay(_exceptions_first(_excepting(words)))))
    out: list[Word] = []
    at = 0
    while at < len(words):
        new, length = _set_phrase(words, at) or _slip(words, at)
        out += new
        at += length
    return out


_Reworded: TypeAlias = tuple[list[Word], int]
"""The plain words, and how many words they stand for."""


def _set_phrase(words: Sequence[Word], at: int) -> _Reworded | None:
    """Return plain words for a set phrase at a place, none for what only fills; None where there is none."""
    length = next((n for n in range(_LONGEST, 1, -1) if tuple(w.text for w in words[at : at + n]) in _PHRASES), 0)
    if length:
        phrase = words[at : at + length]
        return _in_place_of(phrase, _PHRASES[tuple(word.text for word in phrase)]), length
    made = _MADE.get(text_at(words, at + 1)) if words[at].text == "make" else None
    if made is not None and text_at(words, at + 2) in DETERMINERS | PRONOUNS:
        return _in_place_of(words[at : at + 2], made), 2
    for read, plain in _PLAIN.items():
        count = read(words, at)
        if count:
            return _in_place_of(words[at : at + count], plain), count
    ended = _end_of_adverbial(words, at) or _end_of_order(words, at)
    if ended > at:
        return [], ended - at
    if words[at].text in _LATER and at and _is_edge(words, at, at + 1):
        return _in_place_of(words[at : at + 1], ("please",)), 1
    return None


def _slip(words: Sequence[Word], at: int) -> _Reworded:
    """Return the word that is meant at a place; no word where it is idle."""
    word, before, following = words[at], text_at(words, at - 1), text_at(words, at + 1)
    if word.text == "each" and before in _OUT | {"at"} and _is_end(words, at + 1):
        return [word, *_in_place_of([word], ("of",)), *_in_place_of([word], ("them",))], 1
    if word.text == "form" and following in DETERMINERS and at and words[at - 1].kind == "word":
        return [replace(word, text="from")], 1
    if word.text == "whatever" and following in ("is", "lie", "stand"):
        return [*_in_place_of([word], ("everything",)), *_in_place_of([word], ("that",))], 1
    if _is_taken_from(words, at) or (word.text == "," and before in UNRECORDED and following in UNRECORDED):
        return [], 1
    if _is_foreign(words, at):
        new = "of" if word.text == "from" else "that"
        return [replace(word, text=new, raw=new)], 1
    if _is_idle_out(words, at) or _is_idle_over(words, at):
        return [], 1
    return [_topped_up(words, at) or _turned_off(words, at)], 1


def _end_of_order(words: Sequence[Word], at: int) -> int:
    """Return the end of ``After that``, ``In the end`` before a clause, which say that steps come in their order."""
    if at and words[at - 1].kind != "mark":
        return at
    length = next((len(said) for said in _IN_ORDER if tuple(w.text for w in words[at : at + len(said)]) == said), 0)
    following = text_at(words, at + length)
    subject = following in DETERMINERS | PRONOUNS | {",", "please", "there", "i", "we", "you"}
    return at + length + (following == ",") if length and subject else at


def _is_taken_from(words: Sequence[Word], at: int) -> bool:
    """Whether ``away`` stands before ``from`` where something is taken: it was there, and goes on elsewhere."""
    clause = takewhile(lambda word: word.kind != "mark" and word.text != "and", reversed(words[:at]))
    taken = any(word.text in ("take", "bring", "carry", "get", "fetch") for word in clause)
    return text_at(words, at) == "away" and text_at(words, at + 1) == "from" and taken


def _as_many_as_missing(words: Sequence[Word], at: int) -> int:
    """Return how many words ``add as many as are missing so there are`` is before the number that there shall be."""
    said = [word.text for word in words[at : at + 14]]
    verb = 2 if said[:2] in (["take", "away"], ["take", "out"]) else 1
    if said[0] not in ("add", "bring", "put", "remove", "take") or said[verb : verb + 3] != ["as", "many", "as"]:
        return 0
    left = next((k for k in range(verb + 3, len(said) - 1) if said[k : k + 2] == ["left", "with"]), 0)
    if left and "needed" in said[:left] and at + left + 2 < len(words) and words[at + left + 2].kind == "number":
        return left + 2
    if verb > 1:
        return 0
    end = 4 + (said[4:5] in (["are"], ["is"]))
    if said[end : end + 1] not in (["missing"], ["needed"], ["necessary"], ["required"], ["needs"], ["need"]):
        return 0
    end += 1 + (said[end + 1 : end + 2] == ["to"]) + (said[end + 1 : end + 2] == ["so"])
    end += said[end : end + 1] == ["that"]
    there = said[end : end + 2] == ["there", "are"]
    counted = at + end + 2 < len(words) and words[at + end + 2].kind == "number"
    return end + 2 if there and counted else 0


def _end_of_adverbial(words: Sequence[Word], at: int) -> int:
    """Return the end of ``, of course``, ``as discussed,`` at the edge of a clause; 0 where there is none."""
    comma = text_at(words, at) == ","
    start = at + comma
    for count in range(_LONGEST_ADVERBIAL, 0, -1):
        end = start + count
        if tuple(w.text for w in words[start:end]) not in _ADVERBIALS:
            continue
        begins = not at or words[at - 1].kind == "mark"
        ends = _is_end(words, end)
        if comma:
            placed = ends or text_at(words, start) in ("ideally", "preferably")
            return end + (ends and text_at(words, end) == "," and _is_end(words, end + 1)) if placed else 0
        if begins and text_at(words, end) == ",":
            return end + 1
        if ends or (begins and text_at(words, end) in PREPOSITIONS | DETERMINERS | {"please", "i", "we", "you"}):
            return end
        return end if text_at(words, start) in ("ideally", "preferably", "or") else 0
    return 0


def _exceptions_first(words: Sequence[Word]) -> Sequence[Word]:
    """Return ``all but one of the bags in the hall`` for ``all bags in the hall but one``, ``..., except for one``."""
    for at in range(2, len(words) - 1):
        said = (text_at(words, at), text_at(words, at + 1))
        length = 2 if said in (("except", "for"), ("apart", "from"), ("save", "for")) else said[0] in ("but", "except")
        number = text_at(words, at + length)
        if not length or number not in _FEW or not _is_edge(words, 0, at + length + 1):
            continue
        joined = text_at(words, at - 1) == ","
        words = [*words[: at - joined], replace(words[at], text="but"), *words[at + length :]]
        at -= joined
        start = next(
            (k for k in range(at - 2, -1, -1) if words[k].text in ("all", "every") or words[k].kind == "mark"), -1
        )
        if start < 0 or words[start].text != "all":
            continue
        after = start + 1 + (text_at(words, start + 1) == "of")
        bare = text_at(words, after) not in DETERMINERS
        joint = [replace(words[at + 1], text=text, raw=text) for text in (("of", "the") if bare else ("of",))]
        return [*words[: start + 1], *words[at : at + 2], *joint, *words[after:at], *words[at + 2 :]]
    return words


def _exceptions_that_stay(words: Sequence[Word]) -> Sequence[Word]:
    """Return ``except the lamp, the lamp must stay on`` for ``except the lamp, which must stay on``."""
    for at in range(2, len(words) - 1):
        verb = at + 1 + (text_at(words, at + 1) in _OBLIGING) + (text_at(words, at + 2) == "to")
        if words[at].text not in ("which", "that") or text_at(words, verb) not in ("stay", "remain"):
            continue
        end = at - (words[at - 1].text == ",")
        start = next((k for k in range(end - 1, 0, -1) if words[k].kind == "mark" or _excepts(words, k)), 0)
        spared = words[start:end]
        if start and spared and spared[0].text in DETERMINERS and _excepts(words, start):
            comma = replace(words[at], text=",", raw=",", kind="mark", start=words[end - 1].end, end=words[end - 1].end)
            return [*words[:end], comma, *spared, *words[at + 1 :]]
    return words


def _excepting(words: Sequence[Word]) -> Sequence[Word]:
    """Return ``all chairs except those at the table`` for ``all chairs which are not at the table``."""
    out: list[Word] = []
    at = 0
    while at < len(words):
        contracted = text_at(words, at + 1) == "not" and words[at + 1].raw != "not"
        denied = at + 2 - contracted
        told = text_at(words, at) in ("which", "that") and text_at(words, denied) == "not"
        clause = {word.text for word in takewhile(lambda word: word.kind != "mark", reversed(out))}
        whole = clause & {"all", "every", "each"}
        being = contracted or text_at(words, at + 1) in ("is", "are")
        if not (told and whole and being and text_at(words, denied + 1) in ("on", "in", "at", "under", "by", "inside")):
            out.append(words[at])
            at += 1
            continue
        out += _in_place_of(words[at : denied + 1], ("except", "those"))
        at = denied + 1
    return out


def _excepts(words: Sequence[Word], at: int) -> bool:
    """Whether the words before a place begin an exception."""
    return text_at(words, at - 1) in ("except", "but", "excluding", "besides") or (
        (text_at(words, at - 2), text_at(words, at - 1))
        in (("apart", "from"), ("aside", "from"), ("except", "for"), ("save", "for"), ("other", "than"))
    )


def _half_dozens(words: Sequence[Word]) -> Sequence[Word]:
    """Return ``six mugs`` for ``half a dozen mugs``, ``a half dozen mugs``."""
    out: list[Word] = []
    for word in words:
        before = [other.text for other in out[-2:]]
        half = 2 if before in (["half", "a"], ["a", "half"]) else 1 if before[-1:] == ["half"] else 0
        if word.text != "dozen" or not half:
            out.append(word)
            continue
        out[-half:] = [replace(word, text="six", raw="six", kind="number", value=6.0, start=out[-half].start)]
    return out


def _in_running_order(words: Sequence[Word]) -> Sequence[Word]:
    """Return ``get the fan running`` for ``get the fan going``, ``get the fan started``."""
    out = list(words)
    for at, word in enumerate(words):
        get = next((k for k in range(at - 1, -1, -1) if words[k].kind == "mark" or words[k].text in _GETTING), -1)
        if word.raw in _GOING and get >= 0 and text_at(words, get + 1) in DETERMINERS | PRONOUNS and at > get + 1:
            out[at] = replace(word, text="running", raw="running")
    return out


def _in_place_of(phrase: Sequence[Word], texts: Sequence[str]) -> list[Word]:
    """Return the new words, the last of which ends where the phrase does."""
    kept = phrase[: len(texts) - 1]
    last = replace(phrase[len(kept)], text=texts[-1], raw=texts[-1], end=phrase[-1].end, genitive=False)
    return [*(replace(w, text=t, raw=t if t != w.text else w.raw) for w, t in zip(kept, texts, strict=False)), last]


def _is_edge(words: Sequence[Word], start: int, end: int) -> bool:
    return start == 0 or words[start - 1].kind == "mark" or end >= len(words) or words[end].kind == "mark"


def _courtesy_at(words: Sequence[Word], at: int) -> int:
    """Return how many words ``if you could``, ``could you see to it`` are that stand by themselves; 0 for others."""
    if tuple(w.text for w in words[at : at + 3]) in _AT_EDGES and _is_edge(words, at, at + 3):
        return 3
    return 5 if tuple(w.text for w in words[at : at + 5]) in _SEEING_TO_IT and _is_end(words, at + 5) else 0


def _is_end(words: Sequence[Word], at: int) -> bool:
    return at >= len(words) or words[at].kind == "mark"


def _turned_off(words: Sequence[Word], at: int) -> Word:
    """Return ``of`` as ``off`` in ``switch of the lamp``."""
    word = words[at]
    slip = word.text == "of" and text_at(words, at - 1) in _TURNING and text_at(words, at + 1) in DETERMINERS
    return replace(word, text="off") if slip else word


def _topped_up(words: Sequence[Word], at: int) -> Word | None:
    """Return ``increase`` for the verb of ``top them up to four``."""
    following = words[at + 1] if at + 1 < len(words) else None
    if words[at].text != "top" or following is None or following.text not in DETERMINERS | PRONOUNS:
        return None
    raised = any((text_at(words, k), text_at(words, k + 1)) == ("up", "to") for k in range(at + 2, at + 7))
    return replace(words[at], text="increase") if raised else None


def _is_foreign(words: Sequence[Word], at: int) -> bool:
    """Whether ``from`` stands for ``of`` ("one from the two plants"), or ``what`` for ``that`` ("plants what are")."""
    before = words[at - 1] if at else None
    if words[at].text == "from" and before is not None and before.text in _FEW:
        number = text_at(words, at + 2) in _FEW
        return number and text_at(words, at + 1) in ("the", "these", "those", "our", "my")
    if words[at].text == "what" and text_at(words, at + 1) in _RESTING:
        return _ends_subject(words, at)
    relative = words[at].text == "what" and text_at(words, at + 1) in ("is", "are")
    return relative and before is not None and before.kind == "word" and before.plural and before.text not in PRONOUNS


def _ends_subject(words: Sequence[Word], at: int) -> bool:
    """Whether words before a place are a thing with its article and without a preposition: ``the bear what sits``."""
    start = next((k for k in range(at - 2, max(-1, at - 5), -1) if text_at(words, k) in _ARTICLES), -1)
    plain = start >= 0 and all(word.kind == "word" and word.text not in PREPOSITIONS for word in words[start:at])
    return plain and text_at(words, start - 1) not in PREPOSITIONS


def _supposed(words: Sequence[Word], at: int) -> int:
    """Return how many words of ``Should there still be`` stand for ``if there is`` before a comma; 0 for others."""
    if (text_at(words, at), text_at(words, at + 1)) != ("should", "there") or not (
        at == 0 or words[at - 1].kind == "mark"
    ):
        return 0
    end = at + 2 + (text_at(words, at + 2) in ("still", "already", "now"))
    stop = next_mark(words, end)
    return end + 1 - at if text_at(words, end) == "be" and text_at(words, stop) == "," else 0


def _is_idle_over(words: Sequence[Word], at: int) -> bool:
    """Whether ``over`` only goes with a verb and its pronoun: ``carry it over``."""
    after = text_at(words, at - 1) in PRONOUNS and text_at(words, at - 2) in _CARRYING
    return words[at].text == "over" and after and _is_edge(words, 1, at + 1)


def _is_idle_out(words: Sequence[Word], at: int) -> bool:
    """Whether ``out`` only strengthens the preposition after it: ``the sign out in the corridor``."""
    if words[at].text != "out" or text_at(words, at + 1) not in _OUT:
        return False
    before = words[at - 1] if at else None
    return before is not None and before.kind == "word" and before.text not in PREPOSITIONS | {"put", "set", "lay"}


_PLAIN: Final = {_supposed: ("if", "there", "is"), _courtesy_at: ("please",), _as_many_as_missing: ("make", "it")}
"""Readers of phrases that vary, which return how many words they are, and the plain words."""
