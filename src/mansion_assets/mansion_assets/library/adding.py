"""Add models to a library one by one; a broken one does not stop the rest."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final, Literal

import msgspec

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.records import AssetRecord
from mansion_assets.library.annotations import Annotations
from mansion_assets.library.asset_files import Drawer, asset_files, write_asset
from mansion_assets.library.mesh_files import MODELS
from mansion_assets.library.preparing import AddOptions, prepared
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.file_locks import hold_lock

__all__ = ["Addition", "add_models", "models_below"]

_FILE_NAME: Final = re.compile(r"""filename\s*=\s*["']([^"']+)["']""")

_PATIENCE: Final = 30.0
"""Seconds that one waits for another who adds to the same library."""

_SAME_NAME: Final = 1000
"""Assets of one library that may come from files of one name."""


class Addition(msgspec.Struct, frozen=True, kw_only=True):
    """What became of a file.

    Attributes
    ----------
    status : {"added", "replaced", "unchanged", "refused"}
    reason : str
        Why it was refused.
    """

    file: str
    status: Literal["added", "replaced", "unchanged", "refused"]
    key: str = ""
    category: str = ""
    size: tuple[float, float, float] | None = None
    stated: list[str] = []
    guessed: list[str] = []
    reason: str = ""


def models_below(path: Path) -> list[Path]:
    """Return the models of a folder, or the one that a path is; meshes that a URDF names are its parts.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for what is not there, and for a folder without a model.
    """
    if path.is_file():
        return [path]
    if not path.is_dir():
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no file or folder {path}")
    hidden = {file for file in path.rglob("*") if any(part.startswith(".") for part in file.relative_to(path).parts)}
    files = sorted(file for file in path.rglob("*") if file.is_file() and file not in hidden)
    urdfs = [file for file in files if file.suffix.lower() == ".urdf"]
    parts: dict[Path, set[str]] = {}
    for file in urdfs:
        parts.setdefault(file.parent, set()).update(_names_of_meshes(file))
    meshes = [
        file
        for file in files
        if file.suffix.lower() in MODELS and not any(file.name in parts.get(home, ()) for home in file.parents)
    ]
    found = sorted([*urdfs, *meshes])
    if not found:
        raise MansionError(
            ErrorCode.NOT_FOUND, f"{path} holds no model; models are {', '.join(MODELS)} and .urdf files"
        )
    return found


def _names_of_meshes(urdf: Path) -> frozenset[str]:
    """Return the names of the mesh files that a URDF refers to, without their folders."""
    try:
        text = urdf.read_text(errors="replace")
    except OSError:
        return frozenset()
    return frozenset(name.rpartition("/")[2] for name in _FILE_NAME.findall(text))


def add_models(
    paths: Sequence[Path], folder: Path, options: AddOptions, catalogue: Catalogue, draw: Drawer, *, replace: bool
) -> Iterator[Addition]:
    """Add the models of files and folders to a library, and yield what became of each.

    Parameters
    ----------
    folder : Path
        The library's folder; made if it is missing.
    catalogue : Catalogue
    draw : callable
        Makes the pictures.
    replace : bool
        Whether an asset of the same name and another content gives way.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a path that leads to no model, ``CONFLICT`` when another adds to the library at that time.
    OSError
        When the library cannot be written.
    """
    found = [(model, path if path.is_dir() else model.parent) for path in paths for model in models_below(path)]
    taken: set[str] = set()
    with hold_lock(folder / ".lock", f"another process adds to {folder}", patience=_PATIENCE):
        annotations: dict[Path, Annotations] = {}
        for model, root in found:
            known = annotations.setdefault(root, Annotations(root))
            try:
                asset = prepared(model, root, options, catalogue, known.of(model))
                key = _free_key(f"{_prefix(folder)}.{asset.record.key}", taken)
                record, _ = asset_files(asset, key)
                status = _status(folder, record, replace=replace)
                if status != "unchanged":
                    record = write_asset(folder, asset, key, draw)
            except MansionError as error:
                yield Addition(file=str(model), status="refused", reason=error.info.message)
                continue
            taken.add(key)
            yield Addition(
                file=str(model),
                status=status,
                key=key,
                category=record.category,
                size=record.size,
                stated=record.stated,
                guessed=record.guessed,
            )


def _prefix(folder: Path) -> str:
    return re.sub(r"[^A-Za-z0-9_-]", "_", folder.resolve().name)[:30] or "own"


def _free_key(key: str, taken: set[str]) -> str:
    """Return the key, numbered where this run has given it to another file."""
    short = key[:70]
    return next(name for name in (short, *(f"{short}_{n}" for n in range(2, _SAME_NAME))) if name not in taken)


def _status(folder: Path, record: AssetRecord, *, replace: bool) -> Literal["added", "replaced", "unchanged"]:
    file = folder / "assets" / f"{record.key}.json"
    if not file.is_file():
        return "added"
    try:
        there = decode(AssetRecord, file.read_bytes())
    except MansionError:
        there = None
    if there == record:
        return "unchanged"
    if not replace:
        raise MansionError(ErrorCode.CONFLICT, f"{folder} already has an asset {record.key!r}; --replace replaces it")
    return "replaced"
