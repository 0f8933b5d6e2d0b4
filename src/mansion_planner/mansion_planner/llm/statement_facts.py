"""The statements that a model read in a brief as the facts that the rules' reader would make of them."""

import re
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TypeVar, get_args

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.outside_words import outside_words
from mansion_language import singular, tokenize
from mansion_llm import Fault
from mansion_llm.quotes import find_quote
from mansion_msgs_py.wishes import MOST_WORDS
from mansion_planner.brief.facts import (
    AdjacencyFact,
    BriefFacts,
    ClutterFact,
    CopyFact,
    FloorRef,
    HeightFact,
    MaterialFact,
    ObjectFact,
    OccupantFact,
    OutsideFact,
    Quantity,
    RoomFact,
    Shape,
    Span,
    UseFact,
)
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.lexicon import Mention, lexicon_of
from mansion_planner.brief.similarity import room_of_building, similar_room_type
from mansion_planner.llm.answers import ReadingAnswer, StatementAnswer
from mansion_planner.llm.cleaning import clean_text, is_core_name

__all__ = ["ASIDE", "StatementFacts", "facts_of_statements"]


ASIDE = "aside"
"""Kind of a statement that asks for nothing: a greeting, a reason."""

_MOST_STATEMENTS = 300
_MOST_ROOMS = 500
_MOST_PEOPLE = 1_000_000
_MOST_PLACES = 400
_MOST_AREA = 1e6
_HEIGHTS = (1.5, 30.0)

_FLOOR_WORDS: dict[str, FloorRef] = {
    "ground": FloorRef("number", 1, 1), "top": FloorRef("top", 1), "roof": FloorRef("roof", 1),
    "basement": FloorRef("basement"), "every": FloorRef("every"), "upper": FloorRef("upper"),
    "lower": FloorRef("lower"), "middle": FloorRef("middle"), "odd": FloorRef("odd"), "even": FloorRef("even"),
    "not_top": FloorRef("not_top"),
}  # fmt: skip
_OUTLINES: dict[str, Shape] = {shape.lower(): shape for shape in get_args(Shape)}


@dataclass(frozen=True)
class StatementFacts:
    """What the usable statements of an answer state.

    Attributes
    ----------
    facts : BriefFacts
        `unread` has the words that the model itself calls not understood.
    spans : tuple of Span
        Spans of the usable statements that are understood, asides included.
    kinds : tuple of str
        Their kinds.
    faults : tuple of Fault
        What is wrong with the other statements.
    """

    facts: BriefFacts
    spans: tuple[Span, ...]
    kinds: tuple[str, ...]
    faults: tuple[Fault, ...]


class _UnusableError(ValueError):
    """Says what a statement lacks."""


@dataclass(frozen=True)
class _Named:
    """A room's name in snake case, the type that stands for it, and whether the name is known."""

    name: str
    type: str
    known: bool

    @property
    def label(self) -> str:
        return self.name.replace("_", " ")


_Meaning = TypeVar("_Meaning", bound=str)


def _meant(text: str, known: Mapping[str, _Meaning]) -> _Meaning | None:
    """Return what words stand for, or the name itself that is one of those; ``None`` for anything else."""
    words = text.strip().lower().replace("_", " ")
    own = next((name for name in known.values() if name.replace("_", " ") == words), None)
    return known.get(words) or own


def facts_of_statements(answer: ReadingAnswer, text: str, knowledge: KnowledgeBase) -> StatementFacts:
    """Return the facts of an answer's usable statements, and the faults of the others.

    Parameters
    ----------
    text : str
        The brief; a statement whose quote is not in it is not usable.
    """
    reader = _StatementReader(text, knowledge, _building_names(answer))
    for number, entry in enumerate(answer.statements, 1):
        reader.read(number, entry)
    if len(answer.statements) > _MOST_STATEMENTS:
        reader.faults.append(Fault(f"{len(answer.statements)} statements are too many; at most {_MOST_STATEMENTS}"))
    reader.attach_private_rooms()
    return StatementFacts(reader.facts, tuple(reader.spans), tuple(reader.kinds), tuple(reader.faults))


class _StatementReader:
    """Collects the facts of one answer."""

    def __init__(self, text: str, knowledge: KnowledgeBase, whole: frozenset[str]) -> None:
        self.text, self.knowledge, self.whole = text, knowledge, whole
        self.facts = BriefFacts()
        self.spans: list[Span] = []
        self.kinds: list[str] = []
        self.faults: list[Fault] = []
        self.private: list[tuple[_Named, RoomFact]] = []
        self.taken: dict[str, set[tuple[int, int]]] = {}
        self.readers: dict[str, Callable[[StatementAnswer, Span], None]] = {
            "building_type": self._building_type, "floors": self._floors, "basements": self._basements,
            "total_area": self._total_area, "floor_area": self._floor_area, "outline": self._outline,
            "style": self._style, "use": self._use, "copy": self._copy, "stair": self._vertical,
            "elevator": self._vertical, "room": self._room, "no_room": self._no_room, "adjacent": self._relation,
            "apart": self._relation, "object": self._object, "no_object": self._object, "height": self._height,
            "material": self._material, "facade": self._facade, "roof": self._roof, "grounds": self._grounds,
            "clutter": self._clutter, "occupants": self._occupants, "only": self._only,
            "unread": self._unread,
            ASIDE: lambda entry, span: None,
        }  # fmt: skip

    def read(self, number: int, entry: StatementAnswer) -> None:
        """Take one statement as far as it is usable."""
        shown = f"statement {number} ({clean_text(entry.kind, 20)}, {clean_text(entry.quote, 60)!r})"
        try:
            if number > _MOST_STATEMENTS:
                return
            span = self._quoted(entry)
            self.readers[entry.kind](entry, span)
        except _UnusableError as error:
            self.faults.append(Fault(f"{shown}: {error}", str(number)))
            return
        self.taken.setdefault(f"{entry.kind} {entry.quote}", set()).add((span.start, span.end))
        if entry.kind != "unread":
            self.spans.append(span)
            self.kinds.append(entry.kind)

    def _quoted(self, entry: StatementAnswer) -> Span:
        if entry.kind not in self.readers:
            raise _UnusableError(f"kind is one of {', '.join(self.readers)}")
        place = find_quote(self.text, entry.quote, self.taken.get(f"{entry.kind} {entry.quote}", ()))
        if place is None:
            raise _UnusableError("the quote is not in the brief; repeat its words letter by letter")
        span = Span(self.text[slice(*place)], *place)
        if len(span.words.split()) > MOST_WORDS:
            raise _UnusableError(f"the quote is longer than {MOST_WORDS} words; quote only those that state it")
        return span

    # Names and places -----------------------------------------------------------------------------------------------

    def _last_mention(self, name: str) -> Mention | None:
        """Return the phrase of the knowledge base that a name ends with."""
        tokens = tokenize(name.replace("_", " "))
        mentions = lexicon_of(self.knowledge).find(tokens)
        return mentions[-1] if mentions and mentions[-1].last == len(tokens) else None

    def _named_room(self, name: str, kind: str) -> _Named:
        own, stated = _snake(name) or _snake(kind), _snake(kind)
        if not own:
            raise _UnusableError("value.name must name the room in English snake case")
        if is_core_name(own):
            raise _UnusableError("stairs and lifts are statements of kind stair or elevator")
        mention = self._last_mention(own)
        found = ""
        if mention is not None:
            found = mention.room or room_of_building(mention.building, self.knowledge)
        if stated in self.knowledge.rooms:
            return _Named(own, stated, bool(found) or own in (stated, "room"))
        if found:
            return _Named(own, found, known=True)
        return _Named(own, similar_room_type(own, self.knowledge), known=False)

    def _named_building(self, entry: StatementAnswer) -> tuple[str, str, bool]:
        """Return the name of a kind of building, the type that stands for it, and whether the name is known."""
        own, stated = _snake(entry.value.name) or _snake(entry.value.type), _snake(entry.value.type)
        mention = self._last_mention(own) if own else None
        found = own if own in self.knowledge.buildings else mention.building if mention is not None else ""
        if stated not in self.knowledge.buildings:
            stated = found
        if not stated:
            raise _UnusableError("value.type must be one of the building types of the list")
        return own, stated, bool(found)

    def _places(self, entry: StatementAnswer, span: Span) -> tuple[FloorRef, ...]:
        refs = []
        for place in entry.scope.floors:
            word = re.sub(r"[ _-]+", "_", str(place).strip().lower())
            word = re.sub(r"_(floor|storey|story|level)s?$", "", word)
            if re.fullmatch(r"-?\d{1,3}", word):
                number = int(word)
                refs.append(
                    FloorRef("number", number, number, span) if number >= 1 else FloorRef("basement", span=span)
                )
            elif word in _FLOOR_WORDS:
                refs.append(replace(_FLOOR_WORDS[word], span=span))
            else:
                accepted = ", ".join(_FLOOR_WORDS)
                raise _UnusableError(f"scope.floors has numbers, 1 at the ground, or {accepted}")
        return tuple(refs)

    def _count(self, entry: StatementAnswer, most: int, *, least: int = 1) -> int:
        count = entry.value.count
        if count is None or not least <= count <= most:
            raise _UnusableError(f"value.count must be a number from {least} to {most}")
        return count

    def _some(self, entry: StatementAnswer, span: Span, name: str) -> int | None:
        """Return how many are meant; ``None`` for a plural without a number, which English quotes show themselves."""
        if entry.value.count is None:
            head = name.rpartition("_")[2]
            plural = any(token.plural and token.text == head for token in tokenize(span.words))
            return None if entry.value.several or plural else 1
        return self._count(entry, _MOST_ROOMS)

    # One method for each kind ---------------------------------------------------------------------------------------

    def _building_type(self, entry: StatementAnswer, span: Span) -> None:
        own, kind, known = self._named_building(entry)
        if known:
            self.facts.building.append((kind, span))
            self.facts.building_name = own if own != kind else ""
            return
        # The type is planned, and what the user calls the building is what the receipt tells of.
        self.facts.building.append((kind, Span("", 0, 0)))
        self.facts.building_name = own
        self.facts.building_span.append(span)

    def _floors(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.floors.append(Quantity(float(self._count(entry, 10_000)), span))

    def _basements(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.basements.append(Quantity(float(self._count(entry, 1_000)), span))

    def _area(self, entry: StatementAnswer) -> float:
        area = entry.value.area
        if area is None or not 0.5 <= area <= _MOST_AREA:
            raise _UnusableError("value.area must be a positive number of square metres")
        return float(area)

    def _total_area(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.area.append(Quantity(self._area(entry), span))

    def _floor_area(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.floor_area.append(Quantity(self._area(entry), span))

    def _outline(self, entry: StatementAnswer, span: Span) -> None:
        shape = _OUTLINES.get(re.sub(r"[ _-]?shaped?$", "", entry.value.name.strip().lower()))
        if shape is None:
            raise _UnusableError(f"value.name must be one of {', '.join(_OUTLINES.values())}")
        self.facts.shapes.append((shape, span))

    def _style(self, entry: StatementAnswer, span: Span) -> None:
        own = _snake(entry.value.name)
        mention = self._last_mention(own) if own else None
        style = own if own in self.knowledge.styles else mention.style if mention is not None else ""
        if not style:
            raise _UnusableError("value.name must be one of the styles of the list")
        self.facts.styles.append((style, span))

    def _use(self, entry: StatementAnswer, span: Span) -> None:
        floors = self._places(entry, span)
        if not floors:
            raise _UnusableError("scope.floors must say which floors are for it")
        self.facts.uses.append(UseFact(self._named_building(entry)[1], floors, span))

    def _copy(self, entry: StatementAnswer, span: Span) -> None:
        refs = self._places(entry, span)
        numbers = sorted(ref.first for ref in refs if ref.kind == "number")
        if len(refs) == 1 and not numbers:
            self.facts.copies.append(CopyFact(refs[0], span))
        elif len(numbers) == len(refs) > 1 and numbers == list(range(numbers[0], numbers[0] + len(numbers))):
            self.facts.copies.append(CopyFact(FloorRef("range", numbers[0], numbers[-1], span), span))
        else:
            raise _UnusableError("scope.floors must list consecutive floors, or be one word such as upper")

    def _vertical(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.vertical.append((f"no_{entry.kind}" if entry.value.unwanted else entry.kind, span))
        if entry.value.count is not None and not entry.value.unwanted:
            held = self.facts.stairs if entry.kind == "stair" else self.facts.lifts
            held.append(Quantity(float(self._count(entry, 100)), span))

    def _room(self, entry: StatementAnswer, span: Span) -> None:
        if entry.value.unwanted:
            self._no_room(entry, span)
            return
        room = self._named_room(entry.value.name, entry.value.type)
        fact = RoomFact(
            room_type=room.type,
            name=room.name,
            span=span,
            count=self._some(entry, span, room.name),
            area=None if entry.value.area is None else self._area(entry),
            floors=self._places(entry, span),
            each=entry.scope.each,
            label=room.label,
            known=room.known,
        )
        owner = self._scope_room(entry)
        if owner is not None and owner.name != fact.name:
            self.private.append((owner, fact))
        else:
            self.facts.rooms.append(fact)

    def attach_private_rooms(self) -> None:
        """Hang rooms that others have for themselves on these; those without an owner are rooms like any other."""
        for owner, fact in self.private:
            rooms = self.facts.rooms
            at = next((n for n, r in enumerate(rooms) if r.name == owner.name), None)
            if at is None:
                at = next((n for n, r in enumerate(rooms) if r.room_type == owner.type), None)
            if at is None:
                rooms.append(replace(fact, each=fact.each and bool(fact.floors)))
            else:
                rooms[at] = replace(rooms[at], suite=(*rooms[at].suite, _of_each(fact, rooms[at])))

    def _no_room(self, entry: StatementAnswer, span: Span) -> None:
        name = _snake(entry.value.name) or _snake(entry.value.type)
        kind = name if name == "basement" else self._named_room(entry.value.name, entry.value.type).type
        floors = self._places(entry, span)
        self.facts.excluded_on += [(kind, ref, span) for ref in floors]
        if not floors:
            self.facts.excluded.append((kind, span))

    def _relation(self, entry: StatementAnswer, span: Span) -> None:
        value = entry.value
        first, second = self._named_room(value.name, value.type), self._named_room(value.other, value.other_type)
        held = self.facts.apart if entry.kind == "apart" else self.facts.adjacent
        held.append(AdjacencyFact(first.type, second.type, span, first.name, second.name))

    def _object(self, entry: StatementAnswer, span: Span) -> None:
        words = _snake(entry.value.name) or _snake(entry.value.type)
        if not words:
            raise _UnusableError("value.name must name the furniture in English snake case")
        stated = tuple(_snake(entry.value.type).split("_"))
        category, size = furniture_of(stated)
        if not category or size != len(stated):
            category = furniture_of(tuple(words.split("_")))[0]
        room = self._scope_room(entry)
        self.facts.objects.append(
            ObjectFact(
                words=words.replace("_", " "),
                category=category,
                span=span,
                count=self._some(entry, span, words),
                room=room.name if room else "",
                room_type=room.type if room else "",
                each=entry.scope.each,
                excluded=entry.kind == "no_object" or entry.value.unwanted,
                floors=self._places(entry, span),
            )
        )

    def _scope_room(self, entry: StatementAnswer) -> _Named | None:
        """Return the room that a statement is about; ``None`` for none, or for the building itself."""
        own = _snake(entry.scope.room)
        return self._named_room(own, "") if own and own not in self.whole else None

    def _room_type(self, entry: StatementAnswer) -> str:
        room = self._scope_room(entry)
        return room.type if room is not None else ""

    def _height(self, entry: StatementAnswer, span: Span) -> None:
        height = entry.value.height
        if height is None or not _HEIGHTS[0] <= height <= _HEIGHTS[1]:
            raise _UnusableError(f"value.height must be {_HEIGHTS[0]:g} to {_HEIGHTS[1]:g} metres")
        self.facts.heights.append(HeightFact(float(height), self._room_type(entry), span))

    def _material(self, entry: StatementAnswer, span: Span) -> None:
        surface, material = entry.value.type.strip().lower(), clean_text(entry.value.name, 60).lower().replace("_", " ")
        if surface not in ("floor", "wall") or not re.fullmatch(r"[a-z][a-z ,'-]{2,59}", material):
            raise _UnusableError("value.type must be floor or wall, and value.name a material in plain English words")
        kind = self._room_type(entry)
        self.facts.materials.append(MaterialFact("floor" if surface == "floor" else "wall", material, kind, span))

    def _facade(self, entry: StatementAnswer, span: Span) -> None:
        known = outside_words()
        material = _meant(entry.value.name, {**known.colours, **known.substances})
        if material is None:
            raise _UnusableError(
                "value.name must be a material of outer walls such as brick, stone, timber or white render"
            )
        self.facts.outside.append(OutsideFact("facade", material, span))

    def _roof(self, entry: StatementAnswer, span: Span) -> None:
        known = outside_words()
        form, covering = _meant(entry.value.name, known.roofs), _meant(entry.value.type, known.coverings)
        said = [text for text in (entry.value.name, entry.value.type) if text.strip()]
        if len(said) != (form is not None) + (covering is not None) or not said:
            raise _UnusableError(
                "value.name must be flat, gable or hip, or value.type slate, tile, metal, thatch or grass"
            )
        self.facts.outside.append(OutsideFact("roof", form or "", span, covering=covering or ""))

    def _grounds(self, entry: StatementAnswer, span: Span) -> None:
        known = outside_words()
        use = _meant(entry.value.name, {**known.outdoor, **known.grounds})
        if use is None:
            raise _UnusableError("value.name must be garden, pool, parking, playground, hedge or fence")
        count = 0 if entry.value.count is None else self._count(entry, _MOST_PLACES)
        self.facts.outside.append(OutsideFact("grounds", "", span, count=count, use=use))

    def _clutter(self, entry: StatementAnswer, span: Span) -> None:
        amount = entry.value.name.strip().lower()
        if amount not in ("dense", "sparse"):
            raise _UnusableError("value.name must be dense or sparse")
        self.facts.clutter.append(ClutterFact("dense" if amount == "dense" else "sparse", self._room_type(entry), span))

    def _occupants(self, entry: StatementAnswer, span: Span) -> None:
        count = self._count(entry, _MOST_PEOPLE)
        self.facts.occupants.append(OccupantFact(count, _snake(entry.value.name) or "people", span))

    def _only(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.only.append(span)

    def _unread(self, entry: StatementAnswer, span: Span) -> None:
        self.facts.unread.append(span)


def _of_each(fact: RoomFact, owner: RoomFact) -> RoomFact:
    """Return a private room with its number for each owner, where the model counts all of them: three bathrooms."""
    owners, count = owner.count or 1, fact.count or 1
    whole = owners > 1 and (count == owners or (not fact.each and count % owners == 0))
    return replace(fact, count=count // owners if whole else count, each=False, floors=())


def _building_names(answer: ReadingAnswer) -> frozenset[str]:
    """Return the names of the building itself, which a weak model takes for that of a room."""
    building = {
        _snake(name)
        for entry in answer.statements
        if entry.kind == "building_type"
        for name in (entry.value.name, entry.value.type)
    }
    rooms = {_snake(entry.value.name) for entry in answer.statements if entry.kind == "room"}
    return frozenset((building | {"building"}) - rooms)


def _snake(text: str) -> str:
    """Return a name in snake case and the singular; empty where there is no Latin letter in it.

    Examples
    --------
    >>> _snake("Children's Rooms"), _snake("café"), _snake("寝室")
    ('childrens_room', 'cafe', '')
    """
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    words = re.findall(r"[a-z0-9]+", plain.replace("'", ""))
    if not any(word.isalpha() for word in words):
        return ""
    words[-1] = singular(words[-1])
    name = "_".join(words)[:48].strip("_")
    return name if name[:1].isalpha() else f"room_{name}"
