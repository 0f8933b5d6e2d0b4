"""What a brief names only to refuse it, in the same words or in a later clause, is not wanted."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("words", "types"),
    [
        ("Expressly excluded: bar, gym.", ["bar", "gym"]),
        ("Exclusions: parking, gym", ["parking", "gym"]),
        ("Omitted: sauna.", ["sauna"]),
        ("A restaurant is not part of the programme.", ["restaurant"]),
        ("The bar does not belong to the brief.", ["bar"]),
        ("A garage is out of scope, and a sauna is not in the plan.", ["garage", "sauna"]),
        ("Gym waived by the client.", ["gym"]),
        ("The sauna has been dropped.", ["sauna"]),
        ("Bar isn't coming, people drink outside.", ["bar"]),
        ("A sauna we don't make.", ["sauna"]),
    ],
)
def test_what_is_excluded_waived_or_outside_the_programme_is_not_wanted(words: str, types: list[str]) -> None:
    facts = read(f"A hotel with a lobby. {words}")
    assert [name for name, _ in facts.excluded] == types
    assert [room.room_type for room in facts.rooms] == ["lobby"]


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("A terrace, one has discussed it a lot, but finally no.", "terrace"),
        ("My uncle suggested a bar, but in the end no.", "bar"),
        ("The pool exists already outside, so inside don't put any.", "indoor_pool"),
        ("As for a gym, we walk in the hills, so there will not be one.", "gym"),
        ("A sauna was discussed; you can skip it.", "sauna"),
        ("Our dean wished a library as well, this you may leave out.", "library"),
        ("My aunt keeps asking for a sauna; we will not.", "sauna"),
    ],
)
def test_what_a_later_clause_refuses_is_not_wanted(words: str, kind: str) -> None:
    facts = read(f"A hotel with a lobby. {words}")
    assert [name for name, _ in facts.excluded] == [kind]
    assert [room.room_type for room in facts.rooms] == ["lobby"]


@pytest.mark.parametrize(
    "words",
    [
        "My brother keeps telling us to put in a lift; we shan't.",
        "The council urged us to add a lift, but we won't.",
        "Lift waived by client.",
        "A lift is not part of the project.",
    ],
)
def test_a_lift_is_refused_like_a_room(words: str) -> None:
    facts = read(f"A house with three bedrooms on two floors. {words}")
    assert [kind for kind, _ in facts.vertical] == ["no_elevator"]


@pytest.mark.parametrize(
    ("words", "category"),
    [
        ("Expressly excluded: bar, television sets.", "television"),
        ("Our dean wished a fountain as well, this you may leave out.", "fountain"),
    ],
)
def test_furniture_is_refused_like_a_room(words: str, category: str) -> None:
    facts = read(f"A school with a lobby. {words}")
    assert [(thing.category, thing.room, thing.excluded) for thing in facts.objects] == [(category, "", True)]
    assert facts.unread == []


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("The bar is not to be placed next to the lobby.", "bar"),
        ("Finally a terrace.", "terrace"),
        ("Not only a restaurant.", "restaurant"),
        ("The bar we won't put next to the lobby.", "bar"),
        ("The gym is excluded from the tour.", "gym"),
        ("My aunt keeps asking for a sauna; we will not share it.", "sauna"),
        ("A library where you may leave out the door.", "library"),
        ("The gym is not part of the lobby.", "gym"),
    ],
)
def test_what_is_denied_of_a_room_does_not_refuse_it(words: str, kind: str) -> None:
    facts = read(f"A hotel with a lobby. {words}")
    assert facts.excluded == []
    assert kind in [room.room_type for room in facts.rooms]


def test_what_may_be_meant_of_several_rooms_refuses_none() -> None:
    facts = read("A hotel with a lobby. There is a bar and a gym. You may leave it out.")
    assert facts.excluded == []


@pytest.mark.parametrize(
    "words", ["We send the people to the hospital.", "We refer patients to the hospital.", "We drive them to a school"]
)
def test_where_people_are_sent_is_no_room(words: str) -> None:
    facts = read(f"A clinic with a pharmacy. {words}")
    assert [room.room_type for room in facts.rooms] == ["pharmacy"]
