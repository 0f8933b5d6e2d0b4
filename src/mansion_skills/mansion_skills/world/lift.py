"""A lift as Open-RMF sees it: cabin, doors, and the session that holds it.

The cabin runs at one speed and the doors take a fixed time; both advance the world's clock, not the wall's.
"""

from dataclasses import dataclass, field

from mansion_msgs_py.world import LiftDoor, LiftMotion, LiftState

__all__ = ["Lift"]

SPEED = 1.0
"""Metres a second."""

DOOR_TIME = 2.0
"""Seconds that the doors take to open or close."""


@dataclass
class Lift:
    """One lift of the building.

    Attributes
    ----------
    elevations : dict
        Floor number to height of its finished floor, metres.
    labels : dict
        Floor number to label.
    """

    name: str
    elevations: dict[int, float]
    labels: dict[int, str]
    floor: int
    door: LiftDoor = LiftDoor.CLOSED
    session: str = ""
    queue: list[int] = field(default_factory=list)

    def is_open_at(self, floor: int) -> bool:
        """Whether the cabin stands on `floor` with its doors open."""
        return self.floor == floor and self.door is LiftDoor.OPEN

    def travel(self, floor: int, session: str) -> float:
        """Bring the cabin to `floor` for `session`, open the doors, and return the seconds that it took."""
        self.session = session
        seconds = 0.0
        if self.floor != floor:
            seconds += DOOR_TIME if self.door is LiftDoor.OPEN else 0.0
            seconds += abs(self.elevations[floor] - self.elevations[self.floor]) / SPEED
            self.door = LiftDoor.CLOSED
            self.floor = floor
        if self.door is not LiftDoor.OPEN:
            seconds += DOOR_TIME
            self.door = LiftDoor.OPEN
        return seconds

    def release(self) -> None:
        """End the session that holds the lift and close its doors."""
        self.session = ""
        self.door = LiftDoor.CLOSED

    def state(self, building_id: str, time: float) -> LiftState:
        """Return the lift's state with Open-RMF's field names."""
        return LiftState(
            lift_name=self.name,
            available_floors=[self.labels[floor] for floor in sorted(self.elevations)],
            current_floor=self.labels[self.floor],
            destination_floor=self.labels[self.floor],
            door_state=self.door,
            motion_state=LiftMotion.STOPPED,
            lift_time=time,
            position=self.elevations[self.floor],
            session_id=self.session,
            building_id=building_id,
        )
