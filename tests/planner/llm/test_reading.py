"""A model reads the brief first: its statements count, quotes are verified, and the rules fill its gaps."""

import json
from collections.abc import Iterable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from mansion_knowledge import default_knowledge
from mansion_llm import LlmClient, LlmSettings
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wishes import Wish
from mansion_planner.llm.planner import plan_with_model
from mansion_planner.plan import plan_building

BRIEF = (
    "A two-storey house with three bedrooms, the kitchen next to the dining room, a piano in the living room, no gym"
)
GERMAN = (
    "Ein zweistöckiges Wohnhaus mit drei Schlafzimmern im Obergeschoss, die Küche neben dem Esszimmer, "
    "ohne Keller und mit einem Klavier im Wohnzimmer"
)


def said(kind: str, quote: str, *, scope: dict[str, Any] | None = None, **value: Any) -> dict[str, Any]:
    """Return a statement as a model sends it."""
    return {"kind": kind, "quote": quote, "value": value, "scope": scope or {}}


GOOD = [
    said("floors", "two-storey", count=2),
    said("building_type", "house", name="house", type="house"),
    said("room", "three bedrooms", name="bedroom", type="bedroom", count=3),
    said("room", "kitchen", name="kitchen", type="kitchen", count=1),
    said("room", "dining room", name="dining_room", type="dining_room", count=1),
    said("adjacent", "the kitchen next to the dining room", name="kitchen", other="dining_room"),
    said("room", "living room", name="living_room", type="living_room", count=1),
    said("object", "a piano", name="piano", count=1, scope={"room": "living_room"}),
    said("no_room", "no gym", name="gym", type="gym"),
]
IN_GERMAN = [
    said("floors", "zweistöckiges", count=2),
    said("building_type", "Wohnhaus", name="house", type="house"),
    said("room", "drei Schlafzimmern im Obergeschoss", name="bedroom", type="bedroom", count=3, scope={"floors": [2]}),
    said("room", "Küche", name="kitchen", type="kitchen", count=1),
    said("room", "Esszimmer", name="dining_room", type="dining_room", count=1),
    said("adjacent", "die Küche neben dem Esszimmer", name="kitchen", other="dining_room"),
    said("no_room", "ohne Keller", name="basement"),
    said("object", "einem Klavier", name="piano", count=1, scope={"room": "living_room"}),
    said("room", "Wohnzimmer", name="living_room", type="living_room", count=1),
]


class Reader:
    """Plans with a model that is asked for its reading alone, and answers as it is told."""

    def __init__(self, chat: ModuleType, tape: Path) -> None:
        self.chat, self.tape = chat, tape
        self.requests: list[dict[str, Any]] = []

    def __call__(self, brief: str, *answers: Any, **settings: Any) -> PlanReply:
        """Plan; the last answer is given again and again, and one that is no text is sent as JSON."""
        replies = [self.chat.Reply(a if isinstance(a, str) else json.dumps(a)) for a in answers]
        with self.chat.ChatServer(self.chat.in_turn(*replies)) as server:
            values: dict[str, Any] = {"base_url": server.url, "model": "m", "pieces": ("reading",), "retries": 0}
            client = LlmClient(LlmSettings(**(values | settings)), sleep=lambda seconds: None)
            request = BuildRequest(description=brief, planner="llm")
            self.requests = server.requests
            return plan_with_model(request, default_knowledge(), "b", client)


@pytest.fixture
def read(chat: ModuleType, tmp_path: Path) -> Reader:
    """Return a planner whose model reads."""
    return Reader(chat, tmp_path / "tape.jsonl")


def answer(statements: Iterable[dict[str, Any]], language: str = "English") -> dict[str, Any]:
    return {"language": language, "statements": list(statements)}


def without(*quotes: str) -> list[dict[str, Any]]:
    return [entry for entry in GOOD if entry["quote"] not in quotes]


def readers(reply: PlanReply) -> dict[str, str]:
    """Return who read the words of each wish."""
    return {wish.text: wish.read_by for wish in reply.program.wishes}


def wish(reply: PlanReply, kind: str) -> Wish:
    return next(entry for entry in reply.program.wishes if entry.kind == kind)


def rooms(reply: PlanReply, room_type: str) -> list[int]:
    """Return the floors of the rooms of a type."""
    return [floor.index for floor in reply.program.floors for room in floor.rooms if room.room_type == room_type]


def test_a_good_model_reads_the_whole_brief(read: Reader) -> None:
    reply = read(BRIEF, answer(GOOD))
    assert reply.sources["reading"] == "llm" and len(read.requests) == 1
    assert set(readers(reply).values()) == {"model"}
    assert [entry.kind for entry in reply.program.wishes] == [
        "floors", "building_type", "room", "adjacent", "room", "room", "object", "room", "no_room",
    ]  # fmt: skip
    for entry in reply.program.wishes:
        assert BRIEF[slice(*entry.span)] == entry.text
    assert len(rooms(reply, "bedroom")) == 3


def test_the_question_has_a_schema_and_the_brief_as_data(read: Reader) -> None:
    read(BRIEF, answer(GOOD))
    request = read.requests[0]
    assert request["response_format"]["json_schema"]["name"] == "reading"
    assert f"<brief>\n{BRIEF}\n</brief>" in request["messages"][1]["content"]


def test_the_rules_fill_the_gaps_of_a_weak_model(read: Reader) -> None:
    reply = read(BRIEF, answer(without("three bedrooms", "no gym", "a piano")))
    assert readers(reply) == {
        "two-storey": "model", "house": "model", "three bedrooms": "rules", "kitchen": "model",
        "the kitchen next to the dining room": "model", "dining room": "model", "a piano": "rules",
        "living room": "model", "no gym": "rules",
    }  # fmt: skip
    assert len(rooms(reply, "bedroom")) == 3


def test_the_rules_read_how_rooms_lie_where_the_model_names_the_rooms_alone(read: Reader) -> None:
    reply = read(BRIEF, answer(without("the kitchen next to the dining room")))
    relation = wish(reply, "adjacent")
    assert (relation.read_by, relation.value.name, relation.value.other) == ("rules", "kitchen", "dining_room")


def test_rooms_that_a_relation_names_are_wanted(read: Reader) -> None:
    reply = read(BRIEF, answer(without("kitchen", "dining room")))
    named = {w.value.name: (w.text, w.read_by) for w in reply.program.wishes if w.kind == "room"}
    assert named["kitchen"] == ("kitchen", "model") and named["dining_room"] == ("dining room", "model")


def test_where_both_read_the_same_words_the_model_counts(read: Reader) -> None:
    brief = "A house with a bar stool and three dens"
    statements = [
        said("building_type", "house", type="house"),
        said("object", "a bar stool", name="bar_stool", count=1),
        said("room", "three dens", name="den", type="home_office", count=3),
    ]
    reply = read(brief, answer(statements))
    assert {(w.kind, w.value.type) for w in reply.program.wishes} == {
        ("building_type", "house"), ("object", "bar_stool"), ("room", "home_office"),
    }  # fmt: skip
    assert len(rooms(reply, "home_office")) == 3


def test_private_rooms_hang_on_their_owners(read: Reader) -> None:
    brief = "A house with three bedrooms, each with a bathroom"
    statements = [
        said("room", "three bedrooms", name="bedroom", type="bedroom", count=3),
        said("room", "a bathroom", name="bathroom", type="bathroom", count=1, scope={"room": "bedroom", "each": True}),
    ]
    reply = read(brief, answer(statements))
    private = next(w for w in reply.program.wishes if w.scope.room)
    assert (private.value.count, private.scope.room, private.read_by) == (3, "bedroom", "model")
    by_rules = read(brief, answer(statements[:1]))
    assert next(w for w in by_rules.program.wishes if w.scope.room).read_by == "rules"


@pytest.mark.parametrize(
    ("count", "each", "total"), [(1, True, 3), (1, False, 3), (3, False, 3), (3, True, 3), (2, True, 6), (6, False, 6)]
)
def test_private_rooms_may_be_counted_for_each_owner_or_for_all(
    read: Reader, count: int, each: bool, total: int
) -> None:
    statements = [
        said("room", "three bedrooms", name="bedroom", type="bedroom", count=3),
        said(
            "room", "bathrooms", name="bathroom", type="bathroom", count=count, scope={"room": "bedroom", "each": each}
        ),
    ]
    reply = read("A house with three bedrooms and bathrooms of their own", answer(statements))
    assert next(w for w in reply.program.wishes if w.scope.room).value.count == total


def test_an_invented_quote_is_asked_for_again_once_and_then_left_out(read: Reader) -> None:
    invented = said("room", "a swimming pool", name="pool", type="indoor_pool", count=1)
    reply = read(BRIEF, answer([*GOOD, invented]), repairs=5)
    assert len(read.requests) == 2
    assert "not in the brief" in read.requests[1]["messages"][-1]["content"]
    assert not rooms(reply, "indoor_pool") and set(readers(reply).values()) == {"model"}
    assert reply.sources["reading"].startswith("llm for 9 of 10 statements: ")
    mended = read(BRIEF, answer([*GOOD, invented]), answer(GOOD))
    assert mended.sources["reading"] == "llm"


def test_a_model_that_invents_every_quote_leaves_the_reading_to_the_rules(read: Reader) -> None:
    invented = said("room", "a swimming pool", name="pool", type="indoor_pool", count=1)
    reply = read(BRIEF, answer([invented]))
    assert reply.sources["reading"].startswith("rules: ") and set(readers(reply).values()) == {"rules"}
    with pytest.raises(MansionError, match="next to nothing"):
        read(GERMAN, answer([invented], "German"))


@pytest.mark.parametrize("quote", ["THREE  bedrooms", "“three bedrooms”", "three\nbedrooms."])
def test_a_quote_may_differ_in_case_white_space_and_marks(read: Reader, quote: str) -> None:
    reply = read(BRIEF, answer([*without("three bedrooms"), said("room", quote, name="bedroom", count=3)]))
    assert readers(reply)["three bedrooms"] == "model"


def test_a_model_may_say_how_much_lies_about_in_a_room(read: Reader) -> None:
    reply = read(BRIEF, answer([*GOOD, said("clutter", "kitchen", name="dense", scope={"room": "kitchen"})]))
    cluttered = {room.room_type for floor in reply.program.floors for room in floor.rooms if room.clutter == "dense"}
    assert cluttered == {"kitchen"}


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (said("rooms", "three bedrooms"), "kind is one of"),
        (said("room", "three bedrooms", count=3), "value.name"),
        (said("room", "three bedrooms", name="bedroom", count=-3), "value.count"),
        (said("floors", "two-storey"), "value.count"),
        (said("total_area", "house", area=-5.0), "value.area"),
        (said("style", "house", name="moonlike"), "styles"),
        (said("building_type", "house", name="zorb"), "building types"),
        (said("outline", "house", name="Z"), "value.name must be one of"),
        (said("height", "house", height=0.2), "value.height"),
        (said("facade", "house", name="gingerbread"), "a material of outer walls"),
        (said("roof", "house", name="sawtooth"), "flat, gable or hip"),
        (said("grounds", "house", name="moat"), "garden, pool, parking"),
        (said("copy", "house", scope={"floors": [1, 3]}), "consecutive"),
        (said("room", "kitchen", name="kitchen", scope={"floors": ["attic"]}), "scope.floors"),
        (said("material", "house", name="oak", type="ceiling"), "floor or wall"),
        (said("clutter", "house", name="chaos"), "dense or sparse"),
        (said("room", "three bedrooms", name="stairs"), "stair or elevator"),
        (said("room", BRIEF, name="bedroom"), "longer than 12 words"),
    ],
)
def test_what_is_wrong_with_a_statement_is_told_and_the_rest_is_used(
    read: Reader, wrong: dict[str, Any], words: str
) -> None:
    reply = read(BRIEF, answer([wrong, *GOOD]))
    assert words in reply.sources["reading"]
    assert len(rooms(reply, "bedroom")) == 3


def test_a_reading_that_cannot_be_planned_is_asked_for_again(read: Reader) -> None:
    brief = "A house of 500 feet squared and two bedrooms"
    wrong = said("total_area", "500 feet squared", area=5.0)
    right = said("total_area", "500 feet squared", area=46.5)
    house = said("building_type", "house", type="house")
    reply = read(brief, answer([house, wrong]), answer([house, right]))
    assert "cannot be planned" in read.requests[1]["messages"][-1]["content"]
    assert sum(floor.gross_floor_area for floor in reply.program.floors) > 40.0
    with pytest.raises(MansionError) as error:
        read(brief, answer([house, wrong]))
    assert error.value.code == ErrorCode.INFEASIBLE and len(read.requests) == 2


def test_what_weak_models_write_beside_the_schema_is_understood(read: Reader) -> None:
    brief = "A two-storey house with a piano, bedrooms upstairs and a study on the ground floor"
    statements = [
        said("building_type", "A two-storey house", name="two_storey_house", type="house"),
        said("floors", "two-storey", count=2),
        said("object", "a piano", name="piano", scope={"room": "house"}),
        said("room", "bedrooms upstairs", name="bedrooms", scope={"floors": ["upper floors"]}),
        said("room", "a study", name="study", scope={"floors": ["Ground Floor"]}),
    ]
    reply = read(brief, answer(statements))
    told = {w.value.name: w for w in reply.program.wishes}
    assert reply.sources["reading"] == "llm" and set(readers(reply).values()) == {"model"}
    assert (told["piano"].scope.room, told["study"].scope.floors) == ("", [1])
    assert (told["bedroom"].value.count, told["bedroom"].scope.floors) == (None, [2])


def test_a_model_reads_other_languages(read: Reader) -> None:
    with pytest.raises(MansionError, match="next to nothing"):
        read(GERMAN, "Das verstehe ich nicht.")
    reply = read(GERMAN, answer(IN_GERMAN, "German"))
    assert set(readers(reply).values()) == {"model"}
    assert wish(reply, "no_room").text == "ohne Keller"
    assert rooms(reply, "bedroom") == [2, 2, 2]
    pianos = [entry.category for floor in reply.program.floors for room in floor.rooms for entry in room.objects]
    assert pianos == ["piano"]


def test_what_a_model_leaves_out_of_another_language_is_told(read: Reader) -> None:
    statements = [
        entry for entry in IN_GERMAN if entry["quote"] not in ("drei Schlafzimmern im Obergeschoss", "ohne Keller")
    ]
    reply = read(GERMAN, answer(statements, "de"))
    unread = [w.text for w in reply.program.wishes if w.kind == "unread"]
    assert unread == ["mit drei Schlafzimmern im Obergeschoss", "ohne Keller und mit"]


def test_words_that_neither_understands_are_told(read: Reader) -> None:
    brief = "A house with two bedrooms, and the moon sets behind quarks"
    statements = [said("room", "two bedrooms", name="bedroom", count=2), said("building_type", "house", type="house")]
    assert "unread" in {w.kind for w in read(brief, answer(statements)).program.wishes}
    aside = said("aside", "the moon sets behind quarks")
    assert "unread" not in {w.kind for w in read(brief, answer([*statements, aside])).program.wishes}
    unread = said("unread", "the moon sets behind quarks")
    told = wish(read(brief, answer([*statements, unread])), "unread")
    assert (told.text, told.read_by) == ("the moon sets behind quarks", "model")


@pytest.mark.parametrize(
    "garbage", ["no idea", '{"statements": 4}', '{"language": "English", "statements": []}', "[[["]
)
def test_a_model_that_returns_garbage_leaves_the_reading_to_the_rules(read: Reader, garbage: str) -> None:
    reply = read(BRIEF, garbage)
    assert reply.sources["reading"].startswith("rules: ")
    assert set(readers(reply).values()) == {"rules"}
    assert [w.kind for w in reply.program.wishes][:2] == ["floors", "building_type"]


def test_an_endpoint_that_fails_leaves_the_reading_to_the_rules(read: Reader) -> None:
    with read.chat.ChatServer(read.chat.in_turn(read.chat.Reply("busy", status=503))) as server:
        settings = LlmSettings(base_url=server.url, model="m", pieces=("reading",), retries=0)
        client = LlmClient(settings, sleep=lambda seconds: None)
        request = BuildRequest(description=BRIEF, planner="llm")
        reply = plan_with_model(request, default_knowledge(), "b", client)
    assert reply.sources["reading"].startswith("rules: ") and len(rooms(reply, "bedroom")) == 3


def test_the_rules_refuse_nothing_before_the_model_is_asked(read: Reader) -> None:
    brief = "A tower of 400 floors would be silly; give me a house of two floors"
    with pytest.raises(MansionError, match="400"):
        read(brief, "garbage")
    assert read.requests
    statements = [
        said("aside", "A tower of 400 floors would be silly"),
        said("building_type", "a house", type="house"),
        said("floors", "two floors", count=2),
    ]
    reply = read(brief, answer(statements))
    assert len(reply.program.floors) == 2 and reply.program.building_type == "house"


def test_a_reading_that_states_nothing_is_refused_after_the_model_was_asked(read: Reader) -> None:
    with pytest.raises(MansionError, match="next to nothing") as error:
        read("blorp quux zzz", answer([said("unread", "blorp quux zzz")], "Klingon"))
    assert error.value.code == ErrorCode.INVALID_PAYLOAD and len(read.requests) == 1


def test_an_unknown_kind_of_building_is_planned_as_the_model_says(read: Reader) -> None:
    statements = [said("building_type", "An igloo", name="igloo", type="bungalow")]
    reply = read("An igloo with two bedrooms", answer(statements))
    told = wish(reply, "building_type")
    assert reply.program.kind == "bungalow" and reply.program.building_type == "igloo"
    assert (told.text, told.value.name, told.value.type) == ("An igloo", "igloo", "bungalow") and told.reason


def test_a_piece_that_is_not_wanted_is_not_asked_for(read: Reader) -> None:
    reply = read(BRIEF, "never asked", pieces=("seeds",))
    assert reply.sources["reading"] == "rules" and set(readers(reply).values()) == {"rules"}
    assert len(reply.program.wishes) == len(plan_of_rules().program.wishes)


def plan_of_rules(brief: str = BRIEF) -> PlanReply:
    return plan_building(BuildRequest(description=brief))


def test_the_same_text_and_answers_give_the_same_bytes(read: Reader) -> None:
    weak = answer(without("three bedrooms", "a piano"))
    first, again = read(BRIEF, weak, record=read.tape), read(BRIEF, weak)
    assert encode_bytes(first.program) == encode_bytes(again.program)
    client = LlmClient(LlmSettings(replay=read.tape))
    request = BuildRequest(description=BRIEF, planner="llm")
    replayed = plan_with_model(request, default_knowledge(), "b", client)
    assert encode_bytes(replayed.program) == encode_bytes(first.program)
    assert encode_bytes(replayed.problems) == encode_bytes(first.problems)
