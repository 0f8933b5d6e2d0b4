"""Each sentence of the page on security has tests that exist."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "security.md").read_text()
HEADER = "| what | tests |"
NAMED = re.compile(r"`(tests/[\w/]+\.py)`: ((?:`test_\w+`(?:, )?)+)")


def rows() -> list[tuple[str, str]]:
    """The sentences and what stands beside them."""
    found = [line.strip("|").split(" | ") for line in PAGE.splitlines() if line.startswith("| ")]
    return [(row[0].strip(), row[1]) for row in found if row[0].strip() not in ("what", "---")]


@pytest.mark.parametrize(("sentence", "tests"), rows(), ids=[sentence[:40] for sentence, _ in rows()])
def test_a_sentence_has_tests_that_exist(sentence: str, tests: str) -> None:
    assert sentence.endswith(".")
    named = [(file, name) for file, names in NAMED.findall(tests) for name in re.findall(r"test_\w+", names)]
    assert len(named) == tests.count("`test_") > 0
    missing = [f"{file}: {name}" for file, name in named if f"def {name}(" not in (ROOT / file).read_text()]
    assert missing == []


def test_every_part_of_the_page_is_a_table_of_such_sentences() -> None:
    parts = PAGE.split("\n## ")[1:]
    assert len(parts) == PAGE.count(HEADER) == 8
    assert all(part.count(HEADER) == 1 for part in parts)
