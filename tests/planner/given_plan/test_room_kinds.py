"""What rooms on a plan are, by their names in several languages."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.given_plan.room_kinds import core_kind, room_kind


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("Schlafzimmer 1", "bedroom"),
        ("Küche", "kitchen"),
        ("Salle de bain 2", "bathroom"),
        ("1.OG Flur", "hallway"),
        ("Dormitorio", "bedroom"),
        ("soggiorno", "living_room"),
        ("Woonkamer", "living_room"),
        ("Büro", "open_office"),
    ],
)
def test_words_of_other_languages(name: str, kind: str) -> None:
    found = room_kind(name, "", default_knowledge())
    assert (found.type.name, found.known) == (kind, True)


def test_english_goes_before_other_languages() -> None:
    assert room_kind("Salon", "", default_knowledge()).type.name == "living_room"
    assert room_kind("Flur", "bathroom", default_knowledge()).type.name == "bathroom"


@pytest.mark.parametrize(
    ("name", "core"), [("Treppenhaus", "stair"), ("Aufzug 1", "elevator"), ("Escalier", "stair"), ("Flur Treppe", "")]
)
def test_stairs_and_lifts_of_other_languages(name: str, core: str) -> None:
    assert core_kind(name, "", default_knowledge()) == core
