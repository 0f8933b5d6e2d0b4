"""The pictures of docs/seeing.md and the README's, of its office.

python benchmarks/skills/pictures.py out/office -o docs/images

seeing_views.png has three rooms as colours, depth and labels, each in the direction in which most of its objects are
seen; seeing_landmarks.png a page of the second floor's landmarks; seeing_cores.png the lift's panel and the stairs
there; office.png is the building's own overview.
"""

import argparse
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from mansion_msgs_py.world import Pose2D
from mansion_skills import Robot
from mansion_skills.vision import Camera, Frame

ROOMS = ("F1/cafeteria", "F2/open_office", "F4/boardroom")
FLOOR = 2
DIRECTIONS = 12
VIEW = (300, 225)
LEAST = 40
"""Pixels of an object that counts as seen."""


def stand(robot: Robot, floor: int, x: float, y: float, yaw: float) -> None:
    """Put the robot of this process somewhere; its session's state stays as it is."""
    body = robot.engine.session(robot.session).robot
    body.floor, body.pose = floor, Pose2D(x=x, y=y, yaw=yaw)


def best_view(robot: Robot, camera: Camera, name: str) -> Frame:
    """Return the frame from a room's landmark that shows most of its objects."""
    world = robot.engine.session(robot.session).world
    found = [entry for f in world.building.floors for entry in world.view(f).landmarks]
    place = next(entry for entry in found if entry.name == name)
    frames = []
    for k in range(DIRECTIONS):
        yaw = 360.0 * k / DIRECTIONS
        stand(robot, place.floor, place.pose.x, place.pose.y, yaw)
        frames.append(camera.render())
    return max(frames, key=lambda frame: seen(frame, name))


def seen(frame: Frame, room: str) -> int:
    """Return how many objects of a room are in a frame."""
    return sum(thing.startswith(f"{room}/") for thing in frame.visible(least=LEAST))


def row(frame: Frame) -> Any:
    """Return colours, depth (near is bright) and labels side by side."""
    depth = np.round(255.0 * 3.0 / (3.0 + frame.depth)).astype(np.uint8)
    # Knuth's multiplicative hash spreads neighbouring labels over the colours.
    code = (frame.segmentation.astype(np.int64) + 1) * 2654435761 % 2**24
    labels = np.stack([code >> 16, code >> 8 & 255, code & 255], axis=-1).astype(np.uint8)
    return np.hstack([frame.rgb, np.repeat(depth[..., None], 3, axis=2), labels])


def save(picture: Any, path: Path, width: int) -> None:
    """Write a picture, at most so wide."""
    image = Image.fromarray(picture)
    height = round(image.height * width / image.width)
    image = image.resize((width, height), Image.Resampling.LANCZOS) if width < image.width else image
    image.save(path, optimize=True)
    print(path)


def cores(robot: Robot, camera: Camera) -> Any:
    """Return the lift's panel and the view into the stairs beside each other."""
    world = robot.engine.session(robot.session).world
    lift = next(entry for entry in world.view(FLOOR).landmarks if entry.kind == "elevator")
    stand(robot, FLOOR, lift.pose.x, lift.pose.y, lift.pose.yaw)
    panel, stairs = Image.fromarray(camera.lift_panel()), Image.fromarray(camera.stairs_view())
    stairs = stairs.resize((round(stairs.width * panel.height / stairs.height), panel.height))
    return np.hstack([np.array(panel), np.array(stairs)])


def main() -> None:
    """Read the arguments and draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("building", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=Path("docs/images"))
    args = parser.parse_args()
    robot = Robot(args.building)
    with Camera(robot, *VIEW) as camera:
        views = np.vstack([row(best_view(robot, camera, name)) for name in ROOMS])
        save(views, args.output / "seeing_views.png", 900)
        pages = camera.landmark_pages(floor=FLOOR)
        save(pages[0], args.output / "seeing_landmarks.png", 1000)
        save(cores(robot, camera), args.output / "seeing_cores.png", 900)
    overview = Image.open(args.building / "building.png")
    overview.quantize(256, dither=Image.Dither.NONE).save(args.output / "office.png", optimize=True)


if __name__ == "__main__":
    main()
