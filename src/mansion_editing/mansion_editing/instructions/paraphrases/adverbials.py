"""Words at the edge of a clause that change nothing of what is asked: courtesies, times of day, who says it."""

from typing import Final

from mansion_editing.instructions.paraphrases.patterns import Rule, rules

__all__ = ["ADVERBIALS"]

_EDGES: Final = (
    "however|though|mind you|after all|you know|you see|in fact|as a matter of fact|as it happens|as ever|as usual|"
    "in the meantime|for good measure|on second thoughts?|come to think of it|if i may|i reckon|i am afraid|i must say|"
    "needless to say|believe it or not|luckily|unfortunately|sadly|hopefully|apparently|literally|altogether|at last|"
    "at long last|straight away|right away|at once|as a treat|as a matter of urgency|to be safe|to be on the safe side|"
    "for the record|at your convenience|as far as possible|wherever convenient|if need be|if necessary|if needed|"
    "if you like|if you want|if you wish|if you can|if you could|if you would|if it fits|if that works|if it works|"
    "if you would be so kind|if you will|if that is (?:ok|okay|fine|alright|all right|possible|feasible)|"
    "if (?:at all )?(?:possible|poss\\.?|feasible)|no rush|no hurry|whenever you (?:can|like|have time|get round to it)|"
    "when you (?:can|get a moment|have a moment|have a minute|get round to it)|and that is it|that is all|that is it|"
    "as (?:soon|quickly|fast) as (?:possible|you can)|somehow|sort of|kind of|for crying out loud|for heaven's sake|"
    "for goodness' sake|for god's sake|my (?:dear|friend)|mate|love|darling|buddy|there is a good (?:chap|fellow|one)|"
    "no offence|strictly speaking|all things considered|in that case|then again|to start with|to begin with|for starters|"
    "for a start|in addition|on top of that|besides|what is more|furthermore|moreover|additionally|on the other hand|"
    "in return|conversely|meanwhile|in any case|at any rate|ok\\?|okay\\?|all right|right\\?|yeah|yep"
)
_TIMES: Final = (
    "overnight|over the weekend|for the weekend|this (?:morning|afternoon|evening|week|month|year|weekend)|today|tonight|"
    "tomorrow(?: (?:morning|evening|night))?|for (?:now|today|tonight|tomorrow)|in the evenings?|in the mornings?|"
    "during the (?:night|day)|at night|for a (?:while|bit|moment|few days)|until (?:further notice|tomorrow|later)|"
    "before (?:lunch|dinner|tonight|tomorrow)|after (?:lunch|dinner|hours|work)|by (?:tonight|tomorrow|noon)|from now on"
)

ADVERBIALS: Final[tuple[Rule, ...]] = rules(
    (r",? (?:would|will|could|can|won't) you(?:,? please)?(?=\s*[?.!]|\s*$)", ""),
    (r"{^}if there is (?:still |any |enough |some )*(?:room|space)(?: left| for (?:it|that|one|them)| there)*,", ""),
    (r",? if there is (?:still |any |enough |some )*(?:room|space)(?: left| for (?:it|that|one|them)| there)*{$}", ""),
    (r",? (?:from|rather than|instead of) (?:wherever|anywhere)(?: (?:it|they) (?:{be}|may be|might be)(?: now)?)?\b", ""),
    (r",? wherever (?:it|they) (?:{be}|may be|might be|happens? to be)(?: now)?\b", ""),
    (r",? where [^,.;]+?, (?:that is|namely|say),? (?=(?:in|on|at|by|next to|under) )", " "),
    (r", (?:however|though|by contrast|on the other hand|in turn|for (?:its|their) part), ", " "),
    (r"\bwhilst\b", "while"),
    (r"\b(?:hence|thus|consequently|accordingly|therefore)\b,?", "so"),
    (rf"{{^}}(?:{_EDGES}),? ", ""),
    (rf",? \(?(?:{_EDGES})\)?(?=\s*(?:[.!?;,:)]|- |$))", ""),
    (rf"{{^}}(?:{_TIMES}), ", ""),
    (rf",? (?:{_TIMES})(?=\s*(?:[.!?;,]|- |$))", ""),
)
"""What is left out, or put as the word that it stands for."""
