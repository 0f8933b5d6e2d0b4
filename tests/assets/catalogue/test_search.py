"""Text search over the catalogue."""

from pathlib import Path

import msgspec
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.descriptions import Hypernym, description_of, hypernyms
from mansion_assets.catalogue.query_words import plain_words
from mansion_assets.catalogue.search import search_assets
from mansion_msgs_py.errors import MansionError


def queries(name: str) -> list[tuple[str, list[str]]]:
    """Return texts with the categories that answer them."""
    return msgspec.json.decode(Path(__file__).with_name(name).read_bytes(), type=list[tuple[str, list[str]]])


QUERIES = queries("search_queries.json")
BENCHMARKS = Path(__file__).parents[3] / "benchmarks" / "editing"
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


def test_a_category_is_found_by_what_it_is_used_for() -> None:
    catalogue = load_catalogue()
    uses = {name: description_of(name).use for name in catalogue.categories}
    missed = [
        name for name, use in uses.items() if name not in {h.asset.category for h in search_assets(catalogue, use, 5)}
    ]
    assert len(missed) <= 0.1 * len(uses), missed


@pytest.mark.parametrize(
    ("query", "category"),
    [
        ("indoor cycling", "exercise_bike"),
        ("boxing practice target", "punching_bag"),
        ("L-shaped lounge seating", "sofa"),
        ("table for examining patients", "exam_table"),
        ("a chair without wheels", "chair"),
        ("somewhere to throw rubbish away", "garbage_can"),
        ("bookshelfs", "bookshelf"),
        ("micowave", "microwave"),
    ],
)
def test_descriptions_find_what_they_mean_among_the_first_three(query: str, category: str) -> None:
    assert category in {hit.asset.category for hit in search_assets(load_catalogue(), query, 3)}


@pytest.mark.parametrize(
    "query",
    ["something to sit on", "exercise equipment", "kitchen appliances", "toys", "musical instrument", "storage"],
)
def test_a_wide_query_gives_different_categories_of_its_kind_first(query: str) -> None:
    members = set(notion_of(query).categories)
    found = [hit.asset.category for hit in search_assets(load_catalogue(), query, 3)]
    assert len(set(found)) == 3
    assert set(found) <= members


def notion_of(query: str) -> Hypernym:
    """Return the general notion that a query names."""
    wanted = plain_words(query)
    return next(notion for notion in hypernyms() if wanted in [plain_words(name) for name in notion.names])


def test_names_of_general_notions_give_three_different_members_first() -> None:
    """At least 19 in 20 of all names of notions with three members or more."""
    names = [
        (name, set(notion.categories)) for notion in hypernyms() if len(notion.categories) > 2 for name in notion.names
    ]
    missed = [name for name, members in names if len(set(first_three(name)) & members) < 3]
    assert len(missed) <= 0.05 * len(names), missed


def first_three(query: str) -> list[str]:
    """Return the categories of the first three hits."""
    return [hit.asset.category for hit in search_assets(load_catalogue(), query, 3)]


@pytest.mark.parametrize(
    ("query", "category"),
    [("something to drink", "cola_can"), ("something to drink from", "glass"), ("something to eat", "apple")],
)
def test_small_words_tell_general_notions_apart(query: str, category: str) -> None:
    assert first_three(query)[0] == category


@pytest.mark.parametrize(
    ("query", "category"),
    [
        ("La-Z-Boy", "recliner"),
        ("Pepsi", "cola_can"),
        ("the Times", "newspaper"),
        ("liquidizer", "blender"),
        ("clothes horse", "drying_rack"),
        ("settle down the brolly", "umbrella"),
        ("thing to hang coats on", "coat_rack"),
    ],
)
def test_brands_slang_and_circumlocutions_are_found(query: str, category: str) -> None:
    assert category in first_three(query)


@pytest.mark.parametrize(("name", "share"), [("synonyms", 0.98), ("uses", 0.97), ("descriptions", 0.97)])
def test_every_category_is_found_by_a_synonym_a_use_and_a_description(name: str, share: float) -> None:
    rows = msgspec.json.decode((BENCHMARKS / f"queries_{name}.json").read_bytes(), type=list[tuple[str, list[str]]])
    assert {accepted[0] for _, accepted in rows} == set(load_catalogue().categories)
    missed = [query for query, accepted in rows if not set(first_three(query)) & set(accepted)]
    assert len(missed) <= (1 - share) * len(rows), missed


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
