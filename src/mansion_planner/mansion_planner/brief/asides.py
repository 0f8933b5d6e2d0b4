"""Find the words of a brief that ask for nothing: why or what for something is wanted, who is there, what they do.

What a statement was read from stays one; these are about the words that are left over. Which of them ask for nothing
is a matter of form, not of the single word: the clause of a reason, a purpose, people and robots with what they do, and
clauses in which no part of a building is named and nothing is wished for.
"""

from mansion_planner.brief.idle_clauses import WISHES, idle_clauses, says_how
from mansion_planner.brief.persons import COLLECTIVES, ROBOTS, is_person
from mansion_planner.brief.phrase import FUNCTION_WORDS
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.remarks import remark_tokens

__all__ = ["TRIALS", "aside_tokens"]

TRIALS = frozenset(
    """
    trial test testing experiment research evaluation simulation training development study project benchmark
    thesis dissertation coursework assignment
    evaluating competition demo demonstration dataset task learning manipulation game film movie novel campaign
    """.split()
)
"""What a building is wanted for by those who try robots or programs in it."""
_TRYING = frozenset("test evaluate train simulate learn practise benchmark demonstrate".split())
"""What is done with the robots of a trial, after "to" or a form of "be"."""
_REASONS = frozenset({"because", "since"})
_LEADS = frozenset({"for", "as"})
_WITHIN = frozenset("the our a an some new my this of with on about in and your their to".split())
"""Words within a purpose: "for the research about serving robots"."""
_LONGEST = 12
"""Tokens of a reason or a purpose, at most."""


def aside_tokens(reading: Reading) -> set[int]:
    """Return the tokens of which no statement is made, and that ask for nothing.

    "On one floor because my knees are bad", "for our navigation benchmark", "an office for the librarian". Where a
    reason holds a statement ("because we want a lift") its other words are told of as well.
    """
    found: set[int] = {*idle_clauses(reading), *remark_tokens(reading)}
    for index in range(len(reading.tokens)):
        word = reading.word(index)
        if word in _REASONS:
            found |= _reason(reading, index)
        elif word in _LEADS:
            found |= _purpose(reading, index) | _client(reading, index)
        elif word in _TRYING and _is_tried_there(reading, index):
            found |= _trial(reading, index)
        if word in ROBOTS or is_person(word):
            found |= _someone(reading, index)
        elif word in COLLECTIVES and _acts(reading, index):
            found |= {at for at in range(index - 2, index + 1) if at == index or _describes(reading, at)}
        elif word in _SITES or (word in ("wood", "woods") and reading.plural(index)):
            found |= _site(reading, index)
        elif word in ("too", "being"):
            found |= _excuse(reading, index)
    return found


_SITES = frozenset(
    """
    town village city suburb countryside lake beach seafront waterfront
    plot park neighbourhood neighborhood hill hillside mountain island
    forest slope coast sea seaside river riverside meadow valley square row road
    """.split()
)
"""Nouns for where a building stands, of which no plan is made."""
_AT = frozenset({"in", "at", "on", "of", "for", "by", "near", "across", "over", "opposite"})
_ATTRIBUTES = frozenset(
    """
    the a an our my their this small little big large market quiet busy narrow old edge sloping steep sunny wooded rural
    urban corner
    """.split()
)


def _site(reading: Reading, index: int) -> set[int]:
    """Return the tokens that say where the building stands: "in a market town", "at the lake"."""
    first = index
    while reading.word(first - 1) in _ATTRIBUTES and first - 1 not in reading.taken:
        first -= 1
    last = index + 1
    if reading.word(last) in ("near", "in", "outside", "by") and last + 1 < len(reading.tokens):
        last += 2 * reading.tokens[last + 1].capital  # "a sloping plot near Graz"
    asks = reading.word(index - 1) in ("our", "the", "a") and reading.word(index + 1) in ("need", "want", "require")
    stands = asks or reading.word(first - 1) in _AT | (
        {"buy", "bought", "own", "have", "inherit", "inherited"} if reading.word(index) == "plot" else frozenset()
    )
    return set(range(first - 1, last)) if stands and index not in reading.taken else set()


def _excuse(reading: Reading, index: int) -> set[int]:
    """Return the tokens of a reason without a conjunction: "it is too noisy", "the archive, being heavy, is below"."""
    said = reading.word(index) == "being" or reading.word(index - 1) in ("it", "that", "is")
    ends = reading.breaks(index + 2) or reading.word(index + 2) in (",", ")")
    return {index, index + 1} if said and ends and index + 1 not in reading.taken else set()


def _reason(reading: Reading, index: int) -> set[int]:
    """Return the tokens of the clause that a conjunction opens, if nothing was read in it."""
    end = index + 1
    while not reading.breaks(end) and reading.word(end) not in (",", ")", ":") and end - index <= _LONGEST:
        if end in reading.taken or reading.kind(end) in ("number", "unit"):
            return set()
        end += 1
    return set(range(index, end))


def _purpose(reading: Reading, index: int) -> set[int]:
    """Return the tokens of a purpose whose noun is that of a trial: "for the testing of a disinfecting robot"."""
    end = index + 1
    while end - index <= _LONGEST and reading.kind(end) == "word":
        if end in reading.taken and not is_person(reading.word(end)):
            break
        if reading.word(end) in FUNCTION_WORDS - _WITHIN:
            break
        end += 1
    return set(range(index, end)) if not TRIALS.isdisjoint(reading.words(index + 1, end)) else set()


_CLIENT = 4
"""Tokens of who a building is for, at most."""


def _client(reading: Reading, index: int) -> set[int]:
    """Return the tokens of who the building is for, right after its name: "headquarters for a maritime consultancy"."""
    names = [span for _, span in reading.facts.building if span.words] + reading.facts.building_span
    follows = index > 0 and reading.tokens[index - 1].end in {span.end for span in names}
    end = index + 2
    while end - index - 2 < _CLIENT and reading.kind(end) == "word" and end not in reading.taken:
        if reading.word(end) in FUNCTION_WORDS or says_how(reading.word(end)):
            break
        end += 1
    closed = reading.breaks(end) or reading.word(end) in (",", ":", "(", "with", "on", "in", "over")
    led = reading.word(index) == "for" and reading.word(index + 1) in ("a", "an", "our", "the", "my")
    return set(range(index, end)) if follows and led and closed and end > index + 2 else set()


def _is_tried_there(reading: Reading, index: int) -> bool:
    return reading.word(index - 1) in ("to", "for", "is", "are", "be", "can", "will", "we", "i", "being")


def _trial(reading: Reading, index: int) -> set[int]:
    """Return the tokens of what is tried, up to what was read: "to evaluate the transport of meals by a robot"."""
    end = index + 1
    while end - index <= _LONGEST and reading.kind(end) == "word" and end not in reading.taken:
        end += 1
    return set(range(index, end))


def _someone(reading: Reading, index: int) -> set[int]:
    """Return the tokens of a person or a robot that nothing was read of, and of what they do before what was read.

    A number says how many places are wanted, and is told of: "five partners".
    """
    if index in reading.taken:
        return set()
    first = index
    while first > 0 and first - 1 not in reading.taken and _describes(reading, first - 1):
        first -= 1
    if reading.kind(first - 1) == "number" and first - 1 not in reading.taken:
        return set()
    return set(range(first, _end_of_doing(reading, index + 1)))


def _describes(reading: Reading, index: int) -> bool:
    """Whether a word right before a person or a robot goes with it: "delivery", "our two", "elderly"."""
    return (
        reading.kind(index) == "word"
        and reading.word(index) not in FUNCTION_WORDS
        and not reading.plural(index)
        and index not in reading.mention_at
    )


def _acts(reading: Reading, index: int) -> bool:
    """Whether people together are only named as those for whom a building is, and no number of them follows."""
    lead = index - 1
    while index - lead < 3 and lead not in reading.taken and _describes(reading, lead):
        lead -= 1
    return reading.word(lead) in ("our", "the", "a", "my", "for", "small", "young", "whole") and not (
        reading.word(index + 1) == "of" and reading.kind(index + 2) == "number" and index + 2 not in reading.taken
    )


_MOST_DOING = 3
"""Words of what somebody does before what was read: "will be evaluated in an office"."""


def _end_of_doing(reading: Reading, start: int) -> int:
    """Return where the verbs of a person or robot end, if what was read follows or the clause ends; else `start`."""
    end, said = start, 0
    while said <= _MOST_DOING and reading.kind(end) == "word" and end not in reading.taken:
        word = reading.word(end)
        if word in WISHES or (says_how(word) and not word.endswith("ed")):
            return start
        said += word not in FUNCTION_WORDS
        end += 1
    closed = reading.breaks(end) or reading.word(end) in (",", ")", ";")
    return end if end in reading.taken or closed else start
