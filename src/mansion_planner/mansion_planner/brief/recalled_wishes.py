"""Leave out what a writer recalls of earlier wishes: "I had written two meeting rooms before, one is enough".

What was asked for and is not needed any more becomes a refusal: "before I asked for storage, now it is not needed".
"""

from dataclasses import replace

from mansion_language import Token

__all__ = ["without_recalled_wishes"]

_ENDS = frozenset({".", ";", "\n", "!", "?"})
_WISHING = frozenset("said written wrote asked ask wanted thought planned mentioned put had considered hoped".split())
_EARLIER = frozenset({"before", "first", "earlier", "originally", "previously", "initially", "once"})
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
        while last < len(tokens) and tokens[last].text not in _ENDS:
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
    elif verb is None or (_EARLIER.isdisjoint(texts) or not {"i", "we", "at"} & set(texts[:verb])):
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
