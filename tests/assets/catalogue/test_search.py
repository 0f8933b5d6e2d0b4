"""Text search over the catalogue."""

from pathlib import Path

import msgspec
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.search import search_assets, use_of, uses_by_category
from mansion_msgs_py.errors import MansionError


def queries(name: str) -> list[tuple[str, list[str]]]:
    """Return texts with the categories that answer them."""
    return msgspec.json.decode(Path(__file__).with_name(name).read_bytes(), type=list[tuple[str, list[str]]])


QUERIES = queries("search_queries.json")
WORDED = queries("search_queries_worded.json")


def test_at_least_95_percent_of_300_queries_have_an_accepted_category_in_the_first_three() -> None:
    catalogue = load_catalogue()
    missed = [
        query
        for query, accepted in QUERIES
        if not {hit.asset.category for hit in search_assets(catalogue, query, 3)} & set(accepted)
    ]
    assert len(QUERIES) >= 300
    assert len(missed) <= 0.05 * len(QUERIES), missed


def test_misspelt_worded_plural_and_british_queries_are_answered_too() -> None:
    """Errors of typing, materials, uses that name no thing ("to boil water"), variants and plurals."""
    catalogue = load_catalogue()
    missed = [
        query
        for query, accepted in WORDED
        if not {hit.asset.category for hit in search_assets(catalogue, query, 3)} & set(accepted)
    ]
    assert len(WORDED) >= 170
    assert len(missed) <= 0.05 * len(WORDED), missed


def test_uses_are_of_categories_and_find_them() -> None:
    catalogue = load_catalogue()
    used = [name for name in catalogue.categories if use_of(name)]
    assert len(used) == len(uses_by_category()) > 200
    found = [name for name in used if name in {h.asset.category for h in search_assets(catalogue, use_of(name), 5)}]
    assert len(found) >= 0.9 * len(used)


@pytest.mark.parametrize(
    ("query", "category"), [("key board", "keyboard"), ("boxes", "box"), ("book shelf", "bookshelf")]
)
def test_words_written_apart_and_plurals_are_one_word(query: str, category: str) -> None:
    assert search_assets(load_catalogue(), query, 1)[0].asset.category == category


def test_every_category_is_found_by_its_own_name() -> None:
    catalogue = load_catalogue()
    missed = [
        name
        for name in catalogue.categories
        if name not in {h.asset.category for h in search_assets(catalogue, name.replace("_", " "), 3)}
    ]
    assert missed == []


@pytest.mark.parametrize("field", ["pickupable", "receptacle", "openable", "toggleable"])
def test_a_property_filter_holds_for_every_hit(field: str) -> None:
    hits = search_assets(load_catalogue(), "kitchen", 20, [field])
    assert hits
    assert all(getattr(hit.asset, field) for hit in hits)


def test_names_of_ai2_thor_properties_are_understood() -> None:
    hits = search_assets(load_catalogue(), "apple", 3, ["CanPickup", "thor"])
    assert hits[0].asset.asset_id is not None
    assert hits[0].asset.category == "apple"


def test_an_unknown_property_is_refused_with_the_accepted_ones() -> None:
    with pytest.raises(MansionError, match="openable"):
        search_assets(load_catalogue(), "apple", 3, ["edible"])


def test_a_colour_in_the_query_chooses_the_variant() -> None:
    hit = search_assets(load_catalogue(), "blue office chair", 1)[0]
    assert hit.asset.category == "office_chair"
    assert hit.asset.material.endswith("blue")


def test_text_without_any_known_word_finds_nothing_or_little() -> None:
    assert len(search_assets(load_catalogue(), "zzqx", 5)) <= 5
    assert search_assets(load_catalogue(), "", 5) == []
