"""The error object says what, where and what would be accepted, and survives processes."""

import pickle

from mansion_msgs_py.errors import MansionError


def test_the_text_names_code_stage_place_and_reason() -> None:
    error = MansionError("INFEASIBLE", "4 m2 is too little", path="$.area").at_stage("plan_program")
    assert str(error) == "INFEASIBLE [plan_program] at $.area: 4 m2 is too little"


def test_the_deepest_stage_is_kept() -> None:
    error = MansionError("TIMEOUT", "late").at_stage("solve_floor").at_stage("build_building")
    assert error.stage == "solve_floor"


def test_it_crosses_process_boundaries_whole() -> None:
    error = MansionError("CONFLICT", "busy", path="$.output", details={"n": 4})
    assert pickle.loads(pickle.dumps(error)).info == error.info
