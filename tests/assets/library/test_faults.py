"""Faults of assets are found: of facts, meshes, pieces, joints."""

from pathlib import Path

import msgspec
import pytest

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.catalogue.asset import JointRecord, Surface
from mansion_assets.library.adding import add_models
from mansion_assets.library.faults import asset_faults, library_faults
from mansion_assets.library.preparing import AddOptions
from sample_models import write_cabinet


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("faults")
    model = write_cabinet(folder / "models")
    list(
        add_models(
            [model], folder / "shop", AddOptions(licence="CC0"), load_catalogue([]), lambda seen: b"", replace=False
        )
    )
    return folder / "shop"


@pytest.fixture
def cabinet(library: Path) -> Asset:
    return load_catalogue([library]).asset("shop.filing_cabinet")


def test_a_sound_asset_has_none(cabinet: Asset) -> None:
    assert asset_faults(cabinet) == []


def test_a_drawer_that_goes_into_the_body_is_a_fault(cabinet: Asset) -> None:
    inward = msgspec.structs.replace(cabinet.joints[0], axis=(0.0, -1.0, 0.0))
    (fault,) = asset_faults(msgspec.structs.replace(cabinet, joints=(inward,)))
    assert "pass into the body" in fault.message


def test_an_axis_that_is_no_unit_vector_is_a_fault(cabinet: Asset) -> None:
    long = msgspec.structs.replace(cabinet.joints[0], axis=(0.0, 2.0, 0.0))
    assert "not a unit vector" in asset_faults(msgspec.structs.replace(cabinet, joints=(long,)))[0].message


def test_a_joint_of_a_part_that_is_not_there_is_a_fault(cabinet: Asset) -> None:
    joint = JointRecord(part="lid_1", kind="hinge", axis=(1.0, 0.0, 0.0), origin=(0.0, 0.0, 0.0), travel=90.0)
    faults = asset_faults(msgspec.structs.replace(cabinet, joints=(*cabinet.joints, joint)))
    assert any("lid_1, but the mesh has no such part" in fault.message for fault in faults)


def test_a_surface_out_of_the_box_and_an_absurd_size_are_faults(cabinet: Asset) -> None:
    wide = Surface(kind="top", x=0.0, y=0.0, z=0.3, w=3.0, d=0.3)
    assert "reaches out" in asset_faults(msgspec.structs.replace(cabinet, surfaces=(wide,)))[0].message
    assert any("edges are" in f.message for f in asset_faults(msgspec.structs.replace(cabinet, size=(40.0, 1.0, 1.0))))


def test_a_piece_that_stands_out_of_its_part_is_a_fault(cabinet: Asset, tmp_path: Path) -> None:
    pieces = tmp_path / "x.pieces.json"
    drawer = '{"part":"drawer_1","center":[0,0,0],"size":[0.1,0.1,0.1]}'
    pieces.write_text(f'[{{"center":[0,0,0],"size":[2,0.1,0.1]}},{drawer}]')
    faults = asset_faults(msgspec.structs.replace(cabinet, pieces=str(pieces)))
    assert any("of the body (number 1) that protrudes from it" in fault.message for fault in faults)


def test_a_record_that_cannot_be_read_is_a_fault_of_the_library(library: Path, tmp_path: Path) -> None:
    folder = tmp_path / "broken" / "assets"
    folder.mkdir(parents=True)
    (folder / "x.json").write_text("{}")
    assert [fault.asset for fault in library_faults(tmp_path / "broken")] == ["x.json", "broken"]
