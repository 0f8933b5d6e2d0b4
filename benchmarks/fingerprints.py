"""Digests of twelve buildings and all their exports, to show that a change of the sources changes no byte.

    python benchmarks/fingerprints.py before.json
    python benchmarks/fingerprints.py after.json --compare before.json

Builds each sentence with its own seed into a temporary folder and writes the SHA-256 of every file but ``report.json``,
whose times differ. With ``--compare`` prints the files that differ and ends with status 1 if there are any.
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SENTENCES = [
    "a four-storey office with a cafeteria on the ground floor",
    "a two-storey family house of 160 m2 with three bedrooms, a garage and a home office",
    "a three-bedroom flat of 95 m2",
    "a small hospital with an emergency department on the ground floor and two wards above",
    "a primary school with six classrooms, a library and a gym on two floors",
    "a five-storey hotel with a restaurant, a bar and 24 guest rooms",
    "a public library with a basement archive and two lifts",
    "a warehouse with a loading dock and offices on the upper floor",
    "a supermarket with a bakery",
    "an L-shaped townhouse on three floors with a roof terrace",
    "a research laboratory with clean rooms, a server room in the basement and a lecture hall",
    "a museum around a courtyard with a cafe and a shop",
]


EXPORTS = ["thor", "nav2", "mjcf", "sdf", "rmf", "glb", "usd"]


def run(*arguments: str) -> None:
    """Run the command line on the sources that this script belongs to."""
    path = os.pathsep.join(str(folder) for folder in (Path(__file__).resolve().parents[1] / "src").iterdir())
    command = [sys.executable, "-m", "mansion_bringup", *arguments]
    done = subprocess.run(command, env=os.environ | {"PYTHONPATH": path}, capture_output=True, text=True, timeout=600)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr[-2000:]}")


def digests(job: tuple[str, int]) -> dict[str, str]:
    """Build and export one sentence, by the commands that users give, and return the digest of each file."""
    description, seed = job
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "building"
        run("build", description, "-o", str(out), "--seed", str(seed), "--jobs", "1")
        for export in EXPORTS:
            run("export", str(out), "--to", export, "-o", str(out / export))
        return {
            f"{seed:02}/{file.relative_to(out)}": hashlib.sha256(file.read_bytes()).hexdigest()
            for file in sorted(out.rglob("*"))
            if file.is_file() and file.name != "report.json"
        }


def main() -> int:
    """Write, and compare if asked."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("output", type=Path, help="where to write the digests")
    parser.add_argument("--compare", type=Path, help="digests of an earlier run")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    found: dict[str, str] = {}
    with ThreadPoolExecutor(options.jobs) as pool:
        for some in pool.map(digests, [(sentence, seed) for seed, sentence in enumerate(SENTENCES)]):
            found |= some
    options.output.write_text(json.dumps(found, indent=1, sort_keys=True), encoding="utf-8")
    print(f"{len(found)} files of {len(SENTENCES)} buildings")
    if options.compare is None:
        return 0
    before = json.loads(options.compare.read_text(encoding="utf-8"))
    changed = sorted(name for name in found.keys() | before.keys() if found.get(name) != before.get(name))
    for name in changed:
        print("differs:" if name in found and name in before else "only in one:", name)
    print(f"{len(changed)} of {len(before)} files differ")
    return int(bool(changed))


if __name__ == "__main__":
    sys.exit(main())
