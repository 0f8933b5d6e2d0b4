"""Ways of saying that things shall be elsewhere, or in another state: ``down to the cellar with it``."""

from typing import Final

from mansion_editing.instructions.paraphrases.patterns import Rule, rules

__all__ = ["CARRYING"]

_DONE: Final = (
    "moved|placed|taken|removed|switched|turned|opened|closed|shut|replaced|relocated|carried|brought|painted|"
    "swapped|exchanged|cleared|emptied|hung|gone|thrown|shifted|returned"
)
_KNOWN: Final = r"(?:(?:the|our|my|this|that|these|those|both|all|every|her|his|their)\b(?: (?!(?:and|or|but)\b)[\w'-]+){1,9}?)"
_WITH: Final = r"(?:(?:down|up|off|over|out|back|straight|away) )*(?:to|into|onto|in)"

CARRYING: Final[tuple[Rule, ...]] = rules(
    (r"{^}(?:let|have|see that) ({np}) (?:remains?|stays?)(?: exactly| right| just)? (?:where (?:it|they) (?:is|are)|"
     r"as (?:it|they) (?:is|are)|there|here|in place|put)", r"leave \1 where it is"),
    (r"{^}(?:lay|set|deck|dress|decorate|cover|adorn|garnish) ({np}) with ((?!it\b|them\b){rest}){end}", r"put \2 on \1"),
    (r"{^}(?:shift|move|take|get|bring|carry) ({np}) out of ({lead})[,;:.-]+ (?:it|they|that|those) "
     r"(?:would|will|should|could|is|are) (?:be|look|fit|do|fit in|go)? ?(?:(?:much|far|a lot|of) )*(?:better|nicer|more use|"
     r"more useful|well|nicely|more at home|better off|needed|wanted)? ?({on}) ({lead}){end}", r"move \1 from \2 to \4"),
    (r"{^}({np}) - [^.?!;]*\? ((?!is\b|are\b)\w+) (?:it|them)\b", r"\2 \1"),
    (r"{^}(?:and )?of ((?:the|our|those|these|my) {rest}), (?:please )?(\w+) ({num})(?: of them)? ", r"\2 \3 of \1 "),
    (r"\b(?:get|take|bring|move|clear) ({rest}) out of (?:here|there|it){$}", r"remove \1"),
    (r"{^}({on} {np}) there (?:should|must|shall|may|is to|can) be nothing (?:but|except|except for|other than|besides) "
     r"({rest}){end}", r"remove everything except \2 from \1"),
    (r"\bfrom (?:on|in) (?=the|our|my)", "from "),
    (r"{^}there is (?:still )?no ([\w -]+?) ({on} {lead})(?: yet| at all| so far)?[.,;:-]+ (?:so |please |then )*"
     r"(put|lay|place|hang|set|stand|add) (?:one|it) ({on} {lead}){end}", r"\3 a \1 \4 \2"),
    (r"{^}((?:the|our|my) {lead}) (?:from|in|of) ({lead}) (?:is|are) (?:required|needed|wanted|supposed to be|meant to be)"
     r" (in|on|at) ({lead}){$}", r"move \1 from \2 to \4"),
    (r"\b(hang|put|set) (one|it|them) (?:up|down|out){$}", r"\1 \2 there"),
    (r"\band ({on} (?:the|our|my) [\w' -]+?),? ({new}){$}", r"and \2 \1"),
    (r"\b(?:{on}) (?:the|our|my)(?: [\w'-]+){1,3}(?:,? - ?|, ?|\. ?)(?:sorry|no|wait|or rather|rather|i mean|correction)"
     r"(?:[, ]+(?:no|wait|sorry|rather|i mean))*[,:]? ({on} (?:the|our|my) )", r"\1"),
    (r"\b(it|he|she|that|there) is (been|ended|gone|got|become|had|seen)\b", r"\1 has \2"),
    (r"{^}neither ({np}) nor ({np}) (?:is|are|gets?) (?:used|needed|wanted|required)(?: by anyone| by anybody| any ?more)?,",
     r"\1 and \2 are idle,"),
    (r"{^}({np}) (?:is|are|looks?|seems?|has|have) [^.,;:]{3,40}? and (can|could|should|must|may|has to|have to|needs? to|"
     r"belongs?|goes?|ought to) ", r"\1 \2 "),
    (r"{^}({np})(?: ?[:,]| -) (?:off |down |up |over |out |back |straight |away )*(to|into|onto) ({lead}) with "
     r"(?:it|them|that|those){$}", r"move \1 \2 \3"),
    (rf"{{^}}{_WITH} ({{lead}}) with ({{np}}|it|them|both|both of them){{$}}", r"move \2 to \1"),
    (r"{^}({np}) (?:does|do|really does|really do) not (?:really )?belong (in|on|at|by|under) ({lead}),? but "
     r"(?:rather )?(in|on|at|by|under|next to|beside) ({lead}){$}", r"move \1 \2 \3 to \4 \5"),
    (r"{^}({np}) (?:belongs?|should be|should go|should stand|must be|goes|is supposed to be|are supposed to be|"
     r"is meant to be|are meant to be) (in|on|at|by|under|next to|beside) ({lead}),? "
     r"(?:and )?(?:not|rather than|instead of)(?: (in|on|at|by|under))? ((?:the|our|my) {lead}){$}",
     r"move \1 in \5 to \2 \3"),
    (r"\bto (?:in|on|at|by) (the|our|my|this|that|her|his|their)\b", r"to \1"),
    (r"\bto (?:beside|next to|under) ", r"to next to "),
    (r"{^}(an? {lead}) (?:has|have) (?:been (?:left|put|placed|forgotten|dumped|parked|abandoned)|ended up|landed|"
     r"wound up|strayed|turned up) ({on} {lead}){$}", r"somebody left \1 \2"),
    (rf"{{^}}(?:have|get|take|bring|carry|move|{{I}} (?:want|need|would like)) ({_KNOWN}) (?:out of|from) ({{lead}}) and "
     r"(?:in|into|to|over to|onto|on) ({np}){$}", r"move \1 from \2 to \3"),
    (r"\bget ({np}) to (?:go|stand|sit|hang|be|lie|put) ({on}) ", r"put \1 \2 "),
    (rf"{{^}}(?:have|get|see|{{I}} (?:want|need|would like|would love)) ({_KNOWN}) ((?:{_DONE})\b)", r"\1 should be \2"),
    (rf"{{^}}{{I}} (?:want|need|would like|would love) ({_KNOWN}) (in|on|by|next to|beside|under|near|behind|against|"
     r"in front of|between) ", r"\1 should be \2 "),
    (r"{^}(?:have|let|see|make) ({np}) (stand|sit|hang|go|be|face|live|lie|rest|move) (?={on}|here|there)",
     r"\1 should \2 "),
    (r"{^}(?:{I}|she|he|they|dr\.? \w+|mrs?\.? \w+|ms\.? \w+|the \w+|my \w+|our \w+|[A-Z]\w+) "
     r"(?:wants?|needs?|would like|would love|would prefer) ({np}) (?:to be )?"
     r"(?:swapped|exchanged|traded|replaced|substituted) (?:for|with|by) ", r"replace \1 by "),
    (r"{^}({np}) (?:should |must |has to |shall |will )?(?:makes?|gives?) way (?:for|to) ", r"replace \1 by "),
    (r"{^}(?:clear|make|free up|free|create|gain|win|save)(?: up)? (?:some |a bit of |a little |more )?"
     r"(?:room|space|floor space)(?: for {lead})?,? by (\w+)ing ", r"\1ing "),
    (r"{^}(?:start|begin|finish|continue|go on|carry on|end)(?: off| up)? (?:by|with) (\w+)ing ", r"\1ing "),
    (r"\b(?:whatever|all that|everything which|anything that|all the things that|anything)(?: is| are| lies| stands)? "
     r"(?=(?:on|in|under|inside) (?:the|our|my|this|that|her|his))", "everything "),
    (r"\b(?:all|everything) of what is ", "everything "),
    (r"{^}(?:please )?(?:pop|go|nip|hop|run|head|walk|drive|swing|step|climb|drop|come)(?: on| up| down| over| across| "
     r"out| back| round| by)*(?: in)? (?:to|into|by) ({lead}) and (?=\w+ )", r"in \1, "),
    (r"{^}((?:in [^.,;]+(?=, ))?),? ?(?:see|check|find out|look|verify|have a look|tell me)(?: to see)? (?:whether|if) ({np}) "
     r"(?:is|are) ({state})[,;.:-]* (?:and )?if (?:it|they) (?:is|are) not,? ", r"is \2 \1 \3? If not, "),
    (r"{^}((?:in [^.,;]+(?=, ))?),? ?(?:see|check|find out|look|verify|have a look|tell me)(?: to see)? (?:whether|if) ({np}) "
     r"(?:is|are) ({state})[,;.:-]* (?:and )?if (?:so|it is|they are|that is the case),? ", r"is \2 \1 \3? If so, "),
    (r"{^}(?:in case|provided(?: that)?|assuming(?: that)?|supposing(?: that)?|in the event that) ({np}) (is|are) ",
     r"if \1 \2 "),
    (r"{^}should ({np}) (?:still )?be ({state}),", r"if \1 is \2,"),
    (r"{^}{lead} (?:swears?|says?|thinks?|claims?|believes?|reckons?|suspects?|noticed|told me|feels?|fears?|sure)"
     r"(?: that)? ({np}) (is|are)(?: still)? ({state})\. (.+?),? (?:if (?:so|that is (?:so|true|the case)|it is|they are)|"
     r"in that case){end}", r"If \1 \2 \3, \4"),
)  # fmt: skip
"""Put as ``move``, ``put``, ``replace``, ``should be`` and conditions."""
