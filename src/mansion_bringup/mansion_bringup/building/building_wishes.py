"""Verdicts on wishes for the building as a whole: its kind, storeys, areas, outline, style, cores and occupants."""

import re
from collections.abc import Mapping
from typing import Final

from mansion_bringup.building.judged_building import JudgedBuilding
from mansion_bringup.building.verdicts import BOUNDS, Judge, Verdict, comma_separated, keeps_to, met_if
from mansion_knowledge import default_knowledge
from mansion_knowledge.places import places_of, use_of
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.wishes import AREA_TOLERANCE, Wish
from mansion_msgs_py.wording import in_words

__all__ = ["BUILDING_JUDGES"]


def _building_type(wish: Wish, state: JudgedBuilding) -> Verdict:
    kind = wish.value.type or wish.value.name
    if state.program.kind != kind:
        return Verdict("not_met", f"planned as {in_words(state.program.kind)}")
    area = sum(floor.gross_floor_area for floor in state.program.floors)
    sized = wish.value.area is None or keeps_to(wish, area)
    bound = f"{BOUNDS[wish.value.limit]}{wish.value.area or 0.0:.0f} m2"
    return met_if(sized, f"the building has {area:.0f} m2, {bound} would be so", partly=True)


def _floors(wish: Wish, state: JudgedBuilding) -> Verdict:
    have = sum(floor.index >= 1 for floor in state.program.floors)
    return met_if(have == wish.value.count, f"the building has {have} above ground")


def _basements(wish: Wish, state: JudgedBuilding) -> Verdict:
    have = sum(floor.index < 1 for floor in state.program.floors)
    return met_if(have == wish.value.count, f"the building has {have}")


def _total_area(wish: Wish, state: JudgedBuilding) -> Verdict:
    wanted = wish.value.area or 0.0
    above = sum(floor.gross_floor_area for floor in state.program.floors if floor.index >= 1)
    whole = sum(floor.gross_floor_area for floor in state.program.floors)
    if wish.scope.floors:  # "without the basement"
        above = whole = sum(f.gross_floor_area for f in state.program.floors if f.index in wish.scope.floors)
    if wish.value.limit:
        return met_if(keeps_to(wish, above) or keeps_to(wish, whole), f"the building has {whole:.0f} m2")
    off = min(abs(above - wanted), abs(whole - wanted)) / max(wanted, 1.0)
    return met_if(off <= AREA_TOLERANCE, f"the building has {whole:.0f} m2", partly=off <= 2 * AREA_TOLERANCE)


def _floor_area(wish: Wish, state: JudgedBuilding) -> Verdict:
    wanted = wish.value.area or 0.0
    areas = sorted(floor.gross_floor_area for floor in state.program.floors if floor.index >= 1)
    have = areas[len(areas) // 2]
    if wish.value.limit:
        return met_if(keeps_to(wish, have), f"a storey has {have:.0f} m2")
    off = abs(have - wanted) / max(wanted, 1.0)
    return met_if(off <= AREA_TOLERANCE, f"a storey has {have:.0f} m2", partly=off <= 2 * AREA_TOLERANCE)


_TURNS = {"L": "LLLLLR", "U": "LLLLLLRR", "T": "LLLLRLLR", "H": "LLLLRRLLLLRR"}
"""Left and right turns of an outline that is walked counter-clockwise, from any corner."""


def _outline(wish: Wish, state: JudgedBuilding) -> Verdict:
    ground = next((floor for floor in state.program.floors if floor.index == 1), state.program.floors[0])
    turns, name = _turns(ground.outline), wish.value.name
    if name == "courtyard":
        return met_if(
            bool(ground.holes) or _same_turns(turns, _TURNS["U"]),
            f"the outline has {len(turns)} corners and no courtyard",
        )
    ok = not ground.holes and _same_turns(turns, _TURNS.get(name, "LLLL"))
    if name == "square" and ok:
        xs, ys = [x for x, _ in ground.outline], [y for _, y in ground.outline]
        ok = 0.9 <= (max(xs) - min(xs)) / max(max(ys) - min(ys), 0.1) <= 1.1
    others = [form for form, word in _TURNS.items() if _same_turns(turns, word)]
    return met_if(ok, f"the outline is {others[0]}-shaped" if others else f"the outline has {len(turns)} corners")


def _turns(ring: Ring) -> str:
    """Return how an outline turns at each corner; points on a straight line are not corners."""
    crosses = [
        (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
        for (ax, ay), (bx, by), (cx, cy) in zip([ring[-1], *ring[:-1]], ring, [*ring[1:], ring[0]], strict=True)
    ]
    return "".join("L" if cross > 0 else "R" for cross in crosses if abs(cross) > 1e-6)


def _same_turns(turns: str, word: str) -> bool:
    return len(turns) == len(word) and turns in word * 2


def _style(wish: Wish, state: JudgedBuilding) -> Verdict:
    return met_if(state.program.style == wish.value.name, f"the style is {in_words(state.program.style)}")


def _facade(wish: Wish, state: JudgedBuilding) -> Verdict:
    have = state.outside.facade
    return met_if(have == wish.value.name, f"the outer walls are {in_words(have)} all round")


def _roof(wish: Wish, state: JudgedBuilding) -> Verdict:
    """Judge a roof by what was decided of it; outlines that are no upright rectangles get flat ones."""
    outside, value = state.outside, wish.value
    if outside.roof not in ("", "flat") and not state.upright:
        return Verdict("not_met", "the roof is flat: the outline is not of right angles")
    form, covering = value.name in ("", outside.roof), value.type in ("", outside.covering)
    if form and covering:
        return Verdict("met")
    reason = f"the roof is {in_words(outside.roof)}" if not form else f"it is covered with {in_words(outside.covering)}"
    return Verdict("partly" if form and value.name else "not_met", reason)


def _grounds(wish: Wish, state: JudgedBuilding) -> Verdict:
    found = next((entry for entry in state.outside.grounds if entry.use == wish.value.name), None)
    if found is None:
        return Verdict("not_met", "nothing of the kind is on the plot")
    enough = wish.value.count is None or found.count >= wish.value.count
    return met_if(enough, f"there are {found.count} places", partly=True)


def _use(wish: Wish, state: JudgedBuilding) -> Verdict:
    words = rf"\b{re.escape(in_words(wish.value.name))}\b"
    uses = {floor.index: floor.requirement.split(":")[0] for floor in state.program.floors}
    missing = [floor for floor in wish.scope.floors if not re.search(words, uses.get(floor, ""))]
    ok = bool(wish.scope.floors) and not missing
    return met_if(
        ok, f"storey {comma_separated(missing)} has another use", partly=0 < len(missing) < len(wish.scope.floors)
    )


def _original(index: int, state: JudgedBuilding) -> int:
    """Return the storey that one repeats, through those that repeat another themselves."""
    copies = {floor.index: floor.copy for floor in state.program.floors}
    while (earlier := copies.get(index)) is not None:
        index = earlier
    return index


def _copy(wish: Wish, state: JudgedBuilding) -> Verdict:
    group = [floor for floor in state.program.floors if floor.index in wish.scope.floors]
    originals = {_original(floor.index, state) for floor in group}
    if len(group) < 2:
        return Verdict("not_met", "there are not two such storeys")
    return met_if(len(originals) == 1, "the storeys differ", partly=len(originals) < len(group))


def _core(wish: Wish, state: JudgedBuilding) -> Verdict:
    have = sum(core.type == wish.kind for core in state.program.vertical_connectivity.cores)
    noun = "stair" if wish.kind == "stair" else "lift"
    if wish.value.unwanted:
        return met_if(have == 0, f"the building has a {noun}: its storeys cannot be reached otherwise")
    if wish.value.count is None or have >= wish.value.count:
        storeys = sum(floor.index >= 1 for floor in state.program.floors)
        return met_if(have > 0, "one storey needs none" if storeys == 1 else f"there is no {noun}")
    return Verdict("partly" if have else "not_met", f"{have} of {wish.value.count} {noun}s have a place")


def _occupants(wish: Wish, state: JudgedBuilding) -> Verdict:
    count = wish.value.count or 1
    area = sum(room.area for room in state.rooms)
    if area < 2.0 * count:
        return Verdict("not_met", f"{area:.0f} m2 of rooms are little for {count} people")
    record = default_knowledge().buildings.get(state.program.kind)
    use = use_of(wish.value.name, record.family if record is not None else "")
    if state.planned or not use:
        return Verdict("met")
    have = sum(
        places_of(category, size[0], use)
        for room in state.rooms
        for category, looks in room.looks.items()
        for size, _ in looks
    )
    return met_if(have >= count, f"there are {have} places to {use}", partly=have > 0)


BUILDING_JUDGES: Final[Mapping[str, Judge]] = {
    "building_type": _building_type,
    "floors": _floors,
    "basements": _basements,
    "total_area": _total_area,
    "floor_area": _floor_area,
    "outline": _outline,
    "style": _style,
    "facade": _facade,
    "roof": _roof,
    "grounds": _grounds,
    "use": _use,
    "copy": _copy,
    "stair": _core,
    "elevator": _core,
    "occupants": _occupants,
}
"""For each kind of wish for the whole building, what judges it."""
