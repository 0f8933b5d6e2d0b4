"""``mansion call`` without the parser of the command line: what is plain enough for it, and what it prints."""

import json
from pathlib import Path

import pytest

from mansion_bringup.cli import socket_call as module
from mansion_bringup.cli.socket_call import call_quickly
from mansion_bringup.graph.call_progress import CallProgress
from mansion_bringup.graph.call_socket import Answer
from mansion_msgs_py.errors import MansionError

Asked = list[tuple[object, ...]]


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Asked:
    """What a graph is asked that sends arguments back, and refuses a call without any."""
    heard: Asked = []

    def ask(service: str, arguments: object, *, namespace: str, timeout: float, progress: CallProgress) -> Answer:
        heard.append((service, arguments, namespace, timeout))
        if arguments is None:
            return Answer(False, '{"error": {"code": "NOT_FOUND", "message": "nothing there"}}')
        return Answer(True, json.dumps(arguments))

    monkeypatch.setattr(module, "ask_resident", ask)
    monkeypatch.delenv("MANSION_CONFIG", raising=False)
    monkeypatch.chdir(tmp_path)
    return heard


@pytest.mark.parametrize(
    ("words", "call"),
    [
        (["call", "echo", "[1]"], ("echo", [1], "/mansion", 600.0)),
        (["call", "--timeout", "2", "echo", "-n", "site/", "{}"], ("echo", {}, "/site", 2.0)),
        (["call", "-q", "echo", "[1]"], ("echo", [1], "/mansion", 600.0)),
        (["call", "echo", "@arguments.json", "--namespace", "/a/b"], ("echo", {"floor": 2}, "/a/b", 600.0)),
    ],
)
def test_a_plain_call_is_asked_and_its_reply_printed(
    words: list[str], call: tuple[object, ...], asked: Asked, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("arguments.json").write_text('{"floor": 2}')
    assert call_quickly(words)
    assert asked == [call] and json.loads(capsys.readouterr().out) == call[1]


@pytest.mark.parametrize(
    "words",
    [
        [],
        ["up"],
        ["call"],
        ["call", "--help"],
        ["call", "echo", "{}", "-v"],
        ["call", "echo", "{}", "more"],
        ["call", "echo", "--timeout"],
        ["call", "echo", "--timeout", "soon"],
        ["call", "echo", "--timeout", "0"],
        ["call", "echo", "--timeout", "nan"],
        ["--config", "mine.toml", "call", "echo"],
    ],
    ids=" ".join,
)
def test_anything_else_is_left_to_the_parser(words: list[str], asked: Asked) -> None:
    assert not call_quickly(words) and asked == []


def test_a_settings_file_is_left_to_the_parser(asked: Asked, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("mansion.toml").write_text('namespace = "/site"\n')
    assert not call_quickly(["call", "echo", "{}"])
    Path("mansion.toml").unlink()
    monkeypatch.setenv("MANSION_CONFIG", "mine.toml")
    assert not call_quickly(["call", "echo", "{}"]) and asked == []


def test_a_refusal_is_printed_and_raised(asked: Asked, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(MansionError, match="nothing there"):
        call_quickly(["call", "echo"])
    assert json.loads(capsys.readouterr().out)["error"]["code"] == "NOT_FOUND"


def test_a_domain_that_is_none_is_refused(asked: Asked, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "many")
    with pytest.raises(MansionError, match="ROS_DOMAIN_ID is 'many'"):
        call_quickly(["call", "echo"])
    assert asked == []


def test_a_file_that_is_not_there_is_refused(asked: Asked) -> None:
    with pytest.raises(MansionError, match="No such file"):
        call_quickly(["call", "echo", "@none.json"])
