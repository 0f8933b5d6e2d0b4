"""Hostile input for every service, payload and command does no harm; benchmarks/robustness/fuzz.py goes on for long."""

import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from fuzz_guards import WriteGuard, outcome_of
from fuzzing import Fuzzer, Stock, make_stock
from mansion_bringup.interfaces import PAYLOADS, SERVICES
from mansion_msgs_py.errors import ErrorCode, MansionError

CASES = 120
SEED = 20


@pytest.fixture(scope="module")
def stock(tmp_path_factory: pytest.TempPathFactory) -> Stock:
    return make_stock(tmp_path_factory.mktemp("stock") / "house")


@pytest.fixture(scope="module")
def guard(tmp_path_factory: pytest.TempPathFactory) -> WriteGuard:
    return WriteGuard(tmp_path_factory.getbasetemp())


@pytest.fixture
def fuzzer(stock: Stock, guard: WriteGuard, tmp_path: Path) -> Iterator[Fuzzer]:
    before = Path.cwd()
    yield Fuzzer(stock, tmp_path / "run", SEED, guard)
    os.chdir(before)


def test_hostile_input_is_answered_or_refused(fuzzer: Fuzzer) -> None:
    outcomes = {case: fuzzer.run(case) for case in map(fuzzer.case, range(CASES))}
    harm = {f"{case.number} {case.target}": outcome for case, outcome in outcomes.items() if not outcome.sound}
    assert harm == {}
    verdicts = Counter(outcome.verdict for outcome in outcomes.values())
    assert verdicts["answered"] > CASES / 4 and verdicts["refused"] > CASES / 4


def test_a_case_is_the_same_for_a_seed(stock: Stock, fuzzer: Fuzzer, guard: WriteGuard, tmp_path: Path) -> None:
    again, other = (Fuzzer(stock, tmp_path / "other", seed, guard) for seed in (SEED, SEED + 1))
    numbers = range(50)
    assert [*map(again.case, numbers)] == [*map(fuzzer.case, numbers)] != [*map(other.case, numbers)]


def test_cases_go_to_every_service_payload_and_kind_of_file(fuzzer: Fuzzer) -> None:
    targets = set(fuzzer.targets)
    assert {entry.name for entry in SERVICES} <= targets
    assert {f"payload {name}" for name in PAYLOADS} <= targets
    assert {"file building.json", "file floors/floor_1/scene.json", "mansion plan", "mansion check"} <= targets


def test_what_does_harm_is_told(guard: WriteGuard, tmp_path: Path) -> None:
    def fails() -> None:
        raise MansionError(ErrorCode.INTERNAL, "broken")

    def spins() -> None:
        while True:
            pass

    def escapes() -> None:
        (guard_root / "outside").write_text("")

    def refuses() -> None:
        raise MansionError(ErrorCode.NOT_FOUND, "there is none")

    guard_root = Path(os.path.expanduser("~"))
    assert outcome_of(lambda: {}["key"], guard).what.startswith("KeyError")  # type: ignore[index]
    assert outcome_of(fails, guard).verdict == "fault"
    assert outcome_of(spins, guard, seconds=0.2).verdict == "hang"
    assert outcome_of(escapes, guard).verdict == "outside" and not (guard_root / "outside").exists()
    assert outcome_of(refuses, guard).verdict == "refused"
    assert outcome_of(lambda: (tmp_path / "inside").write_text(""), guard).verdict == "answered"


@pytest.mark.parametrize("act", ["os.mkdir", "os.rename", "os.remove", "os.symlink", "os.open"])
def test_writing_outside_is_prevented_however_it_is_done(act: str, guard: WriteGuard, tmp_path: Path) -> None:
    inside, outside = tmp_path / "inside", Path("/var/tmp") / f"mansion-{os.getpid()}"
    inside.touch()
    calls = {
        "os.mkdir": lambda: os.mkdir(outside),
        "os.rename": lambda: os.rename(inside, outside),
        "os.remove": lambda: os.remove(outside),
        "os.symlink": lambda: os.symlink(inside, outside),
        "os.open": lambda: os.open(outside, os.O_CREAT | os.O_WRONLY),
    }
    assert outcome_of(calls[act], guard).verdict == "outside"
    assert inside.exists() and not outside.exists()
