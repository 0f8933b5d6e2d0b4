"""Options of the commands that take a request for a building, and the request that they make."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import convert, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.request import BuildRequest, Footprint

__all__ = [
    "Area",
    "Assets",
    "Complete",
    "FloorArea",
    "Floors",
    "FootprintFile",
    "Layers",
    "PlanFile",
    "Planner",
    "given_plan",
    "library_names",
    "planner_name",
    "request_from_options",
]

Floors = Annotated[int | None, typer.Option(min=1, max=100, help="Number of floors.")]
Area = Annotated[float | None, typer.Option(min=1, help="Gross area of the building, m2.")]
FloorArea = Annotated[float | None, typer.Option(min=1, help="Gross area of a floor, m2.")]
FootprintFile = Annotated[Path | None, typer.Option(help="Outline: our JSON or GeoJSON.")]
PlanFile = Annotated[
    Path | None, typer.Option(help="A plan to furnish as it is: our JSON, GeoJSON, IFC, DXF or a room graph.")
]
Complete = Annotated[
    str, typer.Option(help="What may be added where the plan lacks it: doors, windows, or doors,windows.")
]
Layers = Annotated[str, typer.Option(help="Layers of a drawing: rooms=NAME,names=NAME,doors=NAME,windows=NAME.")]
Planner = Annotated[str, typer.Option(help="rules, or llm: a language model reads and plans, rules fill its gaps.")]
Assets = Annotated[
    str, typer.Option(help="Libraries of your own assets that come first: NAME,NAME (mansion assets add).")
]


def request_from_options(
    description: str,
    floors: int | None,
    area: float | None,
    floor_area: float | None,
    footprint: Path | None,
    seed: int,
    planner: Literal["rules", "llm"],
    plan: BuildingPlan | None = None,
    assets: str = "",
) -> BuildRequest:
    """Return the validated request that the options make.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for options that do not fit, ``NOT_FOUND`` for a library of own assets that is not there.
    """
    fields = {
        "description": description,
        "floors": floors,
        "area": area,
        "floor_area": floor_area,
        "footprint": _read_footprint(footprint) if footprint else None,
        "seed": seed,
        "planner": planner,
        "plan": None if plan is None else to_builtins(plan),
    }
    if names := library_names(assets):
        fields["assets"] = names
    return convert(BuildRequest, fields)


def library_names(listed: str) -> list[str]:
    """Return the libraries of a comma-separated list, paths as absolute ones.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the libraries that exist.
    """
    named = [name.strip() for name in listed.split(",") if name.strip()]
    if not named:
        return []
    from mansion_assets.library.folders import stated_libraries

    return stated_libraries(named)


def given_plan(file: Path | None, complete: str, layers: str) -> BuildingPlan | None:
    """Return the plan that the options name.

    Parameters
    ----------
    complete : str
        ``doors``, ``windows`` or both with a comma.
    layers : str
        ``rooms=NAME,doors=NAME``, for drawings.
    """
    for name, said in (("--complete", complete), ("--layers", layers)):
        if file is None and said:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{name} needs a plan (--plan)")
    if file is None:
        return None
    from mansion_bringup.plan_files import plan_from_file

    added = convert(list[Literal["doors", "windows"]], [part.strip() for part in complete.split(",") if part.strip()])
    pairs = [part.partition("=") for part in layers.split(",") if part.strip()]
    return plan_from_file(file, added, {name.strip(): layer.strip() for name, _, layer in pairs})


def _read_footprint(path: Path) -> Footprint:
    """Read a footprint: ``{"boundary": ring, "holes": [ring]}`` in metres, or GeoJSON with one polygon.

    Raises
    ------
    MansionError
        ``NOT_FOUND``, or ``INVALID_PAYLOAD`` with what would be accepted.
    """
    from mansion_msgs_py.request import footprint_from_json

    expected = 'a file of {"boundary": [[x, y], ...]} or GeoJSON'
    return footprint_from_json(read_bytes(path, expected), str(path))


def planner_name(name: str) -> Literal["rules", "llm"]:
    """Return the planner of that name, or refuse it."""
    if name == "rules":
        return "rules"
    if name == "llm":
        return "llm"
    raise MansionError(ErrorCode.INVALID_PAYLOAD, f"unknown planner {name!r}; use rules or llm", path="$.planner")
