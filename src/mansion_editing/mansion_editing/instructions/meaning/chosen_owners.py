"""What stands around one of several things goes with that one: ``remove one table and its four chairs``."""

import msgspec

from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import things_of
from mansion_editing.instructions.statements import Amount, Instruction, Move, Remove, Statement, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import MansionError

__all__ = ["with_owners_chosen"]


def with_owners_chosen(instruction: Instruction, state: SceneState, context: Context) -> Instruction:
    """Return an instruction in which any of several things is chosen where what stands around it goes along.

    What stands around each of those that are chosen goes first, while they still tell where it is.
    """
    out = list(instruction.statements)
    for own in instruction.statements:
        owner = next((one for one in out if _owns(one, own)), None)
        if not isinstance(owner, Remove | Move) or not isinstance(own, Remove | Move):
            continue
        try:
            chosen = _chosen(owner, own, state, context)
        except MansionError:
            return instruction
        around = [_around(own, name, len(chosen)) for name in chosen]
        gone = [msgspec.structs.replace(owner, things=Things(noun=name, definite=True)) for name in chosen]
        at = min(out.index(owner), out.index(own))
        rest = [one for one in out if one is not owner and one is not own]
        out = [*rest[:at], *around, *gone, *rest[at:]]
    return msgspec.structs.replace(instruction, statements=out)


def _chosen(owner: Remove | Move, own: Remove | Move, state: SceneState, context: Context) -> list[str]:
    """Return the ids of as many owners as are meant, of those around which such things stand.

    Raises
    ------
    MansionError
        See `things_meant`.
    """
    meant = [item.id for item in things_meant(state, owner.things, context)]
    rooms = {name.rpartition("/")[0] for name in meant}
    there = [item.id for item in things_of(state, owner.things, context) if item.room in rooms]
    around = {name: len(things_of(state, _around(own, name, 1).things, context)) for name in there}
    least = own.things.amount.number // len(meant) or max(around.values(), default=0)
    bearing = [name for name in there if around[name] >= max(1, least)]
    return bearing[-len(meant) :] if len(bearing) >= len(meant) else meant


def _owns(owner: Statement, own: Statement) -> bool:
    """Whether a statement takes any of some things, around one of which those of the other one stand."""
    if not isinstance(own, Remove | Move) or type(owner) is not type(own) or not isinstance(owner, Remove | Move):
        return False
    anchor = None if own.things.place is None else own.things.place.anchor
    any_of_them = not owner.things.definite and owner.things.amount.kind == "some" and bool(owner.things.amount.number)
    return anchor is not None and not anchor.definite and anchor.noun == owner.things.noun and any_of_them


def _around(own: Remove | Move, owner: str, owners: int) -> Remove | Move:
    """Return what stands around one of the owners: a share of their number where one is told."""
    number = own.things.amount.number
    share = Amount(kind="all", number=0) if number % owners or not number else Amount(number=number // owners)
    place = own.things.place
    assert place is not None
    there = msgspec.structs.replace(place, anchor=Things(noun=owner, definite=True), rooms=None)
    return msgspec.structs.replace(own, things=msgspec.structs.replace(own.things, place=there, amount=share))
