"""What is wrong with a plan: all of it, each fault with its floor, its room and its place."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.wording import counted

__all__ = ["Findings", "PlanFault"]

_SHOWN = 3


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
    """

    floor: int | None
    subject: str
    message: str
    place: Point | None = None

    def __str__(self) -> str:
        floor = "building" if self.floor is None else f"floor {self.floor}"
        place = f" at ({self.place[0]:.2f}, {self.place[1]:.2f})" if self.place else ""
        subject = f", {self.subject}" if self.subject else ""
        return f"{floor}{subject}{place}: {self.message}"


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

    def fault(self, floor: int | None, subject: str, message: str, place: Point | None = None) -> None:
        """Add a fault, once."""
        found = PlanFault(floor, subject, message, place)
        if found not in self.faults:
            self.faults.append(found)

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
