"""Frames of the robot's camera: python benchmarks/skills/frames.py BUILDING [--frames 2000].

Prints frames a second of one core's processor time (all threads of the process count), for the poses of every floor's
landmarks in eight directions each; what rooms' visibility saves; time to load a floor; and memory over many frames.
"""

import argparse
import os
import statistics
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

os.environ.setdefault("LP_NUM_THREADS", "0")  # Mesa's software renderer in the calling thread only

from mansion_msgs_py.world import Pose2D
from mansion_skills import Robot
from mansion_skills.vision import Camera
from mansion_skills.vision.floor_model import FloorModel

SIZES = ((300, 300), (640, 480))
PARTS = {
    "colours": {"depth": False, "segmentation": False},
    "colours, depth": {"segmentation": False},
    "colours, depth, segmentation": {},
}


def poses(robot: Robot) -> Iterator[None]:
    """Put the robot everywhere, lowest floor first."""
    session = robot.engine.session(robot.session)
    for floor in session.world.building.floors:
        for landmark in session.world.view(floor).landmarks:
            for turn in range(0, 360, 45):
                pose = landmark.pose
                session.robot.floor = floor
                session.robot.pose = Pose2D(x=pose.x, y=pose.y, yaw=pose.yaw + turn)
                yield


def spent(robot: Robot, call: Callable[[], object]) -> list[float]:
    """Return the milliseconds of processor time of a call at every pose; the floors are loaded before."""
    found, floor = [], None
    for _ in poses(robot):
        here = robot.engine.session(robot.session).robot.floor
        if here != floor:
            floor = here
            call()
        begin = time.process_time()
        call()
        found.append((time.process_time() - begin) * 1e3)
    return found


def told(name: str, times: list[float]) -> None:
    """Print one line of figures."""
    mean = statistics.fmean(times)
    late = statistics.quantiles(times, n=20)[-1]
    print(f"{name:44} {1e3 / mean:6.0f} frames/s   mean {mean:5.1f} ms   95% {late:5.1f} ms")


def everywhere(model: FloorModel, rooms: Any, offset: Any, radius: Any, heading: float) -> Any:
    """Stand for `FloorModel._in_wedges` where every room counts as seen."""
    return radius >= 0.0


def resident() -> float:
    """Return the process's memory, MB."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("building")
    parser.add_argument("--frames", type=int, default=2000, help="of the memory's measurement")
    arguments = parser.parse_args()
    robot = Robot(arguments.building, reset=True)
    for width, height in SIZES:
        with Camera(robot, width, height) as camera:
            for name, parts in PARTS.items():
                told(f"{width}x{height} {name}", spent(robot, partial(camera.render, **parts)))
            if (width, height) == SIZES[0]:
                colours = partial(camera.render, **PARTS["colours"])
                wedges, FloorModel._in_wedges = FloorModel._in_wedges, everywhere
                told(f"{width}x{height} colours, all rooms drawn", spent(robot, colours))
                FloorModel._in_wedges = wedges
    session = robot.engine.session(robot.session)
    session.robot.floor = session.world.building.floors[0]
    session.robot.pose = session.world.view(session.robot.floor).landmarks[0].pose
    begin = time.process_time()
    with Camera(robot) as camera:
        camera.render()
        print(f"open a camera and load a floor: {time.process_time() - begin:.2f} s")
        begin = time.process_time()
        pages = camera.landmark_pages()
        print(f"{len(pages)} pages of landmarks: {time.process_time() - begin:.2f} s")
        for _ in range(200):
            camera.render()
        before = resident()
        for _ in range(arguments.frames):
            camera.render()
        print(f"{arguments.frames} frames: {before:.0f} MB before, {resident():.0f} MB after")


if __name__ == "__main__":
    main()
