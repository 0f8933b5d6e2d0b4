"""Arguments and replies of the tools that look at a building: paths, assets, objects, surfaces and contents."""

from typing import Annotated

import msgspec

from mansion_msgs_py.editing.open_buildings import Text, ToolArgs
from mansion_msgs_py.shapes import Point3

__all__ = [
    "AssetHits",
    "AssetInfo",
    "CheckPathArgs",
    "CheckSurfaceArgs",
    "ListObjectsArgs",
    "ObjectInfo",
    "ObjectList",
    "PathReport",
    "PathStep",
    "ReceptacleContents",
    "ReceptacleReport",
    "SearchAssetsArgs",
    "SearchContentsArgs",
]


class CheckPathArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Both ends may be left out: from the entrance, to every room. A room, core or object, by id or words."""

    start: Text = ""
    end: Text = ""


class SearchAssetsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Words for a new object, how many hits, and properties that each must have (``Pickable``, ``Receptacle``, ...)."""

    query: Text
    top_k: Annotated[int, msgspec.Meta(ge=1, le=50)] = 5
    properties: Annotated[list[Text], msgspec.Meta(max_length=8)] = msgspec.field(default_factory=list)


class ListObjectsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Filters: a room (id or words, with a floor where it matters), a keyword or an id."""

    room: Text = ""
    keyword: Text = ""
    id: Text = ""
    limit: Annotated[int, msgspec.Meta(ge=1, le=500)] = 100


class CheckSurfaceArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """The receptacle, by keyword or by id."""

    keyword: Text = ""
    id: Text = ""


class SearchContentsArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """The container, by keyword or by id."""

    keyword: Text = ""
    id: Text = ""


class PathStep(msgspec.Struct, frozen=True, kw_only=True):
    """A place on the way and the door into it; a stair or a lift comes once for each floor."""

    place: str
    floor: int
    door: str = ""


class PathReport(msgspec.Struct, kw_only=True, frozen=True):
    """Reply of CheckPath.

    Attributes
    ----------
    unreachable : list of str
        Rooms that cannot be reached from the start.
    blocked_doors : list of str
        Doors before which an object leaves no way through.
    cut_rooms : list of str
        Rooms whose furniture leaves a robot no way between two parts of their floor, or to a door.
    """

    message: str
    reachable: bool
    start: str = ""
    end: str = ""
    route: list[PathStep] = []
    unreachable: list[str] = []
    blocked_doors: list[str] = []
    cut_rooms: list[str] = []


class AssetInfo(msgspec.Struct, frozen=True, kw_only=True):
    """An asset of the catalogue; `asset_id` is what the Place tools take."""

    asset_id: str
    category: str
    name: str
    size: Point3
    score: float
    material: str = ""
    properties: list[str] = []


class AssetHits(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of SearchAssets, the best first."""

    message: str
    assets: list[AssetInfo]


class ObjectInfo(msgspec.Struct, frozen=True, kw_only=True):
    """An object of the scene with the properties that the catalogue knows of its asset."""

    id: str
    category: str
    name: str
    asset_id: str
    floor: int
    room: str
    position: Point3
    mount: str
    parent: str | None = None
    color: str = ""
    properties: list[str] = []
    states: dict[str, bool | float | str] = {}


class ObjectList(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ListObjects; `total` counts those beyond the limit too."""

    message: str
    total: int
    objects: list[ObjectInfo]


class ReceptacleContents(msgspec.Struct, frozen=True, kw_only=True):
    """One receptacle and what geometry finds on or in it."""

    receptacle: ObjectInfo
    objects: list[ObjectInfo]


class ReceptacleReport(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of CheckSurface and of SearchContents: one entry for each receptacle that fits."""

    message: str
    receptacles: list[ReceptacleContents]
