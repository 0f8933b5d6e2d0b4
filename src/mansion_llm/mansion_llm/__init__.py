"""The language-model client: structured answers that are validated and repaired, a cache, and replay.

Planner, scene and skills ask for a payload type and get a value of it; nothing else of them knows which model
answers, or whether the answer was recorded.
"""

__version__ = "0.1.0"
