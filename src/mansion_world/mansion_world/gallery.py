"""The gallery of a world: an HTML page of pictures of its buildings, with filters; it loads nothing from elsewhere."""

from collections.abc import Iterator
from html import escape
from importlib.resources import files
from typing import Any, Final

from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import encode
from mansion_world.records import Record
from mansion_world.world_folder import WorldFolder

__all__ = ["gallery_page"]

_DATA: Final = "/*buildings*/"
_TITLE: Final = "<!--title-->"


def gallery_page(world: WorldFolder) -> str:
    """Return the page; pictures and plans are linked relative to the world's folder, where it belongs.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when there is no world.
    """
    world.index()
    page = (files("mansion_world") / "data" / "gallery.html").read_text(encoding="utf-8")
    name = world.path.resolve().name
    records = (record for record in world.records() if (world.path / record.building.path).is_dir())
    cards = encode([_card(world, record) for record in records])
    # No sentence may end the script that it stands in.
    return page.replace(_TITLE, escape(name)).replace(_DATA, cards.replace("<", "\\u003c"))


def _card(world: WorldFolder, record: Record) -> dict[str, Any]:
    row = record.building
    folder = BuildingFolder(world.path / row.path)
    return {
        "index": row.index,
        "text": row.description,
        "kind": row.kind,
        "part": row.sub_kind,
        "split": row.split,
        "difficulty": row.difficulty,
        "floors": row.floors,
        "rooms": row.rooms,
        "objects": row.objects,
        "area": row.area,
        "tasks": [task.instruction for task in record.tasks],
        "picture": f"{row.path}/{folder.building.files.get('picture', 'building.png')}",
        "plans": list(_plans(folder, row.path)),
    }


def _plans(folder: BuildingFolder, path: str) -> Iterator[str]:
    for floor in folder.floors:
        name = folder.entry(floor).files.get("plan_svg") or f"floors/floor_{floor}/plan.svg"
        if (folder.path / name).is_file():
            yield f"{path}/{name}"
