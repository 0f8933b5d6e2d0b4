"""Read tables with a row for each storey as lists: "| 2 | open office |" becomes "2: open office"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["storey_tables"]


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
