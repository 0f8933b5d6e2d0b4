"""``mansion export`` and ``mansion view``: a building for other programs and for people."""

import webbrowser
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import err
from mansion_bringup.cli.outputs import check_output_file, check_output_folder
from mansion_bringup.extras import ensure_extra
from mansion_msgs_py.building_folder import BuildingFolder, floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic

__all__ = ["EXPORTS", "register"]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.command("export", no_args_is_help=True)(export)
    app.command("view", no_args_is_help=True)(view)


def _thor(building: BuildingFolder) -> dict[str, bytes]:
    from mansion_export.thor import house

    return {f"{floor_directory(scene.floor)}/house.json": encode_bytes(house(scene)) for scene in building.scenes()}


def _glb(building: BuildingFolder) -> dict[str, bytes]:
    from mansion_export.glb import building_glb, floor_glb

    scenes = building.scenes()
    files = {f"{floor_directory(scene.floor)}/floor.glb": floor_glb(scene) for scene in scenes}
    return {"building.glb": building_glb(scenes), **files}


def _mjcf(building: BuildingFolder) -> dict[str, bytes]:
    from mansion_export.mjcf import floor_mjcf

    files = {}
    for scene in building.scenes():
        model = floor_mjcf(scene)
        files[f"{floor_directory(scene.floor)}/model.xml"] = model.xml.encode()
        files.update({f"meshes/{name}": data for name, data in model.meshes.items()})
    return files


def _nav2(building: BuildingFolder) -> dict[str, bytes]:
    from mansion_export.nav2 import map_pgm, map_yaml

    files = {}
    for scene in building.scenes():
        folder = floor_directory(scene.floor)
        files[f"{folder}/map.pgm"] = map_pgm(scene)
        files[f"{folder}/map.yaml"] = map_yaml(scene).encode()
    return files


def _usd(building: BuildingFolder) -> dict[str, bytes]:
    ensure_extra("usd")
    from mansion_export.usd import building_usd

    return {"building.usdc": building_usd(building.scenes())}


def _sdf(building: BuildingFolder) -> dict[str, bytes]:
    from mansion_export.sdf import world_sdf

    world = world_sdf(building.scenes())
    return {"building.sdf": world.xml.encode(), **{f"meshes/{name}": data for name, data in world.meshes.items()}}


def _rmf(building: BuildingFolder) -> dict[str, bytes]:
    from mansion_export.rmf.maps import rmf_files

    return rmf_files(building.scenes())


EXPORTS: dict[str, Callable[[BuildingFolder], dict[str, bytes]]] = {
    "thor": _thor,
    "glb": _glb,
    "mjcf": _mjcf,
    "nav2": _nav2,
    "usd": _usd,
    "sdf": _sdf,
    "rmf": _rmf,
}


def export(
    building: Annotated[Path, typer.Argument(help="Folder that `mansion build` wrote.")],
    to: Annotated[str, typer.Option("--to", help=", ".join(EXPORTS))],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder; the building's own when absent.")
    ] = None,
) -> None:
    """Write a building in another program's format.

    Examples:

      mansion export out/office --to thor

      mansion export out/office --to sdf -o gazebo/office
    """
    if to not in EXPORTS:
        known = ", ".join(EXPORTS)
        raise MansionError(ErrorCode.NOT_FOUND, f"no format {to!r}; use one of {known}", path="$.to")
    read, target = BuildingFolder(building), output or building
    check_output_folder(target)
    files = EXPORTS[to](read)
    for name, data in files.items():
        write_atomic(target / name, data)
    size = sum(len(data) for data in files.values()) / 1e6
    err.print(f"wrote {len(files)} files, {size:.1f} MB, to {target}", highlight=False)
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
    check_output_file(page)
    write_atomic(page, view_page(scenes).encode())
    typer.echo(str(page))
    if show:
        webbrowser.open(page.absolute().as_uri())
