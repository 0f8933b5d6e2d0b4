"""What a description must be to be planned: there, not too long, and understood."""

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.limits import MAX_BUILDING_AREA, MAX_COORDINATE, MAX_FLOOR_AREA, MAX_ROOMS
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.wording import counted
from mansion_planner.brief.facts import BriefFacts

__all__ = [
    "check_length",
    "check_number",
    "check_size",
    "check_there",
    "check_total_area",
    "check_understood",
    "nothing_understood",
    "states_something",
]

MOST_ASKED = 400
"""Rooms of a storey that a description may ask for: to arrange them takes time that grows as the third power."""

MOST_CHARACTERS = 20_000
"""Characters of a description that are read."""


def check_there(description: str) -> None:
    """Refuse an empty description.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``.
    """
    if not description.strip():
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            'the description is empty; write what to build, such as "a two-storey house with three bedrooms"',
            path="$.description",
        )


def check_length(description: str) -> None:
    """Refuse a description that is longer than what is read.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``.
    """
    if len(description) > MOST_CHARACTERS:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"the description has {len(description)} characters; up to {MOST_CHARACTERS} are read",
            path="$.description",
        )


def check_number(name: str, number: int, storeys: int) -> None:
    """Refuse more rooms of one kind than a number of storeys is planned with, before they are shared out.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the limit.
    """
    if number > MOST_ASKED * storeys:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the description asks for {number:.4g} rooms of the kind {name}; at most {MOST_ASKED} on each of"
            f" {counted(storeys, 'storey')} are planned",
            path="$.description",
            details={"room_type": name, "limit": MOST_ASKED * storeys},
        )


def check_size(program: BuildingProgram) -> None:
    """Refuse a building that is larger than what is built (see `mansion_msgs_py.limits`).

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the storey and the limit.
    """
    for floor in program.floors:
        if floor.gross_floor_area > MAX_FLOOR_AREA:
            raise _too_large(f"storey {floor.label or floor.index}", floor.gross_floor_area, MAX_FLOOR_AREA)
        reach = max((abs(value) for point in floor.outline for value in point), default=0.0)
        if reach > MAX_COORDINATE:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"storey {floor.label or floor.index} of {floor.gross_floor_area:.0f} m2 would be {reach:.0f} m long;"
                f" at most {MAX_COORDINATE:.0f} m are built",
                path="$.description",
                details={"length": reach, "limit": MAX_COORDINATE},
            )
        if len(floor.rooms) > MAX_ROOMS:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"storey {floor.label or floor.index} would have {len(floor.rooms)} rooms; at most {MAX_ROOMS} are"
                " built",
                path="$.description",
            )
    check_total_area(sum(floor.gross_floor_area for floor in program.floors))


def check_total_area(total: float) -> None:
    """Refuse a building beyond the limit of area, square metres.

    Raises
    ------
    MansionError
        ``INFEASIBLE``.
    """
    if total > MAX_BUILDING_AREA:
        raise _too_large("the building", total, MAX_BUILDING_AREA)


def _too_large(what: str, area: float, limit: float) -> MansionError:
    return MansionError(
        ErrorCode.INFEASIBLE,
        f"{what} would have {area:.4g} m2; at most {limit:.0f} m2 are built",
        path="$.description",
        details={"area": area, "limit": limit},
    )


def states_something(facts: BriefFacts) -> bool:
    """Whether facts hold more than the size or the unknown name of the building."""
    return bool(_stated(facts))


def _stated(facts: BriefFacts) -> list[str]:
    return [name for name, value in vars(facts).items() if value and name not in _UNSTATED]


_UNSTATED = frozenset(
    {"unread", "unheeded", "corrections", "combined", "building_name", "building_like", "building_span", "size"}
)
"""Fields of the facts that say nothing of a building by themselves."""


def check_understood(facts: BriefFacts, description: str) -> None:
    """Refuse a text of which the rules read next to nothing.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` with the words that were not understood.
    """
    stated = _stated(facts)
    unread = sum(len(span.words.split()) for span in facts.unread)
    words = len(description.split())
    if facts.building and words <= 8:
        return  # "Flat: 3½ rooms"
    if facts.building_like and not facts.unread:
        return  # "A canteen building"
    if (stated and unread <= 0.6 * words) or (len(stated) > 2 and unread < 0.8 * words):
        return
    raise nothing_understood(facts, description)


def nothing_understood(facts: BriefFacts, description: str) -> MansionError:
    """Return the refusal of a text that is not understood."""
    shown = ", ".join(f'"{span.words}"' for span in facts.unread[:4]) or f'"{description.strip()[:60]}"'
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"next to nothing of the description was understood: {shown}; it must be English and name a kind of building, "
        "rooms, storeys or an area; --planner llm reads other languages",
        path="$.description",
        details={"unread": [span.words for span in facts.unread], "stage": "program"},
    )
