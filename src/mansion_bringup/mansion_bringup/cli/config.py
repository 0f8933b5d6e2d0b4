"""``mansion config``: the settings in effect, and where each comes from."""

import os
from collections.abc import Iterator
from typing import Annotated, Any

import msgspec
import typer
from rich.table import Table

from mansion_bringup.cli.console import AsJson, err, out, print_json
from mansion_bringup.cli.settings_file import (
    DEFAULT_FILE,
    LLM,
    SHARED,
    SettingsFile,
    commands_below,
    configurable,
    option_key,
)
from mansion_llm.secret import Secret
from mansion_llm.settings import LlmSettings, setting_variable, settings_and_places
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import choices

__all__ = ["Setting", "command_settings", "common_settings", "llm_settings", "register"]


class Setting(msgspec.Struct, frozen=True, kw_only=True):
    """One setting in effect.

    Attributes
    ----------
    command : str
        The command that it belongs to; empty for one of several commands, ``llm`` for one of the language model.
    value : object
        The value in effect; null where nothing is set.
    source : str
        The file with the key in it, a variable of the environment, or ``default``.
    """

    command: str
    name: str
    value: Any
    source: str


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("config")(config)


def config(
    context: typer.Context,
    command: Annotated[list[str] | None, typer.Argument(help="Only this command, with all its options.")] = None,
    as_json: AsJson = False,
) -> None:
    """Show which settings hold and where each comes from: a file, the environment, or a command's own default.

    Without a command: the settings of several commands, those of single commands in the file, and the language model's.

    Examples:

      mansion config

      mansion config build

      mansion --config lab.toml config task generate --json
    """
    root: Any = context.find_root().command
    settings: SettingsFile = context.find_root().obj
    rows = command_settings(settings, root, tuple(command)) if command else common_settings(settings)
    if as_json:
        print_json({"file": None if settings.path is None else str(settings.path), "settings": rows})
        return
    found = f"settings of {settings.path}" if settings.path else f"no settings file ({DEFAULT_FILE} is not here)"
    err.print(found, highlight=False)
    table = Table("setting", "value", "from", box=None)
    for row in rows:
        shown = "" if row.value is None else str(row.value)
        table.add_row(".".join(filter(None, (row.command.replace(" ", "."), row.name))), shown, row.source)
    out.print(table)


def common_settings(settings: SettingsFile) -> list[Setting]:
    """Return the settings that several commands share, those of single commands in a file, and the language model's."""
    rows = []
    for name in SHARED:
        held = settings.options.get(((), name))
        source = "each command's default" if held is None else f"{settings.path}: {name}"
        rows.append(Setting(command="", name=name, value=held, source=source))
    for (path, name), value in settings.options.items():
        if path:
            place = ".".join((*path, name))
            rows.append(Setting(command=" ".join(path), name=name, value=value, source=f"{settings.path}: {place}"))
    return [*rows, *llm_settings(settings)]


def command_settings(settings: SettingsFile, root: Any, path: tuple[str, ...]) -> list[Setting]:
    """Return every option of a command that a file may set.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the commands that there are.
    """
    known = dict(commands_below(root))
    if path not in known:
        name = " ".join(path)
        there = choices(name, (" ".join(each) for each in known), "commands")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no command {name!r}; {there}")
    return list(_options(settings, path, known[path]))


def _options(settings: SettingsFile, path: tuple[str, ...], command: Any) -> Iterator[Setting]:
    for parameter in configurable(command):
        key = option_key(parameter)
        found = settings.value_for(path, key)
        value = parameter.default if found is None else found[1]
        source = "default" if found is None else f"{settings.path}: {found[0]}"
        shown = value if isinstance(value, str | int | float | bool | list) else None
        yield Setting(command=" ".join(path), name=key, value=shown, source=source)


def llm_settings(settings: SettingsFile) -> list[Setting]:
    """Return the settings of the language model; of a key only that there is one."""
    held, places = settings_and_places()
    rows = []
    for name, value in _shown(held).items():
        source = places.get(name, "default")
        if source == setting_variable(name) and settings.llm.get(name) == os.environ[source]:
            source = f"{settings.path}: {LLM}.{name}"
        rows.append(Setting(command=LLM, name=name, value=value, source=source))
    return rows


def _shown(held: LlmSettings) -> dict[str, Any]:
    """Return the settings as they may be shown."""
    values: dict[str, Any] = {}
    for name in held.__dataclass_fields__:
        value = getattr(held, name)
        if isinstance(value, Secret):
            values[name] = "set" if value.reveal() else None
        elif name == "base_url":
            values[name] = held.place or None
        elif isinstance(value, tuple):
            values[name] = ",".join(value)
        else:
            values[name] = value if value is None or isinstance(value, int | float) else str(value) or None
    return values
