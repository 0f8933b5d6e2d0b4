"""Things that people tell apart at a glance do not share a mesh that differs in colour alone."""

import numpy as np
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.meshes import mesh

CATALOGUE = load_catalogue()


def _outline(category: str) -> list[tuple[str, int]]:
    """Return the named parts of a category's first asset with their numbers of triangles."""
    parts = mesh(CATALOGUE.by_category(category)[0])
    return sorted((part.name, len(part.faces)) for part in parts)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("butter", "dish_sponge"),
        ("petri_dish", "cd"),
        ("stapler", "tape_dispenser"),
        ("candle", "bunsen_burner"),
        ("toilet_paper", "bandage"),
        ("toilet_brush", "scrub_brush"),
        ("cable_machine", "loom"),
        ("milling_machine", "laser_cutter"),
        ("drill_press", "robot_arm"),
        ("freezer_chest", "salad_bar"),
        ("produce_stand", "boat"),
        ("display_case", "infant_incubator"),
        ("syringe", "pencil"),
        ("thermostat", "light_switch"),
        ("package", "medicine_box"),
        ("shampoo", "water_bottle"),
        ("wine_rack", "bookshelf"),
        ("violin", "guitar_stand"),
        ("air_hockey_table", "pool_table"),
        ("ultrasound_machine", "anesthesia_machine"),
        ("dialysis_machine", "ventilator"),
        ("generator", "air_handler"),
        ("pump_unit", "air_compressor"),
        ("storage_tank", "water_heater"),
        ("printing_press", "printer"),
        ("ironing_press", "lathe_machine"),
        ("car_lift", "gantry_crane"),
        ("power_drill", "hair_dryer"),
        ("webcam", "camera"),
        ("security_camera", "camera"),
        ("truck", "van"),
        ("van", "garage_car"),
        ("ticket_machine", "atm"),
        ("wheelie_bin", "shredder"),
        ("smoke_detector", "ceiling_speaker"),
        ("orange", "exercise_ball"),
        ("basketball", "exercise_ball"),
        ("newspaper", "magazine"),
        ("hymn_book", "notebook"),
        ("tea_box", "cereal_box"),
        ("towel", "blanket"),
        ("dishwasher", "stove"),
        ("high_chair", "kids_chair"),
        ("watering_can", "kettle"),
        ("calculator", "remote_control"),
        ("defibrillator", "first_aid_box"),
        ("mail_shelf", "archive_shelf"),
        ("stretcher", "hospital_bed"),
        ("freezer", "minibar"),
        ("service_station", "sideboard"),
        ("bar_counter", "sales_counter"),
        ("slippers", "sneakers"),
        ("cola_can", "canned_food"),
        ("beer_bottle", "wine_bottle"),
        ("clothes_dryer", "washing_machine"),
        ("mri_scanner", "ct_scanner"),
        ("television", "monitor"),
        ("salon_chair", "recliner"),
        ("exam_table", "massage_table"),
        ("lounger", "single_bed"),
        ("medical_screen", "folding_screen"),
        ("grab_bar", "towel_holder"),
        ("laundry_hamper", "waste_bin"),
        ("linen_cart", "book_cart"),
        ("display_case", "aquarium"),
        ("kitchen_counter", "sideboard"),
    ],
)
def test_kinds_that_look_different_are_made_of_different_parts(one: str, other: str) -> None:
    assert _outline(one) != _outline(other)


def test_a_football_has_twelve_dark_pentagons() -> None:
    dark = next(part for part in mesh(CATALOGUE.by_category("football")[0]) if part.name == "pentagons")
    middles = dark.vertices.reshape(12, -1, 3).mean(axis=1)
    assert len({tuple(np.sign(np.round(middle, 3))) for middle in middles}) == 12


@pytest.mark.parametrize(
    ("category", "parts"),
    [
        ("calculator", {"display", "digits", "keys", "signs"}),
        ("defibrillator", {"heart", "flash", "letters", "handle"}),
        ("mail_shelf", {"partitions", "letters", "stamps", "names"}),
        ("stretcher", {"legs", "wheels", "rails", "pillow", "straps"}),
        ("freezer", {"controls", "icicles", "snowflake", "drawers"}),
        ("service_station", {"cutlery", "glasses", "plates", "napkins", "menus"}),
        ("bar_counter", {"foot_rail", "letters", "beer", "glass"}),
        ("slippers", {"soles", "footbeds", "uppers", "openings", "collars"}),
        ("cola_can", {"letters", "tab", "opening", "neck"}),
        ("beer_bottle", {"cap", "foil", "label", "letters"}),
        ("water_jug", {"water", "spout", "handle"}),
        ("hair_dryer", {"nozzle", "grip", "switches", "cord", "plug"}),
        ("lettuce", {"leaves", "stalks", "heart"}),
        ("television", {"screen", "head", "letters", "feet"}),
        ("painting", {"frame", "mount", "face", "title"}),
        ("tapestry", {"rod", "diamonds", "zigzags", "fringe"}),
        ("door_sign", {"letters", "number"}),
        ("blinds", {"slats", "sky", "cords", "pull"}),
        ("clothes_dryer", {"letters", "heat", "lint_flap"}),
        ("mri_scanner", {"magnet", "lip", "table", "letters"}),
        ("conference_table", {"pads", "names", "cable_well", "sockets"}),
        ("evidence_table", {"numbers", "scale", "letters"}),
        ("kids_table", {"letters", "rim", "sun"}),
        ("office_desk", {"fronts", "computer", "cables", "mat"}),
        ("exam_table", {"roll", "paper", "drawers", "step"}),
        ("operating_table", {"pads", "sheet", "bulbs", "column"}),
        ("dental_chair", {"lamp", "tray", "drills", "bowl", "tooth"}),
        ("salon_chair", {"arms", "lever", "rest", "sign"}),
        ("lounger", {"slats", "wheels", "cushion"}),
        ("footstool", {"feet", "rungs"}),
        ("kitchen_counter", {"cup_handles", "tools", "whisk", "towel"}),
        ("counter_top", {"cup_handles", "tools", "whisk"}),
        ("bathroom_cabinet", {"mirror", "towel", "drops"}),
        ("media_console", {"player", "clock", "console", "films"}),
        ("lab_bench", {"flasks", "bottles", "tubes", "taps", "sign"}),
        ("lab_island", {"flasks", "bottles", "tubes", "taps", "sign"}),
        ("sink_row", {"mirror", "soap", "bowl", "tap"}),
        ("display_case", {"mask", "label", "letters"}),
        ("linen_cart", {"towels", "bags", "letters"}),
        ("laundry_hamper", {"coils", "shirt", "sock", "letters"}),
        ("toilet_paper_hanger", {"roll", "core", "sheet", "dots"}),
        ("luggage_rack", {"straps", "studs", "legs", "suitcase"}),
        ("medical_screen", {"cloth", "castors", "cross"}),
        ("wallet", {"cards", "slots", "notes", "photo"}),
        ("shower_head", {"rose", "water", "hose", "taps"}),
        ("grab_bar", {"plates", "screws", "ribs"}),
        ("phone_charging_station", {"letters", "bolt", "telephones", "cables"}),
        ("bathtub", {"feet", "taps", "water", "towel"}),
        ("bedside_cabinet", {"wheels", "letters", "cross"}),
        ("medicine_cabinet", {"cross", "bottles", "boxes"}),
        ("refrigerated_case", {"milk", "cheese", "yoghurt", "letters"}),
        ("produce_stand", {"apples", "bananas", "prices", "letters"}),
        ("handbag", {"flap", "clasp", "handle"}),
        ("basket", {"weave", "handle", "checks"}),
        ("scrub_brush", {"bristles", "grip"}),
        ("cinema_screen", {"curtains", "pelmet", "number"}),
        ("host_stand", {"letters", "book", "shade"}),
        ("massage_table", {"face_rest", "stones", "towel"}),
        ("floor_mirror", {"posts", "pivots", "gleam"}),
        ("recliner", {"arms", "foot_rest", "lever"}),
        ("scrub_sink", {"knee_boards", "soap", "letters"}),
        ("dishwashing_station", {"rack", "plates", "spray_head"}),
        ("student_desk", {"books", "pencil", "exercise_book"}),
        ("cafeteria_table", {"trays", "plates", "cups"}),
        ("dining_table", {"plates", "forks", "knives"}),
        ("patio_table", {"slats", "ring", "parasol_tube"}),
        ("training_table", {"castors", "hinges", "modesty"}),
        ("sales_counter", {"till", "bag", "letters"}),
        ("mail_shelf", {"envelope", "title"}),
        ("pot", {"soup", "letters", "handles"}),
        ("cup", {"bands", "handle"}),
        ("toothpaste", {"letters", "cap", "crimp"}),
    ],
)
def test_a_kind_has_the_parts_that_it_is_known_by(category: str, parts: set[str]) -> None:
    for asset in CATALOGUE.by_category(category):
        assert parts <= {part.name for part in mesh(asset)}, asset.key
