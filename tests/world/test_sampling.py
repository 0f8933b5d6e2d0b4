"""Requests of a world follow from index, seed and mixture, and keep to the asked shares and bounds."""

from collections import Counter
from pathlib import Path

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_world.mixture import MOST_FLOOR_AREA, load_clutter_sentences, load_mixture, load_sentences
from mansion_world.sampling import sample
from mansion_world.sentence_templates import fill_wording

MIX = load_mixture()
REQUESTS = [sample(index, 7, MIX) for index in range(1000)]


def test_the_same_index_and_seed_give_the_same_request() -> None:
    assert [sample(index, 7, MIX) for index in reversed(range(20))] == REQUESTS[:20][::-1]
    assert sample(3, 8, MIX).request != REQUESTS[3].request


def test_each_request_has_a_seed_of_its_own() -> None:
    attempts = [sample(4, 7, MIX, attempt=attempt) for attempt in range(5)]
    seeds = [request.request.seed for request in (*REQUESTS, *attempts[1:])]
    assert len(set(seeds)) == len(seeds)
    assert {request.sub_kind for request in attempts} == {REQUESTS[4].sub_kind}


@pytest.mark.parametrize("count", [100, 1000])
def test_the_first_requests_have_the_shares_of_the_mixture(count: int) -> None:
    found = Counter(request.kind for request in REQUESTS[:count])
    asked = {"residential": 0.5, "office": 0.3, "public": 0.2}
    assert {kind: abs(found[kind] / count - share) <= max(0.01, 2 / count) for kind, share in asked.items()} == (
        dict.fromkeys(asked, True)
    )
    parts = Counter((request.kind, request.sub_kind) for request in REQUESTS)
    assert all(abs(parts[name] / 1000 - share) <= 0.01 for name, share in MIX.shares().items())


def test_floors_and_areas_keep_to_the_bounds() -> None:
    for request in REQUESTS:
        part = MIX.kinds[request.kind].kinds[request.sub_kind]
        assert request.request.floors is not None and request.request.floor_area is not None
        assert part.floors[0] <= request.request.floors <= min(10, part.floors[1])
        assert part.floor_area[0] <= request.request.floor_area <= min(MOST_FLOOR_AREA, part.floor_area[1])


def test_tall_buildings_are_a_long_tail() -> None:
    floors = Counter(request.request.floors for request in REQUESTS)
    assert floors[1] > floors[3] > floors[7] > 0
    assert max(floor for floor in floors if floor) >= 9


def test_there_are_two_hundred_wordings_and_each_stands_once() -> None:
    wordings = [wording for group in load_sentences().values() for wording in group]
    assert len(wordings) == len(set(wordings)) >= 200
    assert set(load_sentences()) == {name for _, name in MIX.shares()}


def test_sentences_say_what_was_drawn() -> None:
    for request in REQUESTS:
        sentence = request.request.description
        assert "{" not in sentence and "  " not in sentence
        assert request.outline in sentence and request.style in sentence
    assert len({request.request.description for request in REQUESTS}) > 500


@pytest.mark.parametrize(
    ("word", "sentence"),
    [("eight-storey", "An eight-storey"), ("L-shaped", "An L-shaped"), ("two-storey", "A two-storey"), ("8", "An 8")],
)
def test_articles_follow_the_sound(word: str, sentence: str) -> None:
    assert fill_wording("{A:x}", {"x": word}) == sentence


@pytest.mark.parametrize(
    ("name", "floors", "refusal"),
    [
        ("studio", [1, 11], r"mix.toml.*10"),
        ("studio", [3, 1], "the first may not be greater"),
        ("castle", [1, 1], "no sentences for 'castle'"),
    ],
)
def test_a_mixture_that_does_not_fit_is_refused(name: str, floors: list[int], refusal: str, tmp_path: Path) -> None:
    file = tmp_path / "mix.toml"
    part = f"[kinds.a.kinds.{name}]\nshare = 1\nfloors = {floors}\nfloor_area = [60, 70]\n"
    file.write_text(f"[kinds.a]\nshare = 1\n{part}")
    with pytest.raises(MansionError, match=refusal):
        load_mixture(file)


def test_some_buildings_have_many_and_some_few_small_objects_and_say_so() -> None:
    found = Counter(request.clutter for request in REQUESTS)
    assert 60 <= found["sparse"] <= 140
    assert 60 <= found["dense"] <= 140
    for request in REQUESTS:
        sentences = load_clutter_sentences().get(request.clutter, [])
        assert any(request.request.description.endswith(text) for text in sentences) == bool(request.clutter)
        assert (request.request.clutter == request.clutter) == bool(request.clutter)
