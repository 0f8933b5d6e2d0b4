"""Many ways of saying things to a few: courtesies dropped, contractions opened, turns of speech made plain."""

import re
from typing import Final

__all__ = ["passed_over", "sentences"]

_CONTRACTIONS: Final = (
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
_COURTESIES: Final = re.compile(
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
_OPENINGS: Final = re.compile(
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
_REASONS: Final = re.compile(
    r"[\s,]+(?:because|since|in case|in order to|as (?:i|we|they|people|the robot|the guests|guests|somebody|"
    r"someone)\b|"
    r"so (?:the|a) robot|for (?:the )?(?:robot|guests?|visitors?|staff|children|everyone|customers|patients|later|"
    r"testing|demo|lunch|breakfast|dinner|a test|the test|the demo|the meeting|tomorrow)\b)[^,;]*",
    re.IGNORECASE,
)
_TURNS: Final = (
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
    (r",? (?:and )?(?:if|unless) (?:not|there is none|there is not|one is there|it is there|so|"
        r"missing)\b,?(?: (?=\w))?", ", "),
    (r"\btake (.+?) away\b", r"remove \1"),
    (r"\b(?:no more than|not more than|at most|a maximum of)\b", "atmost"),
    (r"\bthe (?:presence|existence|availability) of\b", ""),
    (r",? (?:which|that) (?:(?:must|should|has to|have to|is|are)(?: be)?) "
        r"(red|blue|green|white|black|yellow|orange|purple|pink|brown|beige|gr[ea]y|cold|chilled)\b,?", r" \1"),
    (r": ", ", "),
    (r"\bhalf a dozen\b", "six"),
    (r"\b(?:a|one) dozen\b", "twelve"),
    (r"\b(?:a )?(?:couple|pair) of\b", "two"),
    (r"\b(?:a few|several|a handful of|a number of)\b", "three"),
    (r"\b(?:on|in) (?:the )?(?:top|surface) of\b|\bupon\b|\batop\b|\bon to\b", "on"),
    (r"\b(?:in|on) the (?:corner|middle|centre|center|back|front|left|right|far end|edge|inside) of\b", "in"),
    (r"\bin the (?:top|bottom|upper|lower|first|second|left|right)? ?drawers? of\b", "in"),
    (r"\b(?:that|which) (?:(?:is|are|lies|stands|sits|rests) )?(?=(?:on|in|inside|next|near|at|by|beside)\b)", ""),
    (r"\b(?:lying|standing|sitting|resting|placed|located|situated|waiting|stored|kept|available|present|left|"
        r"laid|set) "
        r"(?=(?:on|in|inside|next|near|at|by|beside|there)\b)", ""),
    (r"\b(?:right|directly|just|immediately) (?=(?:next|beside|near|by|on)\b)", ""),
    (r"\b(?:adjacent to|close to|alongside|beside|near to|nearby|around|in front of|near)\b", "next to"),
    (r"\b(?:red|blue|green|white|black|yellow|orange|purple|pink|brown|beige|grey|gray)[- ]colou?red\b",
        lambda m: re.split(r"[- ]", m.group())[0]),
    (r"\b(?:ice|nice and|well)[- ](cold|chilled|cooled)\b", r"\1"),
    (r"\b(first|second|third|fourth|fifth|sixth|ground|top)-(floor|storey|story|level)\b", r"\1 \2"),
    (r"(\w)'s? (?=[a-z])", r"\1 's "),
)  # fmt: skip
_QUESTION: Final = re.compile(
    r"^(?:is|are) (there)\b(.*)$|^(?:can|could) (the robot|i|we|one|a robot|someone) (?=get|go|reach|walk|"
    r"drive)(.*)$",
    re.IGNORECASE,
)
_UNTOLD: Final = re.compile(
    r"\b(?:an?|the|some|any|every|each|all|my|our|your|one|two|three|four|five|six|another|more|\d+) (?:\w+ )??"
    r"(?P<words>(?:(?:small|large|big|fresh|clean|new|nice|full|empty) )+)(?!of\b|and\b|or\b|on\b|in\b)(?=[a-z])",
    re.IGNORECASE,
)
_STOPS: Final = re.compile(r"[.!?;\n]+(?=\s|$)|,\s+so\s+(?!that\b)")


def sentences(text: str) -> list[str]:
    """Return the sentences of an instruction in plain words.

    Examples
    --------
    >>> sentences("Could you please put a couple of mugs on top of the desk? Thanks!")
    ['put two mugs on the desk']
    """
    whole = " ".join(_STOPS.sub(" ;; ", text.replace("’", "'").replace("`", "'")).split())
    out = [_plain(part) for part in whole.split(";;")]
    return [part for part in out if part]


def passed_over(text: str) -> list[str]:
    """Return the adjectives of an instruction that are understood and that nothing in a scene tells.

    Examples
    --------
    >>> passed_over("put a small new mug on the clean desk, then empty the bin")
    ['small', 'new', 'clean']
    """
    found = " ".join(match["words"].lower() for match in _UNTOLD.finditer(text))
    return list(dict.fromkeys(found.split()))


def _plain(text: str) -> str:
    for pattern, plain in _CONTRACTIONS:
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    text = _QUESTION.sub(lambda m: f"there is{m[2]}" if m[1] else f"{m[3]} can {m[4]}", text.strip(" ,.?!"))
    text = _REASONS.sub("", _COURTESIES.sub("", text))
    for pattern, turn in _TURNS:
        text = re.sub(pattern, turn, text, flags=re.IGNORECASE)
    text = " ".join(text.replace(" ,", ",").split()).strip(' ,.;!?"')
    before = ""
    while before != text:
        before, text = text, _OPENINGS.sub("", text).strip(" ,")
    return text
