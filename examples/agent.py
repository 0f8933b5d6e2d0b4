"""Give one task to two agents: the oracle follows the plan that comes with it, the explorer searches the building.

.venv/bin/python examples/agent.py --output out/examples    # after examples/build.py
"""

import argparse
from pathlib import Path

from mansion_tasks.agents.registry import make_agent
from mansion_tasks.episodes.log import write_log
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import run_episode
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.sandbox import Sandbox


def main() -> None:
    """Run an episode of each agent and write DIR/episodes/AGENT.jsonl."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    output = parser.parse_args().output

    building = output / "clinic"
    task = generate(Sandbox(building), count=1, seed=0)[0]
    print(task.instruction)
    for name in ("oracle", "explorer"):
        log = run_episode(task, building, make_agent(name), LocalPort())
        for step in log.steps:
            print(f"  {step.call.skill}: {step.status}")
        end = log.end
        print(f"{name}: success {end.success}, {end.steps} skills, {end.time:.0f} s, {end.stop}")
        (output / "episodes").mkdir(exist_ok=True)
        write_log(output / "episodes" / f"{name}.jsonl", log)


if __name__ == "__main__":
    main()
