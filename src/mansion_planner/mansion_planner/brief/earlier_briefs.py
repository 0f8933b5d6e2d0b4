"""Leave out what a writer says of earlier briefs and wishes: "scratch what I sent on Monday", "I had asked for two"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["without_recalled_wishes", "without_withdrawn_briefs"]

_WITHDRAWING = frozenset(
    "scratch forget ignore disregard discard scrap drop skip bin delete cancel dismiss replace".split()
)
_POLITE = frozenset({"please", "oh", ",", "sorry", "so", "and", "hi", "hello", "ok", "okay", "kindly", "just"})
_OWNERS = frozenset({"my", "our", "the", "that", "this", "all", "his", "her", "their", "any"})
_EARLIER = frozenset(
    "last first earlier previous old other former original initial yesterday monday tuesday wednesday thursday friday "
    "saturday sunday prior preceding of".split()
)
_MESSAGES = frozenset(
    """
    mail email message note brief version request draft sketch idea plan list letter text attempt description proposal
    programme program order spec specification post scheme enquiry inquiry wish
    """.split()
)
_ABOVE = frozenset({"above", "before", "far"})
"""Words that speak of what the same text says before."""
_NEW = frozenset("new latest corrected final updated revised second current actual real".split())
_ANNOUNCING = (
    _NEW | _MESSAGES | frozenset("here is are come the my our one now instead try so what we want need".split())
)
_RESTARTS = frozenset({"now", "we", "i", "here", "instead", "please", "the", "it", "this", "what", "my", "our"})
_ENDS = frozenset({".", "!", "\n", ";", ":", "?"})
_FEWEST = 3
"""Tokens that a new brief has at least."""


def without_withdrawn_briefs(tokens: list[Token]) -> list[Token]:
    """Return the tokens without sentences that withdraw an earlier brief, and without "New version:".

    What the same text says before "forget all of the above" goes with it.
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        opens = index == 0 or tokens[index - 1].text in _ENDS
        end = _withdrawal(tokens, index) if opens else 0
        if end:
            if _speaks_of_above(tokens, index, end):
                result = []
            index = end
            continue
        announced = _announcement(tokens, index) if opens else 0
        if announced:
            index = announced
            continue
        result.append(tokens[index])
        index += 1
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _withdrawal(tokens: list[Token], index: int) -> int:
    """Return the token after a sentence that withdraws an earlier brief, where a new one follows; or 0."""
    at = index
    while _text(tokens, at) in _POLITE and at - index < 4:
        at += 1
    if _text(tokens, at) not in _WITHDRAWING:
        return 0
    at += 1 + (_text(tokens, at + 1) == "about")
    if not (_is_clause(tokens, at) or _is_message(tokens, at)):
        return 0
    end = _end(tokens, at)
    if "about" in [token.text for token in tokens[at:end]]:
        return 0  # "forget what I said about the roof garden" takes back a part
    return end if len(tokens) - end >= _FEWEST else 0


def _is_clause(tokens: list[Token], at: int) -> bool:
    """Whether "what I sent", "everything we asked for", "all that", "all of the above" begins at a token."""
    if _text(tokens, at) in ("what", "everything", "all"):
        after = at + 1
        while _text(tokens, after) in ("that", "of", "the", "this", "what"):
            after += 1
        if _text(tokens, after) in ("i", "we", "you", "he", "she", "they") or _text(tokens, after) in _ABOVE:
            return True
        return after > at + 1 and _text(tokens, after) in _ENDS
    return _text(tokens, at) == "the" and _text(tokens, at + 1) == "above"


def _is_message(tokens: list[Token], at: int) -> bool:
    """Whether "my last mail", "the earlier version" begins at a token."""
    if _text(tokens, at) not in _OWNERS:
        return False
    after = at + 1
    while _text(tokens, after) in _EARLIER | _OWNERS:
        after += 1
    told = after > at + 1 or _text(tokens, after + 1) in ("from", "of", "i", "we", "with", "above", "before", "(")
    return told and _text(tokens, after) in _MESSAGES


def _end(tokens: list[Token], at: int) -> int:
    """Return the token after the sentence, or after the comma at which the new brief begins."""
    depth = 0
    while at < len(tokens):
        text = tokens[at].text
        depth += (text == "(") - (text == ")")
        restarts = text in (",", "-", "–") and _text(tokens, at + 1) in _RESTARTS and _text(tokens, at + 2) != "one"
        if depth <= 0 and (text in _ENDS or restarts):
            return at + 1
        at += 1
    return at


def _speaks_of_above(tokens: list[Token], first: int, last: int) -> bool:
    """Whether a withdrawal is of what the same text says before it."""
    texts = [token.text for token in tokens[first:last]]
    said = {"sent", "mailed", "emailed", "posted", "mail", "email", "message", "letter"} & set(texts)
    whole = bool({"all", "everything"} & set(texts)) or bool(_ABOVE & set(texts))
    return whole and not said


def _announcement(tokens: list[Token], index: int) -> int:
    """Return the token after "New version:", "Here is the corrected list:"; or 0."""
    end = index
    while end < len(tokens) and tokens[end].text in _ANNOUNCING and end - index < 8:
        end += 1
    texts = {token.text for token in tokens[index:end]}
    return end + 1 if _text(tokens, end) == ":" and texts & _NEW and texts & (_MESSAGES | {"one", "try"}) else 0


_SENTENCE_ENDS = frozenset({".", ";", "\n", "!", "?"})
_WISHING = frozenset("said written wrote asked ask wanted thought planned mentioned put had considered hoped".split())
_FORMERLY = frozenset({"before", "first", "earlier", "originally", "previously", "initially", "once"})
_GIVEN_UP = (
    ("not", "needed"), ("not", "necessary"), ("leave", "it"), ("forget", "it"), ("drop", "it"), ("skip", "it"),
    ("leave", "that"), ("forget", "that"), ("forget", "about"), ("no", "longer"), ("not", "any"), ("said", "no"),
    ("say", "no"), ("says", "no"), ("given", "up"), ("gave", "up"), ("too", "expensive"), ("too", "dear"),
)  # fmt: skip
_LEADS = frozenset({"for", "a", "an", "the", "some", "to", "have", "of", "about", "up"})
_CLOSERS = frozenset({",", "but", "and", "now", "in", "on", "so", "(", "-"})
_LONGEST = 3


def without_recalled_wishes(tokens: list[Token]) -> list[Token]:
    """Return the tokens without the sentences that recall an earlier wish and say that it does not hold any more."""
    result: list[Token] = []
    first = 0
    while first < len(tokens):
        last = first
        while last < len(tokens) and tokens[last].text not in _SENTENCE_ENDS:
            last += 1
        sentence = tokens[first:last]
        verb = _recall(sentence)
        kept = sentence if verb is None else _refusal(sentence, verb)
        result += [*kept, *tokens[last : last + 1]] if kept or verb is None else []
        first = last + 1
    return result


def _recall(sentence: list[Token]) -> int | None:
    """Return the verb of an earlier wish in a sentence that has nothing to say of the present but that it fell away."""
    texts = [token.text for token in sentence]
    verb = next((at for at, text in enumerate(texts[:8]) if at and text in _WISHING), None)
    if texts[:4] == ["there", "was", "talk", "of"]:
        verb = 3
    elif verb is None or (_FORMERLY.isdisjoint(texts) or not {"i", "we", "at"} & set(texts[:verb])):
        return None
    tail = next((at for at in range(verb, len(texts)) if texts[at] in (",", "but", "now")), len(texts))
    given_up = _gives_up(texts[tail:])
    enough = texts[-2:] == ["is", "enough"] or texts[-2:] == ["are", "enough"]
    return verb if (tail == len(texts) and verb != 3) or given_up or enough else None


def _gives_up(texts: list[str]) -> bool:
    return any(tuple(texts[at : at + 2]) in _GIVEN_UP for at in range(len(texts)))


def _refusal(sentence: list[Token], verb: int) -> list[Token]:
    """Return "no storage" for a sentence that gives it up; nothing where the text has a number of what it recalls."""
    first = verb + 1
    while first < len(sentence) and sentence[first].text in _LEADS:
        first += 1
    last = first
    while last < len(sentence) and sentence[last].kind == "word" and sentence[last].text not in _CLOSERS:
        last += 1
    thing = sentence[first:last]
    if not 0 < len(thing) <= _LONGEST or not _gives_up([token.text for token in sentence[last:]]):
        return []
    lead = replace(sentence[verb], kind="word", text="no", plural=False)
    return [lead, *thing]
