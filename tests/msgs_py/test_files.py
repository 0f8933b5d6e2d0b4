"""Writing files whole."""

import os
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from mansion_msgs_py.files import remove_remains, write_atomic


def _mode(path: Path) -> int:
    return path.stat().st_mode & 0o777


def test_a_file_is_written_with_its_folders_and_nothing_beside_it(tmp_path: Path) -> None:
    path = tmp_path / "a" / "b" / "scene.json"
    write_atomic(path, b"one")
    write_atomic(path, b"two", durable=True)
    assert path.read_bytes() == b"two"
    assert list(path.parent.iterdir()) == [path]


def test_a_failed_write_leaves_the_former_file_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "scene.json"
    write_atomic(path, b"former")

    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        write_atomic(path, b"new", durable=True)
    assert path.read_bytes() == b"former"
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_takes_its_name_when_all_of_it_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk that is full refuses the last bytes when they leave the buffer, which must not be after the renaming."""
    written: list[bytes] = []
    replace = Path.replace

    def watched(self: Path, target: Path) -> Path:
        written.append(self.read_bytes())
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", watched)
    write_atomic(tmp_path / "record.json", b"{}")
    assert written == [b"{}"]


def test_only_a_durable_write_waits_for_the_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    synced: list[int] = []
    monkeypatch.setattr(os, "fsync", synced.append)
    write_atomic(tmp_path / "quick", b"x")
    assert synced == []
    write_atomic(tmp_path / "sure", b"x", durable=True)
    assert len(synced) == 1


def test_permissions_are_those_of_the_file_replaced_or_of_any_new_file(tmp_path: Path) -> None:
    plain, path = tmp_path / "plain", tmp_path / "scene.json"
    plain.write_bytes(b"")
    write_atomic(path, b"one")
    assert _mode(path) == _mode(plain)
    path.chmod(0o640)
    write_atomic(path, b"two")
    assert _mode(path) == 0o640
    write_atomic(path, b"three", mode=0o600)
    assert _mode(path) == 0o600
    path.chmod(0o666)
    write_atomic(path, b"four")
    assert _mode(path) == 0o666, "the process's mask does not narrow what stood there"


def test_what_a_killed_writer_left_is_removed_and_nothing_else(tmp_path: Path) -> None:
    kept = [tmp_path / name for name in ("scene.json", ".scene.json", ".hidden.txt", ".world.json.backup")]
    for path in kept:
        path.write_bytes(b"kept")
    left = tmp_path / f".scene.json.{'0a' * 8}"
    left.write_bytes(b"half")
    remove_remains(tmp_path)
    assert sorted(tmp_path.iterdir()) == sorted(kept)


def test_what_is_being_written_is_not_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "world.json"
    fsync = os.fsync

    def another_looks(descriptor: int) -> None:
        remove_remains(tmp_path)
        fsync(descriptor)

    monkeypatch.setattr(os, "fsync", another_looks)
    write_atomic(path, b"new", durable=True)
    assert path.read_bytes() == b"new"


def test_writers_and_those_who_clear_up_do_not_disturb_each_other(tmp_path: Path) -> None:
    done = threading.Event()

    def clear_up() -> None:
        while not done.is_set():
            remove_remains(tmp_path)

    def write(number: int) -> None:
        for turn in range(150):
            write_atomic(tmp_path / f"{number}.json", f"{turn}".encode())

    cleaner = threading.Thread(target=clear_up)
    cleaner.start()
    with ThreadPoolExecutor(3) as pool:
        list(pool.map(write, range(3)))
    done.set()
    cleaner.join()
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {f"{n}.json": "149" for n in range(3)}
