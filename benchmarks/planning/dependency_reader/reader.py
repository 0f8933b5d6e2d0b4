"""Read the core statements of a brief from its parse: nouns, what is said of them, and at last the facts."""

from collections.abc import Sequence
from dataclasses import replace

from dependency_reader.areas import Areas
from dependency_reader.attachment import Attachment
from dependency_reader.building import Building
from dependency_reader.negations import negate
from dependency_reader.nouns import EACH, Nouns, Thing
from dependency_reader.ownership import Ownership
from dependency_reader.relations import Relation, Relations
from dependency_reader.rules import Rules
from dependency_reader.storeys import Place, Storeys
from dependency_reader.tree import Parsed, Tree
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, CopyFact, ObjectFact, RoomFact, Span

__all__ = ["read_parsed"]

_SEATED = frozenset("people guest person diner student pupil visitor patient customer seat child".split())


def read_parsed(parsed: Parsed, rules: Rules) -> BriefFacts:
    """Return the core statements of a brief that is parsed."""
    tree, facts = Tree(parsed), BriefFacts()
    used: set[int] = set()
    storeys = Storeys(tree, rules, facts, used)
    storeys.read_conventions()
    places = sorted(storeys.find(), key=lambda place: place.begin)
    nouns = Nouns(tree, rules, used)
    nouns.building = Building(tree, nouns, facts).find()
    for thing in nouns.things:
        nouns.count(thing)
    Attachment(tree, rules, nouns, places).place_things()
    Areas(tree, nouns, facts).read()
    negate(nouns.things, rules)
    relations = list(Relations(tree, rules, nouns, used).find())
    ownership = Ownership(tree, rules, nouns)
    ownership.corefer(relations)
    ownership.give_owners()
    ownership.repeat(places)
    _Statements(tree, nouns, places, facts).state(relations)
    return facts


class _Statements:
    """Adds to `facts` what is said of rooms, furniture, stairs and lifts."""

    def __init__(self, tree: Tree, nouns: Nouns, places: Sequence[Place], facts: BriefFacts) -> None:
        self.tree, self.nouns, self.places, self.facts = tree, nouns, places, facts
        self.reading, self.nodes, self.segments = tree.reading, tree.nodes, tree.segments

    def state(self, relations: Sequence[Relation]) -> None:
        """Add the facts of all things and relations."""
        for thing in self.nouns.things:
            span = self.reading.span(thing.begin, thing.end)
            if thing is self.nouns.building:
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

    def _state_core(self, thing: Thing, span: Span) -> None:
        if thing.negated or self.reading.word(thing.end) == "no":
            self.facts.vertical.append((f"no_{thing.kind}", span))
            return
        self.facts.vertical.append((thing.kind, span))
        if any(child.lower_ == "only" for child in (*thing.node.children, *thing.node.head.children)):
            self.facts.vertical.append(("no_elevator" if thing.kind == "stair" else "no_stair", span))

    def _state_object(self, thing: Thing, span: Span) -> None:
        room = thing.owner.itself() if thing.owner is not None else None
        if room is None and not thing.category:
            return
        each = thing.owner is not None and (
            thing.owner.determiner in EACH or thing.owner.plural or self.reading.word(thing.end) in ("each", "apiece")
            or "per" in self.reading.words(thing.end, thing.end + 2)
        )  # fmt: skip
        self.facts.objects.append(
            ObjectFact(
                thing.label, thing.category, span, thing.count, room.name if room is not None else "",
                room.room_type if room is not None else "", each=each, excluded=thing.negated,
            )
        )  # fmt: skip

    def _seats(self, thing: Thing) -> None:
        """Read "a dining room for 48 guests" as the chairs that they need."""
        for child in thing.node.children:
            if child.lower_ not in ("for", "seating") or thing.room_type in ("bedroom", "garage"):
                continue
            for below in child.children:
                value = self.tree.number_of(thing.begin, below) or next(
                    filter(None, (self.tree.number_of(thing.begin, c) for c in below.children)), None
                )
                at = self.tree.index(thing.begin, below)
                if value and at is not None and self.tree.word(thing.begin, below) in _SEATED and value > 1:
                    span = self.reading.span(at, at + 1)
                    room = thing.itself()
                    self.facts.objects.append(ObjectFact(span.words, "chair", span, value, room.name, room.room_type))

    def _room_facts(self, thing: Thing, span: Span) -> list[RoomFact]:
        owned = [t for t in self.nouns.things if t.owner is not None and t.owner.itself() is thing and t.is_room]
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
