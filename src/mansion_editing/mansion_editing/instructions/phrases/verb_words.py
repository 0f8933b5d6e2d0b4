"""Verbs of instructions and what each asks for, as data."""

from typing import Final, Literal, TypeAlias

__all__ = ["BY_WORDS", "GERUNDS", "LONGEST", "PARTICIPLES", "VERB_WORDS", "Deed"]

Deed: TypeAlias = Literal[
    "add", "bring", "remove", "take", "clear", "tidy", "go", "move", "swap", "replace", "switch", "open", "close",
    "paint", "rename", "furnish", "equip", "enlarge", "shrink", "number", "make", "turn", "check", "undo", "redo",
    "leave", "keep", "let", "change", "tell", "give", "set", "want", "restore", "repeat", "start", "stop", "connect",
    "use", "throw",
]  # fmt: skip
"""What a verb asks for."""

_VERBS: Final[dict[Deed, str]] = {
    "add": "in with|"
           "add|put|place|lay|install|position|supply|provide|insert|drop|stick|deposit|park|stand|hang|mount|spawn|"
           "create|include|store|hide|serve|spread|fix|arrange|distribute|rest|shelve|line up|set up|"
           "set out|lay out|squeeze|tuck|fit|attach|introduce|order|buy|build in|throw in|lean|display|plug in|"
           "assemble|bring in|pop|"
           "scatter|drape|put up|put down|put out|add in|put in|put back|place back|set down|put on|dock|situate|"
           "generate|organise|organize|prepare|decorate|procure|leave behind|slot|slide in|nest|sit|"
           "lay down|rack|file|organize|stow|stash|stack|pile|pile up|heap",
    "bring": "bring|fetch|deliver|get|carry|return",
    "remove": "remove|delete|take away|take out|take off|take down|get rid of|throw away|throw out|dispose of|discard|"
              "eliminate|clear away|erase|bin|scrap|drop off|rid|ditch|lose|junk|trash|chuck out|chuck|"
              "uninstall|dump|away with|out with|off with|clear off|clear out|withdraw|subtract|pull out|do away with|"
              "kick out|toss out|"
              "move out|put away|destroy|strip out",
    "take": "take|grab|pick up|pick|collect|gather|gather up|catch",
    "go": "go to|walk to|look at|find|approach|search for|go over to|drive to|take a look at|"
          "have a look at|have a look in|consider|locate|look for",
    "clear": "clear|empty|clean out|clear up|strip|empty out|vacate|free|free up",
    "tidy": "tidy|tidy up|clean|clean up|declutter|wipe|clean off|sort out",
    "move": "move|relocate|transfer|shift|transport|haul|push|pull|roll|wheel|slide|drag|shove|reposition|migrate|walk|"
            "rearrange|lift|hand over|pass|send|nudge|put over|bring over|push back",
    "swap": "swap|exchange|trade|switch around|switch places of|interchange|swap over|swap round|swap around",
    "replace": "replace|substitute|swap out|switch out|trade in|renew|upgrade",
    "switch": "turn|switch|power|flip|flick",
    "open": "open|unshut|open up",
    "close": "close|shut|close up",
    "start": "activate|preheat|start|light|ignite|light up|start up|boot|boot up|enable|run|power up|fire up|wake up",
    "stop": "deactivate|stop|extinguish|dim|disable|kill|shut down",
    "paint": "paint|colour|color|dye|repaint|recolour|recolor|tint|reupholster|upholster|varnish|lacquer|spray",
    "rename": "rename|call|name|relabel|label",
    "furnish": "furnish|refurnish|convert|transform|redo|redecorate|re-furnish|refit|repurpose|remodel",
    "equip": "equip|brighten up|brighten|liven up|spruce up|cheer up|"
             "stock|fill|fill up|outfit|load|restock|fit out|kit out|populate|refill|pack",
    "enlarge": "enlarge|extend|expand|widen|grow|increase|raise",
    "shrink": "shrink|cut|reduce|decrease|cut down|narrow|limit|lower|bring down",
    "make": "make",
    "turn": "rotate|spin|orient|face|pivot|twist|swivel|flip round|turn around|turn round|angle|point",
    "check": "make sure|make certain|ensure|check|verify|see to it|confirm|guarantee|assure|be sure|take care|test|"
             "make absolutely sure|see that|please ensure|double check|i must be sure|validate",
    "undo": "undo|revert|reverse|roll back|cancel",
    "redo": "redo|reapply",
    "restore": "restore",
    "repeat": "repeat|do the same|do that|do it|same|the same|do likewise",
    "leave": "leave",
    "keep": "keep|maintain|preserve|hold|spare|save",
    "let": "let|allow",
    "change": "change|turn into|alter|modify",
    "tell": "tell me|tell|count|list|show me|show|find out|report|say|name me|give me a count of|look up|look|"
            "let me know",
    "give": "give|hand",
    "set": "set",
    "want": "want|need|require|have|like to have|love|wish for|expect|wish|fancy|prefer|go for|would like",
    "connect": "connect|join|link",
    "use": "use",
    "throw": "throw|toss|fling",
}  # fmt: skip

BY_WORDS: Final[dict[tuple[str, ...], Deed]] = {
    tuple(verb.split()): deed for deed, verbs in _VERBS.items() for verb in verbs.split("|")
}
LONGEST: Final = max(map(len, BY_WORDS))

VERB_WORDS: Final = frozenset(word for words in BY_WORDS for word in words)
"""Words that verbs are made of, which are no mistakes."""

GERUNDS: Final = {
    form: verb
    for words in BY_WORDS
    for verb in words[:1]
    for form in (f"{verb}ing", f"{verb.removesuffix('e')}ing", f"{verb}{verb[-1]}ing")
}
"""Their forms in -ing ("while keeping a way free")."""

PARTICIPLES: Final[dict[tuple[str, ...], Deed]] = {
    **dict.fromkeys([("removed",), ("deleted",), ("gone",), ("taken", "away"), ("taken", "out"), ("thrown", "out"),
                     ("thrown", "away"), ("discarded",), ("eliminated",), ("cleared", "away"), ("taken", "off"),
                     ("binned",), ("taken", "down"), ("disposed", "of"), ("dropped",), ("scrapped",)], "remove"),
    **dict.fromkeys([("moved",), ("relocated",), ("transferred",), ("shifted",), ("carried",), ("brought",), ("taken",),
                     ("pushed",), ("pulled",), ("returned",)], "move"),
    **dict.fromkeys([("placed",), ("put",), ("added",), ("installed",), ("positioned",), ("provided",), ("mounted",),
                     ("hung",), ("set",), ("laid",), ("stored",), ("kept",), ("left",), ("stacked",), ("parked",),
                     ("arranged",), ("inserted",), ("hidden",), ("shown",), ("displayed",), ("exhibited",)], "add"),
    **dict.fromkeys([("emptied",), ("cleared",), ("empty",), ("clear",), ("bare",), ("tidied",), ("free",)], "clear"),
    **dict.fromkeys([("replaced",), ("exchanged",), ("substituted",)], "replace"),
    ("swapped",): "swap",
    **dict.fromkeys([("painted",), ("coloured",), ("colored",), ("repainted",)], "paint"),
    **dict.fromkeys([("renamed",), ("called",), ("named",)], "rename"),
    **dict.fromkeys([("rotated",), ("turned",)], "turn"),
    **dict.fromkeys([("furnished",), ("converted",), ("refurnished",)], "furnish"),
    **dict.fromkeys([("equipped",), ("stocked",), ("filled",), ("loaded",)], "equip"),
}  # fmt: skip
"""Participles of a predicate ("should be removed"), and the verbs that they belong to."""
