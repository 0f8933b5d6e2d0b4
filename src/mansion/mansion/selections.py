"""Selections of a building's parts: iterate over them, filter them, find them by words, take one by its id."""

import dataclasses
import html
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import Any, ClassVar, Final, Generic, Self, TypeVar, overload

import msgspec

from mansion.parts import Floor, Object, Room
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.wishes import Wish
from mansion_msgs_py.wording import choices, counted

__all__ = ["Floors", "Objects", "Rooms", "Selection", "Wishes"]

T = TypeVar("T")

_SHOWN = 8
"""Ids that a `repr` shows."""

_ROWS = 60
"""Rows that a notebook shows."""


class Selection(Collection[T], Generic[T]):
    """Parts of one kind, in the building's order; what selects from it gives another one.

    Parameters
    ----------
    parts : iterable

    Examples
    --------
    >>> b.rooms["kitchen"].id
    'F1/kitchen'
    >>> [room.id for room in b.rooms.filter(type="kitchen")]
    ['F1/kitchen']
    >>> "F1/kitchen" in b.rooms, len(b.rooms.filter(lambda room: room.area > 1000))
    (True, 0)
    """

    noun: ClassVar[str] = "part"
    plural: ClassVar[str] = ""
    columns: ClassVar[tuple[str, ...]] = ("id",)

    def __init__(self, parts: Iterable[T]) -> None:
        self._parts = tuple(parts)

    @staticmethod
    def key(part: T) -> Any:
        """Return what a part is picked by."""
        return part.id  # type: ignore[attr-defined]

    @staticmethod
    def called(part: T) -> tuple[str, ...]:
        """Return the names that mean a part beside its id."""
        return ()

    @property
    def ids(self) -> tuple[Any, ...]:
        """Keys of the parts, in their order."""
        return tuple(self.key(part) for part in self._parts)

    def __iter__(self) -> Iterator[T]:
        return iter(self._parts)

    def __len__(self) -> int:
        return len(self._parts)

    def __contains__(self, part: object) -> bool:
        return part in self._parts or part in self.ids

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and other._parts == self._parts

    def __hash__(self) -> int:
        return hash(self._parts)

    @overload
    def __getitem__(self, which: int | str) -> T: ...
    @overload
    def __getitem__(self, which: slice) -> Self: ...
    def __getitem__(self, which: int | str | slice) -> T | Self:
        """Return a part by id, by the end of its id or by its name where one alone has it; or by position."""
        if isinstance(which, slice):
            return type(self)(self._parts[which])
        return self._named(which) if isinstance(which, str) else self._parts[which]

    def get(self, which: Any, default: T | None = None) -> T | None:
        """Return a part as by index, `default` where there is none."""
        try:
            found: T = self[which]
        except (MansionError, IndexError):
            return default
        return found

    def _named(self, name: str) -> T:
        wanted = name.strip().casefold()
        keys = [str(self.key(part)).casefold() for part in self._parts]
        fits = (
            [part for part, key in zip(self._parts, keys) if key == wanted],
            [part for part, key in zip(self._parts, keys) if key.endswith(f"/{wanted}")],
            [part for part in self._parts if wanted in map(str.casefold, self.called(part))],
        )
        found = next(filter(None, fits), [])
        if len(found) == 1:
            return found[0]
        if found:
            ids = [str(self.key(part)) for part in found]
            some = f"{', '.join(ids[:_SHOWN])}{', ...' if len(ids) > _SHOWN else ''}"
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{name!r} names {self._counted(len(found))}; give an id: {some}",
                details={"candidates": ids},
            )
        raise self._missing(name)

    def _missing(self, wanted: object) -> MansionError:
        near = choices(wanted, map(str, self.ids), self.plural or f"{self.noun}s")
        return MansionError(ErrorCode.NOT_FOUND, f"there is no {self.noun} {wanted!r}; {near}")

    def _counted(self, number: int) -> str:
        return counted(number, self.noun, self.plural)

    def filter(self, test: Callable[[T], bool] | None = None, /, **fields: Any) -> Self:
        """Return the parts that pass a test and whose fields have these values.

        Raises
        ------
        MansionError
            ``INVALID_PAYLOAD`` for a field that the parts do not have.
        """
        for name in fields:
            if self._parts and not hasattr(self._parts[0], name):
                raise MansionError(
                    ErrorCode.INVALID_PAYLOAD,
                    f"a {self.noun} has no field {name!r}; {choices(name, _fields(self._parts[0]), 'fields')}",
                )
        return type(self)(
            part
            for part in self._parts
            if (test is None or test(part)) and all(getattr(part, name) == value for name, value in fields.items())
        )

    def records(self) -> list[dict[str, Any]]:
        """Return a dictionary of plain values for each part: what a table or a data frame is made from.

        Examples
        --------
        >>> b.rooms.records()[0]["type"]
        'living_room'
        """
        return [{name: getattr(part, name) for name in self.columns} for part in self._parts]

    def __repr__(self) -> str:
        shown = ", ".join(map(str, self.ids[:_SHOWN]))
        more = ", ..." if len(self) > _SHOWN else ""
        return f"<{self._counted(len(self))}{': ' if shown else ''}{shown}{more}>"

    def _repr_html_(self) -> str:
        records = self[:_ROWS].records()
        names = records[0] if records else self.columns
        head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
        rows = [
            "<tr>" + "".join(f"<td>{html.escape(_shown(value))}</td>" for value in record.values()) + "</tr>"
            for record in records
        ]
        more = f"<p>and {len(self) - _ROWS} more</p>" if len(self) > _ROWS else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>{more}"


def _fields(part: Any) -> list[str]:
    if dataclasses.is_dataclass(part):
        return [entry.name for entry in dataclasses.fields(part)]
    return [entry.name for entry in msgspec.structs.fields(part)]


def _shown(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.2f}"
    if isinstance(value, (tuple, list)):
        return ", ".join(map(_shown, value))
    return "" if value is None else str(value)


class Objects(Selection[Object]):
    """Objects, which `find` finds by words."""

    noun = "object"
    columns = (
        "id", "name", "category", "floor", "room", "position", "size", "rotation", "color", "material", "parent"
    )  # fmt: skip

    @staticmethod
    def called(part: Object) -> tuple[str, ...]:
        """Return what people call an object."""
        return (part.name, part.category.replace("_", " "))

    def find(self, words: str) -> "Objects":
        """Return the objects that words name or describe, the best fits first; none where nothing fits.

        Parameters
        ----------
        words : str
            A name ("red mug"), or what it is for ("something to sit on").

        Examples
        --------
        >>> "chair" in {item.category for item in b.objects.find("something to sit on")}
        True
        >>> b.objects.find("grand piano")
        <0 objects>
        """
        return Objects(_objects_fitting(self._parts, words))


class Rooms(Selection[Room]):
    """Rooms, stairs and lifts left out; `find` finds them by words."""

    noun = "room"
    columns = ("id", "name", "type", "floor", "area", "floor_material", "wall_material")

    @staticmethod
    def called(part: Room) -> tuple[str, ...]:
        """Return what people call a room."""
        return (part.name, *part.aliases)

    @property
    def objects(self) -> Objects:
        """All that is in these rooms."""
        return Objects(item for room in self for item in room.objects)

    def find(self, words: str) -> "Rooms":
        """Return the rooms that words name: "the bedrooms", "the largest office on the second floor".

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for words of a floor that is not there.

        Examples
        --------
        >>> b.rooms.find("the bathroom").ids
        ('F1/bathroom',)
        """
        return Rooms(_rooms_fitting(self._parts, words))


class Floors(Selection[Floor]):
    """Floors from below; an index is the number of a floor, which starts at 1 on the ground.

    Examples
    --------
    >>> b.floors[1].label
    '1'
    """

    noun = "floor"
    columns = ("number", "label", "elevation", "height", "area", "cores")

    @classmethod
    def of(cls, scenes: Iterable[FloorScene]) -> "Floors":
        """Return the floors of scenes."""
        return cls(_floor(scene) for scene in scenes)

    @staticmethod
    def key(part: Floor) -> int:
        """Return the number of a floor."""
        return part.number

    @staticmethod
    def called(part: Floor) -> tuple[str, ...]:
        """Return what a lift's button says."""
        return (part.label,)

    @overload
    def __getitem__(self, which: int | str) -> Floor: ...
    @overload
    def __getitem__(self, which: slice) -> Self: ...
    def __getitem__(self, which: int | str | slice) -> Floor | Self:
        """Return the floor of a number, or of a label."""
        if isinstance(which, int):
            found = next((floor for floor in self if floor.number == which), None)
            if found is None:
                raise self._missing(which)
            return found
        return super().__getitem__(which)

    @property
    def rooms(self) -> Rooms:
        """All rooms of these floors."""
        return Rooms(room for floor in self for room in floor.rooms)

    @property
    def objects(self) -> Objects:
        """All objects of these floors."""
        return Objects(item for floor in self for item in floor.objects)


def _floor(scene: FloorScene) -> Floor:
    objects = Objects(Object.of(item, scene.floor) for item in scene.objects)
    inside: dict[str, list[Object]] = {}
    for item in objects:
        inside.setdefault(item.room, []).append(item)
    rooms = [room for room in scene.rooms if room.kind not in ("stair", "elevator")]
    return Floor(
        number=scene.floor,
        label=scene.label,
        elevation=scene.elevation,
        height=scene.height,
        area=sum(room.area for room in scene.rooms),
        outline=tuple(scene.outline),
        cores=tuple(core.id for core in scene.cores),
        rooms=Rooms(Room.of(room, scene, Objects(inside.get(room.id, []))) for room in rooms),
        objects=objects,
        scene=scene,
    )


class Wishes(Selection[Wish]):
    """What a brief asks for, and what became of it: the receipt.

    Examples
    --------
    >>> b.wishes.filter(status="met")[0].text
    'small flat'
    >>> "2 met" in b.wishes.summary
    True
    """

    noun = "wish"
    plural = "wishes"
    columns = ("id", "text", "kind", "status", "reason")

    def records(self) -> list[dict[str, Any]]:
        """Return a dictionary for each wish, with what it was read as beside its words."""
        with importing:
            from mansion_bringup.building.wish_words import read_as

        made = zip(super().records(), self)
        return [{"id": row.pop("id"), "text": row.pop("text"), "read_as": read_as(wish), **row} for row, wish in made]

    @property
    def summary(self) -> str:
        """How many wishes there are of each status, in one line."""
        with importing:
            from mansion_bringup.building.wish_words import receipt_summary

        return receipt_summary(self._parts)

    def __repr__(self) -> str:
        return f"<{self.summary}>"


_NEAR: Final = 0.6
"""Share of the best score of the whole catalogue from which a kind of object is what the words describe."""

_PART: Final = 1
"""The rank of what has the words as another part of its name, ``Vocabulary.rank``."""


def _objects_fitting(objects: Sequence[Object], words: str) -> list[Object]:
    """Return the objects that words name or describe, the best fits first."""
    with importing:
        from mansion_assets.catalogue import load_catalogue
        from mansion_assets.catalogue.search import word_scores
        from mansion_assets.catalogue.vocabulary import vocabulary_of

    catalogue = load_catalogue()
    vocabulary = vocabulary_of(catalogue)
    of_colour = [item for item in objects if _has_colours(item, words)]
    ranks = {item.id: vocabulary.rank(item.record, words) for item in of_colour}
    least = _PART + 1 if any(rank > _PART for rank in ranks.values()) else _PART
    scores = word_scores(catalogue, words)
    bound = max(_NEAR * max(scores.values(), default=0.0), 1e-9)
    fits = [item for item in of_colour if ranks[item.id] >= least or scores.get(item.category, 0.0) >= bound]
    return sorted(fits, key=lambda item: (-ranks[item.id], -scores.get(item.category, 0.0)))


def _has_colours(item: Object, words: str) -> bool:
    """Whether an object is of the colour that stands beside other words; a colour alone may be a thing (an orange)."""
    with importing:
        from mansion_assets.catalogue import load_catalogue
        from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
        from mansion_language.colours import COLOUR_WORDS, colour_of

    asked = stems(words)
    colours = {COLOUR_WORDS[word] for word in asked if word in COLOUR_WORDS}
    if not colours or all(word in COLOUR_WORDS for word in asked):
        return True
    if vocabulary_of(load_catalogue()).exact(asked):
        return True
    return colours == {colour_of(item.material)}


def _rooms_fitting(rooms: Sequence[Room], words: str) -> list[Room]:
    """Return all rooms that words name, in the building's order."""
    with importing:
        from mansion_assets.catalogue import load_catalogue
        from mansion_editing.state import SceneState
        from mansion_editing.tools.perception import find_rooms

    scenes = list({room.floor: room.scene for room in rooms}.values())
    if not scenes:
        return []
    found = {room.id for _, room in find_rooms(SceneState(scenes, load_catalogue()), words, every=True)}
    return [room for room in rooms if room.id in found]
