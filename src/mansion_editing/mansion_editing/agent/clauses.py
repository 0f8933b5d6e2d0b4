"""Sentences to clauses: what each asks for (be there, be gone, be moved, be open, be reached) and of what."""

import re
from dataclasses import dataclass, field
from typing import Final

from mansion_editing.agent.wholes import whole_of

__all__ = ["Clause", "clauses_of"]

_MODAL = (
    r"(?:should|must|ought to|has to|have to|needs? to|shall|will|would|is to|are to|(?:is|are) supposed "
    r"to|can|may)"
)
_BE = (
    r"(?:is|are|be|stays?|remains?|lies?|sits?|stands?|rests?|goes|go|belongs?|exists?|gets?|comes?|"
    r"(?:be|is|are|get|gets) (?:placed|put|found|kept|left|provided|added|set|laid|stored|located|brought|"
    r"delivered)?)"
)
_AT = r"(?:on|in|inside|into|within|at|next to|under|by|upstairs|downstairs|there)\b"
_SUBJECT = (
    r"(?:the |a )?(?:robot|one|you|people|someone|anyone|somebody|anybody|everyone|everybody|i|we|"
    r"visitors?|guests?|staff|person|it)"
)
_GO = r"(?:get|go|walk|drive|reach|travel|move|come|navigate|access|enter|make it|find (?:my|its|the|a) way)"
_SEE: Final = re.compile(
    r"^(?:(?:make (?:absolutely )?(?:sure|certain)|ensure|check|verify|see to it|see|confirm|guarantee|assure|"
    r"arrange|"
    r"be sure|take care|(?:i|we) (?:want|need|would like|would love|would prefer|wish for|require|expect|am "
    r"missing|are missing|lack)"
    r"(?: to (?:see|have|find))?|let|have|get)\b(?: (?:that|whether|if|for))?)\s+",
    re.IGNORECASE,
)

_CLAUSES: Final[tuple[tuple[str, str], ...]] = (
    # ways
    ("path", rf"(?:there {_MODAL}? ?(?:is|are|be) )?(?:provide |keep |leave |make )?(?:an?|the|"
        rf"some)? ?(?:clear|free|open|unobstructed|possible|working)? ?"
        r"(?:way|path|route|access|passage|connection|walkway)s?\b(?: (?:leading|going|that "
        r"leads))? ?(?P<b>(?:from|to|into|towards)\b.*?)?"
        rf"(?: (?:{_MODAL} )?(?:(?:is|be|are|stays?|remains?|kept) )?(?:clear|free|open|possible|available|"
        rf"unobstructed|there))?"),
    ("have", rf"{_SUBJECT} (?:{_MODAL}|could|wants? to) (?:be able to )?(?:find|see|have|pick up|grab) "
        rf"(?P<x>(?!(?:my|its|the|a|his) way).+)"),
    ("path", rf"{_SUBJECT} (?:(?:{_MODAL}|could|am|is|are) )?(?:be )?(?:able to )?(?:{_GO} (?P<b>(?:to|into|in|inside"
             rf"|from|"
        r"through|around|towards|up|down|over|upstairs|downstairs|there|anywhere|everywhere)\b.*)|(?:reach|access|"
        r"enter) (?P<c>.+))"),
    ("path", rf"it {_MODAL}? ?(?:is|be) possible (?:for .+? )?to {_GO} (?P<b>.+)"),
    ("path", r"nothing (?:should |must |may |can )?blocks? (?:the )?(?:way|path|route|access)(?P<b> .+)"),
    ("reach", rf"(?P<b>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?) (?:reachable|accessible|reached|"
        rf"within reach|connected)"
        r"(?: (?:by|for) (?:the |a )?\w+)?(?: (?:from|to|with) (?P<a>.+))?"),
    ("reach", r"(?:make |keep )?(?P<b>.+?) (?:reachable|accessible)(?: from (?P<a>.+))?"),
    ("reach", rf"{_SUBJECT} (?:{_MODAL} )?(?:has|have) (?:an? )?(?:clear |free )?(?:access|way|path|route) to "
        rf"(?P<b>.+)"),
    # nothing, empty
    ("quality", rf"(?:they|it|these|those|both|all of them) (?:{_MODAL} )?(?:be|is|are) (?P<v>\w+)"),
    ("clear", rf"nothing (?:else )?(?:{_MODAL} )?(?:{_BE} )?(?:left )?(?:on|in|inside|at) (?P<y>.+)"),
    ("absent_on", rf"(?P<y>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?) (?:free|clear|empty|rid|cleared|"
        rf"emptied) (?:of|from) (?:all |any )?(?P<x>.+)"),
    ("absent_on", r"(?:keep|clear|empty|rid|strip|free|leave|make) (?P<y>.+?) (?:free |clear |empty )?of "
        r"(?:all |any )?(?P<x>(?!the \w+ room).+)"),
    ("clear", rf"(?P<y>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?|gets?) (?:completely |totally "
        rf")?(?:empty|clear|cleared|emptied|bare|tidied|free)(?: up| off| out)?"),
    ("clear", r"leave nothing (?:on|in) (?P<y>.+)"),
    ("absent", r"(?:clear|clean|tidy|sweep) (?:away |up )?(?P<x>.+? (?:off|from|out of) .+)"),
    ("clear", r"(?:clear|empty|tidy|clean)(?: off| out| up)? (?P<y>.+?)(?: off| out| up| completely)?"),
    ("clear", r"remove (?:everything|all (?:things|objects|items)|anything|whatever is)(?: that is)? (?:from|"
        r"on|off|in) (?P<y>.+)"),
    # not open, not on
    ("unstate", rf"(?P<x>.+?) (?:{_MODAL} not (?:be |stay |remain |stand |run )?|(?:is|are) not (?:{_MODAL} )?(?:be "
                rf")?)(?:switched |turned "
        r"|left |kept )?(?P<v>open|opened|closed|shut|on|off|running|lit)"),
    ("unstate", r"do not (?:leave|keep|let|have) (?P<x>.+?) (?:be )?(?:switched |turned )?(?P<v>open|opened|closed|"
                r"shut|on|off|running|lit)"),
    # gone
    ("absent", rf"there (?:{_MODAL} )?(?:is|are|be|not be|is not|are not|be not)? ?(?:no longer (?:be )?|no|"
        rf"not|never|none of) (?:be )?(?:any |a |an |a single )?(?P<x>.+)"),
    ("absent_on", rf"(?P<y>.+?) (?:{_MODAL} not|does not|do not|must not) (?:have|contain|hold|carry|include|"
        rf"keep|store) (?:any |a |an )?(?P<x>.+?)(?: (?:on|in|inside) (?:it|them|there))?"),
    ("absent", rf"(?:no|none of the|none of|not a single|not any|neither|nor) (?P<x>.+?) (?:{_MODAL} "
        rf")?{_BE}(?: left)? (?P<loc>{_AT}.*)"),
    ("absent", rf"(?P<x>.+?) (?:{_MODAL} not (?:{_BE})?|(?:is|are) not(?: {_MODAL})?|do not belong|does not "
        rf"belong|has no place|have no place) (?P<loc>{_AT}.*)"),
    ("absent", rf"(?P<x>.+?) (?:{_MODAL} )?(?:be |is |are |gets? )(?:removed|gone|taken away|deleted|thrown "
        rf"away|discarded|cleared away)(?P<loc> .*)?"),
    ("absent", rf"(?P<x>.+?) {_MODAL} (?:go|go away|disappear|vanish|leave)"),
    ("absent", r"do not (?:leave|keep|put|have|allow|store) (?:any |a |an )?(?P<x>.+)"),
    ("absent", r"keep (?P<x>.+? (?:off|out of|away from) .+)"),
    ("absent", r"(?:remove|delete|take away|take off|take out|get rid of|throw away|throw out|dispose of|"
        r"discard|eliminate|clear away|erase|bin|rid) (?P<x>.+)"),
    ("absent", r"take (?P<x>.+? (?:away|off|out of)(?: .+)?)"),
    ("absent", r"take (?P<x>.+? from (?!.*\b(?:to|into|on)\b).+)"),
    ("no", r"(?:no|none of the|not a single|without|neither|nor) (?P<x>.+)"),
    # replaced
    ("swap", r"(?:replace|swap|exchange|trade|switch)(?: out)? (?P<x>.+?) (?:with|by|for) (?P<z>.+)"),
    # open, closed, on, off
    ("state", r"(?P<v>open|close|shut)(?: up)? (?P<x>.+)"),
    ("state", r"(?:turn|switch|power|put) (?P<v>on|off) (?P<x>.+)"),
    ("state", r"(?:turn|switch|power|leave|keep|put|make|set) (?P<x>.+?) (?P<v>open|opened|closed|shut|on|off|"
        r"switched on|switched off|turned on|turned off|running)"),
    ("state", r"(?P<v>activate|deactivate|start|stop|light) (?P<x>.+)"),
    ("state", rf"(?P<x>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?|being|left|kept|stand|stands|"
        rf"gets?)? ?(?:switched |turned |powered |wide |left |kept )?(?P<v>open|opened|closed|shut|on|off|"
        rf"running|lit)"),
    # moved
    ("move", r"(?:move|relocate|transfer|carry|shift|transport|haul) (?P<x>.+)"),
    ("move", r"(?:bring|take|put|place|fetch|get|deliver) (?P<x>(?!a |an |two |three |\d)[^,]+? from .+? "
        r"(?:to|into|on|in) .+)"),
    ("move", r"(?:bring|take|fetch|deliver) (?P<x>(?:the|all|every|that|this|those|these) .+? (?:to|into) .+)"),
    ("move", rf"(?P<x>.+?) (?:{_MODAL} )(?:be (?:moved|relocated|transferred|brought|carried|taken|shifted)|"
        rf"move|go)(?P<loc> (?:from|to|into|over to) .+)"),
    # there
    ("have", rf"there (?:{_MODAL} )?(?:is|are|be|exists?|lies?|stands?) (?P<x>.+)"),
    ("hold", r"(?:equip|stock|fill(?: up)?|set|furnish|supply|provide|load|set up|outfit|decorate|lay) "
        r"(?P<y>.+?) with (?P<x>.+)"),
    ("hold", r"give (?P<y>the .+?|every .+?|each .+?) (?P<x>(?:a|an|one|two|three|four|five|six|another|some|"
        r"\d+) .+)"),
    ("hold", rf"(?P<y>(?!{_AT}|i |we |there ).+?) (?:(?:{_MODAL} )?(?:have|has|contains?|holds?|carry|carries|"
        rf"stores?|keeps?|features?|includes?|gets?|offers?)|needs?|requires?|lacks?|is missing|are missing|"
        rf"(?:{_MODAL} )?(?:be|is|are) (?:equipped|stocked|filled|furnished|loaded|provided|supplied) with) "
        rf"(?P<x>.+?)(?: (?:on|in|inside|within) (?:it|them|its top))?"),
    ("hold", rf"(?:{_MODAL} )?(?:contains?|holds?|has|carries|stores?) (?P<x>.+)"),
    ("have", rf"(?P<x>.+?) (?:{_MODAL} )?{_BE}(?: (?:placed|put|found|kept|left|lying|standing|sitting))? "
        rf"(?P<loc>{_AT}.*)"),
    ("have", r"(?:put|place|add|provide|set|lay|leave|bring|supply|install|position|deposit|drop|store|keep|"
        r"stick|rest|insert|deliver|fetch|find|locate|"
        r"arrange|create|spawn|furnish|prepare|hide|park|stand|set up|set out|lay out|i need|we need|i want) "
        r"(?P<x>.+)"),
    ("have", rf"(?P<x>.+?) {_MODAL} (?:be|exist)"),
)  # fmt: skip
_TABLE: Final = [(kind, re.compile(rf"^{pattern}$", re.IGNORECASE)) for kind, pattern in _CLAUSES]
_JOINTS: Final = re.compile(
    r"\s*,\s*(?:and |but |then |or )?(?:then |that )?|\s+(?:and|but|while|whereas|nor|and so) (?:then |that "
    r")?|\s+then\s+|\s+(?:such|so) that\s+",
    re.IGNORECASE,
)
_IDLE: Final = re.compile(
    r"^(?:make sure |ensure |see to it |do |check )?(?:that )?(?:(?:there|it|this|that) "
    rf"(?:is|are|{_MODAL} be)(?: so| true| the case| one)?|so|it|yes|no)$",
    re.IGNORECASE,
)
_LEADING: Final = re.compile(
    rf"^(?P<loc>(?:on|in|inside|at|next to)\b.+?) (?P<rest>(?:there (?:{_MODAL}|is|are)|put|place|add|make sure|"
    r"ensure|i want|we need|leave|set|lay|remove|i would like|have)\b.+)$",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class Clause:
    """What a piece of a sentence asks for.

    Attributes
    ----------
    kind : str
        ``have``, ``hold``, ``absent``, ``absent_on``, ``clear``, ``state``, ``move``, ``swap``, ``path``, ``reach``,
        ``quality``; of whole sentences ``only``, ``exchange``, ``mention`` and ``some``;
        ``place`` for a place alone; empty for things whose clause is the one before, or the one after.
    words : dict of str to str
        Its parts: `x` things, `y` the receptacle or room, `loc` a place, `z` what replaces, `a` and `b` ends of a way,
        `v` a state.
    """

    kind: str
    words: dict[str, str] = field(default_factory=dict)


def clauses_of(sentence: str) -> list[Clause]:
    """Return the clauses of a sentence in its order."""
    whole = whole_of(sentence)
    if whole is not None:
        return [Clause(*whole)]
    out: list[Clause] = []
    for piece in _JOINTS.split(sentence):
        words = piece.strip(" ,")
        if words:
            out += _clauses(words)
    return out


def _clauses(words: str) -> list[Clause]:
    leading = _LEADING.match(words)
    if leading:
        return [Clause("place", {"loc": leading["loc"].strip(" ,")}), *_clauses(leading["rest"])]
    if _IDLE.match(words):
        return []
    bare = re.sub(
        r"^(?:i|we) (?:want|would like|need|expect|require) (.+?) to (?=(?:be|have|contain|hold|stand|lie|"
        r"stay|remain|go|reach)\b)",
        r"\1 should ",
        words,
        flags=re.IGNORECASE,
    )
    asked = bare != words
    for _ in range(3):
        match = _SEE.match(bare)
        if match is None:
            break
        asked, bare = True, bare[match.end() :]
    for kind, pattern in _TABLE:
        found = pattern.match(bare)
        if found:
            parts = {name: (text or "").strip() for name, text in found.groupdict().items()}
            return [Clause(kind, parts)]
    if asked:
        return [Clause("have", {"x": bare})]
    if re.match(rf"^{_AT}", bare, re.IGNORECASE):
        return [Clause("place", {"loc": bare})]
    return [Clause("", {"x": bare})]
