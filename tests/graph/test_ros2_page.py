"""The commands of docs/ros2.md do what the page says: ours on a running graph, those of ROS 2 where it is installed."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest.importorskip("rclpy")

from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest

pytestmark = pytest.mark.graph

PAGE = Path(__file__).parents[2] / "docs" / "ros2.md"
COMMANDS = [
    line.strip()
    for line in re.sub(r" \\\n +", " ", PAGE.read_text(encoding="utf-8")).splitlines()
    if line.startswith("    ")
]
OURS = [line for line in COMMANDS if line.startswith("mansion call")]
THEIRS = [line for line in COMMANDS if line.startswith("ros2 ") and "launch" not in line]
ENDLESS = ("ros2 bag record",)


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, str]]:
    """Two graphs of the page in one domain, and the buildings that it names."""
    root = tmp_path_factory.mktemp("tmp")
    office = BuildRequest(description="a two-storey office with an elevator", floor_area=150.0)
    build_building(office, root / "office", jobs=2)
    shutil.copytree(root / "office", root / "clinic")
    domain = free_domain()
    quiet = {"skill_server": {"camera": "false"}}
    graphs = [
        GraphProcesses(GraphOptions(namespace=namespace, domain_id=domain, parameters=quiet))
        for namespace in ("/mansion", "/site_b")
    ]
    with graphs[0], graphs[1]:
        for graph in graphs:
            graph.wait_ready(240.0)
        yield {**os.environ, "ROS_DOMAIN_ID": str(domain), "PAGE_TMP": str(root)}


def run(words: list[str], environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """Run a command."""
    return subprocess.run(words, env=environment, capture_output=True, text=True, timeout=120, check=False)


def placed(line: str, environment: dict[str, str]) -> str:
    """Return a command of the page with the folder /tmp of its own."""
    return line.replace("/tmp", environment["PAGE_TMP"])


def test_the_calls_of_the_page_are_answered(environment: dict[str, str]) -> None:
    assert len(OURS) >= 5
    for line in OURS:
        words = shlex.split(placed(line, environment))[1:]
        done = run([sys.executable, "-P", "-m", "mansion_bringup", *words], environment)
        assert done.returncode == 0, f"{line}: {done.stdout}{done.stderr}"


@pytest.mark.skipif(shutil.which("ros2") is None, reason="the ros2 tool is not installed")
@pytest.mark.parametrize("line", THEIRS)
def test_the_commands_of_ros_2_are_answered(line: str, environment: dict[str, str]) -> None:
    if line.startswith(ENDLESS):
        words = ["timeout", "--signal=INT", "10", *shlex.split(placed(line, environment))]
        run(words, environment)
        return
    done = run(["bash", "-c", placed(line, environment)], environment)
    assert done.returncode == 0, done.stderr
