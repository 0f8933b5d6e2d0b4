"""A noun phrase of a brief, with the counts, the determiner and the name that stand around its head."""

from dataclasses import dataclass
from typing import Literal, TypeAlias

from mansion_language import Token
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = [
    "FUNCTION_WORDS",
    "PEOPLE",
    "PLAIN",
    "UNITS_OF_ROOMS",
    "Head",
    "Phrase",
    "count_after",
    "count_before",
    "finished_phrase",
    "name_of",
    "tells_some",
]

Head: TypeAlias = Literal["room", "building", "stair", "elevator", "object", "people", "unknown"]

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
    straight also only just even still again very quite too rather really maybe perhaps possibly ideally mainly
    mostly partly nearly about around approximately roughly circa ca approx almost least most more less many few
    several multiple various numerous much enough same identical alike altogether together total overall exactly
    precisely apart away someone everybody everyone anyone nobody nothing everything something anything one's
    live sleep eat
    cook meet walk carry gather believe afford love find see look say tell ask think know located situated placed
    spread divided split equipped furnished fitted surrounded arranged organised organized reserved dedicated called
    named known planned needed wanted required preferred desired expected apiece respectively etc ie eg namely such
    measure measuring occupy occupying span spanning
    well however therefore moreover nevertheless obviously yes ok pls hello hi dear thanks thank upstairs downstairs
    upstair downstair throughout everywhere anywhere elsewhere neither
    either incl leaving fleeing escaping standing ditto idem likewise half itself themselves
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
    adjoining adjacent neighbouring neighboring nearby accessible wooden
    """.split()
)
"""Adjectives that say how a room is, and are no part of its name."""

PEOPLE = frozenset(
    """
    people person resident occupant pupil student child employee worker guest patient adult inhabitant staff teacher
    kid user visitor elderly tenant inmate firefighter officer diner roommate friend colleague developer lodger
    brother sister member player nun monk soldier crew engineer worshipper customer client artist family household
    passenger traveller commuter donor drummer dancer musician nurse doctor consultant lawyer architect agent
    analyst programmer designer journalist trader operator researcher scientist professor lecturer cleaner waiter
    detainee prisoner technician judge juror priest cook chef baker brewer
    midwife therapist pilot driver clerk trainee apprentice intern volunteer swimmer climber viewer spectator
    delegate
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
    label = reading.text[reading.tokens[begin].start : reading.tokens[end - 1].end]
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
        if (
            reading.kind(index) == "number"
            and not reading.tokens[index + 1].spaced
            and reading.word(index + 1) in UNITS_OF_ROOMS
        ):
            index -= 1  # "two-bedroom" is an adjective
            continue
        if reading.kind(index) == "number" and reading.text[
            reading.tokens[index].end : reading.tokens[index].end + 1
        ] in ("-", "‑"):
            break  # "two-family house", "four-poster bed"
        if reading.kind(index) == "number" and not reading.tokens[index].spaced and reading.kind(index - 1) == "word":
            break  # "BSL-3 laboratory" has the number in its name
        if reading.kind(index) == "number" and index not in reading.taken:
            value = reading.value(index)
            adjective = (
                reading.tokens[index].soft
                and reading.plural(end - 1)
                and word in ("single", "double", "twin", "triple")
            )
            if adjective or word == "double":
                index -= 1
                continue
            if value != int(value) or not 1 <= value <= 2000:
                break
            if reading.word(index - 1) in ("and", "–", "to", "or") and reading.kind(index - 2) == "number":
                low = reading.value(index - 2)
                if reading.word(index - 1) != "and" and low < value <= 3 * low:
                    return index - 2, int((low + value) / 2), True, determiner
            first = index
            while (
                reading.word(first - 1)
                in ("least", "at", "exactly", "about", "a", "of", "minimum", "up", "to", "some", "around", "roughly")
                and first - 1 not in reading.taken
                and begin - first < 5
            ):
                if reading.word(first - 1) in ("at", "to", "of", "a") and reading.word(first) not in (
                    "least",
                    "minimum",
                ):
                    break
                first -= 1
            if reading.word(first - 1) in ("the", "these", "those", "both", "all", "our", "each", "every"):
                determiner = determiner or reading.word(first - 1)
            return first, int(value), True, determiner
        if word in ("nos", "no", "pcs", "pc") and reading.kind(index - 1) == "number":
            index -= 1  # "30 nos. chairs"
            continue
        if word == "." and reading.word(index - 1) in ("nos", "no", "pcs") and reading.kind(index - 2) == "number":
            index -= 2
            continue
        if word == "of" and reading.kind(index - 1) == "number" and reading.tokens[index - 1].soft:
            index -= 1
            continue
        if word in (
            "a",
            "an",
            "the",
            "each",
            "every",
            "per",
            "own",
            "its",
            "their",
            "our",
            "my",
            "her",
            "his",
            "both",
            "all",
            "no",
            "this",
            "that",
            "these",
            "those",
            "any",
            "either",
            "another",
            "some",
            "several",
            "many",
            "multiple",
            "few",
            "various",
            "numerous",
            "enough",
            "more",
        ):
            determiner = determiner or word
            if word in ("own", "more", "few"):
                index -= 1
                continue
            if word == "no":
                return begin, None, False, determiner
            if word == "a" and determiner == "few":
                return index, None, False, "several"
            return index, None, False, determiner
        if word in ("more", "other", "such", "very", "same", "separate"):
            index -= 1
            continue
        break
    return begin, None, False, determiner


def count_after(reading: Reading, end: int) -> tuple[int, int | None]:
    """Read "(4)", "x3", ": five of them", ", 18 no." after a head; return where it ends and the number."""
    word = reading.word(end)
    value = reading.value(end + 1) if reading.kind(end + 1) == "number" else 0.0
    whole = value == int(value) and 1 <= value <= 2000
    if word == "(" and whole and reading.word(end + 2) in (")", "of", ":", ","):
        return end + (3 if reading.word(end + 2) == ")" else 2), int(value)
    if word == "(" and reading.word(end + 1) == "x" and reading.kind(end + 2) == "number":
        many = reading.value(end + 2)
        if reading.word(end + 3) == ")" and many == int(many) and 1 <= many <= 2000:
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
    if word in (",", "-", "–", "(") and whole and reading.plural(end - 1) and _per_storey(reading, end + 2):
        return end + 2, int(value)
    if word in (",", ":") and whole and reading.word(end + 2) in ("no", "nos", "number", "off", "pcs", "piece"):
        return end + 3 + (reading.word(end + 3) == "."), int(value)
    return end, None


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
    words = [reading.word(i) for i in range(begin, end) if i >= core or _names(reading.tokens[i])]
    words = [word.replace("&", "_and_") for word in words]
    return "_".join(word for word in words if word.isascii() and word.replace("_", "").isalnum())[:60].strip("_")


def _names(token: Token) -> bool:
    return token.text not in PLAIN and token.text not in _JOINTS
