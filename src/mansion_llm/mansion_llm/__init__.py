"""The language-model client: structured answers that are validated and repaired, a cache, and replay.

Planner, scene and skills ask for a payload type and get a value of it; nothing else of them knows which model
answers, or whether the answer was recorded.
"""

from mansion_llm.client import Answer, Fault, LlmClient
from mansion_llm.prompt import Prompt, quoted_data
from mansion_llm.settings import PIECES, LlmSettings, load_settings

__all__ = ["PIECES", "Answer", "Fault", "LlmClient", "LlmSettings", "Prompt", "load_settings", "quoted_data"]
