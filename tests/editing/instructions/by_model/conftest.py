"""A model on loopback that reads instructions as a test tells it to, and the editor that it reads for."""

import importlib.util
import json
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.by_model.carrying_out import carry_out_with_model
from mansion_llm import LlmClient, LlmSettings
from mansion_llm.secret import Secret
from mansion_msgs_py.editing.instructions import AgentReport

Answer = dict[str, Any] | str


class ReadingModel:
    """Serves answers in turn, the last one again and again, and carries instructions out with them."""

    def __init__(self, editor: SceneEditor, stack: ExitStack, chat: Any) -> None:
        self.editor, self._stack, self._chat = editor, stack, chat
        self.prompts: list[str] = []

    def does(self, text: str, *answers: Answer) -> AgentReport:
        """Return the report of an instruction that a model answers so."""
        replies = [self._chat.Reply(one if isinstance(one, str) else json.dumps(one)) for one in answers]
        server = self._stack.enter_context(self._chat.ChatServer(self._chat.in_turn(*replies)))
        settings = LlmSettings(base_url=server.url, model="m", api_key=Secret("sk-none"), timeout=10.0, retries=0)
        report = carry_out_with_model(LlmClient(settings, sleep=lambda seconds: None), self.editor, text)
        self.prompts = ["\n".join(m["content"] for m in request["messages"]) for request in server.requests]
        return report


@pytest.fixture
def model(editor: SceneEditor) -> Iterator[ReadingModel]:
    """Return the model that reads for the editor of the furnished building."""
    file = Path(__file__).parents[3] / "llm" / "chat_server.py"
    spec = importlib.util.spec_from_file_location("chat_server", file)
    assert spec is not None and spec.loader is not None
    chat: Any = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = chat
    spec.loader.exec_module(chat)
    with ExitStack() as stack:
        yield ReadingModel(editor, stack, chat)
