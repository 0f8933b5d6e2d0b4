"""Answers kept by the digest of their request: a cache folder, and recordings that replay without network."""

import os
from pathlib import Path
from typing import Protocol

import msgspec

from mansion_msgs_py.codec import prepared
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic

__all__ = ["AnswerStore", "CacheFolder", "Recorder", "Recording", "RunSettings", "StoredAnswer"]


class StoredAnswer(msgspec.Struct, frozen=True, kw_only=True):
    """An answer and what it took.

    Attributes
    ----------
    prompt : str
        The template's name, for the reader of the file.
    failure : str
        Why there was no answer; recordings keep it, so that they replay to the same result.
    """

    digest: str
    prompt: str
    text: str
    model: str = ""
    input_tokens: int = 0
    output_tokens: int = 0
    seconds: float = 0.0
    cut: bool = False
    failure: str = ""


class AnswerStore(Protocol):
    """Something that may know an answer."""

    def get(self, digest: str) -> StoredAnswer | None:
        """Return the answer of that digest, if it is there."""

    def put(self, answer: StoredAnswer) -> None:
        """Keep an answer."""


class CacheFolder:
    """A folder with a file for each answer; a damaged file counts as none."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def _file(self, digest: str) -> Path:
        return self._folder / digest[:2] / f"{digest}.json"

    def get(self, digest: str) -> StoredAnswer | None:
        """See `AnswerStore.get`."""
        try:
            found = msgspec.json.decode(self._file(digest).read_bytes(), type=prepared(StoredAnswer))
        except (OSError, msgspec.MsgspecError, UnicodeError):
            return None
        return found if found.digest == digest else None

    def put(self, answer: StoredAnswer) -> None:
        """Write atomically, so that two processes cannot see half a file."""
        write_atomic(self._file(answer.digest), msgspec.json.encode(answer))


class RunSettings(msgspec.Struct, frozen=True, kw_only=True):
    """What a replay must share with the run that was recorded: the first line of a recording."""

    pieces: tuple[str, ...]
    repairs: int
    input_price: float
    output_price: float


class Recorder:
    """Appends each answer to a file, one JSON line an answer; several processes may share the file."""

    def __init__(self, file: Path, run: RunSettings) -> None:
        self._file = file
        file.parent.mkdir(parents=True, exist_ok=True)
        self._append(msgspec.json.encode(run))

    def get(self, digest: str) -> StoredAnswer | None:
        """A recorder knows no answers."""
        return None

    def put(self, answer: StoredAnswer) -> None:
        """Append one line in one write."""
        self._append(msgspec.json.encode(answer))

    def _append(self, line: bytes) -> None:
        handle = os.open(self._file, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o644)
        try:
            os.write(handle, line + b"\n")
        finally:
            os.close(handle)


class Recording:
    """A recorded file; what it does not hold is not asked elsewhere.

    Attributes
    ----------
    run : RunSettings, optional
        Settings of the recorded run.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a missing file, ``INVALID_PAYLOAD`` with the line that is not an answer.
    """

    def __init__(self, file: Path) -> None:
        try:
            lines = file.read_bytes().splitlines()
        except OSError:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no recording {file}") from None
        self.run: RunSettings | None = None
        self._answers: dict[str, StoredAnswer] = {}
        for number, line in enumerate(lines, start=1):
            if not line.strip():
                continue
            try:
                if line.startswith(b'{"pieces"'):
                    self.run = self.run or msgspec.json.decode(line, type=prepared(RunSettings))
                    continue
                answer = msgspec.json.decode(line, type=prepared(StoredAnswer))
            except (msgspec.MsgspecError, UnicodeError) as error:
                raise MansionError(
                    ErrorCode.INVALID_PAYLOAD, f"line {number} of the recording {file}: {error}"
                ) from None
            earlier = self._answers.get(answer.digest)
            if earlier is None or (earlier.failure and not answer.failure):
                self._answers[answer.digest] = answer

    @property
    def model(self) -> str:
        """Model of the first answer."""
        return next((a.model for a in self._answers.values() if a.model), "")

    def get(self, digest: str) -> StoredAnswer | None:
        """See `AnswerStore.get`."""
        return self._answers.get(digest)

    def put(self, answer: StoredAnswer) -> None:
        """A recording stays as it is."""
