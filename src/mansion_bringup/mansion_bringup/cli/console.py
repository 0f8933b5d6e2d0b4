"""Output of commands: results to standard output, progress to standard error; checks that a file can be written."""

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console

from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError

if TYPE_CHECKING:
    from mansion_msgs_py.world import Progress as ProgressPayload
    from mansion_world.making import WorldProgress

__all__ = [
    "EXIT_INTERRUPTED",
    "AsJson",
    "BuildingArgument",
    "buildings_reporter",
    "check_output_file",
    "check_output_folder",
    "complaints",
    "details",
    "err",
    "out",
    "print_json",
    "progress_bar",
]

EXIT_INTERRUPTED = 130
"""Exit status after Ctrl-C, as shells have it: 128 and the signal's number."""

PIPED = 1000
"""Columns where no terminal says how wide it is: paths stay whole."""

out = Console(width=None if sys.stdout.isatty() else PIPED)
err = Console(stderr=True, width=None if sys.stderr.isatty() else PIPED)
"""Progress and notices; silent with ``--quiet``."""

complaints = Console(stderr=True, width=None if sys.stderr.isatty() else PIPED)
"""What went wrong, said with ``--quiet`` too."""

details = Console(stderr=True, width=None if sys.stderr.isatty() else PIPED, quiet=True)
"""What ``--verbose`` adds."""

AsJson = Annotated[bool, typer.Option("--json", help="Print only the result, as JSON.")]
"""The option of every command that otherwise answers in words."""

BuildingArgument = Annotated[Path, typer.Argument(help="Folder that `mansion build` wrote.")]
"""The argument of commands on a finished building."""


def print_json(value: Any) -> None:
    """Print a payload as indented JSON, nothing added."""
    sys.stdout.write(encode(value, indent=2) + "\n")


@contextmanager
def progress_bar() -> Iterator["Callable[[ProgressPayload], None]"]:
    """Show `Progress` payloads: a bar on a terminal, plain lines elsewhere and with ``--verbose``.

    The bar's thread starts with the first payload, so that a command can fork its workers before.
    """
    if err.quiet:
        yield lambda p: None
        return
    if not err.is_terminal or not details.quiet:
        yield lambda p: err.print(f"[{p.done}/{p.total}] {p.message}", markup=False, highlight=False)
        return
    from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = (
        SpinnerColumn(),
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.completed}/{task.total}"),
        TimeElapsedColumn(),
    )
    bar = Progress(*columns, console=err, transient=True)
    task = bar.add_task("starting", total=None)

    def show(payload: "ProgressPayload") -> None:
        bar.start()
        bar.update(task, description=payload.message, completed=payload.done, total=payload.total)

    try:
        yield show
    finally:
        bar.stop()


def buildings_reporter() -> "Callable[[WorldProgress], None]":
    """Return what prints a line for each change: buildings done, rate, remaining time, what was set aside."""
    from mansion_world.making import WorldProgress

    started = time.monotonic()
    last = WorldProgress(0, 0, 0, 0, 0)

    def report(progress: "WorldProgress") -> None:
        nonlocal last
        if progress == last:
            return
        last = progress
        made = max(0, progress.done - progress.kept)
        hours = (time.monotonic() - started) / 3600
        rate = made / hours if hours else 0.0
        left = progress.total - progress.done - progress.missing
        pace = f", {rate:.0f} an hour, {left / rate * 60:.0f} min left" if made and left else ""
        aside = f", {progress.set_aside} set aside" if progress.set_aside else ""
        err.print(f"[{progress.done}/{progress.total}] buildings{pace}{aside}", markup=False, highlight=False)

    return report


def check_output_folder(folder: Path) -> None:
    """Refuse a folder that is a file, or that cannot be made or written.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` naming the folder that is in the way.
    """
    nearest = folder.absolute()
    while not nearest.exists() and nearest != nearest.parent:
        nearest = nearest.parent
    if not nearest.is_dir():
        raise _refusal(folder, f"{nearest} is a file, not a folder")
    if not os.access(nearest, os.W_OK | os.X_OK):
        raise _refusal(folder, f"{nearest} is not writable")


def check_output_file(file: Path) -> None:
    """Refuse a file that is a folder, or whose folder cannot be made or written."""
    if file.is_dir():
        raise _refusal(file, "it is a folder; name a file in it")
    check_output_folder(file.parent)


def _refusal(path: Path, why: str) -> MansionError:
    return MansionError(
        ErrorCode.UNAVAILABLE,
        f"cannot write {path}: {why}; name another place with --output",
        path="$.output",
        details={"file": str(path)},
    )
