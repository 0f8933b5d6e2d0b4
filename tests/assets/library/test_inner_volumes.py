"""What a model holds lies in its drawers, behind its doors and below its lids."""

import numpy as np
import pytest
import trimesh

from mansion_assets.joints import Joint
from mansion_assets.library.inner_volumes import receptacles_of_model
from mansion_assets.library.source_model import Look, SourceModel, SourcePart, SourceSurface

Board = tuple[tuple[float, float, float], tuple[float, float, float]]


def part(name: str, joint: Joint | None, *boards: Board) -> SourcePart:
    surfaces = []
    for size, center in boards:
        mesh = trimesh.creation.box(size)
        mesh.apply_translation(center)
        surfaces.append(SourceSurface(np.array(mesh.vertices), np.array(mesh.faces), Look((90, 60, 30))))
    return SourcePart(name, tuple(surfaces), joint)


def case(width: float = 0.8) -> SourcePart:
    """A case of 0.9 m with a bottom, a back, two sides and a top."""
    side = (width - 0.02) / 2
    return part(
        "",
        None,
        ((width, 0.5, 0.02), (0.0, 0.0, -0.44)),
        ((width, 0.5, 0.02), (0.0, 0.0, 0.44)),
        ((width, 0.02, 0.9), (0.0, -0.24, 0.0)),
        ((0.02, 0.5, 0.9), (-side, 0.0, 0.0)),
        ((0.02, 0.5, 0.9), (side, 0.0, 0.0)),
    )


HINGE = Joint("door_1", "hinge", (0.0, 0.0, 1.0), (-0.4, 0.26, 0.0), 84.0)
SLIDE = Joint("drawer_1", "slide", (0.0, 1.0, 0.0), (0.0, 0.0, 0.0), 0.3)


def test_what_is_behind_a_door_is_a_volume_and_no_surface() -> None:
    door = part("door_1", HINGE, ((0.8, 0.02, 0.86), (0.0, 0.26, 0.0)))
    found = receptacles_of_model(SourceModel("cupboard", (case(), door)))
    assert [surface.z for surface in found.surfaces] == pytest.approx([0.45], abs=1e-3)
    (room,) = found.volumes
    assert (room.kind, room.z - room.h / 2) == ("cell", pytest.approx(-0.43, abs=1e-3))
    assert 0.8 < room.h < 0.86
    assert 0.7 < room.w < 0.8


def test_an_open_case_has_surfaces_alone() -> None:
    found = receptacles_of_model(SourceModel("shelf", (case(),)))
    assert len(found.surfaces) == 2
    assert found.volumes == []


def test_a_tray_holds_things_up_to_its_rim_and_hides_what_it_stands_before() -> None:
    tray = part(
        "drawer_1",
        SLIDE,
        ((0.74, 0.44, 0.01), (0.0, 0.0, -0.4)),
        ((0.78, 0.02, 0.8), (0.0, 0.25, 0.0)),
        ((0.01, 0.44, 0.7), (-0.365, 0.0, -0.05)),
        ((0.01, 0.44, 0.7), (0.365, 0.0, -0.05)),
    )
    found = receptacles_of_model(SourceModel("chest", (case(), tray)))
    assert len(found.surfaces) == 1
    (room,) = found.volumes
    assert (room.kind, room.z - room.h / 2) == ("drawer", pytest.approx(-0.395, abs=1e-3))


def test_a_drawer_that_is_a_block_holds_nothing() -> None:
    block = part("drawer_1", SLIDE, ((0.74, 0.44, 0.8), (0.0, 0.0, 0.0)))
    assert receptacles_of_model(SourceModel("chest", (case(), block))).volumes == []


def test_a_chest_holds_things_below_its_lid() -> None:
    lid = part(
        "door_1",
        Joint("door_1", "hinge", (1.0, 0.0, 0.0), (0.0, -0.25, 0.45), 84.0),
        ((0.8, 0.5, 0.02), (0.0, 0.0, 0.46)),
    )
    boards = [(s.vertices[:, 2].mean(), s) for s in case().surfaces]
    open_case = SourcePart("", tuple(s for z, s in boards if z < 0.4))
    found = receptacles_of_model(SourceModel("blanket_chest", (open_case, lid)))
    assert found.surfaces == []
    (room,) = found.volumes
    assert room.h == pytest.approx(0.45 + 0.43 - 0.005, abs=0.01)
