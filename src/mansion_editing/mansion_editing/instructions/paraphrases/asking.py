"""Ways of asking and wishing: ``I was wondering if you could``, ``we'd be glad of``, ``wouldn't go amiss``."""

from typing import Final

from mansion_editing.instructions.paraphrases.patterns import Rule, rules

__all__ = ["ASKING"]

_WISHING: Final = (
    "(?:be )?(?:glad|grateful|thankful|happy) (?:of|for|about|with|to have|to see|to get)|do with|appreciate|welcome|"
    "(?:quite |really )?(?:like|love|hope|wish) to (?:have|see|get|own|find)|settle for|kill for|die for|go for|"
    "not say no to|not mind(?: having)?|use|enjoy|fancy|benefit from"
)
_LACKING: Final = (
    "(?:after|looking for|in (?:dire |urgent )?need of|in want of|on the lookout for|hoping for|keen on|short of|"
    "lacking|missing|crying out for|desperate for|dying for|thinking of|craving|waiting for|running short of)"
)
_HELPING: Final = (
    "(?:would|will) not (?:go amiss|go astray|hurt|harm|do any harm|be bad|be out of place|be a bad idea|come amiss)|"
    "would (?:go a long way|do the trick|brighten (?:it|things|the place) up|be (?:just )?(?:lovely|nice|wonderful|neat|"
    "cool|good|great|sweet|handy|useful|helpful|perfect|brilliant|ideal|fantastic|welcome|the thing|appreciated)|"
    "(?:should|would|will|might|could) (?:sort (?:that|it|this) out|fix (?:that|it|this)|solve (?:that|it|this)|"
    "remedy (?:that|it|this)|take care of (?:that|it|this)|help(?: out| there)?)|look (?:nice|good|great|lovely)|work wonders|make (?:my|our) day|come in (?:handy|useful)|help(?: a lot)?)"
)
_PLEASE: Final = (
    "i (?:was|am) (?:just )?wondering (?:if|whether) (?:you|we) (?:could|can|might|would)",
    "i wonder (?:if|whether) (?:you|we) (?:could|can|might|would)",
    "(?:is|would) there (?:be )?any chance (?:that )?(?:you|we) (?:could|can|might|would)",
    "any chance (?:that )?(?:you|we) (?:could|can|might|would)",
    "do you think (?:you|we) (?:could|can|might)",
    "(?:would|will) you be able to",
    "(?:might|may|can|could) (?:i|we) (?:trouble|ask|bother) you to",
    "{I} (?:need|want|would like|would love|expect|ask|beg|urge|trust)(?: for)? you to",
    "(?:your task is|you are|you need|you have|feel free|be sure|remember|do not forget|it is time|time|try) to",
    "make sure (?:that )?you",
    "it (?:would|will) (?:be|help) ?(?:nice|good|great|lovely|kind|helpful|best|better|wise|a good idea)? ?if "
    "(?:you|we|somebody|someone) (?:could|can|would)",
    "{I} would (?:really )?(?:be (?:very |so )?(?:grateful|glad|happy|delighted|pleased|thankful)|appreciate it|love it|"
    "like it) if (?:you|we|somebody|someone) (?:could|can|would)",
    "why do (?:not|n't) (?:you|we)|why not",
    "let us (?!have\\b|not\\b)(?:just |now |first |also )?",
    "(?:you|one|we) (?:should|ought to|might want to|may want to|could|had better) (?:also |then |just |please )?"
    "(?=(?:put|place|move|remove|take|add|open|close|switch|turn|bring|set|hang|get|replace|swap|clear|carry) )",
    "(?:could|can|would|will|may) (?:somebody|someone|anybody|anyone|one of you)(?: (?:please|kindly|possibly))?",
    "(?:could|can|would|will) you (?:guys|all|lot|lovely people)(?: (?:please|kindly|possibly))?",
    "(?:go ahead and|be an angel and|be a star and|be a love and|kindly see to it that you|so kindly)",
    "(?:somebody|someone|anybody|anyone) (?:ought to|should|must|has to|needs to|please|can|could|may|better)(?: please)?",
    "(?:would you )?mind(?= \\w+ing\\b)",
    "(?:my|our) (?:request|wish|order|idea|plan) (?:is|would be) (?:that you|for you to|to)",
)

ASKING: Final[tuple[Rule, ...]] = rules(
    *((rf"{{^}}{said}\b,? ", "please ") for said in _PLEASE),
    (r"\bplease,? (?:to |please )+", "please "),
    (rf"{{^}}({{I}})(?: would| could| can| might| will)?(?: really| also| just| certainly| definitely)? (?:{_WISHING}) "
     r"(?=(?:an?|another|some|two|three|four|five|six|\d+|more|a few) )", r"\1 want "),
    (rf"{{^}}({{I}}) (?:am|are)(?: also| still| now)? {_LACKING} ", r"\1 want "),
    (r"{^}(?:could|can) do with ", "I want "),
    (r"{^}({I}) (?:(?:am|are) going to|will|shall)(?: also| probably)? (?:need|want|require) ", r"\1 need "),
    (r"{^}(?:could|can|may|might) (?:i|we) (?:please )?(?:have|get|see) ", "I want "),
    (r"{^}(?:in need of|needed|wanted|required|requested|desired):? (?=(?:an?|another|some|two|three|four|five|\d+) )",
     "I want "),
    (rf"{{^}}((?:the|our|my|this|that) {{lead}}) (?:would |could |can |might )?(?:do with|use|benefit from|welcome) "
     r"(?=(?:an?|another|some|two|three|four|five|six|\d+|more) )", r"\1 needs "),
    (rf"{{^}}((?:the|our|my|this|that) {{lead}}) (?:is|are)(?: also| still| now)? {_LACKING} "
     r"(?=(?:an?|another|some|two|three|four|five|six|\d+|more) )", r"\1 needs "),
    (r"{^}((?:the|our|my|this|that) {lead}) (?:cries out for|calls for|begs for|screams for|demands|merits|deserves) "
     r"(?=(?:an?|another|some|two|three|four|five|six|\d+|more) )", r"\1 needs "),
    (rf"{{^}}({{new}}(?: {{on}} {{lead}})?) (?:{_HELPING})( {{on}} {{lead}})?{{$}}", r"I want \1\2"),
    (r"\bthere (?:ought to|has to|have to|needs to|need to|had better|must|shall) be\b", "there should be"),
    (r"{^}(?:let us have|let me have|let us get|give us|get us|get me|find us|find me|fetch us|fetch me|treat us to|"
     r"how about having|what about having) ", "I want "),
    (r"{^}({new}) (?:is|are) (?:called for|required|needed|wanted|missing|in order|due|necessary|lacking)"
     r"( {on} {lead})?{$}", r"I want \1\2"),
)  # fmt: skip
"""Put as ``please`` before a verb, ``I want`` and ``the kitchen needs``."""
