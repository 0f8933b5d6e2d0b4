"""What the steps of the language-model planner share: the client, the knowledge, and where each piece came from."""

from dataclasses import dataclass, field

from mansion_knowledge import KnowledgeBase
from mansion_llm import LlmClient

__all__ = ["LLM", "RULES", "Context"]

LLM = "llm"
RULES = "rules"


@dataclass
class Context:
    """A planning run.

    Attributes
    ----------
    sources : dict of str to str
        Piece (``numbers``, ``cores``, ``program/F1``, ``topology/F1``, ``seeds/F1``) to ``llm``, ``rules`` or
        ``rules: REASON``, in the order of planning.
    """

    client: LlmClient
    knowledge: KnowledgeBase
    description: str
    sources: dict[str, str] = field(default_factory=dict)

    def from_model(self, piece: str) -> None:
        """Record that the model's answer is used."""
        self.sources[piece] = LLM

    def from_rules(self, piece: str, reason: str = "") -> None:
        """Record that the offline planner's answer is used, and why."""
        self.sources[piece] = f"{RULES}: {reason}" if reason else RULES
