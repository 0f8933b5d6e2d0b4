"""The statements of a model's answer as those that the rules make: each field checked for what it may hold."""

from collections.abc import Callable, Mapping
from typing import Any, Final, TypeAlias

import msgspec

from mansion_editing.instructions.by_model.answers import PlaceAnswer, RoomsAnswer, StatementAnswer, ThingsAnswer
from mansion_editing.instructions.statements import (
    Add,
    Ask,
    Clear,
    Ensure,
    Finish,
    Forbid,
    Furnish,
    History,
    Keep,
    Mention,
    Move,
    Paint,
    Reach,
    Remove,
    Rename,
    Replace,
    Reshape,
    SetState,
    Statement,
    Swap,
    Turn,
)
from mansion_msgs_py.codec import prepared

__all__ = ["ASIDE", "KINDS", "OTHER", "UnusableError", "statement_of"]

ASIDE: Final = "aside"
"""Kind of a statement that asks for nothing."""

OTHER: Final = "other"
"""Kind of a statement that none of the others can say."""


_Made: TypeAlias = tuple[type[Any], dict[str, Any]]
_Maker: TypeAlias = Callable[[StatementAnswer], _Made]
"""Gives the type of a statement and its fields."""


class UnusableError(ValueError):
    """Says why a statement of an answer cannot be used."""


def statement_of(answer: StatementAnswer, quote: str) -> Statement:
    """Return the statement of an answer.

    Parameters
    ----------
    quote : str
        Its words as they stand in the text.

    Raises
    ------
    UnusableError
        For an unknown kind, a field that is missing, or a value that a field cannot have.
    """
    make = _MAKERS.get(answer.kind)
    if make is None:
        raise UnusableError(f"kind is one of {', '.join(KINDS)}")
    kind, parts = make(answer)
    try:
        statement: Statement = msgspec.convert({**parts, "quote": quote}, prepared(kind))
    except msgspec.ValidationError as error:
        raise UnusableError(str(error)) from None
    return statement


def _things(answer: ThingsAnswer | None, *, open_noun: bool = False) -> dict[str, Any]:
    """Return the fields of `Things`.

    Parameters
    ----------
    open_noun : bool
        The noun may be left out, for whatever is at the place.
    """
    if answer is None or not (answer.noun.strip() or answer.refers or (open_noun and answer.place is not None)):
        raise UnusableError("things.noun is missing: say what it is about in the singular")
    none_given = 0 if answer.plural or answer.amount in ("all", "none") else 1
    number = none_given if answer.number is None else answer.number
    states = {name: value for name, value in (("open", answer.open), ("on", answer.on)) if value is not None}
    if answer.amount == "all" and number > 1 and answer.of != number:
        raise UnusableError("amount all with a number means so many of as many: give the same number for of")
    parts: dict[str, Any] = {
        "type": "Things",
        "noun": answer.noun.strip().lower() if "/" not in answer.noun else answer.noun.strip(),
        "amount": {"kind": answer.amount or "some", "number": number, "of": answer.of},
        "beside": [_things(one) for one in answer.excepted],
        "states": states,
    }
    if number < 0 or answer.of < 0:
        raise UnusableError("numbers of things are not negative")
    for name in ("definite", "plural", "colour", "material", "ordinal", "size", "refers", "owned"):
        parts[name] = getattr(answer, name)
    if answer.place is not None:
        parts["place"] = _place(answer.place)
    return parts


def _rooms(answer: RoomsAnswer | None) -> dict[str, Any]:
    if answer is None or not (answer.words.strip() or answer.floors or answer.same or answer.every or answer.holding):
        raise UnusableError("rooms.words is missing: say which room in the words of the text")
    parts: dict[str, Any] = {"type": "Rooms", "words": answer.words.strip(), "next_to": answer.next_to.strip()}
    for name in ("floors", "every", "number", "ordinal", "size", "same"):
        parts[name] = getattr(answer, name)
    if answer.holding is not None:
        parts["holding"] = _things(answer.holding)
    return parts


def _place(answer: PlaceAnswer | None) -> dict[str, Any]:
    if answer is None:
        return {}
    if answer.relation and answer.anchor is None:
        raise UnusableError("place.relation needs place.anchor, the thing that it is seen from")
    if answer.within < 0:
        raise UnusableError("place.within is a distance in metres")
    parts: dict[str, Any] = {
        "relation": answer.relation,
        "within": answer.within,
        "spot": answer.spot,
        "outside": answer.outside,
    }
    for name in ("anchor", "other", "facing"):
        value = getattr(answer, name)
        if value is not None:
            parts[name] = _things(value)
    if answer.rooms is not None:
        parts["rooms"] = _rooms(answer.rooms)
    return parts


def _optional(name: str, value: object, make: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
    return {} if value is None else {name: make(value)}


def _placed(kind: type[Any]) -> "_Maker":
    """Return what reads a statement about things and a place."""

    def make(answer: StatementAnswer) -> _Made:
        parts: dict[str, Any] = {"things": _things(answer.things), "place": _place(answer.place)}
        if kind in (Add, Ensure):
            parts["each"] = answer.each
        if kind is Move:
            if answer.place is None:
                raise UnusableError("place is missing: say where the things go")
            parts["or_new"] = answer.or_new
        return kind, parts

    return make


def _about(kind: type[Any]) -> "_Maker":
    """Return what reads a statement about things alone; a place of its own tells which ones."""

    def make(answer: StatementAnswer) -> _Made:
        things = answer.things
        if things is not None and things.place is None and answer.place is not None:
            things = msgspec.structs.replace(things, place=answer.place)
        return kind, {"things": _things(things, open_noun=kind is Keep)}

    return make


def _clear(answer: StatementAnswer) -> _Made:
    place = answer.place
    if place is None and answer.rooms is not None:
        place = PlaceAnswer(rooms=answer.rooms)
    if place is None and answer.things is not None:
        place = PlaceAnswer(relation="on", anchor=answer.things)
    if place is None:
        raise UnusableError("place is missing: say what is cleared")
    return Clear, {"place": _place(place), "spare": [_things(one) for one in answer.spare]}


def _pair(answer: StatementAnswer) -> _Made:
    if answer.rooms is not None and answer.other_rooms is not None:
        return Swap, {"one": _rooms(answer.rooms), "other": _rooms(answer.other_rooms)}
    return Swap, {"one": _things(answer.things), "other": _things(answer.other)}


def _replace(answer: StatementAnswer) -> _Made:
    return Replace, {**_about(Replace)(answer)[1], "by": _things(answer.other)}


def _set_state(answer: StatementAnswer) -> _Made:
    return SetState, {**_about(SetState)(answer)[1], "state": answer.state, "value": answer.value}


def _paint(answer: StatementAnswer) -> _Made:
    if not (answer.colour or answer.material):
        raise UnusableError("colour or material is missing")
    return Paint, {**_about(Paint)(answer)[1], "colour": answer.colour, "material": answer.material}


def _turn(answer: StatementAnswer) -> _Made:
    if answer.other is None and not answer.number:
        raise UnusableError("say by how many degrees (number) or to what (other) it turns")
    parts = {**_about(Turn)(answer)[1], "degrees": answer.number}
    return Turn, {**parts, **_optional("facing", answer.other, _things)}


def _reach(answer: StatementAnswer) -> _Made:
    parts: dict[str, Any] = {}
    for name, things, rooms in (("end", answer.things, answer.rooms), ("start", answer.other, answer.other_rooms)):
        parts |= _optional(name, rooms, _rooms) or _optional(name, things, _things)
    return Reach, parts


def _rename(answer: StatementAnswer) -> _Made:
    if not answer.name.strip():
        raise UnusableError("name is missing: what the room is to be called")
    return Rename, {"room": _rooms(answer.rooms), "name": answer.name.strip()}


def _finish(answer: StatementAnswer) -> _Made:
    if not (answer.colour or answer.material):
        raise UnusableError("colour or material is missing")
    look = {"part": answer.what, "colour": answer.colour, "material": answer.material}
    return Finish, {"rooms": _rooms(answer.rooms), **look}


def _furnish(answer: StatementAnswer) -> _Made:
    return Furnish, {"rooms": _rooms(answer.rooms), "kind": answer.name.strip()}


def _reshape(answer: StatementAnswer) -> _Made:
    parts = {"what": answer.what, "area": answer.number, "absolute": answer.absolute}
    parts |= _optional("rooms", answer.rooms, _rooms)
    return Reshape, {**parts, **_optional("other", answer.other_rooms, _rooms)}


def _ask(answer: StatementAnswer) -> _Made:
    parts: dict[str, Any] = {"about": answer.what, "state": answer.state, "value": answer.value}
    parts |= _optional("things", answer.things, lambda things: _things(things, open_noun=True))
    parts |= _optional("place", answer.place, _place)
    return Ask, {**parts, **_optional("rooms", answer.rooms, _rooms), **_optional("start", answer.other_rooms, _rooms)}


def _history(answer: StatementAnswer) -> _Made:
    parts: dict[str, Any] = {"what": answer.kind}
    return History, {**parts, **_optional("things", answer.things, _things), **_optional("place", answer.place, _place)}


_MAKERS: Final[Mapping[str, _Maker]] = {
    "add": _placed(Add),
    "ensure": _placed(Ensure),
    "remove": _about(Remove),
    "forbid": _placed(Forbid),
    "keep": _about(Keep),
    "clear": _clear,
    "move": _placed(Move),
    "swap": _pair,
    "replace": _replace,
    "set_state": _set_state,
    "paint": _paint,
    "turn": _turn,
    "reach": _reach,
    "rename": _rename,
    "finish": _finish,
    "furnish": _furnish,
    "reshape": _reshape,
    "ask": _ask,
    **dict.fromkeys(("undo", "redo", "restore", "repeat"), _history),
    ASIDE: lambda answer: (Mention, {}),
}
KINDS: Final = (*_MAKERS, OTHER)
"""What a statement of an answer can be."""
