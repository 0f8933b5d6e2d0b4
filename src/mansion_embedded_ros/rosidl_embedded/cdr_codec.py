"""Compile a message definition into an encoder and a decoder of little-endian XCDR1.

Both are generated as Python source: runs of fixed-size fields, across nested messages, become one
``struct`` call, and numeric sequences are copied as blocks of memory.
"""

from __future__ import annotations

import sys
from array import array
from collections.abc import Callable
from dataclasses import dataclass
from struct import Struct, error
from typing import Any

from rosidl_embedded.definition import PRIMITIVES, FieldType, MessageDefinition, message_definition

__all__ = ["HEADER", "Codec", "compile_codec"]

HEADER = b"\x00\x01\x00\x00"
"""Encapsulation header: plain CDR, little endian, no options."""

if sys.byteorder != "little":  # pragma: no cover
    raise ImportError(
        "the embedded ROS writes little-endian CDR from memory; this host is big-endian"
    )


@dataclass(frozen=True, slots=True)
class Codec:
    """``encode(message, buffer)`` appends to a bytearray that starts with the 4-byte header;
    ``decode(view, offset)`` gives the message and the offset behind it."""

    encode: Callable[[Any, bytearray], None]
    decode: Callable[[memoryview, int], tuple[Any, int]]


class _Source:
    """Lines of a generated function, with what is known about the alignment of its position.

    The position modulo ``mod`` is ``rest``; ``run`` holds fixed-size fields not yet written out.
    """

    def __init__(self, namespace: dict[str, Any]) -> None:
        self.lines: list[str] = []
        self.indent = 1
        self.namespace = namespace
        self.run: list[tuple[str, str]] = []
        self.mod, self.rest = 1, 0
        self.names = 0

    def emit(self, line: str) -> None:
        self.lines.append("    " * self.indent + line)

    def fresh(self, stem: str) -> str:
        self.names += 1
        return f"{stem}{self.names}"

    def constant(self, stem: str, value: Any) -> str:
        name = self.fresh(stem)
        self.namespace[name] = value
        return name

    def advance(self, size: int) -> None:
        self.rest = (self.rest + size) % self.mod

    def forget(self) -> None:
        self.mod, self.rest = 1, 0

    def align(self, size: int) -> None:
        """Bring the position to a multiple of ``size``, as padding of the run where possible."""
        if size <= 1:
            return
        if self.mod >= size:
            pad = -self.rest % size
            if pad:
                self.run.append((f"{pad}x", ""))
                self.advance(pad)
            return
        self.flush()
        self.align_dynamic(size)
        self.mod, self.rest = size, 0

    def fixed(self, char: str, size: int, name: str) -> None:
        self.align(size)
        self.run.append((char, name))
        self.advance(size)

    def align_dynamic(self, size: int) -> None:
        raise NotImplementedError

    def flush(self) -> None:
        raise NotImplementedError


class _Encoder(_Source):
    def align_dynamic(self, size: int) -> None:
        self.emit(f"p = (4 - len(b)) & {size - 1}")
        self.emit("if p: b += ZERO[p]")

    def flush(self) -> None:
        if not self.run:
            return
        layout = Struct("<" + "".join(char for char, _ in self.run))
        values = ", ".join(value for _, value in self.run if value)
        self.emit(f"b += {self.constant('pack', layout.pack)}({values})")
        self.run.clear()

    def message(self, definition: MessageDefinition, value: str) -> None:
        if not definition.fields:
            self.fixed("B", 1, "0")
        for field in definition.fields:
            self.field(field.type, f"{value}._{field.name}")

    def field(self, kind: FieldType, value: str) -> None:
        if kind.kind == "single":
            self.single(kind, value)
        elif kind.is_numeric:
            self.numbers(kind, value)
        else:
            self.items(kind, value)

    def single(self, kind: FieldType, value: str) -> None:
        if kind.is_message:
            self.message(message_definition(kind.base), value)
        elif kind.base == "string":
            text = self.fresh("s")
            self.emit(f"{text} = {value}.encode()")
            self.fixed("I", 4, f"len({text}) + 1")
            self.flush()
            self.emit(f"b += {text}; b += NUL")
            self.forget()
        else:
            char, size, _ = PRIMITIVES[kind.base]
            self.fixed(char, size, value)

    def numbers(self, kind: FieldType, value: str) -> None:
        _, size, _ = PRIMITIVES[kind.base]
        if kind.kind == "array":
            self.align(size)
            self.flush()
            self.emit(f"b += {value}.tobytes()")
            self.advance(kind.size * size)
            return
        items = self.fresh("a")
        self.emit(f"{items} = {value}")
        self.fixed("I", 4, f"len({items})")
        self.flush()
        self.emit(f"if {items}:")
        self.indent += 1
        if size > 4:
            self.align_dynamic(size)
        self.emit(f"b += {items}")
        self.indent -= 1
        self.forget()

    def items(self, kind: FieldType, value: str) -> None:
        items = self.fresh("a")
        self.emit(f"{items} = {value}")
        if kind.kind == "sequence":
            self.fixed("I", 4, f"len({items})")
        self.flush()
        if kind.is_primitive:
            body = f"bytes({items})" if kind.base == "bool" else f"b''.join({items})"
            self.emit(f"b += {body}")
            self.forget()
            return
        item = self.fresh("e")
        self.emit(f"for {item} in {items}:")
        self.indent += 1
        self.forget()
        self.single(kind.element, item)
        self.flush()
        self.indent -= 1
        self.forget()


class _Decoder(_Source):
    """Reads from the memoryview ``d`` at offset ``o``; ``run`` names the targets."""

    def align_dynamic(self, size: int) -> None:
        self.emit(f"o += (4 - o) & {size - 1}")

    def flush(self) -> None:
        if not self.run:
            return
        layout = Struct("<" + "".join(char for char, _ in self.run))
        targets = "".join(f"{name}, " for _, name in self.run if name)
        unpack = self.constant("unpack", layout.unpack_from)
        if targets:
            self.emit(f"{targets}= {unpack}(d, o)")
        self.emit(f"o += {layout.size}")
        self.run.clear()

    def message(self, definition: MessageDefinition) -> str:
        """Emit the reading of a message; gives the name of the variable that will hold it."""
        from rosidl_embedded.registry import get_message

        cls = self.constant("C", get_message(definition.name))
        target = self.fresh("m")
        self.emit(f"{target} = new({cls})")
        self.emit(f"{target}._check_fields = CHECK")
        if not definition.fields:
            self.fixed("B", 1, self.fresh("unused"))
        for field in definition.fields:
            self.field(field.type, f"{target}._{field.name}")
        return target

    def field(self, kind: FieldType, target: str) -> None:
        if kind.kind == "single":
            self.single(kind, target)
        elif kind.is_numeric:
            self.numbers(kind, target)
        else:
            self.items(kind, target)

    def single(self, kind: FieldType, target: str) -> None:
        if kind.is_message:
            name = self.message(message_definition(kind.base))
            self.emit(f"{target} = {name}")
        elif kind.base == "string":
            size = self.fresh("n")
            self.fixed("I", 4, size)
            self.flush()
            self.emit(f"{target} = str(d[o:o + {size} - 1], 'utf-8', 'replace') if {size} else ''")
            self.emit(f"o += {size}")
            self.forget()
        else:
            char, size_, _ = PRIMITIVES[kind.base]
            self.fixed(char, size_, target)

    def numbers(self, kind: FieldType, target: str) -> None:
        char, size, _ = PRIMITIVES[kind.base]
        if kind.kind == "array":
            self.align(size)
            self.flush()
            self.namespace["frombuffer"] = __import__("numpy").frombuffer
            self.emit(
                f"{target} = frombuffer(d, '<{_numpy_code(char, size)}', {kind.size}, o).copy()"
            )
            self.emit(f"o += {kind.size * size}")
            self.advance(kind.size * size)
            return
        count = self.fresh("n")
        self.fixed("I", 4, count)
        self.flush()
        self.emit(f"{target} = a = array('{char}')")
        self.emit(f"if {count}:")
        self.indent += 1
        if size > 4:
            self.align_dynamic(size)
        self.emit(f"p = o; o += {count} * {size}")
        self.emit("if o > len(d): raise error(SHORT)")
        self.emit("a.frombytes(d[p:o])")
        self.indent -= 1
        self.forget()

    def items(self, kind: FieldType, target: str) -> None:
        if kind.kind == "sequence":
            count = self.fresh("n")
            self.fixed("I", 4, count)
        else:
            count = str(kind.size)
        self.flush()
        if kind.is_primitive:
            self.emit(f"p = o; o += {count}")
            self.emit("if o > len(d): raise error(SHORT)")
            each = "x != 0" if kind.base == "bool" else "ONE[x]"
            self.emit(f"{target} = [{each} for x in d[p:o]]")
            self.forget()
            return
        self.emit(f"{target} = a = []")
        item, out = self.fresh("e"), self.fresh("l")
        self.emit(f"{out} = a")
        self.emit(f"for _ in range({count}):")
        self.indent += 1
        self.forget()
        if kind.is_message:
            item = self.message(message_definition(kind.base))
        else:
            self.single(kind.element, item)
        self.flush()
        self.emit(f"{out}.append({item})")
        self.indent -= 1
        self.forget()


def _numpy_code(char: str, size: int) -> str:
    return {"f": "f", "d": "f"}.get(char, "i" if char.islower() else "u") + str(size)


def compile_codec(definition: MessageDefinition, check_fields: bool) -> Codec:
    """The codec of a message; ``check_fields`` is what decoded messages do on assignment."""
    namespace: dict[str, Any] = {
        "ZERO": tuple(bytes(n) for n in range(8)),
        "ONE": tuple(bytes([n]) for n in range(256)),
        "NUL": b"\0",
        "CHECK": check_fields,
        "array": array,
        "new": object.__new__,
        "error": error,
        "SHORT": f"the data ends inside a {definition.name}",
    }
    encoder = _Encoder(namespace)
    encoder.mod, encoder.rest = 8, 0
    encoder.message(definition, "m")
    encoder.flush()
    decoder = _Decoder(namespace)
    decoder.names = encoder.names
    decoder.mod, decoder.rest = 8, 0
    result = decoder.message(definition)
    decoder.flush()
    source = "\n".join(
        [
            "def encode(m, b):",
            *encoder.lines,
            "    return None",
            "def decode(d, o):",
            *decoder.lines,
            "    if o > len(d): raise error(SHORT)",
            f"    return {result}, o",
            "",
        ]
    )
    exec(compile(source, f"<codec of {definition.name}>", "exec"), namespace)
    return Codec(namespace["encode"], namespace["decode"])
