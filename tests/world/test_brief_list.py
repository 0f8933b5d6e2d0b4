"""The briefs of a list become buildings, each under its name; what fails is told and costs nothing else."""

from collections.abc import Callable
from concurrent.futures import Executor
from contextlib import AbstractContextManager
from pathlib import Path

import pytest
from typer.testing import CliRunner

import mansion
from mansion_bringup.cli.app import app
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_world.brief_files import read_briefs
from mansion_world.brief_list import BriefList, Result, results
from mansion_world.making import WorldProgress, make_world
from mansion_world.world_folder import WorldFolder
from sample_models import write_library

Build = Callable[[BuildRequest, Path], None]
Threads = Callable[[int], Callable[[], AbstractContextManager[Executor]]]

STUDIO = "A studio flat."


def written(folder: Path, name: str, text: str) -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def make(
    folder: Path, file: Path, build: Build, threads: Threads, jobs: int = 1
) -> tuple[WorldProgress, dict[str, Result]]:
    briefs = BriefList.of(read_briefs(file))
    made = make_world(
        folder, len(briefs), requests=briefs, build=build, check=lambda folder: [], workers=threads(jobs), jobs=jobs
    )
    return made, {row.name: row for row in results(WorldFolder(folder), briefs)}


def test_a_text_has_a_brief_a_line(tmp_path: Path) -> None:
    file = written(tmp_path, "briefs.txt", f"# homes\n{STUDIO}\n\n  - two floors\n")
    assert [row.request.description for row in read_briefs(file)] == [STUDIO, "- two floors"]


def test_rows_say_what_a_request_may_say_and_defaults_fill_the_rest(tmp_path: Path) -> None:
    written(tmp_path, "l.json", '{"boundary": [[0, 0], [9, 0], [9, 7], [0, 7]]}')
    file = written(
        tmp_path,
        "briefs.csv",
        'name,brief,floors,floor_area,seed,footprint\nhome,"a flat, for two",2,80.5,4,\n,a clinic,,,,l.json\n',
    )
    home, clinic = read_briefs(file, BuildRequest(description="", seed=9, area=500.0))
    assert (home.name, clinic.name) == ("home", "")
    assert home.request == BuildRequest(description="a flat, for two", floors=2, floor_area=80.5, seed=4)
    assert (clinic.request.seed, clinic.request.area) == (9, 500.0)
    assert clinic.request.footprint is not None
    lines = written(
        tmp_path, "briefs.jsonl", '{"brief": "a flat, for two", "floors": 2, "floor_area": 80.5, "seed": 4}'
    )
    assert [row.request for row in read_briefs(lines)] == [home.request]


def test_rows_name_libraries_by_paths_from_their_file_and_defaults_fill_the_rest(tmp_path: Path) -> None:
    shop, lab = write_library(tmp_path / "shop"), write_library(tmp_path / "lab")
    text = f'brief,assets\na flat,"./shop, {lab}"\na clinic,\n'
    flat, clinic = read_briefs(written(tmp_path, "briefs.csv", text), BuildRequest(description="", assets=(lab,)))
    assert (flat.request.libraries, clinic.request.libraries) == ((shop, lab), (lab,))
    lines = written(tmp_path, "briefs.jsonl", '{"brief": "a flat", "assets": ["./shop", "./lab"]}')
    assert read_briefs(lines)[0].request == flat.request


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "brief,floors\na flat,two\n", r"a\.csv:2: Expected `int \| null`, got `str` - at `\$\.floors`"),
        ("a.csv", "brief,style\na flat,modern\n", r"a\.csv:1: the columns are 'brief', 'style'; they may be brief and"),
        ("a.csv", "brief\na flat, for two\n", r"a\.csv:2: 2 cells under 1 columns; put a text with commas into quotes"),
        ("a.csv", 'brief,name\n"two\nlines",a\n"b,c\n', r"a\.csv:4: no CSV: "),
        ("a.csv", "brief,seed\n,4\n", r"a\.csv:2: the brief is empty"),
        ("a.csv", "brief,area,floor_area\na flat,90,90\n", r"a\.csv:2: area and floor_area exclude each other"),
        ("a.csv", "brief,name\na,x\nb,X\n", r"a\.csv:3: the name 'X' is already used in line 2"),
        ("a.csv", "brief,name\na,../x\n", r"a\.csv:2: the name '\.\./x' names no folder"),
        ("a.csv", "brief,assets\na,./none\n", r"a\.csv:2: there is no library '.*none' at .*; libraries: "),
        ("a.csv", "brief,footprint\na,none.json\n", r"a\.csv:2: .*none\.json: No such file"),
        ("a.jsonl", '{"brief": "a"}\n{"brief": \n', r"a\.jsonl:2: not JSON"),
        ("a.jsonl", '["a flat"]\n', r"a\.jsonl:1: expected an object such as .*, got list"),
        (
            "a.jsonl",
            '{"brief": "a", "colour": 1}\n{"brief": " "}\n',
            r"a\.jsonl:1: unknown colour; .*a\.jsonl:2: the br",
        ),
        ("a.txt", "\n# nothing\n", r"a\.txt: holds no brief"),
        ("a.xml", "", r"a\.xml: briefs are read from files that end in \.txt, \.csv, \.jsonl"),
    ],
)
def test_a_bad_row_is_refused_with_file_and_line(tmp_path: Path, name: str, text: str, message: str) -> None:
    with pytest.raises(MansionError, match=message) as caught:
        read_briefs(written(tmp_path, name, text))
    assert caught.value.code == ErrorCode.INVALID_PAYLOAD
    assert "\n" not in str(caught.value)


def test_a_text_that_is_not_utf8_is_refused_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_bytes(b"a flat\n\xe9t\xe9\n")
    with pytest.raises(MansionError, match=r"a\.txt:2: the text is not UTF-8"):
        read_briefs(tmp_path / "a.txt")


def test_what_fails_is_told_and_the_others_are_built(tmp_path: Path, build: Build, threads: Threads) -> None:
    def no_castle(request: BuildRequest, folder: Path) -> None:
        if "castle" in request.description:
            raise MansionError(ErrorCode.INFEASIBLE, "no room for a moat")
        build(request, folder)

    file = written(tmp_path, "briefs.csv", "brief,name\na flat,a\na castle,b\na flat,c\n")
    made, rows = make(tmp_path / "out", file, no_castle, threads, jobs=2)
    assert (made.done, made.missing, made.set_aside) == (2, 1, 1)
    assert rows["b"] == Result(name="b", reason="refused: INFEASIBLE: no room for a moat")
    assert (rows["a"].path, rows["c"].path) == ("buildings/a", "buildings/c")  # alike, and both wanted
    assert (tmp_path / "out" / "buildings" / "c" / "building.json").is_file()


def test_a_changed_list_builds_only_what_changed(tmp_path: Path, build: Build, threads: Threads) -> None:
    asked: list[str] = []

    def counted(request: BuildRequest, folder: Path) -> None:
        asked.append(request.description)
        if request.description == "bad":
            raise MansionError(ErrorCode.INFEASIBLE, "bad")
        build(request, folder)

    file = written(tmp_path, "briefs.csv", "brief,name\none,a\nbad,b\nthree,c\n")
    make(tmp_path / "out", file, counted, threads)
    make(tmp_path / "out", file, counted, threads)
    assert asked == ["one", "bad", "three"]
    asked.clear()
    written(tmp_path, "briefs.csv", "brief,name\nnew,n\nthree,c\ngood,b\nother,a\n")
    made, rows = make(tmp_path / "out", file, counted, threads)
    assert asked == ["new", "good", "other"]
    assert (made.kept, [row.reason for row in rows.values()]) == (1, [""] * 4)
    assert [(row.index, row.path, row.description) for row in WorldFolder(tmp_path / "out").manifest()] == [
        (0, "buildings/n", "new"),
        (1, "buildings/c", "three"),
        (2, "buildings/b", "good"),
        (3, "buildings/a", "other"),
    ]
    whole, _ = make(tmp_path / "whole", file, build, threads)
    assert whole.done == 4
    for part in ("records", "manifest", "buildings"):
        assert files(tmp_path / "out" / part) == files(tmp_path / "whole" / part)


def files(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file() and path.name != "report.json"
    }


def test_buildings_of_another_list_are_not_thrown_away(tmp_path: Path, build: Build, threads: Threads) -> None:
    make(tmp_path / "out", written(tmp_path, "one.csv", "brief,name\none,a\ntwo,b\n"), build, threads)
    before = files(tmp_path / "out")
    with pytest.raises(MansionError, match="holds buildings that the list does not have: buildings/a; remove"):
        make(tmp_path / "out", written(tmp_path, "two.csv", "brief,name\ntwo,b\n"), build, threads)
    assert files(tmp_path / "out") == before


def test_the_command_builds_what_the_single_command_builds(tmp_path: Path) -> None:
    file = written(tmp_path, "briefs.csv", f"brief,name,seed\n{STUDIO},studio,4\n{STUDIO},none,-1\n")
    refused = CliRunner().invoke(app, ["build", "--from", str(file), "-o", str(tmp_path / "out")])
    assert "briefs.csv:3: " in str(refused.exception)
    assert not (tmp_path / "out").exists()
    written(tmp_path, "briefs.csv", f"brief,name,floor_area\n{STUDIO},studio,40\na flat of 90 bathrooms,none,40\n")
    done = CliRunner().invoke(
        app, ["build", "--from", str(file), "--jobs", "1", "--seed", "5", "-o", str(tmp_path / "out")]
    )
    assert done.exit_code == 1, done.output
    assert "1 of 2 briefs failed" in done.output
    table = (tmp_path / "out" / "table.csv").read_text().splitlines()
    assert table[0] == "name,path,floors,rooms,objects,wishes,wishes_met,reason"
    assert table[1].startswith("studio,buildings/studio,1,")
    assert table[2].startswith("none,,0,0,0,0,0,")
    single = CliRunner().invoke(app, ["build", STUDIO, "--floor-area", "40", "--seed", "5", "-o", str(tmp_path / "s")])
    assert single.exit_code == 0, single.output
    assert files(tmp_path / "out" / "buildings" / "studio") == files(tmp_path / "s")
    (row, failed) = mansion.build_all(
        [
            BuildRequest(description=STUDIO, floor_area=40.0, seed=5),
            BuildRequest(description="a flat of 90 bathrooms", floor_area=40.0),
        ],
        tmp_path / "python",
    )
    assert files(tmp_path / "python" / row.path) == files(tmp_path / "s")
    assert failed.reason.startswith("refused: ")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["a flat", "--from", "briefs.txt"], "--from takes all briefs from its file; leave out the brief"),
        (["--from", "briefs.txt", "--graph"], "--from takes all briefs from its file; leave out --graph"),
        ([], "there is no brief; give a sentence, a plan with --plan, or a file with --from"),
    ],
)
def test_one_brief_or_a_file_of_them(tmp_path: Path, arguments: list[str], message: str) -> None:
    done = CliRunner().invoke(app, ["build", *arguments, "-o", str(tmp_path / "out")])
    assert isinstance(done.exception, MansionError)
    assert message in str(done.exception)
