"""``building.json`` and ``report.json``: the index of a building folder, and what was asked and met."""

from typing import Annotated, Literal

import msgspec

from mansion_msgs_py.program import BuildingProgram, CorePlan, Downgrade
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.shapes import BuildingId, FileInFolder, PathText
from mansion_msgs_py.usage import LlmUsage
from mansion_msgs_py.wishes import Wish

__all__ = ["Building", "BuildingReport", "FloorEntry", "FloorReport", "LoadBuilding", "OwnAssetUse"]


class FloorEntry(msgspec.Struct, frozen=True, kw_only=True):
    """Where a floor's files are, relative to the building's folder; empty for a file that is not there."""

    floor: int
    label: str
    elevation: float
    height: float
    area: float
    rooms: int
    objects: int
    files: dict[str, FileInFolder]


class Building(msgspec.Struct, frozen=True, kw_only=True):
    """The content of ``building.json``.

    Attributes
    ----------
    wishes : list of Wish
        What the description asks for, and what became of it in the finished building.
    """

    building_id: BuildingId
    request: BuildRequest
    program: BuildingProgram
    floors: Annotated[list[FloorEntry], msgspec.Meta(min_length=1)]
    cores: list[CorePlan]
    seed: int
    versions: dict[str, str] = {}
    checks: dict[str, int] = {}
    files: dict[str, FileInFolder] = {}
    wishes: list[Wish] = []
    schema_version: Literal[1] = 1


class FloorReport(msgspec.Struct, frozen=True, kw_only=True):
    """What one floor asked for and got."""

    floor: int
    rooms_asked: int
    rooms_made: int
    edges_asked: int
    edges_met: int
    area_scale: float
    area_error: float
    objects_asked: int
    objects_placed: int


class OwnAssetUse(msgspec.Struct, frozen=True, kw_only=True):
    """An asset of the user's own in a building; its files are in the folder ``assets``.

    Attributes
    ----------
    objects : int
        How many objects show it.
    library : str
        Name of the library that it was taken from.
    licence, author, source, sha256 : str
        As its record states them.
    """

    asset: str
    category: str
    objects: int
    library: str = ""
    licence: str = ""
    author: str = ""
    source: str = ""
    sha256: str = ""


class BuildingReport(msgspec.Struct, frozen=True, kw_only=True):
    """The content of ``report.json``; the only file of a building that holds times.

    Attributes
    ----------
    sources : dict of str to str
        With the planner ``llm``: which piece came from the model, which from the rules, and why.
    llm : LlmUsage, optional
        Answers, tokens, time and cost.
    faults : list of str
        What ``mansion check`` found when it was built; empty for a sound building.
    assets : list of OwnAssetUse, optional
        Assets of the user's own in it; absent where there are none.
    """

    building_id: BuildingId
    floors: list[FloorReport]
    downgrades: list[Downgrade]
    seconds: dict[str, float]
    warnings: list[str] = []
    sources: dict[str, str] = {}
    llm: LlmUsage | None = None
    wishes: list[Wish] = []
    faults: list[str] = []
    assets: list[OwnAssetUse] | msgspec.UnsetType = msgspec.UNSET
    schema_version: Literal[1] = 1


class LoadBuilding(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Arguments of the ``load_building`` service: the folder that ``mansion build`` wrote.

    Attributes
    ----------
    session : str
        Which robot; the one default robot when absent.
    world : str
        Sessions that load the same folder under the same name share objects, doors and lifts.
    reset : bool
        Start over: everything back where the scenes have it, the robot at the spawn pose.
    """

    path: PathText
    session: str = ""
    world: str = "shared"
    reset: bool = False
