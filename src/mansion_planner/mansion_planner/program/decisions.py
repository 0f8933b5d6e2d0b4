"""What is decided of a building before its rooms, and the refusal of statements that exclude each other."""

from dataclasses import dataclass, field

from shapely.geometry import Polygon

from mansion_knowledge import BuildingType
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade, TraceEntry
from mansion_planner.brief.facts import BriefFacts, Quantity, Span

__all__ = ["Decisions", "contradiction", "one_value", "quoted"]


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


def contradiction(what: str, first: str, second: str, path: str = "$.description") -> MansionError:
    """Return the refusal of two statements that exclude each other."""
    return MansionError(
        ErrorCode.CONTRADICTION,
        f"{what}: {first} against {second}; keep one of the two",
        path=path,
        details={"first": first, "second": second, "stage": "program"},
    )


def quoted(span: Span) -> str:
    """Return the place of some words for an error message."""
    return f'"{span.words}" (characters {span.start} to {span.end} of the description)'


def one_value(values: list[Quantity], what: str) -> Quantity | None:
    """Return the value that all statements share, or refuse."""
    if not values:
        return None
    for other in values[1:]:
        if abs(other.value - values[0].value) > 0.02 * values[0].value:
            raise contradiction(
                f"the description states two different {what}", quoted(values[0].span), quoted(other.span)
            )
    return values[0]
