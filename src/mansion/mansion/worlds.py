"""Worlds of many buildings: read one by one, or built from a list of briefs."""

from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

from mansion.briefs import request_of
from mansion.building import Building
from mansion.making import load
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_world.lists import BriefList, NamedRequest, Result
from mansion_world.records import SPLITS, BuildingRow, Difficulty
from mansion_world.world_folder import WorldFolder

__all__ = ["World", "WorldBuilding", "build_all"]


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


def build_all(briefs: str | Path | Sequence[str | BuildRequest], folder: str | Path, *, jobs: int = 1) -> list[Result]:
    """Build many briefs, as ``mansion build --from`` does, or go on with them.

    Parameters
    ----------
    briefs : path, or sequence of str or BuildRequest
        A file of them (``.txt``, ``.csv`` or ``.jsonl``), or themselves; those need no names.
    folder : path
        Gets the buildings and ``table.csv``.
    jobs : int
        Buildings in work at once, each in a process of its own where there are several: a script then needs
        ``if __name__ == "__main__":``.

    Returns
    -------
    list of Result
        What became of each brief: `name`, `path` of its building in `folder` (for `load`), number of `floors`, `rooms`
        and `objects`, or the `reason` why there is none.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming the lines of a file that are no briefs, ``CONFLICT`` for a folder that holds
        something else.
    """
    from mansion_bringup.lists import build_list
    from mansion_bringup.worlds import world_workers
    from mansion_world.brief_files import read_briefs

    if isinstance(briefs, (str, Path)):
        named = read_briefs(Path(briefs))
    else:
        named = [NamedRequest(request=request_of(brief, None)) for brief in briefs]
    workers = world_workers(jobs) if jobs > 1 else (lambda: ThreadPoolExecutor(1))
    return build_list(BriefList.of(named), Path(folder), workers=workers, jobs=jobs)


def _known(name: str, value: str | None, known: tuple[str, ...]) -> str | None:
    if value is not None and value not in known:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"unknown {name} {value!r}; use {', '.join(known)}")
    return value
