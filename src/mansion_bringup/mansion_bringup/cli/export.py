"""``mansion export`` and ``mansion view``: a building for other programs and for people."""

import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import (
    AsJson,
    BuildingArgument,
    check_output_file,
    check_output_folder,
    err,
    print_json,
)
from mansion_bringup.exporting import PAGE, format_named, write_export, write_page
from mansion_bringup.time_estimates import model_seconds, notice
from mansion_export.formats import ExportOptions, export_formats
from mansion_msgs_py.building_folder import check_building_folder
from mansion_msgs_py.wording import counted

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.command("export", no_args_is_help=True)(export)
    app.command("view", no_args_is_help=True)(view)


def export(
    building: BuildingArgument,
    to: Annotated[str, typer.Option("--to", help=", ".join(export_formats()))],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder; the building's own when absent.")
    ] = None,
    articulated: Annotated[
        bool, typer.Option("--articulated", help="Joints for doors, drawers, lids and lift leaves (mjcf, sdf, usd).")
    ] = False,
    site: Annotated[bool, typer.Option("--site/--no-site", help="Include the plot around the building.")] = True,
    as_json: AsJson = False,
) -> None:
    """Write a building in another program's format.

    Examples:

      mansion export out/office --to thor

      mansion export out/office --to sdf -o gazebo/office

      mansion export out/office --to mjcf --articulated

      mansion export out/office --to glb --no-site -o models
    """
    chosen, target = format_named(to), output or building
    check_building_folder(building)
    check_output_folder(target)
    files = write_export(building, chosen, output, ExportOptions(articulated=articulated, site=site))
    size = sum(file.stat().st_size for file in files) / 1e6
    err.print(f"wrote {counted(len(files), 'file')}, {size:.1f} MB, to {target}", highlight=False)
    if as_json:
        print_json({"format": chosen.name, "folder": str(target), "files": [str(file) for file in files]})
        return
    for file in files:
        if file.relative_to(target).parts[0] != "meshes":
            typer.echo(str(file))


def view(
    building: BuildingArgument,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Page to write; DIR/view.html if absent.")
    ] = None,
    site: Annotated[bool, typer.Option("--site/--no-site", help="Include the plot around the building.")] = True,
    show: Annotated[bool, typer.Option("--open", help="Open it in the browser.")] = False,
    as_json: AsJson = False,
) -> None:
    """Write a self-contained page with the 3D building, floor by floor.

    Examples:

      mansion view out/office --open
    """
    check_building_folder(building)
    check_output_file(output or building / PAGE)
    if told := notice(building, "the page", model_seconds):
        err.print(told, highlight=False)
    page = write_page(building, output, site=site)
    if as_json:
        print_json({"page": str(page)})
    else:
        typer.echo(str(page))
    if show:
        webbrowser.open(page.absolute().as_uri())
