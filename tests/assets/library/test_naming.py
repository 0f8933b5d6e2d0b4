"""Which category the name of a file means."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.library.naming import category_of, slug


@pytest.mark.parametrize(
    ("name", "category", "known"),
    [
        ("SM_OfficeChair_02", "office_chair", True),
        ("vintage armchair", "armchair", True),
        ("espresso_bar", "espresso_bar", False),
        ("gene sequencer 3000", "gene_sequencer", False),
    ],
)
def test_a_name_means_a_category_of_the_catalogue_or_a_new_one(name: str, category: str, known: bool) -> None:
    found = category_of(name, load_catalogue([]))
    assert (found.category, found.known) == (category, known)


def test_a_slug_begins_with_a_letter() -> None:
    assert slug("3 legs") == "thing_3_legs"
