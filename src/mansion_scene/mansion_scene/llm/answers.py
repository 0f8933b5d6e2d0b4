"""The answer to the question for a room's objects: section G's three kinds of constraint."""

import msgspec

__all__ = ["ObjectAnswer", "ObjectsAnswer", "RelationAnswer", "StructureAnswer"]


class StructureAnswer(msgspec.Struct):
    """``single``, ``matrix`` with rows and columns, or ``paired`` with another object."""

    kind: str
    rows: int | None = None
    cols: int | None = None
    with_: str | None = msgspec.field(name="with", default=None)


class RelationAnswer(msgspec.Struct):
    """A relative position constraint."""

    kind: str
    target: str


class ObjectAnswer(msgspec.Struct):
    """A kind of object in the room."""

    name: str
    category: str
    quantity: int
    global_: str = msgspec.field(name="global")
    structure: StructureAnswer
    relative: list[RelationAnswer] = []


class ObjectsAnswer(msgspec.Struct):
    """What a room is furnished with, the most important first."""

    objects: list[ObjectAnswer]
