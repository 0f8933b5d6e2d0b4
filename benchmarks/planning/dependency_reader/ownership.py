"""What belongs together in a parsed brief: names of one room, furniture and its room, rooms that others have."""

from collections.abc import Sequence
from dataclasses import replace

from dependency_reader.nouns import Nouns, Thing
from dependency_reader.relations import Relation
from dependency_reader.rules import Rules
from dependency_reader.storeys import Place
from dependency_reader.tree import Tree

__all__ = ["Ownership"]

_DEFINITE = frozenset({"the", "per", "this", "that", "these", "those", "each", "every", "both", "either", "any", "all"})


class Ownership:
    """Joins things to others."""

    def __init__(self, tree: Tree, rules: Rules, nouns: Nouns) -> None:
        self.tree, self.rules, self.nouns = tree, rules, nouns
        self.reading, self.segments = tree.reading, tree.segments

    def corefer(self, relations: Sequence[Relation]) -> None:
        """Find the rooms that only speak of one named elsewhere."""
        if not self.rules.coreference:
            return
        operands = {id(right) for _, right, _, _ in relations}
        rooms = [t for t in self.nouns.things if t.is_room and t is not self.nouns.building and not t.negated]
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
    def _alike(thing: Thing, other: Thing) -> bool:
        return (
            thing.name == other.name
            or other.name.endswith(f"_{thing.name}")
            or other.name.startswith(f"{thing.name}_")
            or ("_" not in thing.name and thing.room_type == other.room_type)
        )

    def give_owners(self) -> None:
        """Find the room of furniture, and rooms that each of others has for itself."""
        things, building = self.nouns.things, self.nouns.building
        for thing in things:
            if thing.kind == "object":
                thing.owner = self._inside(thing) or self._holder(thing)
                if thing.owner is None and self.rules.topic_owns:
                    rooms = [t for t in self.nouns.things if t.is_room and t.end <= thing.begin and t is not building]
                    same = [t for t in rooms if self.segments[t.begin] == self.segments[thing.begin]]
                    thing.owner = same[-1] if same else None
            elif thing.is_room and thing is not building and not thing.negated:
                holder = self._holder(thing)
                if holder is None or holder is thing or holder is building or not holder.is_room:
                    continue
                lead = {child.lower_ for child in thing.node.children} | {holder.determiner}
                near = set(self.reading.words(holder.end, thing.begin)) | {self.reading.word(thing.end)}
                mine = "own" in near | lead and not {"our", "my"} & lead
                if near & {"each", "every"} or mine or lead & {"each", "every", "its"}:
                    thing.owner = holder

    def _inside(self, thing: Thing) -> Thing | None:
        """Return the room that a preposition below a thing, or its verb, puts it into."""
        node = thing.node
        first = self.tree.first_conjunct(node)
        last = self.nouns.with_conjuncts(thing)[-1].node
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
                        room = self.nouns.thing(thing.begin, below)
                        if room is not None and room.is_room and room is not self.nouns.building:
                            return room
                        if below.lower_ in ("it", "them"):
                            return next(iter(self.nouns.before(thing.begin)), None)
        return None

    def _holder(self, thing: Thing) -> Thing | None:
        """Return the room that has a thing: "a hall with ...", "the hall has ...", "a hall holding ..."."""
        node = self.tree.first_conjunct(thing.node)
        topic = self.nouns.thing(thing.begin, node)
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
                room = self.nouns.thing(thing.begin, up)
                if room is not None and room.is_room and room is not thing and room is not self.nouns.building:
                    return room if node.dep_ != "conj" else None
                if up.pos_ in ("VERB", "AUX"):
                    for child in up.children:
                        room = self.nouns.thing(thing.begin, child)
                        if child.dep_ in ("nsubj", "nsubjpass") and room is not None and room.is_room:
                            return room
            node = up
        return None

    def repeat(self, places: Sequence[Place]) -> None:
        """Read "five on the second floor, four on the third" as of the rooms named before."""
        extra: list[Thing] = []
        for place in places:
            preposition = place.node.head
            number = preposition.head if place.node.dep_ == "pobj" else None
            value = self.tree.number_of(place.begin, number) if number is not None else None
            at = self.tree.index(place.begin, number) if number is not None else None
            if value is None or at is None:
                continue
            before = [t for t in self.nouns.things if t.is_room and t.end <= at and t is not self.nouns.building]
            if before and number.dep_ not in ("nummod",):
                extra.append(
                    replace(before[-1], begin=at, end=place.end, count=value, counted=True, refs=place.refs, same=None)
                )
                before[-1].kind = "total"
        self.nouns.things = sorted([*self.nouns.things, *extra], key=lambda thing: thing.begin)
