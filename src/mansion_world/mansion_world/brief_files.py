"""Files of briefs: one a line, or rows of CSV or JSON lines with what else a request may say."""

import csv
import io
import json
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Final, Literal

import msgspec

from mansion_assets.library.folders import stated_libraries
from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import prepared
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.limits import MAX_BUILDING_AREA, MAX_FLOORS
from mansion_msgs_py.request import BuildRequest, Footprint, footprint_from_json
from mansion_msgs_py.shapes import Area
from mansion_world.brief_list import NamedRequest

__all__ = ["read_briefs"]

_NAME: Final = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,99}")
_MOST_FAULTS: Final = 5


class _Row(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A row as it may be written; what is absent is that of the defaults."""

    brief: Annotated[str, msgspec.Meta(max_length=200_000)] = ""
    name: str = ""
    floors: Annotated[int, msgspec.Meta(ge=1, le=MAX_FLOORS)] | None = None
    area: Annotated[float, msgspec.Meta(gt=0.0, le=MAX_BUILDING_AREA)] | None = None
    floor_area: Area | None = None
    footprint: str | None = None
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**53)] | None = None
    planner: Literal["rules", "llm"] | None = None
    plan: str | None = None
    assets: str | list[str] | None = None


_COLUMNS: Final = _Row.__struct_fields__

PlanReader = Callable[[Path], BuildingPlan]

Rows = Iterator[tuple[int, Mapping[str, Any] | str]]
"""Line numbers with the row there, or with what is wrong with it."""


def read_briefs(
    path: Path, defaults: BuildRequest | None = None, read_plan: PlanReader | None = None
) -> list[NamedRequest]:
    """Read a file of briefs, all of it or nothing.

    Parameters
    ----------
    path : Path
        ``.txt``: a brief a line; empty lines and those that begin with ``#`` are passed over. ``.csv`` with a heading,
        or ``.jsonl``: ``brief``, and any of ``name``, ``floors``, ``area``, ``floor_area``, ``footprint`` (a file,
        relative to this one), ``seed``, ``planner``, ``plan`` (a file of a plan to furnish, relative to this one,
        with which the brief may be empty) and ``assets`` (libraries of own assets with commas between them, or a list
        in JSON; paths are relative to this file).
    defaults : BuildRequest, optional
        What holds where a row says nothing; its description is not used.
    read_plan : callable, optional
        Reads the file of a plan; rows with plans are refused without it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for the file itself, or ``INVALID_PAYLOAD`` naming file and line of what is wrong.
    """
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"{path}: briefs are read from files that end in {', '.join(_READERS)}"
        )
    rows, faults = list[tuple[int, NamedRequest]](), list[str]()
    for line, row in reader(_text(path)):
        try:
            rows.append((line, _named(row, path.parent, defaults or BuildRequest(description=""), read_plan)))
        except MansionError as error:
            faults.append(f"{path}:{line}: {error.info.message}")
    faults += [f"{path}:{line}: {fault}" for line, fault in _repeated_names(rows)]
    if not rows and not faults:
        faults.append(f"{path}: holds no brief")
    if faults:
        more = f"; and {len(faults) - _MOST_FAULTS} more" if len(faults) > _MOST_FAULTS else ""
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "; ".join(faults[:_MOST_FAULTS]) + more)
    return [row for _, row in rows]


def _text(path: Path) -> str:
    data = read_bytes(path, "a file of briefs")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{path}:{line}: the text is not UTF-8") from None


def _lines(text: str) -> Rows:
    for number, line in enumerate(text.split("\n"), start=1):
        if line.strip() and not line.lstrip().startswith("#"):
            yield number, {"brief": line.strip()}


def _csv_rows(text: str) -> Rows:
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    heading: list[str] | None = None
    line = 1
    try:
        for cells in reader:
            if not any(cell.strip() for cell in cells):
                pass
            elif heading is None:
                heading = [cell.strip() for cell in cells]
                if fault := _heading_fault(heading):
                    yield line, fault
                    return
            elif len(cells) > len(heading):
                yield line, f"{len(cells)} cells under {len(heading)} columns; put a text with commas into quotes"
            else:
                yield line, {name: cell.strip() for name, cell in zip(heading, cells) if cell.strip()}
            line = reader.line_num + 1
    except csv.Error as error:
        yield line, f"no CSV: {error}"


def _heading_fault(heading: Sequence[str]) -> str:
    unknown = [name for name in heading if name not in _COLUMNS]
    if unknown or not {"brief", "plan"} & set(heading) or len(set(heading)) < len(heading):
        said = ", ".join(repr(name) for name in heading)
        return f"the columns are {said}; they may be brief and any of {', '.join(_COLUMNS[1:])}, each once"
    return ""


def _json_rows(text: str) -> Rows:
    for number, line in enumerate(text.split("\n"), start=1):
        if not line.strip():
            continue
        try:
            row = json.loads(line)
        except (ValueError, RecursionError) as error:
            yield number, f"not JSON: {error}"
        else:
            what = f'expected an object such as {{"brief": "a small flat", "seed": 4}}, got {type(row).__name__}'
            yield number, row if isinstance(row, dict) else what


_READERS: Final[Mapping[str, Callable[[str], Rows]]] = {".txt": _lines, ".csv": _csv_rows, ".jsonl": _json_rows}


def _named(
    row: Mapping[str, Any] | str, folder: Path, defaults: BuildRequest, read_plan: PlanReader | None
) -> NamedRequest:
    if isinstance(row, str):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, row)
    if unknown := [name for name in row if name not in _COLUMNS]:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"unknown {', '.join(unknown)}; a row may have {', '.join(_COLUMNS)}"
        )
    try:
        said = msgspec.convert(
            {name: value for name, value in row.items() if value is not None}, prepared(_Row), strict=False
        )
    except msgspec.ValidationError as error:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, str(error)) from None
    if not said.brief.strip() and not said.plan:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "the brief is empty")
    if said.name and not _NAME.fullmatch(said.name):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"the name {said.name!r} names no folder; use letters, digits, '.', '_' and '-', 100 at most, "
            "a letter or a digit first",
        )
    return NamedRequest(request=_request(said, folder, defaults, read_plan), name=said.name)


def _request(said: _Row, folder: Path, defaults: BuildRequest, read_plan: PlanReader | None) -> BuildRequest:
    sized = said.area is not None or said.floor_area is not None
    if said.area is not None and said.floor_area is not None:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "area and floor_area exclude each other")
    if said.plan and read_plan is None:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "plans cannot be read here")
    return BuildRequest(
        description=said.brief,
        floors=said.floors if said.floors is not None else defaults.floors,
        area=said.area if sized else defaults.area,
        floor_area=said.floor_area if sized else defaults.floor_area,
        footprint=_footprint(folder / said.footprint) if said.footprint else defaults.footprint,
        seed=said.seed if said.seed is not None else defaults.seed,
        planner=said.planner or defaults.planner,
        plan=read_plan(folder / said.plan) if said.plan and read_plan else defaults.plan,
        assets=_libraries(said.assets, folder) or defaults.assets,
    )


def _libraries(stated: str | list[str] | None, folder: Path) -> tuple[str, ...]:
    """Return the libraries that a row names, all there, their paths taken from the file's folder."""
    names = stated if isinstance(stated, list) else (stated or "").split(",")
    named = [name.strip() for name in names if name.strip()]
    return tuple(stated_libraries(str(folder / Path(name).expanduser()) if "/" in name else name for name in named))


def _footprint(file: Path) -> Footprint:
    return footprint_from_json(read_bytes(file, 'a file of {"boundary": [[x, y], ...]} or GeoJSON'), str(file))


def _repeated_names(rows: Sequence[tuple[int, NamedRequest]]) -> Iterator[tuple[int, str]]:
    seen: dict[str, int] = {}
    for line, row in rows:
        earlier = seen.setdefault(row.name.casefold(), line)
        if row.name and earlier != line:
            yield line, f"the name {row.name!r} is already used in line {earlier}"
