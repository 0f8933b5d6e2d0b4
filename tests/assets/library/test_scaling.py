"""How large a model is taken to be."""

import numpy as np
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.library.annotations import Annotation
from mansion_assets.library.scaling import sizing

CHAIRS = load_catalogue([]).by_category("office_chair")


@pytest.mark.parametrize(
    ("extent", "scale", "unit"),
    [((0.6, 0.6, 1.0), 1.0, "metres"), ((60, 60, 100), 0.01, "centi"), ((24, 24, 40), 0.0254, "inches")],
)
def test_the_first_unit_that_makes_a_chair_a_chair_is_taken(
    extent: tuple[float, float, float], scale: float, unit: str
) -> None:
    found = sizing(np.array(extent), None, CHAIRS)
    assert found.scale == scale
    assert unit in found.how
    assert not found.stated


def test_a_size_that_no_unit_explains_becomes_the_usual_one() -> None:
    found = sizing(np.array([1e-3, 1e-3, 2e-3]), None, CHAIRS)
    usual = float(np.median([max(asset.size) for asset in CHAIRS]))
    assert found.scale * 2e-3 == pytest.approx(usual)
    assert "usual for its category" in found.how


def test_a_stated_height_holds_where_it_is_possible() -> None:
    found = sizing(np.array([1.0, 1.0, 2.0]), Annotation(height=1.1, source="x.json"), CHAIRS)
    assert (found.scale, found.stated) == (0.55, True)
    absurd = sizing(np.array([1.0, 1.0, 2.0]), Annotation(height=60.0, source="x.json"), CHAIRS)
    assert not absurd.stated
    assert "60 m is implausible" in absurd.how
