"""One way to change a storey, carried out and judged."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from mansion_editing.structure.rebuilding import Rebuilt, rebuild
from mansion_editing.structure.rebuilt_scene import Finished, finish
from mansion_editing.structure.reports import door_sentences, object_sentences, room_sentences, wall_sentences
from mansion_editing.structure.storey_documents import Reshaped, Storey, Workshop
from mansion_editing.structure.wall_moves import MovedWall
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_scene.structure.access import Passage

__all__ = ["Change", "attempt"]


@dataclass(frozen=True)
class Change:
    """A storey's documents after a change, and what its scene is made from.

    Attributes
    ----------
    before, after : Storey
        The scene of `after` is still that of `before`.
    passages : sequence of Passage
        Which regions open to which.
    may_change : collection of str
        Rooms whose objects may move; all others keep theirs as they are.
    moves : sequence of MovedWall
        By the rooms' ids in the scene.
    refurnished : collection of str
        Rooms to furnish again.
    released : collection of str
        Ids of doors that need not stay where they are.
    """

    before: Storey
    after: Storey
    passages: Sequence[Passage]
    may_change: Collection[str]
    moves: Sequence[MovedWall] = ()
    refurnished: Collection[str] = ()
    released: Collection[str] = ()


@dataclass(frozen=True)
class Outcome:
    """A change that was carried out, and how many objects are gone by it."""

    reshaped: Reshaped
    losses: int


def attempt(change: Change, workshop: Workshop) -> Outcome:
    """Carry out a change.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` where the storey could not be built so, or would have a fault that it has not now.
    """
    workshop.go_on()
    rebuilt = rebuild(change.before, change.after, change.passages, change.released)
    _require_entrance(change, rebuilt)
    first = _finished(change, rebuilt, workshop, change.refurnished)
    faults = _new_faults(change, first, workshop)
    finished = first
    # Furniture that was moved piece by piece may stand in its own way: only furnishing the room as a whole helps then.
    crowded = [r for r in first.settled if r in change.may_change and any(_names(fault, r) for fault in faults)]
    if faults and crowded:
        finished = _finished(change, rebuilt, workshop, {*change.refurnished, *crowded})
        faults = _new_faults(change, finished, workshop)
    if faults:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"the storey would have a fault: {faults[0]}", details={"faults": list(faults)}
        )
    after = Storey(change.after.program, change.after.topology, change.after.layout, finished.scene)
    said = [
        *room_sentences(change.before, finished.scene),
        *wall_sentences(change.moves),
        *door_sentences(rebuilt),
        *object_sentences(finished),
    ]
    return Outcome(Reshaped(after, said), finished.losses)


def _finished(change: Change, rebuilt: Rebuilt, workshop: Workshop, refurnished: Collection[str]) -> Finished:
    return finish(change.after, rebuilt, workshop, moves=change.moves, refurnished=refurnished)


def _new_faults(change: Change, finished: Finished, workshop: Workshop) -> Sequence[str]:
    """Return the faults that a change makes; to move the furniture of a room that it does not concern is one."""
    scene, was = finished.scene, change.before.scene
    held = [room.id for room in scene.rooms if room.id not in change.may_change]
    for room in held:
        if [o for o in scene.objects if o.room == room] != [o for o in was.objects if o.room == room]:
            return [f"{room}: its furniture, which stays as it is, would be in the way of a door or a wall"]
    return workshop.judge(scene)


def _names(fault: str, room: str) -> bool:
    return any(word.strip(":,") == room or word.startswith(f"{room}/") for word in fault.split())


def _require_entrance(change: Change, rebuilt: Rebuilt) -> None:
    """Refuse a change that moves a door to the outside into another room or away."""
    new = {door.rooms for door in rebuilt.structure.doors if None in door.rooms}
    for door in rebuilt.lost_doors:
        if None in door.rooms and door.rooms not in new and not _released(door.id, change):
            raise MansionError(ErrorCode.INFEASIBLE, f"the door from {door.rooms[0]} to the outside would be lost")


def _released(door: str, change: Change) -> bool:
    return door in change.released
