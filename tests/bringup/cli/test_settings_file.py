"""``mansion.toml``: what it may hold, what wins over it, and what is refused with its place."""

import json
import os
from pathlib import Path
from typing import Any

import pytest
import typer.main
from typer.testing import CliRunner

from mansion_bringup.cli import settings_file
from mansion_bringup.cli.app import app
from mansion_bringup.cli.settings_file import SHARED, find_settings
from mansion_msgs_py.errors import MansionError

ROOT: Any = typer.main.get_command(app)


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working folder, and an environment that is restored."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(os, "environ", {k: v for k, v in os.environ.items() if not k.startswith(("MANSION", "OPENAI"))})
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    return tmp_path


def write(text: str, name: str = "mansion.toml") -> Path:
    Path(name).write_text(text, encoding="utf-8")
    return Path(name)


def planned(*words: str) -> Any:
    done = CliRunner().invoke(app, ["plan", "a small flat", "--json", *words])
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


def test_without_a_file_nothing_is_set() -> None:
    assert find_settings(None, ROOT) == settings_file.SettingsFile()


def test_the_file_of_the_working_folder_gives_defaults_and_options_win() -> None:
    assert len(planned()["floors"]) == 1
    write("[plan]\nfloors = 2\n")
    assert len(planned()["floors"]) == 2
    assert len(planned("--floors", "1")["floors"]) == 1


def test_a_table_wins_over_the_top_and_reaches_inner_commands() -> None:
    settings = find_settings(write("seed = 3\n[build]\nseed = 4\n[task.generate]\ncount = 2\n"), ROOT)
    defaults = settings.default_map(ROOT)
    assert (defaults["build"]["seed"], defaults["plan"]["seed"]) == (4, 3)
    assert defaults["task"]["generate"] == {"seed": 3, "count": 2}


def test_libraries_stand_at_the_top_beside_tables_of_the_commands_of_assets() -> None:
    settings = find_settings(write('assets = ["shop", "./more"]\n[build]\nseed = 4\n'), ROOT)
    assert settings.default_map(ROOT)["edit"]["assets"] == "shop,./more"
    settings = find_settings(write("[assets.sheet]\ncolumns = 3\n"), ROOT)
    assert settings.default_map(ROOT)["assets"]["sheet"] == {"columns": 3}


def test_lists_stand_for_names_with_commas() -> None:
    settings = find_settings(write('formats = ["nav2", "mjcf"]\n[up]\nallow = ["a", "b"]\n'), ROOT)
    assert settings.default_map(ROOT)["build"]["formats"] == "nav2,mjcf"
    assert settings.default_map(ROOT)["up"]["allow"] == ["a", "b"]


@pytest.mark.parametrize("key", SHARED)
def test_each_key_at_the_top_is_an_option_of_several_commands(key: str) -> None:
    having = [
        path
        for path, command in settings_file.commands_below(ROOT)
        if key in map(settings_file.option_key, settings_file.configurable(command))
    ]
    assert len(having) >= 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("sede = 1", ("mansion.toml: sede", "did you mean seed?")),
        ("floors = 2", ("mansion.toml: floors", "[build]", "[plan]")),
        ("[build]\nfloor_aera = 2", ("build.floor_aera", "did you mean floor_area?")),
        ("[buildings]\nseed = 2", ("mansion.toml: buildings", "did you mean build?")),
        ("[task.generating]\ncount = 2", ("task.generating", "did you mean generate?")),
        ("[llm]\nmodell = 'x'", ("llm.modell", "did you mean model?")),
        ("[llm]\nretries = 'many'", ("retries", "must be a number")),
        ("[llm]\napi_key = 'sk-1'", ("llm.api_key", "MANSION_LLM_API_KEY")),
        ("[llm]\ntimeout = true", ("llm.timeout must be",)),
        ("[llm]\nmodel = {a = 1}", ("llm.model must be",)),
        ("[llm]\nmodel = 'a\\u0000'".replace("'", '"'), ("llm.model has a character",)),
        ("seed = 2026-01-01", ("mansion.toml: seed must be",)),
        ("[task]\nseed = 1", ("task.seed", "generate")),
        ("llm = 3", ("llm must be a table",)),
        ("seed = -1", ("mansion.toml: seed does not fit",)),
        ("seed = true", ("mansion.toml: seed",)),
        ("strict = 1", ("strict must be true or false",)),
        ("[build]\noutput = 'x'", ("build.output must be given each time",)),
        ("[build]\nforce = true", ("build.force must be given each time",)),
        ("seed = ", ("mansion.toml is not valid TOML",)),
    ],
)  # fmt: skip
def test_what_is_no_setting_is_refused_with_its_place(text: str, said: tuple[str, ...]) -> None:
    file = write(text)
    with pytest.raises(MansionError) as error:
        find_settings(file, ROOT)
    for words in said:
        assert words in error.value.info.message
    assert "sk-1" not in str(error.value)


@pytest.mark.parametrize(
    "text", ["[up]\nallow = ['/']", "[up]\nparams_file = 'p.yaml'", "[llm]\nbase_url = 'http://a'"]
)
def test_a_file_that_merely_lies_there_cannot_widen_what_mansion_may_do(text: str) -> None:
    file = write(text)
    Path("p.yaml").write_text("{}")
    with pytest.raises(MansionError, match="a file that you name"):
        find_settings(None, ROOT)
    assert find_settings(file, ROOT).path == file


def test_a_named_file_must_be_there() -> None:
    done = CliRunner().invoke(app, ["--config", "none.toml", "config"])
    assert isinstance(done.exception, MansionError) and "none.toml" in str(done.exception)


def shown(*words: str) -> dict[str, dict[str, Any]]:
    done = CliRunner().invoke(app, [*words, "--json"])
    assert done.exit_code == 0, done.output
    found = json.loads(done.stdout)["settings"]
    return {f"{row['command']}.{row['name']}".lstrip("."): row for row in found}


def test_config_says_what_holds_and_where_from(monkeypatch: pytest.MonkeyPatch) -> None:
    write("seed = 7\n[build]\nfloor_area = 400\n[llm]\nmodel = 'small'\ntimeout = 30\n", "lab.toml")
    os.environ |= {"MANSION_CONFIG": "lab.toml", "MANSION_LLM_MODEL": "large", "OPENAI_API_KEY": "sk-secret"}
    rows = shown("config")
    assert (rows["seed"]["value"], rows["seed"]["source"]) == (7, "lab.toml: seed")
    assert rows["build.floor_area"]["source"] == "lab.toml: build.floor_area"
    assert (rows["llm.model"]["value"], rows["llm.model"]["source"]) == ("large", "MANSION_LLM_MODEL")
    assert (rows["llm.timeout"]["value"], rows["llm.timeout"]["source"]) == (30, "lab.toml: llm.timeout")
    assert (rows["llm.api_key"]["value"], rows["llm.api_key"]["source"]) == ("set", "OPENAI_API_KEY")
    assert rows["llm.retries"]["source"] == "default"


def test_config_of_a_command_has_all_its_options() -> None:
    write("seed = 7\n")
    rows = shown("config", "build")
    assert (rows["build.seed"]["value"], rows["build.seed"]["source"]) == (7, "mansion.toml: seed")
    assert (rows["build.planner"]["value"], rows["build.planner"]["source"]) == ("rules", "default")
    assert "build.output" not in rows
    with pytest.raises(MansionError, match="did you mean build"):
        CliRunner().invoke(app, ["config", "buildings"], catch_exceptions=False)
