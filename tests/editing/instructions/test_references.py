"""Words mean the rooms, things and places that they fit best, and are refused where they fit several equally."""

import msgspec
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.meaning.choices import one_room_each, things_meant
from mansion_editing.instructions.meaning.context import Ambiguous, Context
from mansion_editing.instructions.meaning.descriptions import rooms_of, things_of
from mansion_editing.instructions.meaning.targets import places_of
from mansion_editing.instructions.statements import Amount, Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_scene.decor.frames import scene_object

HERE = Context()


def ids(found: list) -> list[str]:  # type: ignore[type-arg]
    return [item.id for item in found]


def the(noun: str, **more: object) -> Things:
    return Things(noun=noun, definite=True, **more)  # type: ignore[arg-type]


KITCHEN = Rooms(words="kitchen")
ON_TABLE = Place(relation="on", anchor=the("dining table"), rooms=KITCHEN)
ELSEWHERE = Place(rooms=KITCHEN, outside=True)


@pytest.mark.parametrize(
    ("rooms", "expected"),
    [
        (Rooms(words="kitchen"), ["F1/kitchen"]),
        (Rooms(words="office"), ["F2/private_office_1"]),
        (Rooms(words="private office 1"), ["F2/private_office_1"]),
        (Rooms(words="office 2"), []),
        (Rooms(words="F1/hall"), ["F1/hall"]),
        (Rooms(floors=(2,), every=True), ["F2/corridor", "F2/private_office_1"]),
        (Rooms(words="rooms", floors=(1,), ordinal=-1), ["F1/kitchen"]),
        (Rooms(words="room", next_to="kitchen"), ["F1/hall"]),
        (Rooms(words="room", holding=the("fridge")), ["F1/kitchen"]),
        (Rooms(same=True), ["F1/hall"]),
        (Rooms(words="ballroom"), []),
    ],
)
def test_words_mean_rooms(furnished_state: SceneState, rooms: Rooms, expected: list[str]) -> None:
    assert rooms_of(furnished_state, rooms, Context(rooms=("F1/hall",))) == expected


@pytest.mark.parametrize(
    ("things", "expected"),
    [
        (the("fridge"), ["F1/kitchen/fridge_1"]),
        (the("chair", plural=True), ["F1/hall/chair_1", "F1/hall/chair_2", "F1/hall/chair_3"]),
        (the("chair", ordinal=2), ["F1/hall/chair_2"]),
        (the("chair", ordinal=-1), ["F1/hall/chair_3"]),
        (the("chair 3"), ["F1/hall/chair_3"]),
        (the("F1/hall/chair_3"), ["F1/hall/chair_3"]),
        (the("seat", plural=True), [*(f"F1/hall/chair_{n}" for n in (1, 2, 3)), "F1/hall/sofa_1"]),
        (the("sofa", colour="red"), []),
        (the("mug", place=ON_TABLE), ["F1/kitchen/mug_1"]),
        (the("mug", owned="kitchen"), ["F1/kitchen/mug_1"]),
        (the("mug", place=ELSEWHERE), [f"F2/private_office_1/mug_{n}" for n in (1, 2)]),
        (
            Things(plural=True, place=Place(relation="on", anchor=the("table", owned="kitchen")), beside=(the("mug"),)),
            ["F1/kitchen/plate_1"],
        ),
        (the("lamp"), ["F2/private_office_1/floor_lamp_1"]),
        (the("light", place=Place(rooms=Rooms(words="kitchen"))), [f"F1/kitchen/ceiling_light_{n}" for n in (1, 2)]),
        (the("piano"), []),
    ],
)  # fmt: skip
def test_words_mean_things(furnished_state: SceneState, things: Things, expected: list[str]) -> None:
    assert ids(things_of(furnished_state, things, HERE)) == expected


def test_pronouns_mean_what_was_mentioned_last(furnished_state: SceneState) -> None:
    context = Context(("F1/hall/chair_2",), ("F1/hall",), "chair")
    assert ids(things_of(furnished_state, Things(refers="last"), context)) == ["F1/hall/chair_2"]
    assert ids(things_of(furnished_state, Things(refers="others", plural=True), context)) == [
        "F1/hall/chair_1",
        "F1/hall/chair_3",
    ]


def test_one_certain_thing_among_several_is_refused_with_the_candidates(furnished_state: SceneState) -> None:
    with pytest.raises(Ambiguous) as caught:
        things_meant(furnished_state, the("chair"), HERE)
    assert caught.value.code == "CONFLICT"
    assert caught.value.info.details["candidates"] == [f"F1/hall/chair_{n}" for n in (1, 2, 3)]
    assert "say which" in caught.value.info.message


def test_the_light_of_a_room_means_all_its_ceiling_lights(furnished_state: SceneState) -> None:
    light = the("light", place=Place(rooms=Rooms(words="kitchen")))
    assert len(things_meant(furnished_state, light, HERE)) == 2


@pytest.mark.parametrize(
    ("amount", "definite", "number"),
    [
        (Amount(number=2), False, 2),
        (Amount(number=2, of=3), True, 2),
        (Amount(kind="all", number=0), True, 3),
        (Amount(kind="all_but"), True, 2),
        (Amount(kind="exactly"), False, 2),
        (Amount(kind="at_most", number=5), False, 0),
    ],
)
def test_the_number_that_is_meant(furnished_state: SceneState, amount: Amount, definite: bool, number: int) -> None:
    things = Things(noun="chair", plural=amount.number != 1, amount=amount, definite=definite)
    assert len(things_meant(furnished_state, things, HERE, surplus=True)) == number


@pytest.mark.parametrize("amount", [Amount(number=4), Amount(number=2, of=5), Amount(kind="all", number=4)])
def test_more_than_there_are_is_refused_with_the_number_there(furnished_state: SceneState, amount: Amount) -> None:
    with pytest.raises(MansionError, match="3 chair"):
        things_meant(furnished_state, Things(noun="chair", plural=True, amount=amount), HERE)


def test_a_room_is_told_apart_by_what_the_statement_needs(furnished_state: SceneState) -> None:
    rooms = Rooms(words="room", floors=(1,))
    with pytest.raises(Ambiguous):
        one_room_each(furnished_state, rooms, HERE)
    assert one_room_each(furnished_state, rooms, HERE, lambda room: room == "F1/hall") == ["F1/hall"]


def test_the_table_of_two_rooms_is_ambiguous_and_that_of_one_is_not(furnished_state: SceneState) -> None:
    with pytest.raises(Ambiguous, match="dining_table_1 in Kitchen or F2"):
        places_of(furnished_state, Place(relation="on", anchor=the("dining table")), HERE)
    (target,) = places_of(
        furnished_state, Place(relation="on", anchor=the("dining table"), rooms=Rooms(words="kitchen")), HERE
    )
    assert target.anchor is not None and target.anchor.id == "F1/kitchen/dining_table_1"


@pytest.mark.parametrize("relation", ["on", "beside", "near"])
def test_any_chair_of_a_room_serves_to_put_something_on_or_beside(furnished_state: SceneState, relation: str) -> None:
    place = msgspec.structs.replace(Place(anchor=the("chair")), relation=relation)
    assert len(places_of(furnished_state, place, HERE)) == 3


def test_tables_of_several_rooms_are_asked_about(furnished_state: SceneState) -> None:
    with pytest.raises(Ambiguous):
        places_of(furnished_state, Place(relation="beside", anchor=the("dining table")), HERE)


def test_a_name_comes_before_an_alias_of_another_room(furnished_state: SceneState) -> None:
    floor, corridor = next(pair for pair in furnished_state.rooms() if pair[1].room_type == "corridor")
    scene = furnished_state.scenes[floor]
    named = msgspec.structs.replace(corridor, aliases=["hall"])
    rooms = [named if room.id == corridor.id else room for room in scene.rooms]
    furnished_state.scenes[floor] = msgspec.structs.replace(scene, rooms=rooms)
    assert rooms_of(furnished_state, Rooms(words="hall"), HERE) == ["F1/hall"]
    assert rooms_of(furnished_state, Rooms(words="hall", floors=(2,)), HERE) == ["F2/corridor"]


@pytest.mark.parametrize("noun", ["kitchen table", "office table"])
def test_a_room_named_before_a_noun_tells_which_is_meant(furnished_state: SceneState, noun: str) -> None:
    (found,) = things_of(furnished_state, the(noun), HERE)
    assert noun.split()[0] in found.room and found.category == "dining_table"


def test_an_exception_that_is_not_there_is_refused(furnished_state: SceneState) -> None:
    everything = Things(plural=True, amount=Amount(kind="all", number=0), beside=(the("vase"),))
    with pytest.raises(MansionError, match="no vase to leave out"):
        things_meant(furnished_state, everything, HERE)


def test_one_of_several_is_nearest_where_no_room_is_named(editor: SceneEditor) -> None:
    assert instruct(editor, "Put a vase on the office desk.").done
    report = instruct(editor, "Move the vase from the office desk to one of the dining tables.")
    (vase,) = (item for _, item in editor.state.objects() if item.category.endswith("vase"))
    assert report.done and vase.parent == "F2/private_office_1/dining_table_1"
    report = instruct(editor, "In private office 1 remove the vase. Put a bowl on one of the dining tables.")
    assert report.done and any(name.startswith("F2/private_office_1/bowl") for name in report.object_ids)


def test_another_room_is_meant_where_it_is_named(editor: SceneEditor) -> None:
    assert instruct(editor, "Put a vase on the office desk.").done
    report = instruct(editor, "Move the vase from the office desk to one of the dining tables in the kitchen.")
    assert report.done and any(name.startswith("F1/kitchen/") for name in report.object_ids)


def test_each_of_several_rooms_has_its_own_thing_of_a_name(furnished: list[FloorScene], catalogue: Catalogue) -> None:
    first, second = furnished
    stood = [
        scene_object(
            catalogue.by_category(kind)[0], f"F1/{room}/{kind}_1", f"F1/{room}", (x, 2.0, 0.4), 0.0, mount="floor"
        )
        for kind, room, x in (("toilet", "hall", 2.0), ("toilet_pan", "kitchen", 8.0))
    ]
    scenes = [msgspec.structs.replace(first, objects=[*first.objects, *stood]), second]
    in_both = Place(rooms=Rooms(words="hall / kitchen", every=True, number=2))
    found = things_of(SceneState(scenes, catalogue), the("toilet", place=in_both), HERE)
    assert ids(found) == ["F1/hall/toilet_1", "F1/kitchen/toilet_pan_1"]
