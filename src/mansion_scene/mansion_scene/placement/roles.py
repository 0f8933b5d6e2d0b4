"""Roles of objects in placement (seat, bed, table, board ...), read from the words of their category."""

import re
from typing import Literal, TypeAlias

from mansion_knowledge import kin_of, words_by

__all__ = ["Fitment", "Role", "is_public_room", "role_of"]

Fitment: TypeAlias = Literal["worktop", "sink", "dishwasher", "hob", "fridge"]

_WORDS = re.compile(r"[a-z]+")


def _set(text: str) -> frozenset[str]:
    return frozenset(_WORDS.findall(text))


_SEATS = _set("chair stool armchair seat recliner pew highchair rocker lounger")
_SOFAS = _set("sofa couch loveseat settee bench futon daybed")
_BEDS = _set("bed crib cot bunk stretcher gurney")
_FOCAL = _set(
    "teacher blackboard whiteboard chalkboard smartboard podium lectern stage altar projector instructor pulpit judge"
)
_CENTRED = _set(
    "bed sofa couch counter bar desk television tv fireplace piano stage altar podium lectern"
    " blackboard whiteboard reception"
)
_SYMMETRIC = _set("plant lamp bin basket vase can pot tree stand rack umbrella pouf ottoman pillar column")
_SCREENS = _set("tv television media")
_MACHINES = _set("bike elliptical rowing rower treadmill weight press")
_TABLES = _set("table desk island workbench counter")
_VEHICLES = _set("car truck van engine lorry tractor ambulance bus")
_BEDSIDE = frozenset({"nightstand", "bedside_table", "side_table"})
_FITMENTS: dict[str, Fitment] = {
    "counter_top": "worktop",
    "kitchen_counter": "worktop",
    "kitchen_sink_unit": "sink",
    "dishwasher": "dishwasher",
    "stove": "hob",
    "fridge": "fridge",
}
"""What stands in the run of a kitchen, by category."""

_STAFFED = frozenset({"reception_desk", "sales_counter"})
"""What staff stand or sit behind, with visitors before it, by category."""

_DRIVEN_BETWEEN = frozenset({"pallet_rack"})
"""What forklifts drive between, by category."""

_BACK_TO_BACK = frozenset({"pallet_rack", "metal_shelf", "shelving_unit", "archive_shelf"})
"""What is reached from its front alone, and stands in double rows away from walls, by category."""

_WALKED_ALONG = _BACK_TO_BACK | {"library_stack", "gondola_shelf", "locker"}
"""Shelves whose rows people walk between, by category."""

_ENTERED_AT_ENDS = frozenset({"pew"})
"""Seats for several that people slide into from an aisle on either side, by category."""

_ENTRANCE = _set("host hostess reception umbrella coat shoe doormat checkout cashier ticket turnstile")


class Role:
    """The use of an object, as far as its words tell.

    Attributes
    ----------
    seat : bool
        One person sits on it, facing what it belongs to.
    sofa, bed, focal, centred, symmetric, table, entrance : bool
        A wider seat; a bed (head at a wall); an object that a class faces; placed at the middle of a wall; without a
        front; a table or desk; placed near the door.
    screen : bool
        One watches it from a sofa.
    exercise : bool
        One moves on it, and needs room on both sides.
    bedside : bool
        It stands at the head of a bed.
    fitment : Fitment or None
        Its part in the run of a kitchen.
    staffed : bool
        Staff are behind it, and visitors come to its front.
    vehicle : bool
        It is driven in and out.
    driven_between : bool
        Forklifts need the wider aisle before it.
    back_to_back : bool
        Rows of it stand in pairs, their backs together.
    walked_along : bool
        People walk between its rows.
    entered_at_ends : bool
        Rows of it leave an aisle between two.
    """

    __slots__ = (
        *("back_to_back", "bed", "bedside", "centred", "driven_between", "entered_at_ends", "entrance", "exercise"),
        *("fitment", "focal"),
        *("screen", "seat", "sofa", "staffed", "symmetric", "table", "vehicle", "walked_along"),
    )

    def __init__(self, words: frozenset[str], category: str = "") -> None:
        self.bedside = category in _BEDSIDE
        self.staffed = category in _STAFFED
        self.driven_between = category in _DRIVEN_BETWEEN
        self.back_to_back = category in _BACK_TO_BACK
        self.walked_along = category in _WALKED_ALONG
        self.entered_at_ends = category in _ENTERED_AT_ENDS
        self.fitment = _FITMENTS.get(category)
        self.seat = bool(words & _SEATS)
        self.sofa = bool(words & _SOFAS)
        self.bed = bool(words & _BEDS)
        self.screen = bool(words & _SCREENS)
        self.exercise = bool(words & _MACHINES)
        self.vehicle = bool(words & _VEHICLES)
        self.table = bool(words & _TABLES) and not self.seat
        self.entrance = bool(words & _ENTRANCE) and not self.seat
        self.focal = bool(words & _FOCAL) and not self.seat
        self.centred = bool(words & _CENTRED) and not self.seat and self.fitment is None
        self.symmetric = bool(words & _SYMMETRIC) and not self.table


def role_of(name: str, category: str) -> Role:
    """Return the role that the words of an object's name and category imply."""
    text = f"{name} {category}".lower().replace("_", " ")
    words = _WORDS.findall(text)
    return Role(frozenset(words) | {word.removesuffix("s") for word in words}, category.lower().replace(" ", "_"))


def is_public_room(room_type: str) -> bool:
    """Tell whether a room of this type needs the wider public aisle."""
    words = _WORDS.findall(kin_of(room_type).lower().replace("_", " "))
    return bool(words) and not set(words_by("classes")["domestic"]).intersection(words)
