"""The command ``mansion`` itself: its help, the options before a command, and the settings that all commands share."""

import os
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.command_group import MansionGroup
from mansion_bringup.cli.settings_file import SettingsFile, find_settings
from mansion_bringup.cli.version import print_version

__all__ = ["app"]

app = typer.Typer(
    name="mansion",
    help="One sentence in, a furnished multi-storey building out, and a robot that works in it through ROS 2.",
    cls=MansionGroup,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
)


@app.callback()
def common(
    context: typer.Context,
    config_file: Annotated[
        Path | None,
        typer.Option(
            "--config",
            "-C",
            envvar="MANSION_CONFIG",
            help="Settings file; mansion.toml in the working folder by default.",
        ),
    ] = None,
    version: Annotated[
        bool,
        typer.Option(
            "--version", "-V", callback=print_version, is_eager=True, help="Print the versions in use, and exit."
        ),
    ] = False,
) -> None:
    """Take what every command has in common; the help of the whole is the text of `app`."""
    if context.resilient_parsing:
        return
    settings = find_settings(config_file, context.command)
    context.obj = settings
    context.default_map = settings.default_map(context.command)
    _pass_on(settings)


def _pass_on(settings: SettingsFile) -> None:
    """Give the settings of the language model to this process and all that it starts; variables of the user's win."""
    if not settings.llm:
        return
    from mansion_llm.settings import setting_variable

    for name, value in settings.llm.items():
        os.environ.setdefault(setting_variable(name), value)
