"""Objects stay where they stand rightly, go with a wall that they lean on, or find the nearest free place."""

import msgspec
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.structure import Storey
from mansion_editing.structure.displaced_objects import Settled, settle
from mansion_editing.structure.standing_checks import RoomSpace
from mansion_editing.structure.wall_moves import MovedWall
from mansion_msgs_py.scene import Door, FloorScene, SceneObject, SceneRoom


def room(width: float) -> SceneRoom:
    return SceneRoom(
        id="F1/den",
        room_type="office",
        kind="Entities",
        polygon=[(0, 0), (width, 0), (width, 5), (0, 5)],
        net_polygon=[(0.06, 0.06), (width - 0.06, 0.06), (width - 0.06, 4.94), (0.06, 4.94)],
        area=width * 5,
    )


def thing(name: str, x: float, y: float, *, parent: str | None = None, turn: float = 0.0) -> SceneObject:
    size = (0.1, 0.1, 0.1) if parent else (0.8, 0.4, 0.9)
    return SceneObject(
        id=f"F1/den/{name}",
        room="F1/den",
        category=name,
        asset=name,
        position=(x, y, 0.95 if parent else 0.45),
        rotation=turn,
        size=size,
        mount="surface" if parent else "floor",
        parent=parent,
    )


def settled(
    office: Storey, catalogue: Catalogue, width: float, items: list[SceneObject], doors: tuple[Door, ...] = ()
) -> Settled:
    """Settle objects of a room of 5 x 5 m whose east wall moved."""
    now = room(width)
    scene: FloorScene = msgspec.structs.replace(office.scene, rooms=[now], doors=list(doors), objects=[])
    wall = MovedWall("F1/den", "F1/hall", ((5.0, 0.0), (5.0, 5.0)), (width - 5.0, 0.0))
    return settle(RoomSpace(now, doors, []), items, [wall], scene, catalogue)


@pytest.mark.parametrize("width", [4.0, 6.5])
def test_what_leaned_on_the_wall_goes_with_it_and_carries_its_load(
    office: Storey, catalogue: Catalogue, width: float
) -> None:
    desk = thing("desk", 4.7, 2.5, turn=90.0)
    mug = thing("mug", 4.7, 2.5, parent=desk.id)
    sofa = thing("sofa", 0.6, 2.5)
    result = settled(office, catalogue, width, [desk, mug, sofa])
    at = {item.category: item.position[:2] for item in result.objects}
    assert at["desk"] == at["mug"] == pytest.approx((4.7 + width - 5.0, 2.5))
    assert result.objects[2] is sofa
    assert result.went_along == [desk.id]


def test_what_is_outside_finds_a_place_inside(office: Storey, catalogue: Catalogue) -> None:
    table = thing("table", 3.8, 2.5)
    result = settled(office, catalogue, 3.0, [table])
    assert result.placed == [table.id]
    assert RoomSpace(room(3.0), [], []).holds(result.objects[0])


def test_nothing_stays_in_front_of_a_door(office: Storey, catalogue: Catalogue) -> None:
    door = Door(
        id="F1/door_9", kind="single", segment=((1.0, 0.0), (1.9, 0.0)), rooms=("F1/den", None), width=0.9, height=2.1
    )
    box = thing("box", 1.4, 0.3)
    result = settled(office, catalogue, 5.0, [box], (door,))
    assert result.placed == [box.id]
    assert not RoomSpace(room(5.0), [door], []).holds(box)


def test_what_has_no_place_is_lost_with_what_it_carries(office: Storey, catalogue: Catalogue) -> None:
    wide = msgspec.structs.replace(thing("counter", 2.5, 4.0), size=(5.0, 0.6, 0.9))
    mug = thing("mug", 2.5, 4.0, parent=wide.id)
    result = settled(office, catalogue, 1.5, [wide, mug])
    assert result.objects == []
    assert [item.id for item in result.lost] == [wide.id]
