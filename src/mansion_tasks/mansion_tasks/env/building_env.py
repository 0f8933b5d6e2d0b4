"""``mansion/Building-v0``: a robot with a task in a building, as a Gymnasium environment."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, Final, Literal, TypeAlias

import gymnasium
import numpy as np

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.task import ProgressScore, Task, read_task_set
from mansion_msgs_py.world import SkillStatus
from mansion_tasks.env.bounds import FAR, Bounds, action_space, observation_space
from mansion_tasks.env.low_level import Outcome, act, low_level_actions
from mansion_tasks.env.observations import SLOTS, ObservationEncoder, Values, Vocabulary
from mansion_tasks.env.skill_level import SKILL_ACTIONS, skill_call
from mansion_tasks.env.visibility import VisibilityIndex
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.progress import ProgressTracker
from mansion_tasks.tasks.sandbox import SESSION, Sandbox

__all__ = ["BuildingEnv"]

Actions: TypeAlias = Literal["low", "skill"]
Observations: TypeAlias = Literal["state", "rgb", "rgbd"]

MOVES_PER_SKILL: Final = 20
"""Low-level steps that an episode may take for each skill that its task allows."""

TASKS_MADE: Final = 10
"""Tasks that are made where none are given."""


class BuildingEnv(gymnasium.Env[Values, Any]):  # type: ignore[misc]
    """One robot, one task at a time; a reset puts the building back to how it was built.

    The reward is the rise of the progress score, retrieval and navigation a quarter each, and a half for success.
    ``terminated`` is success; ``truncated`` means that the steps are used up.

    Parameters
    ----------
    building : path
        Folder that ``mansion build`` wrote; nothing is written to it.
    tasks : path or sequence of Task, optional
        A file of ``mansion task generate``; ten tasks are made with `task_seed` when absent.
    actions : {"low", "skill"}
        ``low``: ``Discrete``, named by `action_names`. ``skill``: ``MultiDiscrete`` of skill (`action_names`), landmark
        of this floor, object in view (as the observation lists them), floor.
    observation : {"state", "rgb", "rgbd"}
        Pictures come on top of the state.
    image_size : (int, int)
        Width and height, pixels.
    max_steps : int, optional
        Most steps of an episode; by default the task's own limit, times 20 for low-level actions.
    render_mode : {"rgb_array"}, optional
    bounds : Bounds, optional
        Bounds of the spaces, to share them with other buildings; the building's own when absent.

    Attributes
    ----------
    vocabulary : Vocabulary
    action_names : tuple of str
    tasks : list of Task

    Raises
    ------
    MansionError
        ``NOT_FOUND`` without a building or for an unknown task; ``INVALID_PAYLOAD`` for other values of the options.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 4}  # noqa: RUF012

    def __init__(
        self,
        building: str | Path,
        *,
        tasks: str | Path | Sequence[Task] | None = None,
        task_seed: int = 0,
        actions: Actions = "low",
        observation: Observations = "state",
        image_size: tuple[int, int] = (300, 300),
        max_steps: int | None = None,
        render_mode: str | None = None,
        bounds: Bounds | None = None,
    ) -> None:
        _check_option("actions", actions, ("low", "skill"))
        _check_option("observation", observation, ("state", "rgb", "rgbd"))
        _check_option("render_mode", render_mode, (None, "rgb_array"))
        self.render_mode = render_mode
        self._sandbox = Sandbox(building)
        self.tasks = _tasks(tasks, self._sandbox, task_seed)
        self.vocabulary = Vocabulary.of(self._sandbox)
        if bounds is not None:
            self.vocabulary = replace(self.vocabulary, categories=bounds.categories)
        self._describer = ObservationEncoder(self._sandbox, self.vocabulary)
        self._visibility = VisibilityIndex(self._sandbox.world)
        self._low = actions == "low"
        self._pictures = observation
        self._size = image_size
        self._most = max_steps
        self._camera: Any = None
        self._task: Task | None = None
        bounds = bounds or Bounds.of(self._sandbox)
        self.observation_space = observation_space(bounds, observation, image_size)
        self.action_space = action_space(bounds, actions)
        self.action_names = tuple(low_level_actions(list(self.vocabulary.floors))) if self._low else SKILL_ACTIONS

    @property
    def task(self) -> Task:
        """The task of this episode."""
        if self._task is None:
            raise MansionError(ErrorCode.NOT_LOADED, "no episode has begun; call reset first")
        return self._task

    @property
    def sandbox(self) -> Sandbox:
        """The world, for whoever judges or draws it."""
        return self._sandbox

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Values, dict[str, Any]]:
        """Begin an episode: of the task that ``options["task"]`` names (id or index), else of a random one."""
        super().reset(seed=seed)
        self._task = self._chosen((options or {}).get("task"))
        self._sandbox.reset(self._task.start)
        self._visibility.world_changed()
        self._tracker = ProgressTracker(self._task, self._sandbox.world, SESSION)
        self._goal = self._describer.goal(self._task)
        scale = MOVES_PER_SKILL if self._low else 1
        self._limit = self._most or self._task.max_steps * scale
        self._steps = 0
        self._observe()
        info = self._info(Outcome(SkillStatus.SUCCESS, "the episode begins"))
        return self._values(), {**info, "instruction": self._task.instruction}

    def _chosen(self, wanted: object) -> Task:
        if wanted is None:
            return self.tasks[int(self.np_random.integers(len(self.tasks)))]
        for index, task in enumerate(self.tasks):
            if wanted in (index, task.id):
                return task
        known = ", ".join(task.id for task in self.tasks)
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no task {wanted!r}; tasks are {known}")

    def step(self, action: Any) -> tuple[Values, float, bool, bool, dict[str, Any]]:
        """Do an action; one that cannot be done changes nothing, and ``info["status"]`` says so."""
        before = self._running_tracker().score
        outcome = self._act(action)
        self._steps += 1
        if outcome.changed:
            self._visibility.world_changed()
        score = self._observe()
        truncated = self._steps >= self._limit and not score.success
        reward = _potential(score) - _potential(before)
        return self._values(), reward, score.success, truncated, self._info(outcome)

    def _running_tracker(self) -> ProgressTracker:
        if self._task is None:
            raise MansionError(ErrorCode.NOT_LOADED, "no episode has begun; call reset first")
        return self._tracker

    def _act(self, action: Any) -> Outcome:
        sandbox = self._sandbox
        if self._low and int(action) >= len(self.action_names):
            return Outcome(SkillStatus.INVALID_ACTION, "this building has fewer floors")
        if self._low:
            outcome = act(sandbox, self.action_names[int(action)], self._view)
            sandbox.world.lift_changes.clear()
            return outcome
        call = skill_call(
            [int(part) for part in action],
            sandbox.world.view(sandbox.robot.floor).landmarks,
            self._view.ids[:SLOTS],
            self.vocabulary.floors,
        )
        if call is None:
            return Outcome(SkillStatus.INVALID_ACTION, "the action's index names nothing here")
        result = sandbox.run(call)
        return Outcome(result.status, result.message, result.status is SkillStatus.SUCCESS)

    def _observe(self) -> ProgressScore:
        view = self._view = self._visibility.look(self._sandbox.robot, SLOTS, self._tracker.targets)
        return self._tracker.observe(dict(zip(view.ids, view.distances.tolist())))

    def _values(self) -> Values:
        left = max(0.0, 1.0 - self._steps / self._limit)
        values = self._describer.state(self._view, self._goal, left)
        if self._pictures != "state":
            frame = self._frame(depth=self._pictures == "rgbd")
            values["rgb"] = frame.rgb
            if self._pictures == "rgbd":
                values["depth"] = np.clip(frame.depth, 0.0, FAR).astype(np.float32)
        return values

    def _info(self, outcome: Outcome) -> dict[str, Any]:
        score = self._tracker.score
        return {
            "task": self.task.id,
            "status": outcome.status.value,
            "message": outcome.message,
            "retrieval": score.retrieval,
            "navigation": score.navigation,
            "success": score.success,
            "visible": self._view.ids[:SLOTS],
            "time": self._sandbox.world.time,
        }

    def _frame(self, *, depth: bool) -> Any:
        if self._camera is None:
            with importing:
                from mansion_skills.vision import Camera

            self._camera = Camera(self._sandbox.session, *self._size)
        return self._camera.render(depth=depth, segmentation=False)

    def render(self) -> Any:
        """Return what the camera sees, ``(height, width, 3)`` of uint8; ``None`` without a render mode."""
        return None if self.render_mode is None else self._frame(depth=False).rgb

    def close(self) -> None:
        """Let go of the camera."""
        if self._camera is not None:
            self._camera.close()
            self._camera = None


def _potential(score: ProgressScore) -> float:
    return 0.25 * score.retrieval + 0.25 * score.navigation + 0.5 * score.success


def _check_option(name: str, value: object, known: tuple[object, ...]) -> None:
    if value not in known:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{name} {value!r}: one of {known}", path=f"$.{name}")


def _tasks(tasks: str | Path | Sequence[Task] | None, sandbox: Sandbox, seed: int) -> list[Task]:
    if tasks is None:
        return generate(sandbox, TASKS_MADE, seed)
    found = read_task_set(Path(tasks)).tasks if isinstance(tasks, str | Path) else list(tasks)
    if not found:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "there are no tasks", path="$.tasks")
    return found
