"""Read desks that are counted as places to work, "30 hot desks", as one area with so many desks."""

from dataclasses import replace

from mansion_planner.brief.facts import BriefFacts, ObjectFact

__all__ = ["read_desk_areas"]

_PLACES = frozenset({"desk", "workstation", "workplace"})


def read_desk_areas(facts: BriefFacts) -> None:
    """Replace several rooms that are called desks by one area on each storey that is meant, and its desks."""
    for number, room in enumerate(facts.rooms):
        if room.name.rpartition("_")[2] not in _PLACES or room.count == 1:
            continue
        name = f"{room.name}_area"
        facts.rooms[number] = replace(room, name=name, label=f"{room.label} area", count=1, suite=())
        facts.objects.append(
            ObjectFact(
                words=room.span.words,
                category="desk",
                span=room.span,
                count=room.count,
                room=name,
                room_type=room.room_type,
                each=room.each,
                floors=room.floors,
                noun=room.label,
            )
        )
