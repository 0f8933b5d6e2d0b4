"""Steps and resets a second of the Gymnasium environment on one core.

Run: python benchmarks/skills/env_speed.py DIR... [--steps 5000] [--repeats 3] [--observation state|rgb|rgbd]

A uniformly random policy; resets are part of the time. The best of `--repeats` counts, in processor time.
"""

import argparse
import time
from pathlib import Path

import numpy as np

from mansion_tasks.env.building_env import BuildingEnv


def steps_a_second(env: BuildingEnv, steps: int, seed: int) -> float:
    """Return how many random steps run in a second of processor time."""
    rng = np.random.default_rng(seed)
    sizes = np.atleast_1d(getattr(env.action_space, "nvec", getattr(env.action_space, "n", None)))
    actions = rng.integers(sizes, size=(steps, len(sizes)))
    env.reset(seed=seed)
    begin = time.process_time()
    for row in actions:
        _, _, terminated, truncated, _ = env.step(int(row[0]) if len(row) == 1 else row)
        if terminated or truncated:
            env.reset()
    return steps / (time.process_time() - begin)


def resets(env: BuildingEnv, count: int) -> float:
    """Return the milliseconds of a reset after a few steps."""
    spent = 0.0
    for seed in range(count):
        for _ in range(5):
            env.step(env.action_space.sample())
        begin = time.process_time()
        env.reset(seed=seed)
        spent += time.process_time() - begin
    return 1e3 * spent / count


def main() -> None:
    """Print one line for each building and action set."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--steps", type=int, default=5000)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--observation", default="state")
    options = parser.parse_args()
    for folder in options.folders:
        for actions, steps in (("low", options.steps), ("skill", options.steps // 10)):
            env = BuildingEnv(folder, actions=actions, observation=options.observation)
            steps_a_second(env, min(steps, 300), 99)
            best = max(steps_a_second(env, steps, seed) for seed in range(options.repeats))
            wait = resets(env, 20)
            env.close()
            objects = len(env.sandbox.world.objects.kinds)
            print(f"{folder.name}: {objects} objects, {actions}: {best:.0f} steps/s, reset {wait:.1f} ms", flush=True)


if __name__ == "__main__":
    main()
