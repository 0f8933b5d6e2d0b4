"""``mansion check`` and ``mansion test``: is a building sound, is Mansion sound."""

from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import err, print_json
from mansion_msgs_py.wording import counted

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.command("check", no_args_is_help=True)(check)
    app.command("test", context_settings={"allow_extra_args": True, "ignore_unknown_options": True})(test)


def check(
    building: Annotated[Path, typer.Argument(help="Folder that `mansion build` wrote.")],
    as_json: Annotated[bool, typer.Option("--json", help="Faults as JSON.")] = False,
) -> None:
    """Verify a building from its geometry and its request; exit status 1 and a line for each fault.

    Examples:

      mansion check out/office
    """
    from mansion_bringup.verify import verify_building

    faults = verify_building(building)
    if as_json:
        print_json(faults)
    else:
        for fault in faults:
            typer.echo(str(fault))
    if faults:
        err.print(f"{building}: {counted(len(faults), 'fault')}", highlight=False)
        raise typer.Exit(1)
    err.print(f"{building}: no fault found")


def test(context: typer.Context) -> None:
    """Run the test suite with the tools that it needs; further arguments go to pytest.

    Examples:

      mansion test

      mansion test tests/graph -x
    """
    from mansion_bringup.testing import run_tests

    raise typer.Exit(run_tests(context.args))
