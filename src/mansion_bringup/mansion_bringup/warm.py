"""Compile and cache the solver kernels, so that a first user does not wait: ``python -m mansion_bringup.warm``."""

__all__ = ["warm"]


def warm() -> None:
    """Compile the kernels of the floor solver and the placer."""
    from mansion_planner.solver import warm as warm_solver
    from mansion_scene.placement import warm as warm_placement

    warm_solver()
    warm_placement()


if __name__ == "__main__":
    warm()
