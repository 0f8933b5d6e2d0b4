"""``mansion bench gallery``: rooms from several systems side by side for a study, and its tally."""

from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import err
from mansion_bringup.cli.outputs import check_output_folder
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.placement import PlacementResult
from mansion_msgs_py.reading import read_payload

__all__ = ["gallery"]


def gallery(
    rooms: Annotated[Path, typer.Argument(help="JSON list of rooms with their objects.")],
    systems: Annotated[list[str], typer.Argument(help="NAME=PLACEMENTS.json for each system; may be repeated.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for pages, form and key.")],
    seed: Annotated[int, typer.Option(min=0, help="Decides the order of panels.")] = 0,
    runs: Annotated[int, typer.Option(min=1, help="Runs of a room shown for a system.")] = 2,
    answers: Annotated[list[Path] | None, typer.Option(help="Saved answers: print their tally instead.")] = None,
) -> None:
    """Lay the same rooms of several systems side by side, unlabelled, with a key file.

    A system's files may hold several runs of a room, or be given several times.

    Examples:

      mansion bench gallery rooms.json ours=a.json ours=b.json other=c.json -o gallery

      mansion bench gallery rooms.json ours=a.json other=c.json -o gallery --answers answers.json
    """
    from mansion_export.gallery import Answer, GalleryKey, gallery_files, tally
    from mansion_scene.placement.files import load_rooms

    if answers:
        key = read_payload(GalleryKey, output / "key.json")
        given = [entry for file in answers for entry in read_payload(list[Answer], file)]
        for question, shares in tally(given, key).items():
            line = ", ".join(f"{name} {share:.0%}" for name, share in shares.items())
            typer.echo(f"{question:10} {line}")
        return
    check_output_folder(output)
    results: dict[str, list[PlacementResult]] = {}
    for entry in systems:
        name, separator, file = entry.partition("=")
        if not name or not separator:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD, f"{entry!r} does not read NAME=PLACEMENTS.json", path="$.systems"
            )
        results.setdefault(name, []).extend(read_payload(list[PlacementResult], Path(file)))
    files = gallery_files(load_rooms(rooms), results, seed=seed, runs=runs)
    for file_name, data in files.items():
        write_atomic(output / file_name, data)
    err.print(f"wrote {len(files) - 2} pages, form.html and key.json to {output}", highlight=False)
