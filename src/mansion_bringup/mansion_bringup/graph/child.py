"""Run a node's module as a child that ends with its parent: ``python -m mansion_bringup.graph.child MODULE ...``.

A supervisor that is killed cannot end its nodes; Linux does it when the child asks for a signal at its parent's death.
"""

import runpy
import sys

from mansion_msgs_py.workers import end_with_parent

__all__ = ["main"]


def main() -> None:
    """Run ``sys.argv[2]`` as the main module; ``sys.argv[1]`` is the parent's process id."""
    parent, module = int(sys.argv[1]), sys.argv[2]
    del sys.argv[1:3]
    end_with_parent(parent)
    runpy.run_module(module, run_name="__main__", alter_sys=True)


if __name__ == "__main__":
    main()
