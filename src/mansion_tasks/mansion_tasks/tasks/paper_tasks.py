"""The tasks of the paper (supplement, E and Table 6), in words, each with a brief for a building that fits."""

from dataclasses import dataclass
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import Goal, GoalKind, Need, Task, TaskKind
from mansion_msgs_py.wording import choices

__all__ = ["PAPER_TASKS", "PaperTask", "paper_task"]


@dataclass(frozen=True)
class PaperTask:
    """A task that is not grounded yet.

    Attributes
    ----------
    task : Task
        With instruction and needs.
    sentence : str
        For ``mansion build``.
    source : str
        Where the supplement describes it.
    start_floor : int
    """

    task: Task
    sentence: str
    source: str
    start_floor: int = 1


APARTMENT: Final = "A single-storey apartment with two bedrooms"
TWO_FLOOR_OFFICE: Final = "A two-storey office with a lounge and a break room"
FOUR_FLOOR_OFFICE: Final = "A four-storey office with meeting rooms"
HOUSE: Final = "A two-storey family house"


def _deliver(name: str, instruction: str, *needs: Need, goals: tuple[GoalKind, ...] = ()) -> Task:
    return Task(
        id=name,
        kind=TaskKind.DELIVER,
        instruction=instruction,
        needs=list(needs),
        goals=[Goal(kind=kind) for kind in goals],
    )


_BOX: Final = PaperTask(
    _deliver(
        "apartment_box",
        "Find a box on the bed and bring it to the bathroom.",
        Need(noun="box", relation="on", receptacle="bed", role="target"),
        Need(room="bathroom", role="destination"),
    ),
    APARTMENT,
    "Table 6, single-floor apartment",
)
_CELLPHONE: Final = PaperTask(
    _deliver(
        "office_cellphone",
        "Find a cellphone on a blue couch on the first floor and bring it to the round table on the second floor.",
        Need(noun="cellphone", relation="on", receptacle="couch", receptacle_color="blue", floor=1, role="target"),
        Need(noun="round table", floor=2, role="destination"),
    ),
    TWO_FLOOR_OFFICE,
    "Table 6, double-floor office",
)
_LAPTOP: Final = PaperTask(
    _deliver(
        "office_laptop",
        "Go to the third floor, find a laptop on the desk in the meeting room on the third floor, and take it to the "
        "restroom on the fourth floor.",
        Need(noun="laptop", relation="on", receptacle="desk", room="meeting room", floor=3, role="target"),
        Need(room="restroom", floor=4, role="destination"),
    ),
    FOUR_FLOOR_OFFICE,
    "Table 6, four-floor office",
)
_CLOTH: Final = PaperTask(
    _deliver(
        "sofa_cloth",
        "I want to clean my sofa. Go get a cloth from the first floor and come back near the sofa.",
        Need(noun="cloth", floor=1, role="target"),
        Need(noun="sofa", floor=2, role="destination"),
        goals=(GoalKind.OBJECT_NEAR, GoalKind.ROBOT_NEAR),
    ),
    HOUSE,
    "E, two-floor tasks, and Fig. 14",
    start_floor=2,
)
_TOOLBOX: Final = PaperTask(
    _deliver(
        "orange_toolbox",
        "Collect the orange toolbox on the third floor and deliver it to the fourth floor.",
        Need(noun="toolbox", color="orange", floor=3, role="target"),
        Need(floor=4, role="destination"),
    ),
    FOUR_FLOOR_OFFICE,
    "E, four-story setting",
)
_BASKETBALL: Final = PaperTask(
    _deliver(
        "apartment_basketball",
        "Find the basketball and bring it to the bathroom.",
        Need(noun="basketball", role="target"),
        Need(room="bathroom", role="destination"),
    ),
    APARTMENT,
    "E, single-floor tasks",
)
_HOME_LAPTOP: Final = PaperTask(
    _deliver(
        "apartment_laptop",
        "Find a laptop and bring it to the kitchen.",
        Need(noun="laptop", role="target"),
        Need(room="kitchen", role="destination"),
    ),
    APARTMENT,
    "E, single-floor tasks",
)

PAPER_TASKS: Final[dict[str, PaperTask]] = {
    entry.task.id: entry for entry in (_BOX, _CELLPHONE, _LAPTOP, _CLOTH, _TOOLBOX, _BASKETBALL, _HOME_LAPTOP)
}
"""By the task's id."""


def paper_task(name: str) -> PaperTask:
    """Return the task of that id.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with those that exist.
    """
    if name not in PAPER_TASKS:
        known = choices(name, PAPER_TASKS, "the paper's tasks")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no paper task {name!r}; {known}")
    return PAPER_TASKS[name]
