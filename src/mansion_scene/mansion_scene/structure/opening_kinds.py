"""What kind of door stands between two regions, how wide it is, and into which of them it opens."""

from dataclasses import dataclass

from mansion_msgs_py.scene import DoorKind
from mansion_scene.structure.dimensions import CLEAR_WIDTH
from mansion_scene.structure.regions import Region
from mansion_scene.structure.room_classes import is_class

__all__ = ["OpeningKind", "entrance_kind", "is_circulation", "opening_kind", "room_after_door"]

_LARGE_PUBLIC = 45.0  # square metres from which a public room gets a double door


@dataclass(frozen=True)
class OpeningKind:
    """A kind of door, its wished clear width in metres, and its leaf's material."""

    kind: DoorKind
    width: float
    material: str = ""

    @property
    def leaves(self) -> int:
        """Hinged leaves: 0 for a passage, a sliding door or a garage door."""
        if self.kind in ("open", "doorway", "sliding", "frame", "garage"):
            return 0
        return 2 if self.width >= 1.4 else 1


def is_circulation(region: Region) -> bool:
    """Whether people pass through the region on their way."""
    return region.node_kind == "main" or is_class(region.room_type, "circulation")


def room_after_door(a: Region, b: Region) -> Region:
    """Return which of two rooms the door serves: not circulation, not the larger."""
    if is_circulation(a) != is_circulation(b):
        return b if is_circulation(a) else a
    for name in ("wet", "store"):
        if is_class(a.room_type, name) != is_class(b.room_type, name):
            return a if is_class(a.room_type, name) else b
    return min(a, b, key=lambda region: (round(region.polygon.area, 3), region.id))


def opening_kind(a: Region, b: Region) -> OpeningKind:
    """Return the kind of door between two regions of which at most one is a core."""
    for core in (a, b):
        if core.kind == "elevator":
            return OpeningKind("sliding", 1.0, "brushed_steel")
        if core.kind == "stair":
            return OpeningKind("frame", 1.1, "painted_steel")
    if is_class(a.room_type, "outdoor") or is_class(b.room_type, "outdoor"):
        return OpeningKind("balcony", CLEAR_WIDTH, "glass")
    if is_circulation(a) and is_circulation(b):
        return OpeningKind("doorway", 1.4, "painted_wood")
    served = room_after_door(a, b)
    kind, area = served.room_type, served.polygon.area
    if is_class(kind, "wet") or is_class(kind, "store") or is_class(kind, "sleeping"):
        return OpeningKind("single", CLEAR_WIDTH, "painted_wood")
    if is_class(kind, "assembly"):
        return OpeningKind("double", 1.6 if area >= _LARGE_PUBLIC else 1.4, "painted_wood")
    large = area >= _LARGE_PUBLIC
    if is_class(kind, "clinical"):
        # Beds pass through.
        return OpeningKind("double" if large else "single", 1.6 if large else 1.2, "light_wood")
    if is_class(kind, "teaching"):
        return OpeningKind("double" if large else "single", 1.4 if large else 1.0, "light_wood")
    if is_class(kind, "office") and not _is_private_study(kind):
        return OpeningKind("glazed", 1.6 if large else CLEAR_WIDTH, "glass")
    if is_class(kind, "living"):
        return OpeningKind("doorway", 1.2, "painted_wood")
    return OpeningKind("single", CLEAR_WIDTH, "painted_wood")


def _is_private_study(room_type: str) -> bool:
    return "home" in room_type.lower() or room_type.lower() in ("study", "den")


def entrance_kind(public: bool) -> OpeningKind:
    """Return the kind of the building's entrance: a double glazed one, or a house door."""
    return OpeningKind("entrance", 1.8, "glass") if public else OpeningKind("entrance", 1.0, "dark_wood")
