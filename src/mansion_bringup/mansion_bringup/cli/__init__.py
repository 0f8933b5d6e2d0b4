"""The command line: ``mansion COMMAND ...``."""

import gc
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from mansion_bringup.cli.socket_call import call_quickly
from mansion_bringup.discovery import keep_to_this_machine
from mansion_bringup.graph.rclpy_available import NO_RCLPY
from mansion_msgs_py.errors import ErrorCode, MansionError, refused_by_system

__all__ = ["main"]

EXIT_FAILURE = 1
EXIT_INFEASIBLE = 2

COLLECT_AFTER = 20_000
"""New objects after which garbage is looked for: importing makes many that stay, and each search visits them."""


def _require_text(arguments: Sequence[str]) -> None:
    """Refuse bytes that are not UTF-8, which Python passes on as characters that no file or message can hold."""
    for number, argument in enumerate(arguments, start=1):
        try:
            argument.encode()
        except UnicodeEncodeError:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD, f"argument {number}, {argument[:80]!r}, is not UTF-8 text"
            ) from None


def _print_more(error: MansionError) -> None:
    """Print what ``--verbose`` and ``--json`` add to an error."""
    from mansion_bringup.cli.console import details, print_json

    details.print(str(error.info.details), markup=False, highlight=False)
    if "--json" in sys.argv[1:]:
        print_json(error.reply())


def main() -> NoReturn:
    """Run the command line; expected failures print one line and end with status 1, an infeasible brief with 2."""
    gc.set_threshold(COLLECT_AFTER, 20, 20)
    keep_to_this_machine()
    try:
        _require_text(sys.argv[1:])
        if not call_quickly(sys.argv[1:]):
            from mansion_bringup.cli.app import app

            app(prog_name="mansion")
    except KeyboardInterrupt:
        from mansion_bringup.cli.console import EXIT_INTERRUPTED

        sys.exit(EXIT_INTERRUPTED)
    except ModuleNotFoundError as error:
        if error.name != "rclpy" or "MANSION_DEBUG" in os.environ:
            raise
        print(f"error: {ErrorCode.UNAVAILABLE}: {NO_RCLPY}", file=sys.stderr)
        sys.exit(EXIT_FAILURE)
    except MansionError as error:
        if "MANSION_DEBUG" in os.environ:
            raise
        print(f"error: {error}", file=sys.stderr)
        for fault in error.info.details.get("faults", ()):
            print(f"  {fault}", file=sys.stderr)
        if "--json" in sys.argv[1:] or "mansion_bringup.cli.console" in sys.modules:  # which hears --verbose
            _print_more(error)
        trace = error.info.details.get("traceback")
        if error.code == ErrorCode.INTERNAL and trace:
            print(f"This is a fault of Mansion; please report it with this:\n{trace}", file=sys.stderr)
        infeasible = (ErrorCode.INFEASIBLE, ErrorCode.CONTRADICTION)
        sys.exit(EXIT_INFEASIBLE if error.code in infeasible else EXIT_FAILURE)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(EXIT_FAILURE)
    except OSError as error:
        if "MANSION_DEBUG" in os.environ or error.errno is None:
            raise
        print(f"error: {refused_by_system(error)}", file=sys.stderr)
        sys.exit(EXIT_FAILURE)
    sys.exit(0)
