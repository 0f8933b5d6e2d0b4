"""One of several bathrooms that is the master bedroom's."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        ", one of them en suite to the master",
        ", one en suite to the master bedroom",
        " (one attached to the master bedroom)",
        " - one of them off the main bedroom",
        ", one of which is private to the parents",
    ],
)
def test_the_master_bedroom_has_it(words: str) -> None:
    rooms = {fact.name: fact for fact in read(f"A house with three bedrooms. Two bathrooms{words}. A kitchen.").rooms}
    assert rooms["bathroom"].count == 1
    assert [child.room_type for child in rooms["master_bedroom"].suite] == ["ensuite_bathroom"]
