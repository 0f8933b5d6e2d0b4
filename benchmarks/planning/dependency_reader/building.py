"""What names the building in a parsed brief, and what is said right before that name."""

from dependency_reader.nouns import Nouns, Thing
from dependency_reader.tree import Tree
from mansion_planner.brief.building_shape import read_sizes
from mansion_planner.brief.facts import BriefFacts, RoomFact

__all__ = ["Building"]


class Building:
    """Reads the kind of building, how tall it is called, and "three-bedroom" before it, into `facts`."""

    def __init__(self, tree: Tree, nouns: Nouns, facts: BriefFacts) -> None:
        self.tree, self.nouns, self.facts = tree, nouns, facts
        self.reading, self.nodes, self.segments = tree.reading, tree.nodes, tree.segments

    def find(self) -> Thing | None:
        """Return the noun that names the building: the highest in the tree of the first sentences."""
        best: tuple[int, int, Thing] | None = None
        for thing in self.nouns.things:
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
        at = self.tree.index(0, root) if root is not None else None
        if (
            at is not None
            and root.pos_ in ("NOUN", "PROPN")
            and not any(t.begin <= at < t.end for t in self.nouns.things)
        ):
            begin = self.tree.begin(at)
            self.facts.building_name = "_".join(self.reading.words(begin, at + 1))
            self.facts.building_span.append(self.reading.span(begin, at + 1))
        self._sizes(0, 0)
        return None

    def _sizes(self, begin: int, end: int) -> None:
        """Read how tall the building is called, in the words of the product's reader."""
        self.reading.facts.size.clear()
        read_sizes(self.reading, begin, end)
        self.facts.size = list(self.reading.facts.size)

    def _bedrooms_before(self, thing: Thing) -> None:
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
