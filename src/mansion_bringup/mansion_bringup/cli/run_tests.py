"""``mansion test``: the test suite with the tools that it needs, as CI runs it."""

import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

import typer

from mansion_bringup.discovery import CHOICES, loopback_variables
from mansion_bringup.extras import ensure_extra
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["TEST_EXTRAS", "pytest_command", "register", "run_tests", "test_environment"]

TEST_EXTRAS: Final = ("test", "sim", "llm", "usd", "record", "rerun", "cluster", "convex", "world", "dxf", "ifc")
"""What the suite imports: the tools themselves, and the extras whose code it covers."""

_CHECKOUT: Final = Path(__file__).resolve().parents[4]


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("test", context_settings={"allow_extra_args": True, "ignore_unknown_options": True})(test)


def test(context: typer.Context) -> None:
    """Run the test suite with the tools that it needs; further arguments go to pytest.

    Examples:

      mansion test

      mansion test tests/graph -x
    """
    raise typer.Exit(run_tests(context.args))


def pytest_command(arguments: Sequence[str]) -> list[str]:
    """Return the command that runs pytest on two processes with coverage, and that ends with this process.

    Parameters
    ----------
    arguments : sequence of str
        pytest's own; they come last and so win (``-n 0``, ``--no-cov``, a path).
    """
    child = [sys.executable, "-m", "mansion_bringup.graph.child", str(os.getpid())]
    return [*child, "pytest", "-n", "2", "--cov", "--cov-report=term:skip-covered", *arguments]


def test_environment(environment: Mapping[str, str]) -> dict[str, str]:
    """Return the environment of the suite: loopback only, one thread for each numeric library.

    Parameters
    ----------
    environment : mapping
        The caller's; its own choices stay, but for how far nodes look and for settings of commands.
    """
    kept = {name: value for name, value in environment.items() if name not in CHOICES}
    return {
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "MPLBACKEND": "Agg",
        **kept,
        "MANSION_CONFIG": os.devnull,
        **loopback_variables(kept),
    }


def run_tests(arguments: Sequence[str]) -> int:
    """Run the test suite of this checkout and return pytest's exit status.

    Parameters
    ----------
    arguments : sequence of str
        Passed on to pytest; paths are relative to the checkout.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` outside a checkout; ``UNAVAILABLE`` if the tools cannot be installed.
    """
    if not (_CHECKOUT / "tests").is_dir():
        raise MansionError(
            ErrorCode.NOT_FOUND, f"there are no tests beside {_CHECKOUT}; run ./mansion test in a checkout of Mansion"
        )
    for name in TEST_EXTRAS:
        ensure_extra(name)
    done = subprocess.run(pytest_command(arguments), cwd=_CHECKOUT, env=test_environment(os.environ), check=False)
    return done.returncode
