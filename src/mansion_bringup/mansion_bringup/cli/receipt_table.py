"""The receipt of a brief as a table: what was asked for, and what became of it."""

from collections.abc import Sequence
from typing import Final

from rich.table import Table
from rich.text import Text

from mansion_bringup.building.wish_words import STATUS_WORDS, read_as, receipt_summary
from mansion_bringup.cli.console import out
from mansion_msgs_py.building import BuildingReport
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.wishes import Wish

__all__ = ["print_own_assets", "print_plan_notes", "print_receipt", "receipt_table", "refuse_unmet"]

_COLOURS: Final = {"met": "green", "partly": "yellow", "not_met": "red", "not_understood": "magenta", "": ""}


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
        reader = [Text(wish.read_by)] if signed else []
        table.add_row(
            Text(wish.text),
            Text(read_as(wish)),
            Text(STATUS_WORDS[wish.status], style=_COLOURS[wish.status]),
            *reader,
            Text(wish.reason),
        )
    return table


def print_receipt(wishes: Sequence[Wish]) -> None:
    """Print the table and its summary."""
    if wishes:
        out.print(receipt_table(wishes))
    out.print(receipt_summary(wishes), highlight=False)


def print_plan_notes(downgrades: Sequence[Downgrade]) -> None:
    """Print what was decided where a given plan leaves something open, or is not built as it is drawn."""
    for entry in downgrades:
        floor = "" if entry.floor is None else f"floor {entry.floor}, "
        out.print(f"{floor}{entry.wish}: {entry.got} ({entry.reason})", markup=False, highlight=False)


def print_own_assets(report: BuildingReport, libraries: Sequence[str]) -> None:
    """Print which of the user's assets a building has, where libraries were named or it has any."""
    if report.assets:
        named = ", ".join(f"{use.objects} x {use.asset}" for use in report.assets)
        out.print(f"own assets: {named}", markup=False, highlight=False)
    elif libraries:
        out.print(f"own assets: none used; no room needs those of {', '.join(libraries)}", markup=False)


def refuse_unmet(wishes: Sequence[Wish]) -> None:
    """Raise the error that ``--strict`` ends with, unless every wish is met.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` naming the first wishes that are not met.
    """
    unmet = [wish for wish in wishes if wish.status != "met"]
    if unmet:
        named = "; ".join(f'"{wish.text}" ({wish.reason or STATUS_WORDS[wish.status]})' for wish in unmet[:3])
        more = f" and {len(unmet) - 3} more" if len(unmet) > 3 else ""
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{len(unmet)} of {len(wishes)} wishes are not met: {named}{more}; without --strict it would be built",
            path="$.description",
            details={"wishes": [wish.text for wish in unmet], "stage": "program"},
        )
