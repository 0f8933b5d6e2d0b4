"""Annotations of models: those of objathor and Objaverse, of AI2-THOR's databases, and plain ones.

objathor (https://github.com/allenai/objathor) keeps one object for each model, in ``annotations.json`` of a whole data
set by their ids, or in a file of the model's folder. ``width``, ``depth`` and ``height`` are centimetres; ``scale`` is
metres, of the height where ``z_axis_scale`` holds, else of the longest side; ``pose_z_rot_angle`` turns the model about
the vertical, in radians, so that its front faces +z of glTF. AI2-THOR's databases (ProcTHOR's ``asset-database.json``)
list ``assetId``, ``objectType``, ``boundingBox`` and properties of each.
"""

import gzip
import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Mount

__all__ = ["Annotation", "Annotations", "annotation_of"]

FILES: Final = ("annotations.json", "annotations.json.gz", "data.json", "asset-database.json", "metadata.json")
"""Names of files that hold annotations of many models, or of the one in their folder."""

_LARGEST: Final = 256 * 1024 * 1024
_LICENCES: Final = {
    "by": "CC-BY-4.0",
    "by-sa": "CC-BY-SA-4.0",
    "by-nd": "CC-BY-ND-4.0",
    "by-nc": "CC-BY-NC-4.0",
    "by-nc-sa": "CC-BY-NC-SA-4.0",
    "by-nc-nd": "CC-BY-NC-ND-4.0",
    "cc0": "CC0-1.0",
}
"""Objaverse's codes of licences, all of version 4.0."""

_MOST_TEXT: Final = 400
_CENTIMETRES: Final = 0.01


@dataclass(frozen=True)
class Annotation:
    """What an annotation states of a model; None and empty for what it leaves out.

    Attributes
    ----------
    size : (w, d, h), optional
        Metres, of the model that faces the front.
    height, longest : float, optional
        Metres.
    turn : float, optional
        Degrees counter-clockwise about the vertical that bring its front to where the file's convention has it.
    source : str
        File that it is from.
    """

    category: str = ""
    description: str = ""
    size: tuple[float, float, float] | None = None
    height: float | None = None
    longest: float | None = None
    turn: float | None = None
    mount: Mount | None = None
    pickupable: bool | None = None
    receptacle: bool | None = None
    openable: bool | None = None
    toggleable: bool | None = None
    mass: float | None = None
    licence: str = ""
    author: str = ""
    origin: str = ""
    source: str = ""


class Annotations:
    """The annotations of the models below a folder, read as they are asked for.

    Parameters
    ----------
    root : Path
        Nothing above it is read.
    """

    def __init__(self, root: Path) -> None:
        self._root = root
        self._files: dict[Path, Any] = {}

    def of(self, model: Path) -> Annotation | None:
        """Return the annotation of a model, by the name of its file or its folder; None if there is none.

        Raises
        ------
        MansionError
            ``INVALID_PAYLOAD`` for annotations that are not JSON, or have invalid numbers.
        """
        for file in self._candidates(model):
            found = _entry(self._read(file), (model.stem, model.parent.name), alone=self._is_alone(file, model))
            if found is not None:
                try:
                    return annotation_of(found, file.name)
                except MansionError as error:
                    raise error.with_message(f"{file.name}: {error.info.message}") from None
        return None

    def _is_alone(self, file: Path, model: Path) -> bool:
        return file.stem.split(".")[0] == model.stem or file.parent == model.parent

    def _candidates(self, model: Path) -> Iterator[Path]:
        """Yield the files that may describe a model, the nearest first."""
        for ending in (".json", ".json.gz"):
            yield from filter(Path.is_file, [model.with_name(f"{model.stem}{ending}")])
        folder = model.parent
        while True:
            yield from (folder / name for name in FILES if (folder / name).is_file())
            if folder == self._root or folder == folder.parent or self._root not in folder.parents:
                return
            folder = folder.parent

    def _read(self, file: Path) -> Any:
        if file not in self._files:
            try:
                data = file.read_bytes()
                if file.suffix == ".gz":
                    with gzip.open(file) as stream:
                        data = stream.read(_LARGEST + 1)
                if len(data) > _LARGEST:
                    raise ValueError(f"it is larger than {_LARGEST >> 20} MB")
                self._files[file] = json.loads(data)
            except (OSError, ValueError, EOFError, RecursionError) as error:
                raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{file.name} cannot be read: {error}") from None
        return self._files[file]


def _entry(document: Any, names: tuple[str, ...], *, alone: bool) -> Mapping[str, Any] | None:
    """Return the object of a document that describes the model with one of these names."""
    if isinstance(document, list):
        document = {"": document}
    if not isinstance(document, Mapping):
        return None
    for name in names:
        if isinstance(document.get(name), Mapping):
            return _flat(document[name])
    for value in document.values():
        for entry in value if isinstance(value, list) else ():
            if isinstance(entry, Mapping) and (entry.get("assetId") in names or entry.get("uid") in names):
                return _flat(entry)
    known = {"category", "objectType", "annotations", "assetMetadata", "scale", "description", "boundingBox"}
    return _flat(document) if alone and known & document.keys() else None


def _flat(entry: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return an entry with what is nested in it beside the rest."""
    flat = dict(entry)
    for name in ("assetMetadata", "annotations"):
        if isinstance(entry.get(name), Mapping):
            flat |= entry[name]
    return flat


def annotation_of(entry: Mapping[str, Any], source: str = "") -> Annotation:
    """Return what an object of an annotation file states.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a size, a mass or an angle that is not a number, or not a possible one.

    Examples
    --------
    >>> annotation_of({"category": "chair", "scale": 0.9, "z_axis_scale": True, "onFloor": True}).height
    0.9
    """
    scale = _length(entry, "scale")
    upright = entry.get("z_axis_scale", True) is True
    angle = _number(entry, "pose_z_rot_angle")
    size = _size(entry)
    licence = entry.get("license_info")
    info: Mapping[str, Any] = licence if isinstance(licence, Mapping) else {}
    properties = entry.get("secondaryProperties")
    secondary = set(map(str, properties)) if isinstance(properties, list) else None
    mass = _number(entry, "mass")
    if mass is not None and mass <= 0.0:
        raise _fault("mass", mass)
    return Annotation(
        category=_text(entry, "category") or _words(_text(entry, "objectType")),
        description=_text(entry, "description") or _text(entry, "description_auto"),
        size=size,
        height=scale if scale is not None and upright else None,
        longest=scale if scale is not None and not upright else None,
        turn=None if angle is None else math.degrees(angle),
        mount=_mount(entry),
        pickupable=_pickupable(entry),
        receptacle=_flag(entry, "receptacle", secondary, "Receptacle"),
        openable=_flag(entry, "openable", secondary, "CanOpen"),
        toggleable=_flag(entry, "toggleable", secondary, "CanToggleOnOff"),
        mass=mass,
        licence=_licence(str(info.get("license") or _text(entry, "license") or _text(entry, "licence"))),
        author=str(info.get("creator_display_name") or info.get("creator_username") or "")[:_MOST_TEXT],
        origin=str(info.get("uri") or _text(entry, "uri"))[:_MOST_TEXT],
        source=source,
    )


def _licence(said: str) -> str:
    """Return a licence by its SPDX name where Objaverse's code for one is said; else what is said."""
    return _LICENCES.get(said.strip().lower(), said)[:_MOST_TEXT]


def _size(entry: Mapping[str, Any]) -> tuple[float, float, float] | None:
    """Return width, depth and height: AI2-THOR's bounding box in metres, y up, or objathor's centimetres."""
    box = entry.get("boundingBox")
    if isinstance(box, Mapping):
        sides = [_length(box, name) for name in ("x", "z", "y")]
    else:
        sides = [_length(entry, name, _CENTIMETRES) for name in ("width", "depth", "height")]
    if any(side is None for side in sides):
        return None
    w, d, h = (float(side or 0.0) for side in sides)
    return w, d, h


def _mount(entry: Mapping[str, Any]) -> Mount | None:
    mounts: tuple[tuple[str, Mount], ...] = (
        ("onFloor", "floor"),
        ("onWall", "wall"),
        ("onCeiling", "ceiling"),
        ("onObject", "surface"),
    )
    said = [mount for name, mount in mounts if entry.get(name) is True]
    return said[0] if said else None


def _pickupable(entry: Mapping[str, Any]) -> bool | None:
    primary = entry.get("primaryProperty")
    if isinstance(primary, str):
        return primary == "CanPickup"
    value = entry.get("pickupable")
    return value if isinstance(value, bool) else None


def _flag(entry: Mapping[str, Any], name: str, secondary: set[str] | None, thor: str) -> bool | None:
    value = entry.get(name)
    if isinstance(value, bool):
        return value
    return None if secondary is None else thor in secondary


def _text(entry: Mapping[str, Any], name: str) -> str:
    value = entry.get(name)
    return " ".join(value.split())[:_MOST_TEXT] if isinstance(value, str) else ""


def _words(camel: str) -> str:
    return "".join(f" {c.lower()}" if c.isupper() else c for c in camel).strip()


def _number(entry: Mapping[str, Any], name: str) -> float | None:
    value = entry.get(name)
    if value is None:
        return None
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise _fault(name, value) from None
    if not math.isfinite(number):
        raise _fault(name, value)
    return number


def _length(entry: Mapping[str, Any], name: str, unit: float = 1.0) -> float | None:
    value = _number(entry, name)
    if value is not None and value <= 0.0:
        raise _fault(name, value)
    return None if value is None else value * unit


def _fault(name: str, value: Any) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"{name} is {str(value)[:40]!r}; it must be a finite number above 0",
        path=f"$.{name}",
    )
