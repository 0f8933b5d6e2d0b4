"""Many episodes: every agent at every task, over processes, resuming where an interrupted run ended."""

from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

from mansion_msgs_py.building_folder import is_building_folder
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.task import Task, TaskSet, read_task_set
from mansion_msgs_py.world import Progress
from mansion_tasks.agents.interface import Agent
from mansion_tasks.agents.registry import LEARNING, check_agents, make_agent
from mansion_tasks.episodes.camera_pictures import CameraPictures
from mansion_tasks.episodes.log import EpisodeLog, read_log, write_log
from mansion_tasks.episodes.port import LocalPort, SkillPort
from mansion_tasks.episodes.results import BenchResult, EpisodeRow, row_of, summarise
from mansion_tasks.episodes.running import EpisodeOptions, run_episode
from mansion_tasks.episodes.worker_pool import in_processes

__all__ = ["TAKEN_OVER", "Bench", "Ports", "Unit", "local_port", "log_path", "run_bench", "run_unit"]

TAKEN_OVER = "taken over"
"""Stage of the progress of an episode that an earlier run finished."""

MAX_LESSONS = 20
"""Lessons of earlier episodes that an agent is known_lessons, the newest."""

Ports = Callable[[], AbstractContextManager[SkillPort]]


@contextmanager
def local_port() -> Iterator[SkillPort]:
    """Yield the skills of this process."""
    yield LocalPort()


@dataclass(frozen=True)
class Bench:
    """What to run.

    Attributes
    ----------
    files : tuple of Path
        Task sets.
    agents : tuple of str
    output : Path
        Folder of logs and results.
    ports : callable
        Makes the way to the robot, in the process that runs the episodes; a function of a module.
    graph : bool
        Whether `ports` goes through a node graph, for the record.
    """

    files: tuple[Path, ...]
    agents: tuple[str, ...]
    output: Path
    seed: int = 0
    ports: Ports = local_port
    graph: bool = False


@dataclass(frozen=True)
class Unit:
    """One agent at the tasks of one file, in their order; what runs in one process."""

    bench: Bench
    agent: str
    file: Path


def run_bench(
    bench: Bench, *, jobs: int = 1, progress: Callable[[Progress], None] = lambda payload: None
) -> BenchResult:
    """Run every episode that has no log yet, and write ``results.json``.

    Parameters
    ----------
    bench : Bench
    jobs : int
        Processes; apart from wall times the results are the same for any number.
    progress : callable
        Told of each episode as it ends; stage `TAKEN_OVER` where it was read from its log.

    Raises
    ------
    MansionError
        For files that are not task sets, agents that do not exist, or a model or node that is not available. Logs of
        finished episodes stay, so that the same call continues from them.
    """
    check_agents(list(bench.agents))
    total = sum(len(read_task_set(file).tasks) for file in bench.files) * len(bench.agents)
    units = [Unit(bench, agent, file) for agent in bench.agents for file in bench.files]
    rows_of_unit: list[list[EpisodeRow]] = [[] for _ in units]
    episodes_of_units = in_processes(run_unit, units, jobs) if jobs > 1 else _in_this_process(units)
    with closing(episodes_of_units) as episodes:
        for done, (number, (row, taken_over)) in enumerate(episodes, start=1):
            rows_of_unit[number].append(row)
            text = f"{row.agent}: {row.task}, {row.stop}"
            stage = TAKEN_OVER if taken_over else "bench"
            progress(Progress(stage=stage, message=text, done=done, total=total))
    rows = [row for unit in rows_of_unit for row in unit]
    result = BenchResult(seed=bench.seed, graph=bench.graph, summary=summarise(rows), episodes=rows)
    write_atomic(bench.output / "results.json", encode_bytes(result, indent=1))
    return result


def _in_this_process(units: Sequence[Unit]) -> Generator[tuple[int, tuple[EpisodeRow, bool]]]:
    for number, unit in enumerate(units):
        for found in run_unit(unit):
            yield number, found


def run_unit(unit: Unit) -> Iterator[tuple[EpisodeRow, bool]]:
    """Yield the episodes of a unit, and whether each was read from the log of an earlier run.

    The way to the robot is made for the first episode that has to run.
    """
    tasks = read_task_set(unit.file)
    building = (unit.file.parent / tasks.building).resolve()
    lessons: list[str] = []
    with ExitStack() as stack:
        access: tuple[SkillPort, CameraPictures | None] | None = None
        for task in tasks.tasks:
            known_lessons = tuple(lessons[-MAX_LESSONS:]) if unit.agent in LEARNING else ()
            path = log_path(unit, tasks, task)
            earlier = _finished(path, unit, task, known_lessons)
            log = earlier
            if log is None:
                _check_building(unit.file, building)
                # A new agent for each episode: what one brings to the next are its lessons alone.
                agent = make_agent(unit.agent)
                access = access or _robot_access(unit, agent, stack)
                port, pictures = access
                options = EpisodeOptions(
                    seed=unit.bench.seed, lessons=known_lessons, pictures=pictures, building=str(building)
                )
                log = run_episode(task, building, agent, port, options)
                write_log(path, log)
            lessons += log.end.lessons
            yield row_of(log, str(path.relative_to(unit.bench.output))), earlier is not None


def _check_building(file: Path, building: Path) -> None:
    if not is_building_folder(building):
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"{building} holds no building.json, but {file} names it as its building; put both back, or make the "
            "tasks again with `mansion task generate`",
            path="$.building",
        )


def _robot_access(unit: Unit, agent: Agent, stack: ExitStack) -> tuple[SkillPort, CameraPictures | None]:
    """Make what all episodes of a unit need."""
    pictures = stack.enter_context(CameraPictures()) if agent.access.pictures else None
    return stack.enter_context(unit.bench.ports()), pictures


def log_path(unit: Unit, tasks: TaskSet, task: Task) -> Path:
    """Return where an episode's log is; two files of tasks of one building may share task ids."""
    name = f"{tasks.building_id}_{unit.file.stem}"
    return unit.bench.output / "episodes" / unit.agent / name / f"{task.id}.jsonl"


def _finished(path: Path, unit: Unit, task: Task, known_lessons: tuple[str, ...]) -> EpisodeLog | None:
    """Return the log of the same episode, if an earlier run finished it."""
    if not path.exists():
        return None
    try:
        log = read_log(path)
    except MansionError:
        return None
    start = log.start
    same = start.task == task and start.seed == unit.bench.seed and start.lessons == list(known_lessons)
    return log if same and start.agent == unit.agent else None
