"""From what msgspec says of a payload's fault to a message that names what would be accepted."""

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

from msgspec import inspect

from mansion_msgs_py.wording import choices

__all__ = ["explained"]

_PATH = re.compile(r"^(?P<what>.*) - at `(?P<path>\$.*)`$", re.DOTALL)
_STEP = re.compile(r"\.(?P<field>[^.\[\]]+)|\[(?P<index>[^\]]*)\]")
_UNKNOWN = re.compile(r"^Object contains unknown field `(?P<name>.*)`$", re.DOTALL)
_MISSING = re.compile(r"^Object missing required field `(?P<name>.*)`$", re.DOTALL)
_ENUM = re.compile(r"^Invalid enum value (?P<value>.*)$", re.DOTALL)


def explained(kind: Any, message: str) -> tuple[str, str]:
    """Return what is wrong with a payload and the JSON path of the place.

    Parameters
    ----------
    kind : type
        What the payload was to be.
    message : str
        Of msgspec's `ValidationError`.

    Examples
    --------
    >>> from mansion_msgs_py.skills import ControlArgs
    >>> explained(ControlArgs, "Object contains unknown field `clients`")
    ("unknown field 'clients'; did you mean client? fields: session, token, client, force", '$.clients')
    """
    match = _PATH.match(message)
    what, path = (message, "$") if match is None else (match["what"], match["path"])
    places = list(_places(kind, path))
    if found := _UNKNOWN.match(what):
        name = found["name"][:80]
        return f"unknown field {name!r}; {_fields(places, name)}", f"{path}.{name}"
    if found := _MISSING.match(what):
        name = found["name"]
        if tags := [str(p.tag) for p in _structs(places) if p.tag_field == name]:
            return f"the field {name!r} is missing; {choices('', tags, 'values')}", path
        return f"the required field {name!r} is missing; {_fields(places, '')}", path
    if found := _ENUM.match(what):
        value = found["value"].strip("'")
        return f"{value!r} is not accepted; {choices(value, _values(places), 'values')}", path
    return what, path


@cache
def _type_info(kind: Any) -> inspect.Type:
    return inspect.type_info(kind)


def _places(kind: Any, path: str) -> Iterator[inspect.Type]:
    """Yield the types that a JSON path may lead to, without unions."""
    try:
        found = list(_members(_type_info(kind)))
    except TypeError:
        return
    for step in _STEP.finditer(path):
        found = [member for place in found for inner in _inner(place, step) for member in _members(inner)]
    yield from found


def _members(place: inspect.Type) -> Iterator[inspect.Type]:
    if isinstance(place, inspect.UnionType):
        for inner in place.types:
            yield from _members(inner)
    else:
        yield place


def _inner(place: inspect.Type, step: re.Match[str]) -> Iterator[inspect.Type]:
    if step["field"] is not None:
        if isinstance(place, inspect.StructType | inspect.DataclassType):
            yield from (field.type for field in place.fields if field.encode_name == step["field"])
        return
    if isinstance(place, inspect.DictType):
        yield place.value_type
    elif isinstance(place, inspect.TupleType) and step["index"].isdecimal():
        yield from place.item_types[int(step["index"]) : int(step["index"]) + 1]
    elif isinstance(place, inspect.CollectionType):
        yield place.item_type


def _fields(places: list[inspect.Type], wanted: str) -> str:
    """Say which fields the structs of a place have, the required ones first."""
    fields = [field for struct in _structs(places) for field in struct.fields]
    names = {field.encode_name: field.required for field in fields}
    order = sorted(names, key=lambda name: not names[name])
    said = choices(wanted, order, "fields")
    head, mark, tail = said.partition("fields: ")
    marked = (f"{n} (required)" if names[n] else n for n in tail.split(", "))
    return f"{head}{mark}{', '.join(marked)}" if mark else said


def _structs(places: list[inspect.Type]) -> list[inspect.StructType]:
    return [place for place in places if isinstance(place, inspect.StructType)]


def _values(places: list[inspect.Type]) -> list[str]:
    found: list[str] = []
    for place in places:
        if isinstance(place, inspect.LiteralType):
            found += map(str, place.values)
        elif isinstance(place, inspect.EnumType):
            found += [str(member.value) for member in place.cls]
    return found
