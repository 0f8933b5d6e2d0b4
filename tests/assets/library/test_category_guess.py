"""Which category the name of a file means."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.library.category_guess import category_of, slug


@pytest.mark.parametrize(
    ("name", "category", "known"),
    [
        ("SM_OfficeChair_02", "office_chair", True),
        ("vintage armchair", "armchair", True),
        ("espresso_bar", "espresso_bar", False),
        ("coffee_table_round", "coffee_table", True),
        ("coffee table book", "book", True),
        ("gene sequencer 3000", "gene_sequencer", False),
    ],
)
def test_a_name_means_a_category_of_the_catalogue_or_a_new_one(name: str, category: str, known: bool) -> None:
    found = category_of(name, load_catalogue([]))
    assert (found.category, found.known) == (category, known)


@pytest.mark.parametrize(
    ("name", "extent", "category"),
    [
        ("sofa_3seat", (2.0, 0.9, 0.82), "sofa"),
        ("coffee_table_checker", (1.2, 0.6, 0.45), "coffee_table"),
        ("office chair cushion", (0.45, 0.45, 0.1), "pillow"),
        ("vintage armchair", (900.0, 800.0, 1000.0), "armchair"),
    ],
)
def test_the_size_decides_between_things_that_a_name_names(
    name: str, extent: tuple[float, float, float], category: str
) -> None:
    assert category_of(name, load_catalogue([]), extent).category == category


def test_it_says_how_many_words_led_to_a_known_category() -> None:
    catalogue = load_catalogue([])
    assert category_of("SM_OfficeChair_02", catalogue).words == 2
    assert category_of("vintage armchair", catalogue).words == 1
    assert category_of("espresso_bar", catalogue).words == 0


def test_a_slug_begins_with_a_letter() -> None:
    assert slug("3 legs") == "thing_3_legs"
