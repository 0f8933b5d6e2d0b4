"""``mansion/Buildings-v0``: another building each episode, with spaces that are the same for all of them."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import gymnasium

from mansion_msgs_py.building_folder import TASKS
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_tasks.env.bounds import Bounds, action_space, observation_space
from mansion_tasks.env.building_env import BuildingEnv
from mansion_tasks.env.low_level import low_level_actions
from mansion_tasks.env.observations import Values
from mansion_tasks.env.skill_level import SKILL_ACTIONS
from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["BuildingsEnv"]


class BuildingsEnv(gymnasium.Env[Values, Any]):  # type: ignore[misc]
    """A `BuildingEnv` in one of many buildings, which a reset chooses at random.

    A building is loaded when it is chosen and forgotten with the next one. Its tasks are those of ``tasks.json`` in its
    folder, or made where there is no such file.

    Parameters
    ----------
    buildings : sequence of path
        Building folders.
    bounds : Bounds, optional
        Bounds of all buildings together; read from each when absent.
    **options
        Those of `BuildingEnv` but for ``tasks``.

    Attributes
    ----------
    action_names : tuple of str
        On the low level the rides come last, one for each floor by its place from below: ``ride_to_lowest``,
        ``ride_to_lowest+1``, ...

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without buildings or for other values of the options; ``NOT_FOUND`` for a path
        that is not a building.
    """

    metadata: dict[str, Any] = BuildingEnv.metadata

    def __init__(self, buildings: Sequence[str | Path], *, bounds: Bounds | None = None, **options: Any) -> None:
        if not buildings:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, "there are no buildings", path="$.buildings")
        self.buildings = [Path(folder) for folder in buildings]
        self.bounds = bounds or Bounds.of(*(Sandbox(folder) for folder in self.buildings))
        self.render_mode: str | None = options.get("render_mode")
        self._options = options
        self._inner: BuildingEnv | None = None
        self._folder: Path | None = None
        actions = options.get("actions", "low")
        self.action_names = _action_names(actions, self.bounds.floors)
        self.action_space = action_space(self.bounds, actions)
        self.observation_space = observation_space(
            self.bounds, options.get("observation", "state"), options.get("image_size", (300, 300))
        )
        self._enter(self.buildings[0])

    @property
    def building(self) -> BuildingEnv:
        """The environment of the building of this episode."""
        if self._inner is None:
            raise MansionError(ErrorCode.NOT_LOADED, "the environment is closed; call reset to begin again")
        return self._inner

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Values, dict[str, Any]]:
        """Begin an episode in the building of index ``options["building"]``, else in a random one.

        ``options["task"]`` names one of its tasks; else that is random too.
        """
        super().reset(seed=seed)
        chosen = (options or {}).get("building")
        if chosen is None:
            chosen = int(self.np_random.integers(len(self.buildings)))
        if not isinstance(chosen, int) or not 0 <= chosen < len(self.buildings):
            raise MansionError(
                ErrorCode.NOT_FOUND, f"there is no building {chosen!r}; indices are 0 to {len(self.buildings) - 1}"
            )
        inner = self._enter(self.buildings[chosen])
        observation, info = inner.reset(seed=int(self.np_random.integers(2**31)), options=options)
        return observation, {**info, "building": inner.sandbox.building.building_id}

    def _enter(self, folder: Path) -> BuildingEnv:
        if self._inner is not None and folder == self._folder:
            return self._inner
        self.close()
        tasks = folder / TASKS
        given = tasks if tasks.is_file() else None
        self._inner, self._folder = BuildingEnv(folder, tasks=given, bounds=self.bounds, **self._options), folder
        return self._inner

    def step(self, action: Any) -> tuple[Values, float, bool, bool, dict[str, Any]]:
        """Do an action; see `BuildingEnv.step`."""
        inner = self.building
        observation, reward, terminated, truncated, info = inner.step(action)
        return observation, reward, terminated, truncated, {**info, "building": inner.sandbox.building.building_id}

    def render(self) -> Any:
        """Return what the camera sees; see `BuildingEnv.render`."""
        return self.building.render()

    def close(self) -> None:
        """Let go of the building and of its camera."""
        if self._inner is not None:
            self._inner.close()
            self._inner = self._folder = None


def _action_names(actions: str, floors: int) -> tuple[str, ...]:
    if actions != "low":
        return SKILL_ACTIONS
    plain = low_level_actions([])
    return (*plain, *(f"ride_to_lowest+{above}" if above else "ride_to_lowest" for above in range(floors)))
