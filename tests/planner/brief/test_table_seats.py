"""How many people a table is for tells how many seats stand at it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "seats"),
    [
        ("A farmhouse with a kitchen with a table for eight, and a snug.", 8),
        ("A restaurant with a dining room with ten tables for four.", 40),
        ("A canteen with 20 tables for 4 persons each.", 80),
    ],
)
def test_seats_at_tables_are_wished_for(text: str, seats: int) -> None:
    facts = read_brief(text, default_knowledge())
    assert [fact.count for fact in facts.objects if fact.category == "chair"] == [seats]
    assert facts.unread == []


def test_a_table_for_things_has_no_seats() -> None:
    facts = read_brief("A workshop with a table for 8 printers.", default_knowledge())
    assert [fact.category for fact in facts.objects if fact.category == "chair"] == []
