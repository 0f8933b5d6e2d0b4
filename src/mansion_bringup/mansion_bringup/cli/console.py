"""What commands print: results to standard output, progress to standard error."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from rich.console import Console

from mansion_msgs_py.codec import encode
from mansion_msgs_py.world import Progress as ProgressPayload

__all__ = ["EXIT_INTERRUPTED", "err", "out", "print_json", "progress_bar"]

EXIT_INTERRUPTED = 130
"""Exit status after Ctrl-C, as shells have it: 128 and the signal's number."""

PIPED = 1000
"""Columns where no terminal says how wide it is: paths stay whole."""

out = Console(width=None if sys.stdout.isatty() else PIPED)
err = Console(stderr=True, width=None if sys.stderr.isatty() else PIPED)


def print_json(value: Any) -> None:
    """Print a payload as indented JSON, nothing added."""
    sys.stdout.write(encode(value, indent=2) + "\n")


@contextmanager
def progress_bar() -> Iterator[Callable[[ProgressPayload], None]]:
    """Show `Progress` payloads: a bar on a terminal, plain lines elsewhere.

    The bar's thread starts with the first payload, so that a command can fork its workers before.
    """
    if not err.is_terminal:
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

    def show(payload: ProgressPayload) -> None:
        bar.start()
        bar.update(task, description=payload.message, completed=payload.done, total=payload.total)

    try:
        yield show
    finally:
        bar.stop()
