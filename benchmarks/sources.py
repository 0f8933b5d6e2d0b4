"""The grain of the sources: modules, their lengths, and how many only one other imports.

    python benchmarks/sources.py [--single]

Counts the modules below src without tests, ``__init__.py`` and ``setup.py``.
"""

import argparse
import ast
import statistics
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

SRC = Path(__file__).resolve().parents[1] / "src"


def modules() -> dict[str, Path]:
    """Return the file of each module by its dotted name."""
    found = {}
    for package in sorted(SRC.iterdir()):
        for file in sorted((package / package.name).rglob("*.py")):
            if file.name != "__init__.py":
                found[".".join(file.relative_to(package).with_suffix("").parts)] = file
    return found


def imported(file: Path) -> Iterator[str]:
    """Yield the dotted names that a module imports, with and without the last part of each."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and node.level == 0:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def main() -> None:
    """Count and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--single", action="store_true", help="list the modules that only one other imports")
    options = parser.parse_args()
    files = modules()
    importers: dict[str, set[str]] = defaultdict(set)
    for name, file in files.items():
        for other in set(imported(file)) & files.keys():
            importers[other].add(name)
    lengths = {name: len(file.read_text(encoding="utf-8").splitlines()) for name, file in files.items()}
    single = [name for name in files if len(importers[name]) == 1]
    short = [name for name in single if lengths[name] < 60]
    by_package: dict[str, list[int]] = defaultdict(list)
    for name, length in lengths.items():
        by_package[name.partition(".")[0]].append(length)
    for package, counts in sorted(by_package.items()):
        print(f"{package:20} {len(counts):4} modules {sum(counts):7} lines")
    median = statistics.median(lengths.values())
    print(f"{'all':20} {len(files):4} modules {sum(lengths.values()):7} lines, median {median:g}")
    print(f"over 600 lines       {sum(length > 600 for length in lengths.values()):4}")
    print(f"imported by one      {len(single):4}, {len(short)} of them under 60 lines")
    if options.single:
        for name in single:
            print(f"    {lengths[name]:4} {name} <- {min(importers[name])}")


if __name__ == "__main__":
    main()
