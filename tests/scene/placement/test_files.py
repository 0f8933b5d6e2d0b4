"""Files of rooms: order, any number of processes, faults, and the measures over seeds."""

import json
from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.placement import PlacementResult
from mansion_msgs_py.world import Progress
from mansion_scene.placement.evaluation import bench, measure, table
from mansion_scene.placement.files import place_file
from mansion_scene.placement.picture import draw_placements
from placement_rooms import classroom, item, rectangle, restaurant, room, ward


def write(path: Path) -> Path:
    crossed = room([(0, 0), (2, 2), (2, 0), (0, 2)], [], [item("a", (1, 1, 1), 2)], kind="crossed")
    path.write_bytes(encode_bytes([classroom(), crossed, ward()]))
    return path


def without_seconds(path: Path) -> list[dict[str, object]]:
    return [{k: v for k, v in one.items() if k != "seconds"} for one in json.loads(path.read_bytes())]


def test_the_result_is_the_same_for_any_number_of_processes(tmp_path: Path) -> None:
    rooms = write(tmp_path / "rooms.json")
    seen: list[Progress] = []
    place_file(rooms, tmp_path / "one.json", seed=3, progress=seen.append)
    place_file(rooms, tmp_path / "two.json", seed=3, jobs=2)
    assert without_seconds(tmp_path / "one.json") == without_seconds(tmp_path / "two.json")
    assert [(p.done, p.total) for p in seen] == [(1, 3), (2, 3), (3, 3)]
    assert sorted(p.name for p in tmp_path.iterdir()) == ["one.json", "rooms.json", "two.json"]


def test_a_refused_room_keeps_its_place_with_the_reason(tmp_path: Path) -> None:
    results = place_file(write(tmp_path / "rooms.json"), tmp_path / "out.json")
    assert [r.room_id for r in results] == ["test/classroom", "test/crossed", "test/hospital_ward"]
    assert results[1].placements == []
    assert results[1].discarded[0].count == 2
    assert "polygon" in results[1].discarded[0].reason


@pytest.mark.parametrize("text", ["[{]", '[{"room_id": "a"}]', None])
def test_unreadable_rooms_leave_no_output(tmp_path: Path, text: str | None) -> None:
    if text is not None:
        (tmp_path / "rooms.json").write_text(text)
    with pytest.raises(MansionError):
        place_file(tmp_path / "rooms.json", tmp_path / "out.json")
    assert not (tmp_path / "out.json").exists()


def test_the_table_has_a_line_for_each_room_and_one_for_all() -> None:
    runs = bench([restaurant()], range(2))
    lines = table({name: [m for _, m in pairs] for name, pairs in runs.items()}).splitlines()
    assert len(lines) == 3
    assert lines[1].split()[1:5] == ["36", "36.0", "100.0", "100.0"]


def test_measures_find_what_is_wrong() -> None:
    asked = room(rectangle(4, 4), [((1, 0), (2, 0))], [item("box", (1, 1, 1), 2, "edge"), item("rug", (1, 1, 1))])
    result = msgspec.convert(
        {
            "room_id": asked.room_id,
            "placements": [
                {"id": "1", "name": "box", "center": [1.5, 0.5], "rotation": 0, "size": [1, 1, 1]},
                {"id": "2", "name": "box", "center": [2.0, 1.2], "rotation": 0, "size": [1, 1, 1]},
                {"id": "3", "name": "rug", "center": [4.2, 3.0], "rotation": 0, "size": [1, 1, 1]},
            ],
        },
        type=PlacementResult,
    )
    found = measure(asked, result)
    assert (found.outside, found.collisions, found.blocked) == (1, 1, 1)
    assert (found.edges, found.edges_backed) == (2, 1)
    assert found.usable == 0


def test_placements_can_be_drawn(tmp_path: Path) -> None:
    runs = bench([ward()], [0])
    draw_placements([ward()], [runs["test/hospital_ward"][0][0]], tmp_path / "ward.png", columns=1)
    assert (tmp_path / "ward.png").read_bytes()[:4] == b"\x89PNG"
