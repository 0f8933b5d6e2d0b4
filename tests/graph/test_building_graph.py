"""Algorithm 1 through real node processes: same bytes, errors that name the stage, nodes that outlive faults."""

import hashlib
import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.processes import GraphProcesses
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import topic
from mansion_msgs_py.nodes.shell import JsonPublisher
from mansion_msgs_py.request import BuildRequest, Footprint
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.world import Progress
from sample_models import write_library

pytestmark = pytest.mark.graph

FLAT = "a small flat for two"
HOUSE = "a two-storey house with three bedrooms"


@pytest.fixture(scope="module")
def client(graph: GraphProcesses) -> Iterator[MansionClient]:
    with MansionClient(domain_id=graph.options.domain_id, timeout=120.0) as client:
        yield client


def digest(folder: Path) -> dict[str, str]:
    """Hash of every file of a building but the report, which holds times."""
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name != "report.json"
    }


def test_the_graph_and_one_process_write_the_same_bytes(client: MansionClient, tmp_path: Path) -> None:
    formats = ["mjcf", "nav2"]
    reply = client.build(HOUSE, seed=5, output=str(tmp_path / "graph"), formats=formats)
    local = build_building(BuildRequest(description=HOUSE, seed=5), tmp_path / "local", jobs=2, formats=formats)
    assert digest(Path(reply.path)) == digest(local.path)
    assert {"floors/floor_2/model.xml", "floors/floor_2/map.pgm"} < set(digest(local.path))
    assert "building.glb" not in digest(local.path)


def test_own_assets_come_first_in_a_building_of_the_graph(client: MansionClient, tmp_path: Path) -> None:
    brief, assets = "a small flat with an espresso bar in the living room", [write_library(tmp_path / "shop")]
    reply = client.build(brief, output=str(tmp_path / "graph"), assets=assets)
    local = build_building(BuildRequest(description=brief, assets=tuple(assets)), tmp_path / "local")
    assert digest(Path(reply.path)) == digest(local.path)
    assert {"assets/shop.espresso_bar.glb", "assets/shop.sofa.glb"} < set(digest(local.path))


def test_a_format_that_does_not_exist_is_refused_with_those_that_do(client: MansionClient) -> None:
    with pytest.raises(MansionError, match="no format 'clay'; use all, or some of thor, plan") as caught:
        client.build(FLAT, formats=["clay"])
    assert (caught.value.code, caught.value.info.path) == ("NOT_FOUND", "$.formats")


def test_two_builds_at_the_same_time_do_not_mix(client: MansionClient, tmp_path: Path) -> None:
    briefs = {"flat": FLAT, "house": HOUSE}
    threads = [
        threading.Thread(target=client.build, args=(brief,), kwargs={"output": str(tmp_path / name), "seed": 1})
        for name, brief in briefs.items()
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=120.0)
    for name, brief in briefs.items():
        alone = build_building(BuildRequest(description=brief, seed=1), tmp_path / f"{name}_alone")
        assert digest(tmp_path / name) == digest(alone.path)


def test_a_request_by_topic_ends_as_latched_scenes(graph: GraphProcesses) -> None:
    request = BuildRequest(description=HOUSE, seed=9, building_id="by_topic")
    scenes: dict[int, FloorScene] = {}
    complete = threading.Event()

    def keep(text: str) -> None:
        scene = decode(FloorScene, text)
        if scene.building_id == "by_topic":
            scenes[scene.floor] = scene
            if len(scenes) == scene.floors:
                complete.set()

    with MansionClient(domain_id=graph.options.domain_id) as sender:
        publisher = JsonPublisher(sender.node, topic("build_requests"))
        assert wait_until(lambda: publisher.publisher.get_subscription_count() > 0)
        done = threading.Event()
        sender.listen("progress", lambda text: done.set() if finished(text, "by_topic") else None)
        publisher.publish(request)
        assert done.wait(60.0)
    with MansionClient(domain_id=graph.options.domain_id) as late_joiner:
        late_joiner.listen("floor_scene", keep)
        assert complete.wait(20.0)
    assert sorted(scenes) == [1, 2]


def finished(text: str, building_id: str) -> bool:
    progress = decode(Progress, text)
    return progress.building_id == building_id and progress.stage == "done"


def wait_until(condition: object, seconds: float = 10.0) -> bool:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():  # type: ignore[operator]
            return True
        time.sleep(0.02)
    return False


@pytest.mark.parametrize(
    ("service", "arguments", "code", "path"),
    [
        ("solve_floor", {"boundary": [[0, 0]], "nodes": []}, ErrorCode.INVALID_PAYLOAD, "$.boundary"),
        ("build_building", {"descripton": "x"}, ErrorCode.INVALID_PAYLOAD, "$.descripton"),
        ("load_building", {"path": "/nowhere"}, ErrorCode.NOT_FOUND, "$.path"),
    ],
)
def test_bad_calls_are_answered_with_the_error_object(
    client: MansionClient, service: str, arguments: object, code: str, path: str
) -> None:
    with pytest.raises(MansionError) as caught:
        client.call(service, arguments)
    assert (caught.value.code, caught.value.info.path) == (code, path)


def test_a_stage_that_refuses_is_named_and_every_node_lives_on(
    client: MansionClient, graph: GraphProcesses, tmp_path: Path
) -> None:
    with pytest.raises(MansionError) as caught:
        client.build("a hospital", area=12.0, floors=9, output=str(tmp_path / "none"))
    assert caught.value.stage == "plan_program"
    assert not (tmp_path / "none").exists()
    assert graph.ended() == {}
    assert client.build(FLAT, output=str(tmp_path / "flat")).building.floors


def test_a_node_killed_in_the_middle_is_reported_and_the_next_build_works(
    client: MansionClient, graph: GraphProcesses, tmp_path: Path
) -> None:
    victim = graph.running["object_placer"].pid
    started = threading.Event()
    client.listen("progress", lambda text: started.set() if "solve_floor" in text else None)
    killer = threading.Thread(target=lambda: started.wait(60) and os.kill(victim, signal.SIGKILL))
    killer.start()
    with pytest.raises(MansionError) as caught:
        client.build("a six-storey office", seed=2, output=str(tmp_path / "office"))
    killer.join()
    assert caught.value.code == ErrorCode.UNAVAILABLE
    assert caught.value.stage.startswith("furnish_floor")
    assert not (tmp_path / "office").exists()
    graph.running["object_placer"].wait(timeout=10)
    graph.start("object_placer")
    graph.wait_ready(30.0)
    assert client.build("a six-storey office", seed=2, output=str(tmp_path / "office")).building


def test_a_build_is_cancelled_by_its_folder_while_another_goes_on(client: MansionClient, tmp_path: Path) -> None:
    ends: dict[str, str] = {}

    def build(name: str, brief: str) -> None:
        try:
            ends[name] = client.build(brief, output=str(tmp_path / name), building_id=name).path
        except MansionError as error:
            ends[name] = error.code

    begun = threading.Event()
    client.listen("progress", lambda text: begun.set() if decode(Progress, text).building_id == "tower" else None)
    briefs = {"tower": "a sixteen-storey office with an elevator", "flat": FLAT}
    threads = [threading.Thread(target=build, args=entry) for entry in briefs.items()]
    for thread in threads:
        thread.start()
    assert begun.wait(60.0)
    reply = client.call("cancel_build", {"output": str(tmp_path / "tower")})
    assert reply == {"builds": [{"building_id": "tower", "path": str(tmp_path / "tower")}]}
    for thread in threads:
        thread.join(timeout=120.0)
    assert ends == {"tower": ErrorCode.CANCELED, "flat": str(tmp_path / "flat")}
    assert not (tmp_path / "tower").exists()
    assert client.call("cancel_build", {}) == {"builds": []}
    assert client.build(FLAT, output=str(tmp_path / "tower"), building_id="tower").building.floors


def test_a_plan_is_given_up_when_its_build_is_cancelled(client: MansionClient, tmp_path: Path) -> None:
    long_brief = "a house with a kitchen next to the garden room and two bedrooms of 12 m2 upstairs. " * 200
    ends: list[MansionError] = []

    def build() -> None:
        with pytest.raises(MansionError) as ended:
            client.build(long_brief, output=str(tmp_path / "house"), building_id="long")
        ends.append(ended.value)

    begun = threading.Event()
    client.listen("progress", lambda text: begun.set() if decode(Progress, text).building_id == "long" else None)
    building = threading.Thread(target=build)
    building.start()
    assert begun.wait(60.0)
    assert wait_until(lambda: client.call("cancel_plan", {"building_id": "long"})["plans"])
    building.join(timeout=60.0)
    assert [(end.code, end.stage) for end in ends] == [(ErrorCode.CANCELED, "plan_program")]
    building = threading.Thread(target=build)
    building.start()
    assert wait_until(lambda: client.call("cancel_build", {"building_id": "long"})["builds"])
    building.join(timeout=60.0)
    assert [end.code for end in ends[1:]] == [ErrorCode.CANCELED]
    # The planner is free for others: it plans one building after the other.
    assert client.call("plan_program", BuildRequest(description=FLAT), timeout=60.0)
    assert client.call("cancel_plan", {}) == {"plans": []}


def test_an_instruction_is_given_up_when_it_is_cancelled(client: MansionClient, tmp_path: Path) -> None:
    built = client.build(FLAT, output=str(tmp_path / "flat"))
    client.call("scene/open", {"path": built.path, "editor": "long"})
    ends: list[MansionError] = []

    def instruct() -> None:
        instruction = "Put a book on the floor of the living room. " * 90
        with pytest.raises(MansionError) as ended:
            client.call("scene/instruct", {"editor": "long", "instruction": instruction}, timeout=120.0)
        ends.append(ended.value)

    editing = threading.Thread(target=instruct)
    editing.start()
    assert wait_until(lambda: client.call("scene/cancel", {"editor": "long"})["editors"])
    editing.join(timeout=60.0)
    assert [end.code for end in ends] == [ErrorCode.CANCELED]
    assert client.call("scene/diff", {"editor": "long"})["changes"] == []
    assert client.call("scene/cancel", {}) == {"editors": []}


def test_the_robot_rides_the_lift_through_services(client: MansionClient, tmp_path: Path) -> None:
    built = client.build("a three-storey office with an elevator", output=str(tmp_path / "office"))
    client.call("load_building", {"path": built.path})
    with pytest.raises(MansionError) as refused:
        client.call("skills/use_elevator", {"target_floor": 3})
    assert refused.value.code == "PRECONDITION_FAILURE"
    client.call("skills/go_to_landmark", {"landmark": "elevator"})
    client.call("skills/call_elevator")
    client.call("skills/use_elevator", {"target_floor": 3})
    assert client.call("skills/where_am_i")["floor"] == 3


def test_a_large_payload_crosses_whole(client: MansionClient) -> None:
    # Points on the edges of a rectangle: a hundred thousand characters that say no more than its corners.
    sides = [(x / 1000, 0.0) for x in range(0, 12000, 2)] + [(12.0, y / 1000) for y in range(0, 8000, 2)]
    footprint = Footprint(boundary=[*sides, (12.0, 8.0), (0.0, 8.0)])
    request = BuildRequest(description="a small flat", footprint=footprint)
    assert len(encode(request)) > 100_000
    reply = client.call("plan_program", request)
    assert len(encode(reply)) > 1000
