"""``mansion check``: verify a building from its geometry and its request."""

from typing import Annotated

import typer

from mansion_bringup.cli.console import BuildingArgument, err, print_json
from mansion_msgs_py.wording import counted

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("check", no_args_is_help=True)(check)


def check(
    building: BuildingArgument,
    as_json: Annotated[bool, typer.Option("--json", help="Faults as JSON.")] = False,
    norms: Annotated[
        bool,
        typer.Option(
            "--norms", help="Also list deviations from building rules and advice: rule, place, found, required, source."
        ),
    ] = False,
) -> None:
    """Verify a building from its geometry and its request; exit status 1 and a line for each fault.

    With --norms also a line for each deviation from a rule of building, and exit status 1 for one that a code does not
    allow and the brief does not ask for explicitly; as JSON an object of `faults` and `deviations`.

    Examples:

      mansion check out/office

      mansion check out/office --norms
    """
    from mansion_bringup.check.norms import norms_of_folder
    from mansion_bringup.time_estimates import check_seconds, notice
    from mansion_bringup.verify import verify_building

    if told := notice(building, "the check", check_seconds):
        err.print(told, highlight=False)
    faults = verify_building(building)
    unreadable = any(fault.kind == "FILE" for fault in faults)
    deviations = norms_of_folder(building) if norms and not unreadable else []
    if as_json:
        print_json({"faults": faults, "deviations": deviations} if norms else faults)
    else:
        for line in (*faults, *deviations):
            typer.echo(str(line))
    wrong = [item for item in deviations if item.counts]
    if faults or wrong:
        found = [counted(len(faults), "fault")] * bool(faults) + [counted(len(wrong), "deviation")] * bool(wrong)
        err.print(f"{building}: {', '.join(found)}", highlight=False)
        raise typer.Exit(1)
    err.print(f"{building}: no faults found")
