"""Which storeys the rooms and furniture of a parsed brief are on."""

from collections.abc import Sequence

from dependency_reader.nouns import Nouns, Thing
from dependency_reader.rules import Rules
from dependency_reader.storeys import Place
from dependency_reader.tree import Node, Tree, is_noun

__all__ = ["Attachment"]


class Attachment:
    """Gives things the storeys of references, from left to right."""

    def __init__(self, tree: Tree, rules: Rules, nouns: Nouns, places: Sequence[Place]) -> None:
        self.tree, self.rules, self.nouns, self.places = tree, rules, nouns, places
        self.segments = tree.segments

    def place_things(self) -> None:
        """Give each thing its storeys: of the deepest anchor above it, else of what leads its clause or its list."""
        block: Place | None = None
        latest: Place | None = None
        pending = list(self.places)
        for thing in self.nouns.things:
            while pending and pending[0].begin < thing.begin:
                latest = pending.pop(0)
                block = latest if latest.block else block
            if thing is self.nouns.building:
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

    def _holding(self, place: Place) -> Node:
        """Return the anchor of a place, or the room whose furniture the parser takes the place to be of."""
        anchor = place.anchor
        thing = self.nouns.thing(place.begin, anchor)
        while thing is not None and thing.kind == "object" and anchor.head != anchor:
            anchor = anchor.head
            above = self.nouns.thing(place.begin, anchor)
            if above is not None and above.is_room:
                return anchor
        return place.anchor

    def _passed(self, place: Place, anchor: Node, thing: Thing) -> bool:
        """Whether a place is said of a noun and a thing is only joined to that noun after it."""
        if not is_noun(anchor) or place.leads or thing.begin < place.end or place.node.i < anchor.i:
            return False
        node = thing.node
        while node != anchor and node.head != node:
            if node.dep_ in ("conj", "appos"):
                return True
            node = node.head
        return False

    def _nearest(self, thing: Thing) -> Place | None:
        found = []
        for place in self.places:
            if self.segments[place.begin] != self.segments[thing.begin]:
                continue
            anchor = self._holding(place)
            above = anchor == thing.node or (anchor.is_ancestor(thing.node) and not self._passed(place, anchor, thing))
            if not above and self.rules.conjuncts_placed and place.begin >= thing.end and is_noun(anchor):
                anchor = self.tree.first_conjunct(anchor)
                above = anchor == thing.node or (anchor.is_ancestor(thing.node) and thing.node.i < place.anchor.i)
            if above:
                depth = sum(1 for _ in anchor.ancestors)
                gap = thing.begin - place.end if place.end <= thing.begin else 2 * (place.begin - thing.end)
                found.append((-depth, gap, place.begin, place))
        return min(found, key=lambda entry: entry[:3])[3] if found else None
