"""``mansion export`` and ``mansion view``: a building for other programs and for people."""

import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import check_output_file, check_output_folder, err
from mansion_bringup.extras import ensure_extra
from mansion_export.formats import export_formats
from mansion_geometry.sound_shapes import require_sound_shapes
from mansion_msgs_py.building_folder import BuildingFolder, file_in
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.wording import counted

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.command("export", no_args_is_help=True)(export)
    app.command("view", no_args_is_help=True)(view)


def export(
    building: Annotated[Path, typer.Argument(help="Folder that `mansion build` wrote.")],
    to: Annotated[str, typer.Option("--to", help=", ".join(export_formats()))],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder; the building's own when absent.")
    ] = None,
) -> None:
    """Write a building in another program's format.

    Examples:

      mansion export out/office --to thor

      mansion export out/office --to sdf -o gazebo/office
    """
    formats = export_formats()
    if to not in formats:
        known = ", ".join(formats)
        raise MansionError(ErrorCode.NOT_FOUND, f"no format {to!r}; use one of {known}", path="$.to")
    read, target = BuildingFolder(building), output or building
    check_output_folder(target)
    if extra := formats[to].extra:
        ensure_extra(extra)
    scenes = read.scenes()
    require_sound_shapes(scenes)
    files = formats[to].make(scenes)
    for name, data in files.items():
        write_atomic(file_in(target, name), data)
    size = sum(len(data) for data in files.values()) / 1e6
    err.print(f"wrote {counted(len(files), 'file')}, {size:.1f} MB, to {target}", highlight=False)
    for name in [name for name in files if not name.startswith("meshes/")]:
        typer.echo(str(target / name))


def view(
    building: Annotated[Path, typer.Argument(help="Folder that `mansion build` wrote.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Page to write; DIR/view.html if absent.")
    ] = None,
    show: Annotated[bool, typer.Option("--open", help="Open it in the browser.")] = False,
) -> None:
    """Write a self-contained page with the 3D building, floor by floor.

    Examples:

      mansion view out/office --open
    """
    from mansion_export.html import view_page

    page = output or building / "view.html"
    scenes = BuildingFolder(building).scenes()
    require_sound_shapes(scenes)
    check_output_file(page)
    write_atomic(page, view_page(scenes).encode())
    typer.echo(str(page))
    if show:
        webbrowser.open(page.absolute().as_uri())
