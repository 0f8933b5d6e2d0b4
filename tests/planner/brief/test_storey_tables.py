"""Tables with a row for each storey."""

import pytest

from mansion_language import tokenize
from mansion_planner.brief.storey_tables import storey_tables

FLOOR_WORDS = frozenset({"storey", "floor", "level"})


def rewritten(table: str) -> list[str]:
    """Return the lines of a table as they are read."""
    words = [token.text for token in storey_tables(tokenize(table), FLOOR_WORDS)]
    return [line.strip() for line in " ".join(words).split("\n")]


@pytest.mark.parametrize("rule", ["", "|---|---|\n"])
def test_a_row_is_headed_by_its_storey(rule: str) -> None:
    table = (
        f"An office.\n| storey | what |\n{rule}| 1 (street) | lobby, cafe |\n| 2 | open office | 3 desks |\nOne lift."
    )
    lines = [line for line in rewritten(table) if line]
    assert lines == ["an office .", "1 : lobby , cafe", "2 : open office , 3 desk", "one lift ."]


def test_a_storey_may_have_a_name() -> None:
    assert "ground floor : lobby" in rewritten("| floor | rooms |\n| ground floor | lobby |")


def test_other_tables_stay_as_they_are() -> None:
    table = "| room | m2 |\n| kitchen | 12 |"
    assert [token.text for token in storey_tables(tokenize(table), FLOOR_WORDS)] == [t.text for t in tokenize(table)]
