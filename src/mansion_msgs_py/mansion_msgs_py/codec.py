"""JSON text to payloads and back.

Decoding gives a value or raises `MansionError` with the JSON path of the fault, and nothing else, whatever the input.
"""

from collections.abc import Hashable
from functools import cache
from typing import Any, TypeVar, cast

import msgspec

from mansion_msgs_py.errors import ErrorCode, ErrorInfo, ErrorReply, MansionError
from mansion_msgs_py.faults import explained

__all__ = ["convert", "decode", "decode_reply", "encode", "encode_bytes", "schema", "to_builtins"]

T = TypeVar("T")


@cache
def _decoder(kind: Any) -> msgspec.json.Decoder[Any]:
    return msgspec.json.Decoder(kind)


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
        value: T = _decoder(cast(Hashable, kind)).decode(data if data.strip() else b"{}")
    except msgspec.ValidationError as error:
        raise _unfit(kind, error) from None
    except (msgspec.DecodeError, UnicodeError) as error:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"not JSON: {error}", details={"payload": name}) from None
    except RecursionError:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "JSON nested too deeply", details={"payload": name}) from None
    return value


def convert(kind: type[T], value: Any) -> T:
    """Return dicts, lists and scalars as a value of type `kind`.

    Raises
    ------
    MansionError
        As `decode`.
    """
    try:
        return msgspec.convert(value, kind)
    except msgspec.ValidationError as error:
        raise _unfit(kind, error) from None


def _unfit(kind: Any, error: msgspec.ValidationError) -> MansionError:
    what, path = explained(kind, str(error))
    name = getattr(kind, "__name__", str(kind))
    return MansionError(ErrorCode.INVALID_PAYLOAD, what, path=path, details={"payload": name})


def decode_reply(success: bool, message: str, kind: type[T]) -> T:
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
