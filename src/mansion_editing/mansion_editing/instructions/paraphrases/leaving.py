"""Ways of saying that things shall go: ``no need to keep``, ``can do without``, ``has got to go``."""

from typing import Final

from mansion_editing.instructions.paraphrases.patterns import Rule, rules

__all__ = ["LEAVING"]

_UNUSED: Final = (
    "(?:surplus|superfluous|redundant|surplus to requirements|no longer needed|no longer required|not needed any ?more|"
    "not needed any longer|for the (?:skip|tip|bin|chop|dump)|history|ready for the (?:skip|tip|bin|dump)|to go|"
    "to be thrown (?:out|away)|to be removed|to be taken (?:away|out)|to be got rid of)"
)

LEAVING: Final[tuple[Rule, ...]] = rules(
    (r"{^}(?:there is )?no (?:further |more )?(?:need|use|call) (?:for|of) ({np})(?: any ?more| any longer)?{$}",
     r"remove \1"),
    (r"{^}(?:there is |{I} have )?no (?:further |more )?need (?:to|for us to|for you to) keep ({np})"
     r"(?: any ?more| any longer)?{$}", r"remove \1"),
    (r"{^}{I} (?:have|see|find) no (?:further |more )?use for ({np})(?: any ?more| any longer)?{$}", r"remove \1"),
    (r"{^}{I} (?:can|could) (?:easily |well |gladly )?(?:do|live|manage) without ({np}){$}", r"remove \1"),
    (r"{^}{I} (?:can|could) (?:easily |well |gladly )?spare ({np}){$}", r"remove \1"),
    (rf"{{^}}((?:the|our|my|this|that|these|those|both|all) {{lead}}) (?:is|are)(?: now| all| both)? {_UNUSED}{{$}}",
     r"remove \1"),
    (r"{^}((?:the|our|my|this|that|these|those|both|all|it|they|one|{num}) ?{lead}) "
     r"(?:has to|have to|has got to|have got to|needs to|need to|is to|are to|may|should|must|can|ought to|"
     r"had better|is supposed to|wants to) (?:just |now |simply |all |both )?(?:go|leave|disappear|vanish|come out|be gone)"
     r"{$}", r"\1 must go"),
    (r"{^}see the back of ({np}){$}", r"remove \1"),
    (r"\b(?:say goodbye to|part with|see off|wave goodbye to|bid farewell to|purge|banish|evict|oust|expel|retire|"
     r"cull|axe|eject|clear away|cart off|cart away|haul away|haul off|whisk away|spirit away|take away|do away with|"
     r"bin off|be done with|sell off|sell|donate|give away|recycle|scrap) (?=(?:the|our|my|this|that|these|those|both|all|"
     r"every|each|half|one|two|three|four|five|six|\d+|it|them) ?)", "remove "),
    (r"\b(?:cart|haul|whisk|spirit|clear|take|chuck|lug|drag|throw|toss|sling|bundle) "
     r"({np}|it|them|both) (?:away|off|out) from ", r"remove \1 from "),
    (r"{^}({np}|it|they) (?:can|could|should|may|must|has to|have to|needs to|need to|is to|are to) be (?:all |both )?"
     r"(?:got rid of|thrown (?:out|away)|disposed of|done away with|taken away|binned|chucked(?: out)?|scrapped|ditched|"
     r"recycled|given away|sold|donated|discarded|dumped|dismantled|cleared away|cleared out)(?: of)?{$}", r"remove \1"),
    (r"\bremove they\b", "remove them"),
    (r"\bonly one of ((?:the|our|those) [\w -]+?) (?:is to|should|may|must|can|shall|will) (?:stay|remain)[:,;-]+ (?:and that is )?"
     r"(the one {rest})[.;,] (?:and )?(?:all )?(?:the |all )?(?:{num} )?others? (?:must go|can go|go|can leave){end}",
     r"remove all \1 except \2"),
    (r"\bgive ({np}|it|them) the (?:boot|push|chop|heave-ho|sack|elbow)\b", r"remove \1"),
)  # fmt: skip
"""Put as ``remove`` and ``must go``."""
