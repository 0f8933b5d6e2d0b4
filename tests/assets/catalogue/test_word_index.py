"""The index compares words as they stand, in other forms, misspelt, joined and apart."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.word_index import word_index


def best(query: str) -> str:
    """Return the category with the highest score."""
    index = word_index(load_catalogue())
    scores = index.scores(query)
    return index.categories[scores.index(max(scores))]


@pytest.mark.parametrize(
    ("query", "category"),
    [
        ("whiteboard", "whiteboard"),
        ("refrigeratr", "fridge"),
        ("wine glasses", "wine_glass"),
        ("key board", "keyboard"),
        ("officechair", "office_chair"),
        ("settee", "sofa"),
    ],
)
def test_a_name_is_found_in_every_spelling(query: str, category: str) -> None:
    assert best(query) == category


def test_no_word_fits_nothing() -> None:
    assert not any(word_index(load_catalogue()).scores(""))
    assert not any(word_index(load_catalogue()).scores("zzqx"))


def test_a_word_of_the_name_says_more_than_one_of_the_use() -> None:
    index = word_index(load_catalogue())
    scores = dict(zip(index.categories, index.scores("kettle"), strict=True))
    assert scores["kettle"] > 3 * scores["teapot"]


def test_typical_members_of_a_general_notion_come_first() -> None:
    index = word_index(load_catalogue())
    scores = dict(zip(index.categories, index.scores("cutlery"), strict=True))
    assert scores["fork"] > scores["butter_knife"] > scores["plate"]
