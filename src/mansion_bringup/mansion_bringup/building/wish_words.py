"""Wishes in words: what each was read as, where it holds, and how many there are of each status."""

from collections.abc import Callable, Mapping, Sequence
from typing import Final

from mansion_language.inflection import is_plural, plural
from mansion_msgs_py.wishes import Scope, Wish, WishKind, WishStatus
from mansion_msgs_py.wording import counted, in_words

__all__ = ["STATUS_WORDS", "read_as", "receipt_summary"]

STATUS_WORDS: Final[Mapping[WishStatus, str]] = {
    "met": "met", "partly": "partly", "not_met": "not met", "not_understood": "not understood", "": "open",
}  # fmt: skip
"""What became of a wish, as the receipt says it."""


def read_as(wish: Wish) -> str:
    """Return what a wish was read as, with its scope.

    Examples
    --------
    >>> from mansion_msgs_py.wishes import WishValue
    >>> value = WishValue(name="bedroom", type="bedroom", count=3, area=14.0)
    >>> scope = Scope(floors=[2])
    >>> read_as(Wish(id="wish_1", text="3 bedrooms of 14 m2", span=(0, 19), kind="room", value=value, scope=scope))
    '3 bedrooms of 14 m2, floor 2'
    """
    said = _WORDS[wish.kind](wish)
    where = _where(wish.scope) if said else ""
    return f"{said}, {where}" if where else said


def receipt_summary(wishes: Sequence[Wish]) -> str:
    """Return one line: how many wishes there are of each status.

    Examples
    --------
    >>> receipt_summary([])
    'nothing was asked for'
    """
    counts = {status: sum(wish.status == status for wish in wishes) for status in STATUS_WORDS}
    parts = [f"{count} {STATUS_WORDS[status]}" for status, count in counts.items() if count]
    return f"{counted(len(wishes), 'wish', 'wishes')}: {', '.join(parts)}" if wishes else "nothing was asked for"


def _where(scope: Scope) -> str:
    parts = []
    if scope.room and scope.some:
        parts.append(f"in {scope.some} {in_words(scope.room)}")
    elif scope.room:
        parts.append(f"in {'each ' if scope.each else ''}{in_words(scope.room)}")
    if scope.unit:
        parts.append(f"in each {in_words(scope.unit)}")
    if scope.floors:
        parts.append(
            ("each of " if scope.each and not scope.room and len(scope.floors) > 1 else "") + _floors(scope.floors)
        )
    elif scope.each and not (scope.room or scope.unit):
        parts.append("each floor")
    return ", ".join(parts)


def _floors(numbers: list[int]) -> str:
    """Return ``floor 2``, ``floors 2 to 5`` or ``floors 1 and 3``; the ground floor is 1, cellars are below 1."""
    if len(numbers) == 1:
        number = numbers[0]
        return f"basement {1 - number}" if number < 1 else "ground floor" if number == 1 else f"floor {number}"
    run = list(range(numbers[0], numbers[-1] + 1))
    if list(numbers) == run and len(run) > 2:
        return f"floors {run[0]} to {run[-1]}"
    return f"floors {', '.join(map(str, numbers[:-1]))} and {numbers[-1]}"


def _number_of(wish: Wish, name: str) -> str:
    """Return a count with its noun in the right number; several when the brief gives none."""
    noun = in_words(name)
    if wish.value.count is None:
        return noun if is_plural(noun) else plural(noun)
    return counted(wish.value.count, noun, noun if is_plural(noun) else plural(noun))


def _size(wish: Wish) -> str:
    value = wish.value
    area = f" of {_LIMITS[value.limit]}{value.area:.4g} m2" if value.area is not None else ""
    return area + (" in all" if area and value.whole else "")


def _room(wish: Wish) -> str:
    return _number_of(wish, wish.value.name) + _size(wish)


def _object(wish: Wish) -> str:
    return _number_of(wish, wish.value.name) + (", no others" if wish.value.exact else "")


def _building(wish: Wish) -> str:
    return f"building: {in_words(wish.value.name)}{_size(wish)}"


def _absent(wish: Wish) -> str:
    return f"no {in_words(wish.value.name)}"


def _related(relation: str) -> Callable[[Wish], str]:
    return lambda wish: f"{in_words(wish.value.name)} {relation} {in_words(wish.value.other)}"


def _named(noun: str) -> Callable[[Wish], str]:
    return lambda wish: f"{noun}: {in_words(wish.value.name)}" if wish.value.name else noun


def _amount(noun: str) -> Callable[[Wish], str]:
    def said(wish: Wish) -> str:
        if wish.value.unwanted:
            return f"no {noun}"
        return counted(wish.value.count, noun) if wish.value.count is not None else noun

    return said


def _area(suffix: str) -> Callable[[Wish], str]:
    def said(wish: Wish) -> str:
        value = wish.value
        return f"{_LIMITS[value.limit]}{value.area:.4g} m2 {suffix}" if value.area is not None else ""

    return said


_LIMITS = {"": "", "most": "at most ", "least": "at least "}


def _height(wish: Wish) -> str:
    return f"ceiling height {wish.value.height:.3g} m" if wish.value.height is not None else ""


def _roof(wish: Wish) -> str:
    return "roof: " + ", ".join(in_words(part) for part in (wish.value.name, wish.value.type) if part)


def _on_plot(wish: Wish) -> str:
    places = f", {counted(wish.value.count, 'place')}" if wish.value.count is not None else ""
    return f"on the plot: {wish.value.name}{places}"


def _clutter(wish: Wish) -> str:
    return "many small things" if wish.value.name == "dense" else "few small things"


def _occupants(wish: Wish) -> str:
    if wish.value.name == "family" and (wish.value.count or 0) > 1 and "families" not in wish.text.lower():
        return f"for a family of {wish.value.count}"
    return f"for {_number_of(wish, wish.value.name)}"


_WORDS: Final[Mapping[WishKind, Callable[[Wish], str]]] = {
    "building_type": _building,
    "floors": _amount("storey"),
    "basements": _amount("basement"),
    "total_area": _area("in all"),
    "floor_area": _area("a floor"),
    "outline": _named("outline"),
    "style": _named("style"),
    "use": _named("use"),
    "copy": lambda _: "alike",
    "stair": _amount("stair"),
    "elevator": _amount("lift"),
    "room": _room,
    "no_room": _absent,
    "adjacent": _related("next to"),
    "apart": _related("away from"),
    "object": _object,
    "no_object": _absent,
    "height": _height,
    "material": _named("material"),
    "facade": _named("outer walls"),
    "roof": _roof,
    "grounds": _on_plot,
    "clutter": _clutter,
    "occupants": _occupants,
    "only": lambda _: "nothing else",
    "unread": lambda _: "",
}
"""For each kind of wish, its value in words."""
