"""Read what an agent asked, and answer with a script."""

import base64
import json
from collections.abc import Callable
from typing import Any

__all__ = ["pictures", "question", "says", "text"]


def text(request: dict[str, Any]) -> str:
    """Return all words of a request."""
    parts = []
    for message in request["messages"]:
        content = message["content"]
        parts += [content] if isinstance(content, str) else [p.get("text", "") for p in content]
    return "\n".join(parts)


def question(request: dict[str, Any]) -> str:
    """Return the name of the prompt."""
    return str(request["response_format"]["json_schema"]["name"])


def pictures(request: dict[str, Any]) -> list[bytes]:
    """Return the pictures of a request, from their data URLs."""
    found = []
    for message in request["messages"]:
        for part in message["content"] if isinstance(message["content"], list) else []:
            if part["type"] == "image_url":
                head, data = part["image_url"]["url"].split(",", 1)
                assert head == "data:image/png;base64"
                found.append(base64.b64decode(data))
    return found


def says(reply: Callable[[str], Any], **fields: Any) -> Any:
    """Return a reply with a JSON object."""
    return reply(json.dumps(fields))
