"""Words that say how something is to be stay with it, and what nothing is made of is told."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def unread(text: str) -> str:
    return " | ".join(span.words for span in read(text).unread)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a house with a soundproof music room", ["soundproof"]),
        ("a house with a central hall", ["central"]),
        ("a hospital with a central kitchen", []),
        ("a school with 8 sound-proof practice rooms", ["sound-proof"]),
        ("a flat with a wheelchair accessible bathroom", ["wheelchair", "accessible"]),
        ("a house with a windowless store", ["windowless"]),
        ("a house with two bright bedrooms", ["bright"]),
        ("an office with a double-height lobby", ["double-height"]),
        ("a house with an L-shaped living room", ["L-shaped"]),
        ("a house with a locked study", ["locked"]),
        ("a house with a blue armchair and an oval mirror", ["blue", "oval"]),
        ("a house with a spiral staircase", ["spiral"]),
        ("a haunted manor", ["haunted"]),
        ("a medieval tavern", ["medieval"]),
        ("a cabin with a wood stove in the main nook", ["in the main nook"]),
        ("a house with a sauna, a gym; a wooden bench in each", ["in each"]),
    ],
)
def test_properties_that_nothing_is_made_of_are_kept(text: str, words: list[str]) -> None:
    assert [span.words for span in read(text).unheeded] == words


@pytest.mark.parametrize(
    "text",
    [
        "a beautiful house with a nice kitchen",
        "a laboratory with a cold room and a wood shop",
        "a flat with a shared kitchen and a separate toilet",
        "a rustic kitchen in a modern house",
        "a church with a children's corner room",
        "a roastery with a green bean store",
        "an airport with a duty-free shop",
    ],
)
def test_names_and_praise_are_no_properties(text: str) -> None:
    assert read(text).unheeded == []


@pytest.mark.parametrize(
    ("text", "style"),
    [
        ("A station, style is neoclassicism", "neoclassical"),
        ("A flat in the haussmannian style", "classic"),
        ("A house. Its style should be minimalism.", "minimalist"),
    ],
)
def test_styles_are_named_by_their_nouns_too(text: str, style: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert [name for name, _ in facts.styles] == [style]
    assert not facts.unread


def test_a_property_of_a_room_is_no_style_of_the_building() -> None:
    assert read("a house with two bright bedrooms").styles == []
    assert next(name for name, _ in read("Fitness studio. Bright and modern.").styles) == "modern"


def test_the_wish_of_an_unheeded_word_says_so() -> None:
    program = plan_building(BuildRequest(description="a house with a soundproof music room")).program
    wish = next(wish for wish in program.wishes if wish.kind == "room")
    assert (wish.text, wish.value.unheeded) == ("soundproof music room", ["soundproof"])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a house. The sauna is above the garage.", "above"),
        ("a clinic with all rooms in the west except the pharmacy", "except"),
        ("a house with a study on a different floor from the nursery", "different"),
        ("a house with a kitchen (open) and a bath", "open"),
        ("a flat with three rooms", "three rooms"),
        ("Two-family house with a bath", "Two"),
        ("a house with glass walls between the bedrooms", "glass walls"),
        ("a clinic, and a gate for ambulances", "ambulances"),
        ("a house, 60 m2, 90 m2", "90"),
        ("a house with a bathroom instead of the second bedroom", "second bedroom"),
    ],
)
def test_what_no_statement_is_made_of_is_told(text: str, words: str) -> None:
    assert words in unread(text)


def test_an_outline_that_gives_way_stays_in_the_ledger() -> None:
    program = plan_building(BuildRequest(description="an L-shaped bungalow round a courtyard")).program
    assert [wish.value.name for wish in program.wishes if wish.kind == "outline"] == ["L", "courtyard"]


def test_a_reading_is_cancelled_between_its_steps() -> None:
    asked: list[bool] = []

    def cancelled() -> bool:
        asked.append(True)
        return len(asked) > 2

    with pytest.raises(MansionError) as refusal:
        plan_building(BuildRequest(description="a house with two bedrooms, " * 50), cancelled=cancelled)
    assert refusal.value.code == ErrorCode.CANCELED
    assert len(asked) == 3


@pytest.mark.parametrize(
    ("text", "name", "words"),
    [
        ("a bike shop with a workshop", "bike_shop", ["bike"]),
        ("A maritime museum on two floors", "maritime_museum", ["maritime"]),
        ("a patio house with two bedrooms", "patio_house", ["patio"]),
        ("a vinyl record shop", "vinyl_record_shop", ["vinyl record"]),
        ("a black-box theatre", "black_box_theatre", ["black-box"]),
        ("a pharmacy cum polyclinic", "pharmacy_polyclinic", ["pharmacy"]),
    ],
)
def test_what_a_building_is_about_is_in_its_name_and_told(text: str, name: str, words: list[str]) -> None:
    facts = read(text)
    assert (facts.building_name, [span.words for span in facts.unheeded]) == (name, words)


@pytest.mark.parametrize(
    "text",
    [
        "a village library",
        "a local radio station",
        "a lake house",
        "a duplex apartment",
        "the Miller house with two bedrooms",
        "a grandmother's farmhouse",
        "a second-hand bookshop",
        "a two-bed flat",
    ],
)
def test_settings_and_owners_of_a_building_are_not_told(text: str) -> None:
    assert read(text).unheeded == []


@pytest.mark.parametrize(
    ("room", "known"),
    [
        ("turbine hall", False),
        ("ballet hall", False),
        ("wrestling parlour", False),
        ("pottery workshop", False),
        ("assembly hall", True),
        ("concert hall", True),
        ("large hall", True),
        ("repair workshop", True),
        ("front parlour", True),
    ],
)
def test_a_room_called_after_what_its_kind_has_nothing_of_is_taken_for_that_kind(room: str, known: bool) -> None:
    facts = read(f"a school with a {room} and two classrooms")
    assert facts.rooms[0].known is known


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a house with a double bed in the bedroom", ["double"]),
        ("a house with a king-size bed in the bedroom", ["king"]),
        ("a house with a bed in the double bedroom", []),
    ],
)
def test_how_wide_a_bed_is_to_be_is_told(text: str, words: list[str]) -> None:
    assert [span.words for span in read(text).unheeded] == words
