"""Where the model is and how it is asked: environment first, then a TOML file, then defaults."""

import os
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any, Literal, get_args

from mansion_llm.secret import Secret, shown_url
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = [
    "PIECES",
    "WITHOUT_MODEL",
    "LlmSettings",
    "checked_setting",
    "load_settings",
    "setting_names",
    "setting_variable",
    "settings_and_places",
]

Structured = Literal["auto", "schema", "object", "text"]
Images = Literal["auto", "yes", "no"]

PIECES = ("reading", "numbers", "materials", "program", "topology", "seeds", "objects")
"""What a model can be asked for; the rest is then planned by rules."""

WITHOUT_MODEL = "use --planner rules"
"""What commands that can ask a model offer without one."""

_PREFIX = "MANSION_LLM_"

_OPENAI = ("base_url", "api_key")
"""Settings for which the usual variables of OpenAI's client stand in."""


@dataclass(frozen=True)
class LlmSettings:
    """Settings of the client; each is ``MANSION_LLM_`` + its upper-case name in the environment.

    Attributes
    ----------
    base_url, model : str
        Address and model of an OpenAI-compatible endpoint (``http://127.0.0.1:8000/v1``).
    api_key : Secret
        ``MANSION_LLM_API_KEY``; endpoints without keys need none.
    timeout : float
        Seconds that one request may take.
    retries : int
        Repetitions of a request that the endpoint was too busy or too slow for, or failed at.
    backoff : float
        Seconds before the first repetition; doubled for each further one, at most 60. ``Retry-After`` comes first.
    repairs : int
        How often a faulty answer is asked for again.
    temperature : float, optional
        The endpoint's default when absent.
    max_tokens : int
        Most tokens of an answer.
    structured : {"auto", "schema", "object", "text"}
        ``auto`` tries a JSON schema, then a JSON object, then plain text, and remembers what the endpoint took.
    images : {"auto", "yes", "no"}
        ``auto`` attaches pictures until the endpoint refuses them.
    input_price, output_price : float
        Cost of a million tokens.
    cache : Path, optional
        Folder of answers by content.
    record, replay : Path, optional
        File that answers are written to; file that they are read from, without network.
    pieces : tuple of str
        Which of `PIECES` the model is asked for.
    """

    base_url: str = ""
    model: str = ""
    api_key: Secret = field(default_factory=lambda: Secret(""))
    timeout: float = 120.0
    retries: int = 4
    backoff: float = 1.0
    repairs: int = 2
    temperature: float | None = None
    max_tokens: int = 8192
    structured: Structured = "auto"
    images: Images = "auto"
    input_price: float = 0.0
    output_price: float = 0.0
    cache: Path | None = None
    record: Path | None = None
    replay: Path | None = None
    pieces: tuple[str, ...] = PIECES

    def require_endpoint(self, otherwise: str = WITHOUT_MODEL) -> None:
        """Refuse settings that name no model to ask.

        Parameters
        ----------
        otherwise : str
            What the user can do without a model, for the message.

        Raises
        ------
        MansionError
            ``UNAVAILABLE``, naming the variables to set.
        """
        if self.replay is not None or (self.base_url and self.model):
            return
        missing = [name for name, value in (("BASE_URL", self.base_url), ("MODEL", self.model)) if not value]
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            "no language model is configured: set "
            + " and ".join(_PREFIX + name for name in missing)
            + " (and MANSION_LLM_API_KEY where the endpoint wants a key), or name a TOML file in "
            f"MANSION_LLM_CONFIG, or set MANSION_LLM_REPLAY to a recording; or {otherwise}",
            path="$.planner" if otherwise == WITHOUT_MODEL else "$",
            details={"missing": [_PREFIX + name for name in missing]},
        )

    @property
    def place(self) -> str:
        """The endpoint as it may be shown."""
        return shown_url(self.base_url)


def load_settings(environment: Mapping[str, str] | None = None, *, file: Path | None = None) -> LlmSettings:
    """Return the settings.

    Parameters
    ----------
    environment : mapping, optional
        The process's own when absent. ``OPENAI_BASE_URL`` and ``OPENAI_API_KEY`` stand in for ours.
    file : Path, optional
        TOML file; else ``MANSION_LLM_CONFIG``, else ``llm.toml`` in the user's ``mansion`` configuration folder.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming the variable or key at fault, ``NOT_FOUND`` for a file that is named and missing.
        Values are not repeated in the message, for one of them may be a key in the wrong place.
    """
    return settings_and_places(environment, file=file)[0]


def settings_and_places(
    environment: Mapping[str, str] | None = None, *, file: Path | None = None
) -> tuple[LlmSettings, dict[str, str]]:
    """Return the settings as `load_settings` does, and where each comes from that is not a default."""
    environment = os.environ if environment is None else environment
    values = _file_values(environment, file)
    places = dict.fromkeys(values, "the configuration file")
    for name in setting_names():
        for variable in (f"OPENAI_{name.upper()}" if name in _OPENAI else "", setting_variable(name)):
            if environment.get(variable, "") != "":
                values[name], places[name] = environment[variable], variable
    known = setting_names()
    for name in values:
        if name not in known:
            raise _fault(name, "the configuration file", f"is not a setting; settings are {', '.join(sorted(known))}")
    return LlmSettings(**{n: checked_setting(n, v, places[n]) for n, v in values.items()}), places


def setting_names() -> tuple[str, ...]:
    """Return the names of all settings."""
    return tuple(entry.name for entry in fields(LlmSettings))


def setting_variable(name: str) -> str:
    """Return the environment variable of a setting."""
    return _PREFIX + name.upper()


def _file_values(environment: Mapping[str, str], file: Path | None) -> dict[str, Any]:
    named = file is not None or bool(environment.get(_PREFIX + "CONFIG"))
    if file is None:
        home = Path(environment.get("XDG_CONFIG_HOME") or "~/.config").expanduser()
        file = Path(environment.get(_PREFIX + "CONFIG") or home / "mansion" / "llm.toml").expanduser()
    if not file.is_file():
        if named:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no configuration file {file}")
        return {}
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeError):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"the configuration file {file} is not valid TOML") from None


def _fault(name: str, place: str, what: str) -> MansionError:
    return MansionError(ErrorCode.INVALID_PAYLOAD, f"{name} in {place} {what}", details={"setting": name})


_CHOICES = {"structured": get_args(Structured), "images": get_args(Images)}
_LEAST = {
    "timeout": 0.01, "backoff": 0.0, "input_price": 0.0, "output_price": 0.0, "temperature": 0.0,
    "retries": 0, "repairs": 0, "max_tokens": 16,
}  # fmt: skip


def checked_setting(name: str, value: Any, place: str) -> Any:
    """Return the value of a setting from what a variable or a file has.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` with the name, the place and what would be accepted.
    """
    if name == "api_key":
        return Secret(str(value).strip())
    if name in ("cache", "record", "replay"):
        return Path(str(value)).expanduser() if str(value) else None
    if name == "pieces":
        parts = value if isinstance(value, list) else str(value).replace(",", " ").split()
        for part in parts:
            if part not in PIECES:
                raise _fault(name, place, f"may hold {', '.join(PIECES)}")
        return tuple(parts)
    if name in _CHOICES:
        if value not in _CHOICES[name]:
            raise _fault(name, place, f"must be one of {', '.join(_CHOICES[name])}")
        return value
    if name in _LEAST:
        return _number(name, value, place)
    return str(value).strip()


def _number(name: str, value: Any, place: str) -> float | int:
    whole = name in ("retries", "repairs", "max_tokens")
    try:
        number = int(value) if whole else float(value)
    except (TypeError, ValueError):
        raise _fault(name, place, "must be a number") from None
    if not _LEAST[name] <= number <= 1e9:
        raise _fault(name, place, f"must be at least {_LEAST[name]:g}")
    return number
