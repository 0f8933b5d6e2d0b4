"""Worlds of many buildings: read one by one, or built from a list of briefs."""

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_args

from mansion.briefs import request_of
from mansion.building import Building
from mansion.making import load
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.request import BuildRequest
from mansion_world.brief_list import BriefList, NamedRequest, Result
from mansion_world.records import SPLITS, BuildingRow, Difficulty
from mansion_world.world_folder import WorldFolder

if TYPE_CHECKING:
    import gymnasium

    from mansion_tasks.env.bounds import Bounds

__all__ = ["World", "WorldBuilding", "build_all"]


@dataclass(frozen=True)
class WorldBuilding:
    """A building of a world, not opened yet.

    Attributes
    ----------
    row : BuildingRow
        Its row in the manifest: description, kind, split, difficulty, floors, rooms, objects, ...
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

    def env(
        self, *, split: str | None = None, difficulty: str | None = None, kind: str | None = None, **options: Any
    ) -> "gymnasium.Env[Mapping[str, Any], Any]":
        """Return a Gymnasium environment with another building each reset, and one of the building's tasks.

        Its spaces are the same for all buildings of the world, whatever their split: a policy that is trained in some
        acts in the others. Buildings in which no task can be done are left out.

        Parameters
        ----------
        split, difficulty, kind : str, optional
            Only these buildings; see `filter`.
        **options
            ``actions``, ``observation``, ``image_size``, ``max_steps``, ``task_seed``, ``render_mode``: see
            `mansion_tasks.env.buildings_env.BuildingsEnv`, and what ``gymnasium.make`` takes.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` where there is no such building, ``UNAVAILABLE`` naming the extra ``sim`` where that is
            missing.
        """
        with importing:
            from mansion_bringup.extras import require_extra

        require_extra("sim")
        with importing:
            import gymnasium

            from mansion_tasks.env import BUILDINGS_ENV_ID

        chosen = self.filter(split=split, difficulty=difficulty, kind=kind)
        folders = [entry.folder for entry in chosen if not entry.row.no_tasks]
        if not folders:
            raise MansionError(ErrorCode.NOT_FOUND, f"{self.folder} has no building of that kind with a task")
        made: gymnasium.Env[Mapping[str, Any], Any] = gymnasium.make(
            BUILDINGS_ENV_ID, buildings=folders, bounds=self._bounds(), **options
        )
        return made

    def _bounds(self) -> "Bounds":
        """Return what the spaces of an environment need for every building of the world."""
        with importing:
            from mansion_assets.catalogue import load_catalogue
            from mansion_tasks.env.bounds import Bounds

        rooms = floors = landmarks = 1
        for row in self._files.manifest():
            rooms, floors = max(rooms, row.rooms), max(floors, row.floors)
            landmarks = max(landmarks, row.landmarks)
        return Bounds(tuple(sorted(load_catalogue().categories)), rooms, floors, landmarks)

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
        Buildings made at once, each in a process of its own where there are several: a script then needs
        ``if __name__ == "__main__":``.

    Returns
    -------
    list of Result
        What became of each brief: `name`, `path` of its building in `folder` (for `load`), number of `floors`, `rooms`
        and `objects`, or the `reason` why there is none.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming the lines of a file that are not briefs, ``CONFLICT`` for a folder that holds
        something else.
    """
    with importing:
        from mansion_bringup.build_list import build_list
        from mansion_bringup.plan_files import plan_from_file
        from mansion_bringup.worlds import world_workers
        from mansion_world.brief_files import read_briefs

    if isinstance(briefs, (str, Path)):
        named = read_briefs(Path(briefs), read_plan=plan_from_file)
    else:
        named = [NamedRequest(request=request_of(brief, None)) for brief in briefs]
    workers = world_workers(jobs) if jobs > 1 else (lambda: ThreadPoolExecutor(1))
    return build_list(BriefList.of(named), Path(folder), workers=workers, jobs=jobs)


def _known(name: str, value: str | None, known: tuple[str, ...]) -> str | None:
    if value is not None and value not in known:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"unknown {name} {value!r}; use {', '.join(known)}")
    return value
