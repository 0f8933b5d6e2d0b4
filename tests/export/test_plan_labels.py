"""Room names stand where they cover no furniture and leave no room."""

from types import SimpleNamespace

from mansion_export.plan.labels import LabelBox, place_label

ROOM = SimpleNamespace(id="F1/room", polygon=[(0, 0), (6, 0), (6, 4), (0, 4)], holes=[])


def furniture(x: float, width: float) -> SimpleNamespace:
    """Return a block as deep as the room."""
    return SimpleNamespace(room="F1/room", mount="floor", size=(width, 4.0, 1.0), position=(x, 2.0, 0.5), rotation=0.0)


def test_a_name_stands_beside_the_furniture() -> None:
    scene = SimpleNamespace(objects=[furniture(1.5, 3.0)], doors=[])
    place = place_label(scene, ROOM, [LabelBox(2.0, 0.6, 1.0)])
    assert place.at[0] - 1.0 >= 2.8
    assert place.at[0] + 1.0 <= 6.2
    assert not place.turned


def test_a_name_is_turned_in_a_narrow_gap() -> None:
    scene = SimpleNamespace(objects=[furniture(1.2, 2.4), furniture(4.8, 2.4)], doors=[])
    place = place_label(scene, ROOM, [LabelBox(2.6, 0.7, 1.0)])
    assert place.turned
    assert abs(place.at[0] - 3.0) < 0.3


def test_letters_shrink_where_large_ones_do_not_fit() -> None:
    scene = SimpleNamespace(objects=[furniture(1.2, 2.4), furniture(5.4, 1.2)], doors=[])
    place = place_label(scene, ROOM, [LabelBox(4.6, 3.0, 1.0), LabelBox(2.0, 0.6, 0.7)])
    assert place.option == 1
