"""English patterns of instructions (data): refusals, words to drop, paraphrases with their plain forms, clauses."""

import re
from typing import Final

__all__ = [
    "BRING_IT",
    "CARRIER_WITH",
    "CLAUSES",
    "CLEARED",
    "CONJUNCTIONS",
    "CONTRACTIONS",
    "COURTESIES",
    "EMPTY",
    "ENCLOSED",
    "EXAMPLES",
    "EXPRESSIONS",
    "FETCH",
    "FRAMES",
    "FRONTED_PLACE",
    "INDEFINITE",
    "MOVED",
    "NEGATED",
    "OBJECT_FIRST",
    "OPENINGS",
    "OPPOSITES",
    "PARAPHRASES",
    "PLACED",
    "PRONOUN",
    "QUESTION",
    "REASONS",
    "REMAINDER",
    "REPETITION",
    "REQUEST",
    "SENTENCES",
    "SENTENCE_ENDS",
    "STATES",
    "UNSUPPORTED",
    "VAGUE",
]

# Refusals
EXAMPLES: Final = (
    'what can be asked for: "put two red mugs on the desk in the kitchen", "nothing but a book on the coffee table", '
    '"move the pen from the desk to the sideboard", "remove the apples from the counter", "close everything in the '
    'kitchen", "turn on the lamp in the lobby", "make sure there is a way from the lobby to the kitchen"'
)
"""End of a refusal: instructions that are accepted."""


_VERB: Final = r"(?:^|[,;.:!?]\s*|\b(?:and|then|please|you)\s+)"
UNSUPPORTED: Final = tuple(
    (re.compile(pattern, re.IGNORECASE), reason)
    for pattern, reason in (
        (r"\b(?:to|on|at) (?:the|its) (?:left|right)(?: hand)?(?: side)? of\b|\b(?:left|right) of\b|\bbehind\b|"
         r"\bopposite\b",
         "directions are not supported; an object can be placed next to another"),
        (r"\b(?:clos|near|farth|furth|larg|small|bigg|tall|low|high|long|short|wid|old|new)est\b|\b(?:left|"
         r"right)most\b",
         "places are identified by name, not by comparison"),
        (r"\b(?:larg|small|bigg|tall|low|high|long|short|wid|narrow|warm|bright|dark|nic|clos)er\b(?= by|[.!]|$|"
         r" than)|\b(?:more|less) \w+(?:ing|ive|ant|able|ful)\b",
         "only objects, their places and their states can be changed"),
        (r"\b(?:every|each) (?:second|third|fourth|other)\b|\bhalf of\b|\b(?:some|most|many|few) of the\b|\d ?%|"
         r"\bpercent\b",
         "say how many, or all"),
        (r"\bin (?:a|one|two|three) (?:circles?|rows?|lines?|grids?|piles?|stacks?|patterns?|heaps?|triangles?)\b",
         "objects are placed where there is room, in no pattern"),
        (rf"{_VERB}(?P<word>stack|pile|line|align|sort|scatter|throw|rotate|spin|tilt|break|smash|burn|paint|knock|"
         r"demolish|wash|wipe|cook|fold|cut(?! the (?:number|count))|repair|build|widen|enlarge|resize|rename|undo|"
         r"redo)\b(?! away| out)",
         "no tool does this; objects can be placed, moved, removed, opened and switched"),
        (r"\bmake (?:a |\w+ )?(?P<word>copy|copies|duplicates?|clones?)\b",
         "copying is not supported; say what should be there"),
        (r"\b(?:clean|tidy|wipe)\b[^,;]* with\b",
         "no tool does this; objects can be placed, moved, removed, opened and switched"),
        (r"\bby [\w.]+ (?:degrees?|cm|m|mm|centimet\w+|met(?:er|re)s?)\b|\bweigh\w*|\b\d+ ?(?:kg|cm|mm|kilograms?|"
         r"degrees?)\b",
         "sizes, weights and angles are set by the asset"),
        (r"\beither\b[^.;]*\bor\b|\bor (?:an?|the|one|two|three)\b", "say which of them"),
        (r"\b(?:if|unless|otherwise|provided that|depending)\b(?! (?:there|not|possible|necessary|missing|need|"
         r"needed|none|so|one is|any|you (?:can|could|would)|(?:it|they|that)(?: is|'s| are|'re)?(?: not|n't)? "
         r"(?:there|missing|already|yet|possible|necessary|present)|it isn't|it's not|they aren't)\b)",
         "conditions are not supported; say what should be there"),
    )
)  # fmt: skip

# Sentences in plain words
CONTRACTIONS: Final = (
    (r"\b(there|that|it|here|what)'s\b", r"\1 is"),
    (r"\b(there|they|we|you)'re\b", r"\1 are"),
    (r"\b(i|we|they|you)'d like\b", r"\1 would like"),
    (r"\b(i|we|they|you)'d\b", r"\1 would"),
    (r"\b(i|we|they|you)'ve\b", r"\1 have"),
    (r"\bi'm\b", "i am"),
    (r"\blet's\b", ""),
    (r"\bcan't\b|\bcannot\b", "can not"),
    (r"\bwon't\b", "will not"),
    (r"\bshan't\b", "shall not"),
    (r"n't\b", " not"),
)
COURTESIES: Final = re.compile(
    r"\b(?:please|kindly|if possible|if you (?:can|could|would)|for me|for us|thank you|thanks|by the way|"
    r"as soon as possible|right away|right now|once you are done|when you are done|if need be|if necessary|"
    r"if (?:it is|they are|there is) not (?:there )?(?:already|yet)|if (?:it is )?missing|somewhere|anywhere|"
    r"as usual|at all times|in total|altogether|ready|neatly|carefully|quickly|already|again|currently|"
    r"somehow|simply|actually|really|definitely|certainly|always|still|furthermore|moreover|additionally|"
    r"in addition|besides that|as well(?! as)|also|too(?! \w)|finally|lastly|firstly|first of all|next up|afterwards|"
    r"after that|"
    r"at the same time|meanwhile|instead|though|however)\b(?! to\b)",
    re.IGNORECASE,
)
OPENINGS: Final = re.compile(
    r"^(?:(?:hey|hi|hello|ok|okay|robot|so|well|now|then|and|but|also|yes|right)\b[\s,]*|"
    r"(?:could|can|would|will) you (?:be so kind as to |mind )?|you (?:should|must|need to|have to|ought to|may) |"
    r"(?:i|we) (?:would like|want|need|ask|expect|wish) you to |"
    r"(?:i|we) (?:want|need|have|would like|wish) to (?=(?:see|have|find)\b)|"
    r"(?:i|we) (?:need|have|want|would like) to (?=\w)|"
    r"(?:go ahead and|do not forget to|remember to|be sure to|make sure to|take care to|feel free to|try to) |"
    r"(?:your|the) (?:task|job|goal|aim|mission) is to |it would be (?:nice|great|good|helpful|lovely) (?:if|"
    r"to have) |"
    r"it is (?:important|essential|required|necessary|vital|crucial|mandatory) (?:that|to have|for) )+",
    re.IGNORECASE,
)
REASONS: Final = re.compile(
    r"[\s,]+(?:because|since|in case|in order to|as (?:i|we|they|people|the robot|the guests|guests|somebody|"
    r"someone)\b|"
    r"so (?:the|a) robot|for (?:the )?(?:robot|guests?|visitors?|staff|children|everyone|customers|patients|later|"
    r"testing|demo|lunch|breakfast|dinner|a test|the test|the demo|the meeting|tomorrow)\b)[^,;]*",
    re.IGNORECASE,
)
EXPRESSIONS: Final = (
    (r"\bbetween (.+?) and (.+?)(?=$|,|;| and )", r"from \1 to \2"),
    (r"\bboth (.+? and )", r"\1"),
    (r"\beither\b", ""),
    (r"\bas well as\b|\bplus\b|\balong with\b|\btogether with\b|&", "and"),
    (r"\b(?:over|down|up|back|along) (?=(?:from|to|on|in|onto|into|at|next|inside)\b)", ""),
    (r"^(?:and |so |but |then )?(?:i|we) (?:want|need|would like|wish) to be able to\b", "i can"),
    (r"\bneither (.+?) nor (.+)", r"no \1 and no \2"),
    (r"\b(?:at least|no fewer than|no less than|a minimum of|not less than)\b", ""),
    (r"^(?:if|when|in case) there (?:is|are) (?:no|not an?|not any|not)\b(.+?), (?:then )?", r"there is \1, "),
    (r"^(?:if|unless)\b[^,]+, (?:then )?", ""),
    (r",? (?:and )?(?:if|unless) (?:not|there is none|there is not|one is there|it is there|so|missing)\b,?(?: "
     r"(?=\w))?",
     ", "),
    (r"\btake (.+?) away\b", r"remove \1"),
    (r"\b(?:no more than|not more than|at most|a maximum of)\b", "atmost"),
    (r"\bthe (?:presence|existence|availability) of\b", ""),
    (r",? (?:which|that) (?:(?:must|should|has to|have to|is|are)(?: be)?) (red|blue|green|white|black|yellow|"
     r"orange|purple|pink|brown|beige|gr[ea]y|cold|chilled)\b,?",
     r" \1"),
    (r": ", ", "),
    (r"\bhalf a dozen\b", "six"),
    (r"\b(?:a|one) dozen\b", "twelve"),
    (r"\b(?:a )?(?:couple|pair) of\b", "two"),
    (r"\b(?:a few|several|a handful of|a number of)\b", "three"),
    (r"\b(?:on|in) (?:the )?(?:top|surface) of\b|\bupon\b|\batop\b|\bon to\b", "on"),
    (r"\b(?:in|on) the (?:corner|middle|centre|center|back|front|left|right|far end|edge|inside) of\b", "in"),
    (r"\bin the (?:top|bottom|upper|lower|first|second|left|right)? ?drawers? of\b", "in"),
    (r"\b(?:that|which) (?:(?:is|are|lies|stands|sits|rests) )?(?=(?:on|in|inside|next|near|at|by|beside)\b)", ""),
    (r"\b(?:lying|standing|sitting|resting|placed|located|situated|waiting|stored|kept|available|present|left|laid|"
     r"set) (?=(?:on|in|inside|next|near|at|by|beside|there)\b)",
     ""),
    (r"\b(?:right|directly|just|immediately) (?=(?:next|beside|near|by|on)\b)", ""),
    (r"\b(?:adjacent to|close to|alongside|beside|near to|nearby|around|in front of|near)\b", "next to"),
    (r"\b(red|blue|green|white|black|yellow|orange|purple|pink|brown|beige|grey|gray)[- ]colou?red\b", r"\1"),
    (r"\b(?:ice|nice and|well)[- ](cold|chilled|cooled)\b", r"\1"),
    (r"\b(first|second|third|fourth|fifth|sixth|ground|top)-(floor|storey|story|level)\b", r"\1 \2"),
    (r"(\w)'s? (?=[a-z])", r"\1 's "),
)  # fmt: skip
QUESTION: Final = re.compile(
    r"^(?:is|are) (there)\b(.*)$|^(?:can|could) (the robot|i|we|one|a robot|someone) (?=get|go|reach|walk|"
    r"drive)(.*)$",
    re.IGNORECASE,
)
VAGUE: Final = re.compile(
    r"\b(?:an?|the|some|any|every|each|all|my|our|your|one|two|three|four|five|six|another|more|\d+) (?:\w+ )??"
    r"(?P<words>(?:(?:small|large|big|fresh|clean|new|nice|full|empty) )+)(?!of\b|and\b|or\b|on\b|in\b)(?=[a-z])",
    re.IGNORECASE,
)
SENTENCE_ENDS: Final = re.compile(r"[.!?;\n]+(?=\s|$)|,\s+so\s+(?!that\b)")

# Paraphrases of sentences
_WHO: Final = r"(?:the |my |our |a |an )?(?:subject|participant|robot|agent|user|person|policy|model)"
_RUN: Final = r"(?:experiment|trial|episode|test|task|run|study|demo|session|evaluation|recording|benchmark|rollout)s?"
_ON: Final = r"(?:on|onto|in|into|inside|at|next to|from|off|out of)"
ENCLOSED: Final = re.compile(
    r"\b(?:fridge|refrigerator|freezer|cabinet|cupboard|drawers?|wardrobe|box|oven|microwave|dishwasher|basket|bin)\b",
    re.IGNORECASE,
)

FRAMES: Final = re.compile(
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

_PARAPHRASES: Final[tuple[tuple[str, str], ...]] = (
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
    (r"^(?:both )?(.+?) and (.+?) should be (\w+) and (\w+),? respectively$", r"\1 should be \3 ;; \2 should be \4"),
    (r"^(the .+?) (?:is|are|looks?|seems?) (?:a bit |rather |much |far )?too \w+,? (?:and |so )?(tidy|clear|clean|"
     r"empty) it(?: up| off| out)?\b(.*)$",
     r"\2 \1\3"),
    (r"^(?:tidy|clear|clean|empty)(?: up)? (.+?)(?: up)? by (?:removing|taking away|clearing away) (?:everything|"
     r"all) (?:but|except(?: for)?|apart from|other than) (.+)$",
     r"remove everything from \1 except \2"),
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
    (r"^(?:set|lay|prepare|arrange|equip) (the .+?) for [^,]+, (.+)$", r"\1 needs \2"),
    # numbers
    (r"^there (?:should be|must be|is|are) (?:as few as |as many as )(\w+ .+?)(?:, exactly \w+)?$",
     r"there is exactly \1"),
    (r",? (?:and )?(?:second|third|fourth|last)(?:ly)?,? (?=(?:put|place|add|remove|take|move|open|close|turn|"
     r"switch|clear)\b)",
     ", "),
    (r"\ba total of\b|\bin total\b|\ball in all\b", ""),
    (r"^(.+?),? (?:no more and no less|neither more nor less|no more,? no less|not more and not less)$",
     r"exactly \1"),
    (rf"^(?:increase|raise|bring|get) the (?:number|count) of (.+?) ({_ON} .+) (?:up )?to (\w+)$",
     r"there is \3 \1 \2"),
    (rf"^(?:reduce|decrease|limit|lower|cut|restrict) the (?:number|count) of (.+?) ({_ON} .+) (?:down )?to (\w+)$",
     r"there is atmost \3 \1 \2"),
    (rf"^the (?:number|count) of (.+?) ({_ON} .+) (?:should|must|has to|is to|ought to) (?:be|equal) "
     r"(?:exactly )?(\w+)$",
     r"there is exactly \3 \1 \2"),
    (r"^(?:up to|to|atmost) (.+?) (?:may|can|might|are allowed to|is allowed to) (?:stay|remain|be|lie|stand) (on|"
     r"in) (.+)$",
     r"there is atmost \1 \2 \3"),
    (r"^(.+?) each (on|in|at) (the .+?) and (?:(?:on|in|at) )?(the .+)$", r"\1 \2 \3 ;; \1 \2 \4"),
    # not wanted
    (r"^do not (?:allow|have|keep|leave|put|tolerate) more than (.+)$", r"there is atmost \1"),
    (r"^(?:make sure|ensure|check|see to it) (?:that )?(?:nobody|no one) (?:has )?left (.+?) (open|on)$",
     r"\1 should not be \2"),
    (r"^(?:keep|leave) (.+?) (on|in) (.+?),? (?:but|and) (?:take|remove|clear|throw) (?:away )?(?:all |everything )?"
     r"(?:the )?(?:rest|others?|else)(?: away| off)?$",
     r"nothing but \1 \2 \3"),
    (r"^(?:swap|replace|exchange|trade) (?:what|whatever|everything|all that) ?(?:is |lies )?(on|in) (.+?) (?:for|"
     r"with|by) (.+)$",
     r"nothing but \3 \1 \2"),
    (r"^(?:i|we) (?:do|would|can) not (?:want|need|like|wish|stand)(?: to (?:see|have|find))? (?:any )?(.+?)"
     r"(?: any ?more| any longer| no more)?$",
     r"there is no \1"),
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
     r"contain) (.+?)(?: (?:on|in) it)?$",
     r"replace \1 on \2 with \3"),
    (r"^where (.+? (?:lies|stands|is|sits))? ?(on|in) (.+?), (?:there (?:is|should be)|i need|we need|i want|put|"
     r"place) (.+)$",
     r"replace \1 \2 \3 with \4"),
    (r"^wherever (.+?) (?:is|lies|stands) ((?:on|in) .+?), (put|place|add|set) (.+?) (?:close by|close to it|"
     r"next to it|next to|there|beside it)$",
     r"\3 \4 next to \1 \2"),
    (r"^(.+?) (?:close by|right by) (the .+)$", r"\1 next to \2"),
    (r"^(?:put|place|move) (the .+?) (?:of|on|from) (the .+?) where (the .+?) (?:of|on|from) (the .+?) is,? "
     r"(?:and )?vice versa$",
     r"swap \1 on \2 and \3 on \4"),
    (r"^(?:i|we) (?:want|need|would like) ((?:the |a )?(?:robot|agent)|someone|somebody|people) to (?=get|go|reach|"
     r"walk|drive)",
     r"\1 can "),
    (r"^check (?:the|this|that) (?:way|path|route),? (?:and )?", ""),
    (r"^(.+?),? - (?:all|both|everything)(?: of (?:it|them|this))? (on|in) (the .+)$", r"\2 \3, there is \1"),
    # taken and put
    (rf"^(?:grab|pick up|pick|take|get|fetch|lift|collect) (.+? {_ON} .+?)(?: up)?(?:,? and(?: then)?|,(?: then)?) "
     r"(?:put|place|bring|carry|set|lay|drop|move|take|deliver) (?:it|them) (?:down )?(?:on|onto|in|into|to) (.+?)"
     r"(?:,? and (?:leave|keep|put) (?:it|them) there)?$",
     r"move \1 to \2"),
    (r"^(?:i|we) (?:want|need|would like) (.+?) moved(?:,| and)? (?:bring|take|carry|put|move) (?:it|them) (?:to|on|"
     r"onto|in|into) (.+)$",
     r"move \1 to \2"),
    (r"^(?:i|we) (?:want|need|would like) (.+?) (?:moved|brought|taken) to (.+)$", r"move \1 to \2"),
    (r"^(the .+? (?:on|in|from) .+?) (?:belongs?|goes|should (?:go|sit|lie|stand|rest)|must go|has to go|"
     r"ought to go) (?:on|in|to|into|onto) (the .+)$",
     r"move \1 to \2"),
    # places spoken of
    (r"^(?:go|walk|drive) to (.+?),? and put (.+?) (in|on) (?:it|there)$", r"put \2 \3 \1"),
    (r"^(?:look at|see|consider|take|check) (.+?), (the .+?) there (?:is|stands|lies) in the way$",
     r"there is \2 on \1"),
    (r"^(.+) on the same \w+ as .+?, that is,? (.+)$", r"\1 on \2"),
    # everything of a kind of state
    (r"^(?:all|every|the) (?:the )?doors? (?:of|on) (?:all |the )*(?:furniture|cabinets?) in (.+?) (?:should|must|"
     r"has to|have to) be (open|close|shut)(?:d|ed)?$",
     r"\2 everything in \1"),
    (r"^(?:(?:i|we) (?:want|need|would like)|make sure|ensure|have|leave|keep) (the [^,]+?) and (the [^,]+?) "
     r"(?:are |stay |to be )?(open|closed|shut|on|off)$",
     r"\1 should be \3 ;; \2 should be \3"),
    (r"^(?:everything|all (?:the )?(?:things|objects|devices|items)|whatever) (?:that |which )?can be (?:open|clos|"
     r"shut)\w* (in|on) (.+?) (?:should|must|has to|have to|is to) be (open|close|shut)(?:d|ed)?$",
     r"\3 everything \1 \2"),
    (r"^(?:everything|all (?:the )?(?:things|objects|devices|items))( (?:in|on) .+?)? (?:that |which )?can be "
     r"(?:turn|switch)\w* (?:on|off)( (?:in|on) .+?)? (?:should|must|has to|have to|is to) be (?:turned |"
     r"switched )?(on|off)$",
     r"switch \3 everything\1\2"),
    (r"^(close|shut|open) (?:everything|anything|whatever|all) (?:that |which )?(?:is |stands |are )?(?:still )?"
     r"(?:open|closed|shut) (in|on) (.+)$",
     r"\1 everything \2 \3"),
    (r"^(?:turn|switch|power) (everything|(?:all|every) (?:the )?(?:\w+ )?\w+) (on|off) ((?:in|on) .+)$",
     r"switch \2 \1 \3"),
    (r"^((?:close|shut|open|switch on|switch off|turn on|turn off) )(?:all|every) (?:the |of the )?(?:devices?|"
     r"things?|objects?|appliances?|machines?|equipment) ",
     r"\1everything "),
    # ways
    (r"^starting (?:at|from|in) (.+?), (?:.+?) to ((?:the )?\S.*)$", r"there is a way from \1 to \2"),
    (r"\ball the way to\b", "to"),
)  # fmt: skip
PARAPHRASES: Final = [(re.compile(pattern, re.IGNORECASE), turn) for pattern, turn in _PARAPHRASES]

FETCH: Final = re.compile(
    rf"^{_WHO} (?:has to|must|should|will|needs to|is to|shall|is going to|(?:will|is going to) be (?:told|asked) to|"
    rf"is (?:told|asked|supposed) to) (?:pick up|pick|take|grab|fetch|get|find|collect) (?P<x>.+?)(?: up)? "
    rf"(?:from|off|out of) (?P<y>.+?)"
    r"(?:,? (?:and|then|and then) (?:bring|put|place|carry|deliver|take) it (?:to|on|onto|in|into) (?P<z>.+))?$",
    re.IGNORECASE,
)
REPETITION: Final = re.compile(
    r"^(?:(?:make sure|ensure|check|see to it|provide|add|put|get|take care)(?: that)? ?(?:there is )?(?:one|it|some|"
    r"that|this|"
    r"there is one|there is)(?: there| is there| exists?)?(?: if .*)?|(?:make|keep) (?:that|this|it) (?:possible|so)|"
    r"(?:please )?fix (?:that|this|it)|do (?:it|that|this)(?: for \w+)?|take the (?:others|rest) away|remove the "
    r"(?:others|rest))$",
    re.IGNORECASE,
)

REMAINDER: Final = re.compile(
    r"^(?:only |just )(?P<kept>.+?) (?:may|should|must|can|is to|shall) (?:remain|stay|be left)"
    r"(?: (?:there|on it|in it))?$",
    re.IGNORECASE,
)
CLEARED: Final = re.compile(
    r"^(?:free|clear|empty|tidy|clean)(?: up| off| out)? (?P<place>the .+?)(?: (?:up|off|out))?"
    r"(?: (?:from|of) (?:clutter|everything|all (?:things|objects)))?$",
    re.IGNORECASE,
)

# Clauses
_MODAL = (
    r"(?:should|must|ought to|has to|have to|needs? to|shall|will|would|is to|are to|(?:is|are) supposed "
    r"to|can|may)"
)
_BE = (
    r"(?:is|are|be|stays?|remains?|lies?|sits?|stands?|rests?|goes|go|belongs?|exists?|gets?|comes?|"
    r"(?:be|is|are|get|gets) (?:placed|put|found|kept|left|provided|added|set|laid|stored|located|brought|"
    r"delivered)?)"
)
AT = r"(?:on|in|inside|into|within|at|next to|under|by|upstairs|downstairs|there)\b"
_SUBJECT = (
    r"(?:the |a )?(?:robot|one|you|people|someone|anyone|somebody|anybody|everyone|everybody|i|we|"
    r"visitors?|guests?|staff|person|it)"
)
_GO = r"(?:get|go|walk|drive|reach|travel|move|come|navigate|access|enter|make it|find (?:my|its|the|a) way)"
REQUEST: Final = re.compile(
    r"^(?:(?:make (?:absolutely )?(?:sure|certain)|ensure|check|verify|see to it|see|confirm|guarantee|assure|"
    r"arrange|"
    r"be sure|take care|(?:i|we) (?:want|need|would like|would love|would prefer|wish for|require|expect|am "
    r"missing|are missing|lack)"
    r"(?: to (?:see|have|find))?|let|have|get)\b(?: (?:that|whether|if|for))?)\s+",
    re.IGNORECASE,
)

_CLAUSES: Final[tuple[tuple[str, str], ...]] = (
    # ways
    ("path", rf"(?:there {_MODAL}? ?(?:is|are|be) )?(?:provide |keep |leave |make )?(?:an?|the|some)? ?(?:clear|free|"
             r"open|unobstructed|possible|working)? ?(?:way|path|route|access|passage|connection|walkway)s?\b(?: "
             rf"(?:leading|going|that leads))? ?(?P<b>(?:from|to|into|towards)\b.*?)?(?: (?:{_MODAL} )?(?:(?:is|be|"
             r"are|stays?|remains?|kept) )?(?:clear|free|open|possible|available|unobstructed|there))?"),
    ("have", rf"{_SUBJECT} (?:{_MODAL}|could|wants? to) (?:be able to )?(?:find|see|have|pick up|grab) (?P<x>(?!"
             r"(?:my|its|the|a|his) way).+)"),
    ("path", rf"{_SUBJECT} (?:(?:{_MODAL}|could|am|is|are) )?(?:be )?(?:able to )?(?:{_GO} (?P<b>(?:to|into|in|"
             r"inside|from|through|around|towards|up|down|over|upstairs|downstairs|there|anywhere|everywhere)\b.*)|"
             r"(?:reach|access|enter) (?P<c>.+))"),
    ("path", rf"it {_MODAL}? ?(?:is|be) possible (?:for .+? )?to {_GO} (?P<b>.+)"),
    ("path", r"nothing (?:should |must |may |can )?blocks? (?:the )?(?:way|path|route|access)(?P<b> .+)"),
    ("reach", rf"(?P<b>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?) (?:reachable|accessible|reached|within reach|"
              r"connected)(?: (?:by|for) (?:the |a )?\w+)?(?: (?:from|to|with) (?P<a>.+))?"),
    ("reach", r"(?:make |keep )?(?P<b>.+?) (?:reachable|accessible)(?: from (?P<a>.+))?"),
    ("reach", rf"{_SUBJECT} (?:{_MODAL} )?(?:has|have) (?:an? )?(?:clear |free )?(?:access|way|path|route) to "
              r"(?P<b>.+)"),
    # nothing, empty
    ("quality", rf"(?:they|it|these|those|both|all of them) (?:{_MODAL} )?(?:be|is|are) (?P<v>\w+)"),
    (r"clear", rf"nothing (?:else )?(?:{_MODAL} )?(?:{_BE} )?(?:left )?(?:on|in|inside|at) (?P<y>.+)"),
    ("absent_on", rf"(?P<y>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?) (?:free|clear|empty|rid|cleared|emptied) "
                  r"(?:of|from) (?:all |any )?(?P<x>.+)"),
    ("absent_on", r"(?:keep|clear|empty|rid|strip|free|leave|make) (?P<y>.+?) (?:free |clear |empty )?of (?:all |"
                  r"any )?(?P<x>(?!the \w+ room).+)"),
    (r"clear",
     rf"(?P<y>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?|gets?) (?:completely |totally )?(?:empty|clear|cleared|"
     r"emptied|bare|tidied|free)(?: up| off| out)?"),
    (r"clear", r"leave nothing (?:on|in) (?P<y>.+)"),
    ("absent", r"(?:clear|clean|tidy|sweep) (?:away |up )?(?P<x>.+? (?:off|from|out of) .+)"),
    (r"clear", r"(?:clear|empty|tidy|clean)(?: off| out| up)? (?P<y>.+?)(?: off| out| up| completely)?"),
    (r"clear",
     r"remove (?:everything|all (?:things|objects|items)|anything|whatever is)(?: that is)? (?:from|on|off|in) "
     r"(?P<y>.+)"),
    # not open, not on
    ("unstate", rf"(?P<x>.+?) (?:{_MODAL} not (?:be |stay |remain |stand |run )?|(?:is|are) not (?:{_MODAL} )?"
                r"(?:be )?)(?:switched |turned |left |kept )?(?P<v>open|opened|closed|shut|on|off|running|lit)"),
    ("unstate", r"do not (?:leave|keep|let|have) (?P<x>.+?) (?:be )?(?:switched |turned )?(?P<v>open|opened|closed|"
                r"shut|on|off|running|lit)"),
    # gone
    ("absent", rf"there (?:{_MODAL} )?(?:is|are|be|not be|is not|are not|be not)? ?(?:no longer (?:be )?|no|not|"
               r"never|none of) (?:be )?(?:any |a |an |a single )?(?P<x>.+)"),
    ("absent_on", rf"(?P<y>.+?) (?:{_MODAL} not|does not|do not|must not) (?:have|contain|hold|carry|include|keep|"
                  r"store) (?:any |a |an )?(?P<x>.+?)(?: (?:on|in|inside) (?:it|them|there))?"),
    ("absent", rf"(?:no|none of the|none of|not a single|not any|neither|nor) (?P<x>.+?) (?:{_MODAL} )?{_BE}"
               rf"(?: left)? (?P<loc>{AT}.*)"),
    ("absent", rf"(?P<x>.+?) (?:{_MODAL} not (?:{_BE})?|(?:is|are) not(?: {_MODAL})?|do not belong|does not belong|"
               rf"has no place|have no place) (?P<loc>{AT}.*)"),
    ("absent", rf"(?P<x>.+?) (?:{_MODAL} )?(?:be |is |are |gets? )(?:removed|gone|taken away|deleted|thrown away|"
               r"discarded|cleared away)(?P<loc> .*)?"),
    ("absent", rf"(?P<x>.+?) {_MODAL} (?:go|go away|disappear|vanish|leave)"),
    ("absent", r"do not (?:leave|keep|put|have|allow|store) (?:any |a |an )?(?P<x>.+)"),
    ("absent", r"keep (?P<x>.+? (?:off|out of|away from) .+)"),
    ("absent", r"(?:remove|delete|take away|take off|take out|get rid of|throw away|throw out|dispose of|discard|"
               r"eliminate|clear away|erase|bin|rid) (?P<x>.+)"),
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
    ("state", rf"(?P<x>.+?) (?:{_MODAL} )?(?:is|are|be|stays?|remains?|being|left|kept|stand|stands|gets?)? ?"
              r"(?:switched |turned |powered |wide |left |kept )?(?P<v>open|opened|closed|shut|on|off|running|lit)"),
    # moved
    ("move", r"(?:move|relocate|transfer|carry|shift|transport|haul) (?P<x>.+)"),
    ("move", r"(?:bring|take|put|place|fetch|get|deliver) (?P<x>(?!a |an |two |three |\d)[^,]+? from .+? (?:to|into|"
             r"on|in) .+)"),
    ("move", r"(?:bring|take|fetch|deliver) (?P<x>(?:the|all|every|that|this|those|these) .+? (?:to|into) .+)"),
    ("move", rf"(?P<x>.+?) (?:{_MODAL} )(?:be (?:moved|relocated|transferred|brought|carried|taken|shifted)|move|go)"
             r"(?P<loc> (?:from|to|into|over to) .+)"),
    # there
    ("have", rf"there (?:{_MODAL} )?(?:is|are|be|exists?|lies?|stands?) (?P<x>.+)"),
    ("hold", r"(?:equip|stock|fill(?: up)?|set|furnish|supply|provide|load|set up|outfit|decorate|lay) "
             r"(?P<y>.+?) with (?P<x>.+)"),
    ("hold", r"give (?P<y>the .+?|every .+?|each .+?) (?P<x>(?:a|an|one|two|three|four|five|six|another|some|\d+) .+)"),
    ("hold", rf"(?P<y>(?!{AT}|i |we |there ).+?) (?:(?:{_MODAL} )?(?:have|has|contains?|holds?|carry|carries|stores?|"
             r"keeps?|features?|includes?|gets?|offers?)|needs?|requires?|lacks?|is missing|are missing|"
             rf"(?:{_MODAL} )?(?:be|is|are) (?:equipped|stocked|filled|furnished|loaded|provided|supplied) with) "
             r"(?P<x>.+?)(?: (?:on|in|inside|within) (?:it|them|its top))?"),
    ("hold", rf"(?:{_MODAL} )?(?:contains?|holds?|has|carries|stores?) (?P<x>.+)"),
    ("have", rf"(?P<x>.+?) (?:{_MODAL} )?{_BE}(?: (?:placed|put|found|kept|left|lying|standing|sitting))? "
             rf"(?P<loc>{AT}.*)"),
    ("have", r"(?:put|place|add|provide|set|lay|leave|bring|supply|install|position|deposit|drop|store|keep|stick|"
             r"rest|insert|deliver|fetch|find|locate|arrange|create|spawn|furnish|prepare|hide|park|stand|set up|"
             r"set out|lay out|i need|we need|i want) (?P<x>.+)"),
    ("have", rf"(?P<x>.+?) {_MODAL} (?:be|exist)"),
)  # fmt: skip
CLAUSES: Final = [(kind, re.compile(rf"^{pattern}$", re.IGNORECASE)) for kind, pattern in _CLAUSES]
CONJUNCTIONS: Final = re.compile(
    r"\s*,\s*(?:and |but |then |or )?(?:then |that )?|\s+(?:and|but|while|whereas|nor|and so) (?:then |that "
    r")?|\s+then\s+|\s+(?:such|so) that\s+",
    re.IGNORECASE,
)
EMPTY: Final = re.compile(
    r"^(?:make sure |ensure |see to it |do |check )?(?:that )?(?:(?:there|it|this|that) "
    rf"(?:is|are|{_MODAL} be)(?: so| true| the case| one)?|so|it|yes|no)$",
    re.IGNORECASE,
)
FRONTED_PLACE: Final = re.compile(
    rf"^(?P<loc>(?:on|in|inside|at|next to)\b.+?) (?P<rest>(?:there (?:{_MODAL}|is|are)|put|place|add|make sure|"
    r"ensure|i want|we need|leave|set|lay|remove|i would like|have)\b.+)$",
    re.IGNORECASE,
)

# Sentences that no clause pattern covers
_BUT: Final = r"(?:but|except(?: for)?|besides|other than|apart from|aside from|save(?: for)?)"
_OUGHT: Final = r"(?:should|must|may|shall|has to|have to|ought to|is to|can)"
_LIE: Final = r"(?: (?:be|is|are|lie|lies|stand|stands|remain|remains|stay|stays)(?: left)?)?"
_ASK: Final = (
    r"(?:(?:make sure|ensure|see to it)(?: that)? |(?:i|we) (?:want|need|would like) |"
    r"there (?:is|are|should be|must be|has to be) |have |leave |put |keep )*"
)

SENTENCES: Final = tuple(
    (kind, re.compile(f"^{pattern}$", re.IGNORECASE))
    for kind, pattern in (
        ("only", rf"{_ASK}nothing (?:else )?{_BUT} (?P<x>[^,]+?)(?: {_OUGHT})?{_LIE} (?:on|in|inside) (?P<y>[^,]+?)"),
        ("only", rf"{_ASK}nothing (?:else )?(?:on|in|inside) (?P<y>[^,]+?),? {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"{_ASK}(?P<x>[^,]+?),? (?:and|but) nothing else,?(?: {_OUGHT})?{_LIE} (?:on|in|inside) "
                 r"(?P<y>[^,]+?)"),
        ("only", rf"{_ASK}(?P<x>[^,]+?)(?: {_OUGHT})?{_LIE} (?:on|in|inside) (?P<y>[^,]+?),? (?:and|but) nothing else"),
        ("only", rf"{_ASK}(?P<y>(?:the |f\d)[^,]+?) (?:{_OUGHT} )?(?:hold|have|carry|contain|bear)s? (?:only|"
                 rf"nothing {_BUT}|just) (?P<x>(?:an?|the) [^,]+?)(?: on it| in it)?"),
        ("only", rf"the only (?:things?|objects?|items?) (?:on|in|inside) (?P<y>[^,]+?) (?:{_OUGHT} be|is|are) "
                 r"(?P<x>[^,]+?)"),
        ("only", r"(?:remove|clear|take|delete) (?:everything|all|anything|whatever is)(?: else)?(?: \w+)? (?:from|"
                 rf"off|out of|on|in) (?P<y>[^,]+?),? {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"(?:remove|clear|take|delete) (?:everything|all|anything) {_BUT} (?P<x>[^,]+?) (?:from|off|"
                 r"out of) (?P<y>[^,]+?)"),
        ("only", r"(?:clear|empty|tidy(?: up)?|clean(?: up)?)(?: off)? (?P<y>[^,]+?),? (?:but|and) (?:leave|keep|"
                 r"spare) (?P<x>[^,]+?)(?: (?:where (?:it is|they are)|there|alone|on it|in it|untouched|in place))?"),
        ("only", rf"(?:clear|empty)(?: off)? (?P<y>[^,]+?),? {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"(?P<y>[^,]+?) (?:{_OUGHT} be|is) (?:completely )?(?:empty|bare|clear) {_BUT} (?P<x>[^,]+?)"),
        ("only", rf"{_BUT} (?P<x>[^,]+?), (?P<y>[^,]+?) (?:{_OUGHT} be|is) (?:completely )?(?:empty|bare|clear)"),
        ("only", r"(?:only |just )?(?P<x>[^,]+?) on (?P<y>[^,]+?), (?:and )?(?:all|every) other (?:objects?|things?|"
                 rf"items?)(?: \w+)? (?:{_OUGHT} )?(?:disappear|go|vanish|be removed|be gone)"),
        ("exchange", r"(?:swap|exchange|trade|switch) (?P<x>.+? (?:on|in|from|off|at) .+?) (?:and|with|for) "
                     r"(?P<z>the .+? (?:on|in|from|off|at) .+)"),
        ("exchange", rf"(?P<x>.+? (?:on|in) .+?) and (?P<z>the .+? (?:on|in) .+?) (?:{_OUGHT} )?(?:be )?(?:trade|"
                     r"swap|change|exchange|switch)d?(?: places?| positions?)?"),
        ("mention", r"(?P<y>.+?) (?:is|are|looks?|seems?) (?:a bit |rather |much |far )?too \w+"),
        ("mention", r"(?:i|we) (?:want|would like|need) (?:someone|somebody|people|one|guests|the robot) "
                    r"(?:to be able )?to (?:sit|work|eat|sleep|read|rest|relax|cook|study)(?: down)? (?P<y>(?:in|on|"
                    r"at) .+)"),
        ("some", r"(?P<n>one|two|three|four) of (?:them|these|those) (?:\w+ to |should |must )?(?:be |is |are )"
                 r"(?P<v>\w+)"),
    )
)  # fmt: skip

# Parts of clauses
CARRIER_WITH: Final = re.compile(
    r"^(?P<a>.+?) with (?P<b>(?:a|an|one|two|three|four|five|six|some|another|no|cold|\d+)\b.+?)"
    r"(?: (?P<rel>on|in|inside|within)(?: (?:it|them|top))?)?(?P<loc> (?:in|on|at) (?!it\b|them\b|top\b).+)?$",
    re.IGNORECASE,
)
NEGATED: Final = re.compile(r"^(?:no|not any|none of)\s+", re.IGNORECASE)
INDEFINITE: Final = re.compile(r"^(?:an?|one|two|three|four|five|six|some|another|\d+) ", re.IGNORECASE)
PRONOUN: Final = re.compile(r"^(?:it|them|that|this|these|those|both)\b", re.IGNORECASE)
MOVED: Final = (
    r"^(?P<what>.+?)(?: from (?P<source>.+?))? (?:over |back |up |down |upstairs |downstairs )?"
    r"(?P<to>to|into|onto) (?P<target>.+)$",
    r"^(?P<what>.+?) from (?P<source>.+?) => (?P<to>on|in|inside) "
    r"(?P<target>(?!(?:the )?(?:\w+ )?(?:floor|storey|level)\b).+)$",
)
OBJECT_FIRST: Final = re.compile(
    r"^(?:i|we) (?:want|would like|need|expect|require) (.+?) to (?=(?:be|have|contain|hold|stand|lie|stay|remain|go|"
    r"reach)\b)",
    re.IGNORECASE,
)
BRING_IT: Final = re.compile(
    r"^(?:bring|take|carry|put|move) (?:it|them) (?:over )?(?:to|on|onto|in|into) (.+)$", re.IGNORECASE
)
PLACED: Final = re.compile(r" (?:on|onto|in|into|inside|at|next to|from|off|out of) ")
STATES: Final = {
    **dict.fromkeys(["open", "opened"], ("open", True)),
    **dict.fromkeys(["close", "closed", "shut"], ("open", False)),
    **dict.fromkeys(["on", "switched on", "turned on", "running", "lit", "activate", "start", "light"], ("on", True)),
    **dict.fromkeys(["off", "switched off", "turned off", "deactivate", "stop"], ("on", False)),
}  # fmt: skip
OPPOSITES: Final = {("open", True): "closed", ("open", False): "open", ("on", True): "off", ("on", False): "on"}
