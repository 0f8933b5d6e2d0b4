"""``mansion look``: what the robot sees, and the pictures that are drawn for a model to choose from."""

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from mansion_bringup.cli.console import AsJson, check_output_file, out, print_json

if TYPE_CHECKING:
    from mansion_skills import Robot
    from mansion_skills.vision import Camera

__all__ = ["register"]


class Picture(StrEnum):
    """What is drawn."""

    VIEW = "view"
    DEPTH = "depth"
    SEGMENTATION = "segmentation"
    PANORAMA = "panorama"
    LANDMARKS = "landmarks"
    LIFT = "lift"
    STAIRS = "stairs"


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("look", no_args_is_help=True)(look)


def look(
    building: Annotated[Path, typer.Argument(help="Building folder.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="PNG file.")] = Path("look.png"),
    what: Annotated[Picture, typer.Option(help="What to draw.")] = Picture.VIEW,
    room: Annotated[
        str, typer.Option(help="Look at this room from its best place, or from a stair or lift, of any floor.")
    ] = "",
    floor: Annotated[int | None, typer.Option(help="Floor of the landmarks, or of the place to look from.")] = None,
    turn: Annotated[float, typer.Option(help="Degrees to the left of where it looks.")] = 0.0,
    width: Annotated[int, typer.Option(help="Pixels.", min=16, max=4096)] = 640,
    height: Annotated[int, typer.Option(help="Pixels.", min=16, max=4096)] = 480,
    fov: Annotated[float, typer.Option(help="Across, degrees.", min=20.0, max=150.0)] = 90.0,
    per_page: Annotated[int, typer.Option(help="Landmarks per page.", min=1, max=16)] = 9,
    session: Annotated[str, typer.Option("--session", "-s", help="Which robot.")] = "",
    as_json: AsJson = False,
) -> None:
    """Write a picture of a building as the session left it; nothing is moved, several pages get numbers.

    Examples:

      mansion look out/office --room F1/cafeteria -o cafeteria.png

      mansion look out/office --what landmarks --floor 2 -o landmarks.png

      mansion look out/office --what lift
    """
    from mansion_bringup.extras import ensure_extra

    check_output_file(output)
    ensure_extra("sim")
    from mansion_skills import Robot
    from mansion_skills.vision import Camera
    from mansion_skills.vision.viewpoint import stand_at

    robot = Robot(building, session)
    stand_at(robot.engine.session(robot.session), room, floor, turn)
    with Camera(robot, width, height, fov) as camera:
        pictures = _pictures(robot, camera, what, room, floor, per_page)
    stems = [output.stem] if len(pictures) == 1 else [f"{output.stem}_{k}" for k, _ in enumerate(pictures, start=1)]
    paths = [output.with_stem(stem) for stem in stems]
    for picture, path in zip(pictures, paths, strict=True):
        _save(picture, path)
        if not as_json:
            out.print(str(path), highlight=False, soft_wrap=True)
    if as_json:
        print_json({"pictures": [str(path) for path in paths]})


def _pictures(
    robot: "Robot", camera: "Camera", what: Picture, room: str, floor: int | None, per_page: int
) -> list[Any]:
    import numpy as np

    from mansion_skills.vision.contact_shading import contact_shaded

    if what is Picture.PANORAMA:
        return [camera.panorama(room or str(robot.where_am_i().room))]
    if what is Picture.LANDMARKS:
        return list(camera.landmark_pages(per_page, floor))
    if what is Picture.LIFT:
        return [camera.lift_panel()]
    if what is Picture.STAIRS:
        return [camera.stairs_view()]
    frame = camera.render()
    if what is Picture.DEPTH:
        # Near is bright: half of the grey levels belong to the first three metres.
        return [np.round(255.0 * 3.0 / (3.0 + frame.depth)).astype(np.uint8)]
    if what is Picture.SEGMENTATION:
        # Knuth's multiplicative hash spreads neighbouring labels over the colours.
        code = (frame.segmentation.astype(np.int64) + 1) * 2654435761 % 2**24
        return [np.stack([code >> 16, code >> 8 & 255, code & 255], axis=-1).astype(np.uint8)]
    return [contact_shaded(frame.rgb, frame.depth, camera.intrinsics.focal)]


def _save(picture: Any, path: Path) -> None:
    from PIL import Image

    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(picture).save(path)
