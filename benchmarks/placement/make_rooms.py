"""Write the rooms that the placement benchmark uses: twenty kinds, 10 to 130 objects each.

python benchmarks/placement/make_rooms.py benchmarks/placement/rooms.json
"""

import json
import sys
from pathlib import Path
from typing import Any

Json = dict[str, Any]


def obj(
    name: str,
    size: tuple[float, float, float],
    quantity: int = 1,
    where: str = "unconstrained",
    *,
    matrix: tuple[int, int] | None = None,
    paired: str | None = None,
    **relative: str,
) -> Json:
    """Return an object record; keyword arguments are relations, ``near="bed"``."""
    structure: Json = {"kind": "single"}
    if matrix:
        structure = {"kind": "matrix", "rows": matrix[0], "cols": matrix[1]}
        quantity = matrix[0] * matrix[1]
    if paired:
        structure = {"kind": "paired", "with": paired}
    return {
        "name": name,
        "category": name.replace("_", " "),
        "size": list(size),
        "quantity": quantity,
        "global": where,
        "structure": structure,
        "relative": [{"kind": k, "target": t} for k, t in relative.items()],
    }


def room(
    room_id: str,
    room_type: str,
    polygon: list[tuple[float, float]],
    doors: list[tuple[tuple[float, float], tuple[float, float]]],
    objects: list[Json],
    windows: list[tuple[tuple[float, float], tuple[float, float]]] = [],  # noqa: B006
    holes: list[list[tuple[float, float]]] = [],  # noqa: B006
) -> Json:
    """Return a room record."""
    return {
        "room_id": room_id,
        "room_type": room_type,
        "polygon": polygon,
        "doors": [{"id": f"door_{i}", "segment": s} for i, s in enumerate(doors)],
        "windows": [{"id": f"window_{i}", "segment": s} for i, s in enumerate(windows)],
        "holes": holes,
        "objects": objects,
    }


def box(w: float, h: float) -> list[tuple[float, float]]:
    """Return a rectangle from the origin."""
    return [(0, 0), (w, 0), (w, h), (0, h)]


ROOMS = [
    room(
        "library",
        "library",
        box(14, 10),
        [((6, 0), (7.8, 0)), ((14, 4), (14, 4.9))],
        [
            obj("book_shelf", (1.0, 0.4, 2.0), where="middle", matrix=(5, 6)),
            obj("wall_shelf", (0.9, 0.35, 2.0), 10, "edge"),
            obj("reading_table", (1.6, 0.9, 0.75), 4, "middle"),
            obj("reading_chair", (0.45, 0.45, 0.9), 16, around="reading_table"),
            obj("librarian_desk", (1.8, 0.8, 1.0), 1, "edge"),
            obj("librarian_chair", (0.55, 0.55, 0.95), 1, paired="librarian_desk"),
            obj("armchair", (0.75, 0.75, 0.9), 4),
            obj("side_table", (0.4, 0.4, 0.5), 2, near="armchair"),
            obj("book_cart", (0.8, 0.45, 1.0), 1, near="librarian_desk"),
            obj("plant", (0.4, 0.4, 1.2), 3, "edge"),
        ],
        [((1, 10), (5, 10)), ((8, 10), (13, 10))],
    ),
    room(
        "open_office",
        "open office",
        box(16, 10),
        [((0, 4), (0, 5.2)), ((16, 1), (16, 1.9))],
        [
            obj("desk", (1.4, 0.7, 0.75), where="middle", matrix=(4, 5)),
            obj("office_chair", (0.6, 0.6, 1.0), 20, "middle", paired="desk"),
            obj("filing_cabinet", (0.5, 0.6, 1.2), 6, "edge"),
            obj("printer_stand", (0.7, 0.6, 1.0), 1, "edge"),
            obj("bookcase", (1.0, 0.35, 1.9), 3, "edge"),
            obj("water_cooler", (0.35, 0.35, 1.1), 1, "edge"),
            obj("sofa", (1.8, 0.8, 0.8), 1, "edge"),
            obj("coffee_table", (1.0, 0.5, 0.45), 1, in_front_of="sofa"),
            obj("plant", (0.4, 0.4, 1.2), 4, "edge"),
            obj("waste_bin", (0.3, 0.3, 0.4), 4, near="desk"),
        ],
        [((2, 10), (7, 10)), ((9, 10), (14, 10))],
    ),
    room(
        "living_room",
        "living room",
        box(6, 5),
        [((0, 0.5), (0, 1.4)), ((4.6, 0), (5.5, 0))],
        [
            obj("sofa", (2.2, 0.9, 0.85), 1, "edge"),
            obj(
                "coffee_table",
                (1.1, 0.6, 0.45),
                1,
                "middle",
                in_front_of="sofa",
                center_aligned="sofa",
            ),
            obj("tv_stand", (1.6, 0.4, 0.5), 1, "edge"),
            obj("armchair", (0.8, 0.8, 0.9), 2, near="coffee_table"),
            obj("side_table", (0.45, 0.45, 0.55), 2, side_of="sofa"),
            obj("floor_lamp", (0.35, 0.35, 1.6), 1, "edge", near="sofa"),
            obj("bookcase", (0.9, 0.35, 1.9), 2, "edge"),
            obj("dining_table", (1.2, 0.8, 0.75), 1),
            obj("dining_chair", (0.45, 0.45, 0.9), 4, around="dining_table"),
            obj("sideboard", (1.4, 0.45, 0.8), 1, "edge", near="dining_table"),
            obj("plant", (0.35, 0.35, 1.0), 2, "edge"),
        ],
        [((1.5, 5), (4.5, 5))],
    ),
    room(
        "supermarket",
        "supermarket",
        box(18, 12),
        [((2, 0), (3.8, 0)), ((18, 9), (18, 10.2))],
        [
            obj("gondola_shelf", (1.2, 0.8, 1.6), where="middle", matrix=(5, 8)),
            obj("wall_fridge", (1.5, 0.8, 2.0), 6, "edge"),
            obj("freezer_chest", (1.8, 0.9, 0.9), 2, "middle"),
            obj("checkout_counter", (2.0, 0.8, 0.9), 3),
            obj("cashier_stool", (0.4, 0.4, 0.7), 3, paired="checkout_counter"),
            obj("shopping_cart_bay", (1.0, 0.6, 1.0), 2, "edge"),
            obj("fruit_stand", (1.5, 1.0, 0.9), 2),
            obj("bread_shelf", (1.2, 0.5, 1.8), 2, "edge"),
            obj("promo_bin", (0.6, 0.6, 0.8), 3),
        ],
    ),
    room(
        "gym",
        "gym",
        box(12, 9),
        [((5, 0), (6.2, 0))],
        [
            obj("treadmill", (0.85, 1.9, 1.4), where="middle", matrix=(1, 5)),
            obj("exercise_bike", (0.6, 1.2, 1.2), where="middle", matrix=(1, 4)),
            obj("weight_bench", (0.6, 1.3, 0.5), 3, "middle"),
            obj("dumbbell_rack", (1.6, 0.6, 1.0), 2, "edge"),
            obj("power_rack", (1.5, 1.4, 2.2), 1, "edge"),
            obj("cable_machine", (1.2, 1.0, 2.1), 1, "edge"),
            obj("yoga_mat_rack", (0.8, 0.4, 1.2), 1, "edge"),
            obj("locker", (0.4, 0.5, 1.8), 8, "edge"),
            obj("bench", (1.2, 0.4, 0.45), 2, near="locker"),
            obj("water_dispenser", (0.35, 0.35, 1.1), 1, "edge"),
            obj("ball_rack", (0.9, 0.4, 1.2), 1, "edge"),
        ],
        [((12, 2), (12, 7))],
    ),
    room(
        "ward_matrix",
        "hospital ward",
        box(11, 7.5),
        [((0, 3), (0, 4.4))],
        [
            obj("bed", (1.0, 2.1, 0.6), 0, "edge", matrix=(2, 4)),
            obj("bedside_cabinet", (0.45, 0.45, 0.85), 8, "edge", paired="bed"),
            obj("visitor_chair", (0.5, 0.5, 0.85), 8, near="bed"),
            obj("iv_stand", (0.3, 0.3, 1.9), 8, near="bed"),
            obj("sink_unit", (0.6, 0.5, 0.9), 1, "edge"),
            obj("medicine_cart", (0.7, 0.5, 1.0), 1, far="bed"),
            obj("waste_bin", (0.3, 0.3, 0.5), 2, "edge"),
        ],
    ),
    room(
        "l_living",
        "living room",
        [(0, 0), (7, 0), (7, 3.4), (3.6, 3.4), (3.6, 7), (0, 7)],
        [((7, 1), (7, 1.9)), ((0.6, 7), (1.5, 7))],
        [
            obj("sofa", (2.0, 0.9, 0.85), 1, "edge"),
            obj("coffee_table", (1.0, 0.6, 0.45), 1, "middle", in_front_of="sofa"),
            obj("tv_stand", (1.4, 0.4, 0.5), 1, "edge", far="sofa"),
            obj("armchair", (0.8, 0.8, 0.9), 1, near="sofa"),
            obj("dining_table", (1.4, 0.8, 0.75), 1, "middle"),
            obj("dining_chair", (0.45, 0.45, 0.9), 6, around="dining_table"),
            obj("cabinet", (1.0, 0.45, 1.2), 2, "edge"),
            obj("bookcase", (0.8, 0.3, 1.8), 2, "edge"),
            obj("plant", (0.35, 0.35, 1.0), 2, "edge"),
            obj("floor_lamp", (0.3, 0.3, 1.6), 1, near="sofa"),
        ],
    ),
    room(
        "narrow_store",
        "storage room",
        box(2.4, 7),
        [((0.7, 0), (1.6, 0))],
        [
            obj("storage_rack", (1.0, 0.5, 2.0), 8, "edge"),
            obj("box_pallet", (0.8, 0.6, 0.8), 2, "edge"),
            obj("ladder", (0.5, 0.3, 1.8), 1, "edge"),
            obj("cleaning_cart", (0.8, 0.45, 1.0), 1),
        ],
    ),
    room(
        "corridor_lounge",
        "lobby",
        box(3.0, 14),
        [((1, 0), (2, 0)), ((1, 14), (2, 14)), ((3, 6), (3, 7))],
        [
            obj("bench", (1.5, 0.45, 0.45), 5, "edge"),
            obj("planter", (0.4, 0.4, 1.0), 6, "edge"),
            obj("display_case", (1.0, 0.4, 1.8), 3, "edge"),
            obj("vending_machine", (0.9, 0.8, 1.9), 2, "edge"),
            obj("waste_bin", (0.35, 0.35, 0.8), 2, near="vending_machine"),
        ],
    ),
    room(
        "meeting_room",
        "meeting room",
        box(6, 4.5),
        [((0, 0.4), (0, 1.3))],
        [
            obj("conference_table", (3.0, 1.2, 0.75), 1, "middle"),
            obj("conference_chair", (0.55, 0.55, 1.0), 10, "middle", around="conference_table"),
            obj("screen_stand", (1.5, 0.5, 1.6), 1, "edge"),
            obj("credenza", (1.6, 0.45, 0.8), 1, "edge"),
            obj("whiteboard", (1.2, 0.5, 1.8), 1, "edge"),
            obj("plant", (0.4, 0.4, 1.2), 2, "edge"),
            obj("waste_bin", (0.3, 0.3, 0.4), 1, "edge"),
        ],
        [((6, 1), (6, 3.5))],
    ),
    room(
        "restaurant_matrix",
        "restaurant",
        box(12, 9),
        [((5, 0), (6.5, 0)), ((12, 7.5), (12, 8.4))],
        [
            obj("table", (0.9, 0.9, 0.75), where="middle", matrix=(3, 4)),
            obj("chair", (0.45, 0.45, 0.9), 48, "middle", around="table"),
            obj("bar", (3.0, 0.7, 1.1), 1, "edge"),
            obj("bar_stool", (0.38, 0.38, 0.75), 5, in_front_of="bar"),
            obj("sideboard", (1.4, 0.45, 0.9), 2, "edge"),
            obj("wine_rack", (1.0, 0.4, 1.9), 2, "edge", near="bar"),
            obj("host_stand", (0.6, 0.5, 1.1), 1),
            obj("plant", (0.4, 0.4, 1.2), 4, "edge"),
        ],
        [((1, 9), (5, 9))],
    ),
    room(
        "kitchen",
        "kitchen",
        box(4.5, 3.6),
        [((0, 2.4), (0, 3.3))],
        [
            obj("base_cabinet", (0.6, 0.6, 0.9), 4, "edge"),
            obj("stove", (0.6, 0.6, 0.9), 1, "edge"),
            obj("sink_cabinet", (0.9, 0.6, 0.9), 1, "edge"),
            obj("fridge", (0.7, 0.7, 1.9), 1, "edge"),
            obj("dining_table", (1.1, 0.75, 0.75), 1, "middle"),
            obj("dining_chair", (0.42, 0.42, 0.9), 4, around="dining_table"),
            obj("trash_can", (0.3, 0.3, 0.6), 1, "edge"),
            obj("shelf", (0.7, 0.3, 1.6), 1, "edge"),
        ],
        [((1.4, 3.6), (3.2, 3.6))],
    ),
    room(
        "hotel_room",
        "hotel bedroom",
        box(4.2, 6.2),
        [((0.3, 0), (1.2, 0)), ((4.2, 0.6), (4.2, 1.4))],
        [
            obj("double_bed", (1.8, 2.0, 0.55), 1, "edge"),
            obj("nightstand", (0.45, 0.4, 0.55), 2, "edge", side_of="double_bed"),
            obj("desk", (1.2, 0.6, 0.75), 1, "edge"),
            obj("desk_chair", (0.5, 0.5, 0.9), 1, paired="desk"),
            obj("wardrobe", (1.2, 0.6, 2.1), 1, "edge"),
            obj("luggage_rack", (0.8, 0.45, 0.5), 1, "edge", near="wardrobe"),
            obj("armchair", (0.75, 0.75, 0.9), 1),
            obj("side_table", (0.4, 0.4, 0.5), 1, near="armchair"),
            obj("minibar", (0.5, 0.5, 0.8), 1, "edge"),
            obj("floor_lamp", (0.3, 0.3, 1.6), 1, "edge", near="armchair"),
            obj("waste_bin", (0.25, 0.25, 0.3), 1, near="desk"),
        ],
        [((0.8, 6.2), (3.4, 6.2))],
    ),
    room(
        "computer_lab",
        "computer lab",
        box(10, 8),
        [((10, 0.4), (10, 1.4))],
        [
            obj("teacher_desk", (1.4, 0.7, 0.75), 1, "edge"),
            obj("teacher_chair", (0.55, 0.55, 0.95), 1, paired="teacher_desk"),
            obj("computer_desk", (1.2, 0.6, 0.75), where="middle", matrix=(4, 5)),
            obj("computer_chair", (0.5, 0.5, 0.95), 20, paired="computer_desk"),
            obj("server_rack", (0.6, 0.8, 2.0), 2, "edge"),
            obj("printer_table", (0.8, 0.6, 0.8), 1, "edge"),
            obj("cabinet", (0.9, 0.45, 1.8), 2, "edge"),
            obj("waste_bin", (0.3, 0.3, 0.4), 2, "edge"),
        ],
        [((1, 8), (4.5, 8)), ((5.5, 8), (9, 8))],
    ),
    room(
        "lecture_hall",
        "lecture hall",
        box(14, 11),
        [((0, 0.5), (0, 2.0)), ((14, 0.5), (14, 2.0))],
        [
            obj("lectern", (0.7, 0.5, 1.1), 1, "edge"),
            obj("whiteboard", (2.4, 0.4, 1.9), 1, "edge"),
            obj("seat", (0.55, 0.6, 0.9), where="middle", matrix=(8, 12)),
            obj("side_table", (0.8, 0.5, 0.75), 2, "edge"),
            obj("plant", (0.4, 0.4, 1.2), 2, "edge"),
        ],
    ),
    room(
        "waiting_room",
        "waiting room",
        [(0, 0), (7, 0), (8.5, 1.5), (8.5, 6), (0, 6)],
        [((2, 0), (3.2, 0)), ((8.5, 4), (8.5, 4.9))],
        [
            obj("reception_desk", (2.0, 0.8, 1.1), 1, "edge"),
            obj("receptionist_chair", (0.55, 0.55, 0.95), 1, paired="reception_desk"),
            obj("waiting_chair", (0.55, 0.55, 0.85), 12, "edge"),
            obj("magazine_table", (0.6, 0.6, 0.45), 2, "middle", near="waiting_chair"),
            obj("water_dispenser", (0.35, 0.35, 1.1), 1, "edge"),
            obj("brochure_stand", (0.4, 0.3, 1.4), 1, "edge"),
            obj("plant", (0.4, 0.4, 1.2), 3, "edge"),
            obj("toy_box", (0.7, 0.4, 0.4), 1, "edge"),
        ],
    ),
    room(
        "atrium_cafe",
        "cafe",
        box(11, 9),
        [((0, 4), (0, 5.4))],
        [
            obj("cafe_table", (0.7, 0.7, 0.75), 10, "middle"),
            obj("cafe_chair", (0.42, 0.42, 0.85), 20, around="cafe_table"),
            obj("counter", (2.5, 0.7, 1.1), 1, "edge"),
            obj("display_fridge", (0.9, 0.7, 1.9), 2, "edge", near="counter"),
            obj("sofa", (1.8, 0.85, 0.8), 2, "edge"),
            obj("low_table", (0.8, 0.5, 0.4), 2, in_front_of="sofa"),
            obj("plant", (0.4, 0.4, 1.2), 4),
        ],
        holes=[[(5, 4), (6, 4), (6, 5), (5, 5)]],
    ),
    room(
        "workshop",
        "workshop",
        box(9, 7),
        [((3, 0), (5.4, 0))],
        [
            obj("workbench", (1.8, 0.75, 0.9), 4, "edge"),
            obj("stool", (0.4, 0.4, 0.7), 4, paired="workbench"),
            obj("drill_press", (0.6, 0.6, 1.7), 1, "edge"),
            obj("table_saw", (1.0, 0.9, 0.9), 1, "middle"),
            obj("tool_cabinet", (0.9, 0.5, 1.6), 4, "edge"),
            obj("material_rack", (1.5, 0.6, 2.0), 2, "edge"),
            obj("assembly_table", (2.0, 1.0, 0.85), 1, "middle"),
            obj("tool_cart", (0.7, 0.45, 0.9), 2, near="assembly_table"),
            obj("fire_extinguisher", (0.2, 0.2, 0.6), 1, "edge"),
            obj("trash_barrel", (0.5, 0.5, 0.9), 2, "edge"),
        ],
    ),
    room(
        "kindergarten",
        "kindergarten",
        box(9, 8),
        [((9, 3), (9, 4)), ((2, 0), (2.9, 0))],
        [
            obj("play_table", (1.1, 1.1, 0.5), 4, "middle"),
            obj("small_chair", (0.3, 0.3, 0.55), 24, around="play_table"),
            obj("toy_shelf", (1.0, 0.35, 0.8), 5, "edge"),
            obj("cubby", (1.2, 0.4, 1.0), 3, "edge"),
            obj("reading_sofa", (1.2, 0.6, 0.5), 1, "edge"),
            obj("book_bin", (0.6, 0.4, 0.5), 2, near="reading_sofa"),
            obj("cot", (0.6, 1.2, 0.3), 6, "edge"),
            obj("easel", (0.6, 0.5, 1.1), 2),
            obj("teacher_desk", (1.2, 0.6, 0.75), 1, "edge"),
            obj("teacher_chair", (0.5, 0.5, 0.9), 1, paired="teacher_desk"),
        ],
        [((1, 8), (4, 8)), ((5, 8), (8, 8))],
    ),
    room(
        "studio_slanted",
        "bedroom",
        [(0, 0), (5.5, 0), (5.5, 2.5), (4.2, 5), (0, 5)],
        [((0.4, 0), (1.3, 0))],
        [
            obj("bed", (1.4, 2.0, 0.5), 1, "edge"),
            obj("nightstand", (0.4, 0.4, 0.5), 1, "edge", side_of="bed"),
            obj("desk", (1.2, 0.6, 0.75), 1, "edge"),
            obj("desk_chair", (0.5, 0.5, 0.9), 1, paired="desk"),
            obj("wardrobe", (1.5, 0.6, 2.0), 1, "edge"),
            obj("bookshelf", (0.8, 0.3, 1.8), 1, "edge"),
            obj("sofa", (1.6, 0.8, 0.8), 1, "edge"),
            obj("coffee_table", (0.8, 0.5, 0.4), 1, in_front_of="sofa"),
            obj("plant", (0.35, 0.35, 1.0), 1),
        ],
    ),
]

if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(ROOMS, indent=1) + "\n", encoding="utf-8")
