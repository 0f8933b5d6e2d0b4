"""A world of many buildings, read one by one."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

from mansion.building import Building
from mansion.making import load
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_world.records import SPLITS, BuildingRow, Difficulty
from mansion_world.world_folder import WorldFolder

__all__ = ["World", "WorldBuilding"]


@dataclass(frozen=True)
class WorldBuilding:
    """A building of a world, not opened yet.

    Attributes
    ----------
    row : BuildingRow
        What the manifest says of it: description, kind, split, difficulty, floors, rooms, objects, ...
    folder : Path
    """

    row: BuildingRow
    folder: Path

    def open(self) -> Building:
        """Return the building, as `mansion.load` does."""
        return load(self.folder)


class World:
    """The buildings of a folder that ``mansion world make`` wrote.

    Iterating reads the manifest line by line; no building is opened before it is asked to.

    Parameters
    ----------
    folder : path
    split : {"train", "val", "test"}, optional
        Only these; all when absent.
    difficulty : {"easy", "medium", "hard", "expert"}, optional
    kind : str, optional
        Kind or sub-kind.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a folder without a world, ``INVALID_PAYLOAD`` for a split or a difficulty that there is not.
    """

    def __init__(
        self, folder: str | Path, *, split: str | None = None, difficulty: str | None = None, kind: str | None = None
    ) -> None:
        self.folder = Path(folder)
        self._files = WorldFolder(self.folder)
        self._files.index()
        self._split = _known("split", split, SPLITS)
        self._difficulty = _known("difficulty", difficulty, get_args(Difficulty))
        self._kind = kind

    def filter(self, *, split: str | None = None, difficulty: str | None = None, kind: str | None = None) -> "World":
        """Return the world with only the buildings of a split, a difficulty or a kind; what is absent stays."""
        return World(
            self.folder, split=split or self._split, difficulty=difficulty or self._difficulty, kind=kind or self._kind
        )

    def __iter__(self) -> Iterator[WorldBuilding]:
        for row in self._files.manifest():
            if self._holds(row):
                yield WorldBuilding(row, self.folder / row.path)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def _holds(self, row: BuildingRow) -> bool:
        return (
            self._split in (None, row.split)
            and self._difficulty in (None, row.difficulty)
            and self._kind in (None, row.kind, row.sub_kind)
        )


def _known(name: str, value: str | None, known: tuple[str, ...]) -> str | None:
    if value is not None and value not in known:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"unknown {name} {value!r}; use {', '.join(known)}")
    return value
