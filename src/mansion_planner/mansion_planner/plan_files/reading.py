"""One reader for all files of plans: the format follows from the ending, and in JSON from the content."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final, Literal

import msgspec

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.limits import MAX_PAYLOAD
from mansion_msgs_py.wording import choices
from mansion_planner.plan_files.dxf import plan_from_dxf
from mansion_planner.plan_files.geojson import plan_from_geojson
from mansion_planner.plan_files.ifc import plan_from_ifc
from mansion_planner.plan_files.room_graphs import is_room_graph, plan_from_graph

__all__ = ["EXTRAS", "extra_for", "read_plan"]

EXTRAS: Final[Mapping[str, str]] = {".dxf": "dxf", ".ifc": "ifc"}
"""Endings of files that an optional dependency reads, with its name."""

_EXPECTED = "a plan: our JSON, GeoJSON or a room graph; or an .ifc or a .dxf file"


def extra_for(path: Path) -> str:
    """Return the extra that reads a file; empty where none is needed."""
    return EXTRAS.get(_parted(path)[0].suffix.lower(), "")


def read_plan(
    path: Path, *, complete: Sequence[Literal["doors", "windows"]] = (), layers: Mapping[str, str] | None = None
) -> BuildingPlan:
    """Read a plan.

    Parameters
    ----------
    path : Path
        A file; of several plans in one, ``FILE#ID`` names one by its ``plan_id``, or by its place from 1; of a
        building in IFC or DXF, ``FILE#STOREY`` is that storey alone.
    complete : sequence of {"doors", "windows"}
        What may be added to it, beside what the file itself says.
    layers : mapping of str to str, optional
        For drawings, the names of layers by what is on them.

    Raises
    ------
    MansionError
        ``NOT_FOUND``; ``INVALID_PAYLOAD`` for a file that is not a plan; ``UNAVAILABLE`` where the extra is missing.
    """
    file, wanted = _parted(path)
    kind = extra_for(path)
    if kind == "ifc":
        plan = plan_from_ifc(file, wanted)
    elif kind == "dxf":
        plan = plan_from_dxf(file, layers or {}, wanted)
    else:
        plan = _from_json(file, wanted)
    added = [name for name in complete if name not in plan.complete]
    return msgspec.structs.replace(plan, complete=[*plan.complete, *added])


def _parted(path: Path) -> tuple[Path, str]:
    """Return a file and the plan in it that is meant: those of ``FILE#ID``, unless a file has that very name."""
    if path.exists() or "#" not in path.name:
        return path, ""
    name, _, wanted = path.name.rpartition("#")
    return path.with_name(name), wanted


def _from_json(file: Path, wanted: str) -> BuildingPlan:
    data = read_bytes(file, _EXPECTED)
    if len(data) > MAX_PAYLOAD:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file}: more than {MAX_PAYLOAD} bytes")
    try:
        value = json.loads(data)
    except (ValueError, RecursionError) as error:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file} is not JSON: {error}; expected {_EXPECTED}") from None
    try:
        return _plan_of(_chosen(value, wanted, file))
    except MansionError as error:
        raise error.with_message(f"{file}: {error.info.message}") from None


def _chosen(value: Any, wanted: str, file: Path) -> Any:
    """Return the plan that is meant of several in a file."""
    if not isinstance(value, list):
        return value
    ids = [str(entry.get("plan_id", "")) if isinstance(entry, dict) else "" for entry in value]
    if wanted in ids and wanted:
        return value[ids.index(wanted)]
    if wanted.isdigit() and 1 <= int(wanted) <= len(value):
        return value[int(wanted) - 1]
    if len(value) == 1 and not wanted:
        return value[0]
    known = [name or str(number) for number, name in enumerate(ids, 1)]
    said = f"there is no plan {wanted!r} in it; {choices(wanted, known, 'plans')}" if wanted else f"{len(value)} plans"
    raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{said}; name one as {file.name}#{known[0] if known else 'ID'}")


def _plan_of(value: Any) -> BuildingPlan:
    if isinstance(value, dict) and value.get("type") == "FeatureCollection":
        return plan_from_geojson(value)
    if isinstance(value, dict) and is_room_graph(value):
        return plan_from_graph(value)
    if isinstance(value, dict) and "floors" in value:
        return convert(BuildingPlan, value)
    raise MansionError(ErrorCode.INVALID_PAYLOAD, f"expected {_EXPECTED}: an object with floors, features or nodes")
