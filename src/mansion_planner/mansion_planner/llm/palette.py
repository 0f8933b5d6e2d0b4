"""Materials of a building, chosen by a model for each room type; the brief's own wishes come first."""

from mansion_llm import Fault, Prompt, quoted_data
from mansion_msgs_py.wording import with_article
from mansion_planner.llm.answers import MaterialsAnswer
from mansion_planner.llm.cleaning import clean_text, material_fault
from mansion_planner.llm.context import ARCHITECT, CLOSING, Context
from mansion_planner.program.building import PlannedBuilding, materials_of
from mansion_planner.program.decisions import Decisions

__all__ = ["Palette", "choose_palette"]

MOST_TYPES = 60


class Palette:
    """Floor and wall material of each room type.

    Parameters
    ----------
    chosen : dict of str to (str, str)
        By room type; the rest follows the style's rules.
    """

    def __init__(self, context: Context, decisions: Decisions, chosen: dict[str, tuple[str, str]]) -> None:
        self._context, self._decisions, self._chosen = context, decisions, chosen

    def materials(self, room_type: str, floor: str = "", wall: str = "") -> tuple[str, str]:
        """Return a room's materials: the brief's wish, else those given, else the palette's, else the style's."""
        knowledge, decisions = self._context.knowledge, self._decisions
        kind = knowledge.room(room_type)
        plain = materials_of(kind, decisions.style, knowledge)
        wished = materials_of(kind, decisions.style, knowledge, decisions.facts.materials)
        chosen = self._chosen.get(room_type, plain)
        given = (clean_text(floor, 80), clean_text(wall, 80))
        out = []
        for k in (0, 1):
            if wished[k] != plain[k]:
                out.append(wished[k])
            elif given[k] and not material_fault(given[k], kind, floor=k == 0):
                out.append(given[k])
            else:
                out.append(chosen[k])
        return out[0], out[1]

    def hints(self) -> str:
        """Return the palette as lines for a prompt."""
        names = sorted(self._chosen) or [self._decisions.building.hub]
        rows = (f"- {name}: floor {f}; walls {w}" for name in names for f, w in [self.materials(name)])
        return "\n".join(rows)


def _types(reference: PlannedBuilding) -> list[str]:
    found: dict[str, None] = {}
    for floor in reference.program.floors:
        for room in floor.rooms:
            found.setdefault(room.room_type)
    return sorted(found)[:MOST_TYPES]


def _palette_prompt(context: Context, reference: PlannedBuilding) -> Prompt:
    """Return the question for materials."""
    decisions = reference.decisions
    wet = [name for name in _types(reference) if context.knowledge.room(name).wet]
    lines = [
        quoted_data("brief", context.description),
        f"Choose floor and wall materials for {with_article(decisions.building.name.replace('_', ' '))} in the style "
        f"{decisions.style!r}, one pair for each of these room types: {', '.join(_types(reference))}.",
        "Keep one palette through the whole building. Describe a material in a few plain words with its finish, such "
        "as 'warm oak hardwood, matte' or 'soft beige drywall, smooth'.",
        f"These rooms are wet and need materials that stand water: {', '.join(wet) or 'none'}.",
        CLOSING,
        '{"palette": [{"room_type": "<name>", "floor_material": "<words>", "wall_material": "<words>"}]}',
    ]
    return Prompt("materials", ARCHITECT, "\n".join(lines))


def choose_palette(context: Context, reference: PlannedBuilding) -> Palette:
    """Return the palette; room types whose answer stays faulty follow the style's rules."""
    decisions = reference.decisions
    if not context.client.wants("materials"):
        context.from_rules("materials")
        return Palette(context, decisions, {})
    types = _types(reference)

    def check(answer: MaterialsAnswer) -> list[Fault]:
        faults = []
        named = {entry.room_type for entry in answer.palette}
        faults += [Fault(f"{name} has no materials", name) for name in types if name not in named]
        for entry in answer.palette:
            kind = context.knowledge.rooms.get(entry.room_type)
            for text, floor in ((entry.floor_material, True), (entry.wall_material, False)):
                fault = material_fault(text, kind, floor=floor)
                if fault and entry.room_type in types:
                    faults.append(Fault(f"{entry.room_type}: {fault}", entry.room_type))
        return faults

    answer = context.client.ask(_palette_prompt(context, reference), MaterialsAnswer, check)
    if answer.value is None:
        context.from_rules("materials", answer.reason)
        return Palette(context, decisions, {})
    faulty = answer.faulty_pieces()
    chosen = {
        entry.room_type: (entry.floor_material, entry.wall_material)
        for entry in answer.value.palette
        if entry.room_type in types and entry.room_type not in faulty
    }
    if faulty:
        context.partly_from_model("materials", f"{len(chosen)} of {len(types)} room types: {answer.reason}")
    else:
        context.from_model("materials")
    return Palette(context, decisions, chosen)
