"""Which objects people would ask to be put into a container, onto a surface or into a room.

Objects have kinds (chilled, tableware, stationery, ...); a container accepts some kinds, and each kind is used or kept
in some rooms. Unknown containers and rooms accept everything, and unknown objects go anywhere.
"""

from collections.abc import Iterable
from typing import Final

from mansion_knowledge import uses_of
from mansion_msgs_py.scene import SceneObject, SceneRoom

__all__ = ["suits_container", "suits_surface", "suits_room", "is_requested", "kinds_of"]

_KINDS: Final = {
    "chilled": (
        "cola_can juice_carton milk_carton yogurt cheese butter egg lettuce beer_bottle "
        "wine_bottle water_bottle bottle water_jug jam_jar sandwich cake lunch_box apple orange "
        "banana lemon tomato fruit_bowl"
    ),
    "food": (
        "cereal_box canned_food bread potato tea_box coffee_bag sugar_jar donut_box "
        "popcorn_bucket jam_jar apple orange banana lemon tomato fruit_bowl wine_bottle "
        "water_bottle bottle sandwich cake cola_can juice_carton salt_shaker"
    ),
    "drink": ("cola_can juice_carton water_bottle bottle mug cup glass thermos teapot"),
    "baked": "pan pot bread cake potato",
    "warmed": "plate bowl mug cup sandwich lunch_box potato popcorn_bucket",
    "tableware": (
        "plate bowl cup mug glass wine_glass fork knife butter_knife spoon pepper_shaker "
        "napkin_holder teapot thermos tray fruit_bowl sugar_jar lunch_box water_jug tea_box "
        "salt_shaker"
    ),
    "cookware": (
        "pan pot ladle spatula cutting_board knife_block rice_cooker kettle blender aluminum_foil "
        "paper_towel_roll dish_sponge dish_rack"
    ),
    "washed": (
        "plate bowl cup mug glass wine_glass fork knife butter_knife spoon pan pot ladle spatula "
        "cutting_board lunch_box"
    ),
    "stationery": (
        "notebook paper_stack folder document_tray pen_holder stapler scissors calculator "
        "tape_dispenser envelope usb_stick badge clipboard pen pencil crayons painting_brush "
        "laptop tablet cd"
    ),
    "reading": "book book_stack magazine newspaper menu_card sheet_music hymn_book cd notebook",
    "medical": (
        "pill_bottle medicine_box syringe thermometer stethoscope glove_box kidney_dish bandage "
        "hand_sanitizer clipboard scissors"
    ),
    "lab": (
        "microscope test_tube_rack flask beaker petri_dish pipette lab_scale safety_goggles "
        "bunsen_burner glove_box notebook"
    ),
    "cultures": "test_tube_rack flask beaker petri_dish",
    "bath": (
        "soap_bar soap_bottle shampoo toothbrush_cup toothpaste hair_dryer hair_brush perfume "
        "cosmetics_bag hand_sanitizer tissue_box"
    ),
    "linen": "towel hand_towel folded_towels cloth blanket pillow throw_pillow cushion throw_blanket",
    "towels": "towel hand_towel folded_towels cloth",
    "clothing": ("boots sneakers slippers umbrella handbag backpack work_gloves hard_hat suitcase shopping_bag wallet"),
    "personal": (
        "key_chain watch credit_card cell_phone tablet headphones remote_control camera "
        "game_controller alarm_clock tissue_box laptop flashlight wallet handbag badge radio "
        "perfume"
    ),
    "valuable": (
        "wallet key_chain watch credit_card handbag laptop tablet cell_phone camera usb_stick folder envelope trophy"
    ),
    "toy": (
        "teddy_bear basketball baseball_bat toy_car toy_blocks doll football board_game chess_set "
        "game_console game_controller ball crayons"
    ),
    "sport": "tennis_racket basketball baseball_bat football dumbbell ball",
    "tool": (
        "hammer screwdriver wrench power_drill toolbox paint_can bucket flashlight cable_reel "
        "small_parts_bin tape_measure plastic_crate watering_can battery work_gloves hard_hat "
        "detergent scrub_brush dumbbell spray_bottle"
    ),
    "decor": (
        "statue table_top_decor flower_vase vase candle picture_frame small_plant trophy globe "
        "gift_box box basket flower_pot_seedling violin chess_set"
    ),
    "post": "package gift_box envelope box plastic_crate",
    "waste": "newspaper cola_can bottle beer_bottle tissue_box popcorn_bucket package magazine",
    "device": (
        "keyboard mouse laptop tablet headphones calculator camera game_controller game_console "
        "radio microphone webcam usb_stick battery"
    ),
}
_KINDS_OF: Final[dict[str, frozenset[str]]] = {
    category: frozenset(kind for kind, names in _KINDS.items() if category in names.split())
    for category in " ".join(_KINDS.values()).split()
}

_ACCEPTED_KINDS: Final = {
    "fridge freezer minibar display_fridge freezer_chest": "chilled",
    "microwave": "warmed",
    "stove oven commercial_stove commercial_oven": "baked",
    "toy_kitchen": "toy",
    "dishwasher": "washed",
    "washing_machine laundry_hamper clothes_dryer laundry_machine_stack industrial_washer": "linen",
    "wheelie_bin waste_bin": "waste",
    "bathroom_cabinet": "bath linen medical",
    "nightstand bedside_cabinet": "personal reading medical",
    "wardrobe": "clothing linen",
    "sideboard china_cabinet": "tableware decor reading stationery",
    "service_station": "tableware",
    "storage_chest": "toy linen tool decor sport",
    "safe": "valuable",
    "tool_cabinet": "tool",
    "kitchen_counter kitchen_island": "tableware cookware food",
    "wall_cabinet": "tableware cookware food lab",
    "filing_cabinet pedestal_drawer card_catalog": "stationery reading",
    "storage_cabinet": "stationery reading device tool lab medical toy sport decor linen",
    "locker": "clothing personal sport reading",
    "parcel_locker": "post",
    "chemical_cabinet": "lab",
    "incubator": "cultures",
    "infant_incubator": "",
    "crash_cart medicine_cart medicine_cabinet medicine_wall_cabinet": "medical",
}
_KINDS_BY_CONTAINER: Final = {
    category: frozenset(kinds.split())
    for categories, kinds in _ACCEPTED_KINDS.items()
    for category in categories.split()
}

_SOFT: Final = ("bed", "sofa", "loveseat", "stretcher")
_ON_SOFT: Final = frozenset(["linen", "clothing", "toy", "reading", "personal"])
_TREATMENT: Final = ("exam_table", "operating_table", "massage_table", "changing_table")
_ON_TREATMENT: Final = frozenset(["linen", "medical"])
_ROUGH: Final = frozenset(["tool", "sport"])
_DIRTY: Final = frozenset(["boots", "sneakers", "slippers", "plastic_crate", "bucket", "suitcase"])
_FOR_WORK: Final = ("workbench", "lab_bench", "lab_island", "packing_table", "folding_table")

_AT_A_SCREEN: Final = ("desk", "table", "bench", "island")
_TALL_ENOUGH: Final = ("dresser", "nightstand", "sideboard", "bench")
_LAID_FLAT: Final = frozenset(["cd", "menu_card", "sheet_music", "hymn_book"])
"""Reading matter that people put on a table but not on a bed."""

_NEVER_BROUGHT: Final = frozenset([
    "toilet_brush", "toilet_paper", "plunger", "fire_extinguisher", "book_upright", "urine_bottle", "kidney_dish",
    "table_lamp", "desktop_printer", "monitor", "computer_tower", "telephone", "router", "speaker_small",
    "cash_register", "card_reader", "webcam", "dish_rack", "footstool", "napkin_holder",
])  # fmt: skip
"""Objects that nobody asks a robot to bring: plugged in, used in one place, or unclean."""

_USES_BY_KIND: Final = {
    "chilled": frozenset(["eating", "homes"]),
    "food": frozenset(["eating", "homes", "shops"]),
    "drink": frozenset(["eating", "meeting", "desks", "beds", "homes", "care"]),
    "baked": frozenset(["eating", "homes"]),
    "tableware": frozenset(["eating", "homes"]),
    "cookware": frozenset(["eating", "homes"]),
    "stationery": frozenset(["meeting", "desks", "machines", "homes", "post", "labs"]),
    "reading": frozenset(["meeting", "desks", "beds", "homes", "lounging", "showing"]),
    "medical": frozenset(["care", "beds"]),
    "lab": frozenset(["labs"]),
    "cultures": frozenset(["labs"]),
    "bath": frozenset(["washing", "homes", "laundry"]),
    "linen": frozenset(["beds", "homes", "lounging", "laundry", "care"]),
    "towels": frozenset(["washing", "laundry", "homes"]),
    "clothing": frozenset(["beds", "homes", "wraps"]),
    "personal": frozenset(["meeting", "desks", "beds", "homes", "lounging"]),
    "toy": frozenset(["play", "homes", "lounging", "bedrooms"]),
    "sport": frozenset(["sport", "play", "wraps", "stores"]),
    "tool": frozenset(["stores"]),
    "decor": frozenset(["meeting", "desks", "eating", "beds", "homes", "lounging", "showing", "shops"]),
    "post": frozenset(["post", "stores", "machines"]),
    "device": frozenset(["desks", "machines", "presenting", "homes", "lounging"]),
}
"""Uses of the rooms in which objects of a kind are used or kept."""


def kinds_of(item: SceneObject) -> frozenset[str]:
    """Return the kinds of an object; none for an unknown category."""
    return _KINDS_OF.get(item.category, frozenset())


def is_requested(item: SceneObject) -> bool:
    """Whether people would ask for an object to be brought somewhere."""
    return item.category not in _NEVER_BROUGHT


def suits_container(item: SceneObject, container: SceneObject) -> bool:
    """Whether an object is of a kind that a container is for: milk for a fridge, but no vase for a stove."""
    accepted = _KINDS_BY_CONTAINER.get(container.category)
    return accepted is None or bool(kinds_of(item) & accepted)


def suits_surface(item: SceneObject, surface: SceneObject) -> bool:
    """Whether people would put an object on a piece of furniture: a book on a bed, but no juice."""
    kinds = kinds_of(item)
    if not kinds:
        return True
    if surface.category.endswith(_TREATMENT):
        return bool(kinds & _ON_TREATMENT)
    if surface.category.endswith(_SOFT):
        return bool(kinds & _ON_SOFT) and item.category not in (*_DIRTY, *_LAID_FLAT)
    if kinds <= {"linen", "towels"}:
        return surface.category.endswith(_TALL_ENOUGH)
    if kinds == {"device"}:
        return surface.category.endswith(_AT_A_SCREEN)
    if surface.category in _FOR_WORK:
        return True
    return item.category not in _DIRTY and not kinds <= _ROUGH


def suits_room(item: SceneObject, room: SceneRoom) -> bool:
    """Whether objects of this kind are used or kept in a room."""
    kinds = kinds_of(item)
    return not kinds or _is_used_in(kinds, room.room_type)


def _is_used_in(kinds: Iterable[str], room_type: str) -> bool:
    """Whether one of some kinds is used or kept in a room; anything is in rooms of an unknown type.

    Examples
    --------
    >>> _is_used_in(["personal"], "private_office"), _is_used_in(["personal"], "commercial_kitchen")
    (True, False)
    """
    uses = uses_of(room_type)
    if not uses - {"passing"}:
        return "passing" not in uses
    return any(not uses.isdisjoint(_USES_BY_KIND.get(kind, ())) for kind in kinds)
