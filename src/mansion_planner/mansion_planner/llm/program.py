"""Ask a model for the program of the building (Fig. 23), and check each floor against the brief and the rules."""

import dataclasses

import msgspec
import numpy as np
import shapely
from shapely.geometry import Polygon

from mansion_knowledge import KnowledgeBase
from mansion_llm import Fault, Prompt, quoted_data
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.wording import with_article
from mansion_planner.brief.facts import RoomFact
from mansion_planner.llm.answers import FloorAnswer, ProgramAnswer, RoomAnswer
from mansion_planner.llm.cleaning import clean_id, clean_text, is_core_name, material_fault, room_kind, without_number
from mansion_planner.llm.context import ARCHITECT, CLOSING, Context, as_json, number
from mansion_planner.llm.cores import core_faults, core_sizes, cores_of, same_cores
from mansion_planner.llm.palette import Palette
from mansion_planner.llm.refit import ChosenFloor, ChosenRoom, chosen_of_storey, refit, with_cores
from mansion_planner.program.allocation import allocate
from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.storeys import floors_of, make_storeys
from mansion_planner.solver.preview import png_bytes

__all__ = ["MOST_ROOMS", "plan_model_program"]


_SIZE = 320


_MARGIN = 8


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


MOST_ROOMS = 40


def plan_model_program(context: Context, reference: PlannedBuilding, palette: Palette) -> tuple[PlannedBuilding, bool]:
    """Return the plan of the model's rooms and cores in the reference's outline, and whether its cores moved."""
    offline = [
        chosen_of_storey(storey, floor.rooms[0].area_estimate)
        for storey, floor in zip(reference.storeys, reference.program.floors)
    ]
    if not context.client.wants("program"):
        context.from_rules("program")
        return refit(reference, offline, palette), False
    reader = _Reader(context, reference, palette, offline)
    prompt = _program_prompt(context, reference, palette)
    answer = context.client.ask(prompt, ProgramAnswer, reader.faults)
    if answer.value is None:
        context.from_rules("program", answer.reason)
        return refit(reference, offline, palette), False
    faulty = answer.faulty_pieces()
    floors = reader.settled(answer.value, faulty)
    reasons = {fault.piece: fault.text for fault in reversed(answer.faults)}
    for floor in floors:
        piece = _floor_piece(floor.index)
        if floor.index in reader.replaced:
            context.from_rules(piece, reasons.get(piece, reasons.get("program", "the building lacks a stated room")))
        else:
            context.from_model(piece)
    planned, moved = reference, False
    cores = answer.value.vertical_connectivity
    if "cores" in faulty:
        context.from_rules("cores", reasons["cores"])
    else:
        context.from_model("cores")
        if not same_cores(cores.cores, reference.program.vertical_connectivity.cores):
            planned = with_cores(reference, cores_of(cores), cores.method, cores.justification[:240])
            moved = True
    fitted = refit(planned, floors, palette, placed=not moved)
    if len(reader.replaced) < len(floors):
        reasoning = clean_text(answer.value.reasoning) or fitted.program.reasoning
        fitted = dataclasses.replace(fitted, program=msgspec.structs.replace(fitted.program, reasoning=reasoning))
    return fitted, moved


class _Reader:
    """Reads answers to the program's prompt and finds their faults."""

    def __init__(
        self, context: Context, reference: PlannedBuilding, palette: Palette, offline: list[ChosenFloor]
    ) -> None:
        self.context, self.reference, self.palette = context, reference, palette
        self.offline = {floor.index: floor for floor in offline}
        self.replaced: set[int] = set()
        decisions, knowledge = reference.decisions, context.knowledge
        storeys, _ = make_storeys(decisions, knowledge)
        allocation, _ = allocate(decisions, knowledge, storeys)
        self.wanted = allocation.wanted

    def faults(self, answer: ProgramAnswer) -> list[Fault]:
        """Return everything that is wrong with an answer."""
        found = core_faults(answer.vertical_connectivity, self.reference)
        floors, faults = self._read(answer)
        found += faults
        for index in self.offline:
            if index not in floors:
                if not any(fault.piece == _floor_piece(index) for fault in faults):
                    found.append(Fault(f"floor {index} is missing", _floor_piece(index)))
            elif floors[index].copy is None:
                found += self._stated_faults(floors[index])
        found += self._building_faults(floors)
        if not found:
            found += self._fit_faults([floors[index] for index in self.offline])
        return found

    def settled(self, answer: ProgramAnswer, faulty: set[str]) -> list[ChosenFloor]:
        """Return a floor for each storey: the model's where it is faultless, else the offline planner's."""
        floors, _ = self._read(answer)
        whole = "program" in faulty
        for index in self.offline:
            if whole or _floor_piece(index) in faulty or index not in floors:
                self.replaced.add(index)
        for index, floor in sorted(floors.items()):
            if floor.copy in self.replaced:
                self.replaced.add(index)
        return [self._own(index) if index in self.replaced else floors[index] for index in self.offline]

    def _own(self, index: int) -> ChosenFloor:
        """Return the offline floor; one that repeats a floor of the model gets rooms of its own."""
        floor = self.offline[index]
        if floor.copy is not None and floor.copy not in self.replaced:
            return dataclasses.replace(floor, copy=None)
        return floor

    def _read(self, answer: ProgramAnswer) -> tuple[dict[int, ChosenFloor], list[Fault]]:
        floors: dict[int, ChosenFloor] = {}
        faults: list[Fault] = []
        for entry in answer.floors:
            piece = _floor_piece(entry.index)
            if entry.index not in self.offline:
                faults.append(Fault(f"there is no floor {entry.index}; leave it out", "extra"))
            elif entry.index in floors:
                faults.append(Fault(f"floor {entry.index} is listed twice", piece))
            elif entry.copy is not None:
                copied = self._copy(entry, floors)
                if copied is None:
                    what = (
                        f"floor {entry.index} cannot copy floor {entry.copy}: that must be an earlier floor of "
                        "the same outline and use"
                    )
                    faults.append(Fault(what, piece))
                else:
                    floors[entry.index] = copied
            else:
                floor, wrong = _read_floor(entry, self.context, self.reference)
                faults += wrong + self._area_faults(entry)
                if floor is not None:
                    floors[entry.index] = self._marked(floor)
        return floors, faults

    def _area_faults(self, entry: FloorAnswer) -> list[Fault]:
        """Hold a floor's rooms against its gross area and the reserve of 12 to 25 percent."""
        gross = {f.index: f.gross_floor_area for f in self.reference.program.floors}[entry.index]
        total = sum(room.area_estimate for room in entry.rooms)
        text = ""
        if total > 1.001 * gross:
            text = f"the rooms add up to {total:.0f} m2 of {gross:.0f} m2 gross"
        elif total > 0.885 * gross and not entry.reserve_justification:
            text = f"{1 - total / gross:.0%} is in reserve; leave 12% to 25%, or justify it"
        return [Fault(f"floor {entry.index}: {text}", _floor_piece(entry.index))] if text else []

    def _copy(self, entry: FloorAnswer, floors: dict[int, ChosenFloor]) -> ChosenFloor | None:
        storeys = {storey.index: storey for storey in self.reference.storeys}
        source = floors.get(entry.copy) if entry.copy is not None else None
        if source is None or source.copy is not None:
            return None
        mine, other = storeys[entry.index], storeys[source.index]
        if (mine.role in ("ground", "basement")) != (other.role in ("ground", "basement")):
            return None
        if (mine.setback, mine.extension) != (other.setback, other.extension):
            return None
        return dataclasses.replace(source, index=entry.index, copy=source.index)

    def _marked(self, floor: ChosenFloor) -> ChosenFloor:
        """Fix the areas that the brief states, and name rooms in its words."""
        left = [fact for fact in self.wanted[floor.index] if fact.area is not None]
        rooms = []
        for room in floor.rooms:
            fact = next((f for f in left if _is_of(room, f, self.context.knowledge)), None)
            if fact is not None and fact.area is not None and abs(room.area - fact.area) <= 0.05 * fact.area:
                left.remove(fact)
                room = dataclasses.replace(room, area=fact.area, fixed=True)
            rooms.append(self._labelled(room))
        return dataclasses.replace(floor, rooms=tuple(rooms))

    def _labelled(self, room: ChosenRoom) -> ChosenRoom:
        """Give a room that is called as the brief calls one the words of the brief."""
        base = without_number(room.id)
        facts = self.reference.decisions.facts.rooms
        fact = next((f for top in facts for f in (top, *top.suite) if f.name in (room.id, base)), None)
        if fact is None:
            return dataclasses.replace(room, base=base)
        return dataclasses.replace(room, base=fact.name, label=fact.label, stated=True)

    def _stated_faults(self, floor: ChosenFloor) -> list[Fault]:
        """Return what a floor lacks that the brief puts there, and what it has that the brief excludes."""
        piece, out = _floor_piece(floor.index), []
        excluded = dict(self.reference.decisions.facts.excluded)
        out += [f"{room.id} is not wanted by the brief" for room in floor.rooms if room.kind.name in excluded]
        pinned = [fact for fact in self.wanted[floor.index] if fact.floors or fact.each]
        for fact in _distinct(pinned):
            need = pinned.count(fact)
            have = [room for room in (floor.hub, *floor.rooms) if _is_of(room, fact, self.context.knowledge)]
            if len(have) < need:
                out.append(f"the brief puts {need} x {fact.name} here, and there are {len(have)}")
            elif fact.area is not None and not any(abs(r.area - fact.area) <= 0.05 * fact.area for r in have):
                out.append(f"{fact.name} must have {fact.area:g} m2, as the brief states")
        return [Fault(f"floor {floor.index}: {text}", piece) for text in out]

    def _building_faults(self, floors: dict[int, ChosenFloor]) -> list[Fault]:
        """Return what the whole building lacks, and floors that the brief wants identical and are not."""
        facts, out = self.reference.decisions.facts, []
        loose = [fact for rooms in self.wanted.values() for fact in rooms if not (fact.floors or fact.each)]
        for fact in _distinct(loose):
            need = loose.count(fact)
            have = sum(
                _is_of(room, fact, self.context.knowledge)
                and (fact.area is None or abs(room.area - fact.area) <= 0.05 * fact.area)
                for floor in floors.values()
                for room in (floor.hub, *floor.rooms)
            )
            exact = fact.count is not None and fact.count > 1 and fact.area is None
            if have < need or (exact and have > need and fact.room_type == fact.name):
                size = f" of {fact.area:g} m2" if fact.area is not None else ""
                out.append(f"the brief asks for {need} x {fact.name}{size}; the building has {have}")
        for repeat in facts.copies:
            group = [i for i in floors_of((repeat.first,), self.reference.decisions) if i in floors]
            if any(floors[i].copy != group[0] for i in group[1:]):
                out.append(f'floors {group} are to be identical: use "copy": {group[0]}')
        return [Fault(text, "program") for text in out]

    def _fit_faults(self, floors: list[ChosenFloor]) -> list[Fault]:
        """Lay the rooms out and return what does not fit."""
        fitted = refit(self.reference, floors, self.palette)
        out = []
        for floor, storey in zip(floors, fitted.storeys):
            if floor.copy is not None:
                continue
            asked = sum(room.area for room in floor.rooms)
            placed = {p.room.id: p.area for p in fitted.sketches[storey.index].rooms}
            room_for = sum(placed.values())
            missing = [room.id for room in floor.rooms if room.id not in placed]
            small = [r.id for r in floor.rooms if placed.get(r.id, 99.0) < 0.75 * min(r.kind.least, r.area)]
            text = ""
            if asked > 1.25 * room_for or small or missing:
                text = f"the rooms ask for {asked:.0f} m2, and there is place for {room_for:.0f} m2"
            elif asked < 0.6 * room_for:
                text = f"the rooms take {asked:.0f} m2 of {room_for:.0f} m2; add rooms or enlarge them"
            if text:
                out.append(Fault(f"floor {floor.index}: {text}", _floor_piece(floor.index)))
        return out


def _outline_picture(outline: Polygon, cores: list[CorePlan]) -> bytes:
    """Return a plan, y up: the floor white on grey, its edge dark, stairs red, lifts blue.

    Examples
    --------
    >>> _outline_picture(Polygon([(0, 0), (9, 0), (9, 6), (0, 6)]), [])[1:4]
    b'PNG'
    """
    x0, y0, x1, y1 = outline.bounds
    scale = (_SIZE - 2 * _MARGIN) / max(x1 - x0, y1 - y0)
    columns = int((x1 - x0) * scale) + 2 * _MARGIN
    rows = int((y1 - y0) * scale) + 2 * _MARGIN
    xs = x0 + (np.arange(columns) - _MARGIN + 0.5) / scale
    ys = y1 - (np.arange(rows) - _MARGIN + 0.5) / scale
    grid_x, grid_y = np.meshgrid(xs, ys)
    inside = shapely.contains_xy(outline, grid_x, grid_y)
    pixels = np.full((rows, columns, 3), 170, np.uint8)
    pixels[inside] = 255
    for core in cores:
        box = (grid_x > core.x[0]) & (grid_x < core.x[1]) & (grid_y > core.y[0]) & (grid_y < core.y[1])
        pixels[box & inside] = (205, 70, 60) if core.type == "stair" else (60, 90, 205)
    edge = np.zeros_like(inside)
    edge[1:] |= inside[1:] != inside[:-1]
    edge[:, 1:] |= inside[:, 1:] != inside[:, :-1]
    pixels[edge] = 20
    return png_bytes(pixels)


def _program_prompt(context: Context, reference: PlannedBuilding, palette: Palette) -> Prompt:
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
        "What the brief was read to state; use its names as ids:",
        quoted_data("statements", _statements(reference)),
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
    picture = _outline_picture(Polygon(ground.outline, ground.holes), vertical.cores)
    return Prompt("building_program", ARCHITECT, "\n".join(lines), (picture,))


def _statements(reference: PlannedBuilding) -> str:
    """Return the statements that were read in the brief, one a line, without its own words."""
    return "\n".join(
        as_json({"kind": wish.kind, "value": wish.value, "scope": wish.scope})
        for wish in reference.program.wishes
        if wish.kind != "unread"
    )


def _floor_piece(index: int) -> str:
    """Return the name of a floor's program among the pieces."""
    return f"program/F{index}"


def _read_floor(
    answer: FloorAnswer, context: Context, planned: PlannedBuilding
) -> tuple[ChosenFloor | None, list[Fault]]:
    """Return a floor's rooms, and what is wrong with them apart from the rest of the building.

    Corridors and cores among the rooms are passed over: they come out of the reserve.
    """
    piece = _floor_piece(answer.index)
    faults: list[str] = []
    known = {fact.name: fact.room_type for fact in planned.decisions.facts.rooms}
    rooms: list[ChosenRoom] = []
    for place, entry in enumerate(answer.rooms):
        room, wrong = _room(entry, context, known, first=place == 0)
        faults += wrong
        if room is not None:
            rooms.append(room)
    if not rooms or not answer.rooms or clean_id(answer.rooms[0].id) != rooms[0].id:
        faults.append("rooms must begin with the circulation hub")
        return None, [Fault(f"floor {answer.index}: {text}", piece) for text in faults]
    own = next(storey for storey in planned.storeys if storey.index == answer.index)
    if len(rooms) < 2 and own.rooms:
        faults.append("a floor needs rooms besides its hub")
    if len(rooms) > MOST_ROOMS:
        faults.append(f"{len(rooms)} rooms are too many; at most {MOST_ROOMS}")
    ids = [room.id for room in rooms]
    repeated = sorted({name for name in ids if ids.count(name) > 1})
    if repeated:
        faults.append(f"the id {', '.join(repeated)} is used more than once")
    hub = rooms[0]
    if hub.kind.wet or (hub.kind.zone in ("private", "service") and hub.kind.name != "living_room"):
        faults.append(f"{hub.id} cannot be the circulation hub; use a lobby, hall, corridor or main room")
    floor = ChosenFloor(
        index=answer.index,
        hub=dataclasses.replace(hub, id=hub.kind.name),
        rooms=_with_suites(_apart_from(hub.kind.name, rooms[1:])),
        requirement=clean_text(answer.requirement, 240),
    )
    return floor, [Fault(f"floor {answer.index}: {text}", piece) for text in faults]


def _room(
    entry: RoomAnswer, context: Context, known: dict[str, str], *, first: bool
) -> tuple[ChosenRoom | None, list[str]]:
    """Return a room, none where it is unreadable or taken from the reserve, and what is wrong with it."""
    name = clean_id(entry.id)
    if not name:
        return None, [f"{clean_text(entry.id, 40)!r} is no id; use lower-case letters, digits and _"]
    if is_core_name(name):
        return None, []
    kind = room_kind(name, context.knowledge, known)
    if kind.zone == "circulation" and not first:
        return None, []
    if not 0.5 <= entry.area_estimate <= 5000.0:
        return None, [f"area_estimate of {name} is {entry.area_estimate:g}; it must be a positive area in m2"]
    faults: list[str] = []
    if entry.area_estimate < 0.8 * kind.least and not first:
        faults.append(f"{name} has {entry.area_estimate:g} m2; {with_article(kind.name)} needs at least {kind.least:g}")
    for text, is_floor in ((entry.floor_material, True), (entry.wall_material, False)):
        fault = material_fault(text, kind, floor=is_floor)
        if fault:
            faults.append(f"{name}: {fault}")
    room = ChosenRoom(
        id=name,
        kind=kind,
        area=float(entry.area_estimate),
        floor_material=entry.floor_material,
        wall_material=entry.wall_material,
        notes=clean_text(entry.notes, 120),
    )
    return room, faults


def _apart_from(hub: str, rooms: list[ChosenRoom]) -> list[ChosenRoom]:
    """Rename a room that is called as the hub will be."""
    names = {room.id for room in rooms}
    out = []
    for room in rooms:
        name, number = room.id, 2
        while name == hub or (name != room.id and name in names):
            name, number = f"{room.id}_{number}", number + 1
        out.append(dataclasses.replace(room, id=name))
    return out


def _with_suites(rooms: list[ChosenRoom]) -> tuple[ChosenRoom, ...]:
    """Hang wet rooms and closets that are named after a room (``bedroom_1_bathroom``) on it."""
    names = [room.id for room in rooms]
    out = []
    for room in rooms:
        owners = [n for n in names if n != room.id and room.id.startswith(n + "_")]
        suits = room.kind.wet or room.kind.zone == "service"
        suffix = room.id[len(max(owners, key=len)) + 1 :] if owners else ""
        owner = max(owners, key=len) if owners and suits and not suffix.isdigit() else ""
        out.append(dataclasses.replace(room, suite_of=owner))
    return tuple(out)


def _distinct(facts: list[RoomFact]) -> list[RoomFact]:
    return list(dict.fromkeys(facts))


def _is_of(room: ChosenRoom, fact: RoomFact, knowledge: KnowledgeBase) -> bool:
    """Whether a room is what a fact asks for."""
    if room.kind.name == fact.room_type or room.id.startswith(fact.name):
        return True
    return room.kind.counts_as == knowledge.room(fact.room_type).counts_as
