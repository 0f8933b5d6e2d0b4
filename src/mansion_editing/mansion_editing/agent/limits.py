"""What no tool can do, told before anything is read: the words that ask for it are named."""

import re
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["EXAMPLES", "refuse_beyond"]

EXAMPLES: Final = (
    'what can be asked for: "put two red mugs on the desk in the kitchen", "nothing but a book on the coffee table", '
    '"move the pen from the desk to the sideboard", "remove the apples from the counter", "close everything in the '
    'kitchen", "turn on the lamp in the lobby", "make sure there is a way from the lobby to the kitchen"'
)
"""Ends a refusal: instructions that would be accepted."""

_VERB: Final = r"(?:^|[,;.:!?]\s*|\b(?:and|then|please|you)\s+)"
_BEYOND: Final = tuple(
    (re.compile(pattern, re.IGNORECASE), reason)
    for pattern, reason in (
        (r"\b(?:to|on|at) (?:the|its) (?:left|right)(?: hand)?(?: side)? of\b|\b(?:left|right) of\b|\bbehind\b|"
         r"\bopposite\b",
         "directions are not known; a thing can be placed next to another"),
        (r"\b(?:clos|near|farth|furth|larg|small|bigg|tall|low|high|long|short|wid|old|new)est\b|\b(?:left|"
         r"right)most\b",
         "places are told by their names, not by comparing them"),
        (r"\b(?:larg|small|bigg|tall|low|high|long|short|wid|narrow|warm|bright|dark|nic|clos)er\b(?= by|[.!]|$| than)|"
         r"\b(?:more|less) \w+(?:ing|ive|ant|able|ful)\b",
         "only objects, their places and their states can be changed"),
        (r"\b(?:every|each) (?:second|third|fourth|other)\b|\bhalf of\b|\b(?:some|most|many|few) of the\b|\d ?%|"
         r"\bpercent\b",
         "say how many, or all"),
        (r"\bin (?:a|one|two|three) (?:circles?|rows?|lines?|grids?|piles?|stacks?|patterns?|heaps?|triangles?)\b",
         "things are placed where there is room, in no pattern"),
        (_VERB + r"(?P<word>stack|pile|line|align|sort|scatter|throw|rotate|spin|tilt|break|smash|burn|paint|knock|"
                 r"demolish|"
         r"wash|wipe|cook|fold|cut(?! the (?:number|count))|repair|build|widen|enlarge|resize|rename|undo|redo)\b(?! "
         r"away| out)",
         "no tool does it; objects can be placed, moved, removed, opened and switched"),
        (r"\bmake (?:a |\w+ )?(?P<word>copy|copies|duplicates?|clones?)\b",
         "nothing is copied; say what is to be there"),
        (r"\b(?:clean|tidy|wipe)\b[^,;]* with\b",
         "no tool does it; objects can be placed, moved, removed, opened and switched"),
        (r"\bby [\w.]+ (?:degrees?|cm|m|mm|centimet\w+|met(?:er|re)s?)\b|\bweigh\w*|\b\d+ ?(?:kg|cm|mm|kilograms?|"
         r"degrees?)\b",
         "sizes, weights and angles come with the asset"),
        (r"\beither\b[^.;]*\bor\b|\bor (?:an?|the|one|two|three)\b", "say which of them"),
        (r"\b(?:if|unless|otherwise|provided that|depending)\b"
         r"(?! (?:there|not|possible|necessary|missing|need|needed|none|so|one is|any|you (?:can|could|would)|"
         r"(?:it|they|that)(?: is|'s| are|'re)?(?: not|n't)? (?:there|missing|already|yet|possible|necessary|present)|"
         r"it isn't|it's not|they aren't)\b)",
         "conditions are not judged; say what is to be"),
    )
)  # fmt: skip


def refuse_beyond(instruction: str) -> None:
    """Refuse an instruction that asks for what no tool does, rather than do a part of it.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``, naming the words and what would be accepted.
    """
    text = " ".join(instruction.split())
    for pattern, reason in _BEYOND:
        match = pattern.search(text)
        if match:
            words = match.groupdict().get("word") or match.group()
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"not understood: {words.strip(' ,.;:')[:80]!r}: {reason}; {EXAMPLES}",
                path="$.instruction",
                details={"words": words[:80]},
            )
