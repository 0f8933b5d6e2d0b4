"""Whole sentences said in another way: frames dropped, and turns that speak of a thing twice made one wish."""

import re
from typing import Final

__all__ = ["rephrased"]

_WHO: Final = r"(?:the |my |our |a |an )?(?:subject|participant|robot|agent|user|person|policy|model)"
_RUN: Final = r"(?:experiment|trial|episode|test|task|run|study|demo|session|evaluation|recording|benchmark|rollout)s?"
_ON: Final = r"(?:on|onto|in|into|inside|at|next to|from|off|out of)"
_INSIDE: Final = re.compile(
    r"\b(?:fridge|refrigerator|freezer|cabinet|cupboard|drawers?|wardrobe|box|oven|microwave|dishwasher|basket|bin)\b",
    re.IGNORECASE,
)

_FRAMES: Final = re.compile(
    rf"^(?:(?:for|in|before|during|at the start of|when|once) (?:the |my |our |this |that |a |an |each |every |"
    rf"its )?(?:\w+ ){{0,2}}{_RUN}(?: (?:begins?|starts?|runs?))?,? |"
    r"(?:the )?(?:initial|starting|start) (?:state|scene|conditions?|situation|setup)(?: is(?: that)?)?,? |"
    rf"(?:the |my |our |an? |each |every )?{_RUN} (?:starts?|begins?|needs|requires) (?:with |that )?(?=\w)|"
    r"do (?:the following|(?:these |those )?\w+ things),? |"
    r"(?:first|second|third|fourth|firstly|secondly|last),? (?=(?:put|place|add|remove|take|move|open|close|shut|turn|"
    r"switch|clear|empty|make|replace|set|bring|there)\b)|"
    r"(?:we|i)(?:'ll| will| are going to| am going to| plan to) (?:run|do|start|conduct|record) [^,]+, |"
    r"(?:bring|get|put) (?:me|us|it|the building|the scene) (?:in)?to a state (?:where|in which) |"
    r"it would (?:also )?be (?:good|nice|great) (?:if|to have) )+",
    re.IGNORECASE,
)

_SAYINGS: Final[tuple[tuple[str, str], ...]] = (
    # wishes for a thing
    (r"\b(?:have|has) to be (?=(?:on|in|inside|at|next)\b)", "must be "),
    (r"^(?:could|can|would|may|should|must) ((?:an?|the|some|one|two|three) .+?) (?=be\b)", r"\1 should "),
    (r"^(?:while|with) (the .+? (?:is|stays|remains|stands) (?:open|closed|shut|on|off)), ", r"\1 ;; "),
    (r"^(?:i|we) would (?:appreciate|be glad of|be happy with|welcome) (.+)$", r"there is \1"),
    (r"^(?:i|we) (?:am|are) going to need ", "i need "),
    (rf"^{_WHO} expects (?:to find )?(.+)$", r"there is \1"),
    (r"^(?:somebody|someone|i|we|they) forgot to (\w+ .+)$", r"\1"),
    (r"\b(?:is|are) short of\b", "needs"),
    (r"^(?:is|are) (.+) (reachable|accessible)(?= from .+$|$)", r"make \1 \2"),
    (r"\bwhoever (?:walks|comes|goes|steps|gets) (?:over )?to (.+?) (?:sees|finds|has) (.+?) (on|in) it$",
     r"there is \2 \3 \1"),
    (r"^((?:add|put|place|bring) .+?),? (?:and|but) nothing (?:to|onto|into) [^,]+$", r"\1"),
    (r"^(?:both )?(.+?) and (.+?) should be (\w+) and (\w+),? respectively$",
     r"\1 should be \3 ;; \2 should be \4"),
    (r"^(the .+?) (?:is|are|looks?|seems?) (?:a bit |rather |much |far )?too \w+,? (?:and |so )?(tidy|clear|clean|"
     r"empty) it(?: up| off| out)?\b(.*)$", r"\2 \1\3"),
    (r"^(?:tidy|clear|clean|empty)(?: up)? (.+?)(?: up)? by (?:removing|taking away|clearing away) (?:everything|all) "
     r"(?:but|except(?: for)?|apart from|other than) (.+)$", r"remove everything from \1 except \2"),
    (r", which (should|must|has to) be (open|closed|shut|on|off)\b", r" ;; it \1 be \2"),
    (r"^(.+?), one of which (?:is|should be|must be) (\w+)$", r"\1 ;; one of them should be \2"),
    (r"\bwhatever (\w+(?: \w+)?) (?:you find|there is|is|lies) (?=on|in)", r"the \1 "),
    (r"\b(?:lie|lies|be|is)? ?within (?:arm's )?reach of\b", "next to"),
    (r"^(?:would|is|will) it (?:be )?(?:possible|ok|okay) to (?:have|get|put|add|place) (.+)$", r"there is \1"),
    (r"^what (?:i|we) (?:want|need|would like)(?: to have| to see)? (?:is )?(.+)$", r"there is \1"),
    (r"^(?:i|we) (?:was|were|am|are) (?:hoping|looking|going) (?:to (?:find|have|see)|for) (.+)$", r"there is \1"),
    (r"^(?:i|we) (?:require|could use|could do with) (.+)$", r"there is \1"),
    (r"^(?:can|could|may) (?:i|we) (?:get|have) (.+)$", r"there is \1"),
    (r"^(?:i|we) can get ((?:an?|one|two|three|four|some|another|\d+) .+)$", r"there is \1"),
    (rf"^{_WHO} (?:needs|requires|wants) (.+)$", r"there is \1"),
    (r"\b(?:wants|could do with|could use|cries for) (?=(?:an?|one|two|three|four|five|six|some|another|\d+) )",
     "needs "),
    (r"^(.+) would be (?:good|nice|great|fine|helpful|perfect|lovely)(?: there| to have)?$", r"there is \1"),
    (r"^make it ((?:an?|one|two|three|four|five|six|\d+) .+)$", r"there is \1"),
    (r"^not only (?:should|must) there be (.+?),? but (.+)$", r"there is \1 and \2"),
    (r"^(?:set|lay|prepare|arrange|equip) (the .+?) for [^,]+, (.+)$",
     r"\1 needs \2"),
    # numbers
    (r"^there (?:should be|must be|is|are) (?:as few as |as many as )(\w+ .+?)(?:, exactly \w+)?$", r"there is "
                                                                                                    r"exactly \1"),
    (r",? (?:and )?(?:second|third|fourth|last)(?:ly)?,? (?=(?:put|place|add|remove|take|move|open|close|turn|switch|"
     r"clear)\b)", ", "),
    (r"\ba total of\b|\bin total\b|\ball in all\b", ""),
    (r"^(.+?),? (?:no more and no less|neither more nor less|no more,? no less|not more and not less)$", r"exactly \1"),
    (rf"^(?:increase|raise|bring|get) the (?:number|count) of (.+?) ({_ON} .+) (?:up )?to (\w+)$", r"there is \3 \1 "
                                                                                                   r"\2"),
    (rf"^(?:reduce|decrease|limit|lower|cut|restrict) the (?:number|count) of (.+?) ({_ON} .+) (?:down )?to (\w+)$",
     r"there is atmost \3 \1 \2"),
    (rf"^the (?:number|count) of (.+?) ({_ON} .+) (?:should|must|has to|is to|ought to) (?:be|equal) (?:exactly "
     rf")?(\w+)$",
     r"there is exactly \3 \1 \2"),
    (r"^(?:up to|to|atmost) (.+?) (?:may|can|might|are allowed to|is allowed to) (?:stay|remain|be|lie|stand) (on|in) "
     r"(.+)$",
     r"there is atmost \1 \2 \3"),
    (r"^(.+?) each (on|in|at) (the .+?) and (?:(?:on|in|at) )?(the .+)$", r"\1 \2 \3 ;; \1 \2 \4"),
    # not wanted
    (r"^do not (?:allow|have|keep|leave|put|tolerate) more than (.+)$", r"there is atmost \1"),
    (r"^(?:make sure|ensure|check|see to it) (?:that )?(?:nobody|no one) (?:has )?left (.+?) (open|on)$",
     r"\1 should not be \2"),
    (r"^(?:keep|leave) (.+?) (on|in) (.+?),? (?:but|and) (?:take|remove|clear|throw) (?:away )?(?:all |everything "
     r")?(?:the )?"
     r"(?:rest|others?|else)(?: away| off)?$", r"nothing but \1 \2 \3"),
    (r"^(?:swap|replace|exchange|trade) (?:what|whatever|everything|all that) ?(?:is |lies )?(on|in) (.+?) (?:for|"
     r"with|by) (.+)$",
     r"nothing but \3 \1 \2"),
    (r"^(?:i|we) (?:do|would|can) not (?:want|need|like|wish|stand)(?: to (?:see|have|find))? (?:any )?(.+?)"
     r"(?: any ?more| any longer| no more)?$", r"there is no \1"),
    (r"^(?:i|we) would (?:rather|prefer)(?: to)? not (?:to )?(?:see|have|find) (?:any )?(.+)$", r"there is no \1"),
    (r"^(.+?) (?:has|have) no business (on|in|at) (.+)$", r"there is no \1 \2 \3"),
    (r"^(.+?) should no longer (?:have|hold|carry|contain) (.+)$", r"\1 should not have \2"),
    (r"^it (?:must|should|can|may) not be possible to (?:find|see|have) (?:an? |any )?(.+)$", r"there is no \1"),
    (r"^there (?:may|can|might) be (.+?)(?: elsewhere| in other places)?,? but not (on|in|at) (.+)$",
     r"there is no \1 \2 \3"),
    (r"^(?:make|keep|leave) (.+?) (\w+)-free$", r"keep \1 free of \2"),
    (r"^(.+?) (should|must|has to|is to) be (\w+)-free$", r"\1 \2 be free of \3"),
    (r"^without (.+?), (?:clear|take|remove|get) (?:it|them) (?:off|from|out of) (.+)$", r"remove \1 from \2"),
    # one for another
    (r"^(?:substitute|put in) (.+?) for (the .+)$", r"replace \2 with \1"),
    (r"^(?:rather than|in place of|instead of) (the .+?), (the .+?) (?:should|must|has to|is to) (?:have|hold|carry|"
     r"contain) (.+?)"
     r"(?: (?:on|in) it)?$", r"replace \1 on \2 with \3"),
    (r"^where (.+? (?:lies|stands|is|sits))? ?(on|in) (.+?), (?:there (?:is|should be)|i need|we need|i want|put|"
     r"place) (.+)$",
     r"replace \1 \2 \3 with \4"),
    (r"^wherever (.+?) (?:is|lies|stands) ((?:on|in) .+?), (put|place|add|set) (.+?) (?:close by|close to it|next to "
     r"it|"
     r"next to|there|beside it)$", r"\3 \4 next to \1 \2"),
    (r"^(.+?) (?:close by|right by) (the .+)$", r"\1 next to \2"),
    (r"^(?:put|place|move) (the .+?) (?:of|on|from) (the .+?) where (the .+?) (?:of|on|from) (the .+?) is,? (?:and )?"
     r"vice versa$", r"swap \1 on \2 and \3 on \4"),
    (r"^(?:i|we) (?:want|need|would like) ((?:the |a )?(?:robot|agent)|someone|somebody|people) to (?=get|go|reach|"
     r"walk|drive)", r"\1 can "),
    (r"^check (?:the|this|that) (?:way|path|route),? (?:and )?", ""),
    (r"^(.+?),? - (?:all|both|everything)(?: of (?:it|them|this))? (on|in) (the .+)$", r"\2 \3, there is \1"),
    # taken and put
    (rf"^(?:grab|pick up|pick|take|get|fetch|lift|collect) (.+? {_ON} .+?)(?: up)?(?:,? and(?: then)?|,(?: then)?) "
     r"(?:put|place|bring|carry|set|lay|drop|move|take|deliver) (?:it|them) (?:down )?(?:on|onto|in|into|to) (.+?)"
     r"(?:,? and (?:leave|keep|put) (?:it|them) there)?$", r"move \1 to \2"),
    (r"^(?:i|we) (?:want|need|would like) (.+?) moved(?:,| and)? (?:bring|take|carry|put|move) (?:it|them) "
     r"(?:to|on|onto|in|into) (.+)$", r"move \1 to \2"),
    (r"^(?:i|we) (?:want|need|would like) (.+?) (?:moved|brought|taken) to (.+)$", r"move \1 to \2"),
    (r"^(the .+? (?:on|in|from) .+?) (?:belongs?|goes|should (?:go|sit|lie|stand|rest)|must go|has to go|ought to go)"
     r" (?:on|in|to|into|onto)"
     r" (the .+)$",
     r"move \1 to \2"),
    # places spoken of
    (r"^(?:go|walk|drive) to (.+?),? and put (.+?) (in|on) (?:it|there)$", r"put \2 \3 \1"),
    (r"^(?:look at|see|consider|take|check) (.+?), (the .+?) there (?:is|stands|lies) in the way$", r"there is \2 on "
                                                                                                    r"\1"),
    (r"^(.+) on the same \w+ as .+?, that is,? (.+)$", r"\1 on \2"),
    # everything of a kind of state
    (r"^(?:all|every|the) (?:the )?doors? (?:of|on) (?:all |the )*(?:furniture|cabinets?) in (.+?) (?:should|must|has"
     r" to|have to) be "
     r"(open|close|shut)(?:d|ed)?$", r"\2 everything in \1"),
    (r"^(?:(?:i|we) (?:want|need|would like)|make sure|ensure|have|leave|keep) (the [^,]+?) and (the [^,]+?) (?:are |"
     r"stay |to be )?"
     r"(open|closed|shut|on|off)$", r"\1 should be \3 ;; \2 should be \3"),
    (r"^(?:everything|all (?:the )?(?:things|objects|devices|items)|whatever) (?:that |which )?can be (?:open|clos|"
     r"shut)\w* "
     r"(in|on) (.+?) (?:should|must|has to|have to|is to) be (open|close|shut)(?:d|ed)?$", r"\3 everything \1 \2"),
    (r"^(?:everything|all (?:the )?(?:things|objects|devices|items))( (?:in|on) .+?)? (?:that |which )?can be (?:turn"
     r"|switch)\w* "
     r"(?:on|off)( (?:in|on) .+?)? (?:should|must|has to|have to|is to) be (?:turned |switched )?(on|off)$",
     r"switch \3 everything\1\2"),
    (r"^(close|shut|open) (?:everything|anything|whatever|all) (?:that |which )?(?:is |stands |are )?(?:still "
     r")?(?:open|closed|shut) "
     r"(in|on) (.+)$", r"\1 everything \2 \3"),
    (r"^(?:turn|switch|power) (everything|(?:all|every) (?:the )?(?:\w+ )?\w+) (on|off) ((?:in|on) .+)$",
     r"switch \2 \1 \3"),
    (r"^((?:close|shut|open|switch on|switch off|turn on|turn off) )(?:all|every) (?:the |of the )?"
     r"(?:devices?|things?|objects?|appliances?|machines?|equipment) ", r"\1everything "),
    # ways
    (r"^starting (?:at|from|in) (.+?), (?:.+?) to ((?:the )?\S.*)$", r"there is a way from \1 to \2"),
    (r"\ball the way to\b", "to"),
)  # fmt: skip
_TABLE: Final = [(re.compile(pattern, re.IGNORECASE), turn) for pattern, turn in _SAYINGS]

_FETCH: Final = re.compile(
    rf"^{_WHO} (?:has to|must|should|will|needs to|is to|shall|is going to|(?:will|is going to) be (?:told|asked) to|"
    rf"is (?:told|asked|supposed) to) (?:pick up|pick|take|grab|fetch|get|find|collect) (?P<x>.+?)(?: up)? "
    rf"(?:from|off|out of) (?P<y>.+?)"
    r"(?:,? (?:and|then|and then) (?:bring|put|place|carry|deliver|take) it (?:to|on|onto|in|into) (?P<z>.+))?$",
    re.IGNORECASE,
)
_FOLLOWS: Final = re.compile(
    r"^(?:(?:make sure|ensure|check|see to it|provide|add|put|get|take care)(?: that)? ?(?:there is )?(?:one|it|some|"
    r"that|this|"
    r"there is one|there is)(?: there| is there| exists?)?(?: if .*)?|(?:make|keep) (?:that|this|it) (?:possible|so)|"
    r"(?:please )?fix (?:that|this|it)|do (?:it|that|this)(?: for \w+)?|take the (?:others|rest) away|remove the "
    r"(?:others|rest))$",
    re.IGNORECASE,
)

_REMAIN: Final = re.compile(
    r"^(?:only |just )(?P<kept>.+?) (?:may|should|must|can|is to|shall) (?:remain|stay|be left)"
    r"(?: (?:there|on it|in it))?$",
    re.IGNORECASE,
)
_CLEARED: Final = re.compile(
    r"^(?:free|clear|empty|tidy|clean)(?: up| off| out)? (?P<place>the .+?)(?: (?:up|off|out))?"
    r"(?: (?:from|of) (?:clutter|everything|all (?:things|objects)))?$",
    re.IGNORECASE,
)


def rephrased(sentences: list[str]) -> list[str]:
    """Return sentences in forms that clauses know; those that only repeat the one before are left out.

    Examples
    --------
    >>> rephrased(["grab the pen on the desk and put it on the sideboard"])
    ['move the pen on the desk to the sideboard']
    """
    out: list[str] = []
    for sentence in sentences:
        if out and _FOLLOWS.match(sentence):
            continue
        for plain in _said(sentence):
            out += [part for part in (_moved_after(out, plain)) if part]
    return out


def _said(text: str) -> list[str]:
    """Apply the turns to one sentence; some become several."""
    whole = _FRAMES.sub("", re.sub(r"(?:\s*,)+", ",", text)).strip(" ,")
    fetch = _FETCH.match(whole)
    if fetch:
        relation = "in" if _INSIDE.search(fetch["y"].split(" in ")[0]) else "on"
        way = [f"there is a way to {fetch['z']}"] if fetch["z"] else []
        return [f"there is {fetch['x']} {relation} {fetch['y']}", *way]
    for pattern, turn in _TABLE:
        whole = pattern.sub(turn, whole)
    parts = [" ".join(part.replace(" ,", ",").split()).strip(" ,") for part in whole.split(";;")]
    return [part for part in parts if part]


def _moved_after(before: list[str], text: str) -> list[str]:
    """Join ``the pen on the desk moved`` with the sentence that says where to."""
    rest = _REMAIN.match(text)
    cleared = _CLEARED.match(before[-1]) if before and rest else None
    if rest and cleared:
        before.pop()
        return [f"remove everything from {cleared['place']} except {rest['kept']}"]
    match = re.match(r"^(?:bring|take|carry|put|move) (?:it|them) (?:over )?(?:to|on|onto|in|into) (.+)$", text, re.I)
    had = re.match(r"^there is (?:an?|the|one) (.+)$", before[-1], re.I) if before and match else None
    if match is None or had is None or not re.search(rf" {_ON} ", had[1]):
        return [text]
    before.pop()
    return [f"move the {had[1]} to {match[1]}"]
