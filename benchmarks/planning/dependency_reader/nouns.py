"""Noun phrases of a parsed brief: what each names, by the words of the product's reader, and how many."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from dependency_reader.rules import Rules
from dependency_reader.tree import Node, Tree
from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.phrase import name_of
from mansion_planner.brief.reading import FLOOR_WORDS
from mansion_planner.brief.similarity import HEAD_TYPES, room_of_building, similar_room_type

__all__ = ["EACH", "Nouns", "Thing"]

_STAIRS = frozenset({"stair", "staircase", "stairwell", "stairway"})
_LIFTS = frozenset({"lift", "elevator"})
EACH = frozenset({"each", "every", "both", "all", "any", "per", "either", "apiece"})
_PURPOSEFUL = frozenset("room store storage workshop hall area space studio office lab cellar storeroom".split())
_HOLDING = frozenset(
    "with has have hold holds holding contain contains containing house houses housing gets get".split()
)
_PLAIN_HEADS = frozenset({"area", "space", "section", "zone", "corner", "place", "center", "centre"})


@dataclass
class Thing:
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
    same: "Thing | None" = None
    owner: "Thing | None" = None

    @property
    def is_room(self) -> bool:
        """Whether this names rooms of the building."""
        return self.kind in ("room", "building") and bool(self.room_type)

    def itself(self) -> "Thing":
        """Return what this speaks of: itself, or what was named before."""
        return self if self.same is None else self.same.itself()


class Nouns:
    """The things that a brief names.

    Parameters
    ----------
    used : collection of int
        Tokens that name storeys.

    Attributes
    ----------
    things : list of Thing
        From left to right.
    building : Thing, optional
        What names the building itself.
    """

    def __init__(self, tree: Tree, rules: Rules, used: Collection[int]) -> None:
        self.tree, self.rules, self.used = tree, rules, used
        self.reading, self.nodes, self.segments = tree.reading, tree.nodes, tree.segments
        self.things = sorted(self._things(), key=lambda thing: thing.begin)
        self.owners = {(self.segments[t.end - 1], t.node.i): t for t in self.things}
        self.building: Thing | None = None

    def thing(self, index: int, node: Node) -> Thing | None:
        """Return the thing that a node heads, in the segment of token `index`."""
        return self.owners.get((self.segments[index], node.i))

    def with_conjuncts(self, thing: Thing) -> list[Thing]:
        """Return a thing and those joined to it after it."""
        found = [thing]
        for node in thing.node.children:
            if node.dep_ in ("conj", "appos"):
                other = self.thing(thing.begin, node)
                if other is not None and other.begin > thing.begin:
                    found += [t for t in self.with_conjuncts(other) if t not in found]
        return found

    def before(self, index: int, others: Sequence[Thing] = ()) -> list[Thing]:
        """Return the room that a pronoun at a token means: the last that is named before it."""
        rooms = [t for t in self.things if t.end <= index and t.is_room and t is not self.building]
        return [t for t in rooms if t not in others and index - t.end < 25][-1:]

    def count(self, thing: Thing) -> None:
        """Read counts and determiners: children of the head, or the noun that "of" joins it to."""
        node, index = thing.node, thing.end - 1
        numbers = []
        if node.dep_ == "pobj" and node.head.lower_ == "per":
            thing.determiner = "per"
        for child in node.children:
            if child.dep_ in ("det", "predet") or child.lower_ in ("each", "every", "no", "both", "all"):
                word = child.lower_
                thing.determiner = word if not thing.determiner or word in EACH else thing.determiner
            elif child.dep_ == "poss" and child.pos_ == "PRON":
                thing.determiner = thing.determiner or child.lower_
            value = self.tree.number_of(index, child)
            if value is None:
                continue
            after = child.i > node.i
            at = self.tree.index(index, child)
            glued = at is not None and at + 1 < len(self.reading.tokens) and self.reading.word(at + 1) in FLOOR_WORDS
            if not glued and (child.dep_ == "nummod" or (after and self.rules.numbered_noun)):
                numbers.append(value)
        if not numbers and node.dep_ == "pobj" and node.head.lower_ == "of":
            value = self.tree.number_of(index, node.head.head)
            numbers += [value] if value is not None else []
        if (
            not numbers
            and self.reading.kind(thing.begin - 1) == "number"
            and self.tree.number_of(index, self.nodes[thing.begin - 1])
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
        head = self.tree.index(index, node.head)
        if node.dep_ in ("compound", "nmod", "amod", "poss") and head is not None and head > index:
            times = node.head.lower_.startswith("x") and node.head.lower_[1:].isdigit()
            return (
                times
                or reading.kind(head) != "word"
                or "/" in reading.words(index, head)
                or "," in reading.words(index, head)
            )
        return True

    def _things(self) -> Iterator[Thing]:
        index = len(self.reading.tokens) - 1
        while index >= 0:
            thing = self._classified(self.tree.begin(index), index + 1) if self._heads(index) else None
            if thing is not None:
                yield thing
                index = thing.begin
            index -= 1

    def _classified(self, begin: int, end: int) -> Thing | None:
        """Return what a noun phrase names, by the product's vocabulary."""
        reading, node = self.reading, self.nodes[end - 1]
        words = reading.words(begin, end)
        last = words[-1]
        thing = Thing("", node, begin, end, plural=reading.plural(end - 1))
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
        if self.rules.unknown_objects and held and self.tree.word(end - 1, node) not in FLOOR_WORDS:
            thing.kind, thing.name = "object", name
            return thing
        return None

    def _purpose(self, index: int) -> str:
        """Return what a room is for: "books" in "a room for books", "director" in "the office of the director"."""
        for child in self.nodes[index].children:
            if child.dep_ == "prep" and child.lower_ in ("for", "of"):
                for below in child.children:
                    at = self.tree.index(index, below)
                    plain = at is not None and self.reading.kind(at) == "word" and below.pos_ in ("NOUN", "PROPN")
                    if plain and below.dep_ == "pobj":
                        return self.reading.word(at)
        return ""
