"""A contact sheet and an animation of an episode: camera pictures beside plans with the robot's trajectory."""

from collections.abc import Sequence
from io import BytesIO
from math import ceil, cos, radians, sin
from pathlib import Path
from typing import Any

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import SkillStatus
from mansion_skills.vision.annotated_pictures import INK, font, wrapped
from mansion_skills.world.objects import corners
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.camera_pictures import CameraPictures, png
from mansion_tasks.episodes.log import EpisodeLog, EpisodeStep
from mansion_tasks.episodes.port import SkillPort
from mansion_tasks.episodes.replaying import replay

__all__ = ["Trajectory", "chosen_steps", "episode_frames", "draw_plan", "write_gif", "write_contact_sheet"]


class Trajectory:
    """The polyline that a robot drove on its present floor, extended after each skill.

    Attributes
    ----------
    points : list of Point
        The present position last; a change of floor clears the earlier ones.
    """

    def __init__(self) -> None:
        self.points: list[Point] = []
        self._floor: int | None = None
        self._last_path: list[Point] = []

    def add(self, robot: RobotBody) -> None:
        """Append what the robot drove since the last call; it keeps the path of its last motion."""
        if robot.floor != self._floor:
            self._floor, self.points = robot.floor, []
        elif robot.path is not self._last_path and robot.path[-1:] == [robot.place]:
            begin = 1 if robot.path[0] == self.points[-1] else 0
            self.points += robot.path[begin:-1]
        self._last_path = robot.path
        if not self.points or self.points[-1] != robot.place:
            self.points.append(robot.place)


ROOM, CORE, OBJECT, WALL = (243, 238, 228), (205, 214, 226), (208, 201, 190), (80, 80, 80)
OUTLINE = (168, 160, 148)
TARGET, GOAL, TRAJECTORY, ROBOT = (214, 60, 40), (250, 214, 130), (70, 120, 200), (30, 80, 170)
MARGIN = 10


def draw_plan(
    world: World,
    floor: int,
    trajectory: Sequence[Point],
    yaw: float,
    *,
    size: int = 300,
    targets: frozenset[str] = frozenset(),
    goals: frozenset[str] = frozenset(),
) -> Any:
    """Return a Pillow image of a floor, as large as the floor's shape lets it be.

    Parameters
    ----------
    trajectory : sequence of points
        Where the robot was on this floor, the present position last.
    yaw : float
        Degrees; the robot's arrow.
    size : int
        Pixels of the longer side.
    targets, goals : sets of ids
        Objects drawn in red; rooms and objects drawn in yellow.
    """
    from PIL import Image, ImageDraw

    scene = world.building.scene(floor)
    to, shape = _scale(scene, size)
    picture = Image.new("RGB", shape, (255, 255, 255))
    drawing = ImageDraw.Draw(picture)
    for room in scene.rooms:
        fill = GOAL if room.id in goals else ROOM
        drawing.polygon([to(p) for p in room.polygon], fill=fill, outline=WALL)
    for core in scene.cores:
        drawing.polygon([to(p) for p in core.polygon], fill=CORE, outline=WALL)
    for state in world.objects.on_floor(floor):
        kind = world.objects.kinds[state.id]
        if state.position is None or (kind.mount in ("ceiling", "wall") and state.id not in targets):
            continue
        fill = TARGET if state.id in targets else GOAL if state.id in goals else OBJECT
        drawing.polygon([to(p) for p in corners(state, kind)], fill=fill, outline=OUTLINE)
        if state.id in targets:
            x, y = to((state.position[0], state.position[1]))
            drawing.ellipse((x - 5, y - 5, x + 5, y + 5), outline=TARGET, width=2)
    for door in scene.doors:
        drawing.line([to(p) for p in door.segment], fill=(255, 255, 255), width=3)
    if len(trajectory) > 1:
        drawing.line([to(p) for p in trajectory], fill=TRAJECTORY, width=2)
    if trajectory:
        _robot(drawing, to(trajectory[-1]), yaw)
    return picture


def _robot(drawing: Any, place: tuple[float, float], yaw: float) -> None:
    x, y = place
    tip, left, right = (
        (x + r * cos(radians(yaw + a)), y - r * sin(radians(yaw + a))) for r, a in ((11, 0), (8, 140), (8, -140))
    )
    drawing.polygon([tip, left, right], fill=ROBOT, outline=(255, 255, 255))


def _scale(scene: FloorScene, size: int) -> tuple[Any, tuple[int, int]]:
    """Return the map from the plan's metres to pixels, y down, and the size of the picture."""
    xs, ys = [p[0] for p in scene.outline], [p[1] for p in scene.outline]
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    factor = (size - 2 * MARGIN) / max(high_x - low_x, high_y - low_y)

    def to(point: Point) -> tuple[float, float]:
        return MARGIN + (point[0] - low_x) * factor, MARGIN + (high_y - point[1]) * factor

    right, bottom = to((high_x, low_y))
    return to, (round(right) + MARGIN, round(bottom) + MARGIN)


SIDE = 300
"""Pixels of a picture's edge."""

CAPTION_HEIGHT, TITLE_HEIGHT = 13, 16
"""Pixels of the captions' letters and of the heading's."""

LEADING = 1.25
"""Distance of rows over the height of their letters."""

EDGE = 6
"""Pixels left free beside text."""

MAX_FRAMES = 12
KEY_SKILLS = ("PickUp", "Place", "UseElevator", "TakeStairs", "OpenObject", "OpenDoor")
"""Skills whose success is always shown."""


def chosen_steps(steps: Sequence[EpisodeStep], most: int = MAX_FRAMES) -> list[int]:
    """Return which moments to show, 0 for the start: first, last, telling skills, and others evenly between."""
    last = len(steps)
    chosen = dict.fromkeys((0, last))
    for step in steps:
        if len(chosen) < most and step.status is SkillStatus.SUCCESS and step.call.skill in KEY_SKILLS:
            chosen[step.step] = None
    left = [k for k in range(last + 1) if k not in chosen]
    count = min(most - len(chosen), len(left))
    chosen |= dict.fromkeys(left[(2 * k + 1) * len(left) // (2 * count)] for k in range(count))
    return sorted(chosen)


def episode_frames(log: EpisodeLog, building: Path, port: SkillPort) -> list[Any]:
    """Return Pillow images of the chosen moments: what the camera sees, the plan with the trajectory, and a caption.

    Where nothing can render, the plan stands alone.
    """
    wanted = set(chosen_steps(log.steps))
    goals = frozenset(name for goal in log.start.task.goals for name in (*goal.rooms, *goal.receptacles))
    targets = frozenset(name for goal in log.start.task.goals for name in goal.objects)
    frames: list[Any] = []
    trajectory = Trajectory()
    with CameraPictures() as pictures:

        def look(number: int, world: World, robot: RobotBody) -> None:
            trajectory.add(robot)
            if number not in wanted:
                return
            points, yaw = trajectory.points, robot.pose.yaw
            plan = draw_plan(world, robot.floor, points, yaw, size=SIDE, targets=targets, goals=goals)
            step = log.steps[number - 1] if number else None
            frames.append(_frame(_camera(pictures, world, robot), plan, _caption(log, step, world, robot)))

        replay(log, building, port, look)
    return _same_size(frames)


def _camera(pictures: CameraPictures, world: World, robot: RobotBody) -> Any:
    from PIL import Image

    camera = pictures.camera(world, robot)
    try:
        frame = camera.render(depth=False, segmentation=False) if camera is not None else None
    except MansionError:
        frame = None
    if frame is None:
        return None
    height, width = frame.rgb.shape[:2]
    left = (width - height) // 2
    return Image.fromarray(frame.rgb[:, left : left + height]).resize((SIDE, SIDE))


def _caption(log: EpisodeLog, step: EpisodeStep | None, world: World, robot: RobotBody) -> tuple[str, str]:
    state = world.robot_state(robot)
    held = state.held.rsplit("/", 1)[-1] if state.held else "nothing"
    second = f"floor {state.floor}, {(state.room or '').rsplit('/', 1)[-1]}, holds {held}"
    if step is None:
        return f"start: {log.start.agent}", second
    # "Place on table_1" reads better than the order of the arguments.
    named = sorted(step.call.arguments.items(), key=lambda item: item[0] != "relation")
    values = [str(value).rsplit("/", 1)[-1] for _, value in named]
    outcome = "" if step.status is SkillStatus.SUCCESS else f": {step.status.value}"
    return f"{step.step}. {step.call.skill} {' '.join(values)}{outcome}", second


def _frame(camera: Any, plan: Any, caption: tuple[str, str]) -> Any:
    """Lay out a snapshot; it is never narrower than a camera's picture, so that its caption can be read."""
    from PIL import Image

    pictures = [picture for picture in (camera, plan) if picture is not None]
    width = max(SIDE, sum(p.width for p in pictures))
    rows = [row for text in caption for row in wrapped(text, width - 2 * EDGE, CAPTION_HEIGHT)]
    frame = Image.new("RGB", (width, SIDE + _height(rows, CAPTION_HEIGHT)), "white")
    left = 0
    for picture in pictures:
        frame.paste(picture, (left, (SIDE - picture.height) // 2))
        left += picture.width
    _write(frame, SIDE, rows, CAPTION_HEIGHT)
    return frame


def _height(rows: Sequence[str], letters: int) -> int:
    return round(LEADING * letters * len(rows)) + EDGE


def _write(picture: Any, top: int, rows: Sequence[str], letters: int) -> None:
    from PIL import ImageDraw

    drawing = ImageDraw.Draw(picture)
    for k, row in enumerate(rows):
        place = (EDGE, top + EDGE // 2 + round(LEADING * letters * k))
        drawing.text(place, row, fill=INK, font=font(letters))


def _same_size(frames: Sequence[Any]) -> list[Any]:
    """Return frames of one size: floors may have different outlines, captions more or fewer rows."""
    from PIL import Image

    size = (max(frame.width for frame in frames), max(frame.height for frame in frames))
    padded = []
    for frame in frames:
        large = Image.new("RGB", size, "white")
        large.paste(frame, (0, 0))
        padded.append(large)
    return padded


def write_contact_sheet(path: Path, log: EpisodeLog, frames: Sequence[Any]) -> None:
    """Write the frames as one PNG with the instruction and the result above them."""
    from PIL import Image

    columns = min(4 if frames[0].width < 460 else 3, len(frames))
    width, height = frames[0].size
    whole = columns * (width + 8) + 8
    end = log.end
    outcome = "success" if end.success else f"no success ({end.stop.replace('_', ' ')})"
    result = (
        f"{log.start.agent}: {outcome} after {end.steps} skills; "
        f"retrieval {end.retrieval:.2f}, navigation {end.navigation:.2f}"
    )
    rows = [
        row for text in (log.start.task.instruction, result) for row in wrapped(text, whole - 2 * EDGE, TITLE_HEIGHT)
    ]
    top = _height(rows, TITLE_HEIGHT)
    sheet = Image.new("RGB", (whole, top + ceil(len(frames) / columns) * (height + 8)), "white")
    _write(sheet, 0, rows, TITLE_HEIGHT)
    for k, frame in enumerate(frames):
        place = (8 + k % columns * (width + 8), top + k // columns * (height + 8))
        sheet.paste(frame, place)
    write_atomic(path, png(sheet))


def write_gif(path: Path, frames: Sequence[Any], *, milliseconds: int = 900) -> None:
    """Write the frames as an animation that repeats."""
    stream = BytesIO()
    first, *rest = frames
    first.save(stream, "GIF", save_all=True, append_images=rest, duration=milliseconds, loop=0, optimize=True)
    write_atomic(path, stream.getvalue())
