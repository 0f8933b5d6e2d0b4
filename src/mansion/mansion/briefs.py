"""Briefs and options of a call as requests for buildings."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, TypeAlias

from mansion_msgs_py.codec import convert, to_builtins
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.request import BuildRequest, Footprint, footprint_from_json
from mansion_msgs_py.shapes import Point

__all__ = ["Outline", "request_of"]

Outline: TypeAlias = Footprint | Sequence[Point] | str | Path
"""The outline of every floor: a `Footprint`, the corners of a ring in metres, or a file of either or of GeoJSON."""


def request_of(description: str | BuildRequest, footprint: Outline | None, **fields: Any) -> BuildRequest:
    """Return the validated request of a description and options; a request is returned as it is.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` with the option at fault.
    """
    if isinstance(description, BuildRequest):
        return description
    outline = None if footprint is None else to_builtins(_footprint(footprint))
    return convert(BuildRequest, {"description": description, "footprint": outline, **fields})


def _footprint(outline: Outline) -> Any:
    if isinstance(outline, (str, Path)):
        return footprint_from_json(read_bytes(Path(outline), "a file of corners or GeoJSON"), str(outline))
    return outline if isinstance(outline, Footprint) else {"boundary": [list(point) for point in outline]}
