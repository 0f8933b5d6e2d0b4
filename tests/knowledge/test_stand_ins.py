"""Every type that only stands for something is known, and only what is named so is stood in for."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_knowledge import default_knowledge
from mansion_knowledge.object_qualities import has_quality
from mansion_knowledge.stand_ins import StandInKind, _stand_ins, is_for_another_subject, stands_in


def test_every_type_is_known() -> None:
    known, listed = default_knowledge(), _stand_ins()
    assert set(listed.rooms) <= set(known.rooms)
    assert set(listed.buildings) <= set(known.buildings)
    assert set(listed.objects) <= set(load_catalogue().categories)
    assert set(listed.animals.rooms) <= set(known.rooms)
    assert set(listed.told["rooms"]) | set(listed.usual) | set(listed.subjects) <= set(known.rooms)


@pytest.mark.parametrize(
    ("kind", "type_", "name", "only"),
    [
        ("objects", "sofa", "corner sofa", True),
        ("objects", "sofa", "sofa", False),
        ("rooms", "garage", "carport", True),
        ("rooms", "garage", "double_garage", False),
        ("rooms", "prayer_room", "quiet_room", True),
        ("rooms", "vip_room", "private room", True),
        ("rooms", "vip_room", "vip lounge", False),
        ("rooms", "electrical_room", "ups_room", True),
        ("rooms", "utility_room", "mudroom", False),
        ("buildings", "hair_salon", "tattoo studio", True),
        ("buildings", "shop_building", "Flower shop", True),
        ("buildings", "shop_building", "bookshop", False),
        ("buildings", "nightclub", "brewpub", True),
        ("objects", "fireplace", "wood stove", True),
    ],
)
def test_a_type_stands_in_for_some_names(kind: StandInKind, type_: str, name: str, only: bool) -> None:
    assert stands_in(kind, type_, name) is only


def test_some_names_are_the_type_in_buildings_of_its_kind() -> None:
    assert stands_in("rooms", "open_office", "open_space", "home")
    assert not stands_in("rooms", "open_office", "open_space", "office")


@pytest.mark.parametrize(
    ("room_type", "noun", "word", "other"),
    [
        ("gallery", "gallery", "car", True),
        ("gallery", "gallery", "sculpture", False),
        ("laboratory", "lab", "phonetics", True),
        ("laboratory", "lab", "wet", False),
        ("stage", "stage", "mocap", True),
        ("showroom", "showroom", "coffin", True),
        ("bedroom", "bedroom", "car", False),
    ],
)
def test_rooms_about_something_have_furniture_for_some_subjects(
    room_type: str, noun: str, word: str, other: bool
) -> None:
    assert is_for_another_subject(room_type, noun, word) is other


@pytest.mark.parametrize(
    ("category", "width", "material", "words", "so"),
    [
        ("bed", 1.6, "fabric_white", "double", True),
        ("bed", 1.2, "fabric_white", "double", False),
        ("bed", 1.9, "fabric_white", "king size", True),
        ("sofa", 2.0, "leather_brown", "brown leather", True),
        ("sofa", 2.0, "fabric_grey", "leather", False),
        ("dining_table", 2.2, "wood_oak", "long", True),
        ("dining_table", 1.2, "wood_oak", "wooden", True),
        ("armchair", 0.9, "fabric_grey", "medieval", False),
    ],
)
def test_an_object_is_as_a_word_says(category: str, width: float, material: str, words: str, so: bool) -> None:
    assert has_quality(category, (width, 0.8, 0.5), material, words) is so


@pytest.mark.parametrize(
    ("category", "size", "words", "so"),
    [
        ("dining_table", (1.8, 0.9, 0.75), "large", True),
        ("dining_table", (1.2, 0.9, 0.75), "large", False),
        ("cafe_table", (0.7, 0.7, 0.75), "small", True),
        ("cafe_table", (0.7, 0.7, 0.75), "small square", True),
        ("cafe_table", (0.7, 0.7, 0.75), "rectangular", False),
        ("round_table", (0.9, 0.9, 0.75), "square", False),
        ("bed", (1.1, 2.1, 0.5), "large", False),
        ("bookshelf", (1.0, 0.3, 1.9), "tall", True),
        ("bookshelf", (1.0, 0.3, 1.9), "low", False),
        ("coffee_table", (1.0, 0.6, 0.4), "low", True),
        ("toilet", (0.5, 0.9, 1.0), "small", False),
    ],
)
def test_a_size_in_words_is_measured_where_usual_ones_are_known(
    category: str, size: tuple[float, float, float], words: str, so: bool
) -> None:
    assert has_quality(category, size, "wood_oak", words) is so
