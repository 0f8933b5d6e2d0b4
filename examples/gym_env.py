"""Take a few steps in the Gymnasium environment, with a task made for the building. Needs the extra `sim`.

.venv/bin/python examples/gym_env.py --output out/examples    # after examples/build.py
"""

import argparse
from pathlib import Path

import gymnasium

from mansion_tasks.env import ENV_ID
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox

STEPS = 20


def main() -> None:
    """Act at random."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    building = parser.parse_args().output / "clinic"

    tasks = generate(Sandbox(building), count=1, seed=0)
    env = gymnasium.make(ENV_ID, building=building, tasks=tasks, actions="low")
    env.action_space.seed(1)
    observation, info = env.reset(seed=1)
    print(info["instruction"])
    total = 0.0
    for step in range(1, STEPS + 1):
        action = env.action_space.sample()
        observation, reward, terminated, truncated, info = env.step(action)
        total += float(reward)
        print(f"{step:2} {env.unwrapped.action_names[action]}: {info['status']}")
        if terminated or truncated:
            break
    print(f"reward {total:.2f} on floor {int(observation['floor'])}")
    env.close()


if __name__ == "__main__":
    main()
