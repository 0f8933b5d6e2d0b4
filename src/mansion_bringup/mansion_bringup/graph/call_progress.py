"""Progress of a long call: what its node publishes meanwhile, as one line on standard error."""

import os
import sys
import time
from collections.abc import Callable
from typing import IO, Any, Final

from mansion_msgs_py.late_imports import importing

__all__ = ["BEGIN", "CallProgress", "progress_line", "progress_topic"]

BEGIN: Final = 1.0
"""Seconds of a call after which something is said."""

AGAIN: Final = 10.0
"""Seconds between two lines that only say that a call lasts, where lines stay."""


def progress_topic(service: str) -> str | None:
    """Return the topic on which the node of a service publishes how far it is, both below the namespace.

    Examples
    --------
    >>> progress_topic("build_building"), progress_topic("skills/move_to"), progress_topic("scene/open")
    ('progress', 'skill_progress', None)
    """
    if service.rsplit("/", 1)[-1] == "build_building":
        return "progress"
    return "skill_progress" if "skills/" in service else None


def progress_line(topic: str, text: str, arguments: Any = None) -> str | None:
    """Return the text of a message of such a topic; None if it belongs to another session than the call's.

    Parameters
    ----------
    topic : str
        What `progress_topic` returned.
    text : str
        A `Progress` or `SkillProgress` as JSON.
    arguments : dict, optional
        Arguments of the call.
    """
    with importing:
        from mansion_msgs_py.codec import decode
        from mansion_msgs_py.world import Progress, SkillProgress

    if topic == "progress":
        build = decode(Progress, text)
        return f"[{build.done}/{build.total}] {build.message}"
    skill = decode(SkillProgress, text)
    session = (arguments.get("session") if isinstance(arguments, dict) else None) or "default"
    return f"{skill.fraction:.0%} {skill.message}" if skill.session == session else None


class CallProgress:
    """Says on standard error what a call does once it takes long: one changing line on a terminal, lines elsewhere.

    Parameters
    ----------
    service : str
    quiet : bool
        Say nothing.
    stream : text file, optional
        Standard error when absent.
    clock : callable
        Seconds.
    """

    def __init__(
        self,
        service: str,
        *,
        quiet: bool = False,
        stream: IO[str] | None = None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._service, self._quiet, self._clock = service, quiet, clock
        self._stream = sys.stderr if stream is None else stream
        self._changing = self._stream.isatty() and os.environ.get("TERM") != "dumb"
        self._begun = clock()
        self._text: str | None = None
        self._shown: str | None = None
        self._said_at = self._begun

    def told(self, text: str) -> None:
        """Take what the node says that it does now."""
        self._text = text
        self.tick()

    def tick(self) -> None:
        """Show what is new; to be called about once a second."""
        now = self._clock()
        passed = now - self._begun
        if self._quiet or passed < BEGIN:
            return
        text = self._text or f"{self._service}: no answer yet"
        if self._changing:
            self._stream.write(f"\r\033[K{text}, {passed:.0f} s")
        elif text != self._shown or now - self._said_at >= AGAIN:
            self._stream.write(f"{text}, {passed:.0f} s\n")
        else:
            return
        self._shown, self._said_at = text, now
        self._stream.flush()

    def end(self) -> None:
        """Take a changing line away."""
        if self._changing and self._shown is not None:
            self._stream.write("\r\033[K")
            self._stream.flush()
