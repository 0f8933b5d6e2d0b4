"""The receipt of a brief as a table: what was asked for, and what became of it."""

from collections.abc import Sequence

from rich.table import Table
from rich.text import Text

from mansion_bringup.cli.console import out
from mansion_bringup.cli.wish_reading import read_as
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wishes import Wish
from mansion_msgs_py.wording import counted

__all__ = ["print_receipt", "receipt_summary", "receipt_table", "refuse_unmet"]

_MARKS = {"met": ("met", "green"), "partly": ("partly", "yellow"), "not_met": ("not met", "red"),
          "not_understood": ("not understood", "magenta"), "": ("open", "")}  # fmt: skip


def receipt_table(wishes: Sequence[Wish]) -> Table:
    """Return the wishes as rows: words, what they were read as, status, and the reason where one is not met.

    Where a language model read some of them, a column says who read which.
    """
    signed = any(wish.read_by == "model" for wish in wishes)
    table = Table(title="What the description asks for", title_justify="left", show_edge=False, pad_edge=False)
    table.add_column("wish", overflow="fold", max_width=44)
    table.add_column("read as", overflow="fold", max_width=40)
    table.add_column("status", no_wrap=True)
    if signed:
        table.add_column("read by", no_wrap=True)
    table.add_column("reason", overflow="fold")
    for wish in wishes:
        mark, colour = _MARKS[wish.status]
        reader = [Text(wish.read_by)] if signed else []
        table.add_row(Text(wish.text), Text(read_as(wish)), Text(mark, style=colour), *reader, Text(wish.reason))
    return table


def receipt_summary(wishes: Sequence[Wish]) -> str:
    """Return one line: how many wishes there are of each status.

    Examples
    --------
    >>> receipt_summary([])
    'nothing was asked for'
    """
    counts = {status: sum(wish.status == status for wish in wishes) for status in _MARKS}
    parts = [f"{count} {_MARKS[status][0]}" for status, count in counts.items() if count]
    return f"{counted(len(wishes), 'wish', 'wishes')}: {', '.join(parts)}" if wishes else "nothing was asked for"


def print_receipt(wishes: Sequence[Wish]) -> None:
    """Print the table and its summary."""
    if wishes:
        out.print(receipt_table(wishes))
    out.print(receipt_summary(wishes), highlight=False)


def refuse_unmet(wishes: Sequence[Wish]) -> None:
    """Raise the error that ``--strict`` ends with, unless every wish is met.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` naming the first wishes that are not met.
    """
    unmet = [wish for wish in wishes if wish.status != "met"]
    if unmet:
        named = "; ".join(f'"{wish.text}" ({wish.reason or _MARKS[wish.status][0]})' for wish in unmet[:3])
        more = f" and {len(unmet) - 3} more" if len(unmet) > 3 else ""
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{len(unmet)} of {len(wishes)} wishes are not met: {named}{more}; without --strict it is built",
            path="$.description",
            details={"wishes": [wish.text for wish in unmet], "stage": "program"},
        )
