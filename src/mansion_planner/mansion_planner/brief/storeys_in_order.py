"""Number the storeys of a list that goes up or down: "from bottom to top: a shop; offices; a flat"."""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from itertools import pairwise

from mansion_language import Token

__all__ = ["storeys_in_order"]

_LOW = frozenset("bottom ground base below street cellar basement lowest foot".split())
_HIGH = frozenset("top roof above attic highest uppermost".split())
_UP = frozenset("up upward upwards ascending".split())
_DOWN = frozenset("down downward downwards descending".split())
_LINKS = frozenset("from starting start beginning begin to order going go listed counted read stacked by".split())
"""Words one of which shows that an order is told, and not the name of a storey."""
_OPENING = (
    _LOW | _HIGH | _UP | _DOWN | _LINKS
    | frozenset(
        """
        the floor storey level story deck in at with of building house tower as follow follows these are they is it has
        have hold contain we there on every each one ( ) program programme stack stacking list use reading and - –
        """.split()
    )
)  # fmt: skip
_ALONE = frozenset(
    (first, way)
    for first in ("going", "bottom", "ground", "street", "top")
    for way in ("up", "upwards", "down", "downwards")
)
"""Openings without a word that links: "top down:", "going up:"."""
_MARKS = frozenset({":", ",", "-", "–"})
_LONGEST_OPENING = 14
_ENDS = frozenset({".", "\n", "!", "?"})
_SEPARATORS = ((";",), ("/",), ("|",), ("then",), (",",))
_LONGEST_ENTRY = 40
_MOST_STOREYS = 60


def storeys_in_order(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with the number of its storey before each entry of such a list.

    Only where the brief tells as many storeys as the list has entries, or does not tell how many it has. Storeys that
    the brief later calls by what its list has there ("each office storey") get their numbers too.
    """
    for index in range(len(tokens)):
        found = _List(tokens, index, floor_words).read()
        if found is not None:
            return found
    return tokens


@dataclass(frozen=True)
class _Entry:
    """Tokens `first` to `last` (exclusive) of an entry, and over how many storeys it goes."""

    first: int
    last: int
    storeys: int = 1


class _List:
    """A list of storeys whose opening words may begin at a token."""

    def __init__(self, tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> None:
        self.tokens, self.index, self.floor_words = tokens, index, floor_words
        self.upwards = True

    def read(self) -> list[Token] | None:
        """Return all tokens of the brief with the storeys of the list, if there is one."""
        first = self._opened()
        if not first:
            return None
        stated, cellar = self._stated()
        entries = self._entries(first, stated, cellar)
        if not entries:
            return None
        numbers = self._numbers(entries, stated, cellar)
        result = list(self.tokens[: self.index])
        for entry, (low, high) in zip(entries, numbers, strict=True):
            result += [*self._heading(low, high, entry), *self.tokens[entry.first : entry.last]]
            result.append(Token("mark", ";", self.tokens[entry.last - 1].end, self.tokens[entry.last - 1].end))
        rest = self.tokens[entries[-1].last + (self._text(entries[-1].last) in _ENDS | {";"}) :]
        end = replace(result.pop(), text=".")
        return [*result, *([end] if rest else []), *self._with_numbers(rest, entries, numbers)]

    def _text(self, index: int) -> str:
        return self.tokens[index].text if 0 <= index < len(self.tokens) else ""

    def _opened(self) -> int:
        """Return the token after the words that open a list, and keep their direction; 0 where there are none."""
        before = self._text(self.index - 1)
        if before not in _ENDS | {"", ";", ",", ":", "-", "–", "(", "with", "and", "are", "is"}:
            return 0
        end = self.index
        while self._text(end) in _OPENING and end - self.index < _LONGEST_OPENING:
            end += 1
        words = [self._text(at) for at in range(self.index, end)]
        while words and words[-1] in _MARKS:
            words.pop()
            end -= 1
        if self._text(end) not in _MARKS or (self._text(end) != ":" and "from" not in words):
            return 0
        return end + 1 if self._tells_direction(words) else 0

    def _tells_direction(self, words: Sequence[str]) -> bool:
        """Keep whether opening words lead upwards or downwards; whether they do either."""
        alone = words[:1] in (["upwards"], ["downwards"], ["ascending"], ["descending"]) or tuple(words) in _ALONE
        if not (set(words) & _LINKS or alone) or words[:1] in (["the"], ["on"], ["each"], ["every"]):
            return False
        low = next((at for at, word in enumerate(words) if word in _LOW), None)
        high = next((at for at, word in enumerate(words) if word in _HIGH), None)
        rising, falling = bool(set(words) & _UP), bool(set(words) & _DOWN)
        if low is None and high is None and not rising and not falling:
            self.upwards = True
            return words in (["floor", "by", "floor"], ["storey", "by", "storey"], ["level", "by", "level"])
        if low is not None and high is not None:
            self.upwards = low < high
        elif rising or falling:
            self.upwards = rising and words[:2] != ["top", "down"]
        else:
            self.upwards = low is not None
        return True

    def _stated(self) -> tuple[int, bool]:
        """Return how many storeys above ground the brief tells, 0 where it does not, and whether it has a cellar."""
        texts = [token.text for token in self.tokens]
        most = 0
        for at, token in enumerate(self.tokens):
            noun = next((n for n in (1, 2, 3) if at + n < len(texts) and texts[at + n] in self.floor_words), 0)
            plain = all(self.tokens[at + n].kind == "word" for n in range(1, noun))
            if token.kind == "number" and noun and plain and 1 < token.value <= _MOST_STOREYS:
                most = max(most, int(token.value))
            if token.text == "g" and texts[at + 1 : at + 2] == ["+"] and at + 2 < len(texts):
                most = max(most, int(self.tokens[at + 2].value) + 1)
        return most, not {"basement", "cellar"}.isdisjoint(texts)

    def _entries(self, first: int, stated: int, cellar: bool) -> list[_Entry]:
        """Return the entries from a token on, as many as there are storeys; none where they do not come to that."""
        for entries in self._splits(first, stated):
            total = sum(entry.storeys for entry in entries)
            known = total == stated or (cellar and total == stated + 1) if stated else True
            plain = all(self._is_plain(entry) for entry in entries)
            if len(entries) > 1 and known and plain:
                return entries
        return []

    def _splits(self, first: int, stated: int) -> Iterator[list[_Entry]]:
        """Yield the ways in which a list may be read: by semicolons, strokes, lines, commas, sentences."""
        if self._text(first) == "\n":
            yield self._by_breaks(first + 1, "\n", stated)
            return
        end = self._end(first)
        if self._text(end) == "\n" and end - first < _LONGEST_ENTRY and self._text(end - 1) == ";":
            yield self._by_breaks(first, "\n", stated)
        for separator in _SEPARATORS:
            starts = [first, *(at + 1 for at in self._outside(first, end) if self._text(at) in separator)]
            entries = [self._entry(a, b - 1) for a, b in pairwise([*starts, end + 1])]
            entries = [entry for entry in entries if entry.first < entry.last]
            yield entries
            yield self._with_last_parted(entries)
            if separator == (";",) and len(entries) > 1:
                return
        yield self._by_breaks(first, ".", stated)

    def _by_breaks(self, first: int, mark: str, stated: int) -> list[_Entry]:
        """Return the entries that stand in lines, or are sentences, of their own."""
        entries: list[_Entry] = []
        at = first
        while at < len(self.tokens) and (mark == "\n" or len(entries) < stated):
            end = at
            while end < len(self.tokens) and self._text(end) != mark:
                end += 1
            entry = self._entry(at, end)
            if entry.first >= entry.last:
                break
            entries.append(entry)
            at = end + 1
        return entries

    def _entry(self, first: int, last: int) -> _Entry:
        """Return an entry without its bullet, its number and the words that only join it to the one before."""
        while first < last and self._text(first) in ("*", "-", "–", "and", "then", ",", "next", "finally", "lastly"):
            first += 1
        if first + 1 < last and self.tokens[first].kind == "number" and self._text(first + 1) in (".", ")"):
            first += 2
        while last > first and self._text(last - 1) in (";", ",", ".", "then", "and"):
            last -= 1
        counted = first + 2 < last and self.tokens[first].kind == "number" and self._text(first + 2) in ("of", "with")
        storeyed = counted and self._text(first + 1) in self.floor_words
        return _Entry(first + 3, last, int(self.tokens[first].value)) if storeyed else _Entry(first, last)

    def _with_last_parted(self, entries: list[_Entry]) -> list[_Entry]:
        """Return entries with the last one parted at its "and": "a shop, an office and a flat"."""
        if not entries:
            return []
        last = entries[-1]
        joint = next((at for at in range(last.last - 1, last.first, -1) if self._text(at) == "and"), 0)
        parts = [self._entry(last.first, joint), self._entry(joint + 1, last.last)] if joint else [last]
        return [*entries[:-1], *(part for part in parts if part.first < part.last)]

    def _end(self, first: int) -> int:
        end = first
        while end < len(self.tokens) and self._text(end) not in _ENDS:
            end += 1
        return end

    def _outside(self, first: int, last: int) -> Iterator[int]:
        """Yield the tokens outside of brackets."""
        depth = 0
        for at in range(first, last):
            depth += (self._text(at) in ("(", "[")) - (self._text(at) in (")", "]"))
            if depth == 0:
                yield at

    def _is_plain(self, entry: _Entry) -> bool:
        """Whether an entry is short and does not name its storey itself: "ground floor: a shop"."""
        head = range(entry.first, min(entry.first + 4, entry.last))
        named = any(self._text(at) == ":" for at in head) or self.tokens[entry.first].kind == "level"
        return entry.last - entry.first <= _LONGEST_ENTRY and not named

    def _numbers(self, entries: list[_Entry], stated: int, cellar: bool) -> list[tuple[int, int]]:
        """Return the lowest and the highest storey of each entry; 0 is the basement."""
        total = sum(entry.storeys for entry in entries)
        edge = entries[0] if self.upwards else entries[-1]
        below = {self._text(at) for at in range(edge.first, edge.last)} & {"basement", "cellar"}
        lowest = 1 - int(total > stated if stated else bool(below and cellar))
        numbers: list[tuple[int, int]] = []
        for entry in entries if self.upwards else entries[::-1]:
            numbers.append((lowest, lowest + entry.storeys - 1))
            lowest += entry.storeys
        return numbers if self.upwards else numbers[::-1]

    def _heading(self, low: int, high: int, entry: _Entry) -> list[Token]:
        """Return the name of a storey and a colon, without any width, before an entry."""
        start = self.tokens[entry.first].start

        def token(text: str) -> Token:
            number = float(text) if text.isdigit() else 0.0
            kind = "number" if text.isdigit() else "mark" if text == ":" else "word"
            return Token(kind, text, start, start, number, plural=text == "floor" and high > low)  # type: ignore[arg-type]

        if low < 1:
            return [token("basement"), token(":")]
        names = ["floor", str(low), *(["to", str(high)] if high > low else []), ":"]
        return [token(name) for name in names]

    def _with_numbers(
        self, rest: list[Token], entries: list[_Entry], numbers: list[tuple[int, int]]
    ) -> Iterator[Token]:
        """Yield further tokens, "each office storey" and "the office storey" with the numbers of those storeys."""
        named: dict[str, list[int]] = {}
        for entry, (low, high) in zip(entries, numbers, strict=True):
            for word in {self._text(at) for at in range(entry.first, min(entry.first + 3, entry.last))}:
                named.setdefault(word, []).extend(range(low, high + 1))
        at = 0
        while at < len(rest):
            use = rest[at + 1].text if at + 2 < len(rest) else ""
            storeyed = at + 2 < len(rest) and rest[at + 2].text in self.floor_words and use in named
            if rest[at].text in ("each", "every", "both", "all", "the") and storeyed and use not in _OPENING:
                yield from self._numbered(rest[at], rest[at + 2], sorted(named[use]))
                at += 3
            else:
                yield rest[at]
                at += 1

    def _numbered(self, first: Token, noun: Token, storeys: list[int]) -> Iterator[Token]:
        """Yield "each of floors 3 and 4", or "floor 3", in the place of other words for these storeys."""

        def token(text: str) -> Token:
            return Token("word", text, first.start, noun.end)

        if len(storeys) > 1:
            yield token("each")
            yield token("of")
        yield replace(token("floor"), plural=len(storeys) > 1)
        for position, storey in enumerate(storeys):
            if position:
                yield token("and" if position == len(storeys) - 1 else ",")
            yield Token("number", str(storey), first.start, noun.end, float(storey))
