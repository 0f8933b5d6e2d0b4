"""A world as a Gymnasium environment: its splits share their spaces, and environments run in processes of their own."""

import shutil
from functools import partial
from pathlib import Path

import msgspec
import numpy as np
import pytest
from gymnasium.vector import AsyncVectorEnv

import mansion
from mansion_msgs_py.codec import encode_bytes
from mansion_world.world_folder import WorldFolder


def test_every_building_comes_with_its_own_tasks(small_world: Path) -> None:
    world = mansion.World(small_world)
    env = world.env(actions="skill")
    ids = {entry.row.id for entry in world}
    tasks = {row.id for record in WorldFolder(small_world).records() for row in record.tasks}
    found = [env.reset(seed=seed)[1] for seed in range(12)]
    assert {info["building"] for info in found} == ids
    assert {info["task"] for info in found} <= tasks
    env.close()


def test_splits_and_difficulties_choose_buildings_but_not_the_spaces(small_world: Path) -> None:
    world = mansion.World(small_world)
    whole = world.env()
    for split in {entry.row.split for entry in world}:
        part = world.env(split=split)
        assert part.observation_space == whole.observation_space and part.action_space == whole.action_space
        rows = {entry.row.id for entry in world.filter(split=split)}
        assert {part.reset(seed=seed)[1]["building"] for seed in range(6)} <= rows
    with pytest.raises(mansion.MansionError, match="no building of that kind"):
        world.env(difficulty="expert")


def test_environments_in_processes_walk_through_the_world(small_world: Path) -> None:
    world = mansion.World(small_world)
    envs = AsyncVectorEnv([partial(world.env, max_steps=15)] * 2)
    try:
        envs.action_space.seed(1)
        observation, info = envs.reset(seed=[1, 2])
        first = list(info["building"])
        assert observation["pose"].shape == (2, 4)
        seen = set(first)
        for _ in range(70):
            observation, reward, _, _, info = envs.step(envs.action_space.sample())
            seen.update(info["building"])
        assert reward.shape == (2,) and np.isfinite(reward).all()
        assert len(seen) > 1
        assert list(envs.reset(seed=[1, 2])[1]["building"]) == first
    finally:
        envs.close()


def test_buildings_in_which_nothing_can_be_done_are_left_out(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(shutil.copytree(small_world, tmp_path / "world"))
    record = world.record(1)
    assert record is not None
    row = msgspec.structs.replace(record.building, tasks=0, no_tasks="nothing for a task")
    empty = msgspec.structs.replace(record, building=row, tasks=[])
    (world.path / "records/000/000001.json").write_bytes(encode_bytes(empty))
    world.write_manifest()
    env = mansion.World(world.path).env()
    assert row.id not in {env.reset(seed=seed)[1]["building"] for seed in range(12)}
