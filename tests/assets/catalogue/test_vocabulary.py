"""Names of categories, among them those with another word for their last one."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of


@pytest.mark.parametrize(
    ("name", "category"),
    [
        ("houseplant", "house_plant"),
        ("wall cupboard", "wall_cabinet"),
        ("medicine cupboard", "medicine_cabinet"),
        ("instrument cart", "instrument_trolley"),
        ("cot", "crib"),
        ("photograph", "picture_frame"),
    ],
)
def test_everyday_names_are_those_of_the_catalogue(name: str, category: str) -> None:
    assert vocabulary_of(load_catalogue()).exact(stems(name)) == [category]


@pytest.mark.parametrize("name", ["cupboard wall", "dragon cupboard", "reading light"])
def test_other_compounds_name_nothing(name: str) -> None:
    assert vocabulary_of(load_catalogue()).exact(stems(name)) == []
