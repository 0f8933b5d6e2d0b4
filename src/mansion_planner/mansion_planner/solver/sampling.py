"""Batches of perturbed seeds for a cut round (Algorithm 3), and the Monte Carlo fallback's."""

import numpy as np

from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.state import Floats

__all__ = ["base_radii", "repelled_batch", "sample_batch"]


def base_radii(shares: Floats, options: SolverOptions) -> Floats:
    """Return ``R_r^(0) = r_base + k a_r / |Omega(p_t)|`` in grid cells."""
    return options.base_radius + options.radius_gain * shares


def sample_batch(seeds: Floats, radii: Floats, size: int, separation: float, rng: np.random.Generator) -> Floats:
    """Draw perturbed seeds uniformly from the discs around `seeds`; the first candidate is unperturbed.

    Seeds closer than `separation` are drawn again, up to eight times, then kept as they are.

    Returns
    -------
    (size, children, 2) array
    """
    count = len(seeds)

    def draw(number: int) -> Floats:
        angle = rng.uniform(0.0, 2.0 * np.pi, (number, count))
        reach = radii * np.sqrt(rng.uniform(0.0, 1.0, (number, count)))
        step = np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=-1)
        return np.asarray(seeds + step)

    batch = draw(size)
    batch[0] = seeds
    for _ in range(8):
        close = _too_close(batch, separation)
        close[0] = False
        if not close.any():
            break
        batch[close] = draw(int(close.sum()))
    return batch


def _too_close(batch: Floats, separation: float) -> "np.ndarray[tuple[int], np.dtype[np.bool_]]":
    gap = np.linalg.norm(batch[:, :, None] - batch[:, None, :], axis=-1)
    k = np.arange(batch.shape[1])
    gap[:, k, k] = np.inf
    return np.asarray(gap.min(axis=(1, 2), initial=np.inf) < separation)


def repelled_batch(cells: Floats, targets: Floats, size: int, rng: np.random.Generator) -> Floats:
    """Draw seeds uniformly in the region, larger rooms first, each away from those before it (the fallback)."""
    order = np.argsort(-targets, kind="stable")
    batch = np.empty((size, len(targets), 2))
    reach = 0.5 * np.sqrt(targets)
    for b in range(size):
        done: list[int] = []
        for k in order.tolist():
            point = cells[rng.integers(len(cells))]
            for _ in range(12):
                if all(np.hypot(*(point - batch[b, m])) >= 0.8 * (reach[k] + reach[m]) for m in done):
                    break
                point = cells[rng.integers(len(cells))]
            batch[b, k] = point
            done.append(k)
    return batch
