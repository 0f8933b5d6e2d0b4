"""The prompt for the building program: the inputs, rules and output of Fig. 23 in our words."""

from shapely.geometry import Polygon

from mansion_llm import Prompt, quoted_data
from mansion_planner.llm.context import Context
from mansion_planner.llm.cores import core_sizes
from mansion_planner.llm.palette import Palette
from mansion_planner.llm.picture import outline_picture
from mansion_planner.llm.wording import ARCHITECT, CLOSING, as_json, number
from mansion_planner.program.building import PlannedBuilding

__all__ = ["program_prompt"]

_RULES = """\
Rules:
1. Plan the program floor by floor. Fulfil every statement of the brief: named rooms, counts, areas, floors, what
   must not be there.
2. The first room of each floor is its circulation hub (a lobby, hall, corridor or the main room of a small dwelling).
   List no other corridors, stairs or elevators as rooms: they are taken from the reserve.
3. A room has an id and no type: English snake case, unique on its floor, numbered where there are several
   (meeting_room_1). Name a private bathroom or closet after the room that it belongs to (bedroom_1_bathroom).
4. Areas are realistic for the use. The rooms of a floor never add up to more than its gross area; leave 12 to 25
   percent for circulation and cores unless you justify another share.
5. Each room has a floor_material and a wall_material in a few plain words; wet rooms get materials that stand water.
6. A floor that repeats an earlier one exactly is written {"index": k, "copy": j}.
7. Cores stand at the same place on all floors, with non-negative integer coordinates and exactly the given size,
   inside every floor's outline. Put them only in corners of two exterior walls, choose the corner with the least space
   left around it, use tight and awkward pockets first, and keep the large areas in one piece. You may keep the
   proposed cores."""

_SCHEMA = """\
{"reasoning": "<short>",
 "vertical_connectivity": {"method": "none|stair|elevator|stair_and_elevator",
   "cores": [{"type": "stair|elevator", "x": [<int>, <int>], "y": [<int>, <int>]}], "justification": "<why>"},
 "floors": [{"index": <int>, "copy": null, "requirement": "<what this floor is for>",
   "rooms": [{"id": "<hub>", "area_estimate": <float>, "floor_material": "<words>", "wall_material": "<words>",
              "notes": "circulation hub"},
             {"id": "<room>", "area_estimate": <float>, "floor_material": "<words>", "wall_material": "<words>",
              "notes": ""}],
   "reserve_justification": ""}]}"""


def program_prompt(context: Context, reference: PlannedBuilding, palette: Palette) -> Prompt:
    """Return the question for the building program, with the outline as a picture."""
    program, decisions = reference.program, reference.decisions
    ground = next(f for f in program.floors if f.index == min(1, program.floors[-1].index))
    outline = {"boundary": ground.outline, "holes": ground.holes}
    vertical = program.vertical_connectivity
    sizes = "; ".join(
        f"{kind} {' or '.join(f'{number(w)} x {number(d)}' for w, d in both)}"
        for kind, both in core_sizes(vertical).items()
    )
    floors = [
        f"- index {floor.index}: {number(floor.gross_floor_area)} m2 gross, {storey.role} floor"
        + ("" if floor.outline == ground.outline else f", outline {as_json(floor.outline)}")
        for floor, storey in zip(program.floors, reference.storeys)
    ]
    proposed = [{"type": c.type, "x": c.x, "y": c.y} for c in vertical.cores]
    lines = [
        "Program a complete building from the outline of its first floor, shown in the picture (stairs red, elevators "
        "blue where they are proposed).",
        quoted_data("brief", context.description),
        f"Type: {decisions.building.name}; style: {decisions.style}. Floors, from the lowest:",
        *floors,
        f"First-floor boundary: {as_json(outline)}",
        f"Vertical connection by rule: {vertical.method} ({vertical.justification}). Sizes: {sizes}. "
        f"Proposed cores: {as_json(proposed)}",
        "Palette of the building:\n" + palette.hints(),
        _RULES,
        CLOSING,
        _SCHEMA,
    ]
    picture = outline_picture(Polygon(ground.outline, ground.holes), vertical.cores)
    return Prompt("building_program", ARCHITECT, "\n".join(lines), (picture,))
