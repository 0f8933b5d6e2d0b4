"""A model on loopback that answers as a test tells it to."""

import importlib.util
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from mansion_llm import LlmClient, LlmSettings


@pytest.fixture(scope="session")
def chat() -> ModuleType:
    """Return the module of the chat server."""
    file = Path(__file__).parents[2] / "llm" / "chat_server.py"
    spec = importlib.util.spec_from_file_location("chat_server", file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["chat_server"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(autouse=True)
def no_settings_of_the_user(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Keep the tester's own endpoint and key out of the tests."""
    for name in list(os.environ):
        if name.startswith(("MANSION_LLM_", "OPENAI_")) or name.lower().endswith("_proxy"):
            monkeypatch.delenv(name)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


@pytest.fixture
def client_of() -> Callable[..., LlmClient]:
    """Return what makes a client of a chat server: impatient, and without waits."""

    def make(server: object, **changes: object) -> LlmClient:
        settings = {
            "base_url": server.url,  # type: ignore[attr-defined]
            "model": "test",
            "timeout": 0.5,
            "retries": 1,
            "repairs": 1,
            "backoff": 0.0,
        }
        return LlmClient(LlmSettings(**{**settings, **changes}), sleep=lambda seconds: None)

    return make
