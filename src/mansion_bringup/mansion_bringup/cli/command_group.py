"""The group of all commands, which imports the module of a command when the command is wanted.

A command shall not wait for what others need: all modules together take several times as long to import as one.
"""

from collections.abc import MutableMapping
from importlib import import_module
from typing import Any, Final

import typer
import typer.main
from typer.core import TyperGroup

from mansion_bringup.cli.common_options import common_options
from mansion_bringup.cli.patience import with_patience
from mansion_bringup.cli.settings_file import commands_below

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
    "quality": ("check", "test"),
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
                    command.params.extend(common_options())
                    command.callback = with_patience(" ".join((name, *path)), command.callback)
            self._loaded[module] = found
        return self._loaded[module]
