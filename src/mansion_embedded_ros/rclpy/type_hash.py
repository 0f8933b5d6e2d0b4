"""The hash of an interface type."""

from __future__ import annotations

__all__ = ["TypeHash"]


class TypeHash:
    """``RIHS01_`` and 64 hexadecimal digits, as version and bytes."""

    __slots__ = ["_value", "_version"]

    def __init__(self, version: int = -1, value: bytes = bytes(32)):
        self.version = version
        self.value = value

    @property
    def version(self) -> int:
        return self._version

    @version.setter
    def version(self, value: int) -> None:
        assert isinstance(value, int)
        self._version = value

    @property
    def value(self) -> bytes:
        return self._value

    @value.setter
    def value(self, value: bytes) -> None:
        assert isinstance(value, bytes)
        self._value = value

    @classmethod
    def _from_string(cls, text: str) -> TypeHash:
        if text.startswith("RIHS01_") and len(text) == 71:
            try:
                return cls(1, bytes.fromhex(text[7:]))
            except ValueError:
                return cls()
        return cls()

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TypeHash):
            return False
        return (self.version, self.value) == (other.version, other.value)

    def __hash__(self) -> int:
        return hash((self._version, self._value))

    def __str__(self) -> str:
        if self._version <= 0 or len(self._value) != 32:
            return "INVALID"
        return f"RIHS{self._version:02}_{self._value.hex()}"
