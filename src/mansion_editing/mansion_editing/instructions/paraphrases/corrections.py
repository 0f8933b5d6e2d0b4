"""Slips that the writer puts right at once: ``the globe - sorry, the flip chart``, ``hold on, no. Just``."""

from typing import Final

from mansion_editing.instructions.paraphrases.patterns import DETERMINERS, Rule, rules

__all__ = ["CORRECTIONS"]

_NOT_SO: Final = (
    "sorry|no,? wait|no|nope|wait,? no|i mean(?:t)?|or rather|rather|actually|correction|scratch that|make that|hang on|"
    "hold on|pardon|excuse me|er|erm|uh|um|oops"
)
_MARKS: Final = r"(?:,? - ?|, ?|\. ?|\()"

CORRECTIONS: Final[tuple[Rule, ...]] = rules(
    (rf"\b(?:{DETERMINERS})(?: (?!(?:and|or|to|into|from|on|in)\b)[\w'-]+){{1,3}}{_MARKS}(?:{_NOT_SO})(?:[,:-]* "
     rf"(?:{_NOT_SO}))*[,: -]+(?:just |make that |i mean(?:t)? )*((?:{DETERMINERS})(?: (?!(?:and|or)\b)[\w'-]+){{1,3}}?)"
     r"(?: ?- ?|,? ?\)|, )?(?= (?:out|off|from|to|into|on|in|onto|next|beside|under|by|away)\b|[.!?;,]|$| -)", r"\1"),
    (rf"(?:^|(?<=[.!?] ))[^.!?]*? - (?:hold on|hang on|no wait|wait|scratch that|forget (?:that|it)|on second thoughts|no)"
     r"(?:,? (?:no|wait|sorry))*[.,!]+ (?:just |let us |rather |please )*(?=[a-z]+ )", ""),
)  # fmt: skip
"""What was said by mistake is left out."""
