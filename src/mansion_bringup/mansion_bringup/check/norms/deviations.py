"""All deviations of a finished building from the rules of building, and those that its brief asks for."""

from collections.abc import Sequence
from pathlib import Path

import msgspec

from mansion_bringup.check.norms.access import access_deviations
from mansion_bringup.check.norms.escape import escape_deviations
from mansion_bringup.check.norms.exit_routes import exit_route_deviations
from mansion_bringup.check.norms.premises import Deviation, Premises, premises_of
from mansion_bringup.check.norms.room_quality import room_deviations
from mansion_bringup.check.norms.room_relations import relation_deviations
from mansion_bringup.check.norms.sanitary import sanitary_deviations
from mansion_bringup.check.norms.sleeping_units import unit_deviations
from mansion_knowledge.norms import Norm
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import BuildingFolder, check_building_folder
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.wishes import Wish

__all__ = ["check_norms", "norms_of_folder"]


def check_norms(building: Building, scenes: Sequence[FloorScene]) -> list[Deviation]:
    """Return the deviations of a finished building from the rules of building.

    Those that the brief asks for explicitly name its words in `caused_by`.
    """
    premises = premises_of(building, scenes)
    found = [
        *sanitary_deviations(premises),
        *unit_deviations(premises),
        *escape_deviations(premises),
        *exit_route_deviations(premises),
        *access_deviations(premises),
        *room_deviations(premises),
        *relation_deviations(premises),
    ]
    return sorted({msgspec.structs.replace(item, caused_by=_cause_of(premises, item)) for item in found})


def _cause_of(premises: Premises, deviation: Deviation) -> str:
    """Return the words of the brief that ask for a deviation explicitly; empty where none do."""
    norm = premises.norms.rules[deviation.rule]
    if "outline" in norm.gives_way and premises.building.request.footprint is not None:
        return "the given footprint"
    wishes = (wish for wish in premises.building.wishes if wish.kind in norm.gives_way and wish.status == "met")
    return next((wish.text for wish in wishes if _asks_for_it(wish, norm, deviation)), "")


def _asks_for_it(wish: Wish, norm: Norm, deviation: Deviation) -> bool:
    value = wish.value
    concerned = any(room in deviation.where.split(" and ") for room in wish.rooms)
    match wish.kind:
        case "room" if norm.yields_to:
            return value.count is not None and value.type in norm.yields_to
        case "room":
            return concerned and value.area is not None
        case "no_room":
            return value.type in (*norm.yields_to, *norm.rooms, *norm.others)
        case "elevator":
            return value.unwanted
        case "stair":
            return value.unwanted or value.count == 1
        case "adjacent" | "apart" | "object" | "no_object":
            return concerned
        case "only" | "total_area" | "floor_area":
            return True
    return False


def norms_of_folder(path: Path | str) -> list[Deviation]:
    """Return the deviations of the building in a folder.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `path` is not a building folder; ``INVALID_PAYLOAD`` for a file that cannot be read.
    """
    folder = Path(path)
    check_building_folder(folder)
    read = BuildingFolder(folder)
    return check_norms(read.building, read.scenes())
