"""Run a node's module as a child that ends with its parent: ``python -m mansion_bringup.graph.child MODULE ...``.

A supervisor that is killed cannot end its nodes; Linux does it when the child asks for a signal at its parent's death.
"""

import ctypes
import os
import runpy
import signal
import sys

__all__ = ["end_with_parent", "main"]

PR_SET_PDEATHSIG = 1
"""Option of prctl(2)."""


def end_with_parent(parent: int) -> None:
    """Ask for SIGTERM when the process `parent` ends; end now if it has ended already."""
    if sys.platform != "linux":
        return
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != parent:
        os.kill(os.getpid(), signal.SIGTERM)


def main() -> None:
    """Run ``sys.argv[2]`` as the main module; ``sys.argv[1]`` is the parent's process id."""
    parent, module = int(sys.argv[1]), sys.argv[2]
    del sys.argv[1:3]
    end_with_parent(parent)
    runpy.run_module(module, run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
