"""Areas in a parsed brief, and whose they are: a room's, a storey's or the building's."""

from dependency_reader.nouns import Nouns, Thing
from dependency_reader.tree import Node, Tree
from mansion_language.units import AREA
from mansion_planner.brief.facts import BriefFacts, Quantity
from mansion_planner.brief.reading import FLOOR_WORDS

__all__ = ["Areas"]

_TOTALS = frozenset("total overall altogether gross gfa together whole".split())


class Areas:
    """Reads areas into things and `facts`."""

    def __init__(self, tree: Tree, nouns: Nouns, facts: BriefFacts) -> None:
        self.tree, self.nouns, self.facts = tree, nouns, facts
        self.reading, self.nodes = tree.reading, tree.nodes

    def read(self) -> None:
        """Give each area to what it is of."""
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
            if isinstance(target, Thing) and target is not self.nouns.building:
                target.areas = target.areas or values
                return
            storey = target == "floor" or per[0] in ("each", "apiece") or "footprint" in near
        if storey:
            self.facts.floor_area = self.facts.floor_area or [Quantity(values[0], span)]
            return
        if len(values) == 1 and (not self.facts.area or _TOTALS & near):
            self.facts.area = [Quantity(values[0], span)]

    def _owner_of_area(self, index: int, node: Node) -> Thing | str | None:
        linked = False
        while node.head != node:
            linked = linked or node.dep_ == "pobj"
            was, node = node, node.head
            thing = self.nouns.thing(index, node)
            if thing is not None:
                return thing if thing.is_room or thing.kind == "building" else None
            if self.tree.word(index, node) in FLOOR_WORDS:
                plural = any(self.tree.number_of(index, child) for child in node.children) or node.tag_ == "NNS"
                return (
                    "floor"
                    if (plural and linked) or any(c.lower_ in ("each", "every", "all") for c in node.children)
                    else None
                )
            if node.pos_ in ("VERB", "AUX"):
                for child in node.children:
                    subject = self.nouns.thing(index, child)
                    if child.dep_ in ("nsubj", "nsubjpass") and child != was and subject is not None:
                        return subject if subject.is_room else None
                return None
        return None
