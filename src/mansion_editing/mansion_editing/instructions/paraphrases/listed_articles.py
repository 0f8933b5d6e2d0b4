"""Lists of which only the first thing has an article: ``the eggs, butter and milk in the fridge have to go``."""

import re
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_language.inflection import singular

__all__ = ["with_article_for_each"]

_BARE: Final = (
    r"(?!(?:the|an?|all|both|some|any|my|our|your|his|her|their|its|this|that|it|them|one|two)\b)[a-z-]+(?: [a-z-]+)?"
)
_LIST: Final = re.compile(
    rf"\bthe (?P<first>[a-z-]+(?: [a-z-]+)?)(?P<middle>(?:, {_BARE}){{0,4}}),? and (?P<last>{_BARE})"
    r"(?= (?:in|on|from|off|under|out|away|upstairs|downstairs)\b"
    r"| (?:has|have|must|should|can|could|may|go|belongs?|is|are)\b)",
    re.IGNORECASE,
)


def with_article_for_each(text: str, lexicon: Lexicon) -> str:
    """Return ``the eggs, the butter and the milk`` for ``the eggs, butter and milk``, where all of them are things."""

    def each(match: re.Match[str]) -> str:
        names = [match["first"], *(name for name in match["middle"].split(", ") if name), match["last"]]
        if not all(
            lexicon.is_object((*name.lower().split()[:-1], singular(name.lower().split()[-1]))) for name in names
        ):
            return match.group()
        first, *others = (f"the {name}" for name in names)
        return ", ".join([first, *others[:-1]]) + f" and {others[-1]}"

    return _LIST.sub(each, text)
