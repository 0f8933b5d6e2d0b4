"""The client that the process of a graph lends to its user's commands, by a Unix socket that is theirs alone."""

import contextlib
import os
import queue
import socket
import socketserver
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final

import msgspec

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.call_progress import progress_line, progress_topic
from mansion_bringup.graph.call_socket import (
    Answer,
    Call,
    Greeting,
    Told,
    graph_key,
    is_same_user,
    private_folder,
    receive,
    send,
    sockets,
)
from mansion_msgs_py.closing import Closing
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.errors import MansionError

__all__ = ["ResidentClient"]

IDLE: Final = 10.0
"""Seconds after which a command that asks nothing, or does not take its answer, is left alone."""

LOOK_FOR_END: Final = 0.2
"""Seconds between two looks whether the process ends."""


class ResidentClient(Closing):
    """Answers commands in the namespace of a graph, in threads of its own, until it is closed.

    Where there is no folder that this user has alone, nothing is offered; commands then make participants of their own.

    Parameters
    ----------
    namespace : str
    client : MansionClient, optional
        The client to lend, which stays open; one of its own when absent.

    Attributes
    ----------
    path : Path, optional
        Path of the socket.
    """

    def __init__(self, namespace: str, client: MansionClient | None = None) -> None:
        self.path: Path | None = None
        folder = private_folder()
        if folder is None:
            return
        _remove_left_behind(folder)
        self._lent = client
        self._client = client or MansionClient(namespace=namespace)
        path = folder / f"{graph_key(namespace)}-{os.getpid()}.sock"
        # Under its name only once it listens: what does not answer there counts as left behind.
        early = path.with_suffix(".new")
        early.unlink(missing_ok=True)
        self._server = _Server(str(early), self._client)
        self.path = early.rename(path)
        self._thread = threading.Thread(
            target=self._server.serve_forever, args=(LOOK_FOR_END,), name="resident_client", daemon=True
        )
        self._thread.start()

    def close(self) -> None:
        """Take the socket away and end the client; to close it again does nothing."""
        if self.path is None:
            return
        self.path.unlink(missing_ok=True)
        self.path = None
        self._server.shutdown()
        self._server.server_close()
        if self._lent is None:
            self._client.close()


class _Server(socketserver.ThreadingUnixStreamServer):
    """Accepts commands; `client` is shared by the threads that answer them."""

    daemon_threads = True
    request_queue_size = 64

    def __init__(self, path: str, client: MansionClient) -> None:
        self.client = client
        self.news = _News(client)
        super().__init__(path, _Handler)


class _News:
    """What nodes publish of how far they are, for the calls that run; no topic is listened to before its first call."""

    def __init__(self, client: MansionClient) -> None:
        self._client = client
        self._lock = threading.Lock()
        self._calls: dict[str, list[queue.SimpleQueue[str | None]]] = {}
        self._heard: set[str] = set()

    @contextlib.contextmanager
    def of(self, topic: str) -> Iterator["queue.SimpleQueue[str | None]"]:
        """Yield a queue of the messages of a topic until the end of the block; ``None`` is the last."""
        told: queue.SimpleQueue[str | None] = queue.SimpleQueue()
        with self._lock:
            first = topic not in self._heard
            self._heard.add(topic)
            self._calls.setdefault(topic, []).append(told)
        try:
            if first:
                self._hear(topic)
            yield told
        finally:
            with self._lock:
                self._calls[topic].remove(told)
            told.put(None)

    def _hear(self, topic: str) -> None:
        try:
            self._client.listen(topic, lambda text: self._spread(topic, text))
        except BaseException:
            with self._lock:
                self._heard.discard(topic)
            raise

    def _spread(self, topic: str, text: str) -> None:
        with self._lock:
            for told in self._calls[topic]:
                told.put(text)


class _Handler(socketserver.BaseRequestHandler):
    """Answers one command; whatever goes wrong with its connection ends nothing but that."""

    server: _Server
    request: socket.socket

    def handle(self) -> None:
        self.request.settimeout(IDLE)
        with contextlib.suppress(OSError, EOFError, msgspec.DecodeError):
            if is_same_user(self.request):
                send(self.request, Greeting())
                asked = receive(self.request, Call)
                with self._telling(asked):
                    answer = self._answer(asked)
                send(self.request, answer)

    @contextlib.contextmanager
    def _telling(self, asked: Call) -> Iterator[None]:
        """Tell the command how far its call is, in a thread that has ended when the block has."""
        topic = progress_topic(asked.service)
        if topic is None:
            yield
            return
        with contextlib.ExitStack() as ending:
            told = self.server.news.of(topic)
            teller = threading.Thread(
                target=self._tell, args=(ending.enter_context(told), topic, asked.arguments), daemon=True
            )
            teller.start()
            yield
        teller.join()

    def _tell(self, told: "queue.SimpleQueue[str | None]", topic: str, arguments: str | None) -> None:
        given = None if arguments is None else msgspec.json.decode(arguments)
        with contextlib.suppress(OSError):
            while (text := told.get()) is not None:
                with contextlib.suppress(MansionError):
                    if (line := progress_line(topic, text, given)) is not None:
                        send(self.request, Told(line))

    def _answer(self, asked: Call) -> Answer:
        try:
            arguments: Any = None if asked.arguments is None else decode(object, asked.arguments)
            return Answer(True, encode(self.server.client.call(asked.service, arguments, timeout=asked.timeout)))
        except MansionError as error:
            return Answer(False, encode(error.reply()))


def _remove_left_behind(folder: Path) -> None:
    """Remove the sockets of processes that were killed: nobody listens at them."""
    for path in sockets(folder):
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
            probe.settimeout(IDLE)
            try:
                probe.connect(str(path))
            except ConnectionRefusedError:
                path.unlink(missing_ok=True)
            except OSError:
                continue
