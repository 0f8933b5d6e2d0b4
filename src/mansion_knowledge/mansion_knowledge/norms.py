"""Rules of building as data: what codes and practice ask of which buildings and rooms, each with its source."""

import tomllib
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal, TypeAlias

from mansion_knowledge.base import KnowledgeBase
from mansion_knowledge.room_names import kin_of
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["Norm", "Norms", "Severity", "load_norms"]

Severity: TypeAlias = Literal["deviation", "advice"]
"""What not to keep a rule means: a deviation from what a code asks, or from good practice alone."""

_FILE = Path(__file__).parent / "data" / "norms.toml"
_TEXTS = ("statement", "source", "unit")
_SEVERITIES: tuple[Severity, ...] = ("deviation", "advice")
_LISTS = ("families", "rooms", "others", "things", "gives_way", "yields_to")


@dataclass(frozen=True)
class Norm:
    """A rule of building.

    Attributes
    ----------
    statement, source : str
        What holds, in plain words; which code and section says so, or that it is practice.
    figure : float
        The limit, in `unit`.
    severity : {"deviation", "advice"}
    families : tuple of str
        Families of building types that it holds for; all when empty.
    rooms, others : tuple of str
        Room types that it holds for, and those that it relates them to.
    things : tuple of str
        Categories of objects that answer it.
    gives_way : tuple of str
        Kinds of wishes of a brief that come before it.
    yields_to : tuple of str
        Room types of which a wished number comes before it, where wishes for rooms do.
    by : dict of str to float
        Figures for room types, building types, families, or what else the rule tells apart.
    """

    id: str
    statement: str
    source: str
    figure: float
    unit: str
    severity: Severity = "deviation"
    families: tuple[str, ...] = ()
    rooms: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    things: tuple[str, ...] = ()
    gives_way: tuple[str, ...] = ()
    yields_to: tuple[str, ...] = ()
    by: dict[str, float] = field(default_factory=dict)

    def holds_for(self, family: str) -> bool:
        """Whether the rule is asked of buildings of a family."""
        return not self.families or family in self.families

    def limit(self, *names: str) -> float:
        """Return the figure for the first of some names that has its own, or the general one."""
        return next((self.by[name] for name in names if name in self.by), self.figure)


@dataclass(frozen=True)
class Norms:
    """All rules by id, and the square metres that a person takes in rooms."""

    rules: dict[str, Norm]
    occupants: dict[str, float]

    def people(self, room_type: str, area: float, knowledge: KnowledgeBase) -> float:
        """Return how many people a room holds; rooms that people only pass through hold none.

        Parameters
        ----------
        area : float
            Square metres.
        """
        kind = knowledge.room(room_type)
        if kind.zone == "circulation" or (kind.wet and room_type not in self.occupants):
            return 0.0
        names = (room_type, kin_of(room_type), kind.zone)
        return area / next(self.occupants[name] for name in names if name in self.occupants)


@lru_cache(maxsize=1)
def load_norms() -> Norms:
    """Return the rules that Mansion ships.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming the rule and its fault.
    """
    records = tomllib.loads(_FILE.read_text(encoding="utf-8"))
    occupants = {name: float(area) for name, area in records.pop("occupants").items()}
    return Norms({name: _norm(name, record) for name, record in records.items()}, occupants)


def _norm(name: str, record: dict[str, Any]) -> Norm:
    unknown = set(record) - {*_TEXTS, *_LISTS, "figure", "severity", "by"}
    missing = {*_TEXTS, "figure"} - set(record)
    if unknown or missing:
        raise _fault(name, f"unknown {sorted(unknown)}, missing {sorted(missing)}")
    severity = next((word for word in _SEVERITIES if word == record.get("severity", "deviation")), None)
    if severity is None:
        raise _fault(name, f"severity {record['severity']!r} is not one of {', '.join(_SEVERITIES)}")
    texts: dict[str, Any] = {key: str(record[key]) for key in _TEXTS}
    lists: dict[str, Any] = {key: tuple(record.get(key, ())) for key in _LISTS}
    figures = {key: float(value) for key, value in record.get("by", {}).items()}
    return Norm(id=name, figure=float(record["figure"]), severity=severity, by=figures, **texts, **lists)


def _fault(name: str, message: str) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"rule {name!r} of {_FILE.name}: {message}",
        details={"file": _FILE.name, "record": name},
    )
