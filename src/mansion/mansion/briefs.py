"""Requests for buildings from a brief and the options of a call."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, TypeAlias

import msgspec

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import convert, to_builtins
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.request import BuildRequest, Footprint, footprint_from_json
from mansion_msgs_py.shapes import Point

__all__ = ["GivenPlan", "Outline", "request_of"]

Outline: TypeAlias = Footprint | Sequence[Point] | str | Path
"""The outline of every floor: a `Footprint`, the corners of a ring in metres, or a file of either or of GeoJSON."""


GivenPlan: TypeAlias = BuildingPlan | Mapping[str, Any] | str | Path
"""A plan to furnish: a `BuildingPlan`, the same as plain values, or a file that ``mansion build --plan`` reads."""


def request_of(
    description: str | BuildRequest,
    footprint: Outline | None,
    *,
    plan: GivenPlan | None = None,
    complete: Sequence[Literal["doors", "windows"]] = (),
    assets: str | Sequence[str] = (),
    **fields: Any,
) -> BuildRequest:
    """Return the validated request of a description and options; a request is returned as it is.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` with the option at fault, ``NOT_FOUND`` for a library that is not there.
    """
    if isinstance(description, BuildRequest):
        return description
    outline = None if footprint is None else to_builtins(_footprint(footprint))
    given = None if plan is None else to_builtins(_plan(plan, complete))
    if assets:
        with importing:
            from mansion_assets.library.folders import stated_libraries

        fields["assets"] = stated_libraries([assets] if isinstance(assets, str) else assets)
    return convert(BuildRequest, {"description": description, "footprint": outline, "plan": given, **fields})


def _plan(plan: GivenPlan, complete: Sequence[Literal["doors", "windows"]]) -> BuildingPlan:
    if isinstance(plan, (str, Path)):
        with importing:
            from mansion_bringup.plan_files import plan_from_file

        return plan_from_file(Path(plan), complete)
    given = plan if isinstance(plan, BuildingPlan) else convert(BuildingPlan, to_builtins(plan))
    return msgspec.structs.replace(given, complete=list(dict.fromkeys([*given.complete, *complete])))


def _footprint(outline: Outline) -> Any:
    if isinstance(outline, (str, Path)):
        return footprint_from_json(read_bytes(Path(outline), "a file of corners or GeoJSON"), str(outline))
    return outline if isinstance(outline, Footprint) else {"boundary": [list(point) for point in outline]}
