"""Building tells how far it is, step by step to the last."""

from pathlib import Path

from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.world import Progress


def test_progress_grows_step_by_step_to_its_total(tmp_path: Path) -> None:
    told: list[Progress] = []
    build_building(BuildRequest(description="a small flat"), tmp_path / "flat", report=told.append)
    counts = [progress.done for progress in told]
    assert counts == sorted(counts)
    assert set(range(told[-1].total + 1)) == set(counts)
    assert told[-1].stage == "done"
