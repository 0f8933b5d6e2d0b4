"""The record of a step of the planner: lines of its trace, and statements of the brief that gave way."""

from dataclasses import dataclass

from mansion_msgs_py.program import Downgrade, TraceEntry

__all__ = ["Record"]


@dataclass(frozen=True)
class Record:
    """Lines for the trace of a program, and the statements of the brief that gave way."""

    trace: tuple[TraceEntry, ...] = ()
    downgrades: tuple[Downgrade, ...] = ()

    def __add__(self, later: "Record") -> "Record":
        """Return this record followed by a later one."""
        return Record(self.trace + later.trace, self.downgrades + later.downgrades)
