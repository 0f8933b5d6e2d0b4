"""A model for tests: reads the planner's prompts and answers them as a fair architect would."""

import json
import re
from typing import Any

import msgspec

from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wishes import Wish

__all__ = ["Architect", "piece_of", "statement"]

_MARKS = {
    "reading": "Read what the brief states",
    "numbers": "Work out what building",
    "materials": "Choose floor and wall materials",
    "program": "Program a complete building",
    "topology": "abstract connections of this floor",
    "seeds": "Place rooms within their parent",
    "objects": "Choose the furniture",
}


def prompt_of(request: dict[str, Any]) -> str:
    """Return the words of the opening question."""
    content = next(m["content"] for m in request["messages"] if m["role"] == "user")
    return content if isinstance(content, str) else str(content[0]["text"])


def piece_of(request: dict[str, Any]) -> str:
    """Return which piece a request asks for."""
    text = prompt_of(request)
    return next(piece for piece, mark in _MARKS.items() if mark in text)


def _json_after(text: str, label: str) -> Any:
    line = next(line for line in text.splitlines() if label in line)
    return json.loads(line.split(label, 1)[1].strip())


def statement(wish: Wish) -> dict[str, Any]:
    """Return a wish of the ledger as a model states it."""
    value = msgspec.to_builtins(wish.value)
    scope = {"floors": wish.scope.floors, "room": wish.scope.room, "each": wish.scope.each}
    several = wish.kind in ("room", "object") and wish.value.count is None
    return {"kind": wish.kind, "quote": wish.text, "value": value | {"several": several}, "scope": scope}


class Architect:
    """Answers from the rules' plan of the same brief, with words and materials of its own."""

    def __init__(self, plan: PlanReply) -> None:
        self.plan = plan

    def answer(self, request: dict[str, Any]) -> Any:
        """Return the answer as JSON-compatible values."""
        answers = {
            "reading": self.reading,
            "numbers": self.numbers,
            "materials": self.materials,
            "program": self.program,
            "topology": self.topology,
            "seeds": self.seeds,
        }
        return answers[piece_of(request)](prompt_of(request))

    def reading(self, text: str) -> Any:
        """Answer with the statements that the rules read in the plan's brief."""
        return {"language": "English", "statements": [statement(wish) for wish in self.plan.program.wishes]}

    def numbers(self, text: str) -> Any:
        """Answer with the numbers of the plan."""
        program = self.plan.program
        return {
            "reasoning": "as such buildings are",
            "building_type": program.building_type,
            "style": program.style,
            "floors": sum(floor.index >= 1 for floor in program.floors),
            "floor_area": program.floors[0].gross_floor_area,
        }

    def materials(self, text: str) -> Any:
        """Answer with one palette for all."""
        types = re.search(r"these room types: (.*)\.$", text, re.MULTILINE)
        assert types is not None
        return {
            "palette": [
                {"room_type": name, "floor_material": "porcelain tile, sand", "wall_material": "lime plaster, warm"}
                for name in types[1].split(", ")
            ]
        }

    def program(self, text: str) -> Any:
        """Answer with the rooms of the plan."""
        cores = _json_after(text, "Proposed cores: ")
        method = re.search(r"Vertical connection by rule: (\w+)", text)
        assert method is not None
        floors = []
        for floor in self.plan.program.floors:
            if floor.copy is not None:
                floors.append({"index": floor.index, "copy": floor.copy})
                continue
            rooms = [
                {
                    "id": room.id,
                    "area_estimate": room.area_estimate,
                    "floor_material": "polished porcelain tile, grey",
                    "wall_material": "painted plaster, off-white",
                    "notes": "",
                }
                for room in floor.rooms
            ]
            floors.append({"index": floor.index, "requirement": "as the brief says", "rooms": rooms})
        return {
            "reasoning": "plain",
            "vertical_connectivity": {"method": method[1], "cores": cores, "justification": "kept"},
            "floors": floors,
        }

    def topology(self, text: str) -> Any:
        """Answer with a star around the hub, or with the plan's graph where that is for the same floor."""
        number = re.search(r"^Floor (-?\d+),", text, re.MULTILINE)
        assert number is not None
        graph = next(t for t in self.plan.topologies if t.floor == int(number[1]))
        nodes = [
            {
                "id": n.id, "type": n.type, "area": n.area, "floor_material": "terrazzo, grey",
                "wall_material": "painted plaster, white", "open_relation": n.open_relation,
            }
            for n in graph.nodes
        ]  # fmt: skip
        edges = [{"source": e.source, "target": e.target, "kind": e.kind} for e in graph.edges]
        return {"nodes": nodes, "edges": edges}

    def seeds(self, text: str) -> Any:
        """Answer with the places that the plan's own sketch gives the rooms, cut to the parent's range."""
        targets = _json_after(text, "Rooms to place: ")
        span = re.search(r"within x from (\S+) to (\S+) and y from (\S+) to ([\d.]+);", text)
        assert span is not None
        x0, x1, y0, y1 = (float(v.rstrip(".")) for v in span.groups())
        boxes = []
        known = {n.id: n.seed_box for problem in self.plan.problems for n in problem.nodes if n.seed_box}
        for k, target in enumerate(targets):
            box = known.get(target["id"])
            wide = (x1 - x0) / len(targets)
            x = list(box.x) if box else [x0 + k * wide, x0 + (k + 1) * wide]
            y = list(box.y) if box else [y0, y1]
            boxes.append({"room_id": target["id"], "x": x, "y": y, "area": target["share_of_parent"], "reason": "fits"})
        return {"boxes": boxes}
