"""What rooms and buildings are called."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts, RoomFact
from mansion_planner.plan import plan_building


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def rooms(text: str) -> dict[str, RoomFact]:
    return {fact.name: fact for fact in read(text).rooms}


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("A house. Bedroom 1, bedroom 2 and a kitchen.", {"bedroom_1", "bedroom_2", "kitchen"}),
        ("Language school with the classes 1A and 1B.", {"class_1a", "class_1b"}),
        ("TV station. Studio A (200 m2), Studio B (90 m2).", {"studio_a", "studio_b"}),
        ("High school. Chemistry and physics labs.", {"chemistry_lab", "physics_lab"}),
        ("Gym with changing rooms for men and for women.", {"man_changing_room", "woman_changing_room"}),
        ("Mosque with an ablution room for men and another for women.", {"man_ablution_room", "woman_ablution_room"}),
        ("Film house with a live room, a make-up room and a touch pool room.",
         {"live_room", "makeup_room", "touch_pool_room"}),
        ("Institute with two BSL-3 laboratories.", {"bsl_3_laboratory"}),
        ("We need a company building with the office of the director and a gym.", {"director_office", "gym"}),
    ],
)  # fmt: skip
def test_rooms_keep_the_names_that_the_brief_gives_them(text: str, names: set[str]) -> None:
    assert set(rooms(text)) == names


@pytest.mark.parametrize(
    ("text", "name", "kind"),
    [
        ("A warehouse with an office, zone of shipping, a charging room.", "shipping_zone", "loading_dock"),
        ("A hospital with a pharmacy and a post of nurses.", "nurse_post", "nurse_station"),
        ("A museum with two offices and the reserve of artworks.", "artwork_reserve", "storage"),
        ("A factory with a production hall and a measuring room.", "measuring_room", "study_room"),
        ("A factory with a production hall and a goods entrance.", "good_entrance", "loading_dock"),
        ("A shop with an office and a walk-in refrigerator.", "walk_in_refrigerator", "cold_storage"),
        ("A hospital. At the ground floor are the emergencies.", "emergency", "emergency_room"),
    ],
)
def test_a_place_is_a_room_by_what_it_is_for(text: str, name: str, kind: str) -> None:
    assert rooms(text)[name].room_type == kind


def test_a_zone_of_the_town_is_no_room() -> None:
    assert not rooms("A house in a zone of the town, 120 m2.")


def test_numbered_rooms_have_areas_of_their_own() -> None:
    found = rooms("One-family house:\nBedroom 1 - 16 m²\nBedroom 2 - 12 m²\nBathroom - 7 m²")
    assert (found["bedroom_1"].area, found["bedroom_2"].area, found["bathroom"].area) == (16, 12, 7)


def test_an_area_makes_a_room_of_an_unknown_noun() -> None:
    assert rooms("Villa, two floors. Ground floor has men majlis 40 sqm and a kitchen.")["man_majlis"].area == 40


def test_a_room_of_unknown_kind_is_known_where_it_is_named_again() -> None:
    text = "A monastery with a kitchen, scriptorium and chapel. Keep the scriptorium apart from the kitchen."
    facts = read_brief(text, default_knowledge())
    assert [(fact.first_name, fact.second_name) for fact in facts.apart] == [("scriptorium", "kitchen")]


@pytest.mark.parametrize(
    ("text", "own", "kind"),
    [
        ("a two-storey beach house", "beach_house", "detached_house"),
        ("Advertising agency over five floors", "advertising_agency", "office"),
        ("We need a robotics test facility on one floor", "robotics_test_facility", "factory"),
        ("Food bank: delivery room, sorting hall, cold store", "food_bank", "community_center"),
        ("a three-storey office", "office", "office"),
    ],
)
def test_a_building_is_called_what_the_brief_calls_it(text: str, own: str, kind: str) -> None:
    program = plan_building(BuildRequest(description=text)).program
    assert (program.building_type, program.kind) == (own, kind)


def test_what_only_names_the_building_again_is_no_room() -> None:
    assert set(rooms("We turn an old barn into a home with a kitchen. The house is quiet.")) == {"kitchen"}


@pytest.mark.parametrize("text", ["3 bed 2 bath cottage", "Cottage: 3 bed / 2 bath", "3 bedrm + 2 bathrm cottage"])
def test_advertisements_of_homes_are_read(text: str) -> None:
    found = rooms(text)
    assert (found["bedroom"].count, found["bathroom"].count) == (3, 2)


def test_a_count_that_is_corrected_counts() -> None:
    assert rooms("A house with four bedrooms, no sorry, five.")["bedroom"].count == 5


def test_each_of_some_people_has_rooms_of_their_own() -> None:
    bedroom = rooms("We are five friends. Each of us needs an own bedroom with an own bathroom.")["bedroom"]
    assert bedroom.count == 5 and [child.room_type for child in bedroom.suite] == ["bathroom"]


def test_what_a_cell_is_fitted_with_is_furniture() -> None:
    facts = read_brief("A prison with ten cells, every cell fitted with bunk, toilet and desk.", default_knowledge())
    assert [fact.name for fact in facts.rooms] == ["cell"]
    assert {fact.category for fact in facts.objects} >= {"toilet", "desk"}


@pytest.mark.parametrize(
    ("brief", "names"),
    [
        ("A school with a library, room of teachers, room of meetings", {"teacher_room", "meeting_room"}),
        ("A radio with 2 offices of redaction of 25 m2 each", {"redaction_office"}),
        ("A school of 2 floors. Toilet of boys and toilet of girls are in each floor.", {"boy_toilet", "girl_toilet"}),
        ("A spa with vestiary masculine and vestiary feminine", {"man_vestiary", "woman_vestiary"}),
        ("Spa: changing room for women and changing room for men", {"woman_changing_room", "man_changing_room"}),
        ("A house with a large bathroom and a small bathroom", {"large_bathroom", "small_bathroom"}),
        (
            "Baths: separate changing rooms for women, men and families, showers, a sauna",
            {"woman_changing_room", "man_changing_room", "family_changing_room", "shower"},
        ),
        ("A house of two floors with a downstairs loo, an airing cupboard upstairs", {"loo", "airing_cupboard"}),
        ("A brewery: a tasting room, a laboratory and staff lockers", {"staff_locker"}),
        ("A library: a children's library and a story room", {"story_room"}),
    ],
)
def test_rooms_are_called_by_their_purpose_their_users_and_their_size(brief: str, names: set[str]) -> None:
    assert names <= {fact.name for fact in read(brief).rooms}


def test_names_may_follow_the_area_of_the_rooms() -> None:
    facts = read(
        "A school with 2 classrooms of 25 m2 that are called Oslo and Prague. Classroom Oslo is next to the hall."
    )
    assert {fact.name: fact.area for fact in facts.rooms if fact.room_type == "classroom"} == {
        "oslo": 25.0,
        "prague": 25.0,
    }
    assert facts.adjacent[0].first_name == "oslo"


def test_names_after_a_dash_may_hold_words_for_other_rooms() -> None:
    facts = read("An escape room with two game rooms of 35 m2 - the Bank Heist, the Submarine; toilets.")
    named = {fact.name: fact.area for fact in facts.rooms if fact.room_type == "game_room"}
    assert named == {"bank_heist_game_room": 35.0, "submarine_game_room": 35.0}


def test_a_room_may_be_mentioned_again_by_its_first_words() -> None:
    facts = read(
        "A dental practice. Sterilisation room, waiting room. The sterilisation must not adjoin the waiting room."
    )
    assert [(a.first_name, a.second_name) for a in facts.apart] == [("sterilisation_room", "waiting_room")]


def test_what_a_room_is_for_is_no_room() -> None:
    facts = read("A fire station with an appliance bay for three engines (150 sqm)")
    assert {fact.name: fact.area for fact in facts.rooms} == {"appliance_bay": 150.0}


def test_shared_rooms_belong_to_no_suite() -> None:
    facts = read("A hostel. Each floor has 7 studio rooms with own bathroom and one shared kitchen.")
    assert {fact.name: [child.name for child in fact.suite] for fact in facts.rooms} == {
        "studio_room": ["bathroom"],
        "shared_kitchen": [],
    }


def test_each_before_an_area_gives_nobody_a_room() -> None:
    facts = read("A house with 3 children rooms with each 13 m2, parents bedroom 17 m2, one bathroom")
    assert {fact.name: fact.count for fact in facts.rooms}["parent_bedroom"] == 1


@pytest.mark.parametrize(
    ("brief", "name", "room_type"),
    [
        ("An airport with a check-in hall and a hall of the luggage claim.", "luggage_claim_hall", "baggage_claim"),
        ("A clinic with a lobby and a room for the treatments.", "treatment_room", "treatment_room"),
        ("A museum with a shop and seven rooms of exhibition.", "exhibition_room", "gallery"),
        ("A museum with a shop and a workshop of restoration.", "restoration_workshop", "restoration_room"),
    ],
)
def test_a_purpose_that_names_a_known_room_is_that_room(brief: str, name: str, room_type: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert {room.name: (room.room_type, room.known) for room in facts.rooms}[name] == (room_type, True)


def test_a_room_is_known_though_its_plural_is_written_otherwise() -> None:
    rooms = read("A flat with a bath and a childrens room.").rooms
    assert {room.name: (room.room_type, room.known) for room in rooms}["children_room"] == ("childrens_room", True)


def test_only_those_before_the_last_and_are_users() -> None:
    facts = read("Spa: separate changing rooms for women and men, showers, a sauna")
    assert [fact.name for fact in facts.rooms] == ["woman_changing_room", "man_changing_room", "shower", "sauna"]


def test_those_whom_a_practice_is_for_are_people() -> None:
    facts = read("Dental practice for three dentists with three treatment rooms")
    assert [(fact.room_type, fact.count) for fact in facts.rooms] == [("treatment_room", 3)]
    assert [fact.count for fact in facts.occupants] == [3]


def test_a_studio_of_an_agency_is_to_work_in() -> None:
    facts = read("Advertising agency on two floors. Upper floor: one open studio with 32 desks and a coffee bar")
    assert [fact.room_type for fact in facts.rooms] == ["open_office", "cafe"]


@pytest.mark.parametrize("rooms", ["en-suite bathrooms", "en-suite wet rooms"])
def test_bedrooms_with_en_suite_rooms_have_one_each(rooms: str) -> None:
    facts = read(f"A care home with twenty single bedrooms with {rooms}, a lounge and an assisted bathroom")
    assert [fact.name for fact in facts.rooms] == ["single_bedroom", "lounge", "assisted_bathroom"]
    assert [(room.label, room.count) for room in facts.rooms[0].suite] == [(rooms, 1)]


def test_a_counted_number_of_en_suite_rooms_is_theirs_alone() -> None:
    facts = read("A house with four bedrooms with two en-suite bathrooms")
    assert [(fact.room_type, fact.count, fact.suite) for fact in facts.rooms] == [
        ("bedroom", 4, ()),
        ("ensuite_bathroom", 2, ()),
    ]


@pytest.mark.parametrize(
    ("brief", "rooms"),
    [
        ("A house with a snug and a kitchen", ["living_room", "kitchen"]),
        ("A house with a kitchen. The bedrooms should be warm and snug.", ["kitchen", "bedroom"]),
        ("A house with two bedrooms that are snug", ["bedroom"]),
    ],
)
def test_a_snug_is_a_room_where_it_is_no_adjective(brief: str, rooms: list[str]) -> None:
    assert [fact.room_type for fact in read(brief).rooms] == rooms
