"""Optional dependencies, installed when a command first needs them: ``python -m mansion_bringup.extras sim``.

In a checkout's own environment (the one that ``./mansion`` made) a missing extra is installed from its lock file, with
hashes, under the launcher's lock. Anywhere else (a colcon workspace, ``pip install``) nothing is installed behind the
user's back: the error names the pip command.
"""

import fcntl
import hashlib
import importlib
import importlib.util
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["EXTRAS", "ensure_extra", "main", "require_extra"]

EXTRAS: Final[dict[str, tuple[str, ...]]] = {
    "cluster": ("distributed",),
    "convex": ("coacd",),
    "docs": ("material", "mkdocs", "mkdocstrings"),
    "dxf": ("ezdxf",),
    "embeddings": ("sentence_transformers",),
    "ifc": ("ifcopenshell",),
    "lint": ("codespell_lib", "importlinter", "mypy", "ruff"),
    "llm": ("openai",),
    "record": ("mcap", "mcap_ros2"),
    "rerun": ("rerun",),
    "sim": ("gymnasium", "mujoco"),
    "test": ("coverage", "hypothesis", "pytest", "xdist"),
    "thor": ("ai2thor",),
    "usd": ("pxr",),
    "vectors": ("wordllama",),
    "world": ("pyarrow",),
}
"""Modules by which the presence of each extra is recognised."""

_CHECKOUT: Final = Path(__file__).resolve().parents[3]
_PIP_OPTIONS: Final = (
    "--require-hashes",
    "--no-deps",
    "--only-binary=:all:",
    "--no-input",
    "--disable-pip-version-check",
    "--quiet",
    "--retries=2",
)


def ensure_extra(name: str) -> None:
    """Make the modules of an extra importable in this process, installing them if need be.

    Parameters
    ----------
    name : str
        A key of `EXTRAS`.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` if there is no such extra; ``UNAVAILABLE`` if it is missing and cannot be installed here.
    """
    prefix = Path(sys.prefix)
    if name not in EXTRAS or not _is_launchers(prefix):
        require_extra(name)
        return
    lock = _lock_file(name)
    digest = hashlib.sha256(lock.read_bytes()).hexdigest()
    stamp = prefix / f".mansion-extra-{name}"
    if _read(stamp) == digest:
        return
    with _launcher_lock(prefix):
        if _read(stamp) != digest:
            _install(name, lock, prefix)
            stamp.write_text(digest, encoding="utf-8")
    importlib.invalidate_caches()


def require_extra(name: str) -> None:
    """Refuse where an extra is missing; nothing is installed.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` if there is no such extra; ``UNAVAILABLE`` with the command that installs it here.
    """
    if name not in EXTRAS:
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no extra {name!r}; extras are {', '.join(EXTRAS)}")
    missing = [module for module in EXTRAS[name] if importlib.util.find_spec(module) is None]
    if missing:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"this needs the extra {name!r}, which is not installed ({', '.join(missing)}); install it with: "
            + _command(name),
            details={"extra": name, "missing": missing},
        )


_OPTIONS: Final = {"rerun": "--no-deps "}
"""Options of pip: rerun-sdk asks for a newer NumPy than ROS 2 Jazzy has (docs/install.md names what else it needs)."""


def _command(name: str) -> str:
    """Return what installs an extra into the environment of this process."""
    if _is_launchers(Path(sys.prefix)):
        return f"{sys.executable} -m mansion_bringup.extras {name}"
    if (_CHECKOUT / "requirements" / f"{name}.in").exists():
        return f"python3 -m pip install {_OPTIONS.get(name, '')}-r requirements/{name}.in"
    return f"python3 -m pip install 'mansion[{name}]'"


def _is_launchers(prefix: Path) -> bool:
    """Whether ``./mansion`` made the environment."""
    return (prefix / ".mansion-venv").exists()


def _lock_file(name: str) -> Path:
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    lock = _CHECKOUT / "requirements" / f"{name}-{version}.txt"
    if not lock.exists():
        raise MansionError(ErrorCode.UNAVAILABLE, f"the lock file of the extra is missing: {lock}")
    return lock


def _read(stamp: Path) -> str:
    try:
        return stamp.read_text(encoding="utf-8")
    except FileNotFoundError:
        return ""


@contextmanager
def _launcher_lock(prefix: Path) -> Iterator[None]:
    """Hold the lock under which the launcher makes the environment."""
    with open(f"{prefix}.lock", "w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            _say(f"another mansion is installing into {prefix}; waiting for it")
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _install(name: str, lock: Path, prefix: Path) -> None:
    _say(f"installing the extra {name!r} from requirements/{lock.name} (once)")
    command = [sys.executable, "-m", "pip", "install", *_PIP_OPTIONS, "-r", str(lock)]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
    output = done.stdout + done.stderr
    with open(prefix / "setup.log", "a", encoding="utf-8") as log:
        log.write(output)
    if done.returncode != 0:
        errors = [line.strip() for line in output.splitlines() if "ERROR" in line]
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"the extra {name!r} could not be installed: {' '.join(errors[-3:]) or 'pip failed'}; "
            f"the full log is {prefix / 'setup.log'}",
            details={"extra": name},
        )


def _say(text: str) -> None:
    print(f"mansion: {text}", file=sys.stderr, flush=True)


def main(arguments: Sequence[str] | None = None) -> int:
    """Install the extras that the command line names; return the exit status."""
    for name in sys.argv[1:] if arguments is None else arguments:
        try:
            ensure_extra(name)
        except MansionError as error:
            _say(str(error))
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
