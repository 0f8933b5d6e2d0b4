"""What hangs finds a free stretch of wall or of ceiling."""

from typing import Any

import msgspec
import pytest

from mansion_bringup.edit_hooks import new_faults
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.state import SceneState
from mansion_editing.tools.manipulation import move_object
from mansion_editing.tools.placement import place_on_surface
from mansion_editing.tools.relations import relation_holds
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.editing.objects import MoveObjectArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import SceneObject, Window
from mansion_scene.decor.frames import wall_edges
from mansion_scene.decor.wall_objects import WallSpace

SOFA, TABLE, HALL, KITCHEN = "F1/hall/sofa_1", "F1/kitchen/dining_table_1", "F1/hall", "F1/kitchen"


def _hang(state: SceneState, category: str, room: str, **wish: Any) -> SceneObject:
    asset = state.catalogue.by_category(category)[0].key
    return place_on_surface(state, PlaceOnSurfaceArgs(asset_id=asset, receptacle_id=room, **wish), StaticEngine())


def _at_wall(state: SceneState, item: SceneObject) -> bool:
    found = state.room(item.room)
    assert found is not None
    edges = wall_edges(found[1].net_polygon)
    return any(
        abs(edge.coordinates(item.position[:2])[1] - item.size[1] / 2) < 0.01
        and abs((edge.rotation - item.rotation + 180.0) % 360.0 - 180.0) < 0.01
        for edge in edges
    )


@pytest.mark.parametrize("category", ["painting", "wall_clock", "wall_mirror", "wall_shelf", "wall_tv"])
def test_wall_things_hang_with_their_back_to_a_wall(state: SceneState, category: str) -> None:
    before = dict(state.scenes)
    placed = _hang(state, category, KITCHEN)
    assert placed.mount == "wall" and placed.room == KITCHEN and _at_wall(state, placed)
    assert new_faults(before, state.scenes) == []


def test_a_wall_fills_up_without_overlaps_and_clear_of_doors(state: SceneState) -> None:
    with pytest.raises(MansionError, match="in the way"):
        for _ in range(200):
            _hang(state, "large_painting", HALL)
    hung = [item for item in state.scenes[1].objects if item.category == "large_painting"]
    shapes = [footprint(item) for item in hung]
    assert len(hung) > 3
    assert not any(a.intersects(b) for n, a in enumerate(shapes) for b in shapes[:n])
    assert not any(abs(item.position[0] - 6.0) < 0.2 and 3.9 < item.position[1] < 5.0 for item in hung)


def test_nothing_hangs_over_a_window(state: SceneState) -> None:
    window = Window(id="F1/window_1", wall="w", room=KITCHEN, segment=((6.2, 6), (11.8, 6)), sill=0.9, height=1.2)
    state.scenes[1] = msgspec.structs.replace(state.scenes[1], windows=[window])
    placed = [_hang(state, "painting", KITCHEN) for _ in range(4)]
    assert all(item.position[1] < 5.7 for item in placed)


def test_a_painting_hangs_above_the_sofa(state: SceneState) -> None:
    _, sofa = state.get(SOFA)
    state.replace(1, sofa, msgspec.structs.replace(sofa, position=(4.0, 0.07 + sofa.size[1] / 2, sofa.position[2])))
    placed = _hang(state, "painting", HALL, near=SOFA, side="above")
    assert relation_holds(state, placed, "above", SOFA) and _at_wall(state, placed)
    assert placed.position[0] == pytest.approx(4.0, abs=0.1)


def test_nothing_hangs_above_what_is_amid_the_room(state: SceneState) -> None:
    with pytest.raises(MansionError, match="F1/kitchen/dining_table_1 is not at a wall"):
        _hang(state, "painting", KITCHEN, near=TABLE, side="above")


def test_a_lamp_hangs_above_the_table(state: SceneState) -> None:
    before = dict(state.scenes)
    placed = _hang(state, "pendant_lamp", KITCHEN, near=TABLE, side="above")
    assert placed.mount == "ceiling" and relation_holds(state, placed, "above", TABLE)
    assert placed.position[2] + placed.size[2] / 2 == pytest.approx(2.8, abs=1e-3)
    assert new_faults(before, state.scenes) == []


def test_a_second_lamp_hangs_beside_the_first(state: SceneState) -> None:
    first = _hang(state, "ceiling_light", KITCHEN)
    second = _hang(state, "ceiling_light", KITCHEN, near=first.id, side="beside")
    assert not footprint(first).intersects(footprint(second))
    assert relation_holds(state, second, "beside", first.id)


def test_what_hangs_moves_to_another_wall_and_another_floor(state: SceneState) -> None:
    placed = _hang(state, "painting", HALL)
    args = MoveObjectArgs(object_id=placed.id, receptacle_id="F2/private_office_1")
    moved = move_object(state, args, StaticEngine())
    assert moved.room == "F2/private_office_1" and moved.mount == "wall" and _at_wall(state, moved)
    with pytest.raises(MansionError, match="hangs on a wall"):
        move_object(state, MoveObjectArgs(object_id=moved.id, turn=90.0), StaticEngine())


def test_where_the_room_is_shallow_another_wall_is_said_to_be_in_the_way() -> None:
    ring = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.3), (6.0, 1.3), (6.0, 1.34), (0.0, 1.34)]
    edges = wall_edges(ring)
    wall = WallSpace(edges[4], edges)
    size = (1.0, 0.07, 0.7)
    assert wall.hindrances(1.0, 1.5, size) == wall.hindrances(2.4, 1.5, size) == ["another wall of the room"]
    assert wall.hindrances(2.6, 1.5, size) == []
    assert wall.gaps(1.0, 1.2, 1.8, 0.07) == [pytest.approx((2.5, 5.48))]
