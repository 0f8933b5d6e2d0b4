"""Drive a robot through a building without a node graph: up by elevator, down by the stairs.

.venv/bin/python examples/drive.py --output out/examples    # after examples/build.py
"""

import argparse
from pathlib import Path

from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills import Robot


def report(result: SkillResult) -> None:
    """Print what a skill answers; end the script at the first one that fails."""
    if result.status is not SkillStatus.SUCCESS:
        raise SystemExit(f"{result.status}: {result.message}")
    print(result.message)


def main() -> None:
    """Visit the upper floor and come back."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    output = parser.parse_args().output

    robot = Robot(output / "clinic", reset=True)
    report(robot.go_to_landmark("elevator"))
    report(robot.call_elevator())
    report(robot.use_elevator(2))
    print(*(f"  {place.name}" for place in robot.list_landmarks().landmarks), sep="\n")
    report(robot.go_to_landmark("stairs"))
    report(robot.take_stairs("Down"))
    place = robot.where_am_i()
    print(f"on floor {place.floor} at ({place.pose.x:.2f}, {place.pose.y:.2f})")


if __name__ == "__main__":
    main()
