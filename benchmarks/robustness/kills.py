"""Kill builds, worlds, edits, skills and skill servers at random times, and say what was lost or left.

    PYTHONPATH=tests/support python benchmarks/robustness/kills.py [--kills edit=100 skill=100 ...] [--seed 0]

After each kill what was acknowledged must be there, nothing half-written, no process, lock or temporary file left, and
the next call must be answered, or go on, within 5 s. Exit status 1 where any of that fails.
"""

import argparse
import random
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from pathlib import Path

from killing import NEXT_CALL, REMAINS, SUBJECTS, killed
from sample_building import write_building

SERVER = "server"


def server_kills(count: int, folder: Path, rng: random.Random) -> Iterator[tuple[int, list[str]]]:
    """Kill the process of a skill server while a client calls skills; yield each number with what was wrong."""
    from mansion_bringup.client import MansionClient
    from mansion_bringup.discovery import kept_to_this_machine
    from mansion_bringup.graph.domains import free_domain
    from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
    from mansion_bringup.graph.skill_port import SERVER as NODE
    from mansion_msgs_py.errors import MansionError

    building = write_building(folder / "building")
    options = GraphOptions(domain_id=free_domain(), parameters={"skill_server": {"camera": "false"}}, quiet=True)
    with kept_to_this_machine(), GraphProcesses(options, [NODE]) as graph:
        graph.wait_ready()
        with MansionClient(domain_id=options.domain_id, timeout=30.0) as client:
            for number in range(count):
                client.call("load_building", {"path": str(building)})
                yaw = client.call("skills/where_am_i")["pose"]["yaw"]
                process = graph.running[NODE.executable]
                timer = threading.Timer(rng.uniform(0.0, 1.0), process.send_signal, [signal.SIGKILL])
                timer.start()
                turned = 0
                try:
                    while True:
                        client.call("skills/rotate", {"degrees": 1.0})
                        turned += 1
                except MansionError:
                    process.wait()
                graph.start(NODE.executable)
                graph.wait_ready()
                started = time.monotonic()
                client.call("load_building", {"path": str(building)})
                seconds = time.monotonic() - started
                after = (client.call("skills/where_am_i")["pose"]["yaw"] - yaw) % 360.0
                faults = [] if seconds <= NEXT_CALL else [f"the next call took {seconds:.1f} s"]
                if round(after) not in (turned % 360, (turned + 1) % 360):  # one may be done and not answered
                    faults.append(f"{turned} skills were acknowledged, the robot has turned by {after:g} degrees")
                yield number, faults
    left = [path for path in building.rglob("*") if REMAINS.fullmatch(path.name)]
    if left:
        yield count, [f"{path} is left" for path in left]


def main() -> None:
    """Kill, and print what was wrong and how often nothing was."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    usual = ["edit=120", "skill=120", "build=30", "world=10", "server=20"]
    parser.add_argument("--kills", nargs="+", default=usual, metavar="NAME=NUMBER", help=" ".join(usual))
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="kills-") as root:
        for name, _, count in (entry.partition("=") for entry in options.kills):
            rng = random.Random(f"{options.seed}/{name}")
            started, bad = time.monotonic(), 0
            folder = Path(root) / name
            if name == SERVER:
                results = server_kills(int(count), folder, rng)
            else:
                subject = SUBJECTS[name]
                killed(subject, folder / "first", 0.5)  # which loads the kernels and the catalogue into this process
                results = ((k, killed(subject, folder / str(k), rng.random())) for k in range(int(count)))
            for number, faults in results:
                bad += bool(faults)
                for fault in faults:
                    print(f"{name} {number}: {fault}", flush=True)
            print(f"{name}: {count} kills, {bad} with something wrong, {time.monotonic() - started:.0f} s", flush=True)
            wrong += bad
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
