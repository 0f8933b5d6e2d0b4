"""The wheels of ROS 2 import however Python starts, and leave nothing behind for the Pythons that it starts."""

import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

SITE = Path(sys.prefix, "lib", f"python{sys.version_info.major}.{sys.version_info.minor}", "site-packages")

pytestmark = pytest.mark.skipif(not (SITE / "_mansion_ros_wheels.py").exists(), reason="rclpy is not from wheels here")

USE = "import rclpy; from std_msgs.msg import String; rclpy.init(); print(rclpy.create_node('n').get_name())"
GUARD = "_ROS_WHEELS_BOOTSTRAP_COMPLETE"


def output(command: list[str], stdin: str | None = None, **environment: str) -> str:
    """Standard output of a command that must succeed."""
    done = subprocess.run(
        command, input=stdin, env={**os.environ, **environment}, capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_from_an_argument_standard_input_and_a_file(tmp_path: Path) -> None:
    script = tmp_path / "use.py"
    script.write_text(USE, encoding="utf-8")
    assert output([sys.executable, "-c", USE]) == "n\n"
    assert output([sys.executable], stdin=USE) == "n\n"
    assert output([sys.executable, "-"], stdin=USE) == "n\n"
    assert output([sys.executable, "-I", str(script)]) == "n\n"


def test_from_a_process_that_lives_as_long_as_a_kernel() -> None:
    cells = "import subprocess, sys\nprint(1, flush=True)\n" + USE + "\n"
    assert output([sys.executable, "-i", "-q"], stdin=cells, PYTHONSTARTUP="") == "1\nn\n"


def test_from_workers_of_multiprocessing_and_xdist(tmp_path: Path) -> None:
    program = textwrap.dedent("""
        import multiprocessing
        def name(_):
            import rclpy
            return rclpy.__name__
        if __name__ == "__main__":
            for method in ("spawn", "forkserver", "fork"):
                with multiprocessing.get_context(method).Pool(1) as pool:
                    print(pool.map(name, [0])[0])
    """)
    script = tmp_path / "pools.py"
    script.write_text(program, encoding="utf-8")
    assert output([sys.executable, str(script)]) == "rclpy\n" * 3
    test = tmp_path / "test_it.py"
    test.write_text(f"def test_it():\n    {USE}\n", encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-q", "-n", "2", "-p", "no:cacheprovider", str(test)]
    assert "1 passed" in output(command)


def test_no_python_is_started_twice_and_no_variable_is_set() -> None:
    program = f"import rclpy, os; print(os.getppid(), os.environ.get({GUARD!r}), os.environ.get('LD_LIBRARY_PATH'))"
    kept = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    done = subprocess.run(
        [sys.executable, "-c", program], env=kept, capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout == f"{os.getpid()} None None\n"


def test_the_guard_of_another_environment_changes_nothing() -> None:
    assert output([sys.executable, "-c", USE], **{GUARD: "1", "LD_LIBRARY_PATH": "/nowhere"}) == "n\n"


def test_another_python_started_from_here_is_left_as_it_is(tmp_path: Path) -> None:
    environment = tmp_path / "other"
    output([getattr(sys, "_base_executable", sys.executable), "-m", "venv", "--without-pip", str(environment)])
    inner = "import os; print(sorted(name for name in os.environ if 'ROS_WHEELS' in name or name.startswith('LD_')))"
    program = f"import rclpy, subprocess; subprocess.run([{str(environment / 'bin' / 'python')!r}, '-c', {inner!r}])"
    kept = {name: value for name, value in os.environ.items() if not name.startswith("LD_")}
    done = subprocess.run(
        [sys.executable, "-c", program], env=kept, capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout == "[]\n"


def test_a_sourced_rclpy_comes_first_and_loads_no_library_of_the_wheels(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("where = 'sourced'", encoding="utf-8")
    program = "import rclpy; print(rclpy.where, 'librcl.so' in open('/proc/self/maps').read())"
    assert output([sys.executable, "-c", program], PYTHONPATH=str(tmp_path)) == "sourced False\n"


def test_what_needs_no_graph_does_not_load_the_libraries() -> None:
    loaded = "'rclpy' in sys.modules, 'librcl.so' in open('/proc/self/maps').read()"
    program = f"import mansion_bringup.cli.app, sys; print({loaded})"
    assert output([sys.executable, "-c", program]) == "False False\n"
