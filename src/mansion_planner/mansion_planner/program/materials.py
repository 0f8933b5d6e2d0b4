"""Materials of a room from the building's style."""

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_planner.brief.facts import MaterialFact

__all__ = ["materials_of"]


def materials_of(
    kind: RoomType, style: str, knowledge: KnowledgeBase, wishes: list[MaterialFact] | None = None
) -> tuple[str, str]:
    """Return the floor and the wall material of a room type in a style.

    `wishes` of the brief come before the style; one for all rooms leaves wet rooms alone.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> base = default_knowledge()
    >>> materials_of(base.room("bathroom"), "neutral", base)
    ('ceramic tile, light gray', 'ceramic wall tile, white')
    """
    chosen = knowledge.styles[style]
    wall = "dry"
    if kind.zone == "circulation":
        wall = "circulation"
    elif kind.wet:
        wall = "wet"
    elif kind.finish == "concrete":
        wall = "industrial"
    floor_text, wall_text = chosen.floors[kind.finish], chosen.walls[wall]
    for wish in wishes or []:
        if wish.room_type not in ("", kind.name) or (not wish.room_type and kind.wet):
            continue
        if wish.surface == "floor":
            floor_text = wish.material
        else:
            wall_text = wish.material
    return floor_text, wall_text
