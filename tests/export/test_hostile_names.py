"""What a building calls its rooms and itself stays text in pages, pictures and models."""

import re
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import msgspec
import pytest

from mansion_bringup.cli.app import app
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import INDEX, BuildingFolder, floor_directory
from mansion_msgs_py.codec import encode_bytes
from sample_building import write_building

EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(2)>\"'&]]>"


@pytest.fixture
def hostile(tmp_path: Path) -> Path:
    """A building whose rooms, floors and brief are markup."""
    folder = write_building(tmp_path / "hostile")
    building = BuildingFolder(folder)
    for floor in building.floors:
        scene = building.scene(floor)
        rooms = [msgspec.structs.replace(room, name=EVIL) for room in scene.rooms]
        scene = msgspec.structs.replace(scene, rooms=rooms)
        (folder / floor_directory(floor) / "scene.json").write_bytes(encode_bytes(scene))
    program = msgspec.structs.replace(building.building.program, description=EVIL, building_type=EVIL)
    entries = [msgspec.structs.replace(entry, label=EVIL) for entry in building.building.floors]
    index: Building = msgspec.structs.replace(building.building, program=program, floors=entries)
    (folder / INDEX).write_bytes(encode_bytes(index))
    return folder


def run(monkeypatch: pytest.MonkeyPatch, *words: str) -> None:
    monkeypatch.setattr(sys, "argv", ["mansion", *words])
    app(standalone_mode=False)


def test_names_are_no_markup(hostile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from mansion_export.plan import plan_svg

    run(monkeypatch, "view", str(hostile))
    for form in ("sdf", "mjcf"):
        run(monkeypatch, "export", str(hostile), "--to", form)
    (hostile / "plan.svg").write_text(plan_svg(BuildingFolder(hostile).scene(1)))
    pages = {file: file.read_text() for file in hostile.rglob("*") if file.suffix in (".html", ".svg", ".sdf", ".xml")}
    assert {file.suffix for file in pages} == {".html", ".svg", ".sdf", ".xml"}
    for file, text in pages.items():
        assert "<img" not in text and "alert(1)</script>" not in text, file
        if file.suffix != ".html":
            ET.fromstring(text)


def test_the_page_loads_nothing_from_elsewhere(hostile: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run(monkeypatch, "view", str(hostile))
    page = (hostile / "view.html").read_text()
    assert re.findall(r"""(?:src|href|url|fetch|import)\s*[=(]\s*["']?\s*(?:https?:)?//""", page) == []
    assert "http" not in re.sub(r"http://www\.w3\.org/\S+", "", page)
