"""Run one episode: observe, act, judge, until the task is done, the agent stops or its steps are used up."""

import hashlib
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import msgspec

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import SkillCall, Task
from mansion_msgs_py.world import SkillResult
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.agents.interface import Agent, Briefing, Pictures, Stop
from mansion_tasks.episodes.episode_folder import episode_folder
from mansion_tasks.episodes.log import EpisodeEnd, EpisodeLog, EpisodeStart, EpisodeStep, StopReason
from mansion_tasks.episodes.observations import Observer, Snapshot
from mansion_tasks.episodes.port import SkillPort, invalid_call
from mansion_tasks.tasks.progress import ProgressTracker

__all__ = ["EpisodeOptions", "agent_seed", "run_episode", "world_digest"]


@dataclass(frozen=True)
class EpisodeOptions:
    """How to run an episode.

    Attributes
    ----------
    seed : int
        Seed of the whole bench; each episode's own comes from it, the task and the agent.
    lessons : tuple of str
        What the agent learned before.
    pictures : callable, optional
        Makes the agent's pictures for a snapshot.
    building : str
        The building as the log names it.
    clock : callable
        The wall's clock, seconds.
    """

    seed: int = 0
    lessons: tuple[str, ...] = ()
    pictures: Callable[[Snapshot], Pictures] | None = None
    building: str = ""
    clock: Callable[[], float] = time.perf_counter


@dataclass
class _EpisodeState:
    """The state of a running episode."""

    steps: list[EpisodeStep] = field(default_factory=list)
    last_call: SkillCall | None = None
    last: SkillResult | None = None
    time: float = 0.0


def run_episode(
    task: Task, building: Path, agent: Agent, port: SkillPort, options: EpisodeOptions | None = None
) -> EpisodeLog:
    """Let an agent do a task in a temporary copy of a building, and return the log; the building stays as it is.

    The episode ends as soon as the goals hold, at the agent's `Stop`, or after ``task.max_steps`` skills. Success is
    what the goals say, never what the agent says.

    Raises
    ------
    MansionError
        ``CONFLICT`` for a task of another building; ``UNAVAILABLE`` when what the agent needs (a model, a node) is not
        there: no verdict on the agent. Any other error of the agent's ends the episode as ``agent_failed``.
    """
    options = options or EpisodeOptions()
    started = options.clock()
    with episode_folder(building, task.start) as folder:
        port.load(folder)
        world, robot = port.world()
        _check_building(task, world)
        tracker = ProgressTracker(task, world, robot.session)
        state = _EpisodeState()
        stop, reason, claimed = _steps(task, agent, port, options, tracker, state)
        score = tracker.score
        end = EpisodeEnd(
            success=score.success,
            retrieval=round(score.retrieval, 6),
            navigation=round(score.navigation, 6),
            steps=len(state.steps),
            stop=stop,
            reason=reason[:500],
            time=state.time,
            digest=world_digest(world, robot),
            claimed=claimed,
            lessons=agent.lessons(),
            seconds=round(options.clock() - started, 3),
        )
    start = EpisodeStart(
        task=task,
        building=options.building or str(building),
        building_id=world.building.building_id,
        agent=agent.name,
        seed=options.seed,
        lessons=list(options.lessons),
    )
    return EpisodeLog(start=start, steps=state.steps, end=end)


def _steps(
    task: Task, agent: Agent, port: SkillPort, options: EpisodeOptions, tracker: ProgressTracker, state: _EpisodeState
) -> tuple[StopReason, str, bool]:
    observer = Observer(port, task, agent.access)
    world, _ = port.world()
    state.time = world.time
    agent.reset(_briefing(task, world, agent, options))
    while True:
        if tracker.observe().success:
            return "success", "the goals hold", True
        if len(state.steps) >= task.max_steps:
            return "step_limit", f"{task.max_steps} skills were called", False
        snapshot = observer.snapshot()
        pictures = options.pictures(snapshot) if options.pictures is not None else None
        seen = observer.observation(snapshot, len(state.steps), state.last_call, state.last, pictures)
        try:
            choice = agent.act(seen)
        except MansionError as error:
            if error.code == ErrorCode.UNAVAILABLE:
                raise
            return "agent_failed", str(error), False
        except Exception as error:
            # Code of the user's: a fault in it ends this episode, and the bench continues.
            return "agent_failed", _place_of(error), False
        if isinstance(choice, Stop):
            return "agent_stopped", choice.reason, choice.done
        if fault := _wrong_type(choice):
            return "agent_failed", fault, False
        call = observer.call(snapshot, choice)
        refusal = call if isinstance(call, str) else ""
        call = choice if isinstance(call, str) else call
        wish = "a number of the picture"
        result = invalid_call(call.skill, refusal, wish) if refusal else port.call(call)
        state.last_call, state.last = choice, result
        step = _step(port, tracker, state, call, result)
        state.steps.append(msgspec.structs.replace(step, refused=bool(refusal), notes=agent.notes()))


def _place_of(error: Exception) -> str:
    """Say what an agent raised, and where."""
    frame = traceback.extract_tb(error.__traceback__)[-1]
    return f"{type(error).__name__}: {error} ({Path(frame.filename).name}, line {frame.lineno})"


def _wrong_type(choice: object) -> str:
    """Return what is wrong with the type that an agent chose, whose code no type checker may have seen."""
    if isinstance(choice, SkillCall):
        return ""
    return f"act() returned {type(choice).__name__}; accepted: SkillCall or Stop"


def _step(
    port: SkillPort, tracker: ProgressTracker, state: _EpisodeState, call: SkillCall, result: SkillResult
) -> EpisodeStep:
    """Judge the world after a skill; only what changed it makes the clock count."""
    world, robot = port.world()
    here, score = world.robot_state(robot), tracker.observe()
    if result.changed:
        state.time = round(world.time, 6)
    return EpisodeStep(
        step=len(state.steps) + 1,
        call=call,
        status=result.status,
        message=result.message,
        floor=here.floor,
        pose=here.pose,
        room=here.room,
        held=here.held,
        time=state.time,
        retrieval=round(score.retrieval, 6),
        navigation=round(score.navigation, 6),
    )


def _briefing(task: Task, world: World, agent: Agent, options: EpisodeOptions) -> Briefing:
    building = world.building
    return Briefing(
        instruction=task.instruction,
        floors=tuple(building.floors),
        labels=tuple(building.label(floor) for floor in building.floors),
        max_steps=task.max_steps,
        seed=agent_seed(options.seed, task.id, agent.name),
        lessons=options.lessons,
        plan=tuple(task.oracle) if agent.access.plan else (),
    )


def _check_building(task: Task, world: World) -> None:
    found = world.building.building_id
    if task.building_id and task.building_id != found:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"task {task.id!r} is for building {task.building_id!r}, not for {found!r}",
            path="$.building_id",
        )


def agent_seed(seed: int, task: str, agent: str) -> int:
    """Return the seed of one episode, the same for any order of episodes and number of processes."""
    digest = hashlib.sha256(f"{seed}\n{task}\n{agent}".encode()).digest()
    return int.from_bytes(digest[:6], "big")


def world_digest(world: World, robot: RobotBody) -> str:
    """Return a digest of all that skills changed: objects, doors and the robot."""
    objects = sorted(world.objects.changed.values(), key=lambda state: state.id)
    state = world.robot_state(robot)
    facts = [objects, sorted(world.doors.items()), [state.floor, state.pose, state.pitch, state.held]]
    return hashlib.sha256(encode_bytes(facts)).hexdigest()[:16]
