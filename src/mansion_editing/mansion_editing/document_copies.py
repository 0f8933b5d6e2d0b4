"""Whole documents of a building as an edit replaces them: copies kept beside the edit log.

``DIR/edits/documents`` holds each copy once, named by what it holds. An edit that replaces documents names the copies
from before and after it, so that it can be finished, undone and done again.
"""

import hashlib
import re
from pathlib import Path, PurePosixPath
from typing import Any, Final

import msgspec

from mansion_msgs_py.allowed_folders import EVERYWHERE, AllowedFolders
from mansion_msgs_py.building_folder import INDEX, file_in
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.editing.changes import DocumentChange
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes, write_atomic

__all__ = ["Documents", "floor_of", "is_scene"]

COPIES: Final = "edits/documents"
"""Where the copies lie in a building's folder."""

_FLOOR: Final = re.compile(r"floors/floor_(-?\d+)/.")
_SCENE: Final = re.compile(r"floors/floor_-?\d+/scene\.json")
_REPORT: Final = "report.json"


def floor_of(path: str) -> int | None:
    """Return the floor that a document belongs to, ``None`` for one of the whole building."""
    match = _FLOOR.match(path)
    return int(match[1]) if match else None


def is_scene(path: str) -> bool:
    """Whether a document is a floor's scene."""
    return _SCENE.fullmatch(path) is not None


class Documents:
    """The documents of a building folder and the copies that edits keep of them.

    Parameters
    ----------
    folder : Path
        The building's folder.
    allowed : AllowedFolders
        Where copies may be kept.
    """

    def __init__(self, folder: Path, allowed: AllowedFolders = EVERYWHERE) -> None:
        self._folder = folder
        self._allowed = allowed
        self._copies = folder / COPIES

    def present(self, path: str) -> bytes | None:
        """Return what a document holds on disk; ``None`` if it does not exist."""
        file = self._folder / path
        return file.read_bytes() if file.is_file() else None

    def replacement(self, path: str, data: bytes | None) -> DocumentChange:
        """Return the change that puts `data` in a document's place, with copies of both kept; ``None`` removes it.

        Raises
        ------
        MansionError
            ``INVALID_PAYLOAD`` for a path that is no document, ``FORBIDDEN`` where copies may not be kept.
        """
        self._require_document(path)
        there = self.present(path)
        before = "" if there is None else self._keep(there)
        return self.kept(DocumentChange(path=path, before=before), data)

    def kept(self, change: DocumentChange, data: bytes | None) -> DocumentChange:
        """Return a change that puts `data` in the document's place instead."""
        return msgspec.structs.replace(change, after="" if data is None else self._keep(data))

    def copy(self, name: str) -> bytes:
        """Return what a stored copy holds.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` where it is missing.
        """
        return read_bytes(self._copies / name, "the copy of a document that an edit replaced")

    def require_unchanged(self, change: DocumentChange) -> None:
        """Refuse a change of a document that says something else by now.

        What other edits derive (revisions, counts of objects, the status of wishes) may differ.

        Raises
        ------
        MansionError
            ``CONFLICT`` naming the document.
        """
        self._require_document(change.path)
        data = self.present(change.path)
        there = None if data is None else _content(change.path, data)
        known = _content(change.path, self.copy(change.before)) if change.before else None
        if there != known:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{change.path} was changed since this edit began, or later edits rest on it; undo those first, or "
                "look again and repeat the edit",
                details={"file": change.path},
            )

    def after(self, change: DocumentChange, revision: int | None = None) -> bytes | None:
        """Return what a document holds after a change, ``None`` where it is taken away; a scene gets a revision."""
        if not change.after:
            return None
        data = self.copy(change.after)
        if revision is not None and is_scene(change.path):
            return encode_bytes(msgspec.json.decode(data) | {"revision": revision}, indent=1)
        return data

    def _keep(self, data: bytes) -> str:
        name = hashlib.sha256(data).hexdigest()[:32]
        self._allowed.check(self._folder)
        file = file_in(self._folder, f"{COPIES}/{name}")
        if not file.is_file():
            write_atomic(file, data, durable=True)
        return name

    def _require_document(self, path: str) -> None:
        parts = PurePosixPath(path).parts
        if not parts or path.startswith("/") or ".." in parts or parts[0] in ("edits", "state"):
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"{path[:200]!r} is not a document of a building; name a file below the building's folder",
                path="$.documents",
            )


def _content(path: str, data: bytes) -> Any:
    """Return the content of a document, without what is derived from others each time an edit lands."""
    if is_scene(path):
        return {**_object(data), "revision": 0}
    if path == INDEX:
        index = _object(data)
        floors = [{**entry, "objects": 0} for entry in index.get("floors", [])]
        return {**index, "floors": floors, "wishes": [], "checks": {**index.get("checks", {}), "objects": 0}}
    if path == _REPORT:
        return {**_object(data), "wishes": []}
    return data


def _object(data: bytes) -> dict[str, Any]:
    return msgspec.json.decode(data, type=dict[str, Any])
