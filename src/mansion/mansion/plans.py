"""Plans: the program of a brief and its receipt, before anything is built."""

import html
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from mansion.briefs import Outline, request_of
from mansion.selections import Wishes
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.program import BuildingProgram, FloorProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wording import counted

if TYPE_CHECKING:
    from mansion.building import Building

__all__ = ["Plan", "plan"]


def plan(
    description: str | BuildRequest,
    *,
    floors: int | None = None,
    area: float | None = None,
    floor_area: float | None = None,
    footprint: Outline | None = None,
    seed: int = 0,
    planner: Literal["rules", "llm"] = "rules",
    assets: str | Sequence[str] = (),
) -> "Plan":
    """Plan a building without making it: floors, rooms, areas, and what becomes of each wish.

    Parameters
    ----------
    description : str or BuildRequest
        The brief: English, or any language with the planner ``llm``. A request brings its own options.
    floors : int, optional
        Number of floors; read from the description when absent.
    area, floor_area : float, optional
        Gross area of the building, or of one floor; square metres.
    footprint : Footprint, sequence of (x, y), or path, optional
        Outline of every floor.
    seed : int
        Same seed, same plan.
    planner : {"rules", "llm"}
    assets : str or sequence of str
        Libraries of own assets, whose words the description may use.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for options that do not fit, ``CONTRADICTION`` or ``INFEASIBLE`` for a brief that nothing
        meets, ``UNAVAILABLE`` for a model that is not configured.

    Examples
    --------
    >>> p = mansion.plan("a two-storey clinic", floor_area=160)
    >>> len(p.floors), p.wishes.filter(kind="floors")[0].text
    (2, 'two-storey')
    """
    with importing:
        from mansion_bringup.pipeline.planning import plan_request

    request = request_of(
        description, footprint, floors=floors, area=area, floor_area=floor_area, seed=seed, planner=planner,
        assets=assets,
    )  # fmt: skip
    return Plan(request, plan_request(request))


@dataclass(frozen=True)
class Plan:
    """A planned building.

    Attributes
    ----------
    request : BuildRequest
    reply : PlanReply
        Program, room graphs and the solver's problems.
    """

    request: BuildRequest
    reply: PlanReply = field(repr=False)

    @property
    def program(self) -> BuildingProgram:
        """The building's program, ``mansion plan --json``."""
        return self.reply.program

    @property
    def floors(self) -> tuple[FloorProgram, ...]:
        """The planned floors from below, each with its rooms and areas."""
        return tuple(self.program.floors)

    @cached_property
    def wishes(self) -> Wishes:
        """What the brief asks for, with the status that each wish has if every later stage keeps to the plan."""
        with importing:
            from mansion_bringup.building.receipt import receipt_of_plan

        return Wishes(receipt_of_plan(self.program, self.reply.topologies))

    def build(self, folder: str | Path | None = None, **options: Any) -> "Building":
        """Build what is planned; see `mansion.build` for the options."""
        with importing:
            from mansion.making import build

        return build(self.request, folder, **options)

    def __str__(self) -> str:
        lines = [f"{self.program.building_type}: {self.program.description or self.request.description}"]
        for floor in self.floors:
            lines.append(f"floor {floor.index} ({floor.label}), {floor.gross_floor_area:.0f} m2 gross")
            lines += [f"  {room.id:<24} {room.area_estimate:6.1f} m2" for room in floor.rooms]
        return "\n".join([*lines, self.wishes.summary])

    def __repr__(self) -> str:
        rooms = sum(len(floor.rooms) for floor in self.floors)
        return f"<plan of {counted(len(self.floors), 'floor')} and {counted(rooms, 'room')}; {self.wishes.summary}>"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>{self.wishes._repr_html_()}"
