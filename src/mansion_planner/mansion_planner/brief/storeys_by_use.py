"""Number the storeys that a brief calls by what they are for: "an office storey above the production level"."""

from mansion_language import Token
from mansion_planner.brief.storey_forms import ABOVE_GROUND

__all__ = ["storeys_by_use"]

_ABOVE = (("above",), ("over",), ("atop",), ("on", "top", "of"))
_BELOW = (("below",), ("under",), ("beneath",), ("underneath",))
_ALONE = (("above",), ("upstairs",), ("upstair",), ("on", "top"), ("overhead",))
_ARTICLES = frozenset({"a", "an", "the", "one", "our", "its"})
_CLOSERS = frozenset({"", ".", ",", ";", ":", "\n", ")"})
_ELSEWHERE = frozenset({"up", "upstair", "upstairs", "upper", "above"})
"""Words that tell what is on the storey above the ground floor."""
_NOT_USES = frozenset(
    """
    ground street upper lower top bottom basement cellar first last next other same each every entire whole single
    main full that this these those only highest lowest uppermost topmost middle roof attic mezzanine entrance half
    of on per by no any all both a an the one final new old high low raised extra further additional dance shop sale
    sales trading factory
    """.split()
)
"""Words before "floor" that tell its place or size, or name a room with it."""


def storeys_by_use(tokens: list[Token], floor_words: frozenset[str]) -> list[Token]:
    """Return the tokens with such names as levels above the ground, wherever the brief repeats them.

    Only where the brief says which storey lies above which: "the sleeping level below the living level"; or that one
    lies above, and what is there: "an office floor above. ... Up: ...".
    """
    found = _Names(tokens, floor_words)
    result: list[Token] = []
    at = 0
    while at < len(tokens):
        told = found.told_at(at) or found.named_at(at)
        if told is None:
            result.append(tokens[at])
            at += 1
            continue
        level, last = told
        start, end = tokens[at], tokens[last - 1]
        result.append(Token("level", ABOVE_GROUND, start.start, end.end, float(level), spaced=start.spaced))
        at = last
    return result


class _Names:
    """Which uses of storeys a brief tells the place of."""

    def __init__(self, tokens: list[Token], floor_words: frozenset[str]) -> None:
        self.tokens, self.floor_words = tokens, floor_words
        self.levels: dict[str, int] = {}
        for at in range(len(tokens)):
            for use, level in self._statement(at)[0].items():
                self.levels.setdefault(use, level)

    def told_at(self, at: int) -> tuple[int, int] | None:
        """Return the level of the storey whose place a statement at a token tells, and the token after it."""
        uses, last = self._statement(at)
        return (self.levels[self._text(at)], last) if uses else None

    def named_at(self, at: int) -> tuple[int, int] | None:
        """Return the level that a token and the noun after it name, and the token after these."""
        level = self.levels.get(self._text(at))
        return None if level is None or not self._use(at) else (level, at + 2)

    def _statement(self, at: int) -> tuple[dict[str, int], int]:
        """Return the levels by use that are told at a token, and the token after the statement."""
        use = self._use(at)
        if not use:
            return {}, at
        for joints, level in ((_ABOVE, 1), (_BELOW, 0)):
            joint = self._one_of(at + 2, joints)
            other = at + 2 + len(joint) + 1
            if joint and self._text(other - 1) in _ARTICLES and self._use(other) not in ("", use):
                return {use: level, self._use(other): 1 - level}, other + 2
        joint = self._one_of(at + 2, _ALONE)
        last = at + 2 + len(joint)
        led = self._text(at - 1) in _ARTICLES and self._text(last) in _CLOSERS
        if joint and led and self._goes_on(last, use):
            return {use: 1}, last
        return {}, at

    def _use(self, at: int) -> str:
        """Return the word that tells a storey at a token: "office" of "office storey"; or nothing."""
        if not 0 <= at < len(self.tokens) - 1:
            return ""
        token, noun = self.tokens[at], self.tokens[at + 1]
        storey = noun.text in self.floor_words and not noun.plural and noun.text != "story"
        named = token.kind == "word" and token.text not in _NOT_USES | self.floor_words
        return token.text if storey and named else ""

    def _goes_on(self, last: int, use: str) -> bool:
        """Whether the brief tells after a token what is on the storey above."""
        return any(
            (self._text(at) in _ELSEWHERE and self._text(at + 1) in (":", ",")) or self._use(at) == use
            for at in range(last, len(self.tokens))
        )

    def _one_of(self, at: int, phrases: tuple[tuple[str, ...], ...]) -> tuple[str, ...]:
        return next((words for words in phrases if all(self._text(at + n) == word for n, word in enumerate(words))), ())

    def _text(self, at: int) -> str:
        return self.tokens[at].text if 0 <= at < len(self.tokens) else ""
