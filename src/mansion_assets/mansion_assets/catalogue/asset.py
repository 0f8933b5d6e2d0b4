"""An asset of the catalogue with its surfaces and inner volumes."""

from typing import Annotated, Any, Literal, TypeAlias

import msgspec

from mansion_assets.catalogue.palette import material
from mansion_msgs_py.scene import Mount
from mansion_msgs_py.shapes import Size3

__all__ = ["Asset", "JointRecord", "Surface", "Volume"]

Point: TypeAlias = tuple[float, float, float]


class Surface(msgspec.Struct, frozen=True, kw_only=True):
    """A flat rectangle that carries objects, in the asset's frame (origin at the bounding-box centre).

    Attributes
    ----------
    kind : str
        ``top``, ``shelf``, ``seat``, ``mattress``, ...
    x, y, z : float
        Centre of the rectangle; `z` is its height. Metres.
    w, d : float
        Extent along x and y.
    clearance : float
        Free height above it.
    round : bool
        Whether only the inscribed ellipse carries.
    """

    kind: str
    x: float
    y: float
    z: float
    w: float
    d: float
    clearance: float = 1.0
    round: bool = False


class Volume(msgspec.Struct, frozen=True, kw_only=True):
    """An inner box that holds objects; they rest on its floor.

    Attributes
    ----------
    x, y, z : float
        Its centre in the asset's frame.
    w, d, h : float
        Its inner extent.
    """

    kind: str
    x: float
    y: float
    z: float
    w: float
    d: float
    h: float


class JointRecord(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How a part of an asset moves, as `mansion_assets.joints.Joint` has it: in the asset's frame, 0 is closed."""

    part: Annotated[str, msgspec.Meta(pattern=r"^[a-z][a-z0-9_]*$", max_length=80)]
    kind: Literal["hinge", "slide"]
    axis: Point
    origin: Point
    travel: Annotated[float, msgspec.Meta(gt=0)]


class Asset(msgspec.Struct, frozen=True, kw_only=True):
    """An object that a building can be furnished with.

    Attributes
    ----------
    key : str
        Unique in the catalogue; the ``assetId`` of an AI2-THOR asset.
    size : (w, d, h)
        Bounding box: width along the front, depth, height; the front faces +y.
    asset_id, thor_type : str
        AI2-THOR's ``assetId`` and ``objectType``; ``None`` and empty for other assets.
    surfaces, volumes : tuples
        Receptacles: what carries and what holds other objects.
    recipe, parameters
        The mesh recipe of `mansion_assets`; empty when `glb` names a file.
    materials : dict
        Material, ``family_colour``, of each role of the recipe (``main``, ``frame``, ...).
    rooms : tuple of str
        Room types whose programs use the category.
    joints : tuple of JointRecord
        Joints of the parts of a GLB file; a recipe makes its own.
    pieces : str, optional
        File of the convex pieces of a GLB.
    mass : float, optional
        Kilograms, where it is known.
    source, author, licence : str
        Where a user's asset is from.
    record : str
        File of a user's asset; empty for the package's.
    """

    key: str
    category: str
    name: str
    size: Size3
    synonyms: tuple[str, ...] = ()
    asset_id: str | None = None
    thor_type: str = ""
    mount: Mount = "floor"
    pickupable: bool = False
    receptacle: bool = False
    openable: bool = False
    toggleable: bool = False
    surfaces: tuple[Surface, ...] = ()
    volumes: tuple[Volume, ...] = ()
    rooms: tuple[str, ...] = ()
    materials: dict[str, str] = {}
    recipe: str = ""
    parameters: dict[str, Any] = {}
    glb: str | None = None
    tags: tuple[str, ...] = ()
    joints: tuple[JointRecord, ...] = ()
    pieces: str | None = None
    mass: float | None = None
    source: str = ""
    author: str = ""
    licence: str = ""
    sha256: str = ""
    record: str = ""

    @property
    def footprint(self) -> float:
        """Area of the bounding box on the floor, square metres."""
        return self.size[0] * self.size[1]

    @property
    def material(self) -> str:
        """Name of the main material, empty when the mesh brings its own."""
        return self.materials.get("main", "")

    @property
    def color(self) -> str:
        """Colour of the main material, ``#rrggbb``."""
        return material(self.material).color
