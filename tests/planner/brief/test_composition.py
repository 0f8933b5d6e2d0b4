"""How the parts of a brief compose: counts, storeys, relations, negations, furniture and names."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts, RoomFact


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def room(text: str, name: str) -> RoomFact:
    return next(fact for fact in read(text).rooms if fact.name == name)


def floors(text: str, name: str) -> list[tuple[str, int, int]]:
    return [(ref.kind, ref.first, ref.last) for ref in room(text, name).floors]


@pytest.mark.parametrize(
    "text",
    ["an office with meeting rooms (4)", "an office with meeting rooms x4", "an office. Meeting rooms: four of them.",
     "an office with four meeting rooms", "an office. Meeting rooms, 4 no."],
)  # fmt: skip
def test_a_count_stands_before_or_after_its_noun(text: str) -> None:
    assert room(text, "meeting_room").count == 4


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("8 storeys. Ground: lobby. The seven storeys above repeat.", 8),
        ("ground plus two", 3),
        ("a flat, everything on one level", 1),
        ("street level and one upper floor", 2),
        ("floors: 3", 3),
        ("a house of three storeys over a basement", 3),
    ],
)
def test_storeys_are_counted_however_they_are_said(text: str, count: int) -> None:
    assert read(text).floors[0].value == count


@pytest.mark.parametrize(
    ("text", "name", "where"),
    [
        ("four storeys. Second: kitchen. Third: study.", "study", [("number", 3, 3)]),
        ("five storeys. The penultimate floor has a gym.", "gym", [("below_top", 1, 0)]),
        ("an office on floors, L2 to L4 open office", "open_office", [("range", 2, 4)]),
        ("three storeys. CELLAR\n- boiler room\n", "boiler_room", [("basement", 0, 0)]),
        ("a house, four floors, all floors except the last have a bathroom", "bathroom", [("not_top", 0, 0)]),
        ("Ground floor: shop. One flight up: two bedrooms.", "bedroom", [("number", 2, 2)]),
    ],
)
def test_storeys_are_named_in_many_ways(text: str, name: str, where: list[tuple[str, int, int]]) -> None:
    assert floors(text, name) == where


def test_a_heading_holds_for_the_lines_below_it() -> None:
    text = "A house.\nGROUND FLOOR\n- kitchen\n- study\nTOP FLOOR\n- two bedrooms\n"
    assert floors(text, "study") == [("number", 1, 1)]
    assert floors(text, "bedroom") == [("top", 0, 0)]


def test_each_gives_every_room_its_own() -> None:
    fact = room("a house with five bedrooms, each with a private bathroom", "bedroom")
    assert [child.room_type for child in fact.suite] == ["ensuite_bathroom"]


def test_a_negation_reaches_its_clause_and_not_the_relation() -> None:
    facts = read("a house. The bedroom must not be next to the bathroom. No gym or sauna, but a library.")
    assert [(fact.first, fact.second) for fact in facts.apart] == [("bedroom", "bathroom")]
    assert [name for name, _ in facts.excluded] == ["gym", "sauna"]
    assert {fact.room_type for fact in facts.rooms} == {"bedroom", "bathroom", "library_room"}


def test_an_unwanted_room_on_one_storey_is_unwanted_there_alone() -> None:
    facts = read("a house of two floors with a bedroom upstairs. No bedroom downstairs.")
    assert [(name, ref.first) for name, ref, _ in facts.excluded_on] == [("bedroom", 1)]


@pytest.mark.parametrize(
    "text",
    [
        "an office. The larder lies between the kitchen and the storage.",
        "an office with a kitchen, a storage and a larder. The larder is next to the kitchen and the storage.",
    ],
)
def test_between_and_lists_make_a_pair_with_each(text: str) -> None:
    pairs = {(fact.first, fact.second) for fact in read(text).adjacent}
    assert pairs == {("pantry", "kitchen"), ("pantry", "storage")}


def test_the_area_of_a_room_is_not_the_buildings() -> None:
    facts = read("offices of 14 m2 each, six of them, and a canteen for 60 people of 120 m2")
    assert not facts.area
    assert [(fact.count, fact.area) for fact in facts.rooms][:1] == [(6, 14.0)]


def test_several_areas_are_of_as_many_rooms() -> None:
    facts = read("a flat with three bedrooms, of 11, 12 and 14 m2")
    assert [(fact.count, fact.area) for fact in facts.rooms] == [(1, 11.0), (1, 12.0), (1, 14.0)]


def test_furniture_belongs_to_the_room_that_it_is_said_of() -> None:
    facts = read("a house with a fireplace in the living room and a kitchen with a table. One desk per bedroom.")
    assert [(fact.category, fact.room, fact.each) for fact in facts.objects][:2] == [
        ("fireplace", "living_room", False),
        ("dining_table", "kitchen", False),
    ]
    assert facts.objects[2].each


def test_own_names_are_kept() -> None:
    facts = read('Floor 2: private rooms called Sapporo, Kobe and Nagoya, and the party room "Typhoon".')
    assert [fact.name for fact in facts.rooms] == ["sapporo", "kobe", "nagoya", "typhoon"]
    assert room("a museum with a curator's office", "curator_office").label == "curator's office"


def test_words_that_no_statement_was_read_from_are_kept() -> None:
    unread = [span.words for span in read("a house with a kitchen. Blorbs everywhere.").unread]
    assert any("Blorbs" in words for words in unread)


def test_a_text_is_read_in_time_proportional_to_its_length() -> None:
    facts = read("two bedrooms, " * 1000)
    assert sum(fact.count or 0 for fact in facts.rooms) == 2000
