"""Statistics of a world, from its records in one pass."""

from bisect import bisect_right
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final, get_args

from mansion_msgs_py.codec import decode
from mansion_world.mixture import Mixture
from mansion_world.records import SPLITS, Difficulty, Record, TaskRow, Trial, WorldIndex
from mansion_world.trials import read_trials, tried_tasks
from mansion_world.world_folder import WorldFolder

__all__ = ["AGENTS", "CLASSES", "Mean", "WorldStatistics", "world_statistics"]

AGENTS: Final = "Success of agents, by difficulty of the task"
"""Title of the table of agents."""

_TASK_LEVELS: Final = ("easy", "medium", "hard")

CLASSES: Final = {
    "Floor areas, m2": tuple(range(0, 1001, 50)),
    "Objects a building": (0, *(100 * 2**power for power in range(12))),
    "Path lengths of the oracle, m": (0, *(10 * 2**power for power in range(10))),
}
"""Bounds of the classes of values; those with a long tail double."""


@dataclass
class Mean:
    """Number, least, mean and greatest of values that are added one by one."""

    count: int = 0
    total: float = 0.0
    least: float = float("inf")
    most: float = float("-inf")

    def add(self, value: float) -> None:
        """Add a value."""
        self.count += 1
        self.total += value
        self.least, self.most = min(self.least, value), max(self.most, value)

    def __str__(self) -> str:
        if not self.count:
            return "-"
        return f"{self.total / self.count:.1f} ({self.least:.0f} to {self.most:.0f})"


@dataclass
class WorldStatistics:
    """What a world holds.

    Attributes
    ----------
    asked : mapping of (str, str) to float
        Share of each kind and sub-kind in the mixture; empty for a list of briefs.
    found : Counter of (str, str)
        Buildings of each.
    floor_area : Mean
        m2.
    rooms_by_type : Counter
    areas, held, ways : Counter of int
        Floors by area, buildings by objects, and plans of tasks by the metres that the robot drives: each under the
        number of its class in `CLASSES`.
    task_kinds, task_levels, task_floors : Counter
        Tasks by kind, difficulty and number of floors.
    without_tasks : int
        Buildings that have none though some were asked for.
    tried, succeeded : Counter of (str, str)
        Tasks that an agent tried and completed, by agent and difficulty.
    aside : Counter of str
        What was set aside, by sub-kind and reason.
    """

    asked: Mapping[tuple[str, str], float]
    found: Counter[tuple[str, str]] = field(default_factory=Counter)
    floors: Counter[int] = field(default_factory=Counter)
    splits: Counter[str] = field(default_factory=Counter)
    difficulties: Counter[str] = field(default_factory=Counter)
    rooms_by_type: Counter[str] = field(default_factory=Counter)
    areas: Counter[int] = field(default_factory=Counter)
    held: Counter[int] = field(default_factory=Counter)
    ways: Counter[int] = field(default_factory=Counter)
    task_kinds: Counter[str] = field(default_factory=Counter)
    task_levels: Counter[str] = field(default_factory=Counter)
    task_floors: Counter[int] = field(default_factory=Counter)
    tried: Counter[tuple[str, str]] = field(default_factory=Counter)
    succeeded: Counter[tuple[str, str]] = field(default_factory=Counter)
    aside: Counter[tuple[str, str]] = field(default_factory=Counter)
    floor_area: Mean = field(default_factory=Mean)
    rooms: Mean = field(default_factory=Mean)
    objects: Mean = field(default_factory=Mean)
    megabytes: Mean = field(default_factory=Mean)
    way: Mean = field(default_factory=Mean)
    without_tasks: int = 0
    undone: int = 0
    wishes: int = 0
    wishes_met: int = 0

    @property
    def buildings(self) -> int:
        """Number of buildings."""
        return self.found.total()

    @property
    def tasks(self) -> int:
        """Number of tasks."""
        return self.task_kinds.total()

    def distributions(self) -> dict[str, dict[str, int]]:
        """Return counts by value or class of values, titled."""
        classes = zip(CLASSES.items(), (self.areas, self.held, self.ways), strict=True)
        areas, held, ways = ({title: _classes(counts, bounds)} for (title, bounds), counts in classes)
        return {
            "Floors": {str(floors): self.floors[floors] for floors in sorted(self.floors)},
            **areas,
            **held,
            "Difficulty": {level: self.difficulties[level] for level in get_args(Difficulty)},
            "Split": {split: self.splits[split] for split in SPLITS},
            "Tasks": {kind: self.task_kinds[kind] for kind in sorted(self.task_kinds)},
            "Floors of a task": {str(floors): self.task_floors[floors] for floors in sorted(self.task_floors)},
            "Difficulty of tasks": {level: self.task_levels[level] for level in _TASK_LEVELS if self.task_levels},
            **ways,
        }

    def success(self) -> dict[tuple[str, str], float]:
        """Return the share of tasks that each agent did, by agent and difficulty."""
        agents = dict.fromkeys(agent for agent, _ in self.tried)
        pairs = ((agent, level) for agent in agents for level in _TASK_LEVELS)
        return {pair: self.succeeded[pair] / self.tried[pair] for pair in pairs if self.tried[pair]}

    def tables(self) -> dict[str, list[tuple[str, str]]]:
        """Return the statistics as titled rows of text."""
        return {
            "World": [
                ("buildings", str(self.buildings)),
                ("floor area, m2", str(self.floor_area)),
                ("rooms a building", str(self.rooms)),
                ("objects a building", str(self.objects)),
                ("megabytes a building", str(self.megabytes)),
                ("wishes met", f"{self.wishes_met} of {self.wishes}"),
                ("tasks", str(self.tasks)),
                ("path length of a task, m", str(self.way)),
                ("drafted tasks that the oracle could not do", str(self.undone)),
                ("buildings without a task that can be done", str(self.without_tasks)),
            ],
            "Mixture": [
                (
                    f"{kind}, {part}",
                    f"{self.found[kind, part]} ({_share(self.found[kind, part], self.buildings)}; asked {share:.1%})",
                )
                for (kind, part), share in self.asked.items()
            ],
            **{title: _rows(counts) for title, counts in self.distributions().items()},
            AGENTS: [
                (f"{agent}, {level}", f"{share:.1%} of {self.tried[agent, level]}")
                for (agent, level), share in self.success().items()
            ],
            "Rooms": [
                (name, str(count))
                for name, count in sorted(self.rooms_by_type.items(), key=lambda row: (-row[1], row[0]))[:25]
            ],
            "Set aside": [(f"{part}, {reason}", str(count)) for (part, reason), count in sorted(self.aside.items())],
        }


def _rows(counts: Mapping[str, int]) -> list[tuple[str, str]]:
    whole = sum(counts.values())
    return [(name, f"{count} ({_share(count, whole)})") for name, count in counts.items()]


def _classes(counts: Mapping[int, int], bounds: Sequence[int]) -> dict[str, int]:
    """Return counts of classes by their bounds, from the first that holds something to the last."""
    if not counts:
        return {}
    named = [*(f"{low} to {high}" for low, high in pairwise(bounds)), f"{bounds[-1]} and more"]
    return {named[number]: counts.get(number, 0) for number in range(min(counts), max(counts) + 1)}


def _class(title: str, value: float) -> int:
    return bisect_right(CLASSES[title], value) - 1


def _share(count: int, whole: int) -> str:
    return f"{count / whole:.1%}" if whole else "-"


def world_statistics(world: WorldFolder) -> WorldStatistics:
    """Return the statistics of a world, its records read one by one.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when there is no world.
    """
    statistics = WorldStatistics(_asked(world.index()))
    for record in world.records():
        _add_building(statistics, record)
        _add_tasks(statistics, record)
    for task, trial in tried_tasks(world, read_trials(world)):
        _add_trial(statistics, task, trial)
    statistics.aside.update((entry.request.sub_kind, entry.reason) for entry in world.aside())
    return statistics


def _asked(index: WorldIndex) -> dict[tuple[str, str], float]:
    """Return the shares that were asked: of a joined world the mean over its sources, by their buildings."""
    if not index.sources:
        return _shares(index.mix)
    whole = sum(source.buildings for source in index.sources) or 1
    asked: dict[tuple[str, str], float] = {}
    for source in index.sources:
        for name, share in _shares(source.mix).items():
            asked[name] = asked.get(name, 0.0) + share * source.buildings / whole
    return asked


def _shares(mix: str) -> dict[tuple[str, str], float]:
    return decode(Mixture, mix).shares() if mix else {}


def _add_building(statistics: WorldStatistics, record: Record) -> None:
    row = record.building
    statistics.found[row.kind, row.sub_kind] += 1
    statistics.floors[row.floors] += 1
    statistics.splits[row.split] += 1
    statistics.difficulties[row.difficulty] += 1
    statistics.rooms_by_type.update(room.type for room in record.rooms)
    for area in row.floor_areas:
        statistics.floor_area.add(area)
        statistics.areas[_class("Floor areas, m2", area)] += 1
    statistics.rooms.add(row.rooms)
    statistics.objects.add(row.objects)
    statistics.held[_class("Objects a building", row.objects)] += 1
    statistics.megabytes.add(row.bytes / 1e6)
    statistics.wishes += row.wishes
    statistics.wishes_met += row.wishes_met


def _add_tasks(statistics: WorldStatistics, record: Record) -> None:
    statistics.undone += record.building.tasks_undone
    statistics.without_tasks += bool(record.building.no_tasks)
    for task in record.tasks:
        statistics.task_kinds[task.kind] += 1
        statistics.task_levels[task.difficulty] += 1
        statistics.task_floors[task.floors] += 1
        statistics.way.add(task.metres)
        statistics.ways[_class("Path lengths of the oracle, m", task.metres)] += 1


def _add_trial(statistics: WorldStatistics, task: TaskRow, trial: Trial) -> None:
    statistics.tried[trial.agent, task.difficulty] += 1
    statistics.succeeded[trial.agent, task.difficulty] += trial.success
