"""The options that every command has: ``--quiet`` and ``--verbose``."""

import logging
from typing import Annotated, Any

import typer
import typer.main

from mansion_bringup.cli.console import details, err
from mansion_bringup.cli.settings_file import SettingsFile

__all__ = ["common_options"]


def _set_quiet(value: bool) -> bool:
    err.quiet = value
    if value:
        logging.getLogger("mansion").setLevel(logging.ERROR)
    return value


def _set_verbose(context: typer.Context, value: bool) -> bool:
    details.quiet = not value
    settings = context.find_root().obj
    if isinstance(settings, SettingsFile) and settings.path is not None:
        details.print(f"settings of {settings.path}", highlight=False)
    return value


def _declare(
    quiet: Annotated[
        bool,
        typer.Option(
            "--quiet",
            "-q",
            callback=_set_quiet,
            expose_value=False,
            help="Say nothing but results and what went wrong.",
        ),
    ] = False,
    verbose: Annotated[
        bool,
        typer.Option(
            "--verbose",
            "-v",
            callback=_set_verbose,
            expose_value=False,
            help="Say more on standard error: settings, times, details of errors.",
        ),
    ] = False,
) -> None:
    """Carry the declarations of the common options."""


def common_options() -> list[Any]:
    """Return the options as typer makes them of their declarations."""
    carrier = typer.Typer(add_completion=False)
    carrier.command()(_declare)
    return list(typer.main.get_command(carrier).params)
