"""A plan that the user has becomes a building that passes the check, in scripts, lists and on the command line."""

import json
from collections import Counter
from pathlib import Path

import pytest
from shapely.geometry import Polygon
from typer.testing import CliRunner

import mansion
from mansion_bringup.cli.app import app
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.request import BuildRequest, building_id_of
from mansion_planner.plan import plan_building
from mansion_planner.plan_files import read_plan
from mansion_world.brief_files import read_briefs

PLANS = Path(__file__).parents[3] / "examples" / "plans"


@pytest.fixture(scope="module")
def house(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example of two storeys, built."""
    request = BuildRequest(description="", plan=read_plan(PLANS / "house.json"))
    return build_building(request, tmp_path_factory.mktemp("plans") / "house", formats=["nav2"]).path


def test_a_house_of_two_storeys_passes_the_check(house: Path) -> None:
    assert verify_building(house) == []
    folder = BuildingFolder(house)
    scenes = folder.scenes()
    assert [len(scene.rooms) for scene in scenes] == [7, 6]
    assert [core.id for scene in scenes for core in scene.cores] == ["stair_1", "stair_1"]
    assert all(wish.status == "met" for wish in folder.building.wishes)
    assert len([room for room in scenes[1].rooms if room.name.startswith("Bedroom")]) == 2


def test_its_rooms_and_doors_are_where_the_plan_has_them(house: Path) -> None:
    ground = BuildingFolder(house).scenes()[0]
    study = next(room for room in ground.rooms if room.name == "Study")
    assert Polygon(study.polygon).equals(Polygon([(6, 2), (10, 2), (10, 5), (6, 5)]))
    entrance = next(door for door in ground.doors if door.kind == "entrance")
    assert sorted(round(x, 3) for x, _ in entrance.segment) == [4.4, 5.5]


def test_it_is_edited_and_walked_like_any_other(house: Path, tmp_path: Path) -> None:
    building = mansion.load(house).save(tmp_path / "house")
    before = [(window.wall, window.segment) for window in BuildingFolder(building.folder).scenes()[0].windows]
    building.edit("put a red mug on the table in the kitchen")
    building.edit("add a door between the study and the WC")
    assert verify_building(building.folder) == []
    after = [(window.wall, window.segment) for window in BuildingFolder(building.folder).scenes()[0].windows]
    assert after == before
    assert "study" in building.robot().go_to("study").message.lower()


def test_the_command_line_tells_every_fault_and_ends_with_status_2(tmp_path: Path) -> None:
    plan = json.loads((PLANS / "flat.json").read_text())
    del plan["floors"][0]["doors"][0]
    plan["floors"][0]["doors"].pop()
    file = tmp_path / "flat.json"
    file.write_text(json.dumps(plan))
    runner = CliRunner()
    refused = runner.invoke(app, ["plan", "--plan", str(file)])
    assert getattr(refused.exception, "code", "") == "INFEASIBLE"
    assert len(refused.exception.info.details["faults"]) == 2  # type: ignore[union-attr]
    completed = runner.invoke(app, ["plan", "--plan", str(file), "--complete", "doors"])
    assert completed.exit_code == 0
    assert "added (no door leads outside)" in completed.stdout


@pytest.mark.parametrize("option", [["--complete", "doors"], ["--layers", "rooms=A"]])
def test_options_of_a_plan_without_a_plan_are_refused(option: list[str], tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["build", "a flat", "-o", str(tmp_path / "x"), *option])
    assert f"{option[0]} needs a plan" in str(done.exception)


def test_a_list_of_plans(tmp_path: Path) -> None:
    (tmp_path / "flat.json").write_bytes((PLANS / "flat.json").read_bytes())
    (tmp_path / "list.csv").write_text("name,plan,brief\none,flat.json,\ntwo,flat.json,a flat in Japanese style\n")
    one, two = read_briefs(tmp_path / "list.csv", read_plan=read_plan)
    assert one.request.plan == two.request.plan == read_plan(tmp_path / "flat.json")
    assert (one.request.description, two.request.description) == ("", "a flat in Japanese style")
    assert building_id_of(one.request) != building_id_of(two.request)


def test_a_script_gives_a_plan_as_values(tmp_path: Path) -> None:
    plan = json.loads((PLANS / "flat.json").read_text())
    building = mansion.build(plan=plan, folder=tmp_path / "flat", complete=["windows"])
    assert building.rooms["kitchen"].area == pytest.approx(12.0)
    assert verify_building(building.folder) == []


def test_a_building_that_goes_through_ifc_keeps_its_rooms_doors_and_windows(house: Path, tmp_path: Path) -> None:
    pytest.importorskip("ifcopenshell", reason="needs the extra ifc")
    runner = CliRunner()
    assert runner.invoke(app, ["export", str(house), "--to", "ifc", "-o", str(tmp_path)]).exit_code == 0
    reply = plan_building(BuildRequest(description="", plan=read_plan(tmp_path / "building.ifc")))
    for scene, program, problem in zip(
        BuildingFolder(house).scenes(), reply.program.floors, reply.problems, strict=True
    ):
        drawn = {room.id: Polygon(room.polygon) for room in problem.fixed_rooms}
        assert drawn.keys() == {bare(room.id) for room in scene.rooms}
        for room in scene.rooms:
            assert drawn[bare(room.id)].symmetric_difference(Polygon(room.polygon)).area < 0.01 * room.area
        assert {room.id: room.room_type for room in program.rooms} == {
            bare(room.id): room.room_type for room in scene.rooms
        }
        assert program.openings is not None
        kept = Counter(frozenset(door.rooms) for door in program.openings.doors)
        assert kept == Counter(frozenset(name and bare(name) for name in door.rooms) for door in scene.doors)
        assert len(program.openings.windows or ()) == len(scene.windows)


def bare(name: str) -> str:
    """Return an id without its floor."""
    return name.rpartition("/")[2]
