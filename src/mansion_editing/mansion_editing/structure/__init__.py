"""Changes to finished storeys: areas, doors and places of rooms, further cores, with all else held where it is."""

from mansion_editing.structure.areas import change_area
from mansion_editing.structure.cores import add_core
from mansion_editing.structure.doors import add_door
from mansion_editing.structure.storey_documents import Reshaped, Storey, Workshop, storey_of, updated_building
from mansion_editing.structure.swaps import swap_rooms

__all__ = [
    "Reshaped",
    "Storey",
    "Workshop",
    "add_core",
    "add_door",
    "change_area",
    "storey_of",
    "swap_rooms",
    "updated_building",
]
