"""What a world keeps of its buildings: rows of the manifest, and what was set aside."""

from typing import Literal, TypeAlias

import msgspec

from mansion_world.sampling import WorldRequest

__all__ = [
    "SPLITS",
    "BuildingRow",
    "Difficulty",
    "Record",
    "RoomLikeness",
    "RoomRow",
    "SetAside",
    "Split",
    "WorldIndex",
]

Split: TypeAlias = Literal["train", "val", "test"]
Difficulty: TypeAlias = Literal["easy", "medium", "hard", "expert"]

SPLITS: tuple[Split, ...] = ("train", "val", "test")


class WorldIndex(msgspec.Struct, frozen=True, kw_only=True):
    """The content of ``world.json``: what all buildings of a world follow from.

    Attributes
    ----------
    mix : str
        The mixture as JSON; empty where the buildings are those of a list.
    """

    seed: int
    mix: str
    versions: dict[str, str]
    schema_version: Literal[1] = 1


class BuildingRow(msgspec.Struct, frozen=True, kw_only=True):
    """A building in the manifest.

    Attributes
    ----------
    path : str
        Folder of the building, relative to the world's.
    floor_areas : list of float
        Of the floors from below, m2; `area` is their sum.
    wishes, wishes_met : int
        What its sentence asks for, and how much of that the building meets.
    bytes, sha256 : int, str
        Of all files but ``report.json``, which holds times.
    """

    index: int
    id: str
    path: str
    split: Split
    difficulty: Difficulty
    kind: str
    sub_kind: str
    outline: str
    style: str
    description: str
    wording: str
    seed: int
    attempt: int
    floors: int
    rooms: int
    objects: int
    area: float
    floor_areas: list[float]
    wishes: int
    wishes_met: int
    files: int
    bytes: int
    sha256: str
    versions: dict[str, str]


class RoomRow(msgspec.Struct, frozen=True, kw_only=True):
    """A room in the manifest."""

    index: int
    building: str
    split: Split
    floor: int
    id: str
    type: str
    area: float
    objects: int


class RoomLikeness(msgspec.Struct, frozen=True, kw_only=True, array_like=True):
    """Where a room is, for comparison: type, floor, centre and area in metres."""

    floor: int
    type: str
    x: float
    y: float
    area: float


class Record(msgspec.Struct, frozen=True, kw_only=True):
    """All that is kept of a finished building.

    Attributes
    ----------
    graph : str
        Hash of its room graphs (see `mansion_world.likeness`).
    likeness : list of RoomLikeness
    """

    building: BuildingRow
    rooms: list[RoomRow]
    graph: str
    likeness: list[RoomLikeness]


class SetAside(msgspec.Struct, frozen=True, kw_only=True):
    """A request that came to nothing, with the reason."""

    request: WorldRequest
    reason: Literal["refused", "faults", "floor too large", "near-duplicate", "worker ended"]
    details: list[str]
