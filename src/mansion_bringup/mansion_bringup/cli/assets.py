"""``mansion assets``: the catalogue, and libraries of the user's own assets."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.table import Table

from mansion_bringup.cli.console import AsJson, check_output_file, complaints, err, out, print_json
from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.wording import choices, counted

if TYPE_CHECKING:
    from mansion_assets.catalogue import Asset, Catalogue
    from mansion_assets.library.adding import Addition

__all__ = ["register"]

Libraries = Annotated[
    list[str] | None,
    typer.Option("--library", "-l", help="A library by name, or by a path with a slash in it; may be repeated."),
]
Words = Annotated[list[str] | None, typer.Argument(help="Search words: tall shelf, something to sit on.")]
Category = Annotated[str, typer.Option("--category", "-c", help="Only assets of this category.")]

FOUND = 40
"""Assets that words find at most."""

ON_A_SHEET = 96
"""Assets of a sheet at most."""


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    group = typer.Typer(help="The catalogue of furniture, and libraries of your own assets.", no_args_is_help=True)
    group.command("list")(list_assets)
    group.command("show", no_args_is_help=True)(show)
    group.command("sheet", no_args_is_help=True)(sheet)
    group.command("check")(check)
    group.command("add", no_args_is_help=True)(add)
    app.add_typer(group, name="assets")


def list_assets(
    words: Words = None, library: Libraries = None, category: Category = "", as_json: AsJson = False
) -> None:
    """List assets: id, category, size in metres, source, licence.

    Without a library these are the package's and those of all your libraries; with one, its own.

    Examples:

      mansion assets list

      mansion assets list --library shop

      mansion assets list --category office_chair

      mansion assets list something to sit on --json
    """
    chosen, _ = _chosen(words, library, category)
    if as_json:
        print_json([_row(asset) for asset in chosen])
        return
    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in ("id", "category", "size (w x d x h)", "source", "licence"):
        table.add_column(title, no_wrap=True)
    for asset in chosen:
        row = _row(asset)
        table.add_row(asset.key, asset.category, _size(asset.size), row["source"], row["licence"])
    out.print(table, highlight=False)
    err.print(counted(len(chosen), "asset"), highlight=False)


def show(
    key: Annotated[str, typer.Argument(metavar="ID", help="Id of an asset, as `mansion assets list` shows it.")],
    library: Libraries = None,
    as_json: AsJson = False,
) -> None:
    """Show an asset: facts, parts, joints, receptacles, materials.

    Examples:

      mansion assets show Fridge_1

      mansion assets show shop.pinball_machine --json
    """
    from mansion_assets.meshes import links

    asset = _catalogue(library).asset(key)
    rigid = links(asset)
    parts = [
        {
            "part": link.name or "body",
            "triangles": sum(len(part.faces) for part in link.parts),
            "pieces": len(link.pieces),
            "joint": None
            if link.joint is None
            else {
                "kind": link.joint.kind,
                "axis": link.joint.axis,
                "origin": link.joint.origin,
                "travel": link.joint.travel,
            },
        }
        for link in rigid
    ]
    looks = {part.material.name: part.material.color for link in rigid for part in link.parts}
    facts = {**_row(asset), **_facts(asset), "parts": parts, "materials": looks}
    if as_json:
        print_json(facts)
        return
    for name, value in facts.items():
        _print_fact(name.replace("_", " "), value)


def sheet(
    output: Annotated[Path, typer.Option("--output", "-o", help="PNG file to write.")],
    words: Words = None,
    library: Libraries = None,
    category: Category = "",
    columns: Annotated[int, typer.Option(min=1, max=24, help="Pictures in a row.")] = 8,
    as_json: AsJson = False,
) -> None:
    """Draw assets on a contact sheet, with their names: of a category, a library, or what words find.

    Examples:

      mansion assets sheet -o chairs.png --category office_chair

      mansion assets sheet -o shop.png --library shop

      mansion assets sheet -o lamps.png reading lamp
    """
    from mansion_export.pictures.asset_picture import contact_sheet

    check_output_file(output)
    if not (words or library or category):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "name words, --category or --library; the catalogue is too large")
    chosen, catalogue = _chosen(words, library, category)
    if len(chosen) > ON_A_SHEET:
        err.print(f"the first {ON_A_SHEET} of {len(chosen)} assets", highlight=False)
    chosen = chosen[:ON_A_SHEET]
    write_atomic(output, contact_sheet(chosen, catalogue, columns=columns))
    if as_json:
        print_json({"picture": str(output), "assets": [asset.key for asset in chosen]})
    else:
        out.print(str(output), highlight=False, markup=False)


def check(library: Libraries = None, as_json: AsJson = False) -> None:
    """Check assets: meshes, pieces that collide, joints from closed to open, facts and files.

    Without a library these are the package's and those of all your libraries. A line for each fault; status 1 where
    there is one.

    Examples:

      mansion assets check --library shop

      mansion assets check --json
    """
    from mansion_assets.catalogue import load_catalogue
    from mansion_assets.library.faults import asset_faults, library_faults
    from mansion_assets.library.folders import known_libraries, library_folders

    folders = library_folders(library or known_libraries())
    faults = [fault for folder in folders for fault in library_faults(folder)]
    number = sum(1 for folder in folders for _ in (folder / "assets").glob("*.glb"))
    if not library:
        shipped = load_catalogue([]).assets.values()
        faults += [fault for asset in shipped for fault in asset_faults(asset)]
        number += len(shipped)
    if as_json:
        print_json({"assets": number, "faults": [fault._asdict() for fault in faults]})
    else:
        for fault in faults:
            out.print(str(fault), highlight=False, markup=False)
        err.print(f"{counted(number, 'asset')}, {counted(len(faults), 'fault')}", highlight=False)
    if faults:
        raise typer.Exit(1)


def add(
    paths: Annotated[
        list[Path], typer.Argument(metavar="PATH...", help="GLB, glTF, OBJ or URDF files, or folders of them.")
    ],
    library: Annotated[
        str, typer.Option("--library", "-l", help="Library to add to, by name, or by a path with a slash in it.")
    ],
    category: Annotated[
        str, typer.Option("--category", "-c", help="Category of all models; guessed for each one by default.")
    ] = "",
    licence: Annotated[
        str, typer.Option("--licence", "--license", help="For example CC-BY-4.0; kept in each record.")
    ] = "",
    author: Annotated[str, typer.Option(help="Who made them.")] = "",
    source: Annotated[str, typer.Option(help="Where they come from: an address, or a title.")] = "",
    rooms: Annotated[str, typer.Option(help="Room types that get them without being asked: lobby,cafe.")] = "",
    up: Annotated[str, typer.Option(help="Axis of meshes that points up, y or z; y if absent.")] = "",
    front: Annotated[str, typer.Option(help="Direction that the front of meshes faces: +z, -x, ...")] = "",
    triangles: Annotated[int, typer.Option(min=1, help="Most triangles of a model.")] = 100_000,
    replace: Annotated[bool, typer.Option("--replace", help="Replace assets of the same name.")] = False,
    as_json: AsJson = False,
) -> None:
    """Add models to a library of your own, with all that a building needs to know of them.

    What the files, and annotations beside them (objathor, Objaverse, AI2-THOR), do not state is worked out: category,
    front, size, surfaces, what collides, mass. Each line says which is which. Broken files are refused, and the rest is
    added; the status is then 1.

    Examples:

      mansion assets add pinball.glb --library shop --licence CC-BY-4.0

      mansion assets add downloads/chairs --library shop --category office_chair

      mansion assets add cabinet/mobility.urdf --library kitchen

      mansion assets add scan.obj --library ./my_assets --up z --front -y
    """
    from mansion_assets.catalogue import load_catalogue
    from mansion_assets.library.adding import add_models, models_below
    from mansion_assets.library.folders import library_folder
    from mansion_assets.library.preparing import AddOptions
    from mansion_export.pictures.asset_picture import source_thumbnail

    folder = library_folder(library)
    for path in paths:
        models_below(path)  # a path without models is refused before anything is installed
    options = AddOptions(
        category=category,
        licence=licence,
        author=author,
        source=source,
        rooms=tuple(_room_types(rooms)),
        up=_up(up),
        front=_front(front),
        triangles=triangles,
    )
    _provide_decomposition()
    results: list[Addition] = []
    for result in add_models(paths, folder, options, load_catalogue([]), source_thumbnail, replace=replace):
        results.append(result)
        if not as_json:
            _print_addition(result)
    refused = sum(result.status == "refused" for result in results)
    if as_json:
        print_json({"library": str(folder), "assets": to_builtins(results)})
    else:
        err.print(f"{folder}: {counted(len(results) - refused, 'asset')}, {refused} refused", highlight=False)
    if refused:
        raise typer.Exit(1)


def _provide_decomposition() -> None:
    """Install what makes convex hulls; without it pieces are boxes, which is said once."""
    from mansion_bringup.extras import ensure_extra

    try:
        ensure_extra("convex")
    except MansionError as error:
        err.print(f"collision shapes will be boxes, not convex hulls: {error.info.message}", highlight=False)


def _up(name: str) -> Any:
    if name not in ("", "y", "z"):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"{name!r} is not an axis that can point up; use y or z", path="$.up"
        )
    return name or None


def _front(name: str) -> Any:
    from mansion_assets.library.preparing import FRONTS

    if name and name not in FRONTS:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"no front faces {name!r}; use one of {', '.join(FRONTS)}", path="$.front"
        )
    return name or None


def _room_types(listed: str) -> list[str]:
    from mansion_assets.catalogue import load_catalogue

    known = load_catalogue([]).room_types
    found = [name.strip() for name in listed.split(",") if name.strip()]
    for name in found:
        if name not in known:
            raise MansionError(
                ErrorCode.NOT_FOUND,
                f"no room type {name!r} has furniture; {choices(name, known, 'room types')}",
                path="$.rooms",
            )
    return found


def _print_addition(result: "Addition") -> None:
    if result.status == "refused":
        complaints.print(f"refused {result.file}: {result.reason}", highlight=False, markup=False)
        return
    out.print(f"{result.status} {result.key}  {_size(result.size or ())}", highlight=False, markup=False)
    for title, facts in (("stated", result.stated), ("guessed", result.guessed)):
        for fact in facts:
            out.print(f"  {title:<8} {fact}", highlight=False, markup=False)


def _catalogue(library: list[str] | None) -> "Catalogue":
    from mansion_assets.catalogue import load_catalogue
    from mansion_assets.library.folders import known_libraries, library_folders

    return load_catalogue(library_folders(library or known_libraries()))


def _chosen(words: list[str] | None, library: list[str] | None, category: str) -> tuple[list["Asset"], "Catalogue"]:
    """Return the assets that words, libraries and a category choose, and the catalogue that holds them."""
    from mansion_assets.catalogue.search import search_assets

    catalogue = _catalogue(library)
    if category and category not in catalogue.categories:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no category {category!r}; {choices(category, catalogue.categories, 'categories')}",
            path="$.category",
        )
    if words:
        found = [hit.asset for hit in search_assets(catalogue, " ".join(words), FOUND if not library else 10_000)]
    else:
        found = list(catalogue.assets.values())
    chosen = [
        asset for asset in found if (asset.record or not library) and (not category or asset.category == category)
    ]
    if not chosen:
        raise MansionError(ErrorCode.NOT_FOUND, "no asset matches; `mansion assets list` lists all")
    return chosen, catalogue


def _row(asset: "Asset") -> dict[str, Any]:
    """Return the row of an asset in a list."""
    if asset.record:
        source, licence = asset.source or "own", asset.licence or "not stated"
    else:
        source, licence = ("AI2-THOR" if asset.asset_id else "Mansion"), "Apache-2.0"
    return {"id": asset.key, "category": asset.category, "size": asset.size, "source": source, "licence": licence}


def _facts(asset: "Asset") -> dict[str, Any]:
    facts: dict[str, Any] = {
        "name": asset.name,
        "synonyms": asset.synonyms,
        "stands": asset.mount,
        "pickupable": asset.pickupable,
        "openable": asset.openable,
        "toggleable": asset.toggleable,
        "rooms": asset.rooms,
        "surfaces": to_builtins(asset.surfaces),
        "volumes": to_builtins(asset.volumes),
        "mass": asset.mass,
    }
    return facts | _own_facts(asset) if asset.record else facts


def _own_facts(asset: "Asset") -> dict[str, Any]:
    from mansion_assets.catalogue.records import AssetRecord
    from mansion_msgs_py.files import read_payload

    record = read_payload(AssetRecord, Path(asset.record))
    return {
        "description": record.description,
        "author": record.author,
        "sha256": record.sha256,
        "file": asset.record,
        "stated": record.stated,
        "guessed": record.guessed,
    }


def _print_fact(name: str, value: Any) -> None:
    if value is None or value == "" or (isinstance(value, list | tuple | dict) and not value):
        return
    if name == "size":
        value = _size(value)
    if isinstance(value, dict):
        value = [f"{key} {each}" for key, each in value.items()]
    if isinstance(value, list | tuple) and value and isinstance(value[0], dict):
        value = [", ".join(f"{key} {_plain(each)}" for key, each in row.items() if each is not None) for row in value]
    if isinstance(value, list) and value:
        out.print(f"{name}:", highlight=False, markup=False)
        for each in value:
            out.print(f"  {each}", highlight=False, markup=False)
        return
    out.print(f"{name}: {_plain(value)}", highlight=False, markup=False)


def _plain(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, dict):
        return " ".join(f"{key} {_plain(each)}" for key, each in value.items())
    if isinstance(value, list | tuple):
        return ", ".join(map(_plain, value))
    return str(value)


def _size(size: Any) -> str:
    return " x ".join(f"{side:.2f}" for side in size) + " m"
