"""Pictures of an episode: a contact sheet and an animation, made by repeating it before a camera."""

from collections.abc import Sequence
from io import BytesIO
from math import ceil
from pathlib import Path
from typing import Any

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.world import SkillStatus
from mansion_skills.vision.annotated_pictures import INK, font, wrapped
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.camera_eyes import CameraEyes
from mansion_tasks.episodes.log import EpisodeLog, EpisodeStep
from mansion_tasks.episodes.marking import png
from mansion_tasks.episodes.plan_view import plan_view
from mansion_tasks.episodes.port import SkillPort
from mansion_tasks.episodes.replaying import replay
from mansion_tasks.episodes.trail import Trail

__all__ = ["chosen_steps", "episode_frames", "write_gif", "write_sheet"]

SIDE = 300
"""Pixels of a picture's edge."""

LETTERS, TITLE_LETTERS = 13, 16
"""Pixels of the captions' letters and of the heading's."""

LEADING = 1.25
"""Distance of rows over the height of their letters."""

EDGE = 6
"""Pixels left free beside text."""

MOST_FRAMES = 12
TELLING = ("PickUp", "Place", "UseElevator", "TakeStairs", "OpenObject", "OpenDoor")
"""Skills whose success is always shown."""


def chosen_steps(steps: Sequence[EpisodeStep], most: int = MOST_FRAMES) -> list[int]:
    """Return which moments to show, 0 for the start: first, last, telling skills, and others evenly between."""
    last = len(steps)
    chosen = dict.fromkeys((0, last))
    for step in steps:
        if len(chosen) < most and step.status is SkillStatus.SUCCESS and step.call.skill in TELLING:
            chosen[step.step] = None
    left = [k for k in range(last + 1) if k not in chosen]
    count = min(most - len(chosen), len(left))
    chosen |= dict.fromkeys(left[(2 * k + 1) * len(left) // (2 * count)] for k in range(count))
    return sorted(chosen)


def episode_frames(log: EpisodeLog, building: Path, port: SkillPort) -> list[Any]:
    """Return Pillow images of the chosen moments: what the camera sees, the plan with the way, and a caption.

    Where nothing can render, the plan stands alone.
    """
    wanted = set(chosen_steps(log.steps))
    goals = frozenset(name for goal in log.start.task.goals for name in (*goal.rooms, *goal.receptacles))
    targets = frozenset(name for goal in log.start.task.goals for name in goal.objects)
    frames: list[Any] = []
    trail = Trail()
    with CameraEyes() as eyes:

        def look(number: int, world: World, robot: RobotBody) -> None:
            trail.follow(robot)
            if number not in wanted:
                return
            plan = plan_view(world, robot.floor, trail.points, robot.pose.yaw, size=SIDE, targets=targets, goals=goals)
            step = log.steps[number - 1] if number else None
            frames.append(_frame(_camera(eyes, world, robot), plan, _caption(log, step, world, robot)))

        replay(log, building, port, look)
    return _alike(frames)


def _camera(eyes: CameraEyes, world: World, robot: RobotBody) -> Any:
    from PIL import Image

    camera = eyes.camera(world, robot)
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
    """Lay out a moment; it is never narrower than a camera's picture, so that its caption can be read."""
    from PIL import Image

    pictures = [picture for picture in (camera, plan) if picture is not None]
    width = max(SIDE, sum(p.width for p in pictures))
    rows = [row for text in caption for row in wrapped(text, width - 2 * EDGE, LETTERS)]
    frame = Image.new("RGB", (width, SIDE + _height(rows, LETTERS)), "white")
    left = 0
    for picture in pictures:
        frame.paste(picture, (left, (SIDE - picture.height) // 2))
        left += picture.width
    _write(frame, SIDE, rows, LETTERS)
    return frame


def _height(rows: Sequence[str], letters: int) -> int:
    return round(LEADING * letters * len(rows)) + EDGE


def _write(picture: Any, top: int, rows: Sequence[str], letters: int) -> None:
    from PIL import ImageDraw

    drawing = ImageDraw.Draw(picture)
    for k, row in enumerate(rows):
        place = (EDGE, top + EDGE // 2 + round(LEADING * letters * k))
        drawing.text(place, row, fill=INK, font=font(letters))


def _alike(frames: Sequence[Any]) -> list[Any]:
    """Return frames of one size: floors may have different outlines, captions more or fewer rows."""
    from PIL import Image

    size = (max(frame.width for frame in frames), max(frame.height for frame in frames))
    padded = []
    for frame in frames:
        large = Image.new("RGB", size, "white")
        large.paste(frame, (0, 0))
        padded.append(large)
    return padded


def write_sheet(path: Path, log: EpisodeLog, frames: Sequence[Any]) -> None:
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
        row for text in (log.start.task.instruction, result) for row in wrapped(text, whole - 2 * EDGE, TITLE_LETTERS)
    ]
    top = _height(rows, TITLE_LETTERS)
    sheet = Image.new("RGB", (whole, top + ceil(len(frames) / columns) * (height + 8)), "white")
    _write(sheet, 0, rows, TITLE_LETTERS)
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
