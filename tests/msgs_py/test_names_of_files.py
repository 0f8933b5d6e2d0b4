"""A payload that names a file names one in its own folder."""

from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.building_folder import file_in
from mansion_msgs_py.codec import decode, encode_bytes, to_builtins
from mansion_msgs_py.editing.changes import DocumentChange
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import FileInFolder
from mansion_msgs_py.task import TaskSet

OUTSIDE = ["/etc/passwd", "..", "../other/report.json", "a/../../b", "floors/..", "a\\..\\b", "a\x00b", "\n/../../x"]
INSIDE = ["", "report.json", "floors/floor_-1/scene.json", "..a/b..", "a/...", "plan v2 (draft).svg"]


@pytest.mark.parametrize("name", OUTSIDE)
def test_what_leads_out_of_a_folder_is_refused(name: str) -> None:
    with pytest.raises(MansionError, match="a path inside the folder") as caught:
        decode(FileInFolder, encode_bytes(name))
    assert caught.value.code == ErrorCode.INVALID_PAYLOAD


@pytest.mark.parametrize("name", INSIDE)
def test_what_lies_in_a_folder_is_accepted(name: str) -> None:
    assert decode(FileInFolder, encode_bytes(name)) == name


@pytest.mark.parametrize("name", ["/x", "../x", "link/x", "floors/link/x"])
def test_nothing_is_written_outside_of_a_folder(tmp_path: Path, name: str) -> None:
    folder = tmp_path / "building"
    (folder / "floors").mkdir(parents=True)
    (folder / "link").symlink_to(tmp_path)
    (folder / "floors" / "link").symlink_to("/")
    with pytest.raises(MansionError, match="leads out of"):
        file_in(folder, name)
    assert file_in(folder, "floors/new/x") == folder / "floors/new/x"


def test_a_folder_may_itself_be_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to("real")
    assert file_in(tmp_path / "link", "x") == tmp_path / "link" / "x"


@pytest.mark.parametrize("kind", [Building, FloorScene, TaskSet])
def test_an_id_that_becomes_a_name_of_a_file_is_no_path(kind: type[msgspec.Struct]) -> None:
    with pytest.raises(MansionError) as caught:
        decode(kind, encode_bytes({"building_id": "../x", "building": "b", "tasks": []}))
    assert caught.value.info.path == "$.building_id"


def test_files_of_floors_and_documents_of_edits_stay_in_the_folder() -> None:
    entry = FloorEntry(floor=1, label="1", elevation=0, height=3, area=1, rooms=1, objects=0, files={"scene": "../x"})
    with pytest.raises(MansionError, match="inside the folder"):
        decode(FloorEntry, encode_bytes(entry))
    for fields in ({"path": "../x"}, {"path": "x", "after": "../../secret"}):
        with pytest.raises(MansionError):
            decode(DocumentChange, encode_bytes(to_builtins(fields)))
