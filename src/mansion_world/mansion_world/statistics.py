"""Statistics of a world, from its records in one pass."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

from mansion_msgs_py.codec import decode
from mansion_world.mixture import Mixture
from mansion_world.world_folder import WorldFolder

__all__ = ["Mean", "WorldStatistics", "world_statistics"]


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
    aside : Counter of str
        What was set aside, by sub-kind and reason.
    """

    asked: Mapping[tuple[str, str], float]
    found: Counter[tuple[str, str]] = field(default_factory=Counter)
    floors: Counter[int] = field(default_factory=Counter)
    splits: Counter[str] = field(default_factory=Counter)
    difficulties: Counter[str] = field(default_factory=Counter)
    rooms_by_type: Counter[str] = field(default_factory=Counter)
    aside: Counter[tuple[str, str]] = field(default_factory=Counter)
    floor_area: Mean = field(default_factory=Mean)
    rooms: Mean = field(default_factory=Mean)
    objects: Mean = field(default_factory=Mean)
    megabytes: Mean = field(default_factory=Mean)
    wishes: int = 0
    wishes_met: int = 0

    @property
    def buildings(self) -> int:
        """Number of buildings."""
        return self.found.total()

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
            ],
            "Mixture": [
                (
                    f"{kind}, {part}",
                    f"{self.found[kind, part]} ({_share(self.found[kind, part], self.buildings)}; asked {share:.1%})",
                )
                for (kind, part), share in self.asked.items()
            ],
            "Floors": self._rows({str(floors): self.floors[floors] for floors in sorted(self.floors)}),
            "Difficulty": self._rows(
                {level: self.difficulties[level] for level in ("easy", "medium", "hard", "expert")}
            ),
            "Split": self._rows({split: self.splits[split] for split in ("train", "val", "test")}),
            "Rooms": [
                (name, str(count))
                for name, count in sorted(self.rooms_by_type.items(), key=lambda row: (-row[1], row[0]))[:25]
            ],
            "Set aside": [(f"{part}, {reason}", str(count)) for (part, reason), count in sorted(self.aside.items())],
        }

    def _rows(self, counts: Mapping[str, int]) -> list[tuple[str, str]]:
        return [(name, f"{count} ({_share(count, self.buildings)})") for name, count in counts.items()]


def _share(count: int, whole: int) -> str:
    return f"{count / whole:.1%}" if whole else "-"


def world_statistics(world: WorldFolder) -> WorldStatistics:
    """Return the statistics of a world, its records read one by one.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when there is no world.
    """
    mix = world.index().mix
    statistics = WorldStatistics(decode(Mixture, mix).shares() if mix else {})
    for record in world.records():
        row = record.building
        statistics.found[row.kind, row.sub_kind] += 1
        statistics.floors[row.floors] += 1
        statistics.splits[row.split] += 1
        statistics.difficulties[row.difficulty] += 1
        statistics.rooms_by_type.update(room.type for room in record.rooms)
        for area in row.floor_areas:
            statistics.floor_area.add(area)
        statistics.rooms.add(row.rooms)
        statistics.objects.add(row.objects)
        statistics.megabytes.add(row.bytes / 1e6)
        statistics.wishes += row.wishes
        statistics.wishes_met += row.wishes_met
    statistics.aside.update((entry.request.sub_kind, entry.reason) for entry in world.aside())
    return statistics
