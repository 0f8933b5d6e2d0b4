"""What is done on a storey tells where the rooms for it are."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def _rooms(text: str) -> list[tuple[str, int | None, list[str]]]:
    facts = read_brief(text, default_knowledge())
    assert facts.unread == []
    return [(room.room_type, room.count, [ref.kind for ref in room.floors]) for room in facts.rooms]


def test_rooms_named_later_lie_where_what_is_done_there_was_placed() -> None:
    assert _rooms("Living downstairs, sleeping upstairs: a duplex with three bedrooms.") == [
        ("living_room", 1, ["number"]),
        ("bedroom", 3, ["upper"]),
    ]


def test_what_is_done_asks_for_its_room() -> None:
    assert _rooms("A house with cooking downstairs and sleeping upstairs.") == [
        ("kitchen", 1, ["number"]),
        ("bedroom", None, ["upper"]),
    ]


def test_below_and_above_in_one_sentence_are_storeys() -> None:
    assert _rooms("A duplex with the living room and kitchen below and two bedrooms above.") == [
        ("living_room", 1, ["number"]),
        ("kitchen", 1, ["number"]),
        ("bedroom", 2, ["upper"]),
    ]
