"""Loading floors and planning: python benchmarks/skills/navigation.py BUILDING."""

import argparse
import statistics
import time
from collections.abc import Callable
from pathlib import Path

from mansion_skills import Robot
from mansion_skills.skills.driving import path_to
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.floor_view import FloorView
from mansion_skills.world.objects import ObjectTable


def timed(call: Callable[[], object]) -> float:
    """Return the processor time of a call, milliseconds."""
    begin = time.process_time()
    call()
    return (time.process_time() - begin) * 1e3


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("building")
    path = Path(parser.parse_args().building)
    robot = Robot(path, reset=True)
    robot.plan_route(robot.list_landmarks().landmarks[0].name)
    building = LoadedBuilding(path)
    table = ObjectTable(building.scene(floor) for floor in building.floors)
    loads = [
        timed(lambda floor=floor: FloorView(building._read_scene(floor), table, {}, 0.2)) for floor in building.floors
    ]
    print(f"load a floor: median {statistics.median(loads):.1f} ms, most {max(loads):.1f} ms")
    world = robot.engine.session("").world
    targets = [room.id for f in building.floors for room in building.scene(f).rooms]
    world.routes = None
    print(f"first route, its graph made: {timed(lambda: robot.plan_route(targets[-1])):.1f} ms")
    routes = [timed(lambda name=name: robot.plan_route(name)) for name in targets]
    print(f"plan a route: median {statistics.median(routes):.1f} ms, most {max(routes):.1f} ms")
    body = robot.engine.session("").robot
    paths = [
        timed(lambda mark=mark: path_to(world, body, (mark.pose.x, mark.pose.y), 1.5))
        for mark in world.view(body.floor).landmarks
    ]
    print(f"plan a path: median {statistics.median(paths):.1f} ms, most {max(paths):.1f} ms")


if __name__ == "__main__":
    main()
