"""The wishes of a brief: a ledger of its statements, and which rooms get the furniture that it wants."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.furnished_as import furnished_as
from mansion_knowledge.stand_ins import answers_when_told, is_for_animals, stands_in
from mansion_language import singular
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.wishes import Scope, Wish, WishKind, WishValue
from mansion_msgs_py.wording import in_words
from mansion_planner.brief.bounds import Limit
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, FloorRef, ObjectFact, RoomFact, Span
from mansion_planner.brief.furniture_words import own_furniture_of
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.similarity import told_room_type
from mansion_planner.brief.sizes import size_bound
from mansion_planner.brief.told_by_size import rank_of
from mansion_planner.program.allocation import MANY
from mansion_planner.program.building_size import called_bound
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.furniture_areas import usual_number, usually_has
from mansion_planner.program.household import is_whole
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.people_rooms import place_requests
from mansion_planner.program.storeys import floors_of

__all__ = ["furniture_of", "requested_objects", "single_beds", "wishes_of"]


def furniture_of(decisions: Decisions, storeys: Sequence[Storey]) -> dict[tuple[int, str], list[RequestedObject]]:
    """Return the furniture that the brief wants in each planned room, by storey and room id.

    A number for "each" is for every room of the name; any other is shared out among those of a storey and of no copy
    of it, which has as many. Furniture without a room goes to the room that is most likely to have it: one whose type
    usually has such things (as many as that, for a number), the largest of those that the brief names, else the largest
    of all.
    """
    rooms = [
        (storey, room)
        for storey in storeys
        if storey.copy is None
        for top in (*storey.rooms, _hub_of(storey))
        for room in top.each()
    ]
    furniture: dict[tuple[int, str], list[RequestedObject]] = {}
    for fact in decisions.facts.objects:
        if not fact.category:
            continue
        for (storey, room), count in _shared_out(decisions, fact, rooms):
            furniture.setdefault((storey.index, room.id), []).append(
                RequestedObject(
                    category=fact.category,
                    count=count,
                    words=_called(decisions.facts, fact),
                    exact=fact.exact,
                    rows=fact.rows,
                )
            )
    for requests in (place_requests(decisions, rooms), single_beds(decisions, rooms)):
        for place, request in requests.items():
            furniture.setdefault(place, []).append(request)
    return furniture


def _shared_out(
    decisions: Decisions, fact: ObjectFact, rooms: list[tuple[Storey, PlannedRoom]]
) -> list[tuple[tuple[Storey, PlannedRoom], int]]:
    """Return the rooms that get furniture, each with its number of pieces."""
    matching = _matching(decisions, fact, rooms)
    if fact.excluded:
        return [(entry, 0) for entry in matching]
    count = 2 if fact.count is None else fact.count
    if not matching or not fact.room:
        storeys = dict.fromkeys(storey.index for storey, _ in matching) if fact.each else ()
        groups = [[entry for entry in matching if entry[0].index == index] for index in storeys]
        groups = groups or [matching or rooms]
        alike = _alike(fact, groups[0]) if len(groups) == 1 else []
        if alike:
            return list(zip(alike, _shares(count, len(alike))))
        chosen = [max(group, key=lambda entry: _likelihood(fact, entry)) for group in groups]
        others = [entry for group in groups for entry in group if entry not in chosen] if fact.most else []
        return [*((entry, count) for entry in chosen), *((entry, 0) for entry in others)]
    if fact.some and fact.some <= len(matching):
        first = fact.others if fact.others + fact.some <= len(matching) else 0
        return [(entry, -(-count // fact.some)) for entry in matching[first : first + fact.some]]
    if fact.each or not fact.exact or count < len(matching):
        return [(entry, count if fact.each else -(-count // len(matching))) for entry in matching]
    return list(zip(matching, _shares(count, len(matching))))


def _shares(count: int, places: int) -> list[int]:
    """Return a number shared out over some places, the first of them with one more where it does not go evenly."""
    return [count // places + (number < count % places) for number in range(places)]


def _alike(fact: ObjectFact, rooms: Sequence[tuple[Storey, PlannedRoom]]) -> list[tuple[Storey, PlannedRoom]]:
    """Return the rooms that share many beds in no room of the brief's: all that have some as a rule."""
    if not fact.category.endswith("bed") or (fact.count or 0) < MANY:
        return []
    found = [entry for entry in rooms if usually_has(entry[1].kind.name, fact.category)]
    return found if 1 < len(found) <= (fact.count or 0) else []


def _hub_of(storey: Storey) -> PlannedRoom:
    """Return a storey's hub as a room that furniture may be wanted in."""
    kind = storey.hub
    return PlannedRoom(id=kind.name, kind=kind, area=kind.least, least=kind.least, most=kind.most, base=kind.name)


def _noun(fact: ObjectFact) -> str:
    """Return what the brief calls one piece."""
    first, _, last = fact.noun.lower().rpartition(" ")
    return f"{first} {singular(last)}".strip()


def _called(facts: BriefFacts, fact: ObjectFact) -> str:
    """Return what the brief calls one piece, with the words that say how it is to be: "double bed"."""
    noun = _noun(fact)
    inside = [s.words.lower() for s in facts.unheeded if fact.span.start <= s.start and s.end <= fact.span.end]
    return " ".join([*(word for word in inside if word not in noun and " " not in word), noun])


def _matching(
    decisions: Decisions, fact: ObjectFact, rooms: list[tuple[Storey, PlannedRoom]]
) -> list[tuple[Storey, PlannedRoom]]:
    floors = set(floors_of(fact.floors, decisions))
    named = [(s, r) for s, r in rooms if not floors or s.index in floors]
    if not fact.room:
        return named
    own = [(s, r) for s, r in named if r.base == fact.room]
    return own or [(s, r) for s, r in named if r.kind.name == fact.room_type]


_MOST = 0.5
"""Share of many pieces that a room which gets all of them usually has."""


def _likelihood(fact: ObjectFact, entry: tuple[Storey, PlannedRoom]) -> tuple[bool, bool, bool, bool, bool, float]:
    _, room = entry
    count = fact.count or 2
    number = usual_number(room.kind.name, fact.category, max(room.area, room.kind.usual)) if count >= MANY else 0.0
    many = number >= MANY / 2
    most = many and number >= _MOST * count
    usual = usually_has(room.kind.name, fact.category)
    return most, many, usual, room.stated, room.kind.zone == "public", room.area


def requested_objects(decisions: Decisions, room_id: str, storey: Storey) -> list[RequestedObject]:
    """Return the furniture that `furniture_of` gives a room; a storey that repeats another has the same."""
    return decisions.furniture.get((storey.copy or storey.index, room_id), [])


def wishes_of(decisions: Decisions, knowledge: KnowledgeBase) -> list[Wish]:
    """Return every statement of the brief as a wish without a status.

    Parameters
    ----------
    decisions : Decisions
        Resolves what "the top floor" and "every storey" are.
    """
    ledger = _Ledger(decisions, knowledge)
    ledger.collect()
    found = sorted(ledger.found, key=lambda wish: (wish.span, wish.kind))
    return [
        Wish(
            id=f"wish_{n}",
            text=w.text,
            span=w.span,
            kind=w.kind,
            value=w.value,
            scope=w.scope,
            status=w.status,
            reason=w.reason,
        )
        for n, w in enumerate(found, 1)
    ]


_QUALIFIED = frozenset({"total_area", "room", "object", "stair", "elevator", "building_type"})
"""Kinds of wishes for things that can have properties."""


_AS_NAMED = {"bedroom": ("cabin", "berth", "chamber"), "private_office": ("office",), "open_kitchen": ("dining_room",)}
"""Last words of names for which a room type is what they say, whoever uses the room."""


def _stand_in_of(room: RoomFact, knowledge: KnowledgeBase, decisions: Decisions) -> str:
    """Say what is planned in the place of a room of which nothing is known, or that is another thing."""
    family = decisions.building.family
    furnished = furnished_as(room.room_type, decisions.building.name, room.name, ())
    if is_for_animals(room.room_type, room.name) and furnished == room.room_type:
        return f"planned and furnished like {in_words(room.room_type)}"
    if stands_in("rooms", room.room_type, room.name, family):
        return f"planned and furnished like {in_words(room.room_type)}"
    if "accessible" in room.name.split("_") and "accessible" not in room.room_type:
        return f"planned and furnished like any {in_words(room.room_type)}"
    if room.known or room.name == f"{room.room_type}_room":
        return ""  # "a kennel room"
    told = answers_when_told(room.room_type) and told_room_type(room.name, knowledge) == room.room_type
    if told or room.name.endswith(_AS_NAMED.get(room.room_type, ("-",))):
        return ""
    return f"no such room is known; planned and furnished like {in_words(room.room_type)}"


def _stand_in_for(wanted: ObjectFact) -> str:
    """Say what stands in the place of a thing that the catalogue has nothing of."""
    noun = _noun(wanted)
    only = not wanted.excluded and stands_in("objects", wanted.category, noun)
    if not only or own_furniture_of(tuple(noun.replace("-", " ").split())):
        return ""
    return f"no such thing is in the catalogue; {in_words(wanted.category)} stands for it"


class _Ledger:
    def __init__(self, decisions: Decisions, knowledge: KnowledgeBase) -> None:
        self.decisions, self.facts, self.knowledge = decisions, decisions.facts, knowledge
        self.found: list[Wish] = []

    def add(
        self, kind: WishKind, span: Span, value: WishValue, scope: Scope | None = None, *, reason: str = ""
    ) -> None:
        """Add a statement, unless the same words say the same already."""
        span = self._as_corrected(span)
        text = " ".join(span.words.split()[:12])
        unread = kind == "unread"
        unheeded = [w.words for w in self.facts.unheeded if span.start <= w.start and w.end <= span.end]
        if unheeded and kind in _QUALIFIED and not value.unwanted:
            value = msgspec.structs.replace(value, unheeded=[*value.unheeded, *unheeded])
        wish = Wish(
            id="wish",
            text=text,
            span=(span.start, span.end),
            kind=kind,
            value=value,
            scope=scope or Scope(),
            status="not_understood" if unread else "",
            reason=reason,
        )
        if wish not in self.found:
            self.found.append(wish)

    def _as_corrected(self, span: Span) -> Span:
        """Return the words of a statement up to the number that its own was replaced by."""
        for correction in self.facts.corrections:
            if span.start <= correction.start < span.end < correction.end:
                words = span.words[: correction.start - span.start] + correction.words
                return Span(words, span.start, correction.end)
        return span

    def floors(self, refs: tuple[FloorRef, ...]) -> list[int]:
        """Return the floor numbers that references mean."""
        return floors_of(refs, self.decisions)

    def collect(self) -> None:
        """Go through all facts."""
        self._building()
        self._shape_and_finish()
        self._storeys()
        self._vertical()
        for room in (*self.facts.rooms, *self.facts.households):
            self._room(room)
        self._absent_rooms()
        for fact in self.facts.adjacent:
            self._relation("adjacent", fact)
        for fact in self.facts.apart:
            self._relation("apart", fact)
        for wanted in self.facts.objects:
            self._object(wanted)
        for span in self.facts.unread:
            self.add("unread", span, WishValue(), reason="these words were not understood")

    def _building(self) -> None:
        """Add the kind of building, and how many storeys and square metres it is to have."""
        facts = self.facts
        decided = self.decisions
        stated = decided.floors if decided.floors_stated else None
        area, limit = (None, "") if decided.area_stated else called_bound(facts, decided.building, stated)
        for name, span in facts.building[:1]:
            if span.words:
                value = WishValue(name=facts.building_name or name, type=name, area=area, limit=limit)
                only = stands_in("buildings", name, span.words)
                reason = f"planned and furnished like any {in_words(name)}" if only else ""
                self.add("building_type", span, value, reason=reason)
        for span in facts.building_span[:1]:
            kind = decided.building.name
            reason = f"no such kind of building is known; planned like {in_words(kind)}"
            value = WishValue(name=facts.building_name, type=kind, area=area, limit=limit)
            self.add("building_type", span, value, reason=reason)
        for quantity in facts.floors:
            self.add("floors", quantity.span, WishValue(count=int(quantity.value)))
        for quantity in facts.basements:
            self.add("basements", quantity.span, WishValue(count=int(quantity.value)))
        for quantity in facts.area:
            above = next((span for span in facts.above_ground if span.start == quantity.span.start), None)
            scope = Scope(floors=list(range(1, decided.floors + 1))) if above is not None else Scope()
            value = WishValue(area=quantity.value, limit=quantity.limit)
            self.add("total_area", above or quantity.span, value, scope)
        for quantity in facts.floor_area:
            self.add("floor_area", quantity.span, WishValue(area=quantity.value, limit=quantity.limit))

    def _shape_and_finish(self) -> None:
        """Add the outline, the style, materials, the outside and heights."""
        facts = self.facts
        for shape, span in (*facts.shapes, *self.decisions.given_up.shapes):
            self.add("outline", span, WishValue(name=shape))
        for style, span in facts.styles:
            self.add("style", span, WishValue(name=style))
        for material in facts.materials:
            value = WishValue(name=material.material, type=material.surface)
            self.add("material", material.span, value, Scope(room_type=material.room_type, each=material.throughout))
        for fact in facts.outside:
            value = WishValue(name=fact.use or fact.name, type=fact.covering, count=fact.count or None)
            self.add(fact.part, fact.span, value)
        for clutter in facts.clutter:
            self.add("clutter", clutter.span, WishValue(name=clutter.clutter), Scope(room_type=clutter.room_type))
        for height in facts.heights:
            self.add("height", height.span, WishValue(height=height.height), Scope(room_type=height.room_type))

    def _storeys(self) -> None:
        """Add what is said of whole storeys and of all who use them."""
        facts = self.facts
        for use in facts.uses:
            value = WishValue(name=use.building_type, type=use.building_type)
            self.add("use", use.span, value, Scope(floors=self.floors(use.floors)))
        for copy in facts.copies:
            self.add("copy", copy.span, WishValue(), Scope(floors=self.floors((copy.first,))))
        for occupant in facts.occupants:
            self.add("occupants", occupant.span, WishValue(name=occupant.noun, count=occupant.count))
        for span in facts.only:
            self.add("only", span, WishValue())
        for span, refs in facts.only_on:
            self.add("only", span, WishValue(), Scope(floors=self.floors(refs)))

    def _absent_rooms(self) -> None:
        """Add the rooms that are not wanted, anywhere or on some storeys."""
        for name, span in (*self.facts.excluded, *self.decisions.given_up.excluded):
            self.add("no_room", span, WishValue(name=name, type=name, unwanted=True))
        for name, ref, span in self.facts.excluded_on:
            scope = Scope(floors=self.floors((ref,)))
            self.add("no_room", span, WishValue(name=name, type=name, unwanted=True), scope)

    def _vertical(self) -> None:
        counts = {q.span: int(q.value) for q in (*self.facts.lifts, *self.facts.stairs)}
        for name, span in (*self.facts.vertical, *self.decisions.given_up.vertical):
            kind: WishKind = "elevator" if name.endswith("elevator") else "stair"
            self.add(kind, span, WishValue(unwanted=name.startswith("no_"), count=counts.get(span)))

    def _room(self, room: RoomFact) -> None:
        reason = self._stand_in(room)
        whole = room.area is not None and is_whole(room, self.knowledge)
        area, limit = self._area_of(room)
        name = self._called(room)
        value = WishValue(
            name=name,
            type=room.room_type,
            count=room.count,
            area=area,
            whole=whole,
            limit=limit,
            rank=rank_of(room.name.partition("_")[0]),
        )
        self.add("room", room.span, value, Scope(floors=self.floors(room.floors), each=room.each), reason=reason)
        if room.unit:
            self._unit(room)
            return
        owners = room.count
        for child in room.suite:
            many = None if owners is None else owners * (child.count or 1)
            reason = self._stand_in(child)
            scope = Scope(floors=self.floors(room.floors), each=room.each, room=room.name, room_type=room.room_type)
            area, limit = self._area_of(child)
            value = WishValue(name=child.name, type=child.room_type, count=many, area=area, limit=limit)
            self.add("room", child.span, value, scope, reason=reason)

    def _stand_in(self, room: RoomFact) -> str:
        return _stand_in_of(room, self.knowledge, self.decisions)

    def _called(self, room: RoomFact) -> str:
        """Return a room's name as the brief has it, also where it is the hall that the building is there for."""
        renamed = room.name == self.decisions.building.hub and room.label
        return room.label.lower().replace(" ", "_") if renamed else room.name

    def _unit(self, room: RoomFact) -> None:
        """Add what each unit holds."""
        scope = Scope(floors=self.floors(room.floors), unit=room.name, unit_type=room.room_type)
        for child in room.suite:
            reason = self._stand_in(child)
            area, limit = self._area_of(child)
            value = WishValue(name=child.name, type=child.room_type, count=child.count, area=area, limit=limit)
            self.add("room", child.span, value, scope, reason=reason)

    def _area_of(self, room: RoomFact) -> tuple[float | None, Limit]:
        """Return the area that is asked for, and what it bounds; where a word says how large, by what is usual."""
        if room.area is None and room.size:
            kind = self.knowledge.room(room.room_type)
            return size_bound(room.size, kind.least, kind.usual)
        return room.area, room.limit

    def _relation(self, kind: WishKind, fact: AdjacencyFact) -> None:
        value = WishValue(
            name=fact.first_name or fact.first,
            type=fact.first,
            other=fact.second_name or fact.second,
            other_type=fact.second,
            door=fact.door,
            count=fact.sides if fact.sides > 1 else None,
            unheeded=[*fact.beyond, *self._unread_subject(fact.span)],
        )
        self.add(kind, fact.span, value, Scope(each=fact.each))

    def _unread_subject(self, relation: Span) -> list[str]:
        """Return what was not understood right before a relation's words, which may be about it and not what was read.

        Of "phonetics lab, an anechoic chamber wall to wall with" the chamber is the subject, but in "an archive,
        windowless and next to" a property stands there.
        """
        found = []
        for span in self.facts.unread:
            rest = relation.words[span.end - relation.start :].split()
            inside = relation.start < span.start and span.end < relation.end
            if inside and rest and rest[0][0].isalpha() and rest[0] != "and" and not is_property(span.words.lower()):
                found.append(span.words)
        return found

    def _unread_place(self, wanted: ObjectFact) -> list[str]:
        """Return what was not understood right before a thing, where it may stand: "the other one ten chairs"."""
        before = [span.words for span in self.facts.unread if 0 <= wanted.span.start - span.end <= 1]
        return [words for words in before if not (wanted.excluded or (wanted.room and words.split()[-1] != "one"))]

    def _object(self, wanted: ObjectFact) -> None:
        kind: WishKind = "no_object" if wanted.excluded else "object"
        words = wanted.noun if wanted.words.startswith("for ") else wanted.words
        value = WishValue(
            name=words.lower().replace(" ", "_"),
            type=wanted.category,
            count=None if wanted.excluded else wanted.count,
            unwanted=wanted.excluded,
            exact=wanted.exact and not wanted.excluded,
            limit="most" if wanted.most and not wanted.excluded else "",
            unheeded=self._unread_place(wanted),
        )
        self.add(kind, wanted.span, value, self._place_of(wanted), reason=_stand_in_for(wanted))

    def _place_of(self, wanted: ObjectFact) -> Scope:
        """Return where furniture is wanted; in the whole building where its room only names that."""
        floors = self.floors(wanted.floors)
        names = (self.facts.building_name, *(name for name, _ in self.facts.building))
        titles = {span.words.lower().replace(" ", "_") for _, span in self.facts.building}
        stated = {room.name for room in self.facts.rooms} | {room.room_type for room in self.facts.rooms}
        lists = self.decisions.building.storeys.values()
        usual = any(entry.room_type == wanted.room_type for entries in lists for entry in entries)
        called = wanted.room in {*names, *titles} or any(name and wanted.room.endswith(f"_{name}") for name in names)
        if called and wanted.room not in stated and not usual:
            return Scope(floors=floors, each=wanted.each)
        return Scope(floors=floors, room=wanted.room, room_type=wanted.room_type, each=wanted.each, some=wanted.some)


_BEDS: Final = {
    "dorm_room": "single_bed",
    "hotel_room": "single_bed",
    "patient_room": "hospital_bed",
    "resident_room": "hospital_bed",
    "bedroom": "single_bed",
}
"""Bed of each type of room in which more than one may stand."""


def single_beds(
    decisions: Decisions, rooms: Sequence[tuple[Storey, PlannedRoom]]
) -> dict[tuple[int, str], RequestedObject]:
    """Return the one bed of each single room, by storey and room.

    Parameters
    ----------
    decisions : Decisions
    rooms : sequence of (Storey, PlannedRoom)
        All rooms of the building.
    """
    beds = {object_.room for object_ in decisions.facts.objects if object_.category.endswith("bed")}
    singles = {
        fact.name: fact.room_type for fact in decisions.facts.rooms if _is_single(fact) and fact.name not in beds
    }
    return {
        (storey.index, room.id): RequestedObject(category=_BEDS[room.kind.name], count=1, words="bed", exact=True)
        for storey, room in rooms
        if singles.get(room.base, "-") == room.kind.name
    }


def _is_single(fact: RoomFact) -> bool:
    """Whether a fact is about several rooms for one person each: "a single bedroom" is a number."""
    return fact.room_type in _BEDS and (fact.count or 0) > 1 and "single" in fact.span.words.lower().split()
