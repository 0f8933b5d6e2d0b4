"""Room inside a model: the trays of its drawers, and what lies behind its doors and below its lids."""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from mansion_assets.catalogue.asset import Surface, Volume
from mansion_assets.library.source_model import SourceModel, SourcePart
from mansion_assets.library.support_surfaces import level_surfaces
from mansion_geometry.compiled import Floats

__all__ = ["Receptacles", "receptacles_of_model"]

_LEAST_HEIGHT: Final = 0.03
"""Metres of the height of a volume at least."""

_COVERED: Final = 0.5
"""Share of a level face's width that a door in front of it, or a lid above it, covers at least."""

_GAP: Final = 0.005
"""Metres between a volume and what lies above it."""


class Receptacles(NamedTuple):
    """Where things stand on a model, and where they lie in it."""

    surfaces: list[Surface]
    volumes: list[Volume]


def receptacles_of_model(model: SourceModel, kind: str = "top") -> Receptacles:
    """Return the level faces of the body that are open, and the volumes behind doors, below lids and in drawers.

    Parameters
    ----------
    model : SourceModel
        Closed, metres, its front to +y.
    kind : str
        What the highest open face is called.
    """
    body = _corners([part for part in model.parts if part.joint is None])
    moving = [part for part in model.parts if part.joint is not None and len(part.points)]
    surfaces: list[Surface] = []
    volumes: list[Volume] = []
    for face in level_surfaces(body, kind) if len(body) else ():
        cover = next((part for part in moving if _covers(part, face)), None)
        if cover is None:
            surfaces.append(face)
        elif cover.joint is not None and cover.joint.kind == "hinge":
            volumes += _volume("cell", face, _height_below(cover, face))
    for part in moving:
        if part.joint is not None and part.joint.kind == "slide":
            volumes += _tray(part)
    return Receptacles(surfaces, volumes)


def _corners(parts: Sequence[SourcePart]) -> Floats:
    """Return the corners of the triangles of parts, (m, 3, 3)."""
    found = [s.vertices[s.faces] for part in parts for s in part.surfaces]
    return np.concatenate(found) if found else np.zeros((0, 3, 3))


def _bounds(part: SourcePart) -> tuple[Floats, Floats]:
    return part.points.min(axis=0), part.points.max(axis=0)


def _covers(part: SourcePart, face: Surface) -> bool:
    """Whether a closed part is a door in front of a level face, or a lid above it."""
    low, high = _bounds(part)
    across = min(float(high[0]), face.x + face.w / 2) - max(float(low[0]), face.x - face.w / 2)
    if across < _COVERED * face.w:
        return False
    before = float(high[1]) > face.y and low[2] <= face.z + face.clearance / 2 <= high[2]
    along = min(float(high[1]), face.y + face.d / 2) - max(float(low[1]), face.y - face.d / 2)
    above = float(low[2]) > face.z and along >= _COVERED * face.d
    return before or above


def _height_below(cover: SourcePart, face: Surface) -> float:
    """Return the height of the room on a face that a door or a lid closes: up to the lid, or to the door's top."""
    low, high = _bounds(cover)
    top = float(low[2]) if low[2] > face.z + _LEAST_HEIGHT else float(high[2])
    return min(face.clearance, top - face.z)


def _tray(drawer: SourcePart) -> list[Volume]:
    """Return the room in a drawer: from its largest level face to its rim."""
    faces = level_surfaces(_corners([drawer]), "drawer")
    if not faces:
        return []
    floor = max(faces, key=lambda face: (face.w * face.d, -face.z))
    rim = float(drawer.points[:, 2].max()) - floor.z
    return _volume("drawer", floor, min(floor.clearance, rim))


def _volume(kind: str, floor: Surface, height: float) -> list[Volume]:
    """Return the room above a face, less a gap; nothing where there is next to none."""
    h = round(height - _GAP, 4)
    if h < _LEAST_HEIGHT:
        return []
    return [Volume(kind=kind, x=floor.x, y=floor.y, z=round(floor.z + h / 2, 4), w=floor.w, d=floor.d, h=h)]
