"""Every category has a description, and general notions have members."""

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.descriptions import (
    described_categories,
    description_of,
    hypernyms,
    hypernyms_of,
    words_alike,
)


def test_every_category_has_a_use_and_a_look_and_no_other_has() -> None:
    catalogue = load_catalogue()
    assert set(described_categories()) == set(catalogue.categories)
    assert [name for name, known in described_categories().items() if not known.use or not known.look] == []


def test_a_category_of_a_users_own_has_an_empty_description() -> None:
    assert description_of("drone_pedestal").use == ""


def test_general_notions_are_of_categories_each_once() -> None:
    known = set(load_catalogue().categories)
    for notion in hypernyms():
        assert set(notion.categories) <= known, notion.names
        assert len(set(notion.categories)) == len(notion.categories) > 1, notion.names


def test_a_category_knows_its_general_notions() -> None:
    assert "exercise equipment" in hypernyms_of("treadmill")
    assert "seating" not in hypernyms_of("treadmill")


def test_words_alike_name_each_other_and_not_themselves() -> None:
    alike = words_alike()
    assert "settee" in alike["sofa"] and "sofa" in alike["settee"]
    assert [word for word, others in alike.items() if word in others] == []
