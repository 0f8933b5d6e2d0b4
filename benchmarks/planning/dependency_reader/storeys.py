"""References to storeys in a parsed brief, and how many storeys and basements it asks for."""

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace

from dependency_reader.negations import refused
from dependency_reader.rules import Rules
from dependency_reader.tree import Node, Tree, is_noun
from mansion_planner.brief.facts import BriefFacts, FloorRef, Quantity
from mansion_planner.brief.reading import FLOOR_WORDS

__all__ = ["Place", "Storeys"]


@dataclass(frozen=True)
class Place:
    """A reference to storeys: tokens `begin` to `end` (exclusive), and the node whose subtree it places."""

    node: Node
    begin: int
    end: int
    refs: tuple[FloorRef, ...]
    anchor: Node
    leads: bool
    block: bool


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
_UP = frozenset(
    {"pobj", "pcomp", "prep", "advmod", "npadvmod", "compound", "amod", "nmod", "det", "nummod", "quantmod"}
)


class Storeys:
    """Reads storeys; adds their number to `facts`, and the tokens that name them to `used`."""

    def __init__(self, tree: Tree, rules: Rules, facts: BriefFacts, used: set[int]) -> None:
        self.reading, self.nodes, self.segments = tree.reading, tree.nodes, tree.segments
        self.rules, self.facts, self.used = rules, facts, used
        self.british = False

    def read_conventions(self) -> None:
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

    def find(self) -> Iterator[Place]:
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
            yield Place(node, begin, end, refs, self._anchor(index, node), leads, block)

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
        if any(child.lower_ == "no" for child in node.children) or refused(node, self.rules):
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
            if node.pos_ in ("VERB", "AUX") or (is_noun(node) and node.dep_ not in ("pobj",)):
                return node
            if is_noun(node) and node != begin and node.dep_ == "pobj" and node.head.lower_ not in ("of",):
                return node
        if node.dep_ in ("nsubj", "nsubjpass", "attr", "expl", "dep", "appos", "conj", "intj"):
            return node.head
        return node
