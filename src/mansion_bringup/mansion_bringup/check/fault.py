"""A fault of a building."""

import msgspec

__all__ = ["Fault"]


class Fault(msgspec.Struct, frozen=True, order=True):
    """A fault: its kind, the place (an id or a file), and what was found against what holds in a sound building."""

    kind: str
    where: str
    message: str

    def __str__(self) -> str:
        return f"{self.kind} {self.where}: {self.message}"
