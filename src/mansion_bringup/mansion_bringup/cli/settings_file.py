"""``mansion.toml``: defaults of the commands' options, and settings of the language model.

Keys at the top are options that several commands have; a table is named like a command (``[build]``,
``[task.generate]``) and holds options of it; ``[llm]`` holds settings of the language model. Options that are
given win over the file, and so do environment variables.

A file that merely lies in the working folder may come from a stranger. It chooses among what a user may choose without
harm; where services may write and where a model and its key are asked is taken from a file that the user named.
"""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.wording import choices

__all__ = [
    "DEFAULT_FILE",
    "LLM",
    "SHARED",
    "SettingsFile",
    "commands_below",
    "configurable",
    "find_settings",
    "option_key",
]

DEFAULT_FILE: Final = Path("mansion.toml")
"""Read in the working folder where no other file is named."""

LLM: Final = "llm"
"""The table of the language model's settings."""

SHARED: Final = ("planner", "formats", "assets", "seed", "jobs", "physics", "strict", "namespace", "quiet", "verbose")
"""Options that may stand at the top: they mean the same to every command that has them."""

_SAID_EACH_TIME: Final = frozenset({"output", "force", "reset", "help", "version", "config"})
"""What a command writes, replaces or forgets is never a default."""

_NAMED_FILE_ALONE: Final = frozenset(
    {("up", "allow"), ("up", "params_file"), *((LLM, name) for name in ("base_url", "cache", "record", "replay"))}
)
"""What no file may choose that only happens to lie in the working folder."""


@dataclass(frozen=True)
class SettingsFile:
    """What a settings file holds, checked against the commands.

    Attributes
    ----------
    path : Path, optional
        The file; none was found when absent.
    options : dict
        Values by the path of the command and the option's key; the path is empty for what stands at the top.
    llm : dict of str to str
        Settings of the language model as their environment variables would have them.
    """

    path: Path | None = None
    options: dict[tuple[tuple[str, ...], str], Any] = field(default_factory=dict)
    llm: dict[str, str] = field(default_factory=dict)

    def value_for(self, path: tuple[str, ...], key: str) -> tuple[str, Any] | None:
        """Return the place in the file and the value that an option of a command has there, or None."""
        if (path, key) in self.options:
            return ".".join((*path, key)), self.options[path, key]
        if key in SHARED and ((), key) in self.options:
            return key, self.options[(), key]
        return None

    def default_map(self, root: Any) -> dict[str, Any]:
        """Return the defaults as the command line's parser takes them, a dictionary for each command and group."""
        whole: dict[str, Any] = {}
        if not self.options:
            return whole
        for path, command in commands_below(root):
            inner = whole
            for name in path:
                inner = inner.setdefault(name, {})
            for parameter in configurable(command):
                found = self.value_for(path, option_key(parameter))
                if found is not None:
                    inner[parameter.name] = found[1]
        return whole


def find_settings(named: Path | None, root: Any) -> SettingsFile:
    """Return the settings of the file that is named, or else of the one in the working folder, if there is one.

    Parameters
    ----------
    named : Path, optional
        The file that the user named.
    root : click group
        The command line, whose options decide what a file may hold.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a named file that is not there, ``INVALID_PAYLOAD`` with the place of a key that is not a
        setting, of a value that does not fit, and of a setting that only a named file may have.
    """
    if named is None and not DEFAULT_FILE.is_file():
        return SettingsFile()
    path = DEFAULT_FILE if named is None else named
    try:
        read = tomllib.loads(read_bytes(path, "a settings file").decode("utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{path} is not valid TOML: {error}") from None
    return _Reader(path, root, trusted=named is not None).read(read)


def commands_below(command: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield every command of a group with its path, those of inner groups too."""
    inner = getattr(command, "commands", None)
    if inner is None:
        yield path, command
        return
    for name, each in inner.items():
        yield from commands_below(each, (*path, name))


def option_key(parameter: Any) -> str:
    """Return an option's name as a file has it: ``floor_area`` for ``--floor-area``."""
    return str(max(parameter.opts, key=len)).lstrip("-").replace("-", "_")


def configurable(command: Any) -> list[Any]:
    """Return the options of a command that a file may set."""
    return [
        parameter
        for parameter in command.params
        if parameter.param_type_name == "option" and option_key(parameter) not in _SAID_EACH_TIME
    ]


@dataclass(frozen=True)
class _Reader:
    """Checks a file's values against the options of the command line."""

    path: Path
    root: Any
    trusted: bool

    def read(self, tables: Mapping[str, Any]) -> SettingsFile:
        options: dict[tuple[tuple[str, ...], str], Any] = {}
        by_path = dict(commands_below(self.root))
        groups = {path[0] for path in by_path}
        for key, value in tables.items():
            if key == LLM:
                continue
            if key in SHARED and not isinstance(value, Mapping):  # [assets.list] is a command's
                options[(), key] = self._shared(key, value, by_path)
            elif key in groups and isinstance(value, Mapping):
                options |= self._table((key,), value, by_path)
            else:
                raise self._unknown(key, key, [*SHARED, LLM, *sorted(groups)], "settings and tables")
        return SettingsFile(self.path, options, self._llm(tables.get(LLM, {})))

    def _table(
        self, path: tuple[str, ...], values: Mapping[str, Any], by_path: Mapping[tuple[str, ...], Any]
    ) -> dict[tuple[tuple[str, ...], str], Any]:
        """Read the table of a command, or of a group of commands."""
        place = ".".join(path)
        if path not in by_path:
            inner = {known[len(path)] for known in by_path if known[: len(path)] == path}
            found: dict[tuple[tuple[str, ...], str], Any] = {}
            for name, value in values.items():
                if name not in inner or not isinstance(value, Mapping):
                    raise self._unknown(f"{place}.{name}", name, sorted(inner), f"commands of {place}")
                found |= self._table((*path, name), value, by_path)
            return found
        known = {option_key(parameter): parameter for parameter in configurable(by_path[path])}
        for name in values:
            where = f"{place}.{name}"
            if name in _SAID_EACH_TIME:
                raise self._fault(where, f"must be given each time, with --{name}; a file cannot set it")
            if name not in known:
                raise self._unknown(where, name, list(known), f"options of mansion {' '.join(path)}")
            self._refuse_unless_named(place, name)
        return {(path, name): self._checked(f"{place}.{name}", known[name], value) for name, value in values.items()}

    def _shared(self, key: str, value: Any, by_path: Mapping[tuple[str, ...], Any]) -> Any:
        """Check a value at the top against each command that has the option."""
        checked = value
        for command in by_path.values():
            for parameter in configurable(command):
                if option_key(parameter) == key:
                    checked = self._checked(key, parameter, value)
        return checked

    def _checked(self, place: str, parameter: Any, value: Any) -> Any:
        """Return a value as the parser takes it, after the option's own check."""
        if parameter.is_flag is not isinstance(value, bool):
            raise self._fault(
                place, "must be true or false" if parameter.is_flag else "is not a switch; give it a value"
            )
        items = value if isinstance(value, list) else [value]
        if not all(isinstance(item, str | int | float) for item in items):
            raise self._fault(place, "must be a string, a number, or a list of them")
        given: Any = value
        if parameter.multiple:
            given = [str(item) for item in items]
        elif isinstance(value, list):
            given = ",".join(str(item) for item in items)
        try:
            parameter.process_value(self.root.context_class(self.root), given)
        except Exception as error:
            # The parser has its own class of faults, which differs with the version of typer.
            if not hasattr(error, "format_message"):
                raise
            raise self._fault(place, f"does not fit: {getattr(error, 'message', error)}") from None
        return given

    def _llm(self, values: Any) -> dict[str, str]:
        from mansion_llm.settings import checked_setting, setting_names

        if not isinstance(values, Mapping):
            raise self._fault(LLM, "must be a table: [llm]")
        found = {}
        for name, value in values.items():
            place = f"{LLM}.{name}"
            if name == "api_key":
                raise self._fault(place, "is a secret and cannot be set in a file: set MANSION_LLM_API_KEY")
            if name not in setting_names():
                known = [each for each in setting_names() if each != "api_key"]
                raise self._unknown(place, name, known, "settings of the language model")
            self._refuse_unless_named(LLM, name)
            items = value if isinstance(value, list) else [value]
            if not all(isinstance(item, str | int | float) and not isinstance(item, bool) for item in items):
                raise self._fault(place, "must be a string, a number, or a list of them")
            text = ",".join(str(item) for item in items)
            if "\0" in text:
                raise self._fault(place, "has a character that an environment variable cannot hold")
            checked_setting(name, text, f"{self.path}, table [{LLM}],")
            found[name] = text
        return found

    def _refuse_unless_named(self, table: str, name: str) -> None:
        if not self.trusted and (table, name) in _NAMED_FILE_ALONE:
            raise self._fault(
                f"{table}.{name}",
                f"is only taken from a file that you name: --config {self.path} or MANSION_CONFIG={self.path}",
            )

    def _fault(self, place: str, what: str) -> MansionError:
        return MansionError(ErrorCode.INVALID_PAYLOAD, f"{self.path}: {place} {what}", path=f"$.{place}")

    def _unknown(self, place: str, name: str, known: list[str], noun: str) -> MansionError:
        return self._fault(place, f"is not a setting; {choices(name, known, noun)}{self._elsewhere(name)}")

    def _elsewhere(self, name: str) -> str:
        """Name the tables in which a misplaced option would be one."""
        from mansion_llm.settings import setting_names

        places = {
            ".".join(path)
            for path, command in commands_below(self.root)
            for parameter in configurable(command)
            if option_key(parameter) == name
        }
        places |= {LLM} if name in setting_names() else set()
        near = [f"[{place}]" for place in sorted(places)][:4]
        return f"; it is one in {', '.join(near)}" if near else ""
