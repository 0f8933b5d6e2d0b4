"""What lies on a surface makes room for one more thing, as far as it may move and there is room at all."""

import msgspec

from mansion_editing.state import SceneState
from mansion_editing.tools.ledges import Ledge, free_places, ledges_of
from mansion_editing.tools.rearranging import shifts_for
from mansion_msgs_py.scene import SceneObject

MUG = "F1/kitchen/mug_1"


def _table(state: SceneState) -> tuple[SceneObject, Ledge]:
    table = state.get("F1/kitchen/dining_table_1")[1]
    asset = state.asset(table)
    assert asset is not None
    return table, ledges_of(asset, inside=False)[0]


def _large(ledge: Ledge) -> tuple[float, float, float]:
    """Return the size of what fits beside a mug at the edge, and not beside one in the middle."""
    return ledge.w - 0.2, ledge.d - 0.02, 0.1


def test_a_mug_in_the_middle_moves_to_the_edge(state: SceneState) -> None:
    table, ledge = _table(state)
    mug = state.get(MUG)[1]
    size = _large(ledge)
    assert not free_places(state.index(1), table, [ledge], size)
    shifts = shifts_for(state.index(1), table, ledge, size, [mug])
    assert shifts is not None
    ((name, (x, y)),) = shifts
    assert name == MUG and (x, y) != mug.position[:2]
    state.replace(1, mug, msgspec.structs.replace(mug, position=(x, y, mug.position[2])))
    assert free_places(state.index(1), table, [ledge], size)


def test_what_stays_is_not_moved(state: SceneState) -> None:
    table, ledge = _table(state)
    assert shifts_for(state.index(1), table, ledge, _large(ledge), []) is None


def test_what_does_not_fit_at_all_moves_nothing(state: SceneState) -> None:
    table, ledge = _table(state)
    assert shifts_for(state.index(1), table, ledge, (ledge.w, ledge.d, 0.1), [state.get(MUG)[1]]) is None
