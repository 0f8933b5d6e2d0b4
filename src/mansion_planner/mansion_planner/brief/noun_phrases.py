"""Read noun phrases: a count, modifiers and a head that names a room, a building, a core, furniture or people.

``[count] modifier* head [(count) | x3 | five of them]``; the head is the longest phrase of the lexicon that ends the
phrase, else a noun that can head a room's name ("honey room"), else a piece of furniture of the asset catalogue.
"""

import re
from dataclasses import dataclass, replace
from functools import cache
from typing import Literal, TypeAlias

from mansion_language import Token, singular
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.similarity import HEAD_TYPES, room_of_building, similar_room_type

__all__ = ["Head", "Phrase", "furniture_of", "noun_phrases"]

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
    precisely someone everybody everyone anyone nobody nothing everything something anything one's live sleep eat
    cook meet walk carry gather believe afford love find see look say tell ask think know located situated placed
    spread divided split equipped furnished fitted surrounded arranged organised organized reserved dedicated called
    named known planned needed wanted required preferred desired expected apiece respectively etc ie eg namely such
    well however therefore moreover nevertheless obviously yes ok pls hello hi dear thanks thank upstairs downstairs
    upstair downstair
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

_SOFT_PLURAL = frozenset(
    """
    several multiple various many few some numerous more enough
    """.split()
)
_PEOPLE = frozenset(
    """
    people person resident occupant pupil student child employee worker guest patient adult inhabitant staff teacher
    kid user visitor elderly tenant inmate firefighter officer diner roommate friend colleague developer lodger
    brother sister member player nun monk soldier crew engineer worshipper customer client artist family household
    passenger traveller commuter donor drummer dancer musician nurse doctor consultant lawyer architect agent
    analyst programmer designer journalist trader operator researcher scientist professor lecturer cleaner waiter
    midwife therapist pilot driver clerk trainee apprentice intern volunteer swimmer climber viewer spectator
    delegate
    """.split()
)
_STAIRS = frozenset({"stair", "staircase", "stairwell", "stairway", "stairs"})
_LIFTS = frozenset({"lift", "elevator"})
_UNITS_OF_ROOMS = frozenset(
    """
    bed bedroom room br bath person car storey story bay seat man
    """.split()
)
_NO_HEADS = frozenset({"area", "space", "section", "zone", "corner", "place", "center", "centre"})


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


def noun_phrases(reading: Reading) -> list[Phrase]:
    """Return the noun phrases among the tokens that are not read yet, from left to right; their tokens are taken."""
    phrases: list[Phrase] = []
    chunks = _chunks(reading)
    for begin, end in chunks:
        phrases += _phrases_of(reading, begin, end)
    phrases += _listed_unknowns(reading, chunks, phrases)
    named = [own for phrase in phrases for own in _with_own_names(reading, _with_purpose(reading, phrase))]
    return sorted(named, key=lambda phrase: phrase.first)


def _chunks(reading: Reading) -> list[tuple[int, int]]:
    """Return the runs of content words that no function word, number or mark interrupts."""
    inside = _inside_mentions(reading)
    chunks, begin = [], -1
    for index in range(len(reading.tokens) + 1):
        content = (
            index < len(reading.tokens)
            and index not in reading.taken
            and reading.kind(index) == "word"
            and (
                reading.word(index) not in FUNCTION_WORDS
                or index in inside
                or _hyphenated(reading, index)
                or _is_acronym(reading, index)
            )
            and reading.word(index) not in FLOOR_WORDS
        )
        glued = (
            index < len(reading.tokens) - 1
            and index not in reading.taken
            and reading.kind(index) == "number"
            and (not reading.tokens[index + 1].spaced or reading.tokens[index].soft)
            and reading.word(index + 1) in _UNITS_OF_ROOMS | {"height"}
            and begin >= 0
        )
        soft = content or (index < len(reading.tokens) and index not in reading.taken and index in inside)
        if soft or glued:
            begin = index if begin < 0 else begin
        elif begin >= 0:
            chunks.append((begin, index))
            begin = -1
    return chunks


def _with_own_names(reading: Reading, phrase: Phrase) -> list[Phrase]:
    """Read the names that rooms are given: the party room "Typhoon"; private rooms called Sapporo, Kobe and Nagoya."""
    if phrase.head != "room":
        return [phrase]
    last = phrase.last
    listed = _listed_names(reading, phrase)
    if listed:
        return listed
    called = reading.word(last) in ("called", "named") or (reading.word(last) == "(" and reading.word(last + 1) == '"')
    if reading.word(last) == '"' or (called and reading.word(last + 1) == '"'):
        begin = last + 1 + called
        end = next((i for i in range(begin, min(begin + 6, len(reading.tokens))) if reading.word(i) == '"'), begin)
        if end > begin:
            own = reading.text[reading.tokens[begin].start : reading.tokens[end - 1].end]
            reading.take(last, end + 1)
            return [_named(reading, phrase, own, phrase.first, end + 1)]
    if not called:
        return [phrase]
    names, index = [], last + 1
    while reading.kind(index) == "word" and reading.tokens[index].capital:
        names.append(index)
        index += 1
        step = 2 if reading.words(index, index + 2) == (",", "and") else 1 if reading.word(index) in (",", "and") else 0
        if not step:
            break
        index += step
    if not names:
        return [phrase]
    reading.take(last, names[-1] + 1)
    many = len(names) > 1
    return [
        replace(
            _named(
                reading,
                phrase,
                reading.text[reading.tokens[n].start : reading.tokens[n].end],
                n if many else phrase.first,
                n + 1,
            ),
            count=1,
            counted=many or phrase.counted,
            plural=False,
            noun_end=n + 1 if many else phrase.noun_end,
            begin=n if many else phrase.begin,
        )
        for n in names
    ]


def _listed_names(reading: Reading, phrase: Phrase) -> list[Phrase]:
    """Read "three science labs (physics, chemistry, biology)": as many names as rooms."""
    last, count = phrase.last, phrase.count or 0
    if reading.word(last) not in ("(", "-", ":", "–") or not phrase.counted or not 2 <= count <= 12:
        return []
    closers = (")",) if reading.word(last) == "(" else ("\n", ".", ";")
    items: list[tuple[int, int]] = []
    begin = index = last + 1
    while index < len(reading.tokens) and index - last < 40:
        ends = reading.word(index) in closers
        if ends or reading.word(index) in (",", "and"):
            if index > begin:
                items.append((begin, index))
            begin = index + 1
            if ends:
                break
        elif reading.kind(index) != "word" or index in reading.taken:
            return []
        index += 1
    if len(items) != count or any(b - a > 3 for a, b in items):
        return []
    reading.take(last, index + (reading.word(index) == ")"))
    found = []
    for a, b in items:
        own = reading.text[reading.tokens[a].start : reading.tokens[b - 1].end]
        name = "_".join(re.findall(r"[a-z0-9]+", own.lower().replace("'s", "").replace("’s", "")))
        found.append(
            replace(
                phrase,
                name=f"{name}_{phrase.name}"[:60],
                label=f"{own} {singular(phrase.label.lower())}",
                count=1,
                counted=True,
                plural=False,
                first=a,
                begin=a,
                noun_end=b,
                last=b,
            )
        )
    return found


def _named(reading: Reading, phrase: Phrase, own: str, first: int, last: int) -> Phrase:
    words = "_".join(re.findall(r"[a-z0-9]+", own.lower()))
    return replace(
        phrase, name=words or phrase.name, label=f"{own} ({singular(phrase.label.lower())})", first=first, last=last
    )


_LIST_STARTS = frozenset({":", ",", "and", "a", "an", "the", "one", "*", "-", "|", "plus", "&", "\n", "="})
_LIST_ENDS = frozenset(
    {
        ",",
        ".",
        ";",
        "and",
        "|",
        "\n",
        "",
        "(",
        "next",
        "beside",
        "plus",
        "&",
        "with",
        "on",
        "in",
        "adjacent",
        "adjoining",
    }
)


def _listed_unknowns(reading: Reading, chunks: list[tuple[int, int]], phrases: list[Phrase]) -> list[Phrase]:
    """Return the entries of lists of rooms that nobody knows ("vivarium and cage wash"), as rooms of the nearest kind.

    Only where rooms stand in the same sentence, or a storey's heading opens it: other unknown words are no rooms.
    """
    rooms_in = {reading.sentence[phrase.first] for phrase in phrases if phrase.head == "room"}
    found: list[Phrase] = []
    ends = {phrase.last - 1 for phrase in phrases if phrase.head == "room"}
    for begin, end in chunks:
        if not reading.free(begin, end) or end - begin > 3:
            continue
        sentence = reading.sentence[begin]
        start = next(i for i in range(begin, -1, -1) if i == 0 or reading.sentence[i - 1] != sentence)
        headed = any(i in reading.taken and reading.word(i) == ":" for i in range(start, begin)) or (
            start in reading.taken and reading.word(start) not in _LIST_STARTS
        )
        if sentence not in rooms_in and not headed:
            continue
        before = reading.word(begin - 1)
        counted = reading.kind(begin - 1) == "number" and begin - 1 not in reading.taken
        opens = before in _LIST_STARTS or counted or begin - 1 in reading.taken
        joined = (
            before in (":", ",", "and", "|", "-", "*", "&", "\n")
            or counted
            or (
                before in ("a", "an", "the", "one")
                and reading.word(begin - 2) in (",", "and", ":", "a", "|", "with", "has")
            )
        )
        if not opens or not (joined or begin - 1 in reading.taken) or reading.word(end) not in _LIST_ENDS:
            continue
        words = reading.words(begin, end)
        if counted and reading.plural(end - 1) and words[-1].endswith(("er", "or", "ist", "ant", "ian", "eer")):
            continue  # "30 consultants" are people
        if any(word in PLAIN or word.endswith(("ly", "ed")) or word in _NO_ROOMS for word in words[-1:]):
            continue
        bare = before in (",", "and", "&", "|") and not counted
        if bare and begin - 2 not in ends and (begin - 3 not in ends or reading.word(begin - 2) != ","):
            continue
        name = _name(reading, begin, end)
        phrase = _finish(reading, "room", begin, end, room=similar_room_type(name, reading.knowledge), known=False)
        reading.take(phrase.first, phrase.last)
        ends.add(phrase.last - 1)
        found.append(phrase)
    return found


_NO_ROOMS = frozenset(
    """
    style look feel window door wall ceiling roof floor view light noise smell garden outside street visitor guest
    material colour color area interior facade terrace steps step ramp way time year day night week money budget lot
    plenty kind sort type size shape plan layout entrance access room place part one none whole wood oak brick stone
    glass steel concrete marble gold silver white black green blue red furniture gross net total rectangle footprint
    square thing stuff number escape dust water power heating cooling air sun daylight privacy quiet peace m metre
    meter roof
    """.split()
)

_PURPOSEFUL = frozenset(
    """
    room store storage workshop hall area space shop studio office lab cellar storeroom
    """.split()
)


def _with_purpose(reading: Reading, phrase: Phrase) -> Phrase:
    """Add what a room is for to its name: "a room for the bicycles" is a bicycle room."""
    last = phrase.last
    if (
        phrase.head != "room"
        or reading.word(phrase.noun_end - 1) not in _PURPOSEFUL
        or reading.word(last) not in ("for", "of")
    ):
        return phrase
    if reading.word(last) == "of" and phrase.noun_end - phrase.begin > 1:
        return phrase
    begin = last + 1 + (reading.word(last + 1) in ("the", "our", "all", "my", "a"))
    end = begin
    while end < begin + 3 and reading.kind(end) == "word" and reading.word(end) not in FUNCTION_WORDS:
        end += 1
    if end == begin:
        return phrase
    purpose = "_".join(reading.words(begin, end))
    name = f"{purpose}_{phrase.name}"[:60]
    generic = phrase.name in _PURPOSEFUL
    room = (
        similar_room_type(name, reading.knowledge)
        if generic and phrase.name in ("room", "space", "area")
        else phrase.room_type
    )
    label = reading.text[reading.tokens[phrase.begin].start : reading.tokens[end - 1].end]
    reading.take(last, end)
    return replace(phrase, name=name, label=label, last=end, room_type=room or phrase.room_type)


def _is_acronym(reading: Reading, index: int) -> bool:
    """Whether a word is information technology rather than a pronoun."""
    token = reading.tokens[index]
    return token.text == "it" and reading.text[token.start : token.end] == "IT"


def _hyphenated(reading: Reading, index: int) -> bool:
    """Whether a function word is part of a compound ("write-up area", "drop-in centre")."""
    joined = index > 0 and not reading.tokens[index].spaced and reading.kind(index - 1) == "word"
    following = (
        index + 1 < len(reading.tokens) and not reading.tokens[index + 1].spaced and reading.kind(index + 1) == "word"
    )
    return joined or following


def _inside_mentions(reading: Reading) -> set[int]:
    """Tokens of phrases of several words, which may hold function words ("walk in closet")."""
    inside: set[int] = set()
    for mention in reading.mentions:
        if mention.last - mention.first > 1 and reading.free(mention.first, mention.last):
            inside.update(range(mention.first, mention.last))
    return inside


def _phrases_of(reading: Reading, begin: int, end: int) -> list[Phrase]:
    """Read a run of content words: one phrase as a rule, more where a head is followed by words that go on."""
    phrases: list[Phrase] = []
    while begin < end:
        found = None
        for stop in range(end, begin, -1):
            found = _headed(reading, begin, stop, whole=stop == end)
            if found is not None:
                break
        if found is None:
            break
        phrases.append(found)
        reading.take(found.first, found.last)
        begin = max(found.last, found.noun_end)
    return phrases


def _headed(reading: Reading, begin: int, end: int, *, whole: bool) -> Phrase | None:
    """Return the phrase of tokens `begin` to `end` if the last of them can be its head."""
    last = reading.word(end - 1)
    if last in _STAIRS | _LIFTS:
        return _finish(reading, "stair" if last in _STAIRS else "elevator", begin, end)
    mention = _mention_ending(reading, begin, end)
    if mention is not None and (mention.room or mention.building):
        room = mention.room or room_of_building(mention.building, reading.knowledge)
        if (
            last == "hall"
            and mention.last - mention.first == 1
            and end - begin > 1
            and _name(reading, begin, end) != "hall"
        ):
            room = _hall_of(reading, begin, end)
        head: Head = "room" if mention.room or not mention.building else "building"
        return _finish(reading, head, begin, end, room=room, building=mention.building, mention=mention)
    bare = last == "room" and all(word in PLAIN or word in ("guest",) for word in reading.words(begin, end - 1))
    if bare and reading.plural(end - 1) and _before(reading, begin, end)[2]:
        return _finish(reading, "room", begin, end, room="study_room", known=False)
    if last == "room" and end - begin == 1 and reading.word(end) == "for" and not reading.plural(end - 1):
        return _finish(reading, "room", begin, end, room="study_room", known=False)
    alone = last in _STANDS_ALONE and (reading.plural(end - 1) or _before(reading, begin, end)[2])
    if alone and end - begin == 1:
        return _finish(reading, "room", begin, end, room=HEAD_TYPES[last], known=False)
    if last in HEAD_TYPES and end - begin > 1 and not (last in _NO_HEADS and reading.word(end - 2) in PLAIN):
        name = _name(reading, begin, end)
        if name != last:
            kind = similar_room_type(name, reading.knowledge)
            return _finish(reading, "room", begin, end, room=kind, known=False)
    if last in _PEOPLE:
        return _finish(reading, "people", begin, end)
    category, _ = furniture_of(reading.words(begin, end))
    if category:
        return _finish(reading, "object", begin, end, category=category)
    return None


_STANDS_ALONE = frozenset({"surgery", "booth", "cabin", "cell", "ward", "salon", "loft", "kiosk", "chapel"})
"""Nouns that name a room without a word before them, where they are counted or stand in the plural."""


def _hall_of(reading: Reading, begin: int, end: int) -> str:
    """Return what a hall is for, by the words before it: a "gym hall" is a gym; a hall of a home is another thing."""
    if reading.word(end - 2) in ("entrance", "entry", "front", "stair", "little", "small", "tiny"):
        return "hallway"
    before = _mention_ending(reading, begin, end - 1)
    return before.room if before is not None and before.room else "assembly_hall"


def _mention_ending(reading: Reading, begin: int, end: int) -> Mention | None:
    """Return the longest phrase of the lexicon that ends at token `end`, whatever stands before it in the chunk."""
    from mansion_planner.brief.lexicon import lexicon_of

    lexicon = lexicon_of(reading.knowledge)
    texts = reading.words(begin, end)
    for size in range(min(lexicon.longest, end - begin), 0, -1):
        meaning = lexicon.phrases.get(texts[-size:])
        if meaning is not None and (meaning.room or meaning.building):
            return Mention(end - size, end, meaning.room, meaning.building, meaning.style, reading.plural(end - 1))
    return None


def _finish(
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
    first, count, counted, determiner = _before(reading, begin, end)
    plural = reading.plural(end - 1)
    if not counted:
        count = None if plural or determiner in _SOFT_PLURAL else 1
    last, after = _count_after(reading, end)
    if after is not None and not counted:
        count, counted = after, True
    elif after is None:
        last = end
    if head in ("room", "building"):
        reading.modifiers.update(range(begin, mention.first if mention is not None else end - 1))
    name = _name(reading, begin, end, core=mention.first if mention is not None else end - 1)
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


def _before(reading: Reading, begin: int, end: int) -> tuple[int, int | None, bool, str]:
    """Return where the phrase starts, its number, whether it has one, and its determiner."""
    index, determiner = begin - 1, ""
    for _ in range(4):
        word = reading.word(index)
        if (
            reading.kind(index) == "number"
            and not reading.tokens[index + 1].spaced
            and reading.word(index + 1) in _UNITS_OF_ROOMS
        ):
            index -= 1  # "two-bedroom" is an adjective
            continue
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


def _count_after(reading: Reading, end: int) -> tuple[int, int | None]:
    """Read "(4)", "x3", ": five of them", ", 18 no." after a head; return where it ends and the number."""
    word = reading.word(end)
    value = reading.value(end + 1) if reading.kind(end + 1) == "number" else 0.0
    whole = value == int(value) and 1 <= value <= 2000
    if word == "(" and whole and reading.word(end + 2) in (")", "of", ":", ","):
        return end + (3 if reading.word(end + 2) == ")" else 2), int(value)
    if word == "x" and whole and reading.kind(end + 2) != "unit" and reading.word(end + 2) not in ("x", "by"):
        return end + 2, int(value)
    if (
        word in (":", "-", ",", "–", "(")
        and whole
        and reading.words(end + 2, end + 4) in (("of", "them"), ("of", "those"), ("in", "number"), ("in", "total"))
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
    if word in (",", ":") and whole and reading.word(end + 2) in ("no", "nos", "number", "off", "pcs", "piece"):
        return end + 3 + (reading.word(end + 3) == "."), int(value)
    return end, None


def _name(reading: Reading, begin: int, end: int, core: int | None = None) -> str:
    """Return the snake-case name of a phrase: its words in the singular, without plain adjectives before its core."""
    core = end - 1 if core is None else core
    words = [reading.word(i) for i in range(begin, end) if i >= core or _names(reading.tokens[i])]
    return "_".join(word for word in words if word.isascii() and word.replace("_", "").isalnum())[:60].strip("_")


def _names(token: Token) -> bool:
    return token.text not in PLAIN and token.text not in FUNCTION_WORDS


def furniture_of(words: tuple[str, ...]) -> tuple[str, int]:
    """Return the category of the asset catalogue that a phrase ends with, and of how many words; empty for none.

    Examples
    --------
    >>> furniture_of(("grand", "piano")), furniture_of(("big", "sofa")), furniture_of(("dream",))
    (('grand_piano', 2), ('sofa', 1), ('', 0))
    """
    table = _furniture()
    for size in range(min(4, len(words)), 0, -1):
        category = table.get(words[-size:])
        if category:
            return category, size
    return "", 0


_SEATS = {
    "seat": "chair",
    "place": "",
    "book": "",
    "cover": "",
    "box": "",
    "watch": "",
    "badge": "",
    "key": "",
    "light": "",
    "stage": "",
    "sign": "",
    "pump": "",
    "cart": "",
    "paper": "",
    "board": "",
    "stand": "",
    "case": "",
    "computer": "computer_tower",
    "counter": "service_counter",
    "screen": "",
    "window": "",
    "table": "dining_table",
    "tub": "bathtub",
    "telly": "television",
    "tv": "television",
    "bike": "bicycle",
    "press": "",
    "fan": "",
    "scale": "",
    "rack": "shelving_unit",
    "plant": "house_plant",
    "couch": "sofa",
    "settee": "sofa",
    "cooker": "stove",
    "oven": "stove",
    "shelf": "bookshelf",
    "bookcase": "bookshelf",
    "locker": "locker",
    "workstation": "office_desk",
    "bunk": "bunk_bed",
    "berth": "single_bed",
    "cot": "crib",
}


@cache
def _furniture() -> dict[tuple[str, ...], str]:
    """Phrases of the asset catalogue, by their words in the singular; names win over synonyms."""
    from mansion_assets.catalogue import load_catalogue

    catalogue = load_catalogue()
    table: dict[tuple[str, ...], str] = {}
    for names in (True, False):
        for category in catalogue.categories:
            asset = catalogue.by_category(category)[0]
            for phrase in (category.replace("_", " "), asset.name) if names else asset.synonyms:
                key = tuple(singular(word) for word in phrase.lower().replace("-", " ").replace("_", " ").split())
                table.setdefault(key, category)
    for word, category in _SEATS.items():
        if category in catalogue.categories or not category:
            table[(word,)] = category
    return table
