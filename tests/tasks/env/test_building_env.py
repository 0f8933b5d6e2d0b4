"""The environment keeps Gymnasium's contract, and its episodes end as they should."""

import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AsyncVectorEnv, SyncVectorEnv

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import Goal, GoalKind, Task, TaskKind, TaskSet
from mansion_tasks.env import ENV_ID
from mansion_tasks.env.building_env import BuildingEnv
from mansion_tasks.env.skill_level import SKILL_ACTIONS
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox
from sample_building import write_building


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_building(tmp_path_factory.mktemp("sample") / "building")


@pytest.fixture(scope="module")
def tasks(folder: Path) -> list[Task]:
    return generate(Sandbox(folder), 4, seed=0)


def make(folder: Path, tasks: list[Task], **more: Any) -> BuildingEnv:
    made = gymnasium.make(ENV_ID, building=folder, tasks=tasks, **more).unwrapped
    assert isinstance(made, BuildingEnv)
    return made


@pytest.mark.parametrize("actions", ["low", "skill"])
def test_gymnasiums_checker_has_nothing_to_say(folder: Path, tasks: list[Task], actions: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(make(folder, tasks, actions=actions), skip_render_check=True)


@pytest.mark.parametrize("actions", ["low", "skill"])
def test_observations_are_in_their_space_whatever_is_done(folder: Path, tasks: list[Task], actions: str) -> None:
    env = make(folder, tasks, actions=actions)
    env.action_space.seed(4)
    observation, _ = env.reset(seed=4)
    for _ in range(120):
        assert env.observation_space.contains(observation)
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
        assert -1.0 <= reward <= 1.0 and not (terminated and truncated)
        if terminated or truncated:
            observation, info = env.reset()
    assert set(info) >= {"task", "status", "retrieval", "navigation", "success", "visible"}


def trace(env: BuildingEnv, seed: int, steps: int = 60) -> list[bytes]:
    rng = np.random.default_rng(seed)
    observation, _ = env.reset(seed=seed)
    found = []
    for _ in range(steps):
        found.append(b"".join(np.asarray(observation[key]).tobytes() for key in sorted(observation)))
        observation, _, terminated, truncated, _ = env.step(int(rng.integers(env.action_space.n)))
        if terminated or truncated:
            observation, _ = env.reset()
    return found


def test_the_same_seed_gives_the_same_episodes_in_a_used_and_a_new_environment(folder: Path, tasks: list[Task]) -> None:
    used = make(folder, tasks)
    trace(used, 1, 200)
    assert trace(used, 7) == trace(make(folder, tasks), 7)
    assert trace(used, 8) != trace(used, 7)


def test_an_episode_ends_with_success_and_the_whole_reward(folder: Path, tasks: list[Task]) -> None:
    goal = [Goal(kind=GoalKind.HOLDING, objects=["F1/office/mug_1"])]
    task = Task(id="mug", kind=TaskKind.DELIVER, instruction="Get the mug.", goals=goal)
    env = make(folder, [task], actions="skill")
    _, info = env.reset(seed=0)
    assert info["instruction"] == "Get the mug." and info["task"] == "mug"
    office = [mark.name for mark in env.sandbox.world.view(1).landmarks].index("F1/office")
    near = SKILL_ACTIONS.index("GoNearObject")
    env.step([SKILL_ACTIONS.index("GoToLandmark"), office, 0, 0])
    total = 0.0
    for _ in range(8):
        _, _, _, _, info = env.step([SKILL_ACTIONS.index("Rotate 90.0"), 0, 0, 0])
        if "F1/office/mug_1" in info["visible"]:
            break
    _, _, _, _, info = env.step([near, 0, info["visible"].index("F1/office/mug_1"), 0])
    assert info["status"] == "SUCCESS" and info["retrieval"] == 0.5
    slot = info["visible"].index("F1/office/mug_1")
    _, total, terminated, truncated, info = env.step([SKILL_ACTIONS.index("PickUp"), 0, slot, 0])
    assert terminated and not truncated and info["success"]
    assert env._tracker.score.navigation == 1.0 and total >= 0.5


def test_an_episode_is_truncated_when_its_steps_are_used_up(folder: Path, tasks: list[Task]) -> None:
    env = make(folder, tasks, max_steps=3)
    env.reset(seed=0)
    look = env.action_names.index("rotate_left")
    ends = [env.step(look)[2:4] for _ in range(3)]
    assert ends == [(False, False), (False, False), (False, True)]


def test_what_cannot_be_done_changes_nothing_and_says_why(folder: Path, tasks: list[Task]) -> None:
    env = make(folder, tasks)
    env.reset(seed=0, options={"task": 0})
    pose = env.sandbox.robot.pose
    for name, status in [
        ("place", "PRECONDITION_FAILURE"),
        ("ride_to_3", "PRECONDITION_FAILURE"),
        ("stairs_down", "PRECONDITION_FAILURE"),
    ]:
        *_, info = env.step(env.action_names.index(name))
        assert info["status"] == status and info["message"]
    assert env.sandbox.robot.pose == pose
    skills = make(folder, tasks, actions="skill")
    skills.reset(seed=0)
    last = skills.action_space.nvec - 1
    *_, info = skills.step([SKILL_ACTIONS.index("GoNearObject"), *last[1:]])
    assert info["status"] == "INVALID_ACTION"


def test_tasks_are_chosen_by_id_by_index_or_by_the_seed(folder: Path, tasks: list[Task], tmp_path: Path) -> None:
    file = tmp_path / "tasks.json"
    file.write_bytes(encode_bytes(TaskSet(building=str(folder), building_id="sample", tasks=tasks)))
    env = BuildingEnv(folder, tasks=file)
    assert env.reset(options={"task": tasks[2].id})[1]["task"] == tasks[2].id
    assert env.reset(options={"task": 1})[1]["task"] == tasks[1].id
    assert env.reset(seed=5)[1]["task"] == env.reset(seed=5)[1]["task"]
    with pytest.raises(MansionError, match="no task"):
        env.reset(options={"task": "nothing"})


@pytest.mark.parametrize(
    "wrong", [{"actions": "medium"}, {"observation": "sound"}, {"render_mode": "ansi"}, {"tasks": []}]
)
def test_options_that_do_not_exist_are_refused(folder: Path, wrong: dict[str, Any]) -> None:
    with pytest.raises(MansionError):
        BuildingEnv(folder, **wrong)


def test_stepping_before_a_reset_is_refused(folder: Path, tasks: list[Task]) -> None:
    with pytest.raises(MansionError, match="reset"):
        BuildingEnv(folder, tasks=tasks).step(0)


@pytest.mark.parametrize("kind", [SyncVectorEnv, AsyncVectorEnv])
def test_environments_run_side_by_side(folder: Path, tasks: list[Task], kind: type) -> None:
    makers = [lambda: BuildingEnv(folder, tasks=tasks, max_steps=20)] * 2
    both = kind(makers)
    try:
        observation, _ = both.reset(seed=[1, 2])
        assert observation["pose"].shape == (2, 4)
        for _ in range(25):
            observation, reward, *_ = both.step(both.action_space.sample())
        assert reward.shape == (2,)
    finally:
        both.close()


def test_nothing_is_written_to_the_building(folder: Path, tasks: list[Task]) -> None:
    trace(make(folder, tasks), 3)
    assert not (folder / "state").exists()


def test_gymnasium_finds_the_environment_in_a_module_of_its_name(folder: Path) -> None:
    code = f"import gymnasium; gymnasium.make('mansion_tasks.env:{ENV_ID}', building={str(folder)!r})"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
