"""The material library and the match of descriptions."""

import pytest

from mansion_scene.structure.materials import library, match_material, material


@pytest.mark.parametrize(
    ("description", "use", "name"),
    [
        ("warm oak hardwood, matte", "floor", "oak_hardwood"),
        ("dark walnut wood, satin", "floor", "dark_hardwood"),
        ("carpet, neutral gray", "floor", "grey_carpet"),
        ("soft beige drywall, smooth", "wall", "beige_drywall"),
        ("painted drywall, white", "wall", "white_drywall"),
        ("polished concrete", "floor", "polished_concrete"),
        ("white subway tile", "wall", "subway_tiles"),
        ("red brick, exposed", "wall", "red_brick"),
        ("grey ceramic tile, slip-resistant", "floor", "grey_ceramic"),
        ("white marble, polished", "floor", "white_marble"),
        ("antistatic vinyl", "floor", "hospital_vinyl"),
    ],
)
def test_descriptions_find_their_material(description: str, use: str, name: str) -> None:
    assert match_material(description, use).name == name


def test_unknown_words_get_the_default_of_the_use() -> None:
    assert match_material("xyzzy", "floor").name == "oak_hardwood"
    assert match_material("", "wall").name == "white_drywall"


def test_a_material_found_by_its_own_name_is_itself() -> None:
    for name, entry in library().items():
        assert match_material(name, entry.uses[0]) is entry
        assert material(name) is entry


def test_values_are_physical() -> None:
    for entry in library().values():
        assert 0.0 <= entry.roughness <= 1.0 and 0.0 <= entry.metallic <= 1.0
        assert 0.0 < entry.alpha <= 1.0 and entry.thor and entry.keywords
