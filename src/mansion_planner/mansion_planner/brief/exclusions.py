"""Read what a brief does not want, and how far a negation reaches: "no gym or sauna", "no bedroom downstairs"."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.absences import absence_end, time_end
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import Place, Reading
from mansion_planner.brief.refusals import refusal_after, refused_before

__all__ = ["MOTIONS", "negated_phrases", "read_completeness"]

_BEFORE = frozenset(
    """
    no without not neither nor omit skip exclude excluding avoid never refuse nowhere lose drop minus
    """.split()
)
_PHRASES = (
    ("instead", "of"),
    ("rather", "than"),
    ("free", "of"),
    ("free", "from"),
    ("leave", "out"),
    ("get", "rid", "of"),
    ("do", "without"),
    ("anything", "but"),
    ("rule", "out"),
    ("ruled", "out"),
    ("never", "mind"),
    ("forget", "about"),
    *[(verb,) for verb in ("forget", "scrap", "scratch", "cancel", "strike", "remove", "delete", "ditch")],
    ("take", "out"),
    ("nobody", "want"),
    ("nobody", "need"),
    ("nobody", "get"),
    ("nobody", "have"),
    ("no", "one", "get"),
    ("no", "one", "need"),
    ("no", "one", "want"),
    *[("without", noun, link) for noun in ("need", "necessity") for link in ("of", "for")],
    ("no", "necessity", "of"),
    *[("not", participle, ":") for participle in ("needed", "wanted", "required", "necessary", "included")],
    ("not", "necessary"),
    *[
        (*lead, word, ":")
        for lead in (("express",), ("explicit",), ("specific",), ())
        for word in ("excluded", "exclusion", "omitted", "omission", "waived")
    ],
    *[(*words, "scope", ":") for words in (("out", "of"), ("outside",), ("not", "in"), ("outside", "the"))],
)
_AFTER = (
    ("not", "needed"),
    ("not", "wanted"),
    ("not", "required"),
    ("not", "necessary"),
    ("is", "not", "needed"),
    ("are", "not", "wanted"),
    ("unnecessary",),
    ("make", "no", "sense"),
    ("makes", "no", "sense"),
    *[(verb, word) for verb in ("is", "are") for word in ("unnecessary", "superfluous", "unwanted", "undesired")],
    ("is", "not", "wanted"),
    ("are", "not", "needed"),
    *[(verb, "no", participle) for verb in ("is", "are") for participle in ("needed", "necessary", "required")],
    *[(verb, "not", "a", noun) for verb in ("is", "are") for noun in ("must", "need", "necessity")],
    ("we", "do", "not", "want"),
    ("we", "do", "not", "need"),
    ("we", "not", "need"),
    (":", "none"),
    (":", "no"),
    ("=", "no"),
    ("=", "none"),
    ("not", "included"),
    *[(verb, "not", "part", "of", what) for verb in ("is", "are") for what in ("it", "this", "that")],
    ("not", "foreseen"),
    ("can", "be", "omitted"),
    ("we", "do", "not", "have"),
    ("we", "not", "have"),
    ("we", "not", "want"),
    ("is", "outside"),
    ("not", "allowed"),
    *[
        (*verb, "not", participle)
        for verb in ((), ("is",), ("are",))
        for participle in (
            "necessary",
            "required",
            "contemplated",
            "foreseen",
            "planned",
            "desired",
            "wished",
            "asked",
            "permitted",
            "allowed",
            "tolerated",
            "welcome",
            "requested",
            "included",
        )
    ],
)
_FIRST_AFTER = frozenset(words[0] for words in _AFTER)
"""Words that those begin with; nearly no token is one of them."""
_ENDS = frozenset(
    {
        "(",
        ")",
        ".",
        ";",
        ":",
        "\n",
        "but",
        "with",
        "!",
        "?",
        "however",
        "only",
        "because",
        "so",
        "while",
        "since",
        "just",
        "except",
        "if",
        "keep",
        "yet",
        "instead",
        "for",
    }
)
_SUBJECTS = frozenset("do does would i we you they he she it people".split())
_CLAUSE_OPENERS = frozenset({",", "and", "but", "so", "also", "please"})
_CONTRASTS = frozenset(
    "to in on at from into onto near next beside by towards toward inside of for like as under".split()
)
MOTIONS = frozenset({"get", "go", "come", "walk", "pass", "look", "see", "wander", "run", "lead"})
"""Verbs of who must not go somewhere."""
_REFUSALS = frozenset("veto vetoe reject refuse dislike hate detest replace".split())
_NO_REFUSALS = frozenset({"more", "exceed", "mind", "sure", "far", "necessarily", "forget"})
"""Words soon after "not" that make no refusal of it: "do not forget the pantry"."""
_TIGHT = frozenset("narrow small low tight short slim steep little cramped poor".split())
_COMPARISONS = frozenset(
    """
    more less fewer bigger larger later smaller longer higher matter doubt problem need
    """.split()
)


def negated_phrases(reading: Reading, phrases: list[Phrase]) -> dict[int, tuple[int, int]]:
    """Return the phrases that the brief does not want, each with the tokens that say so (first, last).

    A negation reaches to the end of its clause: over "or", "nor" and "and", not over "but".
    """
    found: dict[int, tuple[int, int]] = {}
    for number, phrase in enumerate(phrases):
        after = phrase.last + len(_refusing_words(reading, phrase.last))
        end = after if after > phrase.last else absence_end(reading, phrase.last)
        end = max(end, refusal_after(reading, phrase.last))
        if end > phrase.last:
            found[number] = (phrase.first, end)
            reading.take(phrase.last, end)
            for earlier in _joined_before(reading, phrases, number):
                found[earlier] = (phrases[earlier].first, end)
    found |= refused_before(reading, phrases)
    starts = {phrase.first: number for number, phrase in enumerate(phrases)}
    for index in range(len(reading.tokens)):
        refused = _refused(reading, phrases, index)
        if refused is not None:
            number, last = refused
            found.setdefault(number, (phrases[number].first, last))
            reading.take(index, last)
        elif length := _negation(reading, index):
            length += reading.word(index + length) == ":"  # "please leave out: gym, bar and shop"
            _negate(reading, phrases, starts, found, index, length)
    return found


_WORDS_BETWEEN = frozenset({"also", "too", "upstairs", "upstair", "downstairs", "downstair"})


def _refusing_words(reading: Reading, last: int) -> tuple[str, ...]:
    """Return the words right after a phrase that say that it is not wanted: "is not needed", ", no"; or nothing."""
    begins = reading.word(last) in _FIRST_AFTER
    after = next((p for p in _AFTER if reading.words(last, last + len(p)) == p), None) if begins else None
    leads_on = after == (":", "no") and not (reading.breaks(last + 2) or reading.word(last + 2) in (",", ")", "and"))
    if after is not None and not leads_on:  # "not like a hospital: no operating room"
        return after
    word, following = reading.words(last, last + 2)
    if word == "no" and (reading.breaks(last + 1) or following == ","):
        return ("no",)  # "stairs yes, lift no"
    asked = last < len(reading.tokens) and reading.text[reading.tokens[last].start] == "?"
    if (word, following) == (",", "no") and (asked or reading.breaks(last + 2)):
        return (",", "no")  # "lift, yes; cafe, no", "a lift? No, stairs"
    if (word, following) in (("not", "need"), ("no", "need")):
        closes = reading.breaks(last + 2) or reading.word(last + 2) in (",", "and", ")", "either")
        return ("not", "need") if closes else ()  # "cafe don't need"
    if (word, following) == ("need", "not"):
        return ("need", "not") if reading.breaks(last + 2) else ()
    if word in _WORDS_BETWEEN:  # "a lift also is not needed", "an office upstairs is not wanted"
        said = next((p for p in _AFTER if reading.words(last + 1, last + 1 + len(p)) == p), ())
        return (word, *said) if said else ()
    return ()


def _negate(
    reading: Reading,
    phrases: list[Phrase],
    starts: dict[int, int],
    found: dict[int, tuple[int, int]],
    index: int,
    length: int,
) -> None:
    """Add the phrases that a negation of so many tokens reaches; what it only compares or places is left out."""
    elsewhere = reading.word(index) == "never" and reading.word(index + length) in ("in", "on", "at", "inside")
    whole = _orders_list(reading, starts, phrases, index, length)
    for number in _reached(reading, phrases, starts, index + length, whole=whole):
        phrase = phrases[number]
        if elsewhere:  # "a television in the lounge, never in a bedroom"
            reading.taken.difference_update(range(phrase.begin, phrase.last))
            phrases[number] = replace(phrase, head="unknown")
        elif reading.kind(phrase.first - 1) == "ordinal" or _is_compared(reading, phrase.last):
            reading.taken.difference_update(range(phrase.first - 1, phrase.last))
            phrases[number] = replace(phrase, head="unknown")  # "instead of the second bedroom"
        else:
            found.setdefault(number, (index, phrase.last))
            reading.take(phrase.last, time_end(reading, phrase.last))
    if any(first == index for first, _ in found.values()):
        reading.take(index, index + length)


_ORDERS = frozenset("leave omit skip exclude drop forget scrap scratch cancel strike lose".split())
"""Verbs that order things away which are named after them."""
_JOINTS = frozenset({",", "and", "or", "nor", "&", "/", "any", "also", "please", "too", "thanks"})


def _orders_list(reading: Reading, starts: dict[int, int], phrases: list[Phrase], index: int, length: int) -> bool:
    """Whether a sentence orders a list away and says nothing else: "leave out the gym, the bar and the shop"."""
    opens = reading.starts(index) or reading.word(index - 1) in _CLAUSE_OPENERS
    if not (opens and reading.word(index) in _ORDERS):
        return False
    at = index + length
    while at < len(reading.tokens) and not reading.breaks(at):
        number = starts.get(at)
        if number is None and reading.word(at) not in _JOINTS:
            return False
        at = at + 1 if number is None else phrases[number].last
    return True


def _is_compared(reading: Reading, index: int) -> bool:
    """Whether what is unwanted is only too large or small: "no corridors longer than 10 m"."""
    word = reading.word(index)
    return "than" in reading.words(index + 1, index + 3) and (word.endswith("er") or word in ("more", "less"))


def _joined_before(reading: Reading, phrases: list[Phrase], number: int) -> list[int]:
    """Return the phrases that share what is said after the last of them: "a television or a gym are not wanted"."""
    joined = []
    while number > 0 and reading.words(phrases[number - 1].last, phrases[number].first) in (("or",), ("nor",)):
        number -= 1
        joined.append(number)
    return joined


_STRIKES = (_ORDERS - {"scratch"}) | {"remove", "delete", "cut", "ditch", "take"}
"""Verbs that take back what was mentioned before: "a sauna was in the first draft; please strike it"."""


def _struck(reading: Reading, phrases: list[Phrase], index: int) -> tuple[int, int] | None:
    """Read "strike it", "drop them again"; return which phrase before that refuses, and where it ends."""
    order = reading.starts(index) or reading.word(index - 1) in _CLAUSE_OPENERS | {"you", "then", "to"}
    if not (order and reading.word(index) in _STRIKES and reading.word(index + 1) in ("it", "that", "them", "those")):
        return None
    end = index + 2
    while reading.word(end) in ("out", "off", "away", "again", "please", "altogether", "too"):
        end += 1
    out = reading.word(index + 2) in ("out", "off", "away") or reading.word(index) not in ("leave", "take")
    if not out or not (reading.breaks(end) or reading.word(end) in (",", ";", "and")):
        return None
    near = range(reading.sentence[index] - 1, reading.sentence[index] + 1)
    before = [
        number
        for number, phrase in enumerate(phrases)
        if phrase.last <= index and reading.sentence[phrase.first] in near and phrase.head in ("room", "object")
    ]
    return (before[-1], end) if before else None


def _refused(reading: Reading, phrases: list[Phrase], index: int) -> tuple[int, int] | None:
    """Read "a lift was suggested, but we do not want one"; return which phrase it refuses, and where it ends."""
    struck = _struck(reading, phrases, index)
    if struck is not None:
        return struck
    if reading.word(index) == "zero" or (reading.kind(index) == "number" and reading.value(index) == 0.0):
        # "zero chairs": the number belongs to the phrase, so that no word before it denies it
        none = next((n for n, phrase in enumerate(phrases) if index in (phrase.first, phrase.begin - 1)), None)
        return None if none is None else (none, phrases[none].last)
    if reading.word(index) in _REFUSALS and index not in reading.taken:
        number = next((n for n, p in enumerate(phrases) if 0 <= p.begin - index - 1 <= 2 and p.first > index), None)
        return None if number is None else (number, phrases[number].last)
    if reading.word(index) == "leave" and index not in reading.taken:
        number = next((n for n, p in enumerate(phrases) if 0 <= p.begin - index - 1 <= 2 and p.first > index), None)
        out = number is not None and reading.word(phrases[number].last) in ("out", "off", "away", "aside")
        return (number, phrases[number].last + 1) if number is not None and out else None
    if reading.word(index) in ("change", "convert", "turn") and index not in reading.taken:
        number = next((n for n, p in enumerate(phrases) if 0 <= p.begin - index - 1 <= 2 and p.first > index), None)
        if number is None or reading.word(phrases[number].last) != "into" or phrases[number].head != "room":
            return None
        return number, phrases[number].last  # "change the dining room into a playroom"
    if reading.word(index) != "not" or reading.word(index + 1) not in ("want", "need", "like", "have"):
        return None
    if reading.word(index + 2) not in ("one", "it", "that", "them", "any") or not reading.breaks(index + 3):
        return None
    sentence = reading.sentence[index]
    before = [
        n
        for n, p in enumerate(phrases)
        if p.last <= index
        and reading.sentence[p.first] == sentence
        and p.head in ("room", "stair", "elevator", "object")
    ]
    return (before[-1], index + 3) if before else None


def _negation(reading: Reading, index: int) -> int:
    """Return how many tokens a negation at `index` has, or 0."""
    if index in reading.taken:
        return 0
    for words in _PHRASES:
        if reading.words(index, index + len(words)) == words and reading.word(index - 1) != "not":
            return len(words)
    if reading.word(index) in ("nothing", "none"):
        return _nothing_like(reading, index)
    if (
        reading.word(index) == "no"
        and reading.word(index + 1) in ("space", "room", "need", "budget", "money", "place")
        and reading.word(index + 2) in ("for", "of")
    ):
        return 3
    if reading.word(index) == "than" and "rather" in reading.words(max(index - 7, 0), index):
        return 1  # "I would rather have a shower than a bathtub"
    if reading.word(index) == "too" and reading.word(index + 2) == "for" and reading.word(index + 1) in _TIGHT:
        return 3
    opens = reading.starts(index) or reading.word(index - 1) in _SUBJECTS | _CLAUSE_OPENERS
    if reading.words(index, index + 2) == ("not", "need") and opens:
        return 2  # "we do not need private offices", "Don't need cafe"
    if reading.word(index) not in _BEFORE or reading.word(index + 1) in _COMPARISONS:
        return 0
    if reading.word(index + 1) in MOTIONS and reading.word(index + 2) in ("into", "through", "to", "in", "inside"):
        return 0  # "the public must not get into the sorting hall" is about who goes there
    if reading.word(index) == "not" and reading.word(index + 1) in _CONTRASTS:
        return 0  # "open to the dining room, not to the hall" is about the relation
    if reading.word(index) == "not" and reading.word(index + 1) in (
        "only",
        "just",
        "least",
        "even",
        "too",
        "including",
        "counting",
        "yet",
    ):
        return 0
    if reading.word(index) == "not" and any(reading.word(i) in _NO_REFUSALS for i in range(index + 1, index + 4)):
        return 0
    return 1


def _nothing_like(reading: Reading, index: int) -> int:
    """Return how many tokens "nothing like", "nothing dangerous such as", "nothing in the way of" have, or 0."""
    for at in range(index + 1, index + 4):
        if reading.breaks(at):
            return 0
        if reading.words(at, at + 2) in (("such", "as"), ("way", "of"), ("kind", "of")):
            return at + 2 - index
        if reading.word(at) == "like" and reading.word(at + 1) in ("a", "an", "the", "any"):
            return at + 1 - index
        if reading.words(at, at + 4) == ("in", "the", "way", "of"):
            return at + 4 - index
    return 0


def _reached(
    reading: Reading, phrases: list[Phrase], starts: dict[int, int], index: int, *, whole: bool = False
) -> list[int]:
    """Return the phrases that a negation reaches from token `index` on, `whole` to the sentence's end."""
    reached: list[int] = []
    steps, passed, headed = 0, False, whole or reading.word(index - 1) == ":"  # "not needed: cafe, gym"
    while index < len(reading.tokens) and steps < 9:
        number = starts.get(index)
        if number is not None:
            phrase = phrases[number]
            if phrase.head in ("room", "building", "object", "stair", "elevator") and not (
                reached
                and not whole
                and phrase.determiner in ("a", "the")
                and not (reading.word(phrase.first - 1) in ("and", "or") and reading.breaks(phrase.last))
            ):
                if phrase.counted and reached:
                    break
                reached.append(number)
            index, steps = phrase.last, 0
            continue
        word = reading.word(index)
        if word in _ENDS or reading.breaks(index):
            break
        if passed and not reached and word in ("in", "on", "at", "to", "of", "from", "into", "and", "(", "between"):
            break  # "no windows in the game rooms" is about windows
        passed = passed or (reading.kind(index) == "word" and word not in FUNCTION_WORDS)
        if reached and word not in ("or", "nor", "and", ",", "any", "anywhere", "a", "no", "either", "&", "/", "not"):
            break
        if word == "," and not (headed or _goes_on(reading, phrases, starts, index + 1)):
            break
        index += 1
        steps += 1
    return reached


def _goes_on(reading: Reading, phrases: list[Phrase], starts: dict[int, int], index: int) -> bool:
    """Whether a list of what is not wanted goes on after a comma: "no gym, no sauna", "without gym, bar or pool"."""
    if reading.word(index) in ("no", "nor", "or"):
        return True
    number = starts.get(index)
    if number is None:
        return False
    after = phrases[number].last
    return phrases[number].first == phrases[number].begin and reading.word(after) in ("or", "nor", ",")


_ALONE = frozenset({"only", "exclusively", "solely", "purely"})
_HOLDS = frozenset(
    "is are be has have contain contains hold holds with house houses get gets want put there : ,".split()
)
"""Words before "only" where it is said of what a storey holds."""


def read_completeness(reading: Reading, places: Sequence[Place], phrases: Sequence[Phrase]) -> None:
    """Read "nothing else", "no other rooms" and, of a storey, "nothing but five bedrooms", "only one big office".

    What is said in a sentence that names one storey is of that storey alone. That a room is to hold no other furniture
    ("an attic with one bed and nothing else") is told of, as nothing is made of it.
    """
    for index in range(len(reading.tokens)):
        pair = reading.words(index, index + 2)
        place = _only_place(reading, places, index)
        if pair == ("nothing", "else") and _ends_furniture(reading, phrases, index):
            reading.facts.unread.append(reading.span(index, index + 2))
            reading.take(index, index + 2)
            continue
        if _tells_number_of_rooms(reading, index):
            last = index + 3
        elif _is_complete(reading, index, pair, placed=place is not None):
            last = index + 2
            reading.take(last, last + 1)
            if reading.word(last) in ("except", "but", "than", "apart"):
                place = None  # "nothing else except a bin room on the ground floor"
        elif place is not None and _is_all_there_is(reading, place, phrases, index):
            last = index + 1
        else:
            continue
        reading.take(index, last)
        if place is None:
            reading.facts.only.append(reading.span(index, last))
        elif all(refs != place.refs for _, refs in reading.facts.only_on):
            end = next((phrase.last for phrase in phrases if phrase.first == last), last)
            reading.facts.only_on.append((reading.span(index, end), place.refs))


def _ends_furniture(reading: Reading, phrases: Sequence[Phrase], index: int) -> bool:
    """Whether the words at a token go on from the furniture of a room, named in their sentence before it."""
    before = [p for p in phrases if p.last <= index and reading.sentence[p.first] == reading.sentence[index]]
    joined = bool(before) and set(reading.words(before[-1].last, index)) <= {",", "and", "but", "in", "it", "there"}
    return joined and before[-1].head == "object" and any(phrase.head == "room" for phrase in before)


def _is_complete(reading: Reading, index: int, pair: tuple[str, ...], *, placed: bool) -> bool:
    """Whether "nothing else", "the only other rooms", "no other spaces" stand at a token."""
    if pair in (("nothing", "else"), ("nothing", "besides")):
        return True
    if pair == ("nothing", "more") and reading.breaks(index + 2):
        return True
    if pair in (("only", "other"), ("no", "other")):
        return reading.word(index + 2) in ("room", "space")
    lead = reading.word(index - 1)
    return pair == ("nothing", "but") and (placed or lead in ("want", "need", "with", "", ".", "have"))


def _tells_number_of_rooms(reading: Reading, index: int) -> bool:
    """Whether "just 2 rooms:" stands at a token, before the list of them."""
    told = reading.word(index) in ("just", "only") and reading.kind(index + 1) == "number"
    rooms = reading.word(index + 2) == "room" and reading.word(index + 3) in (":", "-", "–", "=")
    return told and rooms and reading.value(index + 1) > 1


def _only_place(reading: Reading, places: Sequence[Place], index: int) -> Place | None:
    """Return the storey that the sentence of a token names, or its clause where the sentence names several."""
    here = [place for place in places if reading.sentence[place.first] == reading.sentence[index]]
    if len(here) > 1:
        begin, end = index, index
        while (
            begin and reading.sentence[begin - 1] == reading.sentence[index] and reading.word(begin - 1) not in _CLAUSES
        ):
            begin -= 1
        while not reading.breaks(end) and reading.word(end) not in _CLAUSES:
            end += 1
        here = [place for place in here if begin <= place.first < end]
    one = len(here) == 1 and here[0].refs[0].kind != "every"
    return here[0] if one else None


_CLAUSES = frozenset({",", ";", ":", "("})


def _is_all_there_is(reading: Reading, place: Place, phrases: Sequence[Phrase], index: int) -> bool:
    """Whether "only" says that a storey holds no more than the rooms beside it: "upstairs there are only bedrooms"."""
    if reading.word(index) not in _ALONE or index in reading.taken:
        return False
    before = next((p for p in phrases if p.last == index and p.head == "room"), None)
    if before is not None and before.plural and (reading.breaks(index + 1) or reading.word(index + 1) in (",", ";")):
        return reading.sentence[before.first] == reading.sentence[place.first] and place.first < before.first
    rooms = (p for p in phrases if p.head == "room" or (p.head == "building" and p.plural and p.room_type))
    after = next((p for p in rooms if p.first == index + 1), None)
    listed = any(p.head == "room" and place.last <= p.first < index for p in phrases)
    led = place.last < index and reading.word(index - 1) in _HOLDS and not listed
    following = place.last == index or led
    return after is not None and (following or 0 <= place.first - after.last <= 1)
