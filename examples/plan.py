"""Plan a building without making it: print its floors, its rooms and their areas, and which words led to them.

.venv/bin/python examples/plan.py
"""

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.plan_report import trace_lines

BRIEF = "A two-storey house with three bedrooms and a sauna upstairs"


def main() -> None:
    """Print the plan of `BRIEF`."""
    plan = plan_building(BuildRequest(description=BRIEF))
    for floor in plan.program.floors:
        print(f"floor {floor.index}: {floor.gross_floor_area:.0f} m2")
        for room in floor.rooms:
            print(f"  {room.id:<20} {room.area_estimate:5.1f} m2")
    print("why:")
    print(*(f"  {line}" for line in trace_lines(plan)), sep="\n")


if __name__ == "__main__":
    main()
