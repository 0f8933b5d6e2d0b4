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
    ],
)
def test_kinds_that_look_different_are_made_of_different_parts(one: str, other: str) -> None:
    assert _outline(one) != _outline(other)


def test_a_football_has_twelve_dark_pentagons() -> None:
    dark = next(part for part in mesh(CATALOGUE.by_category("football")[0]) if part.name == "pentagons")
    middles = dark.vertices.reshape(12, -1, 3).mean(axis=1)
    assert len({tuple(np.sign(np.round(middle, 3))) for middle in middles}) == 12
