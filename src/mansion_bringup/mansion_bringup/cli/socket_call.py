"""``mansion call`` over the socket of a running graph, without loading the rest of the command line.

To import the parser of the command line takes several times as long as such a call. Its plain form is therefore read
here; whatever is not plain, or not for a socket, is left to the parser.
"""

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from mansion_bringup.graph.call_progress import CallProgress
from mansion_bringup.graph.call_socket import ask_resident
from mansion_bringup.graph.rclpy_available import check_domain
from mansion_msgs_py.codec import decode, decode_reply, encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interface_types import DEFAULT_NAMESPACE

__all__ = ["CALL_TIMEOUT", "absolute_namespace", "json_argument", "call_quickly"]

CALL_TIMEOUT: Final = 600.0
"""Seconds for the answer of a call that does not say how long it may take."""

SHORTEST: Final = 0.1
"""Seconds that a timeout must be."""

_QUIET: Final = ("-q", "--quiet")
_OPTIONS: Final = {"-n": "namespace", "--namespace": "namespace", "--timeout": "timeout"}


def call_quickly(words: Sequence[str]) -> bool:
    """Do ``call SERVICE [JSON] [--namespace NAME] [--timeout SECONDS] [--quiet]`` by a graph's socket; print the reply.

    Parameters
    ----------
    words : sequence of str
        Words of the command line, beginning with ``call``.

    Returns
    -------
    bool
        False where nothing was done: another form, a settings file that may say more, no such graph.

    Raises
    ------
    MansionError
        What the service answered; its JSON is printed as well.
    """
    read = _plain(words)
    if read is None or "MANSION_CONFIG" in os.environ or Path("mansion.toml").exists():
        return False
    positional, options = read
    progress = CallProgress(positional[0], quiet="quiet" in options)
    try:
        timeout = float(options.get("timeout", CALL_TIMEOUT))
    except ValueError:
        return False
    if not timeout >= SHORTEST:
        return False
    payload = json_argument(positional[1]) if len(positional) > 1 else None
    check_domain()
    namespace = absolute_namespace(options.get("namespace", DEFAULT_NAMESPACE))
    try:
        answer = ask_resident(positional[0], payload, namespace=namespace, timeout=timeout, progress=progress)
        if answer is None:
            return False
        reply = decode_reply(object, answer.message, success=answer.success)
    except MansionError as error:
        progress.end()
        _print(error.reply())
        raise
    progress.end()
    _print(reply)
    return True


def _plain(words: Sequence[str]) -> tuple[list[str], dict[str, str]] | None:
    """Return the positional words and the options of a plain call, None for any other command line."""
    if not words or words[0] != "call":
        return None
    positional: list[str] = []
    options: dict[str, str] = {}
    rest = iter(words[1:])
    for word in rest:
        if word in _OPTIONS:
            value = next(rest, None)
            if value is None:
                return None
            options[_OPTIONS[word]] = value
        elif word in _QUIET:
            options["quiet"] = word
        elif word.startswith("-"):
            return None
        else:
            positional.append(word)
    return (positional, options) if 1 <= len(positional) <= 2 else None


def json_argument(text: str) -> Any:
    """Return the value of JSON on the command line, or of the file that ``@FILE`` names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read, ``INVALID_PAYLOAD`` for text that is not JSON.
    """
    if not text.startswith("@"):
        return decode(object, text)
    try:
        return decode(object, Path(text[1:]).read_bytes())
    except OSError as error:
        raise MansionError(ErrorCode.NOT_FOUND, f"{text[1:]}: {error.strerror}") from None


def absolute_namespace(text: str) -> str:
    """Return a namespace with the slash that it begins with."""
    return "/" + text.strip("/")


def _print(value: Any) -> None:
    sys.stdout.write(encode(value, indent=2) + "\n")
