"""What other processes get from the server: the exported map, the world's clock, and two buildings side by side."""

import re
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_export.nav2 import map_pgm, map_yaml
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.scene import FloorScene
from sample_building import with_outer_walls, write_building

pytestmark = pytest.mark.graph

NODE = NodeProcess("mansion_skills", "skill_server", "load_building")

CLIENT = """
import sys
from mansion_bringup.client import MansionClient
domain, folder, session, mug = int(sys.argv[1]), *sys.argv[2:]
with MansionClient(domain_id=domain, timeout=30.0) as client:
    client.call("load_building", {"path": folder, "session": session, "reset": True})
    for _ in range(10):
        for skill, arguments in (
            ("go_near_object", {"object": mug}), ("pick_up", {"object": mug}),
            ("go_to_landmark", {"landmark": "office"}), ("place", {"target": "floor"}),
        ):
            client.call(f"skills/{skill}", {**arguments, "session": session})
    print(client.call(f"{session}/skills/where_am_i")["session"])
"""


@pytest.fixture(scope="module")
def running() -> Iterator[GraphProcesses]:
    options = GraphOptions(
        domain_id=free_domain(), parameters={"skill_server": {"publish_clock": "true", "motion": "fast"}}
    )
    with GraphProcesses(options, [NODE]) as processes:
        processes.wait_ready(60.0)
        yield processes


@pytest.fixture
def client(running: GraphProcesses) -> Iterator[MansionClient]:
    with MansionClient(domain_id=running.options.domain_id, timeout=30.0) as made:
        yield made


def next_message(client: MansionClient, kind: type, name: str, wanted: Callable[[Any], bool] = lambda _: True) -> Any:
    """Return the first message of a topic that is wanted."""
    got: list[Any] = []
    arrived = threading.Event()

    def keep(message: Any) -> None:
        if wanted(message) and not got:
            got.append(message)
            arrived.set()

    stop = client.subscribe(kind, name, keep)
    assert arrived.wait(15.0), f"nothing on {name}"
    stop()
    return got[0]


def trinary(image: bytes) -> np.ndarray[Any, Any]:
    """Read a PGM as ``nav2_map_server`` does, the lowest row first."""
    header = re.match(rb"P5\n(\d+) (\d+)\n255\n", image)
    assert header is not None
    shape = (int(header[2]), int(header[1]))
    shades = np.frombuffer(image[header.end() :], dtype=np.uint8).reshape(shape)[::-1]
    return np.select([shades == 254, shades == 0], [0, 100], -1)


def test_the_live_map_is_the_exported_one(client: MansionClient, tmp_path: Path) -> None:
    from nav_msgs.msg import OccupancyGrid

    folder = write_building(tmp_path / "walled", [1])
    (file,) = folder.glob("floors/*/scene.json")
    scene = with_outer_walls(decode(FloorScene, file.read_bytes()))
    file.write_bytes(encode_bytes(scene))
    client.call("load_building", {"path": str(folder)})
    grid = next_message(client, OccupancyGrid, "/map")
    live = np.array(grid.data).reshape(grid.info.height, grid.info.width)
    assert np.array_equal(live, trinary(map_pgm(scene)))
    place = grid.info.origin.position
    assert f"origin: [{place.x:g}, {place.y:g}, 0]" in map_yaml(scene)


def test_the_clock_goes_on_by_what_skills_take(client: MansionClient, tmp_path: Path) -> None:
    from rosgraph_msgs.msg import Clock

    client.call("load_building", {"path": str(write_building(tmp_path / "b", [1]))})

    def seconds(wanted: Callable[[float], bool] = lambda _: True) -> float:
        def read(message: Any) -> float:
            return float(message.clock.sec + message.clock.nanosec * 1e-9)

        return read(next_message(client, Clock, "/clock", lambda m: wanted(read(m))))

    assert seconds() == 0.0
    assert seconds() == 0.0, "nothing happens, so no time passes"
    client.call("skills/rotate", {"degrees": 180})
    assert seconds(lambda now: now > 0.0) == pytest.approx(2.0, abs=0.01)
    client.call("skills/move_ahead", {"distance": 1.0})
    assert seconds(lambda now: now > 2.5) == pytest.approx(4.0, abs=0.01)


def test_two_client_processes_work_in_two_buildings_at_once(running: GraphProcesses, tmp_path: Path) -> None:
    domain = str(running.options.domain_id)
    clients = [
        subprocess.Popen(
            [
                sys.executable,
                "-c",
                CLIENT,
                domain,
                str(write_building(tmp_path / name, [1, 2])),
                name,
                "F1/office/mug_1",
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        for name in ("left", "right")
    ]
    for process, name in zip(clients, ("left", "right")):
        out, err = process.communicate(timeout=90)
        assert process.returncode == 0, err
        assert out.strip() == name
