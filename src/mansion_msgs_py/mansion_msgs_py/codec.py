"""JSON text to payloads and back.

Decoding gives a value or raises `MansionError` with the JSON path of the fault, and nothing else, whatever the input.
"""

import os
import re
import threading
from collections.abc import Hashable, Iterator
from functools import cache
from typing import Any, TypeVar, cast

import msgspec
from msgspec import inspect

from mansion_msgs_py.errors import ErrorCode, ErrorInfo, ErrorReply, MansionError
from mansion_msgs_py.limits import MAX_PAYLOAD
from mansion_msgs_py.wording import choices

__all__ = [
    "convert",
    "decode",
    "decode_reply",
    "encode",
    "encode_bytes",
    "explained",
    "prepared",
    "schema",
    "to_builtins",
]

T = TypeVar("T")


# msgspec looks at the fields of a struct when it is first asked to decode one, and a second thread that uses the struct
# meanwhile finds fields without types, which ends the process. So only one thread at a time lets it look.
_looking_at_types = threading.RLock()
os.register_at_fork(
    before=_looking_at_types.acquire,
    after_in_parent=_looking_at_types.release,
    after_in_child=_looking_at_types.release,
)


@cache
def _decoder(kind: Any) -> msgspec.json.Decoder[Any]:
    with _looking_at_types:
        return msgspec.json.Decoder(kind)


def prepared(kind: type[T]) -> type[T]:
    """Return `kind` once msgspec knows its fields, so that every thread may decode it.

    For what is decoded by msgspec itself, such as MessagePack or rows that are not strict; `decode` and `convert` do
    it themselves.
    """
    _decoder(cast(Hashable, kind))
    return kind


def _plain_number(value: Any) -> float:
    """Return a float of another library as a float: shapely before 2.1 gives a point's x and y as numpy's."""
    if isinstance(value, float):
        return float(value)
    raise TypeError(f"no JSON for {type(value).__qualname__}")


_encoder = msgspec.json.Encoder(enc_hook=_plain_number)


def encode_bytes(value: Any, *, indent: int | None = None) -> bytes:
    """Encode a payload as UTF-8 JSON; the same value always gives the same bytes.

    Parameters
    ----------
    value : msgspec.Struct or JSON-compatible object
    indent : int, optional
        Spaces per level; one line when absent.
    """
    data = _encoder.encode(value)
    return data if indent is None else msgspec.json.format(data, indent=indent)


def encode(value: Any, *, indent: int | None = None) -> str:
    """Encode a payload as JSON text (see `encode_bytes`)."""
    return encode_bytes(value, indent=indent).decode()


def to_builtins(value: Any) -> Any:
    """Return `value` as dicts, lists and scalars."""
    return msgspec.to_builtins(value, enc_hook=_plain_number)


def decode(kind: type[T], text: str | bytes) -> T:
    """Decode JSON into a value of type `kind`.

    Parameters
    ----------
    kind : type
        A payload type, or any type that msgspec can decode.
    text : str or bytes
        JSON. An empty text counts as ``{}``, so that a service call may leave its arguments out.

    Raises
    ------
    MansionError
        With code ``INVALID_PAYLOAD`` and the JSON path of the fault.

    Examples
    --------
    >>> from mansion_msgs_py.request import BuildRequest
    >>> decode(BuildRequest, '{"description": "a small flat", "floors": "two"}')
    Traceback (most recent call last):
        ...
    mansion_msgs_py.errors.MansionError: INVALID_PAYLOAD at $.floors: Expected `int | null`, got `str`
    """
    name = getattr(kind, "__name__", str(kind))
    try:
        data = text.encode() if isinstance(text, str) else text
        _check_size(data, name)
        value: T = _decoder(cast(Hashable, kind)).decode(data if data.strip() else b"{}")
    except msgspec.ValidationError as error:
        raise _unfit(kind, error) from None
    except (msgspec.DecodeError, UnicodeError) as error:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"not JSON: {error}", details={"payload": name}) from None
    except RecursionError:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "JSON nested too deeply", details={"payload": name}) from None
    return value


def _check_size(data: bytes, name: str) -> None:
    if len(data) > MAX_PAYLOAD:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"the JSON has {len(data)} bytes; at most {MAX_PAYLOAD} are accepted",
            details={"payload": name},
        )


def convert(kind: type[T], value: Any) -> T:
    """Return dicts, lists and scalars as a value of type `kind`.

    Raises
    ------
    MansionError
        As `decode`.
    """
    try:
        return msgspec.convert(value, prepared(kind))
    except msgspec.ValidationError as error:
        raise _unfit(kind, error) from None


def _unfit(kind: Any, error: msgspec.ValidationError) -> MansionError:
    what, path = explained(kind, str(error))
    name = getattr(kind, "__name__", str(kind))
    return MansionError(ErrorCode.INVALID_PAYLOAD, what, path=path, details={"payload": name})


def decode_reply(kind: type[T], message: str, *, success: bool) -> T:
    """Decode the two fields of a service reply.

    Raises
    ------
    MansionError
        The error that the server sent, or ``INVALID_PAYLOAD`` when it sent something else.
    """
    if success:
        return decode(kind, message)
    try:
        info = decode(ErrorReply, message).error
    except MansionError:
        info = ErrorInfo(code=ErrorCode.INTERNAL, message=message or "the server gave no reason")
    raise MansionError.from_info(info)


def schema(kind: Any) -> dict[str, Any]:
    """Return the JSON Schema (draft 2020-12) of a payload type."""
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **msgspec.json.schema(kind)}


_PATH = re.compile(r"^(?P<what>.*) - at `(?P<path>\$.*)`$", re.DOTALL)
_STEP = re.compile(r"\.(?P<field>[^.\[\]]+)|\[(?P<index>[^\]]*)\]")
_UNKNOWN = re.compile(r"^Object contains unknown field `(?P<name>.*)`$", re.DOTALL)
_MISSING = re.compile(r"^Object missing required field `(?P<name>.*)`$", re.DOTALL)
_PATTERN = "Expected `str` matching regex"
_ENUM = re.compile(r"^Invalid enum value (?P<value>.*)$", re.DOTALL)


def explained(kind: Any, message: str) -> tuple[str, str]:
    """Return what is wrong with a payload and the JSON path of the place.

    Parameters
    ----------
    kind : type
        What the payload was to be.
    message : str
        Text of msgspec's `ValidationError`.

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
    if what.startswith(_PATTERN) and (said := _descriptions(places)):
        return f"expected {' or '.join(said)}", path
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


def _descriptions(places: list[inspect.Type]) -> list[str]:
    said = [place.extra_json_schema or {} for place in places if isinstance(place, inspect.Metadata)]
    return [entry["description"] for entry in said if "description" in entry]


def _values(places: list[inspect.Type]) -> list[str]:
    found: list[str] = []
    for place in places:
        if isinstance(place, inspect.LiteralType):
            found += map(str, place.values)
        elif isinstance(place, inspect.EnumType):
            found += [str(member.value) for member in place.cls]
    return found
