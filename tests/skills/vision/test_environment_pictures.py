"""The environment's pictures are part of its observations, and keep Gymnasium's contract."""

import warnings
from pathlib import Path

import numpy as np
import pytest

from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox

gymnasium = pytest.importorskip("gymnasium")


@pytest.mark.parametrize("observation", ["rgb", "rgbd"])
def test_gymnasiums_checker_has_nothing_to_say_of_pictures(pictured: Path, renders: None, observation: str) -> None:
    from gymnasium.utils.env_checker import check_env

    from mansion_tasks.env import ENV_ID

    tasks = generate(Sandbox(pictured), 4, seed=0)
    env = gymnasium.make(ENV_ID, building=pictured, tasks=tasks, observation=observation, image_size=(80, 60)).unwrapped
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env, skip_render_check=True)
    values, _ = env.reset(seed=1)
    assert values["rgb"].shape == (60, 80, 3)
    assert len(np.unique(values["rgb"])) > 10
    assert ("depth" in values) == (observation == "rgbd")
    env.close()
