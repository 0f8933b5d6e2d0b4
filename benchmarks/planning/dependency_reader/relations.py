"""Rooms of a parsed brief that are to be side by side or apart."""

from collections.abc import Collection, Iterator, Sequence

from dependency_reader.nouns import Nouns, Thing
from dependency_reader.rules import Rules
from dependency_reader.tree import Node, Tree

__all__ = ["APART", "BESIDE", "Relation", "Relations"]

Relation = tuple[Thing, Thing, bool, int]
"""Two rooms, whether they are to be apart, and the token that says so."""
BESIDE = frozenset(
    """
    next adjacent adjoining adjoin adjoins beside besides alongside close near neighbouring neighboring neighbour
    neighbours border borders bordering abut abuts abutting touch touches touching open opens opening lead leads
    leading connect connects connected connecting link linked links join joins joined attached off between behind side
    opposite share sharing shares reached accessible accessed access connection door communicates against directly
    """.split()
)
APART = frozenset("away apart far separated separate remote isolated distant".split())
_IT = Thing("pronoun", None, -1, -1)


class Relations:
    """Goes from words such as "beside" to the rooms on both sides of them.

    Parameters
    ----------
    used : collection of int
        Tokens that name storeys.
    """

    def __init__(self, tree: Tree, rules: Rules, nouns: Nouns, used: Collection[int]) -> None:
        self.tree, self.rules, self.nouns, self.used = tree, rules, nouns, used
        self.nodes = tree.nodes

    def find(self) -> Iterator[Relation]:
        """Yield pairs of rooms that are to be side by side or apart, and the token that says so."""
        for index, node in enumerate(self.nodes):
            word = "" if node is None else node.lower_
            if word not in BESIDE | APART or index in self.used:
                continue
            rights = self._below(index, node, 0)
            lefts, negated = self._above(index, node, rights)
            if _IT in rights:
                rights = [t for t in rights if t is not _IT] + self.nouns.before(index, lefts)
            if not rights and len(lefts) > 1 and word not in ("open", "close", "separate", "off"):
                rights = lefts[1:]
                lefts = lefts[:1]
            apart = (word in APART) != negated or (word in APART)
            for left in lefts:
                for right in rights:
                    if left is not right:
                        yield left, right, apart, index

    def _below(self, index: int, node: Node, depth: int) -> list[Thing]:
        """Return the rooms that a relation's words lead down to."""
        found: list[Thing] = []
        for child in node.children:
            if child.dep_ in ("prep", "advmod", "agent", "acomp", "dative") and depth < 3 and child.i > node.i:
                found += self._below(index, child, depth + 1)
            elif child.dep_ in ("pobj", "dobj", "oprd"):
                thing = self.nouns.thing(index, child)
                listed = [t for t in (self.nouns.thing(index, below) for below in child.subtree) if t is not None]
                if (
                    thing is not None
                    and listed
                    and listed[0] is not thing
                    and listed[0].node.dep_ in ("compound", "nmod")
                ):
                    found.append(listed[0])  # "the lab, staff room": the parser takes a list for a compound
                elif thing is not None and thing.kind in ("room", "building", "stair", "elevator"):
                    found += [t for t in self.nouns.with_conjuncts(thing) if t.is_room]
                elif child.lower_ in ("it", "them", "this", "that", "which"):
                    found.append(_IT)
                elif child.lower_ in ("wall", "door", "access", "one", "any", "either", "both", "front"):
                    found += self._below(index, child, depth + 1)
        return found

    def _above(self, index: int, node: Node, rights: Sequence[Thing]) -> tuple[list[Thing], bool]:
        """Return the rooms on the left of a relation, and whether the relation is negated."""
        negated = any(child.dep_ == "neg" or child.lower_ in ("not", "never") for child in node.children)
        steps = 0
        while steps < self.rules.reach:
            subjects = [child for child in node.children if child.dep_ in ("nsubj", "nsubjpass")]
            for child in subjects:
                thing = self.nouns.thing(index, child)
                if child.lower_ in ("that", "which", "it", "this"):
                    thing = self.nouns.thing(index, node.head) if node.dep_ in ("relcl", "ccomp") else None
                    thing = thing or next(iter(self.nouns.before(index)), None)
                if thing is not None and thing not in rights and thing.is_room:
                    negated = negated or any(c.lower_ in ("neither", "no") for c in child.children)
                    return [t for t in self.nouns.with_conjuncts(thing) if t.is_room and t not in rights], negated
            if node.head == node:
                break
            node = node.head
            steps += 1
            negated = negated or any(child.dep_ == "neg" or child.lower_ == "never" for child in node.children)
            thing = self.nouns.thing(index, node)
            if thing is not None and thing.is_room and thing not in rights and thing is not self.nouns.building:
                if rights:
                    return [thing], negated
                first = self.nouns.thing(index, self.tree.first_conjunct(node)) or thing
                return [t for t in self.nouns.with_conjuncts(first) if t.is_room and t.end <= index][-2:], negated
            for child in node.children:
                thing = self.nouns.thing(index, child)
                argument = child.dep_ in ("dobj", "attr", "nsubj", "nsubjpass")
                if argument and thing is not None and thing not in rights and thing.is_room:
                    return [t for t in self.nouns.with_conjuncts(thing) if t.is_room and t not in rights], negated
        return [], negated
