"""What is decided of a building before its rooms, and the record of statements that gave way to others."""

from dataclasses import dataclass, field

from shapely.geometry import Polygon

from mansion_knowledge import BuildingType
from mansion_msgs_py.program import Downgrade, RequestedObject, TraceEntry
from mansion_planner.brief.facts import BriefFacts, Span

__all__ = ["Decisions", "conflict", "quoted"]


@dataclass
class Decisions:
    """What the building is to be.

    Attributes
    ----------
    floors, basements : int
    area : float
        Gross area wished for a storey at and above the ground, square metres.
    area_stated : bool
        `area` follows from what the brief or the request states.
    outline : Polygon, optional
        The given footprint.
    free_form : bool
        The outline is given and is no rectangle.
    furniture : dict of (int, str) to list of RequestedObject
        What the brief wants in a room, by storey and room id.
    """

    building: BuildingType
    floors: int
    basements: int
    area: float
    area_stated: bool
    area_span: str
    style: str
    facts: BriefFacts
    seed: int
    free_form: bool = False
    outline: Polygon | None = None
    trace: list[TraceEntry] = field(default_factory=list)
    downgrades: list[Downgrade] = field(default_factory=list)
    furniture: dict[tuple[int, str], list[RequestedObject]] = field(default_factory=dict)


def conflict(wish: str, got: str, reason: str, floor: int | None = None) -> Downgrade:
    """Return the record of a statement that gave way to another one."""
    return Downgrade(wish=wish, got=got, reason=reason, stage="program", floor=floor)


def quoted(span: Span) -> str:
    """Return the place of some words for an error message."""
    return f'"{span.words}" (characters {span.start} to {span.end} of the description)'
