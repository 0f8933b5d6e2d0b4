"""Arguments that are text rather than options: a description that begins with a dash, such as a list."""

import re
from typing import Any

from typer.core import TyperCommand

__all__ = ["TextCommand"]

_TEXT = re.compile(r"-+[^-A-Za-z].*\s|-.*\n|-+\s", re.DOTALL)
"""A dash before something that is not the name of an option, or several lines."""


class TextCommand(TyperCommand):
    """A command whose argument may begin with a dash: "- two floors", "-3 flats", several lines."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse a command line with texts moved behind all options."""
        end = args.index("--") if "--" in args else len(args)
        options = [arg for arg in args[:end] if not _TEXT.match(arg)]
        texts = [arg for arg in args[:end] if _TEXT.match(arg)]
        return super().parse_args(ctx, [*options, "--", *texts, *args[end + 1 :]] if texts else args)
