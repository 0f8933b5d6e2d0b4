"""Names of storeys in other countries, tables of storeys and added storeys (the ground floor is 1)."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_language import tokenize
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.storey_forms import storey_tables


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


def storeys(brief: str) -> dict[str, list[int]]:
    """Return the storeys of every room that is on numbered ones."""
    return {
        fact.name: [number for ref in fact.floors for number in range(ref.first, ref.last + 1)]
        for fact in read(brief).rooms
    }


@pytest.mark.parametrize(
    ("brief", "expected"),
    [
        ("House. EG: kitchen. 1. OG: library. 2.OG: studio", {"kitchen": [1], "library": [2], "studio": [3]}),
        ("House. EG: kitchen. 1. und 2. OG: a library each", {"kitchen": [1], "library": [2, 3]}),
        ("House. EG: kitchen. 1.-3. OG: a library on each floor", {"kitchen": [1], "library": [2, 3, 4]}),
        ("School, R+2. RDC: canteen. At the R+1: library.", {"canteen": [1], "library": [2]}),
        ("School. RDC: canteen. Du R+1 au R+3: a library by level.", {"canteen": [1], "library": [2, 3, 4]}),
        ("House. Rez-de-chaussée: kitchen. 1er étage: library.", {"kitchen": [1], "library": [2]}),
        ("House. Térreo: kitchen. 1º andar: library. 2º andar: gym.", {"kitchen": [1], "library": [2], "gym": [3]}),
        ("Bank. In PB: vault. Primera planta: archive. In the second floor: gym", {"vault": [1], "archive": [2]}),
        (
            "A house. G/F: kitchen; 1/F: library; 2/F-4/F: a gym on each floor",
            {"kitchen": [1], "library": [2], "gym": [3, 4, 5]},
        ),
        ("A house. 1/F: kitchen; 2/F to 4/F: a gym on each floor", {"kitchen": [1], "gym": [2, 3, 4]}),
        ("A house\nGF: kitchen\nL1: library\nL2: gym", {"kitchen": [1], "library": [2], "gym": [3]}),
        ("A house. Level G: kitchen. Level 1: library.", {"kitchen": [1], "library": [2]}),
        ("Office of 5 floors. 3F-5F: a gym on each floor", {"gym": [3, 4, 5]}),
        ("School with 4 layers. First layer: library. Second to fourth layer: one gym", {"library": [1]}),
        ("Radio on two levels. Low level: archive. High level: gym", {"archive": [1]}),
        ("Our law firm has two storeys. On the lower one we need an archive.", {"archive": [1]}),
        ("Hostel, 8 floors. Ground floor: kitchen. 1st to 3rd floor: one library. 7th floor: gym", {"gym": [8]}),
    ],
)
def test_a_storey_is_known_by_its_name(brief: str, expected: dict[str, list[int]]) -> None:
    found = storeys(brief)
    assert {name: found[name] for name in expected} == expected


@pytest.mark.parametrize(
    ("brief", "count"),
    [
        ("A library in R+2", 3),
        ("A bank, planta baja + 1", 2),
        ("An office, térreo + 2 andares", 3),
        ("A restaurant of one plant", 1),
        ("A hostel with 3 fl", 3),
        ("A house of 3 layers", 3),
    ],
)
def test_storeys_are_counted(brief: str, count: int) -> None:
    assert [quantity.value for quantity in read(brief).floors] == [count]


def test_one_storey_that_is_measured_is_no_count() -> None:
    facts = read("Hotel of 10 stories, one floor is 330㎡.")
    assert [quantity.value for quantity in facts.floors] == [10.0]
    assert [quantity.value for quantity in facts.floor_area] == [330.0]


@pytest.mark.parametrize(
    "size",
    [
        "each floor 560 m2",
        "every floor is about 560 square meters",
        "gross 560 m2 per storey",
        "area of every floor 560㎡",
        "560 m2 by floor",
        "levels x 560 m2",
    ],
)
def test_an_area_is_that_of_each_storey(size: str) -> None:
    facts = read(f"An office of 3 {size}" if size.startswith("levels") else f"An office of 3 floors, {size}")
    assert [quantity.value for quantity in facts.floor_area] == [560.0]
    assert not facts.area


def test_one_plant_in_a_room_is_furniture() -> None:
    facts = read("A restaurant with one plant in the lobby")
    assert [fact.category for fact in facts.objects] == ["house_plant"]
    assert not facts.floors


def test_a_described_basement_takes_none_of_the_rooms_before_it() -> None:
    facts = read(
        "A villa on three floors above a vaulted basement. Five bedrooms, a library, wine cellar in the basement."
    )
    assert [quantity.value for quantity in facts.basements] == [1.0]
    assert {fact.name: bool(fact.floors) for fact in facts.rooms}["bedroom"] is False


FLOOR_WORDS = frozenset({"storey", "floor", "level"})


def rewritten(table: str) -> list[str]:
    """Return the lines of a table as they are read."""
    words = [token.text for token in storey_tables(tokenize(table), FLOOR_WORDS)]
    return [line.strip() for line in " ".join(words).split("\n")]


@pytest.mark.parametrize("rule", ["", "|---|---|\n"])
def test_a_row_is_headed_by_its_storey(rule: str) -> None:
    table = (
        f"An office.\n| storey | what |\n{rule}| 1 (street) | lobby, cafe |\n| 2 | open office | 3 desks |\nOne lift."
    )
    lines = [line for line in rewritten(table) if line]
    assert lines == ["an office .", "1 : lobby , cafe", "2 : open office , 3 desk", "one lift ."]


def test_a_storey_may_have_a_name() -> None:
    assert "ground floor : lobby" in rewritten("| floor | rooms |\n| ground floor | lobby |")


def test_other_tables_stay_as_they_are() -> None:
    table = "| room | m2 |\n| kitchen | 12 |"
    assert [token.text for token in storey_tables(tokenize(table), FLOOR_WORDS)] == [t.text for t in tokenize(table)]


@pytest.mark.parametrize(
    "words",
    [
        "one storey plus a mezzanine-like second storey",
        "one storey and a second floor",
        "one level with an additional level",
        "one floor plus an upper floor",
        "a single storey plus one extra storey",
    ],
)
def test_there_are_two(words: str) -> None:
    assert [quantity.value for quantity in read(f"A car dealership, {words} for the offices.").floors] == [2.0]


def test_one_storey_stays_one() -> None:
    assert [quantity.value for quantity in read("A shop on one storey with a store.").floors] == [1.0]


@pytest.mark.parametrize("mark", [":", " -", " has"])
def test_a_number_before_each_storey_that_heads_a_list_is_its_own(mark: str) -> None:
    text = f"Villa, 3 floor. 1 floor{mark} pool. 2 floor{mark} four bedrooms. 3 floor{mark} sauna."
    facts = read_brief(text, default_knowledge())
    assert [quantity.value for quantity in facts.floors] == [3.0]
    assert [(room.room_type, room.floors[0].first) for room in facts.rooms] == [
        ("indoor_pool", 1),
        ("bedroom", 2),
        ("sauna", 3),
    ]
