"""Domains for private graphs."""

import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, suppress

import pytest

from mansion_bringup.graph import domains
from mansion_bringup.graph.domains import CLAIM, CLAIMS_KEPT, DOMAIN_GAIN, FIRST_UNICAST, PORT_BASE, free_domain
from mansion_msgs_py.errors import ErrorCode, MansionError

OTHER = "from mansion_bringup.graph.domains import free_domain; print(free_domain({start}), flush=True); input()"


@pytest.fixture(autouse=True)
def no_claims(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Give back what a test claims."""
    kept = type(domains._claims)(maxlen=CLAIMS_KEPT)
    monkeypatch.setattr(domains, "_claims", kept)
    yield
    for claim in kept:
        claim.close()


def port(domain: int, offset: int) -> int:
    return PORT_BASE + DOMAIN_GAIN * domain + offset


def test_a_domain_is_given_once() -> None:
    given = [free_domain(40) for _ in range(5)]
    assert len(set(given)) == 5


def test_two_processes_that_begin_at_the_same_domain_are_given_different_ones() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", OTHER.format(start=60)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as other:
        assert other.stdin is not None and other.stdout is not None
        theirs = int(other.stdout.readline())
        ours = free_domain(60)
        other.stdin.close()
    assert theirs != ours


def test_a_domain_comes_back_once_its_process_has_ended() -> None:
    script = OTHER.format(start=70)
    first = subprocess.run([sys.executable, "-c", script], input="\n", capture_output=True, text=True, check=True)
    second = subprocess.run([sys.executable, "-c", script], input="\n", capture_output=True, text=True, check=True)
    assert first.stdout == second.stdout


@pytest.mark.parametrize("participant", [0, 1, 5])
def test_a_domain_with_a_participant_is_not_free(participant: int) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as used:
        domain = free_domain(80)
        domains._claims.pop().close()
        used.bind(("127.0.0.1", port(domain, FIRST_UNICAST + 2 * participant)))
        assert free_domain(domain - 1) != domain


def test_the_domain_of_the_environment_is_not_given(monkeypatch: pytest.MonkeyPatch) -> None:
    domain = free_domain(20)
    domains._claims.pop().close()
    monkeypatch.setenv("ROS_DOMAIN_ID", str(domain))
    assert free_domain(domain - 1) != domain


def test_old_claims_end_so_that_a_process_may_ask_any_number_of_times() -> None:
    given = [free_domain(0) for _ in range(300)]
    assert len(given) == 300
    assert len(set(given[-CLAIMS_KEPT:])) == CLAIMS_KEPT


def test_it_says_when_every_domain_is_in_use(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(domains, "LAST_DOMAIN", 3)
    with ExitStack() as stack:
        for domain in (1, 2, 3):
            used = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
            with suppress(OSError):  # when another process has it already
                used.bind(("127.0.0.1", port(domain, CLAIM)))
        with pytest.raises(MansionError) as caught:
            free_domain(0)
    assert caught.value.code is ErrorCode.UNAVAILABLE
