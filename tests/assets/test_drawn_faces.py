"""Marks on faces of assets: they read from where people stand, stay in their rectangle, and move with their doors."""

import numpy as np
import pytest

from mansion_assets.builder import Builder
from mansion_assets.catalogue import load_catalogue
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.meshes import links

CATALOGUE = load_catalogue()


def _builder() -> Builder:
    return Builder(CATALOGUE.by_category("wardrobe")[0])


def _points(b: Builder) -> np.ndarray:
    return np.concatenate([chunk.vertices for piece in b.pieces.values() for chunk in piece.chunks])


def test_letters_on_the_front_are_read_from_the_front() -> None:
    b = _builder()
    DrawnFace.front(b, 0.2).write("L", (-0.3, 0.3), (1.0, 1.5), "plastic_black")
    points = _points(b)
    high, low = points[points[:, 2] > 1.45], points[points[:, 2] < 1.05]
    # Who looks at the front from +y has +x at the left, where the stem of an L is.
    assert high[:, 0].min() > low[:, 0].min() and high[:, 0].max() == pytest.approx(low[:, 0].max())
    assert points[:, 1].max() == pytest.approx(0.202) and points[:, 1].min() < 0.2


def test_letters_on_a_top_are_read_from_the_front() -> None:
    b = _builder()
    DrawnFace.top(b, 0.5).write("L", (-0.3, 0.3), (-0.2, 0.2), "plastic_black")
    points = _points(b)
    # The upper end of a letter is away from who stands in front.
    high, low = points[points[:, 1] < -0.15], points[points[:, 1] > 0.15]
    assert high[:, 0].min() > low[:, 0].min()
    assert points[:, 2].max() == pytest.approx(0.502)


@pytest.mark.parametrize("word", ["TICKETS", "ATM", "45:00", "FIRE HOSE"])
def test_a_word_is_in_the_middle_of_its_rectangle_and_touches_two_of_its_sides(word: str) -> None:
    b = _builder()
    DrawnFace.front(b, 0.0).write(word, (-0.4, 0.2), (0.1, 0.3), "plastic_black")
    points = _points(b)
    low, high = points.min(axis=0), points.max(axis=0)
    assert low[0] >= -0.2 - 1e-9 and high[0] <= 0.4 + 1e-9 and low[2] >= 0.1 - 1e-9 and high[2] <= 0.3 + 1e-9
    assert (low[0] + high[0]) / 2 == pytest.approx(0.1) and (low[2] + high[2]) / 2 == pytest.approx(0.2)
    assert high[0] - low[0] == pytest.approx(0.6) or high[2] - low[2] == pytest.approx(0.2)


def test_a_sloped_face_bears_marks_above_its_slope() -> None:
    b = _builder()
    face = DrawnFace.sloped(b, (0.5, 0.0), (0.0, 0.5))
    y, z = face.at(0.0, 0.1, 0.01)[1:]
    assert y + z == pytest.approx(0.5 + 0.01 * np.sqrt(2))


@pytest.mark.parametrize(
    ("category", "part"),
    [
        ("chemical_cabinet", "sign"),
        ("book_return", "letters"),
        ("crash_cart", "labels"),
        ("freezer", "snowflake"),
        ("service_station", "cutlery"),
    ],
)
def test_a_sign_moves_with_the_door_or_drawer_that_it_is_on(category: str, part: str) -> None:
    owners = {
        link.name for link in links(CATALOGUE.by_category(category)[0]) if any(p.name == part for p in link.parts)
    }
    assert owners and "" not in owners
