"""Segments of noted processes go when these are dead; those of the living and of everybody else stay."""

import contextlib
import fcntl
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.shared_memory import SegmentLedger, ledger_folders, remove_left_behind

SHM = Path("/dev/shm")
PATIENCE = 30.0
"""Seconds for a process to say what is expected of it."""

DATA, OTHER, PORT = "fastrtps_0123456789abcdef", "fastrtps_fedcba9876543210", "fastrtps_port7411"

HOLDER = """
import fcntl, mmap, sys
from pathlib import Path

shm, kept = Path(sys.argv[1]), []
for word in sys.argv[2:]:
    action, name = word.split(":")
    if action in ("own", "share", "map"):
        memory = open(shm / name, "a+b")
        if memory.tell() == 0:
            memory.truncate(4096)
        kept.append(mmap.mmap(memory.fileno(), 0))
    if action in ("own", "share", "open", "lock"):
        kept.append(open(shm / (name + ("_sl" if action == "share" else "_el")), "a+b"))
    if action in ("own", "share", "lock"):
        fcntl.flock(kept[-1], fcntl.LOCK_SH if action == "share" else fcntl.LOCK_EX)
        if "port" in name:
            (shm / f"sem.{name}_mutex").write_bytes(b"1")
print("ready", flush=True)
sys.stdin.read()
"""
"""A process that owns, shares, opens, locks or maps the named segments until it is ended."""

NODE = """
import sys, threading
import rclpy
from std_msgs.msg import String

name, word = sys.argv[1], "hello"

def listen():
    global word
    for line in sys.stdin:
        word = line.strip()
    rclpy.try_shutdown()

rclpy.init()
node = rclpy.create_node(name)
publisher = node.create_publisher(String, "said", 10)
node.create_subscription(String, "said", lambda message: print(message.data, flush=True), 10)
node.create_timer(0.05, lambda: publisher.publish(String(data=f"{name}: {word}")))
threading.Thread(target=listen, daemon=True).start()
print("ready", flush=True)
try:
    rclpy.spin(node)
except rclpy.executors.ExternalShutdownException:
    pass
"""
"""A node that says what it is told on its input, and prints all that it hears; it ends with its input."""

SUPERVISOR = """
import subprocess, sys
from pathlib import Path
from mansion_bringup.graph.shared_memory import SegmentLedger

shm, folder, *command = sys.argv[1:]
node = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
while node.stdout.readline().strip() != "ready":
    pass
ledger = SegmentLedger(Path(shm), [Path(folder)])
ledger.note([node.pid])
print(node.pid, *sorted(ledger.names), flush=True)
print("ready", flush=True)
sys.stdin.read()
"""
"""A supervisor that notes what the process of the given command owns."""


class Child:
    """A process, and the lines that it has printed."""

    def __init__(self, *command: str, environment: dict[str, str] | None = None) -> None:
        self.command = [sys.executable, "-c", *command]
        self.process = subprocess.Popen(
            self.command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        self.lines: list[str] = []
        self.changed = threading.Condition()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            with self.changed:
                self.lines.append(line.strip())
                self.changed.notify_all()

    @property
    def pid(self) -> int:
        return self.process.pid

    def say(self, word: str) -> None:
        assert self.process.stdin is not None
        print(word, file=self.process.stdin, flush=True)

    def expect(self, line: str) -> None:
        """Wait until the process prints this line, unless it has."""
        with self.changed:
            came = self.changed.wait_for(lambda: line in self.lines, PATIENCE)
        assert came, f"no {line!r} in {set(self.lines)}; status {self.process.poll()}"

    def kill(self) -> None:
        self.process.kill()
        self.process.wait()

    def end(self) -> None:
        assert self.process.stdin is not None
        with contextlib.suppress(OSError):
            self.process.stdin.close()
        try:
            self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.kill()


@pytest.fixture
def shm(tmp_path: Path) -> Path:
    """Return a folder in the place of /dev/shm."""
    folder = tmp_path / "shm"
    folder.mkdir()
    return folder


@pytest.fixture
def ledger(tmp_path: Path, shm: Path) -> SegmentLedger:
    """Return an empty ledger whose file lies in ``ledgers``."""
    return SegmentLedger(shm, [tmp_path / "ledgers"])


@pytest.fixture
def hold(shm: Path) -> Iterator[Callable[..., Child]]:
    """Yield a function that starts a holder of segments and waits until it holds them."""
    started: list[Child] = []

    def start(*words: str) -> Child:
        started.append(Child(HOLDER, str(shm), *words))
        started[-1].expect("ready")
        return started[-1]

    yield start
    for child in started:
        child.kill()


def _files(folder: Path) -> set[str]:
    return set(os.listdir(folder))


def _of(*names: str) -> set[str]:
    """Return the names of the files of segments with exclusive locks."""
    locks = {f"{name}_el" for name in names}
    return {*names, *locks, *(f"sem.{name}_mutex" for name in names if "port" in name)}


def test_what_a_killed_process_owned_is_removed_and_the_ledger_with_it(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], tmp_path: Path
) -> None:
    node = hold(f"own:{DATA}", f"own:{PORT}")
    ledger.note([node.pid])
    assert ledger.names == {DATA, PORT}
    assert len(_files(tmp_path / "ledgers")) == 1
    node.kill()
    assert ledger.remove_dead() == [DATA, PORT]
    assert _files(shm) == _files(tmp_path / "ledgers") == set()


def test_what_a_living_process_owns_stays_in_place_and_in_the_ledger(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], tmp_path: Path
) -> None:
    living, dead = hold(f"own:{DATA}", f"own:{PORT}"), hold(f"own:{OTHER}")
    ledger.note([living.pid, dead.pid])
    dead.kill()
    assert ledger.remove_dead() == [OTHER]
    assert _files(shm) == _of(DATA, PORT)
    assert ledger.names == {DATA, PORT}
    living.kill()
    assert ledger.remove_dead() == [DATA, PORT]
    assert _files(tmp_path / "ledgers") == set()


def test_segments_of_processes_that_are_not_noted_stay(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    foreign, node = hold(f"own:{OTHER}", f"own:{PORT}"), hold(f"own:{DATA}")
    ledger.note([node.pid])
    foreign.kill()
    node.kill()
    assert ledger.remove_dead() == [DATA]
    assert _files(shm) == _of(OTHER, PORT)


def test_a_peer_that_opens_the_lock_file_and_the_memory_owns_nothing(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    owner, peer = hold(f"own:{DATA}"), hold(f"open:{DATA}", f"map:{DATA}")
    ledger.note([peer.pid])
    owner.kill()
    peer.kill()
    assert ledger.names == frozenset()
    assert ledger.remove_dead() == []
    assert _files(shm) == _of(DATA)


@pytest.mark.parametrize("alive", [True, False])
def test_a_port_whose_name_is_used_again_is_its_new_owners(
    alive: bool, shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], tmp_path: Path
) -> None:
    node = hold(f"own:{PORT}")
    ledger.note([node.pid])
    node.kill()
    for name in _files(shm):
        (shm / name).unlink()
    other = hold(f"own:{PORT}")
    if not alive:
        other.kill()
    assert ledger.remove_dead() == []
    assert _files(shm) == _of(PORT)
    assert _files(tmp_path / "ledgers") == set()


def test_a_noted_lock_file_that_another_process_has_locked_since_is_left_alone(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node = hold(f"own:{PORT}")
    ledger.note([node.pid])
    node.kill()
    with open(shm / f"{PORT}_el") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        assert ledger.remove_dead() == []
        assert _files(shm) == _of(PORT)
    assert ledger.remove_dead() == [PORT]


def test_a_shared_port_stays_until_its_last_reader_is_dead(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node, foreign = hold(f"share:{PORT}"), hold(f"share:{PORT}")
    ledger.note([node.pid])
    node.kill()
    assert ledger.remove_dead() == []
    assert _files(shm) == {PORT, f"{PORT}_sl", f"sem.{PORT}_mutex"}
    foreign.kill()
    assert ledger.remove_dead() == [PORT]
    assert _files(shm) == set()


def test_a_port_without_a_lock_stays_while_a_process_has_it_in_memory(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node, peer = hold(f"map:{PORT}"), hold(f"map:{PORT}")
    ledger.note([node.pid])
    assert ledger.names == {PORT}
    node.kill()
    assert ledger.remove_dead() == []
    assert _files(shm) == {PORT}
    peer.kill()
    assert ledger.remove_dead() == [PORT]
    assert _files(shm) == set()


@pytest.mark.parametrize("noted", ["own", "map"])
@pytest.mark.parametrize("reader", ["own", "share"])
def test_a_port_that_another_process_reads_afterwards_is_that_readers(
    noted: str, reader: str, shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node = hold(f"{noted}:{PORT}")
    ledger.note([node.pid])
    node.kill()
    (shm / f"{PORT}_el").unlink(missing_ok=True)
    foreign = hold(f"{reader}:{PORT}")
    files = _files(shm)
    assert ledger.remove_dead() == []
    foreign.kill()
    assert ledger.remove_dead() == []
    assert _files(shm) == files


def test_a_segment_that_is_noted_before_it_is_made_is_removed(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node = hold(f"lock:{DATA}")
    ledger.note([node.pid])
    (shm / DATA).touch()
    node.kill()
    assert ledger.remove_dead() == [DATA]
    assert _files(shm) == set()


def test_a_port_that_another_process_made_anew_stays(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node = hold(f"own:{PORT}")
    ledger.note([node.pid])
    node.kill()
    (shm / PORT).unlink()
    (shm / PORT).touch()
    assert ledger.remove_dead() == []
    assert _files(shm) == _of(PORT)


def test_a_port_noted_before_and_after_it_gets_its_lock_is_removed_as_one(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], tmp_path: Path
) -> None:
    writer = hold(f"map:{PORT}")
    ledger.note([writer.pid])
    reader = hold(f"own:{PORT}")
    ledger.note([writer.pid, reader.pid])
    writer.kill()
    reader.kill()
    assert ledger.remove_dead() == [PORT]
    assert _files(shm) == _files(tmp_path / "ledgers") == set()


def test_a_port_that_other_users_can_map_is_left_alone(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child]
) -> None:
    node = hold(f"map:{PORT}")
    ledger.note([node.pid])
    node.kill()
    (shm / PORT).chmod(0o666)
    assert ledger.remove_dead() == []
    assert _files(shm) == {PORT}


def test_files_of_another_user_are_left_alone(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], monkeypatch: pytest.MonkeyPatch
) -> None:
    node = hold(f"own:{DATA}", f"own:{PORT}")
    ledger.note([node.pid])
    node.kill()
    user = os.geteuid()
    monkeypatch.setattr(os, "geteuid", lambda: user + 1)
    assert ledger.remove_dead() == []
    assert _files(shm) == _of(DATA, PORT)


def test_segments_that_are_gone_already_are_no_error(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], tmp_path: Path
) -> None:
    node = hold(f"own:{DATA}", f"own:{PORT}")
    ledger.note([node.pid])
    node.kill()
    (shm / f"{DATA}_el").unlink()
    for name in _of(PORT):
        (shm / name).unlink()
    assert ledger.remove_dead() == [DATA]
    assert _files(shm) == _files(tmp_path / "ledgers") == set()


def test_a_process_that_is_gone_is_no_error(ledger: SegmentLedger, hold: Callable[..., Child]) -> None:
    node = hold(f"own:{DATA}")
    node.kill()
    ledger.note([node.pid])
    assert ledger.names == frozenset()


def test_looks_closer_than_the_interval_are_left_out(ledger: SegmentLedger, hold: Callable[..., Child]) -> None:
    ledger.note([hold(f"own:{DATA}").pid], interval=1000.0)
    ledger.note([hold(f"own:{OTHER}").pid], interval=1000.0)
    assert ledger.names == {DATA}


@pytest.mark.parametrize("there", [True, False])
def test_without_segments_no_file_is_made(there: bool, shm: Path, ledger: SegmentLedger, tmp_path: Path) -> None:
    if not there:
        shm.rmdir()
    ledger.note([os.getpid()])
    assert ledger.remove_dead() == remove_left_behind(shm, [tmp_path / "ledgers"]) == []
    assert _files(tmp_path) <= {"shm"}


def test_the_ledger_of_a_dead_supervisor_is_followed_and_that_of_a_living_one_is_not(shm: Path, tmp_path: Path) -> None:
    folder = tmp_path / "ledgers"
    holder = [sys.executable, "-c", HOLDER, str(shm), f"own:{DATA}", f"own:{PORT}"]
    supervisor = Child(SUPERVISOR, str(shm), str(folder), *holder)
    supervisor.expect("ready")
    node = int(supervisor.lines[0].split()[0])
    assert remove_left_behind(shm, [folder]) == []
    supervisor.kill()
    _wait(lambda: _has_ended(node))
    assert remove_left_behind(shm, [folder]) == [DATA, PORT]
    assert _files(shm) == _files(folder) == set()


def test_a_ledger_is_dead_when_its_process_id_is_another_process_by_now(
    shm: Path, ledger: SegmentLedger, hold: Callable[..., Child], tmp_path: Path
) -> None:
    node = hold(f"own:{DATA}")
    ledger.note([node.pid])
    node.kill()
    (file,) = (tmp_path / "ledgers").iterdir()
    pid, start, number = file.name.split("-")
    assert int(pid) == os.getpid()
    assert remove_left_behind(shm, [file.parent]) == []
    file.rename(file.with_name(f"{pid}-{int(start) - 1}-{number}"))
    assert remove_left_behind(shm, [file.parent]) == [DATA]


def test_a_ledger_that_is_no_ledger_removes_nothing_and_is_deleted(shm: Path, tmp_path: Path) -> None:
    folder = tmp_path / "ledgers"
    folder.mkdir(mode=0o700)
    (shm / DATA).touch()
    status = (shm / DATA).stat()
    identity = f"[{status.st_dev},{status.st_ino},{status.st_mtime_ns}]"
    texts = ["", "{}", f'[{{"name":"../shm/{DATA}","memory":{identity}}}]']
    for number, text in enumerate(texts):
        (folder / f"0-1-{number}.json").write_text(text)
    (folder / "notes.json").touch()
    assert remove_left_behind(shm, [folder]) == []
    assert _files(shm) == {DATA}
    assert _files(folder) == {"notes.json"}


def test_the_file_lies_in_the_first_folder_that_is_private(
    shm: Path, hold: Callable[..., Child], tmp_path: Path
) -> None:
    shared, missing, private = tmp_path / "shared", tmp_path / "absent/folder", tmp_path / "private"
    linked = tmp_path / "linked"
    shared.mkdir()
    shared.chmod(0o755)
    (tmp_path / "target").mkdir(mode=0o700)
    linked.symlink_to(tmp_path / "target")
    ledger = SegmentLedger(shm, [shared, linked, missing, private])
    ledger.note([hold(f"own:{DATA}").pid])
    assert _files(shared) == _files(linked) == set()
    assert len(_files(private)) == 1
    assert private.stat().st_mode & 0o777 == 0o700


def test_without_a_private_folder_the_ledger_is_kept_in_memory(shm: Path, hold: Callable[..., Child]) -> None:
    ledger = SegmentLedger(shm, [])
    node = hold(f"own:{DATA}")
    ledger.note([node.pid])
    node.kill()
    assert ledger.remove_dead() == [DATA]


def test_ledgers_lie_in_the_runtime_folder_or_else_the_temporary_one(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    assert ledger_folders()[0].parent == tmp_path
    monkeypatch.delenv("XDG_RUNTIME_DIR")
    (folder,) = ledger_folders()
    assert folder.name.endswith(f"-{os.geteuid()}")


def _has_ended(pid: int) -> bool:
    """Whether the process, somebody else's child, is gone or waits for its parent, with all of its threads."""
    try:
        state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        return state == "Z" and len(os.listdir(f"/proc/{pid}/task")) == 1
    except OSError:
        return True


def _wait(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert time.monotonic() < deadline
        time.sleep(0.02)


class Nodes:
    """Real nodes that use shared memory; what they leave is removed in the end."""

    def __init__(self) -> None:
        self.domain = free_domain()
        self.running: list[Child] = []
        self.everything = SegmentLedger(folders=[])

    def environment(self, domain: int) -> dict[str, str]:
        chosen = ("FASTRTPS_DEFAULT_PROFILES_FILE", "FASTDDS_DEFAULT_PROFILES_FILE", "FASTDDS_BUILTIN_TRANSPORTS")
        environment = {name: value for name, value in os.environ.items() if name not in chosen}
        environment.pop("ROS_LOCALHOST_ONLY", None)
        return environment | {"ROS_DOMAIN_ID": str(domain), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}

    def start(self, *names: str, domain: int | None = None) -> list[Child]:
        """Start nodes of these names together."""
        environment = self.environment(self.domain if domain is None else domain)
        children = [Child(NODE, name, environment=environment) for name in names]
        self.running += children
        for child in children:
            child.expect("ready")
        self.everything.note([child.pid for child in children])
        return children

    def end(self) -> None:
        alive = [child for child in self.running if child.process.poll() is None]
        self.everything.note([child.pid for child in alive])
        for child in alive:
            child.end()
        self.everything.remove_dead()


@pytest.fixture
def nodes() -> Iterator[Nodes]:
    """Yield a starter of nodes; they are ended by their process ids."""
    pytest.importorskip("rclpy")
    running = Nodes()
    yield running
    running.end()


def _inodes(child: Child) -> dict[str, int]:
    """Return the files of the segments that the process owns, and their inodes."""
    looked = SegmentLedger(folders=[])
    looked.note([child.pid])
    assert len(looked.names) >= 3, "a segment and two ports"
    return _inodes_of(*looked.names)


def _inodes_of(*names: str) -> dict[str, int]:
    return {file: (SHM / file).stat().st_ino for file in _of(*names) if (SHM / file).exists()}


def _present(inodes: dict[str, int]) -> set[str]:
    """Return those of the files that are there, not others of their names."""
    found: set[str] = set()
    for file, inode in inodes.items():
        with contextlib.suppress(FileNotFoundError):
            if (SHM / file).stat().st_ino == inode:
                found.add(file)
    return found


def _stops_with_one_of(ports: set[str], pid: int) -> bool:
    """Stop the process; let it go on unless it has made one of the ports anew, without a lock.

    Fast DDS sees after a second or so that nobody reads a port, and then makes it anew several times.
    """
    os.kill(pid, signal.SIGSTOP)
    _wait(lambda: Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] == "T")
    memory = Path(f"/proc/{pid}/maps").read_text()
    if any(f"{SHM / name}\n" in memory and not (SHM / f"{name}_el").exists() for name in ports):
        return True
    os.kill(pid, signal.SIGCONT)
    return False


@pytest.mark.graph
def test_killed_nodes_leave_nothing_and_foreign_ones_keep_theirs_and_go_on(nodes: Nodes, tmp_path: Path) -> None:
    first, second, ann, ben = nodes.start("first", "second", "ann", "ben")
    (killed,) = nodes.start("killed", domain=free_domain(nodes.domain))
    ledger = SegmentLedger(folders=[tmp_path / "ledgers"])
    ledger.note([first.pid, second.pid])
    ours = _inodes(first) | _inodes(second)
    foreign = [_inodes(child) for child in (killed, ann, ben)]
    for child in (first, second, killed):
        child.kill()
    assert set(ledger.remove_dead()) <= set(ours)
    assert _present(ours) == set()
    assert [_present(inodes) for inodes in foreign] == [set(inodes) for inodes in foreign]
    assert _files(tmp_path / "ledgers") == set()
    ben.say("after")
    ann.expect("ben: after")
    (new,) = nodes.start("new")
    ann.expect("new: hello")
    new.expect("ann: hello")


@pytest.mark.graph
def test_a_port_that_a_living_node_took_over_stays_and_works(nodes: Nodes, tmp_path: Path) -> None:
    (noted,) = nodes.start("noted")
    ledger = SegmentLedger(folders=[tmp_path / "ledgers"])
    ledger.note([noted.pid])
    ours = _inodes(noted)
    noted.kill()
    (foreign,) = nodes.start("foreign")
    theirs = _inodes(foreign)
    if not ours.keys() & theirs.keys():
        pytest.skip("another graph is in this domain, so the new node has other ports")
    ledger.remove_dead()
    # The semaphore of a port goes over to its new reader.
    assert {name for name in _present(ours) if not name.startswith("sem.")} == set()
    assert _present(theirs) == set(theirs)
    (peer,) = nodes.start("peer")
    peer.expect("foreign: hello")
    foreign.expect("peer: hello")


@pytest.mark.graph
def test_a_port_that_a_noted_node_makes_for_a_killed_peer_is_removed_too(nodes: Nodes, tmp_path: Path) -> None:
    writer, reader = nodes.start("writer", "reader")
    writer.expect("reader: hello")
    ledger = SegmentLedger(folders=[tmp_path / "ledgers"])
    ledger.note([writer.pid, reader.pid])
    ports = {name for name in _inodes(reader) if name.removeprefix("fastrtps_port").isdecimal()}
    reader.kill()
    _wait(lambda: _stops_with_one_of(ports, writer.pid))
    ledger.note([writer.pid])
    files = _inodes_of(*ledger.names)
    writer.kill()
    ledger.remove_dead()
    assert _present(files) == set()


@pytest.mark.graph
def test_what_a_killed_supervisor_leaves_is_removed_at_the_next_start(nodes: Nodes, tmp_path: Path) -> None:
    folder = tmp_path / "ledgers"
    command = [sys.executable, "-c", NODE, "node"]
    supervisor = Child(SUPERVISOR, str(SHM), str(folder), *command, environment=nodes.environment(nodes.domain))
    supervisor.expect("ready")
    pid, *names = supervisor.lines[0].split()
    nodes.everything.note([int(pid)])
    files = _inodes_of(*names)
    assert len(files) >= 8, "a segment and two ports"
    assert remove_left_behind(folders=[folder]) == []
    os.kill(int(pid), signal.SIGKILL)
    supervisor.kill()
    _wait(lambda: _has_ended(int(pid)))
    assert remove_left_behind(folders=[folder]) == sorted(names)
    assert _present(files) == set()
    assert _files(folder) == set()
