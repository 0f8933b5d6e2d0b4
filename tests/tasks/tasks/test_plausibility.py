"""Generated tasks ask for what makes sense to a person."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_msgs_py.scene import SceneObject
from mansion_tasks.tasks.plausibility import is_requested, kinds_of, suits_container, suits_room, suits_surface
from sample_building import room, thing


def _thing(category: str) -> SceneObject:
    return thing(f"{category}_1", "F1/kitchen", (1.0, 1.0, 0.0), (0.1, 0.1, 0.1))


@pytest.mark.parametrize(
    ("what", "container", "fits"),
    [
        ("milk_carton", "fridge", True),
        ("cake", "commercial_oven", True),
        ("folded_towels", "wardrobe", True),
        ("notebook", "filing_cabinet", True),
        ("flower_vase", "stove", False),
        ("monitor", "fridge", False),
        ("juice_carton", "wardrobe", False),
        ("tape_dispenser", "fridge", False),
        ("notebook", "treasure_chest", True),
        ("gizmo", "fridge", False),
    ],
)
def test_a_container_takes_what_it_is_for(what: str, container: str, fits: bool) -> None:
    assert suits_container(_thing(what), _thing(container)) is fits


@pytest.mark.parametrize(
    ("what", "surface", "fits"),
    [
        ("book", "single_bed", True),
        ("juice_carton", "bed", False),
        ("plastic_crate", "student_desk", False),
        ("bunsen_burner", "reception_sofa", False),
        ("hammer", "workbench", True),
        ("bandage", "exam_table", True),
        ("mug", "office_desk", True),
        ("mouse", "sideboard", False),
        ("pillow", "coffee_table", False),
        ("cd", "bed", False),
    ],
)
def test_furniture_gets_what_people_put_there(what: str, surface: str, fits: bool) -> None:
    assert suits_surface(_thing(what), _thing(surface)) is fits


@pytest.mark.parametrize(
    ("what", "kind", "fits"),
    [
        ("paint_can", "restroom", False),
        ("paint_can", "storage", True),
        ("hand_towel", "restroom", True),
        ("hammer", "main_kitchen", False),
        ("mug", "meeting_room", True),
        ("mouse", "corridor", False),
        ("watch", "commercial_kitchen", False),
        ("watch", "private_office", True),
        ("plate", "classroom", False),
        ("paint_can", "private_office", False),
        ("butter_knife", "storage", False),
        ("pillow", "master_bedroom", True),
        ("blanket", "bathroom", False),
        ("wine_bottle", "bedroom", False),
        ("lettuce", "phone_booth", False),
        ("statue", "planetarium", True),
    ],
)
def test_rooms_get_what_is_used_there(what: str, kind: str, fits: bool) -> None:
    assert suits_room(_thing(what), room("F1/there", kind, 0, 0, 4, 4)) is fits


def test_every_small_thing_of_the_catalogue_is_known() -> None:
    catalogue = load_catalogue()
    small = [a.category for a in catalogue.assets.values() if a.pickupable]
    assert not [c for c in small if is_requested(_thing(c)) and not kinds_of(_thing(c))]


def test_every_small_thing_that_is_brought_has_rooms_to_go_to() -> None:
    catalogue = load_catalogue()
    small = [a.category for a in catalogue.assets.values() if a.pickupable]
    rooms = [room("F1/there", kind, 0, 0, 4, 4) for kind in catalogue.room_types]
    lost = [
        c
        for c in dict.fromkeys(small)
        if is_requested(_thing(c)) and sum(suits_room(_thing(c), there) for there in rooms) < 3
    ]
    assert lost == []


def test_every_container_of_the_catalogue_that_opens_takes_something() -> None:
    catalogue = load_catalogue()
    small = [_thing(a.category) for a in catalogue.assets.values() if a.pickupable]
    opens = [a.category for a in catalogue.assets.values() if a.openable and a.volumes]
    empty = [c for c in dict.fromkeys(opens) if not any(suits_container(t, _thing(c)) for t in small)]
    assert empty == ["infant_incubator"]
