"""Materials of a room from the building's style."""

from mansion_planner.knowledge import KnowledgeBase, RoomType

__all__ = ["materials_of"]


def materials_of(kind: RoomType, style: str, knowledge: KnowledgeBase) -> tuple[str, str]:
    """Return the floor and the wall material of a room type in a style.

    Examples
    --------
    >>> from mansion_planner.knowledge import default_knowledge
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
    return chosen.floors[kind.finish], chosen.walls[wall]
