"""The ``response_format`` of a request, from the type that the answer must have."""

from typing import Any, Literal

import msgspec

__all__ = ["answer_schema", "response_format", "weaker_mode"]

Mode = Literal["schema", "object", "text"]
_ORDER: tuple[Mode, ...] = ("schema", "object", "text")
_DROPPED = {"title", "default", "examples"}


def answer_schema(kind: Any) -> dict[str, Any]:
    """Return the JSON Schema of an answer in the strict subset: an object at the root, all fields required, none added.

    Pairs are arrays of two, for few endpoints know ``prefixItems``.

    Examples
    --------
    >>> class Pair(msgspec.Struct, frozen=True):
    ...     left: int = 0
    >>> answer_schema(Pair)["required"]
    ['left']
    """
    tidy: dict[str, Any] = _strict(msgspec.json.schema(kind))
    name = tidy.pop("$ref", "").rsplit("/", 1)[-1]
    if name in tidy.get("$defs", {}):
        tidy |= tidy["$defs"].pop(name)
        if not tidy["$defs"]:
            del tidy["$defs"]
    return tidy


def _strict(value: Any) -> Any:
    if isinstance(value, list):
        return [_strict(entry) for entry in value]
    if not isinstance(value, dict):
        return value
    out = {key: _strict(entry) for key, entry in value.items() if key not in _DROPPED}
    if isinstance(value.get("properties"), dict):
        out["properties"] = {k: _strict(v) for k, v in value["properties"].items()}
        out["required"] = list(out["properties"])
        out["additionalProperties"] = False
    if out.get("prefixItems"):
        out["items"] = out.pop("prefixItems")[0]
    return out


def response_format(mode: Mode, name: str, schema: dict[str, Any]) -> dict[str, Any] | None:
    """Return the request's ``response_format``; ``None`` for plain text."""
    if mode == "schema":
        return {"type": "json_schema", "json_schema": {"name": name, "schema": schema, "strict": True}}
    return {"type": "json_object"} if mode == "object" else None


def weaker_mode(mode: Mode) -> Mode | None:
    """Return the next weaker mode, for an endpoint that refuses `mode`."""
    at = _ORDER.index(mode) + 1
    return _ORDER[at] if at < len(_ORDER) else None
