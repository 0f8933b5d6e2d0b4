"""Settings come from the environment before the file, are checked, and never show a key."""

import copy
import dataclasses
import pickle
from pathlib import Path

import pytest

from mansion_llm.secret import Secret, scrub, shown_url
from mansion_llm.settings import LlmSettings, load_settings
from mansion_msgs_py.errors import MansionError

KEY = "sk-very-secret-0123456789"


def test_the_environment_comes_before_the_file(tmp_path: Path) -> None:
    file = tmp_path / "llm.toml"
    file.write_text('base_url = "http://file/v1"\nmodel = "file"\ntimeout = 5\npieces = ["program"]\n')
    settings = load_settings({"MANSION_LLM_CONFIG": str(file), "MANSION_LLM_MODEL": "env"})
    assert (settings.base_url, settings.model, settings.timeout) == ("http://file/v1", "env", 5.0)
    assert settings.pieces == ("program",)


def test_the_usual_openai_variables_stand_in(tmp_path: Path) -> None:
    settings = load_settings({"OPENAI_BASE_URL": "http://a/v1", "OPENAI_API_KEY": KEY, "MANSION_LLM_MODEL": "m"})
    settings.require_endpoint()
    assert settings.api_key.reveal() == KEY


def test_without_an_endpoint_the_error_names_what_to_set() -> None:
    with pytest.raises(MansionError) as error:
        load_settings({}).require_endpoint()
    text = str(error.value)
    for word in ("MANSION_LLM_BASE_URL", "MANSION_LLM_MODEL", "MANSION_LLM_API_KEY", "--planner rules"):
        assert word in text


@pytest.mark.parametrize(
    ("variable", "value"),
    [
        ("MANSION_LLM_TIMEOUT", KEY),
        ("MANSION_LLM_RETRIES", "-1"),
        ("MANSION_LLM_STRUCTURED", KEY),
        ("MANSION_LLM_PIECES", KEY),
        ("MANSION_LLM_TIMEOUT", "nan"),
    ],
)
def test_a_wrong_value_is_refused_by_name_and_not_repeated(variable: str, value: str) -> None:
    with pytest.raises(MansionError) as error:
        load_settings({variable: value})
    assert variable in str(error.value) and KEY not in str(error.value)


def test_a_wrong_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match="no configuration file"):
        load_settings({"MANSION_LLM_CONFIG": str(tmp_path / "none.toml")})
    file = tmp_path / "llm.toml"
    file.write_text(f"api_key = {KEY}")
    with pytest.raises(MansionError, match="not valid TOML") as error:
        load_settings({}, file=file)
    assert KEY not in str(error.value)
    file.write_text('modell = "x"')
    with pytest.raises(MansionError, match="modell"):
        load_settings({}, file=file)


def test_a_key_shows_nowhere() -> None:
    settings = LlmSettings(api_key=Secret(KEY))
    shown = [
        repr(settings),
        str(settings),
        f"{settings}",
        repr(dataclasses.asdict(settings)),
        repr(copy.deepcopy(settings)),
    ]
    assert not any(KEY in text for text in shown)
    with pytest.raises(TypeError):
        pickle.dumps(settings)


def test_keys_are_scrubbed_from_text_of_other_origin() -> None:
    text = f"bad key {KEY}; Authorization: Bearer abcdefghijk; http://me:pw@host/?api_key=zzz&x=1"
    clean = scrub(text, Secret(KEY))
    assert not any(word in clean for word in (KEY, "abcdefghijk", "pw", "zzz"))
    assert shown_url("https://me:pw@host/v1?key=1") == "https://host/v1"
