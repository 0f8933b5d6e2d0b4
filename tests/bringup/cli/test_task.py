"""``mansion task`` from making to running."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import Task, TaskSet
from sample_building import write_building


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_building(tmp_path_factory.mktemp("sample") / "building")


def run(*words: str) -> tuple[int, str]:
    done = CliRunner().invoke(app, ["task", *words])
    if isinstance(done.exception, MansionError):
        raise done.exception
    return done.exit_code, done.output


def test_tasks_are_made_shown_and_done(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "sets" / "tasks.json"
    assert run("generate", str(folder), "-n", "3", "--seed", "1", "-o", str(file))[0] == 0
    made = decode(TaskSet, file.read_bytes())
    assert len(made.tasks) == 3 and made.building_id == "sample"
    assert (file.parent / made.building).resolve() == folder.resolve()
    assert run("show", str(file))[1].count("deliver_") >= 1
    code, text = run("show", str(file), made.tasks[1].id)
    assert code == 0 and json.loads(text)["instruction"] == made.tasks[1].instruction
    for extra in ([], ["--plan"]):
        code, text = run("run", str(file), *extra)
        assert code == 0 and text.count(": done") == 3


def test_a_plan_that_does_not_lead_there_fails(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "tasks.json"
    run("generate", str(folder), "-n", "1", "-o", str(file))
    made = json.loads(file.read_text())
    made["tasks"][0]["oracle"] = [{"skill": "Rotate", "arguments": {}}]
    file.write_text(json.dumps(made))
    code, text = run("run", str(file), "--plan")
    assert code == 1 and "failed" in text


def test_the_papers_tasks_are_listed_printed_and_grounded(folder: Path, tmp_path: Path) -> None:
    code, text = run("paper")
    assert code == 0 and "office_cellphone" in text and "mansion build" in text
    file = tmp_path / "task.json"
    assert run("paper", "apartment_laptop", "-o", str(file))[0] == 0
    assert decode(Task, file.read_bytes()).id == "apartment_laptop"
    with pytest.raises(MansionError, match="a laptop"):
        run("ground", str(file), str(folder))
    words = {
        "id": "mine",
        "kind": "search",
        "instruction": "Find a ball.",
        "needs": [{"noun": "ball", "floor": 2, "role": "target"}],
    }
    file.write_text(json.dumps(words))
    code, text = run("ground", str(file), str(folder))
    assert code == 0
    assert json.loads(text)["tasks"][0]["goals"][0]["objects"] == ["F2/office/ball_1"]


def test_unknown_tasks_and_files_are_named(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(MansionError, match=r"no paper task .* apartment_box"):
        run("paper", "nonsense")
    with pytest.raises(MansionError, match="No such file"):
        run("show", str(tmp_path / "missing.json"))


def test_a_task_in_words_is_no_task_set_and_says_what_makes_one(tmp_path: Path) -> None:
    file = tmp_path / "laptop.json"
    run("paper", "office_laptop", "-o", str(file))
    for command in ("run", "show"):
        with pytest.raises(MansionError) as caught:
            run(command, str(file))
        assert "mansion task ground" in str(caught.value) and str(file) in str(caught.value)


def test_a_folder_of_tasks_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(MansionError) as caught:
        run("show", str(tmp_path))
    assert "is a folder" in str(caught.value)


def test_tasks_of_another_building_are_refused(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "tasks.json"
    run("generate", str(folder), "-n", "1", "-o", str(file))
    made = json.loads(file.read_text())
    file.write_text(json.dumps({**made, "building_id": "another"}))
    with pytest.raises(MansionError) as caught:
        run("run", str(file), "--building", str(folder))
    assert "are for building 'another'" in str(caught.value) and "'sample'" in str(caught.value)
    file.write_text(json.dumps({**made, "building": "gone"}))
    with pytest.raises(MansionError, match="--building DIR names where it is now"):
        run("run", str(file))


def test_only_a_task_in_words_is_grounded(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(MansionError) as caught:
        run("ground", "offce_laptop", str(folder))
    assert "did you mean office_laptop? the paper's tasks: apartment_box" in str(caught.value)
    file = tmp_path / "tasks.json"
    run("generate", str(folder), "-n", "1", "-o", str(file))
    with pytest.raises(MansionError) as caught:
        run("ground", str(file), str(folder))
    assert f"`mansion task run {file}`" in str(caught.value)


def test_what_a_building_lacks_is_told_with_the_way_to_it(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(MansionError) as caught:
        run("ground", "apartment_laptop", str(folder))
    assert f"mansion edit {folder} --task apartment_laptop.json`" in str(caught.value)
    with pytest.raises(MansionError) as caught:
        run("ground", "orange_toolbox", str(folder))
    assert 'mansion build "A four-storey office' in str(caught.value)


def test_a_bench_of_no_agents_is_refused(folder: Path, tmp_path: Path) -> None:
    file = tmp_path / "tasks.json"
    run("generate", str(folder), "-n", "1", "-o", str(file))
    words = ["bench", "agents", "--tasks", str(file), "--agents", " ,", "-o", str(tmp_path / "o")]
    done = CliRunner().invoke(app, words)
    assert isinstance(done.exception, MansionError) and "explorer" in str(done.exception)
    assert not (tmp_path / "o").exists()
