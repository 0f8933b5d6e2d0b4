"""Make the wheels of ROS 2 importable without environment variables; set-up copies this file into site-packages.

The wheels keep their shared libraries in ``PREFIX/lib`` and expect ``LD_LIBRARY_PATH`` to name it, which a process can
only be given before it starts. Their own start-up file therefore runs every Python of the environment twice, and leaves
two variables behind that break the ROS wheels of any other environment started from it. Mansion does without: when
``rclpy`` is first imported (``ros_wheels_hook.py``), the libraries are loaded by their absolute paths, each after those
that it needs, and the dynamic loader then finds them by name.

``python -m _mansion_ros_wheels`` records which libraries there are, in an order that loads.
"""

import ctypes
import importlib.machinery
import os
import struct
import sys
from collections.abc import Iterable
from pathlib import Path

EXTENSIONS = ("rclpy/*.so", "*/*rosidl_typesupport_c*.so")
"""Where the extension modules are that ask for the libraries."""

NOT_LOADED = ("libtracetools_status.so",)
"""A tool's, which brings a second copy of the trace points: to register them twice aborts the process."""

_SITE = Path(__file__).resolve().parent
_RECORD = _SITE / "_mansion_ros_libraries.txt"

_LOADED, _DYNAMIC = 1, 2
"""Types of ELF segments."""

_NEEDED, _STRING_TABLE, _OWN_NAME = 1, 5, 14
"""Tags of the dynamic section."""


def load_for(module: str) -> None:
    """Load the recorded libraries, if an import of `module` takes the one of the wheels."""
    if _is_ours(module):
        load(_recorded())


def _is_ours(module: str) -> bool:
    """Whether an import takes the wheel's module, not that of a ROS 2 which is sourced."""
    spec = importlib.machinery.PathFinder.find_spec(module)
    return spec is not None and spec.origin is not None and _SITE in Path(spec.origin).parents


def _recorded() -> list[Path]:
    if not _RECORD.exists():
        raise ImportError(f"{_RECORD.name} is missing beside {__name__}; set the environment up again")
    return [_SITE / line for line in _RECORD.read_text(encoding="utf-8").splitlines()]


def load(paths: Iterable[Path]) -> None:
    """Load libraries, each of which comes after those that it needs.

    Raises
    ------
    ImportError
        With the loader's message when one cannot be loaded.
    """
    for path in paths:
        try:
            ctypes.CDLL(os.fspath(path))
        except OSError as error:
            raise ImportError(f"the libraries of the ROS wheels do not load: {error}") from None


def record() -> None:
    """Write down the libraries of the wheels, relative to site-packages, each after those that it needs."""
    inner = _by_name(_SITE.glob("ros_*.libs/*.so*"))
    outer = _by_name(Path(sys.prefix, "lib").glob("lib*.so*"))
    for name in NOT_LOADED:
        outer.pop(name, None)
    # What wheels keep to themselves is loaded only where another library asks for it: some is there twice.
    paths = {**{name: path for name, (path, _) in inner.items()}, **{name: path for name, (path, _) in outer.items()}}
    needs = {name: needed for name, (_, needed) in [*inner.items(), *outer.items()]}
    order: dict[str, None] = {}

    def visit(name: str) -> None:
        if name in paths and name not in order:
            for needed in needs[name]:
                visit(needed)
            order[name] = None

    for name in outer:
        visit(name)
    for extension in EXTENSIONS:
        for path in sorted(_SITE.glob(extension)):
            for needed in linked_names(path)[1]:
                visit(needed)
    load([paths[name] for name in order])
    lines = [f"{os.path.relpath(paths[name], _SITE)}\n" for name in order]
    _RECORD.write_text("".join(lines), encoding="utf-8")


def _by_name(paths: Iterable[Path]) -> dict[str, tuple[Path, list[str]]]:
    """Return libraries by the name that others ask for, with the names that they ask for.

    A wheel holds copies where an installation has symbolic links: only the file of that very name counts.
    """
    found = {}
    for path in sorted(paths):
        own, needed = linked_names(path)
        if own in ("", path.name):
            found[path.name] = (path, needed)
    return found


def linked_names(library: Path) -> tuple[str, list[str]]:
    """Return a library's own name, if it has one, and those of the libraries that it needs.

    From DT_SONAME and DT_NEEDED in the dynamic section of a 64-bit little-endian ELF file.
    """
    image = library.read_bytes()
    offset, size, count = struct.unpack_from("<Q14xHH", image, 32)
    headers = [struct.unpack_from("<IIQQQQ", image, offset + index * size) for index in range(count)]
    start, length = next((head[2], head[5]) for head in headers if head[0] == _DYNAMIC)
    entries = list(struct.iter_unpack("<QQ", image[start : start + length // 16 * 16]))
    table = next(value for tag, value in entries if tag == _STRING_TABLE)
    segment = next(head for head in headers if head[0] == _LOADED and head[3] <= table < head[3] + head[5])
    strings = segment[2] + table - segment[3]

    def text(at: int) -> str:
        return image[strings + at : image.index(b"\0", strings + at)].decode()

    own = [text(value) for tag, value in entries if tag == _OWN_NAME]
    return own[0] if own else "", [text(value) for tag, value in entries if tag == _NEEDED]


if __name__ == "__main__":
    record()
