"""For how many people furniture is, and what those who use a building need a place for: to sleep, sit or work."""

from typing import Final, Literal, TypeAlias

from mansion_knowledge.object_kinds import answers, seats_of_row

__all__ = ["Use", "places_of", "use_of"]

Use: TypeAlias = Literal["sleep", "sit", "work", ""]

_RESIDENTS: Final = frozenset("resident inmate prisoner detainee tenant lodger monk nun".split())
_DWELLERS: Final = frozenset(
    "family person people student adult child kid teenager resident tenant flatmate friend inhabitant guest".split()
)
"""Those who sleep in a home or a lodging that is for them."""
_SEATED: Final = frozenset("pupil student child kid learner trainee diner guest spectator worshipper".split())
_WORKING: Final = frozenset("employee worker staff colleague developer engineer clerk".split())

_DOUBLE = 1.3
"""Width of a bed for two, metres."""
_SEATS: Final = frozenset("stool bench sofa loveseat pew booth_seat armchair".split())
_FOR_TWO: Final = frozenset({"bunk_bed"})
_BEDS: Final = frozenset({"single_bed", "hospital_bed", "cell_bed", "crib", "kids_bed"})
_DESKS: Final = frozenset({"workstation", "workbench", "drafting_table", "lab_bench", "control_desk", "sales_counter"})


def use_of(noun: str, family: str) -> Use:
    """Return what people need a place for in a family of buildings; empty where they only come and go.

    Examples
    --------
    >>> use_of("pupil", "education"), use_of("family", "home"), use_of("employee", "office"), use_of("member", "sport")
    ('sit', 'sleep', 'work', '')
    """
    if noun in _RESIDENTS or (family in ("home", "lodging") and noun in _DWELLERS):
        return "sleep"
    if family == "office" and noun in _WORKING:
        return "work"
    return "sit" if noun in _SEATED else ""


def places_of(category: str, width: float, use: Use) -> int:
    """Return for how many people an object is.

    Parameters
    ----------
    category : str
    width : float
        Metres.
    use : {"sleep", "sit", "work", ""}

    Examples
    --------
    >>> places_of("bed", 1.6, "sleep"), places_of("single_bed", 0.9, "sleep"), places_of("office_chair", 0.6, "sit")
    (2, 1, 1)
    """
    if use == "sleep":
        if category in _FOR_TWO or (category in ("bed", "double_bed") and width >= _DOUBLE):
            return 2
        return int(category in _BEDS or answers("bed", category))
    if use == "work":
        return int(category in _DESKS or answers("desk", category))
    if use == "sit" and (category in _SEATS or answers("chair", category) or answers("stool", category)):
        return seats_of_row(category, width)
    return 0
