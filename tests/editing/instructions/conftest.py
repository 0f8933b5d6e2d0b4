"""The small building with more in it: chairs in the hall, lights, a second table and mugs on both."""

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.state import SceneState
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_scene.decor.frames import scene_object


@pytest.fixture
def furnished(scenes: list[FloorScene], catalogue: Catalogue) -> list[FloorScene]:
    """Return the two floors, furnished more fully."""
    first, second = scenes

    def stand(name: str, category: str, x: float, y: float, z: float = 0.0, parent: str | None = None) -> SceneObject:
        asset = catalogue.by_category(category)[0]
        mount = "surface" if parent else asset.mount
        height = z + asset.size[2] / 2 if mount != "ceiling" else 2.8 - asset.size[2] / 2
        return scene_object(asset, name, name.rsplit("/", 1)[0], (x, y, height), 0.0, mount=mount, parent=parent)

    table = next(item for item in first.objects if item.category == "dining_table")
    lower = [
        *first.objects,
        *(stand(f"F1/hall/chair_{n}", "chair", 0.8 + 0.9 * n, 3.0) for n in (1, 2, 3)),
        *(stand(f"F1/kitchen/ceiling_light_{n}", "ceiling_light", 7.0 + 2 * n, 3.0) for n in (1, 2)),
        stand("F1/kitchen/plate_1", "plate", 9.4, 3.0, table.size[2], table.id),
    ]
    other = stand("F2/private_office_1/dining_table_1", "dining_table", 8.0, 3.5)
    upper = [
        *second.objects,
        other,
        stand("F2/private_office_1/mug_1", "mug", 8.0, 3.5, other.size[2], other.id),
        stand("F2/private_office_1/mug_2", "mug", 8.3, 3.5, other.size[2], other.id),
    ]
    floors = (first, lower), (second, upper)
    return [msgspec.structs.replace(scene, objects=objects) for scene, objects in floors]


@pytest.fixture
def furnished_state(furnished: list[FloorScene], catalogue: Catalogue) -> SceneState:
    """Return the furnished building in memory."""
    return SceneState(furnished, catalogue)


@pytest.fixture
def editor(furnished: list[FloorScene], folder: Path, open_editor: Callable[..., SceneEditor]) -> SceneEditor:
    """Return an editor of the furnished building that lands each instruction."""
    for scene in furnished:
        (folder / f"floors/floor_{scene.floor}/scene.json").write_bytes(encode_bytes(scene, indent=1))
    return open_editor()
