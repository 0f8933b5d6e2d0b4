"""The socket of a graph, seen from a command: who may be at the other end, and what happens where nobody answers."""

import contextlib
import os
import socket
import tempfile
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from mansion_bringup.graph import call_socket
from mansion_bringup.graph.call_progress import CallProgress
from mansion_bringup.graph.call_socket import Answer, Call, Greeting, Told, ask_resident, graph_key, private_folder
from mansion_msgs_py.errors import ErrorCode, MansionError

Talk = Callable[[socket.socket], None]


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder of this test alone for sockets; its path is short, as paths of sockets must be."""
    with tempfile.TemporaryDirectory() as runtime:
        monkeypatch.setenv("XDG_RUNTIME_DIR", runtime)
        monkeypatch.setenv("ROS_DOMAIN_ID", "12")
        yield Path(runtime, "mansion")


@pytest.fixture
def graph() -> Iterator[Callable[[Talk], list[Call]]]:
    """Start a process of a graph that talks to one command as told; gives what it was asked."""
    opened: list[socket.socket] = []
    threads: list[threading.Thread] = []

    def start(talk: Talk) -> list[Call]:
        asked: list[Call] = []
        listener = listening(f"{graph_key('/mansion')}-1.sock")
        opened.append(listener)

        def run() -> None:
            connection, _ = listener.accept()
            with connection:
                talk(connection)
                try:
                    asked.append(call_socket.receive(connection, Call))
                except EOFError:
                    return
                if asked[0].service == "tell":
                    for text in ("one", "two"):
                        call_socket.send(connection, Told(text))
                if asked[0].service != "cut":
                    call_socket.send(connection, Answer(asked[0].service == "echo", asked[0].arguments or "null"))

        threads.append(threading.Thread(target=run, daemon=True))
        threads[-1].start()
        return asked

    yield start
    for thread in threads:
        thread.join(10.0)
        assert not thread.is_alive()
    for listener in opened:
        listener.close()


def listening(name: str) -> socket.socket:
    """Return a socket that listens under that name."""
    place = private_folder()
    assert place is not None
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    listener.bind(str(place / name))
    listener.listen(1)
    return listener


def greet(connection: socket.socket) -> None:
    with contextlib.suppress(BrokenPipeError):
        call_socket.send(connection, Greeting())


def ask(service: str = "echo", arguments: object = None) -> Answer | None:
    return ask_resident(service, arguments, namespace="/mansion", timeout=5.0, progress=CallProgress(service))


def test_none_but_the_user_enters_the_folder(folder: Path) -> None:
    assert private_folder() == folder
    assert folder.stat().st_mode & 0o777 == 0o700


def test_a_folder_that_others_enter_is_not_used(folder: Path) -> None:
    folder.mkdir(mode=0o755)
    assert private_folder() is None and ask() is None


def test_a_link_is_not_used(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "elsewhere").mkdir(mode=0o700)
    folder.symlink_to(tmp_path / "elsewhere")
    assert private_folder() is None


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives folders away")
def test_a_folder_of_somebody_else_is_not_used(folder: Path) -> None:
    folder.mkdir(mode=0o700)
    os.chown(folder, 65534, 65534)
    assert private_folder() is None


def test_a_path_too_long_for_a_socket_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / ("x" * 100)).mkdir()
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / ("x" * 100)))
    assert private_folder() is None


def test_without_a_runtime_folder_it_lies_in_the_temporary_one(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("XDG_RUNTIME_DIR")
    monkeypatch.setenv("TMPDIR", str(folder.parent))
    assert private_folder() == folder.with_name(f"mansion-{os.geteuid()}")


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("ROS_DOMAIN_ID", "13"),
        ("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"),
        ("ROS_STATIC_PEERS", "192.0.2.1"),
        ("RMW_IMPLEMENTATION", "rmw_cyclonedds_cpp"),
        ("AMENT_PREFIX_PATH", "/opt/ros/jazzy"),
    ],
)
def test_whoever_finds_other_nodes_asks_another_graph(name: str, value: str, monkeypatch: pytest.MonkeyPatch) -> None:
    before = graph_key("/mansion")
    monkeypatch.setenv(name, value)
    assert graph_key("/mansion") != before


def test_each_namespace_has_a_graph_of_its_own() -> None:
    assert graph_key("/mansion") == graph_key("/mansion") != graph_key("/site_b/mansion")


def test_no_domain_is_domain_0(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", "0")
    zero = graph_key("/mansion")
    monkeypatch.delenv("ROS_DOMAIN_ID")
    assert graph_key("/mansion") == zero


def test_a_call_is_answered(graph: Callable[[Talk], list[Call]]) -> None:
    asked = graph(greet)
    assert ask(arguments={"text": "ß"}) == Answer(True, '{"text":"ß"}')
    assert asked == [Call("echo", '{"text":"ß"}', 5.0)]


def test_a_command_hears_how_far_its_call_is(graph: Callable[[Talk], list[Call]]) -> None:
    graph(greet)
    heard: list[str] = []

    class Listening(CallProgress):
        def told(self, text: str) -> None:
            heard.append(text)

    answer = ask_resident("tell", None, namespace="/mansion", timeout=5.0, progress=Listening("tell"))
    assert answer == Answer(False, "null") and heard == ["one", "two"]


def test_a_call_without_arguments_has_none(graph: Callable[[Talk], list[Call]]) -> None:
    asked = graph(greet)
    assert ask("other") == Answer(False, "null")
    assert asked == [Call("other", None, 5.0)]


def test_nobody_there_is_no_answer() -> None:
    assert ask() is None


def test_a_socket_left_behind_is_passed_over() -> None:
    listening(f"{graph_key('/mansion')}-1.sock").close()
    assert ask() is None


def test_whoever_does_not_greet_is_asked_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(call_socket, "PATIENCE", 0.05)
    with listening(f"{graph_key('/mansion')}-1.sock"):
        assert ask() is None


def test_another_version_is_asked_nothing(graph: Callable[[Talk], list[Call]]) -> None:
    asked = graph(lambda connection: call_socket.send(connection, Greeting("0.0.0")))
    assert ask() is None and asked == []


def test_what_is_no_greeting_is_passed_over(graph: Callable[[Talk], list[Call]]) -> None:
    asked = graph(lambda connection: connection.sendall(b"\0\0\0\0\0\0\0\x02[]"))
    assert ask() is None and asked == []


def test_another_user_is_asked_nothing(graph: Callable[[Talk], list[Call]], monkeypatch: pytest.MonkeyPatch) -> None:
    asked = graph(greet)
    monkeypatch.setattr(call_socket, "is_same_user", lambda connection: False)
    assert ask() is None and asked == []


def test_a_graph_that_ends_during_a_call_leaves_it_open_what_was_done(graph: Callable[[Talk], list[Call]]) -> None:
    graph(greet)
    with pytest.raises(MansionError, match="ended during the call of cut, which may or may not") as caught:
        ask("cut")
    assert caught.value.code == ErrorCode.UNAVAILABLE


def test_a_graph_that_falls_silent_is_not_waited_for_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(call_socket, "SLACK", 0.05)
    with listening(f"{graph_key('/mansion')}-1.sock") as listener:
        silent = threading.Thread(target=lambda: held.append(greeted(listener)), daemon=True)
        held: list[socket.socket] = []
        silent.start()
        with pytest.raises(MansionError, match=r"echo: no answer in 0\.1 s") as caught:
            ask_resident("echo", None, namespace="/mansion", timeout=0.1, progress=CallProgress("echo"))
        assert caught.value.code == ErrorCode.TIMEOUT
        silent.join(10.0)
        held[0].close()


def greeted(listener: socket.socket) -> socket.socket:
    """Accept a command, greet it, and say no more."""
    connection, _ = listener.accept()
    greet(connection)
    return connection
