"""Ways of saying how many there shall be: ``one will do``, ``that'd be nine``, ``a couple of``."""

from typing import Final

from mansion_editing.instructions.paraphrases.patterns import Rule, rules

__all__ = ["COUNTING"]

_ENOUGH: Final = (
    "(?:is|are|would be|will be|should be) (?:quite |perfectly |more than |just )?(?:plenty|ample|sufficient|enough|fine|"
    "all (?:we|i|they) need|all that is needed)|(?:will|would|should|shall|can|must|might) (?:do|suffice)|suffices?|does|do"
)
_TOTAL: Final = (
    "that (?:would|will|should) be|that makes|that is|which makes|so (?:that )?(?:{I}|they) (?:have|get)|"
    "so (?:that )?there (?:are|is|will be|would be)|making(?: it)?|bringing (?:it|us|them|the total|the number) (?:up )?to|"
    "for a total of|which (?:would )?(?:makes?|gives?)(?: us)?|to make(?: it)?|totalling"
)

COUNTING: Final[tuple[Rule, ...]] = rules(
    (r"\ba (?:couple|pair) of (?!(?:scissors|shoes|socks|glasses|gloves|trousers|boots|sneakers|headphones)\b)", "two "),
    (r"\ba trio of ", "three "),
    (rf"{{^}}({{num}}) (?:of them |of those )?(?:{_ENOUGH})(?: nicely| easily| completely| for us)?{{$}}",
     r"\1 is enough"),
    (r"{^}(?:please,? )?fewer ({lead})(?:[,.;]| -)+ (?:please )?(?:[,.-] )?({num}) is enough", r"there should be exactly \2 \1"),
    (r"{^}(?:how come|why (?:on earth )?(?:are|is)|what is the point of) (?:there (?:are|is) )?({num} {lead})\? "
     r"({num}) is enough", r"There are \1. \2 is enough"),
    (r"{^}(?:[^.,;]+, )?{I} need ({num} {rest})(?:[,;.]| -)+ (?:so |and |please )*(?:add|bring|get|fetch|supply|provide) "
     r"(?:what|whatever|as many as|those that)(?: is| are)? ?(?:necessary|needed|missing|required|lacking){end}",
     r"there should be \1"),
    (r"\b(?:an?|one) ([^.,;]+), ({num}),? (?:actually|in fact|to be precise|even)\b", r"\2 \1"),
    (r"{^}I want something(?: to \w+ (?:on|in|with|at|from))? ({on} [^.,;:]+?)(?: -|,|;|:) ({new}) "
     r"(?:would|will|should) (?:do|be fine|suffice|be enough){$}", r"I want \2 \1"),
    (r"{^}I want (?:some|something|a few|a bit of)[^.?!,;:]*? ({on} [^.?!,;:]+)[.?!,;:-]+ ({num} [\w' -]+?|an? [\w' -]+?) "
     r"(?:is enough|(?:will|would|should|might) (?:do|suffice|be (?:fine|nice|enough|perfect|good|great|lovely)))"
     r"(?: nicely)?{$}", r"I want \2 \1"),
    (r"{^}make (?:the )?(?:{num} )?([a-z' -]+? (?:in|on|at) {lead}) ({num}){$}", r"there should be exactly \2 \1"),
    (r"{^}(?:one|two|three|only one|just one|the one|an?) ([\w -]+?) ({on} {lead}) is not (?:really )?enough\b[^.;!?]*[.;!,-]+ "
     r"(?:so |please )*(?:get|add|fetch|buy|put|bring|provide|give us|let us have|we need|i want) "
     r"(?:a second|another|another one|one more|a second one)(?: one)?(?: in)?{$}", r"I want another \1 \2"),
    (rf",? (?:{_TOTAL}) ({{num}})(?: of them)?(?: in all| altogether| in total)?{{end}}", r", so that there are \1"),
    (r"{^}([\w' -]{2,24}?)[!:] ({num}) of (?:them|those),? ({on}) ", r"put \2 \1 \3 "),
)  # fmt: skip
"""Put as ``is enough``, ``in all`` and numbers."""
