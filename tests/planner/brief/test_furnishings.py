"""Which furniture a brief asks for, how much of it, and where."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import ObjectFact
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.reader import read_brief

NOUNS = """
sofa, armchair, recliner, rocking chair, bean bag, coffee table, tv stand, television, bookcase, fireplace,
wood burner, piano, grand piano, drum kit, double bed, bunk bed, crib, wardrobe, bedside table, dressing
table, mirror, writing desk, office chair, filing cabinet, photocopier, monitor, server rack, whiteboard,
blackboard, projector, lectern, rostrum, pulpit, altar, pew, shoe rack, coat rack, bench, bar stool, high
chair, round table, kitchen island, range cooker, pizza oven, microwave, chest freezer, dishwasher, washing
machine, tumble dryer, ironing board, urinal, bathtub, hot tub, massage table, examination couch, dental
chair, dialysis chair, birthing pool, hospital bed, mri scanner, operating table, wheelchair, stretcher,
barber chair, hair dryer, kiln, easel, pottery wheel, loom, sewing machine, printing press, 3d printer, laser
cutter, drill press, table saw, workbench, car lift, forklift, pallet, conveyor belt, robot arm, steel tank,
vat, barrel, silo, boiler, generator, crane, milking stall, cage, cat tree, aquarium, feeding trough, beehive,
vending machine, coffee machine, water cooler, popcorn machine, counter, till, cash register, checkout,
display case, showcase, mannequin, clothes rack, atm, ticket machine, turnstile, safe, locker, treadmill,
rowing machine, squat rack, punching bag, boxing ring, climbing wall, table tennis table, pool table,
dartboard, slot machine, pinball machine, jukebox, microphone, loudspeaker, mixing desk, music stand, tripod,
softbox, telescope, microscope, fume hood, safety cabinet, centrifuge, lab bench, optical table, statue,
plinth, painting, notice board, globe, study carrel, sandpit, changing table, lounger, picnic table, fountain,
potted plant, rug, chandelier, grandfather clock, luggage cart, metal detector, check-in counter, charging
station, dough mixer, wine rack, prayer mat, coffin, cubicle, phone booth, plan chest, dress form, tyre
changer, gas cylinder, bike rack, van, boat
"""


def wanted(brief: str) -> list[ObjectFact]:
    return read_brief(brief, default_knowledge()).objects


@pytest.mark.parametrize("noun", [noun.strip() for noun in NOUNS.replace("\n", " ").split(",")])
def test_things_that_people_ask_for_are_known(noun: str) -> None:
    words = tuple(noun.replace("-", " ").split())
    category, size = furniture_of(words)
    assert category and size == len(words)


@pytest.mark.parametrize("noun", ["water treatment plant", "tea", "guard's post", "baggage"])
def test_words_that_only_sound_like_furniture_are_left(noun: str) -> None:
    assert furniture_of(tuple(noun.split())) == ("", 0)


def test_a_list_of_furniture_belongs_to_one_room_though_one_of_it_is_a_room_elsewhere() -> None:
    found = wanted("A prison with 24 cells, every cell fitted with bunk, toilet and writing desk.")
    assert {"bunk_bed", "desk"} <= {fact.category for fact in found}
    assert {(fact.room, fact.each) for fact in found} == {("cell", True)}


def test_a_lift_for_vehicles_is_furniture_of_the_workshop() -> None:
    found = wanted("A garage with an office and a workshop with four car lifts (those are for the vehicles).")
    assert [(fact.category, fact.count, fact.room) for fact in found] == [("car_lift", 4, "workshop")]


def test_what_a_lift_carries_is_not_asked_for() -> None:
    assert wanted("A music school with two storeys. There is a lift that carries pianos.") == []


@pytest.mark.parametrize(
    "brief, categories",
    [
        ("A house with a kitchen and a bathroom. A shower instead of a bathtub.", {"bathtub"}),
        ("A house with a living room; a television or a piano are not wanted.", {"television", "piano"}),
        ("A hotel with ten rooms and no bathtubs.", {"bathtub"}),
    ],
)
def test_what_is_not_wanted_is_wanted_nowhere(brief: str, categories: set[str]) -> None:
    unwanted = [fact for fact in wanted(brief) if fact.excluded]
    assert {fact.category for fact in unwanted} == categories
    assert all(fact.room in ("", "room", "hotel_room") for fact in unwanted)


def test_a_number_is_exact_unless_the_text_says_at_least() -> None:
    found = wanted("An office with a lounge with two armchairs, at least four plants and a sofa.")
    assert {fact.category: fact.exact for fact in found} == {"armchair": True, "house_plant": False, "sofa": False}


def test_furniture_after_a_room_that_another_has_is_the_other_ones() -> None:
    found = wanted("A cinema with a foyer with box office and popcorn counter.")
    assert [(fact.room) for fact in found] == ["foyer"]


def test_furniture_that_a_room_is_said_to_have_does_not_move_on_to_the_next_room() -> None:
    found = wanted("A bank with a banking hall with five teller counters and two ATMs in the vestibule.")
    assert [(fact.count, fact.room) for fact in found] == [(5, "banking_hall"), (2, "vestibule")]


def test_entries_of_a_list_do_not_share_the_room_of_the_last() -> None:
    found = wanted("A tiny house. A kitchen, a writing desk, a washing machine in the bathroom.")
    assert {fact.category: fact.room for fact in found} == {"desk": "", "washing_machine": "bathroom"}


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("A restaurant with a kitchen next to the dining room and with an oven in it", "kitchen"),
        ("A restaurant: kitchen beside the dining room, with an oven in it", "kitchen"),
        ("A restaurant with a dining room and a kitchen with an oven", "kitchen"),
        ("A restaurant with a kitchen beside the store, with a dining room and an oven in the store", "store"),
        ("A flat with a kitchen corner with sink and fridge, one oven, two bedrooms", ""),
        ("A flat with a kitchen corner, a bed and an oven", ""),
    ],
)
def test_furniture_stands_in_the_room_that_its_clause_is_about(text: str, room: str) -> None:
    objects = read_brief(text, default_knowledge()).objects
    assert [fact.room for fact in objects if fact.category in ("stove", "oven")] == [room]


@pytest.mark.parametrize("words", ["a bedroom (double bed)", "one bedroom with a double bed", "a bedroom: double bed"])
def test_a_double_bed_is_no_number_of_bedrooms(words: str) -> None:
    facts = read_brief(f"A flat with {words}, a wardrobe.", default_knowledge())
    assert [(room.name, room.count) for room in facts.rooms] == [("bedroom", 1)]
    assert [thing.category for thing in facts.objects] == ["bed", "wardrobe"]
    assert facts.unread == []


@pytest.mark.parametrize(
    ("text", "category", "room"),
    [
        ("A hotel with ten guest rooms, each with a small bathroom, two beds and a TV", "bed", "guest_room"),
        ("A hotel with ten guest rooms, each with a small bathroom, two beds and a TV", "television", "guest_room"),
        ("A school: a recital room with a stage and a grand piano, a foyer", "grand_piano", "recital_room"),
        ("A house: a bedroom with a bathroom and a bathtub, a kitchen", "bathtub", "bathroom"),
    ],
)
def test_furniture_listed_beside_a_room_is_of_the_room_that_has_both(text: str, category: str, room: str) -> None:
    assert [fact.room for fact in wanted(text) if fact.category == category] == [room]


@pytest.mark.parametrize(
    ("text", "category"),
    [
        ("A laboratory: a chemistry lab with an emergency shower", "shower_cabin"),
        ("A birth centre: four birthing rooms, each with a birthing pool", "jacuzzi"),
        ("A house: a kitchen with an island and four bar stools", "kitchen_island"),
        ("A hotel: a lounge with a little table", "cafe_table"),
    ],
)
def test_what_stands_in_a_room_is_no_room(text: str, category: str) -> None:
    assert category in {fact.category for fact in wanted(text)}
    assert len(read_brief(text, default_knowledge()).rooms) == 1


def test_an_island_in_the_sea_is_no_furniture() -> None:
    assert wanted("The school of a small island with a lobby") == []


@pytest.mark.parametrize(
    ("tables", "seats"),
    [
        ("20 tables for 4 persons each", 80),
        ("10 tables for 4 people", 40),
        ("one table for 8 guests", 8),
        ("12 tables for 50 guests", 50),
    ],
)
def test_who_sits_at_tables_has_a_chair(tables: str, seats: int) -> None:
    facts = read_brief(f"A restaurant. The dining room has {tables} and a bar.", default_knowledge())
    chairs = [fact for fact in facts.objects if fact.category == "chair"]
    assert [(fact.count, fact.room) for fact in chairs] == [(seats, "dining_room")]
    assert not facts.occupants


def test_chairs_that_are_counted_are_not_counted_again() -> None:
    facts = read_brief("A house with a kitchen with a table for twelve people and 12 chairs.", default_knowledge())
    assert [fact.count for fact in facts.objects if fact.category == "chair"] == [12]


@pytest.mark.parametrize("least", ["(ten at least)", ", ten or more", "(10 minimum)", ": 10 at least"])
def test_a_number_after_a_noun_may_be_the_least(least: str) -> None:
    found = read_brief(f"A bookshop with a sales area with plenty of bookshelves {least}.", default_knowledge()).objects
    assert [(fact.category, fact.count, fact.exact) for fact in found] == [("bookshelf", 10, False)]


@pytest.mark.parametrize("after", ["(ten at most)", ", ten of our own"])
def test_other_numbers_after_a_noun_are_no_least(after: str) -> None:
    found = read_brief(f"A shop with a sales area with bookshelves {after}.", default_knowledge()).objects
    assert [fact.count for fact in found] != [10]


@pytest.mark.parametrize("room", ["club room with a bar", "lounge with its own bar", "common room with bar"])
def test_the_bar_of_a_room_to_sit_in_is_its_counter(room: str) -> None:
    facts = read_brief(f"A rowing club with a {room} and a kitchen.", default_knowledge())
    assert [fact.category for fact in facts.objects] == ["bar_counter"]
    assert "bar" not in {fact.room_type for fact in facts.rooms}


@pytest.mark.parametrize("rooms", ["lounge, a bar and a kitchen", "lounge and a bar", "foyer with bar"])
def test_a_bar_beside_other_rooms_is_a_room(rooms: str) -> None:
    assert "bar" in {fact.room_type for fact in read_brief(f"A hotel with a {rooms}.", default_knowledge()).rooms}


@pytest.mark.parametrize(
    "text",
    [
        "A house with four bedrooms. And forget the sauna I mentioned on the phone.",
        "A library with a lift; many visitors come with strollers.",
    ],
)
def test_things_that_are_only_spoken_of_are_not_wanted(text: str) -> None:
    assert read_brief(text, default_knowledge()).objects == []


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("A flat with two bedrooms. One bed per bedroom, no TV anywhere.", ""),
        ("A flat with two bedrooms, without a TV in the bedrooms.", "bedroom"),
    ],
)
def test_what_is_wanted_nowhere_is_wanted_in_no_room(text: str, room: str) -> None:
    refused = [wanted for wanted in read_brief(text, default_knowledge()).objects if wanted.excluded]
    assert [wanted.room for wanted in refused] == [room]


def test_racks_of_a_server_room_are_server_racks() -> None:
    wanted = read_brief("A data centre with two data halls of 24 racks each", default_knowledge()).objects
    assert [entry.category for entry in wanted] == ["server_rack"]


@pytest.mark.parametrize(
    ("brief", "shares"),
    [
        (
            "A community centre: three meeting rooms - one with a round table, one with a sofa, one with eight desks",
            [("round_table", 1, 0), ("sofa", 1, 1), ("desk", 1, 2)],
        ),
        ("Two bedrooms, one with a desk and the other with a piano", [("desk", 1, 0), ("piano", 1, 1)]),
        ("Four bedrooms, one with a desk, the other three have bunk beds", [("desk", 1, 0), ("bunk_bed", 3, 1)]),
        ("Three classrooms, each with a piano", [("piano", 0, 0)]),
    ],
)
def test_what_some_of_several_rooms_have_is_in_as_many_others(brief: str, shares: list[tuple[str, int, int]]) -> None:
    found = read_brief(brief, default_knowledge()).objects
    assert [(fact.category, fact.some, fact.others) for fact in found] == shares
    assert all(fact.each != bool(fact.some) for fact in found)


@pytest.mark.parametrize(
    "brief",
    [
        "Changing rooms for men and women with thirty lockers each",
        "Changing rooms for men and women each with two showers and thirty lockers",
        "Changing rooms (men / women) with thirty lockers and five showers each",
    ],
)
def test_what_rooms_for_men_and_for_women_have_is_in_either(brief: str) -> None:
    found = read_brief(f"A gym. {brief}.", default_knowledge()).objects
    lockers = [(fact.room, fact.count) for fact in found if fact.category == "locker"]
    assert lockers == [("man_changing_room", 30), ("woman_changing_room", 30)]


@pytest.mark.parametrize(
    ("brief", "owners"),
    [
        ("A gym: a spinning room with twenty bikes, a boxing ring, changing rooms", ["spinning_room", ""]),
        ("A house: kitchen, guest toilet, cupboard under the stairs", [""]),
        ("A library: open stacks with 60 shelves, eight public computers, reading room", ["open_stack", ""]),
        ("An office with a kitchen, herb store, no televisions", [""]),
        ("A house: a garage with a bike, a workbench and a ladder", ["garage", "garage", "garage"]),
        ("A house with three bedrooms. One of the bedrooms has a cot", ["bedroom"]),
    ],
)
def test_what_is_listed_beside_a_room_is_not_in_it(brief: str, owners: list[str]) -> None:
    assert [fact.room for fact in read_brief(brief, default_knowledge()).objects] == owners


def test_a_number_that_can_be_shared_out_is_that_of_all_rooms() -> None:
    found = read_brief("36 workstations in three team areas; a lamp in three cells", default_knowledge()).objects
    assert [(fact.room, fact.count, fact.each) for fact in found] == [("team_area", 36, False), ("cell", 1, True)]


def test_what_a_room_of_each_group_has_is_for_every_group() -> None:
    brief = "A kindergarten with four groups. Each group has a group room and a nap room with ten cots."
    assert [(fact.count, fact.each) for fact in read_brief(brief, default_knowledge()).objects] == [(10, True)]


@pytest.mark.parametrize(
    ("brief", "each"),
    [("Three seminar rooms for twenty", True), ("Two meeting rooms for four", True), ("Two halls for 60", False)],
)
def test_a_few_people_are_those_of_each_room(brief: str, each: bool) -> None:
    assert [fact.each for fact in read_brief(f"A clinic. {brief}.", default_knowledge()).objects] == [each]


@pytest.mark.parametrize(
    ("thing", "category", "count"),
    [
        ("two floor lamps", "floor_lamp", 2),
        ("two deck ovens", "baking_oven", 2),
        ("two drum kits", "drum_kit", 2),
        ("grab bars", "grab_bar", None),
        ("an exam couch", "exam_table", 1),
    ],
)
def test_things_are_known_by_their_whole_name(thing: str, category: str, count: int | None) -> None:
    facts = read_brief(f"A house with a bathroom with {thing}.", default_knowledge())
    assert [(fact.category, fact.count) for fact in facts.objects] == [(category, count)]
    assert [room.name for room in facts.rooms] == ["bathroom"]
    assert facts.unread == []


@pytest.mark.parametrize(
    ("brief", "words"),
    [
        ("A lounge with a sofa in green.", "green"),
        ("A lounge with floor-to-ceiling bookshelves.", "floor-to-ceiling"),
        ("A sunroom with wicker chairs.", "wicker"),
        ("A washroom with six small toilets.", "small"),
        ("The bedrooms have single beds.", "single"),
        ("A guest room with double bed.", "double"),
    ],
)
def test_how_a_thing_is_to_be_is_kept_once(brief: str, words: str) -> None:
    facts = read_brief(f"A house. {brief}", default_knowledge())
    assert [span.words for span in facts.unheeded] == [words]
    assert facts.unread == []


def test_people_who_sleep_in_bunks_need_half_as_many_beds() -> None:
    found = read_brief("A hostel with four dorms for six people with bunk beds", default_knowledge()).objects
    assert [(fact.category, fact.count, fact.each) for fact in found] == [
        ("bunk_bed", 3, True),
        ("bunk_bed", None, True),
    ]


def test_what_rooms_are_of_each_of_them_has() -> None:
    wanted = read_brief("A hostel with six dormitories of eight beds and a lounge.", default_knowledge()).objects
    assert [(entry.category, entry.count, entry.each) for entry in wanted] == [("bed", 8, True)]
