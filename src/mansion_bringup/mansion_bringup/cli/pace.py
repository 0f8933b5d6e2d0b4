"""How far many buildings are, how fast it goes and how long the rest takes."""

import time
from collections.abc import Callable

from mansion_bringup.cli.console import err
from mansion_world.making import WorldProgress

__all__ = ["pace_reporter"]


def pace_reporter() -> Callable[[WorldProgress], None]:
    """Return what prints a line for each change: buildings done, rate, remaining time, what was set aside."""
    started = time.monotonic()
    last = WorldProgress(0, 0, 0, 0, 0)

    def report(progress: WorldProgress) -> None:
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
