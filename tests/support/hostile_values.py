"""Values that a payload type takes, drawn at random, and what becomes of them when they are spoiled somewhere deep."""

import json
import math
import random
from collections.abc import Sequence
from typing import Any, Final

import msgspec

__all__ = ["drawn", "garbled", "spoiled"]

NUMBERS: Final = (
    0, -0.0, 1, -1, 2, 0.5, 1e-9, 1e-300, 5e-324, 255, 256, 10_000, 10_001, 1e9, 1e18, 2**31, 2**53 + 1, 2**63 - 1,
    2**63, 2**64, 1e300, -1e300, math.inf, -math.inf, math.nan,
)  # fmt: skip
TEXTS: Final = (
    "", " ", "\0", "..", "../..", "/", "/etc/passwd", "~", "~root/x", "a/../../b", "F1", "F1/", "F99/kitchen", "-1",
    "None", "nan", "{}", "[]", "%s%n", "$(id)", "`id`", "'; --", "\n", "\r\n\t", "\u202e", "\ufeff", "é" * 300,
    "𝔘" * 50, "x" * 5_000, "a b" * 2_000, "(" * 2_000, "1" * 400, "-" * 64, "default", "CON", ".", "kitchen",
    "1e400", "\x7f\x1b[2J",
)  # fmt: skip
ODD: Final = (None, True, False, [], {}, [[]], [None], {"": None}, {"error": {}})


def drawn(kind: Any, rng: random.Random, words: Sequence[str]) -> Any:
    """Return a JSON-compatible value of a type.

    Parameters
    ----------
    kind : type
        What `msgspec` decodes into.
    rng : random.Random
    words : sequence of str
        Texts that mean something where the value is used, such as ids.
    """
    return _drawn(msgspec.inspect.type_info(kind), rng, words, depth=0)


def _drawn(info: Any, rng: random.Random, words: Sequence[str], depth: int) -> Any:
    inspect = msgspec.inspect
    match info:
        case inspect.StructType():
            return {
                field.encode_name: _drawn(field.type, rng, words, depth + 1)
                for field in info.fields
                if field.required or rng.random() < 0.3
            }
        case inspect.Metadata():
            return _drawn(info.type, rng, words, depth)
        case inspect.UnionType():
            return _drawn(rng.choice(info.types), rng, words, depth)
        case inspect.LiteralType():
            return rng.choice(info.values)
        case inspect.EnumType():
            return rng.choice(list(info.cls)).value
        case inspect.StrType():
            return rng.choice(words)
        case inspect.BoolType():
            return rng.random() < 0.5
        case inspect.IntType():
            return rng.randint(_bound(info.ge, info.gt, -2), _bound(info.le, info.lt, 12))
        case inspect.FloatType():
            return round(rng.uniform(_bound(info.ge, info.gt, -2), _bound(info.le, info.lt, 12)), 2)
        case inspect.TupleType():
            return [_drawn(part, rng, words, depth + 1) for part in info.item_types]
        case inspect.ListType() | inspect.VarTupleType() | inspect.SetType() | inspect.FrozenSetType():
            count = rng.randint(info.min_length or 0, max(info.min_length or 0, 3 - depth))
            return [_drawn(info.item_type, rng, words, depth + 1) for _ in range(count)]
        case inspect.DictType():
            return {rng.choice(words): _drawn(info.value_type, rng, words, depth + 1) for _ in range(rng.randint(0, 2))}
        case inspect.NoneType():
            return None
        case _:
            return rng.choice([*ODD, *words[:3]])


def _bound(*limits: float | None) -> int:
    """Return the first limit that there is, as a whole number that random numbers can be drawn up to."""
    return int(max(-1000.0, min(1000.0, next(limit for limit in limits if limit is not None))))


def spoiled(value: Any, rng: random.Random, times: int) -> Any:
    """Return a copy of a JSON-compatible value with some of its parts replaced, moved, doubled or taken away."""
    whole = [json.loads(json.dumps(value))]
    for _ in range(times):
        places = [(whole, 0), *_places(whole[0])]
        holder, key = rng.choice(places)
        _spoil(holder, key, rng, places)
    return whole[0]


def _places(value: Any) -> list[tuple[Any, Any]]:
    """Return where the parts of a value are: what holds each, and under which key or index."""
    found: list[tuple[Any, Any]] = []
    holders = [value]
    while holders:
        holder = holders.pop()
        keys = list(holder) if isinstance(holder, dict) else range(len(holder)) if isinstance(holder, list) else ()
        for key in keys:
            found.append((holder, key))
            holders.append(holder[key])
    return found


def _spoil(holder: Any, key: Any, rng: random.Random, places: Sequence[tuple[Any, Any]]) -> None:
    part = holder[key]
    number = isinstance(part, int | float) and not isinstance(part, bool)
    action = rng.randrange(10)
    if action < 3 and number:
        holder[key] = rng.choice(
            [part * -1, part + 1, part - 1, part * 1.001, part * 100, part / 7, part + rng.gauss(0, 3)]
        )
    elif action == 3 and number:
        holder[key] = rng.choice(NUMBERS)
    elif action < 5 and isinstance(part, str):
        holder[key] = rng.choice([*TEXTS, part[::-1], part * 2, part[1:], part.upper(), part + " " + part])
    elif action == 5 and isinstance(holder, dict):
        del holder[key]
    elif action == 6 and isinstance(part, list) and part:
        holder[key] = rng.choice(
            [part[:1], part[1:], part[::-1], part * rng.choice([2, 3, 50]), rng.sample(part, len(part))]
        )
    elif action == 7 and isinstance(holder, dict):
        holder[rng.choice(TEXTS)] = part
    elif action == 8:
        other, place = rng.choice(places)
        if place in other if isinstance(other, dict) else place < len(other):
            holder[key] = json.loads(json.dumps(other[place]))
    else:
        holder[key] = rng.choice([rng.choice(NUMBERS), rng.choice(TEXTS), json.loads(json.dumps(rng.choice(ODD)))])


def garbled(text: str, rng: random.Random) -> bytes:
    """Return a text with its bytes spoiled: cut off, doubled, mixed with others, or nested without end."""
    data = text.encode("utf-8", "replace")
    at = rng.randrange(len(data) + 1)
    return rng.choice([
        data[:at],
        data[:at] + bytes(rng.randrange(256) for _ in range(rng.randint(1, 8))) + data[at:],
        data + data,
        b"[" * rng.choice([10, 1_000, 100_000]),
        b'{"a":' * rng.choice([10, 1_000, 100_000]) + data,
        data.replace(b":", b"", 1),
        b"\xef\xbb\xbf" + data,
        data[:at] + b"\xff\xfe" + data[at:],
        data.replace(b"1", b"1" * 400),
        b"",
    ])  # fmt: skip
