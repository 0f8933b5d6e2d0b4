"""The vocabulary that tasks and the readers of instructions share."""

from mansion_msgs_py.scene import SceneRoom
from mansion_tasks.language.matching import match_score, names_room
from mansion_tasks.language.vocabulary import OBJECTS, ROOMS


def test_a_word_stands_in_one_group_only() -> None:
    words = [word for group in (*OBJECTS, *ROOMS) for word in group.same + group.goal + group.loose]
    assert sorted(words) == sorted(set(words))


def test_words_that_mean_the_same_match_each_other() -> None:
    for group in (*OBJECTS, *ROOMS):
        name = group.same[0].replace(" ", "_")
        assert [match_score(word, name) for word in group.same] == [3] * len(group.same)
        assert all(match_score(word, name) > 0 for word in group.loose), name


def test_a_room_goes_by_its_type_its_name_and_its_other_names() -> None:
    ring = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0)]
    room = SceneRoom(
        id="F1/kitchen", room_type="kitchen", kind="Entities", polygon=ring, net_polygon=ring, area=4.5,
        name="The Trough", aliases=["Canteen"],
    )  # fmt: skip
    assert all(names_room(word, room) for word in ("kitchen", "the trough", "canteen"))
    assert not names_room("lobby", room)
