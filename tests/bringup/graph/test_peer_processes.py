"""Ends of the processes behind endpoints, seen at once on the same machine."""

from pathlib import Path

import pytest

from mansion_bringup.graph.peer_processes import PeerProcesses

OWN = 4711
HOST = b"\x01\x0f\x78\xfd"


def endpoint(pid: int, host: bytes = HOST, entity: int = 0x1403) -> bytes:
    return host + (pid % 65536).to_bytes(2, "little") + b"\xa9\xc3" + bytes(4) + entity.to_bytes(4, "big")


class Machine:
    """A process file system to write into."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "sys/kernel").mkdir(parents=True)
        (folder / "sys/kernel/pid_max").write_text("4194304\n")

    def start(self, pid: int, start: int = 100, state: str = "S") -> None:
        (self.folder / str(pid)).mkdir(exist_ok=True)
        fields = [state, *["0"] * 18, str(start), "0"]
        (self.folder / str(pid) / "stat").write_text(f"{pid} (a (name) of it) {' '.join(fields)}\n")

    def end(self, pid: int) -> None:
        (self.folder / str(pid) / "stat").unlink()


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


@pytest.fixture
def peers(machine: Machine) -> PeerProcesses:
    return PeerProcesses(lambda: endpoint(OWN), OWN, machine.folder)


@pytest.mark.parametrize("pid", [80, 65535, 70_000, 4_000_000])
def test_a_process_that_was_noted_and_runs_no_more_has_ended(machine: Machine, peers: PeerProcesses, pid: int) -> None:
    machine.start(pid)
    peers.note([endpoint(pid)])
    assert not peers.ended(endpoint(pid))
    machine.end(pid)
    assert peers.ended(endpoint(pid))


def test_a_process_that_only_waits_for_its_parent_has_ended(machine: Machine, peers: PeerProcesses) -> None:
    machine.start(80)
    peers.note([endpoint(80)])
    machine.start(80, state="Z")
    assert peers.ended(endpoint(80))


def test_a_later_process_with_the_same_id_is_another(machine: Machine, peers: PeerProcesses) -> None:
    machine.start(80, start=100)
    peers.note([endpoint(80)])
    machine.start(80, start=900)
    assert peers.ended(endpoint(80))


def test_nothing_is_concluded_of_a_process_that_was_never_seen(peers: PeerProcesses) -> None:
    peers.note([endpoint(80)])
    assert not peers.ended(endpoint(80))
    assert not peers.ended(endpoint(81))


def test_of_two_that_fit_both_must_have_ended(machine: Machine, peers: PeerProcesses) -> None:
    machine.start(80)
    machine.start(80 + 65536)
    peers.note([endpoint(80)])
    machine.end(80)
    assert not peers.ended(endpoint(80))
    machine.end(80 + 65536)
    assert peers.ended(endpoint(80))


def test_one_endpoint_tells_of_all_of_its_participant(machine: Machine, peers: PeerProcesses) -> None:
    machine.start(80)
    peers.note([endpoint(80)])
    machine.end(80)
    assert peers.ended(endpoint(80, entity=0x1503))


def test_nothing_is_concluded_of_another_host(machine: Machine, peers: PeerProcesses) -> None:
    machine.start(80)
    there = endpoint(80, host=b"\x01\x0f\x11\x11")
    peers.note([there])
    machine.end(80)
    assert not peers.ended(there)


def test_nothing_is_concluded_where_the_middleware_writes_no_process_ids(machine: Machine) -> None:
    peers = PeerProcesses(lambda: bytes(range(16)), OWN, machine.folder)
    machine.start(80)
    peers.note([endpoint(80)])
    machine.end(80)
    assert not peers.ended(endpoint(80))


def test_endpoints_are_noted_once_this_process_has_one_of_its_own(machine: Machine) -> None:
    own: list[bytes] = []
    peers = PeerProcesses(lambda: own[0] if own else None, OWN, machine.folder)
    machine.start(80)
    peers.note([endpoint(80)])
    own.append(endpoint(OWN))
    peers.note([endpoint(80)])
    machine.end(80)
    assert peers.ended(endpoint(80))


def test_without_a_process_file_system_nothing_has_ended(tmp_path: Path) -> None:
    peers = PeerProcesses(lambda: endpoint(OWN), OWN, tmp_path / "none")
    peers.note([endpoint(80)])
    assert not peers.ended(endpoint(80))
