"""Rooms that no type is called after are planned as what the words of their names tell."""

from pathlib import Path

import pytest

from mansion_knowledge import default_knowledge, load_knowledge
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.similarity import told_room_type
from mansion_planner.plan import plan_building


def kind_of(brief: str, name: str) -> tuple[str, list[str]]:
    """Return the type of the room of that name, and what the receipt calls unmet."""
    program = plan_building(BuildRequest(description=brief)).program
    rooms = [room for floor in program.floors for room in floor.rooms]
    kinds = {room.room_type for room in rooms if name in (room.id, room.name.replace(" ", "_"))}
    (wish,) = [wish for wish in program.wishes if wish.kind == "room" and wish.value.name == name]
    return kinds.pop(), wish.value.type


@pytest.mark.parametrize(
    ("brief", "name", "kind"),
    [
        ("A climbing hall with a bouldering area and a cafe.", "bouldering_area", "climbing_room"),
        ("A clinic with a vaccination room.", "vaccination_room", "treatment_room"),
        ("A brewery with a bottling hall and an office.", "bottling_hall", "production_hall"),
        ("A school with a movement room.", "movement_room", "yoga_studio"),
        ("A data centre with a UPS room.", "ups_room", "electrical_room"),
        ("A warehouse with a forklift charging room.", "forklift_charging_room", "electrical_room"),
        ("A research institute with a spectrometer room.", "spectrometer_room", "laboratory"),
        ("A swimming club with a pool and a filter room.", "filter_room", "mechanical_room"),
        ("A textile workshop with a dyeing room.", "dyeing_room", "workshop"),
        ("A rowing club with a boat hall and changing rooms.", "boat_hall", "warehouse"),
        ("A dairy with a pasteurising room and a shop.", "pasteurising_room", "commercial_kitchen"),
        ("A school with a nurse's room.", "nurse_room", "nurse_office"),
        ("A fire station with a vehicle hall.", "vehicle_hall", "apparatus_bay"),
        ("A recording studio with two lounges and a vocal booth.", "vocal_booth", "recording_studio"),
    ],
)
def test_a_word_before_a_general_noun_tells_what_a_room_is(brief: str, name: str, kind: str) -> None:
    assert kind_of(brief, name) == (kind, kind)


@pytest.mark.parametrize("name", ["weights_shop", "weights", "blue_room", "piano_bar", "server_office"])
def test_nothing_is_told_by_other_words_or_of_other_nouns(name: str) -> None:
    assert told_room_type(name, default_knowledge()) == ""


def test_the_last_telling_word_counts_in_either_number() -> None:
    knowledge = default_knowledge()
    assert told_room_type("free_weights_zone", knowledge) == told_room_type("weight_zone", knowledge) == "gym"
    assert told_room_type("cake_packing_area", knowledge) == "packing_area"


def test_a_folder_of_ones_own_tells_more(tmp_path: Path) -> None:
    (tmp_path / "telling_words.csv").write_text("word,room_type\ntelescope,observatory_dome\n")
    assert told_room_type("telescope_room", load_knowledge([tmp_path])) == "observatory_dome"


def test_a_word_that_tells_of_no_type_is_refused_with_file_and_word(tmp_path: Path) -> None:
    (tmp_path / "telling_words.csv").write_text("word,room_type\ntelescope,dome\n")
    with pytest.raises(MansionError, match=r"telling_words\.csv, record 'telescope': 'dome' is not a room type"):
        load_knowledge([tmp_path])
