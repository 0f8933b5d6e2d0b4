"""The group of all commands: it imports a command's module when the command is called, and adds the common options.

No command should wait for what others need: all modules together take several times as long to import as one.
"""

import logging
from collections.abc import MutableMapping
from importlib import import_module
from typing import Annotated, Any, Final

import typer
import typer.main
from typer.core import TyperGroup

from mansion_bringup.cli.console import details, err
from mansion_bringup.cli.settings_file import SettingsFile, commands_below
from mansion_bringup.cli.slow_commands import announced

__all__ = ["MODULES", "MansionGroup"]

MODULES: Final[dict[str, tuple[str, ...]]] = {
    "build": ("build",),
    "assets": ("assets",),
    "bench": ("bench",),
    "plan": ("plan",),
    "edit": ("edit",),
    "export": ("export", "view"),
    "graph": ("up", "call", "echo", "graph"),
    "solve": ("solve", "place"),
    "schema": ("schema",),
    "check": ("check",),
    "run_tests": ("test",),
    "skill": ("skill",),
    "look": ("look",),
    "task": ("task",),
    "world": ("world",),
    "config": ("config",),
    "record": ("record",),
}
"""The modules of this package that have commands, in the order of the help, and the names of these commands."""

_MODULE_OF: Final = {command: module for module, commands in MODULES.items() for command in commands}


class MansionGroup(TyperGroup):
    """The group of all commands; it gives each of them the common options."""

    def __init__(self, **attributes: Any) -> None:
        self._loaded: dict[str, dict[str, Any]] = {}
        super().__init__(**attributes)

    @property
    def commands(self) -> MutableMapping[str, Any]:
        """All commands by their names, with everything imported."""
        return {name: command for module in MODULES for name, command in self._commands_of(module).items()}

    @commands.setter
    def commands(self, value: MutableMapping[str, Any]) -> None:
        if value:
            raise TypeError(f"commands are declared in {__name__}.MODULES, not added: {', '.join(value)}")

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Return the command of that name, or None; no other module than its own is imported."""
        module = _MODULE_OF.get(cmd_name)
        return None if module is None else self._commands_of(module)[cmd_name]

    def list_commands(self, ctx: Any) -> list[str]:
        """Return the names in the order of the help."""
        return list(_MODULE_OF)

    def _commands_of(self, module: str) -> dict[str, Any]:
        if module not in self._loaded:
            carrier = typer.Typer(pretty_exceptions_enable=False, rich_markup_mode="rich", add_completion=False)
            import_module(f"mansion_bringup.cli.{module}").register(carrier)
            found = dict(typer.main.get_group(carrier).commands)
            for name, group_or_command in found.items():
                for path, command in commands_below(group_or_command):
                    command.params.extend(_common_options())
                    command.callback = announced(" ".join((name, *path)), command.callback)
            self._loaded[module] = found
        return self._loaded[module]


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
        typer.Option("--quiet", "-q", callback=_set_quiet, expose_value=False, help="Print only results and errors."),
    ] = False,
    verbose: Annotated[
        bool,
        typer.Option(
            "--verbose",
            "-v",
            callback=_set_verbose,
            expose_value=False,
            help="Print more to standard error: settings, times, details of errors.",
        ),
    ] = False,
) -> None:
    """Carry the declarations of the common options."""


def _common_options() -> list[Any]:
    """Return the options as typer makes them of their declarations."""
    carrier = typer.Typer(add_completion=False)
    carrier.command()(_declare)
    return list(typer.main.get_command(carrier).params)
