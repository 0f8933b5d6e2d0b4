"""Results of a bench: a row for each episode; rates and means with 95% intervals by agent and number of floors."""

from collections.abc import Sequence
from math import sqrt

import msgspec
import numpy as np

from mansion_msgs_py.task import Difficulty, TaskKind
from mansion_tasks.episodes.log import EpisodeLog, StopReason

__all__ = [
    "BenchResult",
    "EpisodeRow",
    "GroupRow",
    "bootstrap_interval",
    "render",
    "row_of",
    "summarise",
    "wilson_interval",
]

Z = 1.959963984540054
"""Quantile of the normal distribution for 95% intervals."""


def wilson_interval(successes: int, trials: int) -> tuple[float, float]:
    """Return the 95% score interval of a rate (Wilson, 1927).

    Examples
    --------
    >>> low, high = wilson_interval(10, 10)
    >>> round(low, 3), high
    (0.722, 1.0)
    """
    if trials == 0:
        return 0.0, 1.0
    rate, square = successes / trials, Z * Z / trials
    middle = rate + square / 2
    half = Z * sqrt(rate * (1 - rate) / trials + square / (4 * trials))
    low, high = (middle - half) / (1 + square), (middle + half) / (1 + square)
    return (0.0 if successes == 0 else low), (1.0 if successes == trials else high)


def bootstrap_interval(values: Sequence[float], *, resamples: int = 1000, seed: int = 0) -> tuple[float, float]:
    """Return the 95% percentile interval of a mean, from resamples with replacement.

    Examples
    --------
    >>> bootstrap_interval([0.5, 0.5, 0.5])
    (0.5, 0.5)
    """
    if not values:
        return 0.0, 0.0
    data = np.asarray(values, dtype=float)
    picks = np.random.default_rng(seed).integers(len(data), size=(resamples, len(data)))
    low, high = np.percentile(data[picks].mean(axis=1), [2.5, 97.5])
    return float(low), float(high)


class EpisodeRow(msgspec.Struct, frozen=True, kw_only=True):
    """One episode; `log` is its file, relative to the results."""

    agent: str
    task: str
    building: str
    kind: TaskKind
    difficulty: Difficulty
    floors: int
    success: bool
    retrieval: float
    navigation: float
    steps: int
    time: float
    stop: StopReason
    reason: str
    seconds: float
    log: str = ""


class GroupRow(msgspec.Struct, frozen=True, kw_only=True):
    """The episodes of an agent that span a number of floors (0 for all), with 95% intervals.

    Attributes
    ----------
    steps, time, seconds : float
        Means: skills called, seconds on the world's clock, seconds on the wall.
    """

    agent: str
    floors: int
    episodes: int
    success: float
    success_interval: tuple[float, float]
    retrieval: float
    retrieval_interval: tuple[float, float]
    navigation: float
    navigation_interval: tuple[float, float]
    steps: float
    time: float
    seconds: float


class BenchResult(msgspec.Struct, frozen=True, kw_only=True):
    """The content of ``results.json``."""

    seed: int
    graph: bool
    summary: list[GroupRow]
    episodes: list[EpisodeRow]
    schema_version: int = 1


def row_of(log: EpisodeLog, file: str = "") -> EpisodeRow:
    """Return an episode as a row."""
    task, end = log.start.task, log.end
    return EpisodeRow(
        agent=log.start.agent,
        task=task.id,
        building=log.start.building_id,
        kind=task.kind,
        difficulty=task.difficulty,
        floors=task.floors_spanned,
        success=end.success,
        retrieval=end.retrieval,
        navigation=end.navigation,
        steps=end.steps,
        time=end.time,
        stop=end.stop,
        reason=end.reason,
        seconds=end.seconds,
        log=file,
    )


def summarise(rows: Sequence[EpisodeRow]) -> list[GroupRow]:
    """Return the groups of the rows: agents in their order, floors ascending, then all floors."""
    found = []
    for agent in dict.fromkeys(row.agent for row in rows):
        own = [row for row in rows if row.agent == agent]
        found += [
            _group(agent, floors, [row for row in own if row.floors == floors])
            for floors in sorted({row.floors for row in own})
        ]
        found.append(_group(agent, 0, own))
    return found


def _group(agent: str, floors: int, rows: Sequence[EpisodeRow]) -> GroupRow:
    count = len(rows)
    successes = sum(row.success for row in rows)
    retrieval = [row.retrieval for row in rows]
    navigation = [row.navigation for row in rows]
    return GroupRow(
        agent=agent,
        floors=floors,
        episodes=count,
        success=successes / count,
        success_interval=wilson_interval(successes, count),
        retrieval=sum(retrieval) / count,
        retrieval_interval=bootstrap_interval(retrieval),
        navigation=sum(navigation) / count,
        navigation_interval=bootstrap_interval(navigation),
        steps=sum(row.steps for row in rows) / count,
        time=sum(row.time for row in rows) / count,
        seconds=sum(row.seconds for row in rows) / count,
    )


def render(groups: Sequence[GroupRow]) -> str:
    """Return the groups as a Markdown table; rates in percent, with their intervals."""
    lines = [
        "| agent | floors | episodes | success % | retrieval % | navigation % | steps | time, s |",
        "| --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    for group in groups:
        cells = [
            group.agent,
            str(group.floors) if group.floors else "all",
            str(group.episodes),
            _percent(group.success, group.success_interval),
            _percent(group.retrieval, group.retrieval_interval),
            _percent(group.navigation, group.navigation_interval),
            f"{group.steps:.1f}",
            f"{group.time:.0f}",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def _percent(value: float, interval: tuple[float, float]) -> str:
    low, high = interval
    return f"{100 * value:.1f} [{100 * low:.1f}, {100 * high:.1f}]"
