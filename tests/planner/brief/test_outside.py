"""The outside in a brief: what walls and roof are made of and what lies on the plot, told from what is indoors."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "material"),
    [
        ("A two-storey house with a red brick facade", "red_brick"),
        ("A red-brick school", "red_brick"),
        ("A white two-storey villa", "white_render"),
        ("A timber-clad cabin", "timber_cladding"),
        ("A chalet built of logs", "timber_cladding"),
        ("A family house, exterior in light grey stucco", "grey_render"),
        ("A bungalow. The outer walls are white render.", "white_render"),
        ("The facade should be of dark timber. It is a small house.", "dark_cladding"),
        ("An office of five storeys clad in glass", "glass_panels"),
        ("A warehouse with metal cladding", "metal_panels"),
        ("A restaurant with a brick front", "red_brick"),
        ("A yellow Victorian cottage", "yellow_render"),
    ],
)
def test_outer_walls_are_of_what_is_said_of_the_building(text: str, material: str) -> None:
    facts = _facts(text)
    (fact,) = facts.outside
    assert (fact.part, fact.name) == ("facade", material)
    assert not facts.unread and not facts.unheeded
    assert not facts.building_name or "brick" not in facts.building_name


@pytest.mark.parametrize(
    "text",
    [
        "A glass museum with three galleries",
        "A black box theatre with a foyer",
        "A house with oak floors",
        "A villa with stone walls inside the living room",
        "A green office",
        "A kitchen clad in white tiles",
    ],
)
def test_a_substance_of_something_else_is_none_of_the_outer_walls(text: str) -> None:
    assert [fact for fact in _facts(text).outside if fact.part == "facade"] == []


@pytest.mark.parametrize(
    ("text", "form", "covering"),
    [
        ("A house with a slate hip roof", "hip", "slate_roof"),
        ("A flat-roofed school", "flat", ""),
        ("A house. The roof is hipped and covered in red tiles.", "hip", "clay_roof_tiles"),
        ("An office with a green roof", "", "lawn"),
        ("A farmhouse with a thatched roof", "", "thatch"),
        ("A cabin with a steep shingle roof", "gable", "brown_roof_tiles"),
        ("A house, roof: pitched, three bedrooms", "gable", ""),
    ],
)
def test_a_roof_has_a_form_a_covering_or_both(text: str, form: str, covering: str) -> None:
    facts = _facts(text)
    (fact,) = [fact for fact in facts.outside if fact.part == "roof"]
    assert (fact.name, fact.covering) == (form, covering)
    assert not facts.unread


@pytest.mark.parametrize(
    "text", ["A hotel with a roof terrace", "A flat under the roof", "A house with a sawtooth roof"]
)
def test_roof_terraces_attics_and_unknown_forms_are_no_roof(text: str) -> None:
    assert _facts(text).outside == []


@pytest.mark.parametrize(
    ("text", "uses"),
    [
        ("A villa with a garden with a pool", {"garden": 0, "pool": 0}),
        ("A hotel with a swimming pool in the garden", {"pool": 0}),
        ("A house with an outdoor pool and a back garden", {"pool": 0, "garden": 0}),
        ("A school with parking for 20 cars and a playground", {"parking": 20, "playground": 0}),
        ("A supermarket with 40 parking spaces outside", {"parking": 40}),
        ("An office with customer parking in front", {"parking": 0}),
        ("A four-storey office with parking for 30 cars behind the building", {"parking": 30}),
        ("A kindergarten with a fenced garden", {"fence": 0, "garden": 0}),
        ("A cottage with a picket fence and a hedge around the plot", {"fence": 0, "hedge": 0}),
    ],
)
def test_what_lies_on_the_plot_is_no_room(text: str, uses: dict[str, int]) -> None:
    facts = _facts(text)
    assert {fact.use: fact.count for fact in facts.outside} == uses
    assert facts.rooms == [] and facts.objects == [] and not facts.unread


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("A house with a garden room and an indoor pool", ["garden_room", "indoor_pool"]),
        ("A hotel with a pool and a spa", ["pool", "spa"]),
        ("A hotel with a roof garden", ["roof_garden"]),
        ("Flats with underground parking for 20 cars", ["underground_parking"]),
        ("An office with a parking garage on the ground floor", ["parking_garage"]),
        ("A house whose kitchen opens to the garden", ["kitchen"]),
        ("A clinic around a therapy garden", ["therapy_garden"]),
        ("A narrow house with parking for one car", ["parking"]),
        ("A motel with a lobby, parking in front isn't part of the model", ["lobby"]),
        ("A house without a garden", []),
    ],
)
def test_rooms_that_are_called_like_parts_of_a_plot_stay_rooms(text: str, rooms: list[str]) -> None:
    facts = _facts(text)
    assert facts.outside == []
    assert [room.name for room in facts.rooms] == rooms
