"""Another building each episode, in spaces that all of them share."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import TaskSet
from mansion_tasks.env.bounds import Bounds
from mansion_tasks.env.building_env import BuildingEnv
from mansion_tasks.env.buildings_env import BuildingsEnv
from mansion_tasks.env.skill_level import SKILL_ACTIONS
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox
from sample_building import write_building


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """A building of one floor and one of three, with tasks of their own."""
    made = []
    for name, floors in (("low", [1]), ("high", [1, 2, 3])):
        folder = write_building(tmp_path_factory.mktemp("many") / name, floors)
        tasks = TaskSet(building=".", building_id="", tasks=generate(Sandbox(folder), 2, seed=len(floors)))
        (folder / "tasks.json").write_bytes(encode_bytes(tasks))
        made.append(folder)
    return made


@pytest.mark.parametrize("actions", ["low", "skill"])
def test_gymnasiums_checker_has_nothing_to_say(folders: list[Path], actions: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(BuildingsEnv(folders, actions=actions), skip_render_check=True)


@pytest.mark.parametrize("actions", ["low", "skill"])
def test_observations_and_actions_fit_every_building(folders: list[Path], actions: str) -> None:
    env = BuildingsEnv(folders, actions=actions, max_steps=40)
    env.action_space.seed(3)
    for building in (0, 1, 0):
        observation, info = env.reset(seed=3, options={"building": building})
        assert Path(env.building.sandbox.building.path) == folders[building]
        for _ in range(40):
            assert env.observation_space.contains(observation)
            observation, _, terminated, truncated, info = env.step(env.action_space.sample())
            if terminated or truncated:
                break
        assert info["building"] == env.building.sandbox.building.building_id


def episodes(env: BuildingsEnv, seed: int) -> list[tuple[Any, ...]]:
    found = []
    for episode in range(8):
        observation, info = env.reset(seed=seed if episode == 0 else None)
        found.append((str(env.building.sandbox.building.path), info["task"], tuple(observation["pose"])))
    return found


def test_the_seed_chooses_buildings_and_tasks(folders: list[Path]) -> None:
    env = BuildingsEnv(folders)
    first = episodes(env, 5)
    assert {Path(folder) for folder, *_ in first} == set(folders)
    assert len({task for _, task, _ in first}) > 2
    assert episodes(env, 5) == first == episodes(BuildingsEnv(folders), 5)
    assert episodes(env, 6) != first


def test_what_a_building_lacks_cannot_be_done_there_and_says_so(folders: list[Path]) -> None:
    env = BuildingsEnv(folders)
    env.reset(seed=1, options={"building": 0})
    *_, info = env.step(env.action_names.index("ride_to_lowest+2"))
    assert (info["status"], info["message"]) == ("INVALID_ACTION", "this building has fewer floors")
    skills = BuildingsEnv(folders, actions="skill")
    skills.reset(seed=1, options={"building": 0})
    *_, info = skills.step([SKILL_ACTIONS.index("UseElevator"), 0, 0, 2])
    assert info["status"] == "INVALID_ACTION"


def test_spaces_follow_from_bounds_alone(folders: list[Path]) -> None:
    bounds = Bounds.of(*(Sandbox(folder) for folder in folders))
    spaces = [BuildingsEnv([folder], bounds=bounds).observation_space for folder in folders]
    assert spaces[0] == spaces[1] == BuildingsEnv(folders).observation_space
    assert BuildingEnv(folders[0]).observation_space != spaces[0]


def test_categories_that_the_bounds_lack_are_nothing(folders: list[Path]) -> None:
    env = BuildingsEnv(folders[:1], bounds=Bounds(("mug",), 20, 3, 20))
    observation, _ = env.reset(seed=0)
    seen = [observation["categories"]]
    for _ in range(12):
        observation, *_ = env.step(env.action_names.index("rotate_left"))
        seen.append(observation["categories"])
    assert env.observation_space.contains(observation) and set(np.concatenate(seen)) <= {0, 1}


def test_tasks_are_those_of_the_folder(folders: list[Path]) -> None:
    env = BuildingsEnv(folders)
    env.reset(options={"building": 1})
    assert [task.id for task in env.building.tasks] == [task.id for task in generate(Sandbox(folders[1]), 2, seed=3)]


@pytest.mark.parametrize(
    ("buildings", "options", "said"),
    [([], {}, "there are no buildings"), (None, {"actions": "medium"}, "one of"), (["nowhere"], {}, r"building\.json")],
)
def test_what_cannot_be_is_refused(
    folders: list[Path], buildings: list[str] | None, options: dict[str, str], said: str
) -> None:
    with pytest.raises(MansionError, match=said):
        BuildingsEnv(folders if buildings is None else buildings, **options)


def test_a_building_that_is_not_there_is_refused(folders: list[Path]) -> None:
    with pytest.raises(MansionError, match="indices are 0 to 1"):
        BuildingsEnv(folders).reset(options={"building": 2})
