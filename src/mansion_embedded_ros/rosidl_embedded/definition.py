"""Parse the ``.msg`` and ``.srv`` text of the interface tables into frozen dataclasses."""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

__all__ = [
    "PRIMITIVES",
    "Constant",
    "Field",
    "FieldType",
    "InterfaceNotFoundError",
    "MessageDefinition",
    "ServiceDefinition",
    "load_package",
    "message_definition",
    "service_definition",
]

INTERFACES = Path(__file__).parent / "interfaces"

PRIMITIVES: dict[str, tuple[str, int, str]] = {
    # .msg name: (struct character, size in bytes, IDL name)
    "bool": ("?", 1, "boolean"),
    "byte": ("c", 1, "octet"),
    "int8": ("b", 1, "int8"),
    "uint8": ("B", 1, "uint8"),
    "int16": ("h", 2, "int16"),
    "uint16": ("H", 2, "uint16"),
    "int32": ("i", 4, "int32"),
    "uint32": ("I", 4, "uint32"),
    "int64": ("q", 8, "int64"),
    "uint64": ("Q", 8, "uint64"),
    "float32": ("f", 4, "float"),
    "float64": ("d", 8, "double"),
}


class InterfaceNotFoundError(LookupError):
    """The package of messages has no such type here."""


@dataclass(frozen=True, slots=True)
class FieldType:
    """The type of one field.

    ``base`` is a primitive of :data:`PRIMITIVES`, ``string``, or a message's full name. ``size`` is
    the length of an array or the bound of a sequence (0: unbounded).
    """

    base: str
    kind: Literal["single", "array", "sequence"] = "single"
    size: int = 0
    string_bound: int = 0

    @property
    def is_primitive(self) -> bool:
        return self.base in PRIMITIVES

    @property
    def is_message(self) -> bool:
        return "/" in self.base

    @property
    def is_numeric(self) -> bool:
        """Whether a sequence of it is an ``array.array`` and an array of it a ``numpy.ndarray``."""
        return self.is_primitive and self.base not in ("bool", "byte")

    @property
    def element(self) -> FieldType:
        return FieldType(self.base, string_bound=self.string_bound)

    def idl_name(self) -> str:
        """The name that ``get_fields_and_field_types`` gives, ``sequence<rcl_interfaces/Log, 3>``."""
        if self.is_message:
            package, _, name = self.base.split("/")
            text = f"{package}/{name}"
        elif self.base == "string":
            text = f"string<{self.string_bound}>" if self.string_bound else "string"
        else:
            text = PRIMITIVES[self.base][2]
        if self.kind == "array":
            return f"{text}[{self.size}]"
        if self.kind == "sequence":
            return f"sequence<{text}, {self.size}>" if self.size else f"sequence<{text}>"
        return text


@dataclass(frozen=True, slots=True)
class Field:
    name: str
    type: FieldType
    default: object = None


@dataclass(frozen=True, slots=True)
class Constant:
    name: str
    type: str
    value: object


@dataclass(frozen=True, slots=True)
class MessageDefinition:
    """One message, or the request or response of a service."""

    name: str
    fields: tuple[Field, ...]
    constants: tuple[Constant, ...]
    text: str

    @property
    def package(self) -> str:
        return self.name.split("/")[0]

    @property
    def dds_type(self) -> str:
        package, kind, name = self.name.split("/")
        return f"{package}::{kind}::dds_::{name}_"


@dataclass(frozen=True, slots=True)
class ServiceDefinition:
    name: str
    request: MessageDefinition
    response: MessageDefinition
    event: MessageDefinition
    text: str


_FIELD = re.compile(
    r"(?P<base>[\w/]+)(?:<=(?P<bound>\d+))?(?P<array>\[(?P<upto><=)?(?P<size>\d*)\])?"
    r"\s+(?P<name>\w+)\s*(?:=\s*(?P<constant>.+)|(?P<default>.+))?$"
)


def _literal(text: str, base: str) -> object:
    text = text.strip()
    if base == "bool":
        return text.lower() in ("true", "1")
    value = ast.literal_eval(text)
    if base.startswith("float"):
        return float(value)
    if base == "byte":
        return bytes([value])
    return value


def _parse_message(name: str, lines: list[str]) -> MessageDefinition:
    fields: list[Field] = []
    constants: list[Constant] = []
    for line in lines:
        match = _FIELD.match(line)
        if match is None:
            raise ValueError(f"{name}: cannot read the line {line!r}")
        base = match["base"]
        if match["constant"] is not None:
            constants.append(Constant(match["name"], base, _literal(match["constant"], base)))
            continue
        if "/" in base:
            package, short = base.split("/")
            base = f"{package}/msg/{short}"
        bound = int(match["bound"] or 0)
        if match["array"] is None:
            kind: Literal["single", "array", "sequence"] = "single"
        elif match["upto"] or not match["size"]:
            kind = "sequence"
        else:
            kind = "array"
        default = _literal(match["default"], base) if match["default"] else None
        fields.append(
            Field(match["name"], FieldType(base, kind, int(match["size"] or 0), bound), default)
        )
    return MessageDefinition(name, tuple(fields), tuple(constants), "\n".join(lines))


def _parse_service(name: str, lines: list[str]) -> ServiceDefinition:
    cut = lines.index("---")
    request = _parse_message(f"{name}_Request", lines[:cut])
    response = _parse_message(f"{name}_Response", lines[cut + 1 :])
    event = MessageDefinition(
        f"{name}_Event",
        (
            Field("info", FieldType("service_msgs/msg/ServiceEventInfo")),
            Field("request", FieldType(request.name, "sequence", 1)),
            Field("response", FieldType(response.name, "sequence", 1)),
        ),
        (),
        "",
    )
    return ServiceDefinition(name, request, response, event, "\n".join(lines))


@cache
def load_package(package: str) -> dict[str, MessageDefinition | ServiceDefinition]:
    """Every interface of a package, by full name (``std_msgs/msg/String``)."""
    path = INTERFACES / f"{package}.txt"
    if not path.exists():
        raise InterfaceNotFoundError(
            f"the embedded ROS has no message package {package!r}; it has "
            + ", ".join(sorted(p.stem for p in INTERFACES.glob("*.txt")))
        )
    found: dict[str, MessageDefinition | ServiceDefinition] = {}
    for section in path.read_text(encoding="utf-8").split("=== ")[1:]:
        name, *lines = section.splitlines()
        found[name] = _parse_service(name, lines) if "---" in lines else _parse_message(name, lines)
    return found


def message_definition(name: str) -> MessageDefinition:
    """The definition of a message, or of the request, response or event of a service."""
    package, kind, short = name.split("/")
    if kind == "srv":
        service, _, part = short.rpartition("_")
        definition = service_definition(f"{package}/srv/{service}")
        found: MessageDefinition = getattr(definition, part.lower())
        return found
    message = load_package(package).get(name)
    if not isinstance(message, MessageDefinition):
        raise InterfaceNotFoundError(f"the embedded ROS has no message type {name!r}")
    return message


def service_definition(name: str) -> ServiceDefinition:
    """The definition of a service by its full name (``std_srvs/srv/Trigger``)."""
    service = load_package(name.split("/")[0]).get(name)
    if not isinstance(service, ServiceDefinition):
        raise InterfaceNotFoundError(f"the embedded ROS has no service type {name!r}")
    return service
