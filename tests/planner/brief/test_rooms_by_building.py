"""Rooms whose kind depends on the building that they are in."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


def rooms(brief: str) -> dict[str, tuple[str, bool]]:
    return {room.name: (room.room_type, room.known) for room in read_brief(brief, default_knowledge()).rooms}


@pytest.mark.parametrize(
    ("brief", "name", "room_type", "known"),
    [
        ("An office with a security cabin and a cafe.", "security_cabin", "security_room", True),
        ("An office with a lobby and an MD cabin.", "md_cabin", "private_office", True),
        ("A pharmacy with a sales room and a consultation cabin.", "consultation_cabin", "consultation_room", True),
        ("A furniture factory with a spray booth and an assembly hall.", "assembly_hall", "production_hall", True),
        ("A school with a library and an assembly hall.", "assembly_hall", "assembly_hall", True),
        ("An advertising agency with one open studio with 32 desks and a cafe.", "studio", "open_office", False),
        ("A newspaper office with a newsroom. On top a studio for podcasts.", "studio", "recording_studio", True),
        ("A university with a lab and a student room where 18 desks are.", "student_room", "study_room", False),
        ("A dormitory with 20 student rooms and a kitchen.", "student_room", "dorm_room", True),
        ("A birth centre with a waiting room and a midwives' station.", "midwife_station", "nurse_station", False),
        ("A nursing home with a staff station and a laundry.", "staff_station", "nurse_station", True),
        ("A school with a library and an informatics laboratory.", "informatic_laboratory", "computer_lab", True),
        ("A hospital with a pharmacy and a reception hall.", "reception_hall", "lobby", True),
        ("A house with a kitchen and a downstairs loo.", "loo", "toilet", True),
        ("A shared house with six private rooms and a big kitchen.", "private_room", "bedroom", True),
        ("A farmhouse with a kitchen and the parents' room.", "parent_room", "master_bedroom", True),
        ("A mall with a parents' room and toilets.", "parent_room", "nursing_mothers_room", True),
        ("A film studio with a render farm and edit suites.", "render_farm", "server_room", True),
        ("A karaoke club with six private rooms and a bar.", "private_room", "vip_room", True),
        ("A university lab with a gowning room and an etching bay.", "etching_bay", "laboratory", True),
        ("A car workshop with a waiting room and a repair bay.", "repair_bay", "car_workshop", True),
        ("A school with a wood shop and four classrooms.", "wood_shop", "workshop", True),
        ("A stud farm with a riding hall and twelve horse boxes.", "horse_box", "stable", True),
    ],
)
def test_the_building_tells_what_a_room_is(brief: str, name: str, room_type: str, known: bool) -> None:
    assert rooms(brief)[name] == (room_type, known)


def test_a_building_that_is_called_a_station_stays_one() -> None:
    facts = read_brief("A country station with a waiting hall.", default_knowledge())
    assert [name for name, _ in facts.building] == ["train_station"]
    assert [room.name for room in facts.rooms] == ["waiting_hall"]


def test_a_loo_in_a_bathroom_is_no_room_of_its_own() -> None:
    facts = read_brief("A house with a bathroom with a loo and a basin.", default_knowledge())
    assert [room.name for room in facts.rooms] == ["bathroom"]
    assert [(thing.category, thing.room) for thing in facts.objects] == [("toilet", "bathroom"), ("sink", "bathroom")]


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A loft apartment for a painter: a studio with an easel, kitchenette, shower room", "art_room"),
        ("A winery with a press room", "production_hall"),
        ("A yoga studio with two practice rooms", "yoga_studio"),
    ],
)
def test_a_room_is_what_its_building_makes_of_it(brief: str, kind: str) -> None:
    assert kind in [room.room_type for room in read_brief(brief, default_knowledge()).rooms]
