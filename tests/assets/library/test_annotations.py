"""Annotations of objathor, of AI2-THOR's databases, and what they get wrong."""

import json
from pathlib import Path

import pytest

from mansion_assets.library.annotations import Annotations, annotation_of
from mansion_msgs_py.errors import ErrorCode, MansionError


def test_an_annotation_of_objathor() -> None:
    found = annotation_of(
        {"category": "ceiling lamp", "scale": 0.5, "z_axis_scale": False, "onCeiling": True, "pose_z_rot_angle": 0}
    )
    assert (found.category, found.longest, found.height, found.mount, found.turn) == (
        "ceiling lamp", 0.5, None, "ceiling", 0.0,
    )  # fmt: skip


def test_centimetres_are_brought_to_metres() -> None:
    assert annotation_of({"width": 40, "depth": 50, "height": 90}).size == pytest.approx((0.4, 0.5, 0.9))


def test_an_entry_of_ai2_thor() -> None:
    entry = {
        "objectType": "CoffeeMachine",
        "boundingBox": {"x": 0.2, "y": 0.4, "z": 0.3},
        "primaryProperty": "CanPickup",
        "secondaryProperties": ["Receptacle", "CanToggleOnOff"],
    }
    found = annotation_of(entry)
    assert found.category == "coffee machine"
    assert found.size == (0.2, 0.3, 0.4)
    assert (found.pickupable, found.receptacle, found.toggleable, found.openable) == (True, True, True, False)


@pytest.mark.parametrize("facts", [{"scale": -1}, {"scale": "tall"}, {"mass": 0}, {"pose_z_rot_angle": float("inf")}])
def test_numbers_that_cannot_be_are_refused(facts: dict[str, object]) -> None:
    with pytest.raises(MansionError) as caught:
        annotation_of({"category": "chair", **facts})
    assert caught.value.info.code == ErrorCode.INVALID_PAYLOAD


def test_a_file_above_speaks_of_models_by_their_names_alone(tmp_path: Path) -> None:
    folder = tmp_path / "set" / "abc"
    folder.mkdir(parents=True)
    facts = {"abc": {"annotations": {"category": "stool"}}}
    (tmp_path / "set" / "annotations.json").write_text(json.dumps(facts))
    known = Annotations(tmp_path / "set")
    found = known.of(folder / "abc.glb")
    assert found is not None
    assert found.category == "stool"
    assert known.of(tmp_path / "set" / "other" / "other.glb") is None


def test_what_is_above_the_folder_is_not_read(tmp_path: Path) -> None:
    (tmp_path / "set").mkdir()
    (tmp_path / "annotations.json").write_text(json.dumps({"abc": {"category": "stool"}}))
    assert Annotations(tmp_path / "set").of(tmp_path / "set" / "abc.glb") is None


def test_annotations_that_are_no_json_are_refused_by_name(tmp_path: Path) -> None:
    (tmp_path / "annotations.json").write_text("{")
    with pytest.raises(MansionError, match=r"annotations\.json cannot be read"):
        Annotations(tmp_path).of(tmp_path / "abc.glb")


def test_a_code_of_objaverse_is_a_licence_by_its_name() -> None:
    assert annotation_of({"license_info": {"license": "by"}}).licence == "CC-BY-4.0"
    assert annotation_of({"license": "MIT"}).licence == "MIT"
