"""Optional dependencies are installed once, from their locks, and only into the launcher's own environment."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from mansion_bringup import extras
from mansion_bringup.cli.run_tests import TEST_EXTRAS, pytest_command, run_tests, test_environment
from mansion_bringup.extras import EXTRAS, ensure_extra, require_extra
from mansion_msgs_py.errors import ErrorCode, MansionError

test_environment.__test__ = False  # type: ignore[attr-defined]

VERSION = f"{sys.version_info.major}.{sys.version_info.minor}"


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout with a lock of the extra ``sim``, and the environment that its launcher made."""
    (tmp_path / "requirements").mkdir()
    (tmp_path / f"requirements/sim-{VERSION}.txt").write_text("one", encoding="utf-8")
    venv = tmp_path / ".venv"
    venv.mkdir()
    (venv / ".mansion-venv").touch()
    monkeypatch.setattr(extras, "_CHECKOUT", tmp_path)
    monkeypatch.setattr(sys, "prefix", str(venv))
    return venv


@pytest.fixture
def pip(monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    """The pip commands that would have run; each succeeds."""
    commands: list[list[str]] = []

    def run(command: list[str], **_: Any) -> subprocess.CompletedProcess[str]:
        commands.append(command)
        return subprocess.CompletedProcess(command, 0, "", "")

    monkeypatch.setattr(subprocess, "run", run)
    return commands


def test_an_extra_is_installed_once_with_hashes(prefix: Path, pip: list[list[str]]) -> None:
    ensure_extra("sim")
    ensure_extra("sim")
    assert len(pip) == 1
    assert "--require-hashes" in pip[0]
    assert pip[0][-1] == str(prefix.parent / f"requirements/sim-{VERSION}.txt")


def test_a_changed_lock_is_installed_again(prefix: Path, pip: list[list[str]]) -> None:
    ensure_extra("sim")
    (prefix.parent / f"requirements/sim-{VERSION}.txt").write_text("two", encoding="utf-8")
    ensure_extra("sim")
    assert len(pip) == 2


def test_progress_goes_to_stderr(prefix: Path, pip: list[list[str]], capsys: pytest.CaptureFixture[str]) -> None:
    ensure_extra("sim")
    out, err = capsys.readouterr()
    assert out == "" and "installing the extra 'sim'" in err


def test_a_failed_installation_carries_pips_reason_and_is_tried_again(
    prefix: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(command: list[str], **_: Any) -> subprocess.CompletedProcess[str]:
        return subprocess.CompletedProcess(command, 1, "", "ERROR: no matching distribution\n")

    monkeypatch.setattr(subprocess, "run", fail)
    for _ in range(2):
        with pytest.raises(MansionError, match="no matching distribution") as caught:
            ensure_extra("sim")
        assert caught.value.code == ErrorCode.UNAVAILABLE
    assert "no matching distribution" in (prefix / "setup.log").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("checkout", "command"), [(True, r"pip install -r requirements/sim\.in"), (False, r"pip install 'mansion\[sim\]'")]
)
def test_elsewhere_nothing_is_installed_and_the_error_names_the_command(
    prefix: Path, pip: list[list[str]], monkeypatch: pytest.MonkeyPatch, checkout: bool, command: str
) -> None:
    (prefix / ".mansion-venv").unlink()
    if checkout:
        (prefix.parent / "requirements/sim.in").touch()
    monkeypatch.setitem(EXTRAS, "sim", ("json", "no_such_module"))
    with pytest.raises(MansionError, match=command) as caught:
        ensure_extra("sim")
    assert caught.value.info.details["missing"] == ["no_such_module"]
    monkeypatch.setitem(EXTRAS, "sim", ("json",))
    ensure_extra("sim")
    assert pip == []


def test_a_required_extra_is_never_installed_and_the_error_says_how(
    prefix: Path, pip: list[list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(EXTRAS, "sim", ("no_such_module",))
    with pytest.raises(MansionError, match=r"the extra 'sim'.*mansion_bringup\.extras sim$"):
        require_extra("sim")
    assert pip == []


def test_an_unknown_extra_is_refused_with_the_list() -> None:
    with pytest.raises(
        MansionError,
        match="cluster, convex, docs, dxf, embeddings, ifc, lint, llm, record, rerun, sim, test, thor, usd",
    ):
        ensure_extra("gpu")


def test_arguments_of_the_suite_come_last_and_win() -> None:
    command = pytest_command(["-n", "0", "tests/planner"])
    assert command[-3:] == ["-n", "0", "tests/planner"]
    assert command[command.index("-n") + 1] == "2"
    assert "--cov" in command


def test_the_suite_stays_on_loopback_whatever_the_caller_has() -> None:
    environment = test_environment({"ROS_AUTOMATIC_DISCOVERY_RANGE": "SUBNET", "OMP_NUM_THREADS": "4"})
    assert environment["ROS_AUTOMATIC_DISCOVERY_RANGE"] != "SUBNET"
    assert Path(environment["FASTRTPS_DEFAULT_PROFILES_FILE"]).name == "loopback.xml"
    assert environment["OMP_NUM_THREADS"] == "4"


def test_the_suite_installs_its_tools_and_returns_pytests_exit_status(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []
    ran: list[dict[str, Any]] = []

    def run(command: list[str], **options: Any) -> subprocess.CompletedProcess[str]:
        ran.append({"command": command, **options})
        return subprocess.CompletedProcess(command, 5)

    monkeypatch.setattr("mansion_bringup.cli.run_tests.ensure_extra", asked.append)
    monkeypatch.setattr(subprocess, "run", run)
    assert run_tests(["-x"]) == 5
    assert asked == list(TEST_EXTRAS)
    assert ran[0]["cwd"] == root and ran[0]["command"] == pytest_command(["-x"])
