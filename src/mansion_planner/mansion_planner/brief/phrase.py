"""A noun phrase of a brief, with the counts, the determiner and the name that stand around its head."""

import re
from dataclasses import dataclass
from typing import Literal, TypeAlias

from mansion_language import Token
from mansion_language.units import AREA
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = [
    "BARE_BUILDINGS",
    "FUNCTION_WORDS",
    "PEOPLE",
    "PLAIN",
    "PREDICATES",
    "UNITS_OF_ROOMS",
    "Head",
    "Phrase",
    "count_after",
    "count_before",
    "finished_phrase",
    "is_whole_count",
    "name_of",
    "tells_some",
]

Head: TypeAlias = Literal["room", "building", "stair", "elevator", "object", "people", "unknown"]

BARE_BUILDINGS = frozenset({"building", "complex", "place", "tower", "tower_block"})
"""Names of a building that say nothing of its use: its rooms do."""

FUNCTION_WORDS = frozenset(
    """
    a an the our my your his her its their this that these those each every all both any some no not another none
    other and or but nor so then than as if because while where when which who whose whom what there here it they
    them we i you he she us me him with without within of in on at to for from by into onto off out up down over
    under above below beneath behind beside between among around round through along across near next opposite via
    per inside outside against toward towards about after before during until since except besides plus minus like
    unlike instead rather is are was were be been being am has have had having do does did done can could may might
    must shall should will would want need needs like wish please build create make give get go come put keep let
    take include contain provide feature hold comprise consist serve accommodate offer require allow open lead
    connect share sit stand lie lay belong follow reach touch adjoin border abut face join link attach separate
    including containing featuring holding housing comprising serving having sharing facing adjoining bordering
    touching leading opening connecting linking joining using giving making adjacent attached connected directly
    straight direct also only just even still again very quite too rather really maybe perhaps possibly ideally mainly
    mostly partly nearly about around approximately roughly circa ca approx almost least most more less many few
    several multiple various numerous much enough same identical alike altogether together total overall exactly
    precisely apart away someone everybody everyone anyone nobody nothing everything something anything one's
    live sleep eat
    cook meet walk carry gather believe afford love find see look say tell ask think know located situated placed
    spread divided split equipped furnished fitted surrounded arranged organised organized reserved dedicated called
    named known planned needed necessary
    wanted required preferred desired expected apiece respectively etc ie eg namely such
    measure measuring occupy occupying span spanning
    well however therefore moreover nevertheless obviously yes ok pls hello hi dear thanks thank upstairs downstairs
    upstair downstair throughout everywhere anywhere elsewhere neither
    exclusively solely purely
    either incl avoid omit exclude hate dislike detest leaving fleeing escaping standing ditto idem likewise half
    itself themselves ought sorry oops pardon hmm hm um uh erm
    """.split()
)
"""Words that no noun phrase of a room goes across."""

PLAIN = frozenset(
    """
    large small big little tiny huge vast spacious compact modest generous roomy cozy cosy narrow wide long short
    tall high low new old modern nice good great beautiful pleasant bright light dark quiet noisy warm cool simple
    plain basic open private public shared common communal separate own individual main central second third extra
    additional further single double twin double-height attached detached dedicated internal external indoor outdoor
    comfortable elegant luxurious standard normal typical regular usual proper real full complete whole entire
    proper sunny airy welcoming ample decent suitable appropriate minimum maximum max min identical equal different
    adjoining adjacent neighbouring neighboring nearby accessible wooden self contained self-contained
    """.split()
)
"""Adjectives that say how a room is, and are no part of its name."""

PREDICATES = frozenset(
    """
    exist stay goes go run found foreseen foresee possess possesses present mandatory obligatory compulsory essential
    needful requested additionally addition hence absolutely
    """.split()
)
"""What is said of a thing that is wanted and asks for no more than the thing: "a lift is mandatory"."""

PEOPLE = frozenset(
    """
    people person resident occupant pupil student child employee worker guest patient adult inhabitant staff teacher
    kid user visitor elderly tenant inmate firefighter officer diner roommate friend colleague developer lodger
    brother sister member player nun monk soldier crew engineer worshipper customer client artist family household
    passenger traveller commuter donor drummer dancer musician nurse doctor consultant lawyer architect agent
    analyst programmer designer journalist trader operator researcher scientist professor lecturer cleaner waiter
    detainee prisoner technician judge juror priest cook chef baker brewer
    flatmate housemate photographer
    midwife therapist pilot driver clerk trainee apprentice intern volunteer swimmer climber viewer spectator
    delegate dentist
    """.split()
)
"""Nouns for those who live, work or stay in a building."""

_JOINTS = frozenset("a an the of for and in on at to with or per each every".split())
_SOFT_PLURAL = frozenset(
    """
    several multiple various many few some numerous more enough
    """.split()
)
UNITS_OF_ROOMS = frozenset(
    """
    bed bedroom room br bath person car storey story bay seat man
    """.split()
)


@dataclass(frozen=True)
class Phrase:
    """A noun phrase: tokens `first` to `last` (exclusive), its counts included.

    Attributes
    ----------
    head : str
        What kind of thing it names.
    begin : int
        First token of modifiers and head.
    noun_end : int
        Token after the head.
    room_type, building, category : str
        What the head means in the knowledge base and in the asset catalogue; empty for nothing.
    name : str
        Snake case, in the user's words, without plain adjectives.
    count : int, optional
        ``None`` for an unnumbered plural.
    counted : bool
        The text has the number.
    determiner : str
        ``a``, ``the``, ``each``, ``every``, ``own``, ... or empty.
    known : bool
        The lexicon has the head.
    areas : tuple of float
        Square metres; of each room, or one for each.
    limit : {"", "most", "least"}
        What the areas bound.
    size : {"", "large", "small"}
        How large the rooms are to be, in words.
    """

    head: Head
    first: int
    begin: int
    noun_end: int
    last: int
    room_type: str = ""
    building: str = ""
    category: str = ""
    name: str = ""
    label: str = ""
    count: int | None = 1
    counted: bool = False
    plural: bool = False
    determiner: str = ""
    known: bool = True
    areas: tuple[float, ...] = ()
    limit: Literal["", "most", "least"] = ""
    size: Literal["", "large", "small"] = ""


def finished_phrase(
    reading: Reading,
    head: Head,
    begin: int,
    end: int,
    *,
    room: str = "",
    building: str = "",
    category: str = "",
    mention: Mention | None = None,
    known: bool = True,
) -> Phrase:
    """Add the counts and the determiner that stand around a head."""
    first, count, counted, determiner = count_before(reading, begin, end)
    plural = reading.plural(end - 1)
    if not counted:
        count = None if plural or determiner in _SOFT_PLURAL else 1
    last, after = (end, None) if counted else count_after(reading, end)
    if after is not None:
        count, counted = after, True
    if head in ("room", "building"):
        reading.modifiers.update(range(begin, mention.first if mention is not None else end - 1))
    name = name_of(reading, begin, end, core=mention.first if mention is not None else end - 1)
    named = begin + (begin < end - 1 and _measures_places(reading, begin))
    label = reading.text[reading.tokens[named].start : reading.tokens[end - 1].end]
    before = reading.tokens[named - 1]
    if named and before.start == reading.tokens[named].start and before.end > before.start:
        label = re.split(r"[-\s]", label, maxsplit=1)[-1]  # "seat" of "a 200-seat theatre"
    label = label or " ".join(reading.words(named, end))  # a noun that the text leaves out
    return Phrase(
        head,
        first,
        begin,
        end,
        max(last, end),
        room,
        building,
        category,
        name,
        label,
        count,
        counted,
        plural,
        determiner,
        known,
    )


def count_before(reading: Reading, begin: int, end: int) -> tuple[int, int | None, bool, str]:
    """Return where the phrase starts, its number, whether it has one, and its determiner."""
    index, determiner = begin - 1, ""
    for _ in range(4):
        word = reading.word(index)
        if passed := _passed_over(reading, index, end):
            index -= passed
        elif reading.kind(index) == "number":
            if not _is_count(reading, index):
                break
            middle = _middle_of_range(reading, index)
            if middle is not None:
                return index - 2, middle, True, determiner
            first = _with_hedges(reading, begin, index)
            if reading.word(first - 1) in _BEFORE_COUNTS:
                determiner = determiner or reading.word(first - 1)
            return first, int(reading.value(index)), True, determiner
        elif word in _DETERMINERS:
            determiner = determiner or word
            if word not in _BEFORE_THEM_ANOTHER:
                return _determined(begin, index, word, determiner)
            index -= 1
        else:
            break
    wide = reading.word(end - 1) == "bed" and reading.word(begin - 1) in _WIDTHS_OF_BEDS  # "rooms with single beds"
    return begin - (wide and begin - 1 not in reading.taken), None, False, determiner


_WIDTHS_OF_BEDS = frozenset({"single", "double", "twin"})
"""Words that are numbers elsewhere."""
_DETERMINERS = frozenset(
    """
    a an the each every per own its their our my her his both all no this that these those any either another some
    several many multiple few various numerous enough more
    """.split()
)
_BEFORE_THEM_ANOTHER = frozenset({"own", "more", "few"})
"""Determiners that another one may stand before: "its own", "two more", "a few"."""
_BETWEEN = frozenset({"other", "such", "very", "same", "separate", "open", "identical", "equal", "similar"})
"""Words between a count or a determiner and its noun."""
_BEFORE_COUNTS = frozenset({"the", "these", "those", "both", "all", "our", "each", "every"})
"""Determiners of a phrase that has a count: "the four bedrooms"."""
_HEDGES = frozenset("least at exactly about a of minimum up to some around roughly".split())
_NOT_LESS = frozenset((no, less, "than") for no in ("no", "not") for less in ("less", "fewer"))
"""Words before a count that is the least: "not fewer than ten desks"."""
_HEDGES_OF_TWO = frozenset({"at", "to", "of", "a"})
"""Words that say how exact a count is only before "least" and "minimum": "at least", "a minimum"."""


def _determined(begin: int, index: int, word: str, determiner: str) -> tuple[int, None, bool, str]:
    """Return what `count_before` does for a phrase without a number whose outermost determiner is `word`."""
    if word == "no":
        return begin, None, False, determiner
    return index, None, False, "several" if (word, determiner) == ("a", "few") else determiner


def _is_adjective(reading: Reading, index: int, end: int) -> bool:
    """Whether a number is an adjective of the phrase and counts nothing: "two-bedroom flats", "double rooms"."""
    if reading.kind(index) != "number":
        return False
    if not reading.tokens[index + 1].spaced and reading.word(index + 1) in UNITS_OF_ROOMS:
        return True
    if index in reading.taken or _is_in_name(reading, index):
        return False
    word = reading.word(index)
    soft = reading.tokens[index].soft and word in ("single", "double", "twin", "triple")
    return word == "double" or (soft and (reading.plural(end - 1) or reading.word(end - 1) == "bed"))


def _is_in_name(reading: Reading, index: int) -> bool:
    """Whether a number is part of a compound: "two-family house", "four-poster bed", "BSL-3 laboratory"."""
    end = reading.tokens[index].end
    if reading.text[end : end + 1] in ("-", "‑"):
        return True
    return not reading.tokens[index].spaced and reading.kind(index - 1) == "word"


MOST_OF_A_KIND = 2000
"""How many rooms or things of a kind a number can count; a larger one is something else."""


def is_whole_count(value: float) -> bool:
    """Whether so many rooms or things can be asked for."""
    return value == int(value) and 1 <= value <= MOST_OF_A_KIND


def _is_count(reading: Reading, index: int) -> bool:
    """Whether a number can say how many there are of something."""
    value = reading.value(index)
    return is_whole_count(value) and index not in reading.taken and not _is_in_name(reading, index)


def _middle_of_range(reading: Reading, index: int) -> int | None:
    """Return the middle of "four to six", where a number is the upper end of a range."""
    if reading.word(index - 1) not in ("–", "to", "or") or reading.kind(index - 2) != "number":
        return None
    low, high = reading.value(index - 2), reading.value(index)
    return int((low + high) / 2) if low < high <= 3 * low else None


def _with_hedges(reading: Reading, begin: int, index: int) -> int:
    """Return where a count starts with the words that say how exact it is: "at least four", "up to six"."""
    if reading.words(index - 3, index) in _NOT_LESS and reading.free(index - 3, index):
        return index - 3
    first = index
    while reading.word(first - 1) in _HEDGES and first - 1 not in reading.taken and begin - first < 5:
        if reading.word(first - 1) in _HEDGES_OF_TWO and reading.word(first) not in ("least", "minimum"):
            break
        first -= 1
    return first


def _passed_over(reading: Reading, index: int, end: int) -> int:
    """Return how many tokens from `index` back stand between a count and its noun: "30 nos. chairs", "a dozen of"."""
    word = reading.word(index)
    if word in ("nos", "no", "pcs", "pc") and reading.kind(index - 1) == "number":
        return 1
    if word == "." and reading.word(index - 1) in ("nos", "no", "pcs") and reading.kind(index - 2) == "number":
        return 2
    if word == "of" and reading.kind(index - 1) == "number" and reading.tokens[index - 1].soft:
        return 1
    return int(word in _BETWEEN or _is_adjective(reading, index, end))


def count_after(reading: Reading, end: int) -> tuple[int, int | None]:
    """Read "(4)", "x3", ": five of them", ", 18 no." after a head; return where it ends and the number."""
    word = reading.word(end)
    if _is_bare_count(reading, end):
        return end + 1, int(reading.value(end))
    value = reading.value(end + 1) if reading.kind(end + 1) == "number" else 0.0
    whole = is_whole_count(value)
    if word == "(" and whole and _closes_classified(reading, end + 2):
        return _closes_classified(reading, end + 2), int(value)
    if word == "(" and whole and _brackets_are_areas(reading, end):
        return end, None
    if word == "(" and whole and reading.word(end + 2) in (")", "of", ":", ","):
        return end + (3 if reading.word(end + 2) == ")" else 2), int(value)
    if word == "(" and reading.word(end + 1) == "x" and reading.kind(end + 2) == "number":
        many = reading.value(end + 2)
        if reading.word(end + 3) == ")" and is_whole_count(many):
            return end + 4, int(many)
    if word == "x" and whole and reading.kind(end + 2) != "unit" and reading.word(end + 2) not in ("x", "by"):
        return end + 2, int(value)
    if (
        word in (":", "-", ",", "–", "(")
        and whole
        and reading.words(end + 2, end + 4) in (("of", "them"), ("of", "those"), ("in", "number"), ("in", "total"))
        and not tells_some(reading, end + 1)
    ):
        return end + 4, int(value)
    least = reading.words(end + 1, end + 3) in (("at", "least"), ("not", "less"), ("a", "minimum")) or reading.word(
        end + 1
    ) in ("exactly", "about", "around", "altogether")
    number = end + (3 if reading.word(end + 2) in ("least", "minimum") else 2)
    if (
        word in (",", "(", ":")
        and least
        and reading.kind(number) == "number"
        and (reading.breaks(number + 1) or reading.word(number + 1) in (",", ")"))
    ):
        return number + 1 + (reading.word(number + 1) == ")"), int(reading.value(number))
    bounded = end + 2 + _bound_after(reading, end + 2)
    if word in (",", "(", ":") and whole and bounded > end + 2 and (word != "(" or reading.word(bounded) == ")"):
        return bounded + (word == "("), int(value)
    if word in (",", "-", "–", "(") and whole and reading.plural(end - 1) and _per_storey(reading, end + 2):
        return end + 2, int(value)
    if word in ("-", "–", ":") and whole and reading.plural(end - 1) and _ends_entry(reading, end + 2):
        return end + 2, int(value)
    several = reading.plural(end - 1) and end - 1 not in reading.taken
    if word == "," and whole and several and _is_closed(reading, end + 2) and not _counts_places(reading, end - 1):
        return end + 2, int(value)  # "judges' chambers, five, and a library"
    if word in (",", ":") and whole and reading.word(end + 2) in ("no", "nos", "number", "off", "pcs", "piece"):
        return end + 3 + (reading.word(end + 3) == "."), int(value)
    return end, None


def _is_bare_count(reading: Reading, index: int) -> bool:
    """Whether a number at a token counts the nouns right before it: "bathrooms one on each floor", "offices 6,"."""
    counts = reading.kind(index) == "number" and index not in reading.taken and is_whole_count(reading.value(index))
    if not counts or not reading.plural(index - 1) or _counts_places(reading, index - 1):
        return False
    shared = reading.words(index + 1, index + 3) in (
        ("on", "each"),
        ("on", "every"),
        ("per", "floor"),
        ("per", "storey"),
    )
    return shared or (reading.value(index) <= _MOST_BEHIND and _is_closed(reading, index + 1))


_MOST_BEHIND = 40
"""The largest number that counts what stands right before it; a larger one is a name or an area."""


def _is_closed(reading: Reading, index: int) -> bool:
    """Whether an entry of a list ends at a token, and no range of numbers goes on."""
    return (
        reading.breaks(index)
        or reading.word(index) in (")", ";")
        or (reading.word(index) == "," and reading.kind(index + 1) != "number")
    )


def _counts_places(reading: Reading, index: int) -> bool:
    """Whether a noun is of storeys or of people, which a number behind it does not count as rooms."""
    return reading.word(index) in FLOOR_WORDS | PEOPLE


_LEAST_AREA = 6
"""Square metres from which on a number in brackets behind one room may be its area."""


def _brackets_are_areas(reading: Reading, end: int) -> bool:
    """Whether numbers in brackets are areas: "450 m2: wood workshop (90), laboratory (60)", but not "offices (10)".

    Each of those behind a noun in the singular is large enough for one, and the brief tells areas.
    """
    if reading.plural(end - 1) or reading.word(end + 2) != ")":
        return False
    values = [
        reading.value(at + 1)
        for at in range(1, len(reading.tokens) - 2)
        if reading.word(at) == "(" and reading.word(at + 2) == ")" and reading.kind(at + 1) == "number"
        if not reading.plural(at - 1)
    ]
    measured = any(token.kind == "unit" and token.text in AREA for token in reading.tokens)
    return measured and len(values) > 1 and min(values) >= _LEAST_AREA


def _closes_classified(reading: Reading, index: int) -> int:
    """Return where a bracket ends that counts pieces, "(8 no.)", after its number; else 0."""
    last = index + 1 + (reading.word(index + 1) == ".")
    counts = reading.word(index) in ("no", "nos", "off", "pcs", "pc") and reading.word(last) == ")"
    return last + 1 if counts else 0


def _bound_after(reading: Reading, index: int) -> int:
    """Return how many tokens at one say of the number before them that it is the least: "(ten at least)"."""
    if reading.words(index, index + 2) in (("at", "least"), ("or", "more"), ("at", "minimum"), ("as", "minimum")):
        return 2
    return int(reading.word(index) in ("minimum", "min", "least"))


def _ends_entry(reading: Reading, index: int) -> bool:
    """Whether an entry of a list is over, or goes on after a comma: "interview rooms - 3, next to the cells"."""
    listed = reading.word(index) == "," and reading.kind(index + 1) != "number"
    return listed or reading.breaks(index)  # "rehearsal rooms: 60, 80 and 120 m2" are areas


def tells_some(reading: Reading, index: int) -> bool:
    """Whether a number speaks of some of several rooms, and not of all: "toilets, two of them accessible"."""
    of_them = reading.word(index + 1) == "of" and reading.word(index + 2) in ("them", "those", "these", "which")
    return of_them and (reading.value(index) == 1 or reading.word(index + 3) in _OF_SOME)


_OF_SOME = frozenset(
    "accessible wheelchair barrier step for with is are being must should suitable large small".split()
)
"""What is said of some of several rooms."""


def _per_storey(reading: Reading, index: int) -> bool:
    """Whether "per storey" stands at a token: "lecture rooms - three per floor"."""
    at = index + (reading.word(index) in ("on", "in", "at"))
    return reading.word(at) in ("per", "each", "every") and reading.word(at + 1) in FLOOR_WORDS


def name_of(reading: Reading, begin: int, end: int, core: int | None = None) -> str:
    """Return the snake-case name of a phrase: its words in the singular, without plain adjectives before its core."""
    core = end - 1 if core is None else core
    begin += begin < core and _measures_places(reading, begin)
    begin += begin < core and reading.words(begin - 1, begin + 1) == ("open", "plan")
    begin += 2 * (begin + 1 < core and reading.words(begin, begin + 2) == ("open", "plan"))
    words = [reading.word(i) for i in range(begin, end) if i >= core or _names(reading.tokens[i])]
    words = [word.replace("&", "_and_") for word in words]
    return "_".join(word for word in words if word.isascii() and word.replace("_", "").isalnum())[:60].strip("_")


def _measures_places(reading: Reading, index: int) -> bool:
    """Whether a token goes with the number before it that says for how many a room is: "10-person", "12-seat"."""
    joined = not reading.tokens[index].spaced and reading.kind(index - 1) == "number"
    return joined and reading.word(index) in ("person", "seat", "seater", "desk", "man", "bed")


def _names(token: Token) -> bool:
    return token.text not in PLAIN and token.text not in _JOINTS
