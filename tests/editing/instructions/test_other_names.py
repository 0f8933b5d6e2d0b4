"""Rooms and things by other names of their kind, which take nothing from the names of others."""

import msgspec
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of, things_of
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Amount, Ensure, Rooms, SetState, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_scene.decor.frames import scene_object


def _with_rooms(furnished: list[FloorScene], catalogue: Catalogue, **kinds: str) -> SceneState:
    """Return the building with other kinds of rooms, by the ends of their ids."""

    def kind_of(room: SceneRoom) -> SceneRoom:
        kind = kinds.get(room.id.rpartition("/")[2], room.room_type)
        return msgspec.structs.replace(room, room_type=kind, name=kind.replace("_", " ").capitalize())

    scenes = [msgspec.structs.replace(s, rooms=[kind_of(room) for room in s.rooms]) for s in furnished]
    return SceneState(scenes, catalogue)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("operating_room", "the operating theatre"),
        ("operating_room", "the surgical suite"),
        ("toilet", "the loo"),
        ("toilet", "the lavatory"),
    ],
)
def test_a_room_is_found_by_another_name_of_its_kind(
    furnished: list[FloorScene], catalogue: Catalogue, kind: str, said: str
) -> None:
    state = _with_rooms(furnished, catalogue, hall=kind)
    (off,) = read_instruction(f"Switch the lights in {said} off.", state).statements
    assert isinstance(off, SetState) and off.things.place is not None and off.things.place.rooms is not None
    assert rooms_of(state, off.things.place.rooms, Context()) == ["F1/hall"]


def test_another_name_of_a_kind_is_not_shortened(furnished: list[FloorScene], catalogue: Catalogue) -> None:
    state = _with_rooms(furnished, catalogue, hall="bedroom")
    (said,) = read_instruction("Every bed should have a pillow on it.", state).statements
    assert isinstance(said, Add | Ensure) and said.place.anchor is not None and said.place.anchor.noun == "bed"


def _found(noun: str, furnished: list[FloorScene], catalogue: Catalogue, *kinds: str) -> list[str]:
    first, second = furnished
    stood = [
        scene_object(
            catalogue.by_category(kind)[0], f"F1/hall/{kind}_1", "F1/hall", (2.0, 2.0, 0.9), 0.0, mount="floor"
        )
        for kind in kinds
    ]
    state = SceneState([msgspec.structs.replace(first, objects=[*first.objects, *stood]), second], catalogue)
    things = Things(noun=noun, amount=Amount(kind="all", number=0), definite=True, plural=True)
    return [item.category for item in things_of(state, things, Context())]


def test_a_telly_is_a_tv_on_the_wall_where_no_other_is(furnished: list[FloorScene], catalogue: Catalogue) -> None:
    assert _found("telly", furnished, catalogue, "wall_tv") == ["wall_tv"]
    assert _found("telly", furnished, catalogue, "wall_tv", "television") == ["television"]


@pytest.mark.parametrize(
    ("noun", "kinds"),
    [("cupboard", ["wall_cabinet"]), ("toilet", ["toilet_pan"]), ("couch", ["loveseat"]), ("basin", ["washbasin"])],
)
def test_kinds_answer_to_what_people_call_them(
    furnished: list[FloorScene], catalogue: Catalogue, noun: str, kinds: list[str]
) -> None:
    assert [kind for kind in _found(noun, furnished, catalogue, *kinds) if kind in kinds] == kinds


def test_a_cabin_is_no_bin(furnished: list[FloorScene], catalogue: Catalogue) -> None:
    assert "shower_cabin" not in _found("bin", furnished, catalogue, "shower_cabin", "waste_bin")


def test_what_a_cup_holds_is_no_cup(furnished: list[FloorScene], catalogue: Catalogue) -> None:
    assert "yogurt" not in _found("cup", furnished, catalogue, "yogurt")


def test_rooms_are_named_by_themselves_first(furnished: list[FloorScene], catalogue: Catalogue) -> None:
    state = _with_rooms(furnished, catalogue, hall="toilet", kitchen="bathroom")
    assert rooms_of(state, Rooms(words="toilet"), Context()) == ["F1/hall"]
