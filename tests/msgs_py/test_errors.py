"""The error object says what, where and what would be accepted, and survives processes."""

import pickle

import msgspec
import pytest

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.editing.objects import PlaceOnSurfaceArgs
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene


def test_the_text_names_code_stage_place_and_reason() -> None:
    error = MansionError("INFEASIBLE", "4 m2 is too little", path="$.area").at_stage("plan_program")
    assert str(error) == "INFEASIBLE [plan_program] at $.area: 4 m2 is too little"


def test_the_deepest_stage_is_kept() -> None:
    error = MansionError("TIMEOUT", "late").at_stage("solve_floor").at_stage("build_building")
    assert error.stage == "solve_floor"


def test_it_crosses_process_boundaries_whole() -> None:
    error = MansionError("CONFLICT", "busy", path="$.output", details={"n": 4})
    assert pickle.loads(pickle.dumps(error)).info == error.info


def test_input_of_any_length_is_quoted_in_short() -> None:
    long = "x" * 10_000_000
    error = MansionError(
        "NOT_FOUND", f"no {long}; rooms are hall", path=f"$.{long}", details={"seen": [long, {long: long}]}
    )
    assert len(encode_bytes(error.reply())) < 100_000
    assert str(error).endswith("; rooms are hall")
    short = MansionError("NOT_FOUND", "no hall", details={"rooms": ["a", "b"], "n": 4, "at": None})
    assert short.info.details == {"rooms": ["a", "b"], "n": 4, "at": None}


@pytest.mark.parametrize("payload", [BuildRequest, FloorScene, LoadBuilding, PlaceOnSurfaceArgs])
@pytest.mark.parametrize("field", ["planner", "side", "building_id", "xxxxx", "path", "asset_id", "floors"])
def test_no_fault_of_a_payload_echoes_it_whole(payload: type[msgspec.Struct], field: str) -> None:
    long = "x" * 5_000_000
    with pytest.raises(MansionError) as caught:
        decode(payload, encode_bytes({field: long, long: 1, "seed": -1}))
    assert len(encode_bytes(caught.value.reply())) < 10_000
