"""Own assets of a building: their files are kept in its folder, so that it can be read without the library."""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Final

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.loading import PIECES, load_catalogue
from mansion_assets.catalogue.preferred_folders import preferring
from mansion_assets.catalogue.records import AssetRecord
from mansion_assets.library.folders import library_folder, library_folders
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes, read_payload

__all__ = ["ASSETS", "asset_files", "assets_of", "catalogue_for", "own_assets"]

ASSETS: Final = "assets"
"""Folder of own assets in a building's folder, and of the records of a library."""


@contextmanager
def assets_of(building: Path) -> Iterator[None]:
    """Prefer the own assets that a building's folder has, and no others, within the block."""
    with preferring(_kept(building)):
        yield


def _kept(building: Path) -> list[Path]:
    return [building] if (building / ASSETS).is_dir() else []


def catalogue_for(building: Path, asked: Sequence[str] = (), remembered: Sequence[str] = ()) -> Catalogue:
    """Return the catalogue that a building is changed with: its own assets come first, then those of libraries.

    Parameters
    ----------
    building : Path
        Its folder. What it has of an asset counts, whatever a library has under the same name meanwhile.
    asked : sequence of str
        Libraries that must be there.
    remembered : sequence of str
        Libraries that it was made with; those that are gone are left out.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a library that is asked for and not there.
    """
    names = dict.fromkeys(name for name in remembered if library_folder(name).is_dir())
    folders = library_folders(dict.fromkeys([*names, *asked]))
    return load_catalogue(preferred=[*folders, *_kept(building)])


def own_assets(keys: Iterable[str], catalogue: Catalogue) -> list[Asset]:
    """Return the assets among `keys` that are the user's, by key."""
    found = (catalogue.assets.get(key) for key in sorted(set(keys)))
    return [asset for asset in found if asset is not None and asset.record]


def asset_files(assets: Iterable[Asset], building: Path | None = None) -> dict[str, bytes]:
    """Return what a building needs of own assets by path in its folder: records, meshes and convex pieces.

    Parameters
    ----------
    building : Path, optional
        A folder whose assets are left out.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that is gone.
    """
    files: dict[str, bytes] = {}
    for asset in assets:
        if building is not None and (building / ASSETS / f"{asset.key}.json").is_file():
            continue
        record = read_payload(AssetRecord, Path(asset.record), "the record of an asset")
        if record.key != asset.key:
            raise MansionError(ErrorCode.CONFLICT, f"{asset.record} now belongs to another asset than {asset.key!r}")
        glb, pieces = (f"{asset.key}.glb", f"{asset.key}{PIECES}")
        for name, file in ((glb, asset.glb), (pieces, asset.pieces)):
            if file is not None:
                files[f"{ASSETS}/{name}"] = read_bytes(Path(file), "a file of an asset")
        record = msgspec.structs.replace(record, glb=asset.glb and glb, pieces=asset.pieces and pieces)
        files[f"{ASSETS}/{asset.key}.json"] = encode_bytes(record, indent=1)
    return files
