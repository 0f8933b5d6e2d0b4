"""Light in pictures: hollows are darker, flat faces even."""

import numpy as np

from mansion_export.meshes.materials import named
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_export.pictures.projecting import number_seen
from mansion_export.pictures.renderer import Triangles, View, render

GREY = np.array([0.6, 0.6, 0.6])


def boxes(*parts: Box) -> Triangles:
    surface = boxes_surface(parts, named("signal_white"))
    return Triangles.plain(surface.vertices[surface.faces], GREY)


def test_a_leaning_face_has_one_shade() -> None:
    picture = render(boxes(Box((0.0, 0.0, 0.0), (4.0, 4.0, 0.2))), View(-60.0, 30.0, 40.0))
    middle = picture[picture.shape[0] // 2, picture.shape[1] // 2 - 30 : picture.shape[1] // 2 + 30]
    assert np.ptp(middle.astype(int), axis=0).max() <= 1


def test_the_floor_beside_a_wall_is_darker_than_in_the_open() -> None:
    # The wall stands on the side away from the sun and casts no shadow on the floor before it.
    picture = render(
        boxes(Box((0.0, 0.0, -0.1), (6.0, 6.0, 0.2)), Box((0.0, 2.0, 1.0), (6.0, 0.2, 2.0))), View(-90.0, 45.0, 30.0)
    )
    column = picture[:, picture.shape[1] // 2].astype(int).sum(axis=1)
    floor = column[-60:-30]
    assert np.ptp(floor) <= 3
    assert column[:-100].min() < 0.7 * floor.mean()


def test_the_triangles_that_are_seen_are_numbered_in_their_order() -> None:
    index, glass = np.array([[7, -1], [2, 7]], dtype=np.int32), np.array([[-1, 4], [-1, -1]], dtype=np.int32)
    assert number_seen(index, glass, 9).tolist() == [2, 4, 7]
    assert index.tolist() == [[2, -1], [0, 2]]
    assert glass.tolist() == [[-1, 1], [-1, -1]]
