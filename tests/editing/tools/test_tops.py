"""Things on the flat tops of furniture that has no surface there, and in it."""

from collections.abc import Callable

import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.tools.tops import carries_on_top, places_on


@pytest.mark.parametrize("category", ["fridge", "washing_machine", "wardrobe", "bookshelf"])
def test_a_body_with_a_level_top_carries_things(catalogue: Catalogue, category: str) -> None:
    asset = catalogue.by_category(category)[0]
    (top,) = [ledge for ledge in places_on(asset, inside=False) if ledge.kind == "top"]
    assert top.z == pytest.approx(asset.size[2] / 2)
    assert top.d <= asset.size[1] + 0.01
    assert carries_on_top(asset)


@pytest.mark.parametrize("category", ["floor_lamp", "mug", "house_plant", "wall_tv"])
def test_what_is_not_level_or_no_furniture_carries_nothing(catalogue: Catalogue, category: str) -> None:
    assert not carries_on_top(catalogue.by_category(category)[0])


def test_inside_is_not_on_top(catalogue: Catalogue) -> None:
    fridge = catalogue.by_category("fridge")[0]
    assert all(ledge.inside for ledge in places_on(fridge, inside=True) if ledge.kind != "shelf")


def test_a_mug_stands_on_the_fridge_or_in_it(open_editor: Callable[..., SceneEditor], catalogue: Catalogue) -> None:
    editor = open_editor()
    mug = catalogue.by_category("mug")[0].key
    fridge = editor.state.get("F1/kitchen/fridge_1")[1]
    (on_top,) = editor.call("PlaceOnSurface", {"asset_id": mug, "receptacle_id": fridge.id}).object_ids
    (within,) = editor.call("PlaceInContainer", {"asset_id": mug, "container_id": fridge.id}).object_ids
    top = fridge.position[2] + fridge.size[2] / 2
    assert editor.state.get(on_top)[1].position[2] > top
    assert editor.state.get(within)[1].position[2] < top
