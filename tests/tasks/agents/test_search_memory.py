"""What an explorer has seen tells it what is certain, and where to look next."""

from typing import Any

from mansion_msgs_py.skills import LandmarkInfo
from mansion_msgs_py.world import Pose2D
from mansion_tasks.agents.instructions import NounPhrase
from mansion_tasks.agents.interface import Observation, SeenObject
from mansion_tasks.agents.search_memory import SearchMemory, room_likelihood, usual_container

HERE = Pose2D(x=0.0, y=0.0)


def seen(ref: str, category: str, **more: Any) -> SeenObject:
    return SeenObject(
        ref=ref, category=category, distance=2.0, bearing=0.0, room=ref.rsplit("/", 1)[0], pickupable=True, **more
    )  # fmt: skip


def landmark(name: str, x: float) -> LandmarkInfo:
    return LandmarkInfo(name=name, kind="room", floor=1, pose=Pose2D(x=x, y=0.0))


def around(*visible: SeenObject, rooms: tuple[LandmarkInfo, ...] = ()) -> tuple[SearchMemory, Observation]:
    memory = SearchMemory()
    now = Observation("", 0, 50, 1, (1, 2), HERE, visible=visible, landmarks=rooms)
    memory.note(now)
    return memory, now


def best(memory: SearchMemory, phrase: NounPhrase) -> tuple[str, bool]:
    score, sighting = memory.candidates(phrase, pickupable=False)[0]
    return sighting.item.ref, memory.is_certain(phrase, score)


def test_colour_and_furniture_must_be_confirmed() -> None:
    desk = seen("F1/office/desk_1", "desk", color="white")
    red = seen("F1/office/mug_1", "mug", color="red", parent=desk.ref)
    blue = seen("F1/office/mug_2", "mug", color="blue")
    memory, _ = around(desk, blue, red)
    assert best(memory, NounPhrase("mug", "red", ("desk",), ("",))) == (red.ref, True)
    assert best(memory, NounPhrase("mug", "red", ("desk",), ("black",))) == (red.ref, False)
    assert best(memory, NounPhrase("mug", "green"))[1] is False


def test_a_bedroom_is_not_the_master_bedroom() -> None:
    memory, _ = around(seen("F1/bedroom_1/bed_1", "bed"))
    assert best(memory, NounPhrase("bed", places=("master bedroom",), place_colors=("",)))[1] is False
    assert best(memory, NounPhrase("bed", places=("bedroom",), place_colors=("",)))[1] is True


def test_a_tray_may_be_a_document_tray_but_is_not_certain_to_be() -> None:
    memory, _ = around(seen("F1/office/tray_1", "tray"))
    assert best(memory, NounPhrase("document tray")) == ("F1/office/tray_1", False)


def test_things_on_another_floor_than_the_one_named_do_not_count() -> None:
    memory, _ = around(seen("F1/office/mug_1", "mug"))
    assert memory.candidates(NounPhrase("mug", floor=2), pickupable=False) == []


def test_named_rooms_come_first_then_likely_ones_then_the_nearest() -> None:
    rooms = tuple(
        landmark(f"F1/{name}", x)
        for name, x in (("corridor", 1.0), ("office_1", 2.0), ("break_room", 9.0), ("meeting_room_2", 20.0))
    )
    memory, now = around(rooms=rooms)
    potato = memory.rooms_to_search(now, NounPhrase("potato"))
    assert potato == ["F1/break_room", "F1/office_1", "F1/meeting_room_2", "F1/corridor"]
    named = memory.rooms_to_search(now, NounPhrase("potato", places=("meeting room 2",)))
    assert named[:2] == ["F1/meeting_room_2", "F1/break_room"]
    memory.searched["F1/break_room"] = None
    memory.unreachable["F1/office_1"] = None
    assert memory.rooms_to_search(now, NounPhrase("potato")) == ["F1/meeting_room_2", "F1/corridor"]


def test_what_is_kept_where_is_common_knowledge() -> None:
    assert room_likelihood("stapler", "open office") > room_likelihood("stapler", "bedroom 2")
    assert room_likelihood("stapler", "corridor") == 0
    assert usual_container("milk carton") == "fridge"
