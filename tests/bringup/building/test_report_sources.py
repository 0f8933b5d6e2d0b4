"""The report tells which pieces a language model made, and what that took."""

import msgspec
import pytest

from mansion_bringup.building.report import building_report
from mansion_bringup.pipeline.planning import prepare_planner
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.usage import LlmUsage
from mansion_planner.plan import plan_building


def test_sources_and_usage_reach_the_report() -> None:
    plan = plan_building(BuildRequest(description="a small flat"))
    assert building_report(plan, [], [], {}).llm is None
    usage = LlmUsage(model="m", answers=3, input_tokens=10, cost=0.5)
    plan = msgspec.structs.replace(plan, sources={"numbers": "llm", "cores": "rules: why"}, llm=usage)
    report = building_report(plan, [], [], {})
    assert report.sources == {"numbers": "llm", "cores": "rules: why"}
    assert report.llm == usage


def test_the_command_line_says_what_to_set(monkeypatch: pytest.MonkeyPatch, tmp_path: object) -> None:
    for name in ("MANSION_LLM_BASE_URL", "MANSION_LLM_MODEL", "MANSION_LLM_REPLAY", "MANSION_LLM_CONFIG"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.delenv("OPENAI_BASE_URL", raising=False)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    prepare_planner(BuildRequest(description="a flat"))
    with pytest.raises(MansionError, match="MANSION_LLM_MODEL"):
        prepare_planner(BuildRequest(description="a flat", planner="llm"))
