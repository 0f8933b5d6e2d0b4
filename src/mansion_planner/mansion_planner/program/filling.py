"""Fill a storey with rooms up to what it can hold, and settle their areas."""

from mansion_knowledge import KnowledgeBase
from mansion_planner.program.allocation import Allocation, planned_room
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.storeys import entries_of

__all__ = ["base_rooms", "fill_storey", "fit_areas", "hub_area", "name_rooms"]

MOST_ROOMS = 34

_GENERAL = {
    "home": ("home_office", "library_room", "playroom", "game_room", "storage", "laundry_room"),
    "office": ("team_room", "meeting_room", "lounge", "training_room", "archive", "private_office"),
    "education": ("study_room", "computer_lab", "art_room", "common_room", "meeting_room"),
    "health": ("treatment_room", "lounge", "meeting_room", "private_office", "storage"),
    "culture": ("lounge", "training_room", "cafe", "study_room", "meeting_room", "archive"),
    "lodging": ("lounge", "common_room", "laundry_room", "study_room", "gym", "storage"),
    "industry": ("storage", "workshop", "private_office", "meeting_room", "archive"),
    "retail": ("stock_room", "shop", "lounge", "private_office", "break_room"),
    "civic": ("meeting_room", "lounge", "private_office", "training_room", "storage", "common_room"),
}


def base_rooms(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase) -> list[PlannedRoom]:
    """Return the rooms that the brief asks for on a storey, as rooms to be placed."""
    rooms = []
    for fact in allocation.wanted[storey.index]:
        if fact.room_type == storey.hub.name and fact.count == 1:
            continue
        rooms.append(planned_room(knowledge.room(fact.room_type), knowledge, fact=fact))
    return rooms


def hub_area(storey: Storey, allocation: Allocation) -> float:
    """Return the area that the brief states for the room that is a storey's hub, or 0."""
    areas = [f.area for f in allocation.wanted[storey.index] if f.room_type == storey.hub.name and f.area]
    return max(areas, default=0.0)


def fill_storey(
    storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, capacity: float, *, hub_share: float = 0.0
) -> list[PlannedRoom]:
    """Choose a storey's rooms: those asked for, then its type's list by priority, then what may repeat.

    Parameters
    ----------
    capacity : float
        Area for rooms, square metres.
    hub_share : float
        Area that the hub takes of it, where the hub is the main room.
    """
    rooms = base_rooms(storey, allocation, knowledge)
    present = {fact.room_type for fact in allocation.wanted[storey.index]}
    budget = capacity - hub_share
    used = sum(room.gross for room in rooms)
    repeats = []
    for entry in entries_of(storey):
        kind = knowledge.room(entry.room_type)
        if entry.repeat:
            repeats.append(entry)
        if not allocation.adds(kind.name, storey.index) or kind.name == storey.hub.name:
            continue
        count = 0 if entry.repeat else max(entry.count - (kind.name in present), 0)
        for _ in range(count):
            room = planned_room(kind, knowledge, area=entry.area)
            small = min(room.gross, room.gross * 0.5 + 0.5 * kind.least)
            if used + small <= budget * 1.03 or (not rooms and used + kind.least <= budget):
                rooms.append(room)
                used += room.gross
    for entry in repeats:
        kind = knowledge.room(entry.room_type)
        while allocation.adds(kind.name, storey.index) and len(rooms) < MOST_ROOMS:
            room = planned_room(kind, knowledge, area=entry.area)
            if used + 0.72 * room.gross > budget:
                break
            rooms.append(room)
            used += room.gross
    _top_up(storey, allocation, knowledge, rooms, budget)
    return rooms


def _top_up(
    storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, rooms: list[PlannedRoom], budget: float
) -> None:
    """Add rooms of general use where the brief settles the number of those that would fill the storey."""
    kinds = [knowledge.room(name) for name in _GENERAL.get(storey.use.family, _GENERAL["civic"])]
    kinds = [kind for kind in kinds if allocation.adds(kind.name, storey.index)]
    for kind in kinds * 3:
        used = sum(room.gross for room in rooms)
        if used >= 0.82 * budget or len(rooms) >= MOST_ROOMS:
            return
        if used + 0.8 * kind.usual <= budget:
            rooms.append(planned_room(kind, knowledge))


def fit_areas(rooms: list[PlannedRoom], capacity: float) -> float:
    """Scale the rooms to fill `capacity`: stated areas stay, flexible rooms give and take first.

    Returns
    -------
    float
        Area that is left when every room is at its limit (negative when they do not fit).
    """
    every = [room for top in rooms for room in top.each()]
    fixed = sum(room.area for room in every if room.fixed)
    loose = [room for room in every if not room.fixed]
    spare = capacity - fixed
    for limited in (True, False):
        for _ in range(6):
            total = sum(room.area for room in loose)
            if not loose or total <= 0 or abs(total - spare) < 0.01:
                break
            _scale(loose, spare / total, limited=limited)
    return capacity - sum(room.area for room in every)


def _scale(rooms: list[PlannedRoom], factor: float, *, limited: bool) -> None:
    for room in rooms:
        strength = factor if not room.kind.flexible or factor < 1.0 else factor * 1.05
        if limited:
            room.area = min(max(room.area * strength, room.least), room.most)
        else:
            room.area = max(room.area * factor, 1.0)


_CIRCULATION = frozenset({"corridor", "wing", "far", "stair", "elevator"})


def name_rooms(storey: Storey, hub_id: str) -> None:
    """Number the rooms of a storey: ``meeting_room_1``; a name that occurs once stays bare.

    No room takes the name of the hub, of a corridor that the sketch adds, or of a core.
    """
    counts: dict[str, int] = {}
    every = [room for top in storey.rooms for room in top.each()]
    for room in every:
        if room.id in _CIRCULATION:
            room.id = f"{room.id}_area"
        counts[room.id] = counts.get(room.id, 0) + 1
    used = {hub_id} | {name for name, count in counts.items() if count == 1 and name != hub_id}
    seen: dict[str, int] = {}
    for room in every:
        base = room.id
        if counts[base] == 1 and base != hub_id:
            continue
        while room.id == base or room.id in used:
            seen[base] = seen.get(base, 0) + 1
            room.id = f"{base}_{seen[base]}"
        used.add(room.id)
