"""One process holds a lock, and none after it."""

import os
import threading
import time
from pathlib import Path

import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.file_locks import hold_lock


def test_a_lock_is_held_once_at_a_time(tmp_path: Path) -> None:
    with hold_lock(tmp_path / "lock", "taken"), pytest.raises(MansionError, match="taken") as caught:
        hold_lock(tmp_path / "lock", "taken").__enter__()
    assert caught.value.code == ErrorCode.CONFLICT
    with hold_lock(tmp_path / "lock", "taken"):
        pass


def test_the_patient_get_the_lock_when_it_is_free(tmp_path: Path) -> None:
    first = hold_lock(tmp_path / "lock", "taken")
    first.__enter__()
    timer = threading.Timer(0.1, lambda: first.__exit__(None, None, None))
    timer.start()
    with hold_lock(tmp_path / "lock", "taken", patience=20.0):
        timer.join()


def test_a_forked_child_does_not_hold_the_lock_of_its_parent(tmp_path: Path) -> None:
    with hold_lock(tmp_path / "lock", "taken"):
        child = os.fork()
        if child == 0:
            time.sleep(60)
            os._exit(0)
    try:
        with hold_lock(tmp_path / "lock", "taken", patience=5.0):
            pass
    finally:
        os.kill(child, 9)
        os.waitpid(child, 0)


def test_a_lock_file_that_was_removed_meanwhile_locks_nobody_out(tmp_path: Path) -> None:
    lock = tmp_path / "lock"
    with hold_lock(lock, "taken", remove=True):
        lock.unlink()
        with hold_lock(lock, "taken", remove=True):
            assert lock.exists()
    assert not lock.exists()
