"""The edit log is read as it is on disk, and only what is new of it."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_editing import edit_log
from mansion_editing.edit_log import EditLog, append_line
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.editing.changes import Transaction


def line(number: int, who: str = "ann", *, undoes: int | None = None, redoes: int | None = None) -> bytes:
    return encode_bytes(
        Transaction(number=number, who=who, what=f"edit {number}", changes=[], undoes=undoes, redoes=redoes)
    )


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "edits" / "log.jsonl"


def test_a_building_that_nobody_edited_has_no_transactions(file: Path) -> None:
    log = EditLog(file)
    assert len(log) == 0 and log.transactions() == [] and log.landed_by("ann") == []


def test_what_others_append_is_seen(file: Path) -> None:
    log = EditLog(file)
    for number in range(1, 6):
        append_line(file, line(number, "ben"))
        assert len(log) == number and log.transaction(number).what == f"edit {number}"
    assert [entry.number for entry in log.transactions()] == [1, 2, 3, 4, 5]


def test_only_new_lines_are_read_again(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log = EditLog(file)
    for number in range(1, 50):
        append_line(file, line(number))
    assert len(log) == 49
    decoded: list[bytes] = []
    real = edit_log.decode

    def counting(kind: type, data: bytes) -> object:
        decoded.append(data)
        return real(kind, data)

    monkeypatch.setattr(edit_log, "decode", counting)
    append_line(file, line(50))
    assert len(log) == 50 and len(log.landed_by("ann")) == 50
    assert decoded == [line(50)]


def test_a_log_that_was_cut_off_and_went_on_otherwise_is_read_anew(file: Path) -> None:
    log = EditLog(file)
    for number in (1, 2):
        append_line(file, line(number))
    assert len(log) == 2
    first = len(line(1)) + 1
    with file.open("rb+") as stream:
        stream.truncate(first)
    append_line(file, line(2, "eve"))
    assert [entry.who for entry in log.transactions()] == ["ann", "eve"]
    file.unlink()
    assert len(log) == 0


def test_a_line_without_its_end_is_no_transaction_and_is_dropped_by_the_next(file: Path) -> None:
    log = EditLog(file)
    append_line(file, line(1))
    with file.open("ab") as stream:
        stream.write(line(2)[:-3])
    assert len(log) == 1
    append_line(file, line(2))
    assert [entry.number for entry in log.transactions()] == [1, 2]


def test_undoing_and_doing_again_is_each_users_own(file: Path) -> None:
    log = EditLog(file)
    for entry in (line(1), line(2, "ben"), line(3), line(4, undoes=3), line(5, undoes=1)):
        append_line(file, entry)
    assert (log.landed_by("ann"), log.taken_back_by("ann")) == ([], [3, 1])
    assert (log.landed_by("ben"), log.taken_back_by("ben")) == ([2], [])
    append_line(file, line(6, redoes=1))
    assert (log.landed_by("ann"), log.taken_back_by("ann")) == ([6], [3])
    append_line(file, line(7))
    assert (log.landed_by("ann"), log.taken_back_by("ann")) == ([6, 7], [])


@settings(deadline=None, max_examples=30)
@given(st.lists(st.integers(0, 200), min_size=1, max_size=6), st.integers(0, 300))
def test_a_line_is_appended_after_the_last_whole_one_wherever_blocks_end(
    tmp_path_factory: pytest.TempPathFactory, lengths: list[int], rest: int
) -> None:
    path = tmp_path_factory.mktemp("log") / "log.jsonl"
    whole = b"".join(b"x" * length + b"\n" for length in lengths)
    path.write_bytes(whole + b"y" * rest)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(edit_log, "BLOCK", 64)
        append_line(path, b"new")
    assert path.read_bytes() == whole + b"new\n"
