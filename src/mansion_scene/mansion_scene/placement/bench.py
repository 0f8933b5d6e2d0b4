"""``mansion bench placement``: place rooms under several seeds and print what the placements reach, room by room."""

from collections.abc import Iterable, Sequence

import numpy as np

from mansion_msgs_py.placement import PlacementResult, PlacementRoom
from mansion_scene.placement.files import place_timed
from mansion_scene.placement.measure import Measures, measure
from mansion_scene.placement.options import PlacementOptions

__all__ = ["bench", "table"]

_COLUMNS = (
    *("asked", "placed", "cover%", "usable%", "reach%", "out", "hit", "door"),
    *("pair%", "arnd%", "rel%", "back%", "rowdev", "coldev", "cpu s", "worst"),
)


def bench(
    rooms: Sequence[PlacementRoom], seeds: Iterable[int], options: PlacementOptions | None = None
) -> dict[str, list[tuple[PlacementResult, Measures]]]:
    """Place every room with every seed in this process.

    Returns
    -------
    dict
        Placement and measures of each run, by room id.
    """
    from mansion_scene.placement import warm

    warm()
    chosen = options or PlacementOptions()
    numbers = list(seeds)
    runs: dict[str, list[tuple[PlacementResult, Measures]]] = {}
    for room in rooms:
        results = [place_timed(room, seed, chosen) for seed in numbers]
        runs[room.room_id] = [(result, measure(room, result)) for result in results]
    return runs


def table(measures: dict[str, list[Measures]]) -> str:
    """Return a text table: a line for each room, its runs averaged, and one over all rooms."""
    lines = [f"{'room':<20}" + "".join(f"{name:>8}" for name in _COLUMNS)]
    for name, runs in measures.items():
        lines.append(_line(name, runs, len(runs)))
    every = [run for runs in measures.values() for run in runs]
    count = max((len(runs) for runs in measures.values()), default=1)
    lines.append(_line("all rooms", every, count))
    return "\n".join(lines)


def _line(name: str, runs: Sequence[Measures], count: int) -> str:
    def total(field: str) -> float:
        return float(sum(getattr(run, field) for run in runs))

    def percent(part: str, whole: str) -> str:
        return f"{100.0 * total(part) / total(whole):.1f}" if total(whole) else "-"

    cells = [
        f"{total('asked') / count:.0f}",
        f"{total('placed') / count:.1f}",
        percent("placed", "asked"),
        percent("usable", "asked"),
        percent("reachable", "placed"),
        f"{total('outside'):.0f}",
        f"{total('collisions'):.0f}",
        f"{total('blocked'):.0f}",
        percent("pairs_near", "pairs"),
        percent("around_near", "around"),
        percent("relations_held", "relations"),
        percent("edges_backed", "edges"),
        f"{np.mean([run.row_deviation for run in runs]):.2f}",
        f"{np.mean([run.column_deviation for run in runs]):.2f}",
        f"{np.mean([run.seconds for run in runs]):.3f}",
        f"{max(run.seconds for run in runs):.3f}",
    ]
    return f"{name[:20]:<20}" + "".join(f"{cell:>8}" for cell in cells)
