"""Compile and cache the kernels, so that a first user does not wait: ``python -m mansion_bringup.warm``."""

import time
from collections.abc import Callable
from concurrent.futures import as_completed
from os import cpu_count

from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.workers import worker_pool

__all__ = ["WARMERS", "warm"]


def _solver() -> None:
    with importing:
        from mansion_planner.solver import warm as compile_kernels

    compile_kernels()


def _placement() -> None:
    with importing:
        from mansion_scene.placement import warm as compile_kernels

    compile_kernels()


def _navigation() -> None:
    with importing:
        from mansion_skills.navigation import warm as compile_kernels

    compile_kernels()


def _pictures() -> None:
    with importing:
        import numpy as np

        from mansion_assets.texture_coordinates import fitted_coordinates
        from mansion_export.glb import write_glb
        from mansion_export.meshes.model import Material, Node, Part, Surface, assemble
        from mansion_export.pictures.renderer import View, flatten, render

    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]])
    parts: list[Part] = []
    for k, alpha in enumerate((1.0, 0.5)):
        surface = Surface(
            Material("warm", (1.0, 1.0, 1.0), alpha),
            corners[3 * k : 3 * k + 3].astype(np.float64),
            np.array([[0, 1, 2]]),
        )
        parts.append((Node(f"warm_{k}", f"warm_{k}", "structure"), [surface]))
    model = assemble("warm", 1, 0.0, parts)
    fitted_coordinates(corners.astype(np.float64), np.array([[0, 1, 2]]), np.zeros(1, dtype=np.int64))
    render(flatten(model), View())
    write_glb([model], "warm")


WARMERS: tuple[Callable[[], None], ...] = (_solver, _placement, _navigation, _pictures)
"""The longest first, so that two processes end together."""


def warm(report: Callable[[str], None] = lambda text: None) -> None:
    """Compile the kernels of the floor solver, the placer, navigation and the pictures, on all cores.

    Parameters
    ----------
    report : callable
        Gets a line for each of these groups when it is done.
    """
    workers = min(len(WARMERS), cpu_count() or 1)
    begun = time.monotonic()
    with worker_pool(workers, "fork") as pool:
        running = {pool.submit(work): work.__name__.strip("_") for work in WARMERS}
        for number, done in enumerate(as_completed(running), start=1):
            done.result()
            report(f"{number} of {len(WARMERS)} groups: {running[done]}, after {time.monotonic() - begun:.0f} s")


if __name__ == "__main__":
    warm(lambda text: print(text, flush=True))
