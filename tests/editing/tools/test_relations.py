"""Relations are decided from footprints alone, left and right being the landmark's own."""

import msgspec
import pytest

from mansion_editing.state import SceneState
from mansion_editing.tools.relations import relation_holds
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import SceneObject, Window

SOFA, TABLE, FRIDGE = "F1/hall/sofa_1", "F1/kitchen/dining_table_1", "F1/kitchen/fridge_1"


def _box(
    x: float, y: float, room: str, size: tuple[float, float, float] = (0.4, 0.4, 0.5), turn: float = 0.0
) -> SceneObject:
    return SceneObject(
        id=f"{room}/box_1",
        room=room,
        category="box",
        asset="box",
        position=(x, y, size[2] / 2),
        rotation=turn,
        size=size,
    )


def _beside_sofa(state: SceneState, across: float, along: float) -> SceneObject:
    """Return a box so far beyond the sofa's sides; the sofa looks to +y."""
    _, sofa = state.get(SOFA)
    reach_u, reach_v = sofa.size[0] / 2 + 0.2, sofa.size[1] / 2 + 0.2
    u = 0.0 if across == 0.0 else across + (reach_u if across > 0 else -reach_u)
    v = 0.0 if along == 0.0 else along + (reach_v if along > 0 else -reach_v)
    return _box(sofa.position[0] + u, sofa.position[1] + v, "F1/hall")


@pytest.mark.parametrize(
    ("across", "along", "side"), [(-0.3, 0, "left"), (0.3, 0, "right"), (0, 0.3, "front"), (0, -0.3, "behind")]
)
def test_each_side_is_the_landmarks_own(state: SceneState, across: float, along: float, side: str) -> None:
    item = _beside_sofa(state, across, along)
    others = {"left", "right", "front", "behind"} - {side}
    assert relation_holds(state, item, side, SOFA)  # type: ignore[arg-type]
    assert not any(relation_holds(state, item, other, SOFA) for other in others)  # type: ignore[arg-type]
    assert relation_holds(state, item, "beside", SOFA) and relation_holds(state, item, "around", SOFA)


def test_sides_turn_with_the_landmark(state: SceneState) -> None:
    _, sofa = state.get(SOFA)
    state.replace(1, sofa, msgspec.structs.replace(sofa, rotation=180.0))
    assert relation_holds(state, _beside_sofa(state, 0.3, 0.0), "left", SOFA)


def test_what_is_far_off_is_beside_nothing_unless_asked_for(state: SceneState) -> None:
    item = _beside_sofa(state, -1.2, 0.0)
    assert not relation_holds(state, item, "left", SOFA)
    assert relation_holds(state, item, "left", SOFA, within=1.3)
    assert not relation_holds(state, _beside_sofa(state, -0.3, 0.0), "left", SOFA, within=0.2)


def test_another_room_is_not_beside(state: SceneState) -> None:
    assert not relation_holds(state, _box(9.0, 1.5, "F1/kitchen"), "beside", SOFA, within=50.0)


def test_between_is_near_the_line_between_two(state: SceneState) -> None:
    middle, aside = _box(10.0, 1.75, "F1/kitchen"), _box(8.5, 0.8, "F1/kitchen")
    assert relation_holds(state, middle, "between", TABLE, FRIDGE)
    assert not relation_holds(state, aside, "between", TABLE, FRIDGE)


def test_under_is_below_the_top_and_within_the_edges(state: SceneState) -> None:
    assert relation_holds(state, _box(9.0, 3.0, "F1/kitchen"), "under", TABLE)
    assert not relation_holds(state, _box(9.0, 3.0, "F1/kitchen", (0.4, 0.4, 1.2)), "under", TABLE)
    assert not relation_holds(state, _box(10.5, 3.0, "F1/kitchen"), "under", TABLE)
    assert relation_holds(state, _box(9.0, 3.0, "F1/kitchen", (3.0, 2.0, 0.01)), "under", TABLE)


def test_above_is_for_what_hangs(state: SceneState) -> None:
    _, sofa = state.get(SOFA)
    back = sofa.position[1] - sofa.size[1] / 2
    picture = msgspec.structs.replace(
        _box(4.0, back - 0.05, "F1/hall", (0.6, 0.02, 0.4)), mount="wall", position=(4.0, back - 0.05, 1.6)
    )
    assert relation_holds(state, picture, "above", SOFA)
    assert not relation_holds(state, msgspec.structs.replace(picture, mount="floor"), "above", SOFA)
    low = msgspec.structs.replace(picture, position=(4.0, back - 0.05, 0.5))
    assert not relation_holds(state, low, "above", SOFA)


def test_spots_are_parts_of_the_room(state: SceneState) -> None:
    corner, middle = _box(0.3, 5.7, "F1/hall"), _box(3.0, 3.0, "F1/hall")
    assert relation_holds(state, corner, spot="corner") and relation_holds(state, corner, spot="wall")
    assert relation_holds(state, middle, spot="middle") and not relation_holds(state, middle, spot="wall")
    assert not relation_holds(state, corner, spot="middle")
    assert relation_holds(state, _box(5.5, 3.5, "F1/hall"), spot="door")
    assert not relation_holds(state, middle, spot="window")
    window = Window(id="F1/window_1", wall="w", room="F1/hall", segment=((2.5, 6.0), (3.5, 6.0)), sill=0.9, height=1.2)
    state.scenes[1] = msgspec.structs.replace(state.scenes[1], windows=[window])
    assert relation_holds(state, _box(3.0, 5.4, "F1/hall"), spot="window")


def test_a_front_that_points_at_an_object_faces_it(state: SceneState) -> None:
    assert relation_holds(state, _box(4.0, 4.0, "F1/hall", turn=180.0), facing=SOFA)
    assert relation_holds(state, _box(4.6, 4.0, "F1/hall", turn=180.0), facing=SOFA)
    assert not relation_holds(state, _box(4.0, 4.0, "F1/hall", turn=90.0), facing=SOFA)


def test_small_things_are_beside_each_other_on_one_surface(state: SceneState) -> None:
    _, mug = state.get("F1/kitchen/mug_1")
    near = msgspec.structs.replace(mug, id="F1/kitchen/mug_2", position=(9.2, 3.0, mug.position[2]))
    assert relation_holds(state, near, "right", mug.id)
    on_floor_below = msgspec.structs.replace(near, position=(9.2, 3.0, 0.05))
    assert not relation_holds(state, on_floor_below, "right", mug.id)
    assert not relation_holds(state, msgspec.structs.replace(near, position=(9.6, 3.0, mug.position[2])), "", mug.id)


def test_a_landmark_that_is_not_there_is_named(state: SceneState) -> None:
    with pytest.raises(MansionError, match="no object 'F1/hall/piano_1'"):
        relation_holds(state, _box(3.0, 3.0, "F1/hall"), "beside", "F1/hall/piano_1")
