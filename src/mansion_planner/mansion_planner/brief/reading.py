"""A brief while it is read: its tokens, the phrases found in them, and which tokens are spoken for."""

from dataclasses import dataclass, field

from mansion_knowledge import KnowledgeBase
from mansion_planner.brief.facts import BriefFacts, Span
from mansion_planner.brief.lexicon import Mention, lexicon_of
from mansion_planner.brief.spelling import corrected
from mansion_planner.brief.tokens import Token, tokenize

__all__ = ["FLOOR_WORDS", "Reading", "start_reading"]

FLOOR_WORDS = frozenset({"floor", "storey", "story", "level", "storied", "storeyed", "floored", "leveled", "levelled"})


@dataclass
class Reading:
    """The state that the readers share.

    Attributes
    ----------
    taken : set of int
        Indices of tokens that are part of a fact already.
    mention_at : dict of int to Mention
        Phrases by their first token.
    """

    text: str
    tokens: list[Token]
    mentions: list[Mention]
    knowledge: KnowledgeBase
    facts: BriefFacts = field(default_factory=BriefFacts)
    taken: set[int] = field(default_factory=set)
    mention_at: dict[int, Mention] = field(default_factory=dict)
    mention_ending: dict[int, Mention] = field(default_factory=dict)

    def word(self, index: int) -> str:
        """Return the normal form of a token, or an empty string outside the brief."""
        return self.tokens[index].text if 0 <= index < len(self.tokens) else ""

    def kind(self, index: int) -> str:
        """Return the kind of a token, or an empty string outside the brief."""
        return self.tokens[index].kind if 0 <= index < len(self.tokens) else ""

    def span(self, first: int, last: int) -> Span:
        """Return the piece of the brief from token `first` to `last` (exclusive)."""
        start, end = self.tokens[first].start, self.tokens[last - 1].end
        return Span(self.text[start:end], start, end)

    def take(self, first: int, last: int) -> None:
        """Mark tokens as part of a fact."""
        self.taken.update(range(first, last))


def start_reading(text: str, knowledge: KnowledgeBase) -> Reading:
    """Tokenise `text`, correct misspelt words and find the phrases of the knowledge base."""
    lexicon = lexicon_of(knowledge)
    tokens = corrected(tokenize(text), lexicon.words)
    mentions = lexicon.find(tokens)
    return Reading(
        text=text,
        tokens=tokens,
        mentions=mentions,
        knowledge=knowledge,
        mention_at={mention.first: mention for mention in mentions},
        mention_ending={mention.last: mention for mention in mentions},
    )
