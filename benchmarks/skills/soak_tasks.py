"""Simulated hours of episodes: the oracle and a random driver by turns, with every invariant checked.

Run: PYTHONPATH=tests/support python benchmarks/skills/soak_tasks.py DIR... [--hours 24] [--tasks 10]

Episodes go round the buildings, each with one world that is reset between episodes. After each episode every object is
in exactly one place and every robot stands in a room; after each reset the world is as it was built. The resident
memory is printed with the simulated hours.
"""

import argparse
import resource
import sys
import time
from pathlib import Path

import numpy as np

from invariants import check_world
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import Task
from mansion_tasks.env.building_env import BuildingEnv
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox
from mansion_tasks.tasks.solving import solve


def fingerprint(sandbox: Sandbox) -> bytes:
    """Return every object's state and every door's, as bytes."""
    objects = sandbox.world.objects
    return encode_bytes([[objects.state(name) for name in objects], sandbox.world.doors])


def resident() -> float:
    """Return the resident memory now, MB."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 1e6


def wander(env: BuildingEnv, rng: np.random.Generator, steps: int) -> float:
    """Drive at random for some steps; return the simulated seconds."""
    for _ in range(steps):
        action = [int(rng.integers(n)) for n in env.action_space.nvec]
        _, _, terminated, truncated, _ = env.step(action)
        if terminated or truncated:
            break
    return env.sandbox.world.time


def main() -> int:
    """Run until the hours are simulated."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--hours", type=float, default=24.0)
    parser.add_argument("--tasks", type=int, default=10)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    rng = np.random.default_rng(options.seed)
    stages: list[tuple[BuildingEnv, list[Task], bytes]] = []
    for folder in options.folders:
        try:
            tasks = generate(Sandbox(folder), options.tasks, options.seed)
        except MansionError as error:
            print(f"{folder}: {error}")
            continue
        env = BuildingEnv(folder, tasks=tasks, actions="skill")
        env.sandbox.reset()
        stages.append((env, tasks, fingerprint(env.sandbox)))
    simulated, episodes, failed, told = 0.0, 0, 0, 0.0
    begin, first = time.monotonic(), resident()
    while simulated < options.hours * 3600.0:
        env, tasks, built = stages[episodes % len(stages)]
        task = tasks[int(rng.integers(len(tasks)))]
        if episodes // len(stages) % 2 == 0:
            failed += solve(task, env.sandbox) is None
            simulated += env.sandbox.world.time
        else:
            env.reset(seed=episodes, options={"task": task.id})
            simulated += wander(env, rng, task.max_steps)
        check_world(env.sandbox.world)
        env.sandbox.reset()
        if fingerprint(env.sandbox) != built:
            print(f"episode {episodes}: {task.id} left a trace", flush=True)
            return 1
        episodes += 1
        if simulated - told >= 3600.0:
            told = simulated
            print(f"{simulated / 3600.0:5.1f} h simulated, {episodes} episodes, {resident():.0f} MB", flush=True)
    print(
        f"{simulated / 3600.0:.1f} h simulated in {time.monotonic() - begin:.0f} s: {episodes} episodes in "
        f"{len(stages)} buildings, {failed} that the oracle did not do, "
        f"memory {first:.0f} to {resident():.0f} MB, no object lost"
    )
    return 0 if failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
