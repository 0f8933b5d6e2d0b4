"""Which of the rooms that a brief asks for cannot be used as what they are, and why."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from mansion_knowledge.essentials import Need, needs_of, pieces_there, still_wanted
from mansion_knowledge.furnished_as import furnished_as
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom

__all__ = ["Equipment", "equipment_of"]


@dataclass(frozen=True)
class Equipment:
    """What a finished room needs, and what it has of it.

    Attributes
    ----------
    needs : sequence of Need
    objects : sequence of (str, float)
        Category and width of each object, metres.
    reasons : mapping of str to str
        By name of a need, why the room was left without it.
    """

    needs: Sequence[Need] = ()
    objects: Sequence[tuple[str, float]] = ()
    reasons: Mapping[str, str] | None = None

    def lack(self, unwanted: Iterable[str] = ()) -> str:
        """Say what the room cannot be used without and has not; empty where it has all.

        Parameters
        ----------
        unwanted : iterable of str
            Categories that the brief does not want in the room.
        """
        for need in still_wanted(self.needs, list(unwanted)):
            have = pieces_there(need, self.objects)
            if have < need.count:
                why = (self.reasons or {}).get(need.name, "")
                amount = f"{have} of {need.count} x {need.name}" if have else f"no {need.name}"
                return f"has {amount}" + (f": {why}" if why else "")
        return ""


def equipment_of(scene: FloorScene, room: SceneRoom, objects: Iterable[SceneObject]) -> Equipment:
    """Return the equipment of a finished room from its objects and from what was left out of it."""
    return Equipment(
        needs_of(furnished_as(room.room_type, scene.building_type, room.name), (room.name, *room.aliases)),
        [(thing.category, thing.size[0]) for thing in objects],
        {lost.name: lost.reason for lost in scene.discarded if lost.room == room.id},
    )
