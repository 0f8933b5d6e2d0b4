"""Words that say that rooms are side by side or apart, each as the words of its pattern."""

__all__ = ["APART_AT", "BESIDE_AT", "LEADS", "MUTUALLY_APART_AT", "MUTUAL_AT", "NEGATIONS", "PRONOUNS"]

_TO = ("to", "onto", "into", "on", "off", "from", "with", "up")
_BESIDE = [
    ("next", "to"),
    ("next", "door", "to"),
    ("right", "next", "to"),
    ("adjacent", "to"),
    ("adjacent", "with"),
    ("beside",),
    ("besides",),
    ("alongside",),
    ("close", "to"),
    ("near", "to"),
    ("near",),
    ("by", "the"),
    ("adjoining",),
    ("adjoin",),
    ("bordering",),
    ("border",),
    ("abut",),
    ("abutting",),
    ("touch",),
    ("touching",),
    ("against",),
    ("neighbouring",),
    ("neighboring",),
    ("behind",),
    ("in", "front", "of"),
    ("directly", "off"),
    ("off", "the"),
    ("off", "a"),
    ("off", "it"),
    *[
        (verb, *article, *kind, "wall", "with")
        for verb in ("share", "sharing")
        for article in (("a",), ("one",), ("the",), ("any",), ())
        for kind in ((), ("common",), ("same",))
    ],
    ("reached", "through"),
    ("reached", "from"),
    ("accessed", "from"),
    ("accessible", "from"),
    ("entered", "from"),
    ("entered", "through"),
    ("entered", "via"),
    ("reached", "via"),
    ("visible", "from"),
    ("overlooking",),
    *[(verb, to) for verb in ("look", "looking") for to in ("onto", "into")],
    *[
        (word, to)
        for word in ("contiguous", "connection", "passage", "neighbour", "neighbor", "beside", "contact", "bordering")
        for to in ("to", "with", "of")
    ],
    ("adjoining", "to"),
    ("adjoining", "with"),
    ("touch", "with"),
    ("next", "of"),
    *[(noun, to) for noun in ("door", "doorway", "opening") for to in ("to", "into")],
    *[(noun, to) for noun in ("side", "hatch") for to in ("to", "into", "towards", "toward")],
    ("common", "wall", "with"),
    ("wall", "in", "common", "with"),
    ("wall", "to", "wall", "with"),
    ("opposite",),
    *[
        (verb, to)
        for verb in (
            "open",
            "opening",
            "lead",
            "leading",
            "connected",
            "connect",
            "connecting",
            "attached",
            "linked",
            "joined",
            "link",
            "belonging",
            "communicate",
            "communicating",
            "direct",
            "directly",
            "straight",
            "access",
        )
        for to in _TO
    ],
    *[
        (verb, adverb, to)
        for verb in ("open", "connected", "attached", "opening", "connect", "linked", "leading", "lead", "access")
        for adverb in ("directly", "straight", "direct", "internally")
        for to in _TO
    ],
]


_APART = [
    ("away", "from"),
    ("apart", "from"),
    ("far", "from"),
    ("far", "away", "from"),
    ("kept", "off"),
    ("keep", "off"),
    ("separated", "from"),
    ("remote", "from"),
    ("distance", "from"),
    ("clear", "of"),
    ("well", "clear", "of"),
    ("well", "away", "from"),
    ("out", "of", "reach", "of"),
    ("isolated", "from"),
    ("separate", "from"),
    ("distant", "from"),
    *[
        (verb, "no", *kind, "wall", "with")
        for verb in ("share", "sharing", "have", "has", "having")
        for kind in ((), ("common",), ("party",))
    ],
    ("as", "far", "as", "you", "can", "from"),
    ("as", "far", "as", "possible", "from"),
    ("far", "as", "possible", "from"),
]


_MUTUAL = [
    ("wall", "to", "wall"),
    ("next", "to", "each", "other"),
    ("beside", "each", "other"),
    ("side", "by", "side"),
    ("adjacent", "to", "each", "other"),
    ("back", "to", "back"),
    ("next", "to", "one", "another"),
    ("neighbour",),
    ("neighbor",),
    ("adjoin",),
    ("adjacent",),
    ("adjoining",),
    ("beside", "one", "another"),
    ("connected", "to", "each", "other"),
    ("together",),
    ("touch",),
    ("opening", "to", "each", "other"),
    *[
        (verb, *other)
        for verb in ("adjoin", "touch", "border", "abut", "adjoining", "touching", "neighbouring", "facing", "connect")
        for other in (("each", "other"), ("one", "another"), ("to", "each", "other"))
    ],
    ("next", "door"),
    *[("meet", to, article, "corner") for to in ("at", "in") for article in ("the", "a", "one")],
    ("at", "its", "side"),
    ("at", "the", "side"),
    ("common", "wall"),
    ("touching",),
    ("share", "a", "wall"),
    ("share", "wall"),
    ("share", "one", "wall"),
    ("share", "any", "wall"),
    ("connected",),
    ("attached",),
    ("alongside",),
    ("beside",),
]


def _by_first(patterns: list[tuple[str, ...]]) -> dict[str, list[tuple[str, ...]]]:
    """Return patterns by their first word."""
    found: dict[str, list[tuple[str, ...]]] = {}
    for pattern in patterns:
        found.setdefault(pattern[0], []).append(pattern)
    return found


_MUTUALLY_APART = [(*words, *other) for words in _APART for other in (("each", "other"), ("one", "another"))]

BESIDE_AT, APART_AT, MUTUAL_AT = _by_first(_BESIDE), _by_first(_APART), _by_first(_MUTUAL)
MUTUALLY_APART_AT = _by_first(_MUTUALLY_APART)


LEADS = frozenset(
    {
        "between",
        "wall",
        "each",
        "to",
        "of",
        "from",
        "join",
        "serve",
        *(words[0] for words in (*_BESIDE, *_APART, *_MUTUAL)),
    }
)
"""Words that a relation can begin with."""
NEGATIONS = frozenset({"none", "nothing", "not", "no", "never", "neither", "nor", "without", "nowhere", "avoid"})
PRONOUNS = frozenset({"it", "them", "this", "that", "which", "these", "those"})
