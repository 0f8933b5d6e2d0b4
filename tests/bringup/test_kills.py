"""Killed at any time, a program loses nothing that it acknowledged, and leaves nothing.

``benchmarks/robustness/kills.py`` kills many more.
"""

import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from killing import SUBJECTS, Subject, killed

TIMES = random.Random(4)


@pytest.mark.parametrize(
    ("name", "share"),
    [
        (name, round(TIMES.random(), 3))
        for name, count in {"edit": 3, "skill": 3, "build": 1}.items()
        for _ in range(count)
    ],
)
def test_nothing_is_lost_and_nothing_left(name: str, share: float, tmp_path: Path) -> None:
    assert killed(SUBJECTS[name], tmp_path / name, share) == []


LEAVES_ALL = """
import subprocess, sys, time
from pathlib import Path
subprocess.Popen(["sleep", "100"])
Path(sys.argv[1], ".scene.json.0123456789abcdef").touch()
print("ready", flush=True)
print("1", flush=True)
time.sleep(100)
"""


def test_what_is_left_or_lost_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def lost(folder: Path, acknowledged: list[str]) -> Iterator[str]:
        yield f"{acknowledged} is lost"

    monkeypatch.setattr("killing.TO_END", 0.3)
    careless = Subject(LEAVES_ALL, 1.0, lambda folder: None, lost)
    assert killed(careless, tmp_path / "careless", 1.0) == [
        "a process is left",
        "['1'] is lost",
        ".scene.json.0123456789abcdef is left",
    ]
