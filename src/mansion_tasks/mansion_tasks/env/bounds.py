"""The spaces of an environment, from the most categories, rooms, floors and landmarks that they have to number."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from gymnasium import spaces

from mansion_tasks.env.low_level import low_level_actions
from mansion_tasks.env.observations import SLOTS, state_space
from mansion_tasks.env.skill_level import SKILL_ACTIONS
from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["FAR", "Bounds", "action_space", "observation_space"]

FAR: Final = 50.0
"""Metres at which the depth image ends."""


@dataclass(frozen=True)
class Bounds:
    """What the spaces of an environment have room for.

    Environments with the same bounds have the same spaces, whatever their buildings are: a policy that is trained in
    some acts in the others.

    Attributes
    ----------
    categories : tuple of str
        Category ``k`` of objects is ``categories[k - 1]``; 0 stands for all others.
    rooms, floors : int
        Most in a building.
    landmarks : int
        Most on a floor.
    """

    categories: tuple[str, ...]
    rooms: int
    floors: int
    landmarks: int

    @classmethod
    def of(cls, *sandboxes: Sandbox) -> "Bounds":
        """Return the narrowest bounds of some buildings."""
        kinds = {kind.category for sandbox in sandboxes for kind in sandbox.world.objects.kinds.values()}
        buildings = [[sandbox.building.scene(n) for n in sandbox.building.floors] for sandbox in sandboxes]
        return cls(
            categories=tuple(sorted(kinds)),
            rooms=max(sum(len(scene.rooms) for scene in scenes) for scenes in buildings),
            floors=max(map(len, buildings)),
            landmarks=max(len(scene.rooms) + len(scene.cores) for scenes in buildings for scene in scenes),
        )


def observation_space(bounds: Bounds, pictures: str, image_size: tuple[int, int]) -> spaces.Dict:
    """Return the space of the observations; `pictures` is an option of `BuildingEnv`."""
    space = state_space(len(bounds.categories), bounds.rooms, bounds.floors)
    width, height = image_size
    if pictures != "state":
        space["rgb"] = spaces.Box(0, 255, (height, width, 3), np.uint8)
    if pictures == "rgbd":
        space["depth"] = spaces.Box(0.0, FAR, (height, width), np.float32)
    return space


def action_space(bounds: Bounds, actions: str) -> spaces.Space[Any]:
    """Return the space of the actions, which are an option of `BuildingEnv`."""
    if actions == "low":
        return spaces.Discrete(len(low_level_actions(list(range(bounds.floors)))))
    return spaces.MultiDiscrete([len(SKILL_ACTIONS), bounds.landmarks, SLOTS, bounds.floors])
