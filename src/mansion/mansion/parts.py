"""Floors, rooms and objects of a building, as values that do not change: an edit makes new ones."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

from mansion.pictures import FloorPlan
from mansion_msgs_py.scene import FloorScene, Mount, SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point, Point3, Size3

if TYPE_CHECKING:
    from mansion.selections import Objects, Rooms

__all__ = ["Floor", "Object", "Polygon", "Room"]

Polygon: TypeAlias = tuple[Point, ...]
"""Corners of a closed ring, metres in the floor's frame."""


@dataclass(frozen=True)
class Object:
    """An object that stands, hangs or lies in a room.

    Attributes
    ----------
    id : str
        ``F1/kitchen/mug_1``; what edits, robots and exports call it.
    category : str
        Kind of object in the catalogue, ``coffee_table``.
    name : str
        What people call it.
    floor : int
    room : str
        Id of its room.
    position : (x, y, z)
        Centre of its bounding box in the floor's frame, metres; z above the finished floor.
    rotation : float
        Degrees counter-clockwise about z; at 0 the front faces +y.
    size : (width, depth, height)
        Before rotation, metres.
    color, material : str
        ``#rrggbb`` and the catalogue's material, as far as they are known.
    asset : str
        Key in the asset catalogue.
    mount, parent : str
        What carries it: ``floor``, ``wall``, ``ceiling``, or ``surface`` and ``inside`` of the object `parent`.
    pickupable, receptacle, openable, toggleable : bool
        What a robot can do with it.
    record : SceneObject
        The payload in ``scene.json``.
    """

    id: str
    category: str
    name: str
    floor: int
    room: str
    position: Point3
    rotation: float
    size: Size3
    color: str = field(repr=False)
    material: str = field(repr=False)
    asset: str = field(repr=False)
    mount: Mount = field(repr=False)
    parent: str | None = field(repr=False)
    pickupable: bool = field(repr=False)
    receptacle: bool = field(repr=False)
    openable: bool = field(repr=False)
    toggleable: bool = field(repr=False)
    record: SceneObject = field(repr=False, compare=False)

    @classmethod
    def of(cls, record: SceneObject, floor: int) -> "Object":
        """Return the object that a scene records."""
        return cls(
            id=record.id,
            category=record.category,
            name=record.name,
            floor=floor,
            room=record.room,
            position=record.position,
            rotation=record.rotation,
            size=record.size,
            color=record.color,
            material=record.material,
            asset=record.asset,
            mount=record.mount,
            parent=record.parent,
            pickupable=record.pickupable,
            receptacle=record.receptacle,
            openable=record.openable,
            toggleable=record.toggleable,
            record=record,
        )

    @property
    def states(self) -> dict[str, bool | float | str]:
        """``open``, ``on``, ``temperature``, ... where they apply; a copy."""
        return dict(self.record.states)


@dataclass(frozen=True)
class Room:
    """A room of a floor.

    Attributes
    ----------
    id : str
        ``F1/kitchen``.
    type : str
        Room type of the knowledge base, ``bedroom``.
    name : str
        What people call it; the words of the brief where it names the room.
    floor : int
    area : float
        Square metres.
    polygon : tuple of (x, y)
        On the centre lines of inner walls, on the inner face of outer ones; metres.
    ceiling_height : float
        Metres.
    floor_material, wall_material : str
    aliases : tuple of str
        Other names that mean it.
    objects : Objects
        What is in it.
    scene : FloorScene
        The payload of its floor.
    """

    id: str
    type: str
    name: str
    floor: int
    area: float
    polygon: Polygon = field(repr=False)
    ceiling_height: float = field(repr=False)
    floor_material: str = field(repr=False)
    wall_material: str = field(repr=False)
    aliases: tuple[str, ...] = field(repr=False)
    objects: "Objects" = field(repr=False, compare=False)
    scene: FloorScene = field(repr=False, compare=False)

    @classmethod
    def of(cls, record: SceneRoom, scene: FloorScene, objects: "Objects") -> "Room":
        """Return the room that a scene records."""
        return cls(
            id=record.id,
            type=record.room_type,
            name=record.name or record.id.rpartition("/")[2].replace("_", " "),
            floor=scene.floor,
            area=record.area,
            polygon=tuple(record.polygon),
            ceiling_height=record.ceiling_height,
            floor_material=record.floor_material,
            wall_material=record.wall_material,
            aliases=tuple(record.aliases),
            objects=objects,
            scene=scene,
        )


@dataclass(frozen=True)
class Floor:
    """A storey.

    Attributes
    ----------
    number : int
        1 at the ground, 0 and below for basements.
    label : str
        What a lift's button says.
    elevation, height : float
        Height of the finished floor above the ground, and height from floor to floor; metres.
    area : float
        Total area of the rooms, square metres.
    outline : tuple of (x, y)
        Inner face of the outer wall; metres.
    cores : tuple of str
        Ids of its stairs and lifts.
    rooms : Rooms
    objects : Objects
    scene : FloorScene
        The payload, ``scene.json``: walls, doors, windows and lights too.
    """

    number: int
    label: str
    elevation: float
    height: float
    area: float
    outline: Polygon = field(repr=False)
    cores: tuple[str, ...]
    rooms: "Rooms" = field(repr=False, compare=False)
    objects: "Objects" = field(repr=False, compare=False)
    scene: FloorScene = field(repr=False, compare=False)

    @property
    def plan(self) -> FloorPlan:
        """The floor plan, which a notebook shows."""
        return FloorPlan(self.scene)

    def _repr_svg_(self) -> str:
        return self.plan.svg
