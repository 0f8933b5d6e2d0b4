"""``mansion assets``: libraries of one's own models, listed, shown, drawn and checked."""

import json
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from typer.testing import CliRunner, Result

from mansion_bringup.cli.app import app
from sample_models import bar_glb, write_models


def run(*words: str) -> Result:
    return CliRunner().invoke(app, ["assets", *words])


def answer(*words: str) -> Any:
    result = run(*words, "--json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return the path of a library to which good and broken models were added."""
    folder = tmp_path_factory.mktemp("libraries")
    write_models(folder / "models")
    result = run("add", str(folder / "models"), "--library", str(folder / "shop"), "--licence", "CC0")
    assert result.exit_code == 1, "five models are broken"
    assert result.stderr.count("refused ") >= 5
    assert "4 assets, 5 refused" in result.stderr
    return str(folder / "shop")


def test_a_name_is_a_library_in_the_users_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MANSION_LIBRARIES", str(tmp_path / "libraries"))
    model = tmp_path / "espresso_bar.glb"
    model.write_bytes(bar_glb())
    (result,) = answer("add", str(model), "--library", "lab")["assets"]
    assert (result["status"], result["key"]) == ("added", "lab.espresso_bar")
    assert (tmp_path / "libraries" / "lab" / "assets" / "lab.espresso_bar.glb").is_file()
    assert [row["id"] for row in answer("list", "--category", "espresso_bar")] == ["lab.espresso_bar"]


def test_a_path_without_models_is_refused_before_anything_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    installed: list[str] = []
    monkeypatch.setattr("mansion_bringup.extras.ensure_extra", installed.append)
    result = run("add", "no/such/folder", "--library", "lab")
    assert result.exit_code == 1
    assert "there is no file or folder no/such/folder" in str(result.exception)
    assert installed == []


def test_a_library_is_listed(library: str) -> None:
    rows = {row["id"]: row for row in answer("list", "--library", library)}
    assert set(rows) == {"shop.bookshelf_a1b2c3d4", "shop.espresso_bar", "shop.filing_cabinet", "shop.wooden_chair"}
    assert rows["shop.wooden_chair"]["licence"] == "CC0"
    assert [row["id"] for row in answer("list", "coffee", "bar", "--library", library)][:1] == ["shop.espresso_bar"]


def test_the_catalogue_is_listed_by_words_and_category() -> None:
    assert {row["category"] for row in answer("list", "--category", "fridge")} == {"fridge"}
    assert answer("list", "something", "to", "sit", "on")
    refused = run("list", "--category", "no_such_thing")
    assert refused.exit_code == 1


def test_an_asset_is_shown_with_what_was_stated_and_guessed(library: str) -> None:
    facts = answer("show", "shop.filing_cabinet", "--library", library)
    assert [part["part"] for part in facts["parts"]] == ["body", "drawer_1"]
    assert facts["parts"][1]["joint"]["kind"] == "slide"
    assert facts["mass"] == 30
    assert "mass: 30 kg" in facts["stated"]
    text = run("show", "shop.filing_cabinet", "--library", library).stdout
    assert "drawer_1" in text
    assert "category: filing_cabinet, by the name 'filing cabinet'" in text


def test_an_asset_that_is_not_there_is_refused() -> None:
    result = run("show", "no.such_asset")
    assert result.exit_code == 1
    assert "Traceback" not in result.output


def test_a_sheet_shows_each_asset(library: str, tmp_path: Path) -> None:
    made = answer("sheet", "-o", str(tmp_path / "shop.png"), "--library", library, "--columns", "2")
    assert len(made["assets"]) == 4
    picture = Image.open(tmp_path / "shop.png")
    assert picture.width == 2 * 180
    tiles = [picture.crop((x, y, x + 180, y + 180)).convert("RGB") for x in (0, 180) for y in (0, 208)]
    assert all(len(tile.getcolors(40_000) or ()) > 10 for tile in tiles)


def test_a_sheet_of_everything_is_refused(tmp_path: Path) -> None:
    assert run("sheet", "-o", str(tmp_path / "all.png")).exit_code == 1


def test_a_check_tells_each_fault_and_its_status(library: str, tmp_path: Path) -> None:
    assert run("check", "--library", library).exit_code == 0
    model = tmp_path / "espresso_bar.glb"
    model.write_bytes(bar_glb())
    run("add", str(model), "--library", str(tmp_path / "lab"))
    result = run("check", "--library", str(tmp_path / "lab"))
    assert result.exit_code == 1
    assert result.stdout.splitlines() == ["lab.espresso_bar: states no licence"]


@pytest.mark.parametrize(
    "words",
    [
        ("add", "missing.glb", "--library", "./shop"),
        ("add", ".", "--library", "no name"),
        ("add", ".", "--library", "./shop", "--up", "x"),
        ("add", ".", "--library", "./shop", "--front", "north"),
        ("add", ".", "--library", "./shop", "--rooms", "no_such_room"),
        ("list", "--library", "nowhere"),
        ("check", "--library", "nowhere"),
    ],
)
def test_what_cannot_be_is_refused_without_a_traceback(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MANSION_LIBRARIES", str(tmp_path / "libraries"))
    result = run(*words)
    assert result.exit_code == 1
    assert "Traceback" not in result.output
