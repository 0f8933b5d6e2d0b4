"""A format is registered once; command line, its help, the build's files and the documentation follow."""

import re
import subprocess
import sys
from pathlib import Path
from pkgutil import resolve_name

import pytest

from mansion_bringup.exporting import write_export
from mansion_export import formats
from mansion_export.formats import (
    ExportOptions,
    Format,
    Output,
    export_formats,
    formats_of_build,
    outputs_of_build,
    register,
)
from mansion_msgs_py.building_folder import BuildingFolder, floor_directory
from mansion_msgs_py.errors import MansionError
from sample_building import write_building

PAGE = (Path(__file__).parents[2] / "docs" / "exports.md").read_text()

FORMAT = '''
"""The names of rooms, a line for each."""

from mansion_export.formats import ExportOptions, Format, Output, register


def floor_names(scene):
    return {f"floors/floor_{scene.floor}/rooms.txt": "\\n".join(room.id for room in scene.rooms).encode()}


def all_names(scenes):
    return {"rooms.txt": "\\n".join(room.id for scene in scenes for room in scene.rooms).encode()}


register(
    Format(
        "rooms",
        "names of rooms",
        building=Output("room_names:all_names", ("rooms.txt",)),
        floor=Output("room_names:floor_names", ("rooms.txt",), ("rooms",)),
    )
)
'''


@pytest.fixture
def registered(tmp_path, monkeypatch):
    """A module outside the package that registers a format of its own, for the length of a test."""
    (tmp_path / "room_names.py").write_text(FORMAT)
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(formats, "_formats", export_formats())
    resolve_name("room_names")
    yield tmp_path
    sys.modules.pop("room_names")


def test_a_registered_format_makes_its_files(registered, ground):
    made = export_formats()["rooms"].make([ground])
    names = "\n".join(room.id for room in ground.rooms).encode()
    assert made == {"rooms.txt": names, f"{floor_directory(ground.floor)}/rooms.txt": names}


def test_a_build_that_is_asked_for_a_registered_format_writes_and_names_the_files_that_have_keys(registered):
    from mansion_bringup.building.files import building_file_names, floor_file_names

    for names in (["rooms"], ["all"], ["all", "rooms", "glb"]):
        outputs = outputs_of_build(names)
        assert floor_file_names(outputs.floor)["rooms"] == "rooms.txt"
        assert "rooms.txt" not in building_file_names(outputs.building).values()
        assert "room_names:all_names" not in {output.function for output in outputs.building}
    assert "rooms" not in floor_file_names(outputs_of_build().floor)


def test_an_edit_makes_a_registered_format_anew_where_the_folder_has_it(registered, tmp_path):
    from mansion_bringup.building.files import kept_files

    folder = write_building(tmp_path / "building")
    scenes = BuildingFolder(folder).scenes()
    assert kept_files(folder, scenes, [1]) == {}
    there = folder / floor_directory(2) / "rooms.txt"
    there.write_text("of old")
    assert list(kept_files(folder, scenes, [1])) == [f"{floor_directory(1)}/rooms.txt"]
    assert kept_files(folder, scenes, []) == {}
    (folder / "rooms.txt").write_text("of old")
    assert "rooms.txt" not in kept_files(folder, scenes, [1, 2])


def test_every_build_writes_what_people_look_at_and_all_adds_what_the_index_has_keys_for():
    assert [each.name for each in formats_of_build()] == ["plan", "overview"]
    assert [each.name for each in formats_of_build(["all"])] == ["thor", "plan", "nav2", "mjcf", "glb", "overview"]


def test_a_build_writes_all_of_a_format_that_has_no_keys():
    assert [output.files for output in outputs_of_build(["html"]).building] == [("building.png",), ("view.html",)]
    assert [output.files for output in outputs_of_build(["glb"]).building] == [("building.glb",), ("building.png",)]


def test_a_build_is_told_which_formats_there_are():
    with pytest.raises(MansionError, match=r"no format 'clay', 'stone'; use all, or some of thor, plan") as error:
        formats_of_build(["glb", "stone", "clay"])
    assert (error.value.code, error.value.info.path) == ("NOT_FOUND", "$.formats")


def test_the_command_line_offers_a_registered_format(registered, tmp_path):
    script = "import room_names; from mansion_bringup.cli.app import app; app()"

    def mansion(*arguments: str) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", script, *arguments]
        return subprocess.run(command, cwd=registered, capture_output=True, text=True, timeout=120)

    listed = re.sub(r"[\s│|]+", " ", mansion("export", "--help").stdout)
    assert ", ".join(export_formats()) in listed
    folder = write_building(tmp_path / "building")
    done = mansion("export", str(folder), "--to", "rooms")
    assert done.returncode == 0, done.stderr
    assert (folder / "rooms.txt").read_text().splitlines() == [
        room.id for scene in BuildingFolder(folder).scenes() for room in scene.rooms
    ]
    unknown = mansion("export", str(folder), "--to", "stone")
    assert unknown.returncode and "rooms" in unknown.stderr


def test_a_name_is_taken_once():
    with pytest.raises(ValueError, match="already called 'thor'"):
        register(Format("thor", "another"))


def test_files_and_keys_are_as_many():
    with pytest.raises(ValueError, match="2 files have 1 keys"):
        register(Format("two", "two files", floor=Output("two:files", ("a", "b"), ("a",))))


@pytest.mark.parametrize("entry", export_formats().values(), ids=lambda entry: entry.name)
def test_every_format_can_be_imported_and_stands_on_the_page(entry):
    outputs = [output for output in (entry.building, entry.floor) if output is not None]
    for output in outputs:
        assert callable(resolve_name(output.function))
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in PAGE.splitlines() if line.startswith("| `")]
    (row,) = [row for row in rows if row[0] == f"`{entry.name}`"]
    paths = [*(entry.building.files if entry.building else ())]
    paths += [f"floors/floor_N/{name}" for name in (entry.floor.files if entry.floor else ())]
    built = [name for output in outputs if output.keys for name in output.files]
    when = "always" if entry.always else "asked, or with all" if built else "asked"
    assert row[1] == entry.title
    assert re.findall(r"`([^`]+)`", row[3]) == paths
    assert re.findall(r"`([^`]+)`", row[4]) == built
    assert row[5] == when


def test_joints_are_made_where_a_format_has_them_and_refused_elsewhere(tmp_path):
    assert [name for name, entry in export_formats().items() if entry.takes("articulated")] == ["mjcf", "sdf", "usd"]
    with pytest.raises(MansionError, match="plan has no joints; use one of mjcf, sdf, usd"):
        write_export(tmp_path, export_formats()["plan"], options=ExportOptions(articulated=True))


def test_the_plot_is_left_out_where_it_is_not_wanted(building):
    sited = [name for name, entry in export_formats().items() if entry.takes("site")]
    assert sited == ["glb", "overview", "html", "sdf", "usd"]
    for name in ("glb", "sdf"):
        data = [
            b"".join(export_formats()[name].make(building, ExportOptions(site=site)).values()) for site in (True, False)
        ]
        assert b"/plot/lawn" in data[0]
        assert b"/plot/lawn" not in data[1]
