"""Read a German brief with a language model, and let the rules read what a weaker one leaves out of an English brief.

.venv/bin/python examples/model_reads.py

The answers of the model are written below, so that neither an endpoint nor the network is needed.
"""

import json
from typing import Any

from mansion_knowledge import default_knowledge
from mansion_llm import LlmClient, LlmSettings
from mansion_llm.prompt import Message
from mansion_llm.transport import ChatReply
from mansion_msgs_py.request import BuildRequest
from mansion_planner.llm.planner import plan_with_model

GERMAN = "Ein zweistöckiges Haus mit drei Schlafzimmern und einer Küche neben dem Esszimmer"
GERMAN_STATEMENTS = [
    {"kind": "floors", "quote": "zweistöckiges", "value": {"count": 2}},
    {"kind": "building_type", "quote": "Haus", "value": {"name": "house", "type": "house"}},
    {"kind": "room", "quote": "drei Schlafzimmern", "value": {"name": "bedroom", "type": "bedroom", "count": 3}},
    {
        "kind": "adjacent", "quote": "einer Küche neben dem Esszimmer",
        "value": {"name": "kitchen", "other": "dining_room"},
    },
]  # fmt: skip

ENGLISH = "A two-storey house with three bedrooms and a sauna, but no basement"
ENGLISH_STATEMENTS = [
    {"kind": "floors", "quote": "two-storey", "value": {"count": 2}},
    {"kind": "room", "quote": "a sauna", "value": {"name": "sauna", "type": "sauna", "count": 1}},
]


class ScriptedModel:
    """A model that answers every question with one value."""

    def __init__(self, answer: dict[str, Any]) -> None:
        self.answer = answer

    def complete(self, messages: list[Message], response_format: dict[str, Any] | None) -> ChatReply:
        """Return the answer, whatever is asked."""
        return ChatReply(json.dumps(self.answer))


def show(brief: str, answer: dict[str, Any]) -> None:
    """Plan a brief from a model's reading, and print every wish with its reader."""
    settings = LlmSettings(base_url="http://127.0.0.1:1/v1", model="scripted", pieces=("reading",))
    client = LlmClient(settings, transport=ScriptedModel(answer))
    request = BuildRequest(description=brief, planner="llm")
    plan = plan_with_model(request, default_knowledge(), "example", client)
    print(brief)
    for wish in plan.program.wishes:
        print(f"  {wish.read_by}: {wish.kind} from {wish.text!r}")
    rooms = [room.id for floor in plan.program.floors for room in floor.rooms]
    print(f"  {len(plan.program.floors)} floors: {', '.join(rooms)}")


def main() -> None:
    """Print both readings."""
    show(GERMAN, {"language": "German", "statements": GERMAN_STATEMENTS})
    show(ENGLISH, {"language": "English", "statements": ENGLISH_STATEMENTS})


if __name__ == "__main__":
    main()
