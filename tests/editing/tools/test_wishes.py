"""What a wish asks for holds after a placement or a move, or the refusal names what is in the way."""

from collections.abc import Callable
from typing import Any

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mansion_assets.catalogue import Catalogue
from mansion_bringup.edit_hooks import new_faults
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.state import SceneState
from mansion_editing.tools.manipulation import move_object
from mansion_editing.tools.perception import contents, on_top
from mansion_editing.tools.placement import place_on_surface
from mansion_editing.tools.relations import relation_holds
from mansion_msgs_py.editing.objects import MoveObjectArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject, Window

EditorFactory = Callable[..., SceneEditor]
SOFA, TABLE, FRIDGE, MUG = "F1/hall/sofa_1", "F1/kitchen/dining_table_1", "F1/kitchen/fridge_1", "F1/kitchen/mug_1"
HALL, KITCHEN = "F1/hall", "F1/kitchen"
WISHES = ("side", "near", "other", "within", "spot", "facing")


def _holds(state: SceneState, item: SceneObject, args: dict[str, Any]) -> bool:
    return relation_holds(state, item, **{name: args[name] for name in WISHES if name in args})


def _place(state: SceneState, asset: str, receptacle: str, **wish: Any) -> SceneObject:
    args = PlaceOnSurfaceArgs(asset_id=asset, receptacle_id=receptacle, **wish)
    return place_on_surface(state, args, StaticEngine())


def _move(state: SceneState, name: str, **args: Any) -> SceneObject:
    return move_object(state, MoveObjectArgs(object_id=name, **args), StaticEngine())


@pytest.mark.parametrize(
    "wish",
    [
        {"near": SOFA, "side": "left"},
        {"near": SOFA, "side": "right"},
        {"near": SOFA, "side": "front"},
        {"near": SOFA, "side": "around", "within": 0.2},
        {"near": SOFA, "side": "beside", "within": 0.1},
        {"near": SOFA, "within": 0.5},
        {"spot": "corner"},
        {"spot": "wall"},
        {"spot": "door"},
        {"spot": "middle", "facing": SOFA},
        {"near": SOFA, "side": "right", "facing": SOFA},
    ],
)
def test_furniture_stands_where_it_is_wished(state: SceneState, wish: dict[str, Any]) -> None:
    lamp = state.catalogue.by_category("floor_lamp")[0].key
    placed = _place(state, lamp, HALL, **wish)
    assert placed.mount == "floor" and placed.room == HALL
    assert _holds(state, placed, wish)


def test_chairs_round_a_table_look_at_it_and_spread(state: SceneState) -> None:
    chair = state.catalogue.by_category("chair")[0].key
    chairs = [_place(state, chair, KITCHEN, near=TABLE, side="around") for _ in range(4)]
    assert len({item.rotation for item in chairs}) == 4
    assert all(relation_holds(state, item, "around", TABLE, facing=TABLE) for item in chairs)


def test_a_bin_stands_under_a_table_and_stays_when_that_is_removed(open_editor: EditorFactory) -> None:
    editor = open_editor(validator=new_faults)
    args = {"asset_id": "waste_bin_1", "receptacle_id": KITCHEN, "near": TABLE, "side": "under"}
    name = editor.call("PlaceOnSurface", args).object_ids[0]
    _, item = editor.state.get(name)
    assert relation_holds(editor.state, item, "under", TABLE) and item.parent == TABLE
    index = editor.state.index(1)
    _, table = editor.state.get(TABLE)
    asset = editor.state.asset(table)
    assert item not in on_top(index, table, asset) and item not in contents(index, table, asset)
    editor.call("RemoveObject", {"receptacle_id": TABLE})
    assert editor.state.find(name) is not None and editor.state.find(MUG) is None
    editor.call("RemoveObject", {"object_id": TABLE})
    assert editor.state.get(name)[1].parent is None


def test_a_rug_lies_under_a_table(state: SceneState) -> None:
    rug = state.catalogue.by_category("rug")[0].key
    assert relation_holds(state, _place(state, rug, KITCHEN, near=TABLE, side="under"), "under", TABLE)


def test_what_is_too_high_does_not_go_under_a_table(state: SceneState) -> None:
    with pytest.raises(MansionError, match="under F1/kitchen/dining_table_1") as error:
        _place(state, "Fridge_1", KITCHEN, near=TABLE, side="under")
    assert error.value.code == ErrorCode.INFEASIBLE and state.pending == []


def test_a_refusal_names_what_is_in_the_way(state: SceneState) -> None:
    lamp = state.catalogue.by_category("floor_lamp")[0].key
    with pytest.raises(MansionError, match=r"right of F1/kitchen/fridge_1.*: .*the wall of F1/kitchen"):
        _place(state, lamp, KITCHEN, near=FRIDGE, side="right", within=0.1, spot="corner")
    with pytest.raises(MansionError, match="no window"):
        _place(state, lamp, HALL, spot="window")
    with pytest.raises(MansionError, match="is not in F1/hall"):
        _place(state, lamp, HALL, near=TABLE, side="beside")


@pytest.mark.parametrize("side", ["left", "right", "front", "behind", "beside"])
def test_small_things_lie_where_they_are_wished(state: SceneState, side: str) -> None:
    placed = _place(state, "Book_26", TABLE, near=MUG, side=side)
    assert placed.parent == TABLE and relation_holds(state, placed, side, MUG)  # type: ignore[arg-type]


def test_small_things_lie_between_two(state: SceneState) -> None:
    second = _place(state, "Apple_1", TABLE, near=MUG, side="left", within=0.3)
    _, other = state.get(second.id)
    shifted = msgspec.structs.replace(other, position=(8.6, 3.0, other.position[2]))
    state.replace(1, other, shifted)
    placed = _place(state, "cola_can_1", TABLE, near=MUG, side="between", other=second.id)
    assert relation_holds(state, placed, "between", MUG, second.id)


def test_a_wish_about_a_room_is_refused_on_a_table(state: SceneState) -> None:
    with pytest.raises(MansionError, match="'corner of a room' says nothing"):
        _place(state, "Apple_1", TABLE, spot="corner")
    with pytest.raises(MansionError, match=r"no free place for an apple .* beside F1/kitchen/fridge_1 on"):
        _place(state, "Apple_1", TABLE, near=FRIDGE, side="beside")


@pytest.mark.parametrize(
    ("wish", "field"),
    [({"side": "left"}, "near"), ({"within": 1.0}, "near"), ({"near": SOFA, "side": "between"}, "other")],
)
def test_a_wish_without_its_landmark_is_no_wish(state: SceneState, wish: dict[str, Any], field: str) -> None:
    with pytest.raises(MansionError) as error:
        _place(state, "Apple_1", HALL, **wish)
    assert error.value.code == ErrorCode.INVALID_PAYLOAD and error.value.info.path == f"$.{field}"


def test_moving_finds_the_room_and_the_surface_of_its_landmark(state: SceneState) -> None:
    apple = _place(state, "Apple_1", TABLE)
    assert relation_holds(state, _move(state, apple.id, near=MUG, side="left"), "left", MUG)
    fridge = _move(state, FRIDGE, near=SOFA, side="right")
    assert fridge.room == HALL and relation_holds(state, fridge, "right", SOFA)


def test_moving_by_a_wish_takes_along_what_is_carried(state: SceneState) -> None:
    table = _move(state, TABLE, spot="corner")
    _, mug = state.get(MUG)
    assert relation_holds(state, table, spot="corner")
    assert mug.position[:2] == pytest.approx(table.position[:2], abs=1e-3)


def test_an_object_turns_where_it_is(state: SceneState) -> None:
    where = state.get(TABLE)[1].position
    assert _move(state, TABLE, rotation=90.0).rotation == 90.0
    assert _move(state, TABLE, turn=-30.0).rotation == 60.0
    assert state.get(TABLE)[1].position == where and state.get(MUG)[1].rotation == 60.0
    assert relation_holds(state, _move(state, TABLE, facing=FRIDGE), facing=FRIDGE)
    assert state.get(TABLE)[1].position == where
    with pytest.raises(MansionError, match="give receptacle_id"):
        _move(state, TABLE)


@pytest.fixture(scope="module")
def floor_assets(catalogue: Catalogue) -> list[str]:
    """Return furniture of all sizes."""
    return sorted(a.key for a in catalogue.assets.values() if a.mount == "floor" and a.footprint < 2.0)


@settings(max_examples=25, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_whatever_is_placed_is_as_wished_and_sound(
    windowed: SceneEditor, floor_assets: list[str], data: st.DataObject
) -> None:
    sides = ("", "beside", "left", "right", "behind", "front", "under", "around", "between")
    wish: dict[str, Any] = {"side": data.draw(st.sampled_from(sides))}
    if wish["side"]:
        wish["near"] = data.draw(st.sampled_from([TABLE, FRIDGE]))
        wish["within"] = data.draw(st.sampled_from([None, 0.1, 0.6, 3.0]))
    if wish["side"] == "between":
        wish["other"] = FRIDGE if wish["near"] == TABLE else TABLE
    else:
        wish["spot"] = data.draw(st.sampled_from(["", "", "wall", "corner", "window", "door", "middle"]))
        wish["facing"] = data.draw(st.sampled_from(["", "", TABLE, FRIDGE]))
    asset = data.draw(st.sampled_from(floor_assets))
    state = windowed.state
    before = dict(state.scenes)
    try:
        done = windowed.call("PlaceOnSurface", {"asset_id": asset, "receptacle_id": KITCHEN, **wish})
    except MansionError as error:
        assert error.code == ErrorCode.INFEASIBLE and state.scenes == before
        return
    _, placed = state.get(done.object_ids[0])
    assert placed.room == KITCHEN and new_faults(before, state.scenes) == []
    assert not any(wish.values()) or _holds(state, placed, wish)
    windowed.call("Undo")


@pytest.fixture
def windowed(open_editor: EditorFactory) -> SceneEditor:
    """Return an editor whose edits wait, of the building with a window in the kitchen."""
    editor = open_editor(validator=new_faults, autosave=False)
    window = Window(id="F1/window_1", wall="w", room=KITCHEN, segment=((8, 6), (9.5, 6)), sill=0.9, height=1.2)
    editor.state.scenes[1] = msgspec.structs.replace(editor.state.scenes[1], windows=[window])
    return editor
