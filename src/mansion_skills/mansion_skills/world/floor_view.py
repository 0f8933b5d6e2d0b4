"""One floor as a robot finds it: scene, grids, landmarks, and the doors and objects of this moment."""

from collections.abc import Mapping

from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.world import ObjectState
from mansion_skills.navigation.floor_map import Body, FloorMap
from mansion_skills.world.landmarks import Landmark, floor_landmarks
from mansion_skills.world.objects import ObjectTable

__all__ = ["FloorView", "bodies_of"]

FEW_DOORS = 4
"""So many doors are swung one by one; for more, all grids are made anew."""


def bodies_of(floor: int, objects: ObjectTable) -> list[Body]:
    """Return what is on a floor, numbered for its view grid."""
    found = []
    for number, state in enumerate(objects.on_floor(floor), start=1):
        kind = objects.kinds[state.id]
        assert state.position is not None
        found.append(
            Body(
                id=state.id,
                position=state.position,
                size=kind.size,
                rotation=state.rotation,
                carried=state.mount in ("surface", "inside"),
                number=number,
            )
        )
    return found


def _stand_alike(states: list[ObjectState], before: list[ObjectState]) -> bool:
    """Whether objects are where they were, whatever else has changed about them."""
    return len(states) == len(before) > 0 and all(
        a is b or (a.id, a.position, a.rotation, a.mount) == (b.id, b.position, b.rotation, b.mount)
        for a, b in zip(states, before)
    )


class FloorView:
    """A loaded floor (skill card UseElevator, steps 2 and 3).

    Parameters
    ----------
    scene : FloorScene
    objects : ObjectTable
    doors : mapping
        Door id to whether it stands open, for doors that are not as in the scene.
    radius : float
        Of the robot, metres.
    """

    def __init__(self, scene: FloorScene, objects: ObjectTable, doors: Mapping[str, bool], radius: float) -> None:
        self.scene = scene
        self.floor = scene.floor
        self.doors: dict[str, Door] = {door.id: door for door in scene.doors}
        self._objects = objects
        self.numbers: dict[str, int] = {}
        self._states: list[ObjectState] = []
        self.map = FloorMap(scene, radius)
        self.refresh({})
        self.landmarks: list[Landmark] = floor_landmarks(self.map)
        if any(name in self.doors for name in doors):
            self.refresh(doors)

    def refresh(self, doors: Mapping[str, bool]) -> None:
        """Bring the grids up to date with doors and objects."""
        is_open = {name: doors.get(name, door.is_open) for name, door in self.doors.items()}
        states = [state for state in self._objects.on_floor(self.floor) if state.mount not in ("surface", "inside")]
        swung = [name for name in is_open if self.map.is_open.get(name) != is_open[name]]
        if len(swung) <= FEW_DOORS and _stand_alike(states, self._states):
            for name in swung:
                self.map.swing(name, is_open[name])
            return
        self._states = states
        bodies = bodies_of(self.floor, self._objects)
        self.numbers = {body.id: body.number for body in bodies}
        self.map.update(bodies, is_open)
