"""The Unix socket by which a running graph takes the calls of its user's commands, seen from a command.

A participant of ROS 2 takes longer to start and to find a service than most services take to answer. The process that
keeps a graph has one already, and lends it (`mansion_bringup.graph.resident_client`). A command that finds no such
process, or one that it cannot be sure of, makes a participant of its own: nothing but time depends on the socket.

Messages are JSON after their length. The graph speaks first, so that a command notices before it has asked for anything
that nobody listens; before its answer it says how far it is, where that is known.
"""

import contextlib
import hashlib
import os
import select
import socket
import stat
import struct
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final, TypeVar

import msgspec

from mansion_bringup.discovery import CHOICES, CHOSEN_FILES
from mansion_bringup.graph.call_progress import CallProgress
from mansion_msgs_py import __version__
from mansion_msgs_py.codec import encode, prepared
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = [
    "Answer",
    "Call",
    "Greeting",
    "Told",
    "ask_resident",
    "graph_key",
    "is_same_user",
    "private_folder",
    "receive",
    "send",
    "sockets",
]

T = TypeVar("T")

PATIENCE: Final = 1.0
"""Seconds for the greeting; without it, the command does without the socket."""

SLACK: Final = 15.0
"""Seconds beyond the timeout of a call in which the graph says itself that it is over."""

STEP: Final = 0.5
"""Seconds between two looks at the clock while a call lasts."""

LONGEST_FOLDER: Final = 75
"""Bytes of the folder's path; Linux takes 107 for a socket, and its name has up to 32."""

_LENGTH: Final = struct.Struct("!Q")
_CREDENTIALS: Final = struct.Struct("3i")


class Greeting(msgspec.Struct, frozen=True):
    """What a graph says to a command that connects to it."""

    version: str = __version__
    protocol: int = 2


class Call(msgspec.Struct, frozen=True):
    """What a command asks: a service of the graph's namespace, and the JSON of its arguments, if it has any."""

    service: str
    arguments: str | None
    timeout: float


class Told(msgspec.Struct, frozen=True, tag=True):
    """Progress of a call, in words."""

    text: str


class Answer(msgspec.Struct, frozen=True, tag=True):
    """The two fields of a reply, as `decode_reply` takes them."""

    success: bool
    message: str


_REPLIES: Any = Told | Answer


def private_folder() -> Path | None:
    """Return the folder for sockets that none but this user can enter, made if necessary; None where there is none.

    It lies in ``XDG_RUNTIME_DIR``, or in the temporary folder, where a folder of that name may be somebody else's.
    """
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    folder = (
        Path(runtime, "mansion") if runtime else Path(os.environ.get("TMPDIR") or "/tmp", f"mansion-{os.geteuid()}")
    )
    try:
        folder.mkdir(mode=0o700, exist_ok=True)
        found = folder.lstat()
    except OSError:
        return None
    private = stat.S_ISDIR(found.st_mode) and found.st_uid == os.geteuid() and not found.st_mode & 0o077
    return folder.absolute() if private and len(os.fsencode(folder.absolute())) <= LONGEST_FOLDER else None


def graph_key(namespace: str) -> str:
    """Return a name for the graph of a namespace that this environment's nodes find.

    The same for two processes alone where their domain, range, middleware and network are the same.
    """
    seen: list[str | None] = [namespace, str(int(os.environ.get("ROS_DOMAIN_ID") or 0))]
    seen += [os.environ.get(name) for name in (*CHOICES, "RMW_IMPLEMENTATION", "AMENT_PREFIX_PATH")]
    seen += [str(Path(name).absolute()) for name in CHOSEN_FILES if Path(name).exists()]
    with contextlib.suppress(OSError):
        seen.append(os.readlink("/proc/self/ns/net"))
    return hashlib.sha256(encode(seen).encode()).hexdigest()[:16]


def sockets(folder: Path, key: str = "") -> list[Path]:
    """Return the sockets of a graph, or of all, those of processes that are gone too."""
    return sorted(folder.glob(f"{key or '*'}-*.sock"))


def ask_resident(
    service: str, arguments: Any, *, namespace: str, timeout: float, progress: CallProgress
) -> Answer | None:
    """Return the answer of a service by way of the process that keeps the graph; None where there is none.

    Parameters
    ----------
    service : str
        Below the namespace, or absolute.
    arguments : JSON-compatible object, optional
    namespace : str
    timeout : float
        Seconds for the answer.
    progress : CallProgress
        Hears how far the call is.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where the process ended during the call, ``TIMEOUT`` where it fell silent.
    """
    folder = private_folder()
    for path in sockets(folder, graph_key(namespace)) if folder is not None else ():
        with _greeted(path) as connection:
            if connection is not None:
                asked = Call(service, None if arguments is None else encode(arguments), timeout)
                return _asked(connection, asked, progress)
    return None


@contextlib.contextmanager
def _greeted(path: Path) -> Iterator[socket.socket | None]:
    """Yield a connection to a graph of this version and user, or None."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
        connection.settimeout(PATIENCE)
        try:
            connection.connect(str(path))
            greeting = receive(connection, Greeting) if is_same_user(connection) else None
        except (OSError, EOFError, msgspec.DecodeError):
            greeting = None
        yield connection if greeting == Greeting() else None


def _asked(connection: socket.socket, asked: Call, progress: CallProgress) -> Answer:
    details = {"service": asked.service}
    deadline = time.monotonic() + asked.timeout + SLACK
    try:
        send(connection, asked)
        while True:
            while not select.select([connection], [], [], min(STEP, max(0.0, deadline - time.monotonic())))[0]:
                if time.monotonic() >= deadline:
                    raise TimeoutError
                progress.tick()
            connection.settimeout(max(PATIENCE, deadline - time.monotonic()))
            heard: Told | Answer = receive(connection, _REPLIES)
            if isinstance(heard, Answer):
                return heard
            progress.told(heard.text)
    except TimeoutError:
        text = f"{asked.service}: no answer in {asked.timeout:g} s"
        raise MansionError(ErrorCode.TIMEOUT, text, details=details) from None
    except (OSError, EOFError, msgspec.DecodeError):
        text = f"the graph ended during the call of {asked.service}, which may or may not have been carried out"
        raise MansionError(ErrorCode.UNAVAILABLE, text, details=details) from None


def is_same_user(connection: socket.socket) -> bool:
    """Whether the process at the other end runs as this user (unix(7), SO_PEERCRED)."""
    raw = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
    _, user, _ = _CREDENTIALS.unpack(raw)
    return bool(user == os.geteuid())


def send(connection: socket.socket, message: msgspec.Struct) -> None:
    """Send a message whole."""
    body = msgspec.json.encode(message)
    connection.sendall(_LENGTH.pack(len(body)) + body)


def receive(connection: socket.socket, kind: type[T]) -> T:
    """Return the next message.

    Raises
    ------
    EOFError
        When the other end has closed.
    msgspec.DecodeError
        When it is a message of another kind.
    """
    (length,) = _LENGTH.unpack(_exactly(connection, _LENGTH.size))
    return msgspec.json.decode(_exactly(connection, length), type=prepared(kind))


def _exactly(connection: socket.socket, length: int) -> bytes:
    received = bytearray()
    while len(received) < length:
        piece = connection.recv(min(length - len(received), 1 << 20))
        if not piece:
            raise EOFError("the other end has closed")
        received += piece
    return bytes(received)
