"""The grain of the sources: modules, their lengths, how many only one other imports, and long functions.

    python benchmarks/sources.py [--single] [--long]

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


LONGEST = 45
"""Lines of a function, without its docstring, that fit on a screen."""


def long_functions(file: Path) -> Iterator[tuple[int, str]]:
    """Yield lines and names of the functions of a module that do not fit on a screen."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            first = node.body[0]
            documented = ast.get_docstring(node) is not None and first.end_lineno is not None
            lines = (node.end_lineno or node.lineno) - node.lineno + 1
            lines -= (first.end_lineno or 0) - first.lineno + 1 if documented else 0
            if lines > LONGEST:
                yield lines, node.name


def main() -> None:
    """Count and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--single", action="store_true", help="list the modules that only one other imports")
    parser.add_argument("--long", action="store_true", help=f"list the functions of over {LONGEST} lines")
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
    long = sorted(((*found, name) for name, file in files.items() for found in long_functions(file)), reverse=True)
    print(f"functions over {LONGEST} {len(long):4}")
    if options.long:
        for lines, function, name in long:
            print(f"    {lines:4} {name}.{function}")
    if options.single:
        for name in single:
            print(f"    {lengths[name]:4} {name} <- {min(importers[name])}")


if __name__ == "__main__":
    main()
