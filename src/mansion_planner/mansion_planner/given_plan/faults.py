"""What is wrong with a plan: all of it, each fault with its floor, its room and its place."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.wording import counted

__all__ = ["OPENINGS", "Findings", "Origin", "PlanFault"]

_SHOWN = 3
_SAME = 0.02

OPENINGS = ("door", "window")
"""What origins of openings are called."""


def _apart(one: Point | None, other: Point | None) -> float:
    return math.dist(one, other) if one is not None and other is not None else math.inf


def _same_place(one: Point | None, other: Point | None) -> bool:
    return _apart(one, other) < _SAME


@dataclass(frozen=True)
class PlanFault:
    """A fault of a plan.

    Attributes
    ----------
    floor : int, optional
        ``None`` for one of the whole building.
    subject : str
        The room, the door or whatever else it is about.
    place : Point, optional
        Where it is, in metres.
    source : str
        Where the file has it, if that says so.
    """

    floor: int | None
    subject: str
    message: str
    place: Point | None = None
    source: str = ""

    def __str__(self) -> str:
        floor = "building" if self.floor is None else f"floor {self.floor}"
        place = f" at ({self.place[0]:.2f}, {self.place[1]:.2f})" if self.place else ""
        subject = f", {self.subject}" if self.subject else ""
        source = f" [{self.source}]" if self.source else ""
        return f"{floor}{subject}{place}{source}: {self.message}"


@dataclass(frozen=True)
class Origin:
    """Where a file has a room, or an opening, of which a fault may be told.

    Attributes
    ----------
    subject : str
        Name of a room; ``door`` or ``window``.
    place : Point, optional
        In metres; the middle of an opening, any corner of a room.
    """

    floor: int
    subject: str
    place: Point | None
    source: str


@dataclass
class Findings:
    """What reading a plan brings up: faults, and what was made of what it leaves open.

    Attributes
    ----------
    notes : list of (int or None, str, str, str)
        Floor, what the plan says or lacks, what it gets instead, and why.
    """

    faults: list[PlanFault] = field(default_factory=list)
    notes: list[tuple[int | None, str, str, str]] = field(default_factory=list)
    origins: list[Origin] = field(default_factory=list)

    def fault(self, floor: int | None, subject: str, message: str, place: Point | None = None) -> None:
        """Add a fault, once."""
        found = PlanFault(floor, subject, message, place, self._source(floor, subject, place))
        if found not in self.faults:
            self.faults.append(found)

    def _source(self, floor: int | None, subject: str, place: Point | None) -> str:
        """Return where the file has the subject of a fault: its rooms by their names, openings by their place."""
        here = [origin for origin in self.origins if origin.floor == floor]
        at = [origin for origin in here if subject.startswith(origin.subject) and _same_place(origin.place, place)]
        openings = [origin.source for origin in at if origin.subject in OPENINGS]
        if openings or subject in OPENINGS:
            return openings[0] if openings else ""
        named = [origin for origin in here if origin.subject not in OPENINGS]
        sources = []
        for name in (subject,) if any(o.subject == subject for o in named) else subject.split(" and "):
            same = [origin for origin in named if origin.subject == name]
            if same:
                sources.append(min(same, key=lambda origin: _apart(origin.place, place)).source)
        return ", ".join(dict.fromkeys(sources))

    def note(self, floor: int | None, wish: str, got: str, reason: str) -> None:
        """Say what became of something that the plan leaves open, or that cannot be built as it has it."""
        if (floor, wish, got, reason) not in self.notes:
            self.notes.append((floor, wish, got, reason))

    def refuse(self) -> None:
        """Raise all faults together, if there are any.

        Raises
        ------
        MansionError
            ``INFEASIBLE`` with every fault in ``details["faults"]``.
        """
        if not self.faults:
            return
        faults: Sequence[str] = [str(fault) for fault in self.faults]
        more = f"; and {len(faults) - _SHOWN} more" if len(faults) > _SHOWN else ""
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the plan has {counted(len(faults), 'fault')}: {'; '.join(faults[:_SHOWN])}{more}",
            path="$.plan",
            details={"faults": faults, "stage": "program"},
        )
