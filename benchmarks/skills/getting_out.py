"""Robots set into random corners of real buildings: does each get out, by planning and by MoveAhead's hints?

python benchmarks/skills/getting_out.py BUILDING... [--corners 20] [--seed 0]
"""

import argparse
from math import dist
from random import Random

import numpy as np

from mansion_geometry.disc_cells import region_of
from mansion_msgs_py.world import Pose2D, SkillStatus
from mansion_skills import Robot

HINTS = 10
OUT = 1.0
"""Metres from its corner at which a robot is out; the middle of a small room is out too."""

MIDDLE = 0.5
"""Metres from a landmark at which a robot is there."""


def corners(robot: Robot, floor: int) -> list[tuple[float, float]]:
    """Return the cells that a robot can get to and that have something beside and before or behind them."""
    view = robot.engine.session(robot.session).world.view(floor)
    mark, blocked = view.landmarks[0].pose, view.map.blocked
    reached = region_of(blocked, *view.map.frame.cell(mark.x, mark.y))
    beside = np.roll(blocked, 1, 1) | np.roll(blocked, -1, 1)
    before = np.roll(blocked, 1, 0) | np.roll(blocked, -1, 0)
    return [view.map.frame.center(int(r), int(c)) for r, c in np.argwhere(reached & beside & before)]


def stand(robot: Robot, floor: int, x: float, y: float, yaw: float) -> None:
    """Set the robot down."""
    body = robot.engine.session(robot.session).robot
    body.floor, body.pose = floor, Pose2D(x=x, y=y, yaw=yaw)


def by_hints(robot: Robot) -> bool:
    """Whether following MoveAhead's hints leads away, or to the middle of the room."""
    session = robot.engine.session(robot.session)
    body, start = session.robot, session.robot.place
    marks = [(mark.pose.x, mark.pose.y) for mark in session.world.view(body.floor).landmarks]
    for _ in range(HINTS):
        result = robot.move_ahead(20.0)
        if result.status is not SkillStatus.SUCCESS:
            out = result.data["way_out"]
            robot.rotate(out["degrees"])
            robot.move_ahead(out["meters"])
        if dist(start, body.place) > OUT or min(dist(body.place, m) for m in marks) < MIDDLE:
            return True
    return False


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("buildings", nargs="+")
    parser.add_argument("--corners", type=int, default=20, help="tried on each floor")
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    rng = Random(options.seed)
    tried = planned = hinted = 0
    for path in options.buildings:
        robot = Robot(path, "corners", world="corners", reset=True)
        world = robot.engine.session("corners").world
        for floor in world.building.floors:
            found = corners(robot, floor)
            marks = [mark.name for mark in world.view(floor).landmarks]
            for x, y in rng.sample(found, min(options.corners, len(found))):
                yaw = rng.uniform(0.0, 360.0)
                tried += 1
                stand(robot, floor, x, y, yaw)
                planned += robot.go_to_landmark(rng.choice(marks)).status is SkillStatus.SUCCESS
                stand(robot, floor, x, y, yaw)
                hinted += by_hints(robot)
    print(f"{tried} corners in {len(options.buildings)} buildings: {planned} left by GoToLandmark,")
    print(f"{hinted} by at most {HINTS} hints of MoveAhead")


if __name__ == "__main__":
    main()
