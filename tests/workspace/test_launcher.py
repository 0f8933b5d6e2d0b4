"""`./mansion` makes its environment once, safely, and then gets out of the way."""

import json
import os
import shutil
import signal
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any


def test_first_use_shows_progress_on_stderr_and_leaves_stdout_to_the_command(first_use: Any) -> None:
    _, first = first_use
    assert first.stdout.startswith('{"arguments": ["first"]') and first.stdout.count("\n") == 1
    steps = [line for line in first.stderr.splitlines() if line.startswith("mansion: [")]
    assert len(steps) == 3
    assert first.stderr.splitlines()[-1].startswith("mansion: ready after")


def test_later_uses_say_nothing_and_start_no_python_but_their_own(ready: Any, tmp_path: Path) -> None:
    calls = tmp_path / "calls"
    for name in ("python3", "python3.11", "python3.12", "python3.13", "pip"):
        stub = tmp_path / name
        stub.write_text(f"#!/bin/sh\necho {name} >>{calls}\nexit 1\n", encoding="utf-8")
        stub.chmod(0o755)
    done = ready.run("again", PATH=f"{tmp_path}:{os.environ['PATH']}")
    assert (done.returncode, done.stderr) == (0, "")
    assert not calls.exists()


def test_the_command_sees_the_locked_packages_and_the_sources(ready: Any) -> None:
    seen = ready.report()
    assert seen["prefix"] == str(ready.venv)
    assert seen["brick"].startswith(str(ready.venv))
    assert str(ready.folder / "src" / "mansion_bringup") in seen["path"]
    assert seen["rclpy"].startswith(str(ready.venv))


def test_on_a_machine_that_there_are_no_wheels_of_ros_for_all_else_is_set_up(fresh: Any) -> None:
    seen = fresh.report(HOSTTYPE="aarch64")
    assert seen["rclpy"] is None
    assert seen["brick"].startswith(str(fresh.venv))
    assert not list(fresh.venv.glob("lib/*/site-packages/_mansion_ros*"))


def test_beside_an_older_c_library_the_wheels_of_ros_are_left_out(fresh: Any, tmp_path: Path) -> None:
    stub = tmp_path / "getconf"
    stub.write_text("#!/bin/sh\necho glibc 2.27\n", encoding="utf-8")
    stub.chmod(0o755)
    done = fresh.run(PATH=f"{tmp_path}:{os.environ['PATH']}")
    assert done.returncode == 0 and json.loads(done.stdout)["rclpy"] is None
    assert "glibc 2.27: the node graph is left out" in done.stderr


def test_arguments_folder_and_exit_status_pass_through_a_symbolic_link(ready: Any, tmp_path: Path) -> None:
    (tmp_path / "bin").mkdir()
    (tmp_path / "link").symlink_to(ready.folder / "mansion")
    (tmp_path / "bin" / "mansion").symlink_to("../link")
    (tmp_path / "json.py").write_text("raise SystemExit('shadowed')", encoding="utf-8")
    through_link = replace(ready, folder=tmp_path / "bin")
    seen = through_link.report("two words", "", "*", cwd=tmp_path)
    assert seen["arguments"] == ["two words", "", "*"]
    assert seen["folder"] == str(tmp_path)
    assert seen["prefix"] == str(ready.venv)
    assert ready.run("fail").returncode == 3


def test_an_interrupted_set_up_starts_over_and_two_at_once_make_one(quick: Any) -> None:
    first = quick.start()
    assert first.stderr is not None
    for line in first.stderr:
        if "[1/4]" in line:
            break
    os.killpg(first.pid, signal.SIGKILL)
    first.communicate(timeout=30)
    assert not (quick.venv / ".mansion-stamp").exists()

    pair = [quick.start(), quick.start()]
    outputs = [process.communicate(timeout=120) for process in pair]
    assert [process.returncode for process in pair] == [0, 0], outputs
    stderr = "".join(error for _, error in outputs)
    assert stderr.count("setting up") - stderr.count("is setting up") == 1
    assert stderr.count("is setting up") == stderr.count("waiting for it") == 1


def test_a_package_that_differs_from_the_lock_is_refused(quick: Any) -> None:
    quick.write_lock(digest="0" * 64)
    refused = quick.run()
    assert refused.returncode == 1 and refused.stdout == ""
    assert "differs from the lock file" in refused.stderr
    assert not (quick.venv / ".mansion-stamp").exists()
    assert not list(quick.venv.glob("lib/*/site-packages/brick*"))


def test_the_environment_is_made_anew_when_what_made_it_changes(ready: Any) -> None:

    def is_made_anew() -> bool:
        done = ready.run(MANSION_PYTHON="/nowhere/python3")
        assert done.returncode == (1 if "no Python" in done.stderr else 0)
        return done.returncode == 1

    assert not is_made_anew()
    ready.write_lock(note="changed")
    assert is_made_anew()
    ready.write_lock()
    assert not is_made_anew()
    added = ready.folder / "src" / "mansion_added"
    added.mkdir()
    (added / "setup.py").touch()
    assert is_made_anew()
    shutil.rmtree(added)
    assert not is_made_anew()
    python = ready.venv / "bin" / "python"
    target = python.readlink()
    python.unlink()
    python.symlink_to("/nowhere/python3")
    assert is_made_anew()
    python.unlink()
    python.symlink_to(target)
    assert not is_made_anew()


def test_without_a_network_it_says_so(quick: Any) -> None:
    lock = next((quick.folder / "requirements").glob("core-*.txt"))
    lock.write_text(f"--index-url http://127.0.0.1:9/simple\nbrick==1.0 --hash=sha256:{'0' * 64}\n", "utf-8")
    done = quick.run(HOSTTYPE="aarch64")
    assert done.returncode == 1
    assert "the package index cannot be reached" in done.stderr
    assert str(quick.venv / "setup.log") in done.stderr


def test_beside_a_sourced_ros_its_rclpy_is_used_and_the_wheels_are_left_out(fresh: Any) -> None:
    ros = fresh.folder.parent / "opt" / "ros"
    (ros / "rclpy").mkdir(parents=True)
    rclpy = ros / "rclpy" / "__init__.py"
    rclpy.touch()
    sourced = {"ROS_DISTRO": "jazzy", "AMENT_PREFIX_PATH": str(ros), "PYTHONPATH": str(ros)}
    seen = fresh.report(**sourced)
    assert seen["rclpy"] == str(rclpy)
    assert seen["prefix"] == str(fresh.folder / ".venv-ros")
    assert not list((fresh.folder / ".venv-ros").glob("lib/*/site-packages/rclpy*"))
    assert str(fresh.folder / "src" / "mansion_bringup") in seen["path"]
    settings = (fresh.folder / ".venv-ros" / "pyvenv.cfg").read_text(encoding="utf-8")
    assert "include-system-site-packages = true" in settings
    assert not fresh.venv.exists()
    assert fresh.run(**sourced).stderr == ""


def test_a_sourced_ros_that_does_not_import_is_reported_before_anything_is_made(fresh: Any) -> None:
    ros = fresh.folder.parent / "ros"
    (ros / "rclpy").mkdir(parents=True)
    (ros / "rclpy" / "__init__.py").write_text("raise ImportError('librcl.so is missing')", "utf-8")
    done = fresh.run(ROS_DISTRO="jazzy", AMENT_PREFIX_PATH=str(ros), PYTHONPATH=str(ros))
    assert done.returncode == 1
    assert "cannot import its rclpy" in done.stderr and "librcl.so is missing" in done.stderr
    assert not (fresh.folder / ".venv-ros").exists()


def test_a_place_that_cannot_be_written_is_named_with_the_way_out(fresh: Any) -> None:
    done = fresh.run(MANSION_VENV="/proc/nowhere/venv")
    assert done.returncode == 1
    assert "/proc/nowhere/venv" in done.stderr and "MANSION_VENV=" in done.stderr


def test_a_folder_that_is_not_its_own_is_left_alone(fresh: Any, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.tex").touch()
    done = fresh.run(MANSION_VENV=str(tmp_path / "mine"))
    assert done.returncode == 1 and "was not made by this launcher" in done.stderr
    assert (tmp_path / "mine" / "thesis.tex").exists()


def fake_python(folder: Path, lie: str) -> str:
    """A Python that runs `lie` before the script on its standard input."""
    python = folder / "python3"
    python.write_text(
        f'#!/bin/sh\nexec {sys.executable} -c "import sys; {lie}; exec(sys.stdin.read())"\n', encoding="utf-8"
    )
    python.chmod(0o755)
    return str(python)


def test_a_missing_venv_module_comes_with_the_command_that_installs_it(fresh, tmp_path: Path) -> None:
    python = fake_python(tmp_path, "sys.modules['venv'] = None")
    done = fresh.run(MANSION_PYTHON=python)
    assert done.returncode == 1
    assert f"sudo apt install python{sys.version_info.major}.{sys.version_info.minor}-venv" in done.stderr


def test_a_python_that_is_too_old_or_too_new_is_refused(fresh: Any, tmp_path: Path) -> None:
    for version in ("(3, 10, 12)", "(3, 14, 0)"):
        done = fresh.run(MANSION_PYTHON=fake_python(tmp_path, f"sys.version_info = {version}"))
        assert done.returncode == 1
        assert "no Python 3.11, 3.12 or 3.13 found" in done.stderr
    assert not fresh.venv.exists()
