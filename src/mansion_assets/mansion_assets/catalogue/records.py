"""The JSON records of catalogue files, for the package's data and user folders alike."""

from typing import Annotated, Any, Literal, TypeAlias

import msgspec

from mansion_assets.catalogue.asset import JointRecord, Surface, Volume
from mansion_msgs_py.placement import GlobalConstraint, Relation
from mansion_msgs_py.scene import Mount
from mansion_msgs_py.shapes import Size3

__all__ = [
    "Arrangement",
    "AssetRecord",
    "CategoryRecord",
    "Count",
    "Extent",
    "HangItem",
    "Item",
    "JointRecord",
    "MatrixShape",
    "RoomRecord",
    "RugItem",
    "Scatter",
    "Slot",
]

Probability: TypeAlias = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Snake: TypeAlias = Annotated[str, msgspec.Meta(pattern=r"^[a-z][a-z0-9_]*$", max_length=80)]


class CategoryRecord(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A kind of object and its variants.

    Attributes
    ----------
    sizes, finishes : lists
        Sizes (w, d, h) and main materials; variant ``i`` takes entry ``i`` of each, cyclically.
    thor : str
        AI2-THOR object type whose assets belong to this category.
    thor_match : str
        Text that the asset ids must contain.
    materials : dict
        Materials of the other roles of the recipe.
    """

    category: Snake
    recipe: Snake
    name: str = ""
    synonyms: list[str] = []
    sizes: list[Size3] = []
    finishes: list[str] = []
    materials: dict[str, str] = {}
    parameters: dict[str, Any] = {}
    mount: Mount = "floor"
    pickupable: bool = False
    openable: bool = False
    toggleable: bool = False
    thor: str = ""
    thor_match: str = ""
    tags: list[str] = []


class AssetRecord(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A user's asset: a GLB file (glTF axes: y up, front +z) or a recipe, and its facts.

    Attributes
    ----------
    glb : str, optional
        Path relative to the record; the mesh is scaled to `size`.
    rooms : list of str
        Room types that get the asset, with `count` copies at `global_`.
    joints : list of JointRecord
        Parts that move: nodes of the GLB that are called ``PART`` or ``PART/...``.
    pieces : str, optional
        Path of the convex pieces that collide (`mansion_assets.library.convex_decomposition`), relative to the record.
    mass : float, optional
        Kilograms; by its size where it is left out.
    source, author, licence : str
        Where it is from, who made it, and under what licence.
    sha256 : str
        Hash of the GLB and the pieces.
    stated, guessed : list of str
        Which facts its files say, and which were derived when it was added.
    """

    key: Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9_.\-]+$", max_length=80)]
    category: Snake
    size: Size3
    name: str = ""
    synonyms: list[str] = []
    glb: str | None = None
    recipe: str = ""
    parameters: dict[str, Any] = {}
    materials: dict[str, str] = {}
    mount: Mount = "floor"
    pickupable: bool = False
    openable: bool = False
    toggleable: bool = False
    surfaces: list[Surface] = []
    volumes: list[Volume] = []
    rooms: list[str] = []
    asset_id: str | None = None
    tags: list[str] = []
    joints: list[JointRecord] = []
    pieces: str | None = None
    mass: Annotated[float, msgspec.Meta(gt=0)] | None = None
    description: str = ""
    source: str = ""
    author: str = ""
    licence: str = ""
    sha256: str = ""
    stated: list[str] = []
    guessed: list[str] = []


class Count(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A number of copies: one per `per` square metres within [`min`, `max`], or `times` for each copy of `each`."""

    per: Annotated[float, msgspec.Meta(gt=0)] | None = None
    min: Annotated[int, msgspec.Meta(ge=0)] = 0
    max: Annotated[int, msgspec.Meta(ge=1)] = 1
    each: str = ""
    times: float = 1.0


class MatrixShape(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Shape of a matrix: greatest numbers of rows and columns, and free space between copies, metres.

    Attributes
    ----------
    exact : bool
        There are as many rows and columns as that, unless the placer finds no room for them.
    lengthwise : bool
        The rows follow each other along the longer side of the room.
    """

    max_rows: int = 12
    max_cols: int = 12
    gap: tuple[float, float] = (0.9, 0.9)
    exact: bool = False
    lengthwise: bool = False


class Extent(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Bounds of width, depth and height of the assets of a category that an item accepts, metres."""

    min: tuple[float, float, float] = (0.0, 0.0, 0.0)
    max: tuple[float, float, float] = (99.0, 99.0, 99.0)


class Item(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A floor object of a room program.

    Attributes
    ----------
    category : str or list of str
        One of these, drawn by seed.
    p : float
        Probability that the room has it at all.
    min_area, max_area : float
        Bounds of the room's area, square metres.
    matrix, paired
        Structural constraint; without either each copy stands on its own.
    unless : str or list of str
        Room types that have it instead of this room where the floor has one.
    """

    name: Snake
    category: str | list[str]
    count: int | Count = 1
    global_: GlobalConstraint = msgspec.field(name="global", default="unconstrained")
    matrix: MatrixShape | None = None
    paired: str = ""
    relative: list[Relation] = []
    p: Probability = 1.0
    min_area: float = 0.0
    max_area: float = 1e9
    extent: Extent | None = None
    unless: str | list[str] = ""


class HangItem(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A wall or ceiling object.

    Attributes
    ----------
    height : float, optional
        Height of the object's centre above the floor, for wall objects, metres.
    above : str
        Name or category of the floor object over which it hangs.
    place : str
        Wall: ``free``, ``door`` (beside it), ``facing_door``, ``facing_seats``, ``above``. Ceiling: ``grid``,
        ``center``, ``spread``, ``door``, ``above``.
    spacing : float
        Spacing of a ceiling grid, metres.
    """

    category: str | list[str]
    count: int | Count = 1
    p: Probability = 1.0
    height: float | None = None
    above: str = ""
    place: Literal["free", "door", "facing_door", "facing_seats", "above", "grid", "center", "spread"] = "free"
    spacing: float = 3.0
    min_area: float = 0.0


class RugItem(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A rug below a floor object; `margin` metres beyond it; an empty `under` puts it in the middle."""

    category: str | list[str] = "rug"
    under: str = ""
    margin: float = 0.4
    p: Probability = 1.0
    count: int = 1


class Slot(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A small object with a place of its own: (u, v) in [0, 1] from the surface's left back corner.

    Attributes
    ----------
    turn : float
        Degrees added to the receptacle's heading.
    """

    category: str | list[str]
    u: float = 0.5
    v: float = 0.5
    turn: float = 0.0
    p: Probability = 1.0
    jitter: float = 0.02


class Scatter(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Small objects without a place of their own: between `min` and `max` of them, on or in the receptacle."""

    category: str | list[str]
    min: int = 0
    max: int = 1
    p: Probability = 1.0
    inside: bool = False
    line: bool = False


class Arrangement(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The small objects on or in a receptacle.

    Attributes
    ----------
    on : list of str
        Receptacle categories.
    rooms : list of str
        Room types; empty for any.
    seats : list of Slot
        Laid before each chair at the receptacle: u to the right of the sitter, v from the edge inwards, metres.
    """

    name: Snake
    on: list[str]
    rooms: list[str] = []
    slots: list[Slot] = []
    seats: list[Slot] = []
    scatter: list[Scatter] = []
    p: Probability = 1.0


class RoomRecord(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The object program of a room type.

    Attributes
    ----------
    like : str
        Room type whose lists are used for those that this record leaves out.
    cover : float
        Greatest share of the room's area under floor objects.
    """

    room_type: Snake
    synonyms: list[str] = []
    like: str = ""
    cover: Annotated[float, msgspec.Meta(gt=0, le=0.6)] = 0.34
    floor: list[Item] | None = None
    wall: list[HangItem] | None = None
    ceiling: list[HangItem] | None = None
    rugs: list[RugItem] | None = None
    arrangements: list[str] = []
    tags: list[str] = []
