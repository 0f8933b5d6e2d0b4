"""The scene editor as a process: its services, several clients at once, and what is on disk in the end."""

import os
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("rclpy")

from mansion_assets.catalogue import load_catalogue
from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene

pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
NODE = NodeProcess("mansion_editing", "scene_editor", "scene/open")
TABLE, DESK = "F1/kitchen/dining_table_1", "F2/private_office_1/office_desk_1"


@pytest.fixture
def server() -> Iterator[GraphProcesses]:
    """Return a running editor without hooks: the sample has no walls to export."""
    parameters = {"scene_editor": {"physics": "static", "hooks": "mansion_editing"}}
    options = GraphOptions(domain_id=free_domain(), parameters=parameters)
    with GraphProcesses(options, [NODE]) as running:
        running.wait_ready(60.0)
        yield running


def _objects(folder: Path, floor: int) -> list[str]:
    file = folder / f"floors/floor_{floor}/scene.json"
    return [item.id for item in decode(FloorScene, file.read_bytes()).objects]


def test_two_clients_and_a_command_line_keep_each_others_work(server: GraphProcesses, folder: Path) -> None:
    faults: list[BaseException] = []

    def work(name: str, asset: str, table: str) -> None:
        try:
            with MansionClient(domain_id=server.options.domain_id, timeout=60.0) as client:
                client.call("scene/open", {"path": str(folder), "editor": name, "who": name})
                for _ in range(4):
                    place = {"asset_id": asset, "receptacle_id": table, "editor": name}
                    assert client.call("scene/place_on_surface", place)["saved"]
        except BaseException as error:
            faults.append(error)

    def alone() -> None:
        try:
            store = BuildingStore(folder)
            editor = SceneEditor(store, load_catalogue(), StaticEngine(), who="cli")
            for state in (True, False, True):
                editor.call("SetState", {"object_id": "F1/kitchen/fridge_1", "open": state})
        except BaseException as error:
            faults.append(error)

    threads = [
        threading.Thread(target=work, args=("ann", "cola_can_1", TABLE)),
        threading.Thread(target=work, args=("ben", "Apple_1", TABLE)),
        threading.Thread(target=alone),
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(120.0)
    assert faults == []
    names = _objects(folder, 1)
    assert sum("/cola_can_" in name for name in names) == 4
    assert sum("/apple_" in name for name in names) == 4
    log = BuildingStore(folder).log()
    assert [entry.number for entry in log] == list(range(1, 12))
    assert {entry.who for entry in log} == {"ann", "ben", "cli"}
    scene = decode(FloorScene, (folder / "floors/floor_1/scene.json").read_bytes())
    assert scene.revision == 12


def test_an_instruction_a_refusal_and_an_undo_by_service(server: GraphProcesses, folder: Path) -> None:
    def call(name: str, **arguments: Any) -> Any:
        return client.call(f"scene/{name}", arguments)

    with MansionClient(domain_id=server.options.domain_id, timeout=60.0) as client:
        with pytest.raises(MansionError) as closed:
            call("list_objects", keyword="desk")
        assert closed.value.code == "NOT_LOADED"
        assert call("open", path=str(folder), who="ann")["floors"] == [1, 2]
        report = call("instruct", instruction="the desk upstairs needs a laptop and a pen")
        assert report["done"] and report["saved"] and report["edits"] == 2
        assert any("/laptop_" in name for name in _objects(folder, 2))
        with pytest.raises(MansionError) as refused:
            call("place_on_surface", asset_id="office_desk_1", receptacle_id=DESK)
        assert refused.value.code == "INFEASIBLE"
        assert call("check_path", end="private office")["reachable"]
        call("undo")
        assert not any("/laptop_" in name for name in _objects(folder, 2))


def test_a_task_is_made_possible_over_the_graph(server: GraphProcesses, folder: Path) -> None:
    need = {"noun": "pen", "relation": "on", "receptacle": "dining table", "room": "kitchen"}
    task = {"id": "pen", "kind": "deliver", "instruction": "Fetch the pen.", "needs": [need]}
    with MansionClient(domain_id=server.options.domain_id, timeout=60.0) as client:
        client.call("scene/open", {"path": str(folder)})
        first = client.call("scene/provision", {"task": task})
        assert first["done"] and first["saved"] and first["edits"] == 1
        (pen,) = first["object_ids"]
        assert pen in _objects(folder, 1)
        again = client.call("scene/provision", {"task": task})
        assert again["done"] and again["edits"] == 0
        absent = {**task, "needs": [{**need, "room": "ballroom"}]}
        refused = client.call("scene/provision", {"task": absent})
        assert not refused["done"] and "ballroom" in refused["message"]
        with pytest.raises(MansionError) as error:
            client.call("scene/provision", {"task": {"id": "pen"}})
        assert error.value.code == "INVALID_PAYLOAD"
    assert _objects(folder, 1).count(pen) == 1
