"""The edit log of a building, ``edits/log.jsonl``: one `Transaction` a line, of which only new lines are read again."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Final

import msgspec

from mansion_msgs_py.codec import decode
from mansion_msgs_py.editing.changes import Transaction

__all__ = ["EditLog", "append_line"]

BLOCK: Final = 65_536
"""Bytes that are read at once where a file is read from its end."""


class _Entry(msgspec.Struct, frozen=True):
    """What a line says of who did or undid something."""

    who: str
    undoes: int | None = None
    redoes: int | None = None


@dataclass(frozen=True)
class _Line:
    start: int
    end: int
    entry: _Entry


class EditLog:
    """The log of one building, as it is on disk whenever it is asked.

    Parameters
    ----------
    file : Path
    """

    def __init__(self, file: Path) -> None:
        self.file = file
        self._lines: list[_Line] = []
        self._last = b""

    def __len__(self) -> int:
        """Return the number of transactions."""
        return len(self._known())

    def transactions(self) -> list[Transaction]:
        """Return all transactions, oldest first."""
        return [self.transaction(number) for number in range(1, len(self._known()) + 1)]

    def transaction(self, number: int) -> Transaction:
        """Return the transaction of a number, which count from 1."""
        line = self._lines[number - 1]
        with self.file.open("rb") as stream:
            return decode(Transaction, _read(stream, line))

    def landed_by(self, who: str) -> list[int]:
        """Return the numbers of what a user has landed and not taken back, in its order."""
        return _stacks(self._known(), who)[0]

    def taken_back_by(self, who: str) -> list[int]:
        """Return the numbers of what a user has undone and can do again, the next one last."""
        return _stacks(self._known(), who)[1]

    def _known(self) -> Sequence[_Line]:
        """Read what was added since the last time; all of it where the last line is another one by now."""
        try:
            with self.file.open("rb") as stream:
                if self._lines and _read(stream, self._lines[-1]) != self._last:
                    self._lines = []
                start = self._lines[-1].end if self._lines else 0
                stream.seek(start)
                # What has no end of its line yet is not a transaction.
                for line in stream.read().split(b"\n")[:-1]:
                    end = start + len(line) + 1
                    if line.strip():
                        self._lines.append(_Line(start, end, decode(_Entry, line)))
                        self._last = line + b"\n"
                    start = end
        except FileNotFoundError:
            self._lines = []
        return self._lines


def _read(stream: BinaryIO, line: _Line) -> bytes:
    stream.seek(line.start)
    return stream.read(line.end - line.start)


def _stacks(lines: Sequence[_Line], who: str) -> tuple[list[int], list[int]]:
    """Return the numbers of what `who` can undo and redo, the next one last."""
    undoable: list[int] = []
    redoable: list[int] = []
    for number, line in enumerate(lines, 1):
        if line.entry.who != who:
            continue
        if line.entry.undoes is not None:
            redoable.append(undoable.pop())
        else:
            undoable.append(number)
            if line.entry.redoes is not None:
                redoable.pop()
            else:
                redoable.clear()
    return undoable, redoable


def append_line(path: Path, line: bytes) -> None:
    """Append one line, after dropping what an interrupted writer left of a former one."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("ab+") as stream:
        stream.truncate(_whole_lines(stream))
        stream.seek(0, os.SEEK_END)
        stream.write(line + b"\n")
        stream.flush()
        os.fsync(stream.fileno())


def _whole_lines(stream: BinaryIO) -> int:
    """Return the length of a file up to the end of its last whole line."""
    end = stream.seek(0, os.SEEK_END)
    while end:
        start = max(0, end - BLOCK)
        stream.seek(start)
        found = stream.read(end - start).rfind(b"\n")
        if found >= 0:
            return start + found + 1
        end = start
    return 0
