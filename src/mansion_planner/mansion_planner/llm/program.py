"""The program of the whole building by a model (Fig. 23), floor by floor checked against the brief and the rules."""

import dataclasses

from mansion_llm import Fault
from mansion_planner.brief.facts import RoomFact
from mansion_planner.llm.answers import FloorAnswer, ProgramAnswer
from mansion_planner.llm.chosen import ChosenFloor, ChosenRoom, chosen_of_storey
from mansion_planner.llm.cleaning import clean_text
from mansion_planner.llm.context import Context
from mansion_planner.llm.cores import core_faults, cores_of, same_cores
from mansion_planner.llm.palette import Palette
from mansion_planner.llm.program_prompt import program_prompt
from mansion_planner.llm.reading import floor_piece, read_floor
from mansion_planner.llm.refit import refit, with_cores
from mansion_planner.program.allocation import allocate
from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.storeys import floors_of, make_storeys

__all__ = ["plan_model_program"]

_KIN = (
    {"bedroom", "master_bedroom", "guest_room", "childrens_room"},
    {"kitchen", "open_kitchen", "kitchen_diner"},
    {"apartment", "small_apartment", "studio_apartment"},
    {"bathroom", "family_bathroom", "shower_room"},
)


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
    prompt = program_prompt(context, reference, palette)
    answer = context.client.ask(prompt, ProgramAnswer, reader.faults)
    if answer.value is None:
        context.from_rules("program", answer.reason)
        return refit(reference, offline, palette), False
    faulty = answer.faulty_pieces()
    floors = reader.settled(answer.value, faulty)
    reasons = {fault.piece: fault.text for fault in reversed(answer.faults)}
    for floor in floors:
        piece = floor_piece(floor.index)
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
        fitted.program.reasoning = clean_text(answer.value.reasoning) or fitted.program.reasoning
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
        # Allocation notes what it does; the trace of the plan has these notes already.
        quiet = dataclasses.replace(decisions, trace=[], downgrades=[])
        self.wanted = allocate(quiet, knowledge, make_storeys(quiet, knowledge)).wanted

    def faults(self, answer: ProgramAnswer) -> list[Fault]:
        """Return everything that is wrong with an answer."""
        found = core_faults(answer.vertical_connectivity, self.reference)
        floors, faults = self._read(answer)
        found += faults
        for index in self.offline:
            if index not in floors:
                if not any(fault.piece == floor_piece(index) for fault in faults):
                    found.append(Fault(f"floor {index} is missing", floor_piece(index)))
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
            if whole or floor_piece(index) in faulty or index not in floors:
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
            piece = floor_piece(entry.index)
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
                floor, wrong = read_floor(entry, self.context, self.reference)
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
        return [Fault(f"floor {entry.index}: {text}", floor_piece(entry.index))] if text else []

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
        """Fix the areas that the brief states."""
        left = [fact for fact in self.wanted[floor.index] if fact.area is not None]
        rooms = []
        for room in floor.rooms:
            fact = next((f for f in left if _is_of(room, f)), None)
            if fact is not None and fact.area is not None and abs(room.area - fact.area) <= 0.05 * fact.area:
                left.remove(fact)
                room = dataclasses.replace(room, area=fact.area, fixed=True)
            rooms.append(room)
        return dataclasses.replace(floor, rooms=tuple(rooms))

    def _stated_faults(self, floor: ChosenFloor) -> list[Fault]:
        """Return what a floor lacks that the brief puts there, and what it has that the brief excludes."""
        piece, out = floor_piece(floor.index), []
        excluded = dict(self.reference.decisions.facts.excluded)
        out += [f"{room.id} is not wanted by the brief" for room in floor.rooms if room.kind.name in excluded]
        pinned = [fact for fact in self.wanted[floor.index] if fact.floors or fact.each]
        for fact in _distinct(pinned):
            need = pinned.count(fact)
            have = [room for room in (floor.hub, *floor.rooms) if _is_of(room, fact)]
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
                _is_of(room, fact) and (fact.area is None or abs(room.area - fact.area) <= 0.05 * fact.area)
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
                out.append(Fault(f"floor {floor.index}: {text}", floor_piece(floor.index)))
        return out


def _distinct(facts: list[RoomFact]) -> list[RoomFact]:
    return list(dict.fromkeys(facts))


def _is_of(room: ChosenRoom, fact: RoomFact) -> bool:
    """Whether a room is what a fact asks for."""
    if room.kind.name == fact.room_type or room.id.startswith(fact.name):
        return True
    return any(fact.room_type in kin and room.kind.name in kin for kin in _KIN)
