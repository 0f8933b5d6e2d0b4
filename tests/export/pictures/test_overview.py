"""A picture of a building: photographed from the street, its floors cut open below with the names of their rooms."""

import io

import numpy as np
from PIL import Image

from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.materials import named
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_export.pictures.backdrop import HORIZON, sky
from mansion_export.pictures.cut_open import CUT, cut_open
from mansion_export.pictures.overview import overview_png
from mansion_export.pictures.renderer import Camera, Triangles, photograph
from mansion_export.pictures.street_view import StreetView
from mansion_msgs_py.scene import FloorScene


def opened(scenes: list[FloorScene], width: int = 480) -> Image.Image:
    return Image.open(io.BytesIO(overview_png(scenes, width)))


def test_it_is_as_wide_as_asked_and_the_same_each_time(building: list[FloorScene]) -> None:
    assert opened(building).width == 480
    assert overview_png(building, 480) == overview_png(building, 480)


def test_no_building_is_an_empty_sheet() -> None:
    assert opened([]).width == 480


def test_uprights_stay_parallel_and_far_things_are_smaller() -> None:
    surfaces = [boxes_surface([Box((x, y, 2.0), (0.4, 0.4, 4.0))], named("signal_white")) for x, y in ((0, 0), (0, 30))]
    camera = Camera(-90.0, (0.0, -20.0, 1.6), 400.0, (200.0, 150.0), HORIZON, 1e6)
    black = np.zeros((300, 400, 3), dtype=np.float32)
    heights = []
    for surface in surfaces:
        shown = photograph(Triangles.of([surface]), camera, black.copy(), Triangles.join([]))
        rows, columns = np.nonzero(shown.sum(axis=2) > 60)
        assert np.ptp(columns[rows == rows.min() + 2]) == np.ptp(columns[rows == rows.max() - 2])
        heights.append(np.ptp(rows))
    assert abs(heights[0] - 400.0 * 4.0 / 19.8) <= 2
    assert abs(heights[1] - 400.0 * 4.0 / 49.8) <= 2


def test_the_sky_is_deeper_above_and_ends_in_woods() -> None:
    picture = sky((320, 200), 150.0)
    assert picture.shape == (200, 320, 3)
    assert picture[0, :, 0].mean() < picture[120, :, 0].mean()
    assert picture[160, :, 1].std() < 0.01


def test_a_building_fills_its_picture_without_being_cut(building: list[FloorScene]) -> None:
    view = StreetView(building_models(building, site=False), building)
    picture = np.asarray(view.draw(400, view.height(400)))
    assert 0.3 <= picture.shape[0] / picture.shape[1] <= 0.6


def test_what_hangs_high_on_a_wall_hangs_on_the_cut_wall(building: list[FloorScene]) -> None:
    for model, scene in zip(building_models(building), building, strict=True):
        flat = {item.id for item in scene.objects if item.mount == "wall" and item.size[1] < 0.15}
        if flat:
            assert cut_open(model, scene).corners[..., 2].max() < CUT + 1.0
