"""Bring storeys into one form: names of other countries, "1. OG", "RDC", "R+1", tables, and one told beside another."""

from collections.abc import Callable
from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token

__all__ = ["ABOVE_GROUND", "added_storeys", "storey_forms", "storey_tables"]

ABOVE_GROUND = "above_ground"

_GROUND = (
    ("planta", "baja"),
    ("planta", "terrea"),
    ("piso", "terreo"),
    ("piano", "terra"),
    ("piano", "terreno"),
    ("rez", "de", "chaussee"),
    ("rez", "de", "jardin"),
    ("begane", "grond"),
    ("terreo",),
    ("erdgeschoss",),
    ("parter",),
    ("parterre",),
)
_GROUND_SHORT = frozenset({"eg", "rdc", "pb", "rch", "gf"})
_LOWER_GROUND_SHORT = frozenset({"lg", "lgf"})
_BASEMENT = (("sous", "sol"), ("sotano",), ("subsolo",), ("untergeschoss",), ("kellergeschoss",), ("keller",))
_TOP = (("dachgeschoss",), ("cobertura",))
_ABOVE = frozenset({"verdiepingen", "og", "obergeschoss", "andar", "andare", "verdieping", "etage", "stock"})
_FLOOR = frozenset({"piso", "planta", "pavimento"})
_FIRST = {
    "primer": 1, "primera": 1, "primeiro": 1, "premier": 1, "erste": 1, "erster": 1, "primo": 1, "segundo": 2,
    "segunda": 2, "secondo": 2, "terzo": 3, "deuxieme": 2, "zweite": 2, "tercer": 3, "tercera": 3,
    "terceiro": 3, "troisieme": 3, "dritte": 3,
}  # fmt: skip
_SUFFIXES = frozenset({"er", "ere", "eme", "e", "a", "o", "era", "re"})
_LINKS = frozenset({"and", "to", "-", "–", ",", "&", "bis", "und", "et", "y"})
_IN_ENGLISH = {"bis": "to", "und": "and", "et": "and", "y": "and"}
_LEADS = frozenset({"in", "at", "on", "the", "im", "no", "au", "en", "and", "from", "to", "of"})
_MARKS = frozenset({":", "-", "=", "(", "\n", "–"})

_SIZED = frozenset({":", "of", "is", "about", "around", "approx", "roughly", "area", "size", "="})

_PLATES = frozenset({("floor", "plate"), ("floor", "plan"), ("ground", "area")})
"""What the footprint is called."""

_Found = tuple[list[Token], int]


def storey_forms(text: str, tokens: list[Token]) -> list[Token]:
    """Return the tokens with the names of storeys in one form.

    Parameters
    ----------
    text : str
        The brief, which says how a name is written.
    tokens : list of Token
    """
    tokens = _with_plain_ranges(tokens)
    forms = _Forms(text, tokens)
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        found = forms.at(index)
        if found is None:
            result.append(tokens[index])
            index += 1
        else:
            result += found[0]
            index = found[1]
    return _with_ranges(text, _layers(_numbers_behind(result)))


_NUMBERS = ("number", "ordinal")
_RANGED = frozenset({"floor", "storey", "story", "level", "from"})
"""Words before or after two numbers with "till" between them that make them a range."""


def _with_plain_ranges(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "storeys 2 till 4" as "storeys 2 to 4": this till is no piece of furniture."""
    return [
        replace(token, text="to")
        if token.text in ("till", "until", "thru")
        and 0 < index < len(tokens) - 1
        and tokens[index - 1].kind in _NUMBERS
        and tokens[index + 1].kind in _NUMBERS
        and not _RANGED.isdisjoint(
            near.text for near in (*tokens[max(index - 3, 0) : index], *tokens[index + 2 : index + 3])
        )
        else token
        for index, token in enumerate(tokens)
    ]


class _Forms:
    """Finds the names of storeys at a token: what stands for them, and the token after them."""

    def __init__(self, text: str, tokens: list[Token]) -> None:
        self.text, self.tokens = text, tokens
        self.texts = [token.text for token in tokens]
        self.has_ground = any(self._sequence(i, _GROUND) or self._short_ground(i) for i in range(len(tokens)))
        self.readers: tuple[Callable[[int], _Found | None], ...] = (
            self._ground_and_more,
            self._of_hong_kong,
            self._lower_ground,
            self._basement_number,
            self._ground,
            self._numbered,
            self._named,
            self._short,
            self._side,
            self._letter,
        )

    def at(self, index: int) -> _Found | None:
        """Return what stands for the name of a storey that begins at a token, if one does."""
        return next((found for read in self.readers if (found := read(index)) is not None), None)

    def _word(self, index: int) -> str:
        return self.texts[index] if 0 <= index < len(self.texts) else ""

    def _number(self, index: int) -> int:
        """Return the number or ordinal at a token, or -1."""
        token = self.tokens[index] if index < len(self.tokens) else None
        if token is None or token.kind not in ("number", "ordinal") or token.value != int(token.value):
            return -1
        return int(token.value) if token.value <= 100 else -1

    def _capitals(self, index: int) -> bool:
        token = self.tokens[index]
        return self.text[token.start : token.end].isupper()

    def _opens(self, index: int) -> bool:
        return index == 0 or self._word(index - 1) in (".", ";", "\n", "*", "-", "!", "?")

    def _sequence(self, index: int, names: tuple[tuple[str, ...], ...]) -> int:
        """Return how many tokens a name has that begins at a token, or 0."""
        return next((len(name) for name in names if tuple(self.texts[index : index + len(name)]) == name), 0)

    def _short_ground(self, index: int) -> bool:
        return self._is_short(index, _GROUND_SHORT)

    def _is_short(self, index: int, names: frozenset[str]) -> bool:
        """Whether one of some short forms of a storey's name stands at a token, where a name of a storey can."""
        named = (
            self._opens(index) or self._word(index + 1) in _MARKS | {"+", ",", ")"} or self._word(index - 1) in _LEADS
        )
        return self._word(index) in names and self._capitals(index) and named

    def _level(self, first: int, last: int, value: int) -> Token:
        start, end = self.tokens[first], self.tokens[last - 1]
        return Token("level", ABOVE_GROUND, start.start, end.end, float(value), spaced=start.spaced)

    def _ground_and_more(self, index: int) -> _Found | None:
        """Read "R+2" and "térreo + 2 andares" as a number of storeys, and "at the R+1" as one of them."""
        size = self._sequence(index, _GROUND)
        if not size and (self._short_ground(index) or (self._word(index) == "r" and self._capitals(index))):
            size = 1
        if not size or self._word(index + size) not in ("+", "plus") or self._number(index + size + 1) < 0:
            return None
        last = index + size + 2
        placed = self._word(index) == "r" and (
            self._word(last) in _MARKS - {"("}
            or (self._word(index - 1) in ("the", "at", "au", "du", "from") and index > 1)
            or (self._word(index - 1) in ("to", "and") and self._word(index - 3) == "+")
        )
        if placed:
            return [self._level(index, last, self._number(last - 1))], last
        last += self._word(last) in _ABOVE | _FLOOR
        return [replace(self.tokens[index], text="g"), *self.tokens[index + size : index + size + 2]], last

    def _of_hong_kong(self, index: int) -> _Found | None:
        """Read "G/F" and "2/F"."""
        if self.texts[index + 1 : index + 3] != ["/", "f"]:
            return None
        if self._word(index) == "g":
            return [self._level(index, index + 3, 0)], index + 3
        if self.tokens[index].kind != "number" or self._number(index) < 0:
            return None
        token = self.tokens[index]
        return [replace(token, kind="level", text=f"{token.text}f", end=self.tokens[index + 2].end)], index + 3

    def _lower_ground(self, index: int) -> _Found | None:
        """Read "lower ground floor", "LG: ..." and "lower ground (LG)" as the storey below the ground floor."""
        again = self._word(index) == "(" and self._word(index + 1) in _LOWER_GROUND_SHORT
        if again and self._word(index + 2) == ")" and "ground" in self.texts[max(index - 2, 0) : index]:
            return [], index + 3  # "lower ground floor (LG)"
        if self.texts[index : index + 2] == ["lower", "ground"]:
            last = index + 2
        elif self._is_short(index, _LOWER_GROUND_SHORT) and self._word(index - 1) != "in":
            last = index + 1 + 2 * (self.texts[index + 1 : index + 3] == ["/", "f"])
        else:
            return None
        return [replace(self.tokens[index], text="basement", end=self.tokens[last - 1].end)], last

    def _basement_number(self, index: int) -> _Found | None:
        """Read "B1", "B1F" and "B2/F" where they are headings."""
        if self._word(index) != "b" or not self._opens(index):
            return None
        token = self.tokens[index + 1] if index + 1 < len(self.tokens) else None
        if token is None or token.kind not in ("number", "level") or token.spaced:
            return None
        last = index + 2 + 2 * (self.texts[index + 2 : index + 4] == ["/", "f"])
        levels = any(other.kind == "level" for other in self.tokens)  # "B1 boiler room; L1 foyer"
        if self._word(last) not in _MARKS and last == index + 2 and token.kind != "level" and not levels:
            return None
        return [replace(self.tokens[index], text="basement", end=self.tokens[last - 1].end)], last

    def _ground(self, index: int) -> _Found | None:
        size = self._sequence(index, _GROUND) or int(self._short_ground(index))
        if not size:
            return None
        return [self._level(index, index + size, 0)], index + size

    def _storey(self, index: int) -> int:
        """Return where a numbered storey's noun ends that may begin at a token ("OG", "º andar", ". OG"), or 0."""
        suffixed = index < len(self.tokens) and self._word(index) in _SUFFIXES and not self.tokens[index].spaced
        at = index + (self._word(index) == "." or suffixed)
        noun = self._word(at)
        if noun in _ABOVE and not (at < len(self.tokens) and self.tokens[at].plural and noun not in ("og", "andare")):
            bare = at == index and noun in ("etage", "stock") and not suffixed
            return 0 if bare else at + 1
        return at + 1 if noun in _FLOOR and (self.has_ground or suffixed) else 0

    def _numbered(self, index: int) -> _Found | None:
        """Read "1. OG", "1º andar", "1er étage", "1. and 2. OG", "1. - 3. OG"."""
        value = self._number(index)
        if value < 1 or self.tokens[index].text == "one":
            return None
        values: list[tuple[int, int]] = [(index, value)]
        links: list[Token] = []
        at = index + 1
        for _ in range(6):
            last = self._storey(at)
            if last and not (self.tokens[index].text.isalpha() and self.tokens[index].kind == "number"):
                found: list[Token] = []
                for position, (begin, number) in enumerate(values):
                    end = last if position == len(values) - 1 else begin + 1
                    shift = 0 if self._word(last - 1) in _ABOVE or self.has_ground else 1
                    found += [*links[position - 1 : position], self._level(begin, end, number - shift)]
                return found, last
            at += self._word(at) == "."
            at += self._word(at) in _ABOVE
            if self._number(at) > value and self.text[self.tokens[at - 1].end : self.tokens[at].start] in ("-", "‑"):
                links.append(Token("mark", "–", self.tokens[at - 1].end, self.tokens[at].start, spaced=False))
                values.append((at, self._number(at)))
                at += 1
                continue
            if self._word(at) not in _LINKS or self._number(at + 1) < 1:
                return None
            links.append(replace(self.tokens[at], text=_IN_ENGLISH.get(self._word(at), self._word(at))))
            values.append((at + 1, self._number(at + 1)))
            at += 2
        return None

    def _named(self, index: int) -> _Found | None:
        """Read "primera planta", "premier étage", "OG 1"."""
        value = _FIRST.get(self._word(index), 0)
        if value and self._word(index + 1) in _ABOVE | _FLOOR | {"piano"}:
            shift = int(self._word(index + 1) in _FLOOR and not self.has_ground)
            return [self._level(index, index + 2, value - shift)], index + 2
        if self._word(index) == "og" and self._number(index + 1) > 0 and not self._opens(index + 1):
            return [self._level(index, index + 2, self._number(index + 1))], index + 2
        return None

    def _short(self, index: int) -> _Found | None:
        """Read the names of basements and top floors, and "2 andares" and "fl" as words for storeys."""
        size = self._sequence(index, _BASEMENT)
        short = self._word(index) in ("ug", "dg") and self._capitals(index) and self._word(index + 1) in _MARKS
        if size or (short and self._word(index) == "ug"):
            end = index + max(size, 1)
            return [replace(self.tokens[index], text="basement", end=self.tokens[end - 1].end)], end
        if self._sequence(index, _TOP) or short:
            token = self.tokens[index]
            return [replace(token, text="top"), replace(token, text="floor", start=token.end)], index + 1
        counted = index > 0 and self.tokens[index - 1].kind in ("number", "ordinal")
        if counted and self._word(index) in ("andare", "andar", "pavimento", "piso", "fl"):
            token = self.tokens[index]
            plural = token.plural or self.tokens[index - 1].value > 1
            return [replace(token, text="floor", plural=plural)], index + 1
        return None

    def _side(self, index: int) -> _Found | None:
        """Read "Low level: ...", "in the low floor", "the two high floors" as the ground floor and the upper ones."""
        side = {"low": "ground", "high": "upper"}.get(self._word(index), "")
        if not side or self._word(index + 1) not in ("level", "floor", "storey"):
            return None
        heads = self._opens(index) and self._word(index + 2) in _MARKS
        if not (heads or self._is_the_side(index)):
            return None
        return [replace(self.tokens[index], text=side), self.tokens[index + 1]], index + 2

    def _is_the_side(self, index: int) -> bool:
        """Whether "in the low floor" and "the two high floors" tell storeys by their place."""
        counted = self.tokens[index - 1].kind == "number" and index > 1
        several = self.tokens[index + 1].plural
        if self._word(index - 1 - counted) != "the" or (several and self._word(index) == "low"):
            return False
        return several or self._word(index - 2) in ("in", "on", "at")

    def _letter(self, index: int) -> _Found | None:
        """Read "Level G: ..." as level 0, "planta alta" as the upper floor, and "floor plate" as the footprint."""
        token, following = self.tokens[index], self._word(index + 1)
        if token.text in ("floor", "level") and following == "g" and self._word(index + 2) in _MARKS:
            return [token, replace(self.tokens[index + 1], kind="number", text="0", value=0.0)], index + 2
        sized = self._word(index + 2) in _SIZED or (
            index + 2 < len(self.tokens) and self.tokens[index + 2].kind == "number"
        )
        if (token.text, following) in _PLATES and sized:
            return [replace(token, text="footprint", end=self.tokens[index + 1].end)], index + 2
        below = self.text[token.end : token.end + 2].strip() in ("-", "–", "−") and self._number(index + 2) > 0
        if token.text in ("floor", "level") and following in ("-", "–") and below and self._word(index + 3) in _MARKS:
            return [replace(token, text="basement", end=self.tokens[index + 2].end)], index + 3
        if token.text in ("planta", "piso") and following in ("alta", "superior"):
            return [replace(token, text="upper"), replace(self.tokens[index + 1], text="floor")], index + 2
        return None


def _numbers_behind(tokens: list[Token]) -> list[Token]:
    """Return tokens with "1 floor: pool ... 2 floor: rooms" as floor 1 and floor 2, where no other storeys have names.

    Languages in which the noun follows its ordinal number lead people to write so.
    """
    heads = [
        index
        for index in range(len(tokens) - 2)
        if tokens[index].kind == "number"
        and tokens[index + 1].text in _NUMBERED
        and tokens[index + 2].text in _AFTER_HEADS
        and (index == 0 or tokens[index - 1].text in _BEFORE_HEADS)
    ]
    if [tokens[index].value for index in heads] != list(range(1, len(heads) + 1)) or len(heads) < _HEADS:
        return tokens
    result = list(tokens)
    for index in heads:
        result[index : index + 2] = [replace(tokens[index + 1], plural=False), tokens[index]]
    return result


_NUMBERED = frozenset({"floor", "storey", "level", "story"})
_BEFORE_HEADS = frozenset({".", ";", "\n", "!", "?", "*", "-", "on", "in", "at"})
_AFTER_HEADS = frozenset({":", "-", "–", "=", "is", "has", "have", "with"})
_HEADS = 2
"""Storeys that are headed so, at least: one alone may be the number of storeys."""


def _layers(tokens: list[Token]) -> list[Token]:
    """Read layers as storeys where the brief counts them: "4 layers", "first layer: ...", "every layer"."""
    before = ["", *[token.text for token in tokens]]
    counted = [
        token.text == "layer" and (before_kind in ("number", "ordinal") or word in ("every", "each"))
        for token, word, before_kind in zip(tokens, before, ["", *[token.kind for token in tokens]], strict=False)
    ]
    if not any(counted):
        return tokens
    return [replace(token, text="floor") if token.text == "layer" else token for token in tokens]


def _with_ranges(text: str, tokens: list[Token]) -> list[Token]:
    """Put the dash back between two storeys: "3F-9F", "2nd-4th floor"."""
    result: list[Token] = []
    for token in tokens:
        last = result[-1] if result else None
        if (
            last is not None
            and last.kind == token.kind
            and token.kind in ("level", "ordinal")
            and not token.spaced
            and text[last.end : token.start] in ("-", "‑")
            and last.value < token.value
        ):
            result.append(Token("mark", "–", last.end, token.start, spaced=False))
        if token.kind == "level" and len(result) > 1 and result[-1].text == "au" and result[-2].kind == "level":
            result[-1] = replace(result[-1], text="to")
        result.append(token)
    return result


def storey_tables(tokens: list[Token], floor_words: frozenset[str]) -> list[Token]:
    """Return the tokens with the rows of a table of storeys as headed lines.

    The table is one in the manner of Markdown whose header begins with a word for storeys. The header and the line of
    dashes below it are left out.
    """
    result: list[Token] = []
    in_table = False
    for line in _lines(tokens):
        if not line or line[0].text != "|":
            in_table = in_table and not line
            result += line
        elif _is_header(line, floor_words):
            in_table = True
        elif in_table:
            result += _headed(line)
        else:
            result += line
    return result


def _lines(tokens: list[Token]) -> list[list[Token]]:
    """Return the tokens line by line, each line with the break that ends it."""
    lines: list[list[Token]] = [[]]
    for token in tokens:
        lines[-1].append(token)
        if token.text == "\n":
            lines.append([])
    return lines


def _is_header(line: list[Token], floor_words: frozenset[str]) -> bool:
    return len(line) > 2 and line[1].text in floor_words and line[2].text == "|"


def _headed(line: list[Token]) -> list[Token]:
    """Return a row as "first cell: other cells", without what its first cell has in brackets after a number."""
    ends = line[-1:] if line[-1].text == "\n" else []
    cells = line[1 : len(line) - len(ends)]
    if cells and cells[-1].text == "|":
        cells = cells[:-1]
    bar = next((at for at, token in enumerate(cells) if token.text == "|"), None)
    if bar is None or all(token.kind == "mark" for token in cells):
        return ends
    head = cells[:bar]
    if head and head[0].kind == "number":
        head = head[:1]
    rest = [replace(token, text=",") if token.text == "|" else token for token in cells[bar + 1 :]]
    return [*head, replace(cells[bar], text=":"), *rest, *ends]


_JOINTS = frozenset({"plus", "and", "+", "with"})
_ARTICLES = frozenset({"a", "an", "one"})
_FURTHER = frozenset({"second", "upper", "further", "additional", "extra"})
_WORDS_BETWEEN = 4


def added_storeys(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with one storey and a second one as two storeys."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        end = _end(tokens, index, floor_words) or _attic_end(tokens, index, floor_words)
        if end:
            start, last = tokens[index].start, tokens[end - 1].end
            result.append(Token("number", "two", start, last, 2.0))
            result.append(Token("word", "storey", start, last, plural=True))
        else:
            result.append(tokens[index])
        index = end or index + 1
    return result


_ATTICS = frozenset({"attic", "loft"})


def _attic_end(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the token after "ground floor plus attic" where no number of storeys is told; else 0."""
    texts = [token.text for token in tokens[index : index + 6]]
    if len(texts) < 4 or texts[0] != "ground" or texts[1] not in floor_words or texts[2] not in _JOINTS:
        return 0
    attic = 3 + (texts[3] in ("a", "an", "the"))
    counted = any(token.kind == "number" and tokens[at + 1].text in floor_words for at, token in enumerate(tokens[:-1]))
    if texts[attic : attic + 1] == [] or texts[attic] not in _ATTICS or counted:
        return 0
    return index + attic + 1 + (texts[attic + 1 : attic + 2] != [] and texts[attic + 1] in floor_words)


def _end(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return the token after "one storey plus a second storey" at a token; 0 where that is not told."""
    texts = [token.text for token in tokens[index : index + 5 + _WORDS_BETWEEN + 1]]
    one = tokens[index].kind == "number" and tokens[index].value == 1
    if not one or len(texts) < 5 or texts[1] not in floor_words or texts[2] not in _JOINTS:
        return 0
    article = 3 + (texts[3] == "with")
    if texts[article] not in _ARTICLES:
        return 0
    noun = next((at for at in range(article + 1, len(texts)) if texts[at] in floor_words), 0)
    further = not _FURTHER.isdisjoint(texts[article + 1 : noun])
    return index + noun + 1 if noun and further and not tokens[index + noun].plural else 0
