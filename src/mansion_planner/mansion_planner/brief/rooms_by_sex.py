"""Write out for whom toilets and changing rooms are: "WC f, WC m", "toilets by sex", "staff WC m/w"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["rooms_by_sex"]

_ROOMS = frozenset({"wc", "toilet", "restroom", "washroom", "lavatory", "shower", "changing", "locker"})
_SEXES = {
    "m": "man", "f": "woman", "w": "woman", "male": "man", "female": "woman", "ladies": "lady", "lady": "lady",
    "gents": "gent", "gent": "gent", "men": "man", "man": "man", "women": "woman", "woman": "woman",
    "accessible": "accessible", "disabled": "accessible",
}  # fmt: skip
_FITTED = frozenset({"shower", "toilet", "locker", "wc", "bench"})
"""What rooms for men have and those for women too."""
_ENDS = frozenset({"", ",", ".", ";", "\n", ")", "("})
_EITHER = (
    ("by", "sex"), ("by", "gender"), ("for", "either", "sex"), ("for", "both", "sex"), ("for", "each", "sex"),
    ("for", "both", "gender"), ("separated", "by", "sex"), ("separate", "by", "sex"), ("split", "by", "sex"),
    ("separated", "by", "gender"), ("for", "either", "gender"), ("of", "either", "sex"), ("per", "sex"),
)  # fmt: skip
"""What says that there is one for women and one for men."""


def rooms_by_sex(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the users of such rooms in full, before or behind their noun."""
    tokens = _with_users_first(tokens)
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        sexes = _sexes(tokens, index) if token.kind == "word" else 0
        if sexes:
            result += [*_noun_of(token), *_for_both(tokens[index + 1])]
            index = sexes
            continue
        either = _either(tokens, index) if token.text in _ROOMS or token.text == "room" else 0
        if either:
            result += [token, *_for_both(tokens[index + 1])]
            index = either
        elif (included := _included(tokens, index)) is not None:
            result += included
            index += len(included) - 1 + (_text(tokens, index + 1) == ".")
        elif token.text in ("accessible", "disabled") and _is_bare_one(tokens, index):
            result += [replace(token, text="accessible"), Token("word", "toilet", token.end, token.end)]
            index += 1
        elif _is_led(tokens, index):
            user = tokens[index + 1]
            kind = [result.pop()] if token.text == "room" else []
            noun = [replace(token, text="changing"), _room_behind(token)] if token.text == "dressing" else [token]
            result += [replace(user, text=_SEXES[user.text], kind="word"), *kind, *noun]
            index += 2
        else:
            result.append(token)
            index += 1
    return result


def _with_users_first(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "changing rooms with showers for men and women" for both, each with its own."""
    result = list(tokens)
    for index in range(1, len(tokens) - 4):
        joined = tokens[index].text in ("with", "and", "&") and tokens[index - 1].plural
        if not joined or _text(tokens, index - 2) not in _ROOMS:
            continue
        led = index + 2
        users = [_text(tokens, led + 1), _text(tokens, led + 3)]
        both = _text(tokens, led + 2) in ("and", "&") and all(user in _SEXES for user in users)
        if _text(tokens, index + 1) in _FITTED and _text(tokens, led) == "for" and both:
            at = tokens[index].start
            each = [Token("mark", ",", at, at), Token("word", "each", at, at)]
            result[index : led + 4] = [*tokens[led : led + 4], *each, *tokens[index:led]]
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _sexes(tokens: list[Token], index: int) -> int:
    """Return where "WC m/f" or "changing m+f" ends; 0 where nothing of the kind is said. "d" is for everybody."""
    room = tokens[index].text == "room" and _text(tokens, index - 1) in _KINDS
    if not room and tokens[index].text not in _ROOMS:
        return 0
    pair = {_letter(tokens, index + 1), _letter(tokens, index + 3)}
    if pair not in ({"m", "f"}, {"m", "w"}) or _text(tokens, index + 2) not in ("/", "+", "&", "and"):
        return 0
    others = _text(tokens, index + 4) == "/" and _text(tokens, index + 5) in ("d", "x")
    return index + 4 + 2 * others


def _letter(tokens: list[Token], index: int) -> str:
    """Return a word of one letter as it is written: "w", which is "with" elsewhere."""
    if index >= len(tokens):
        return ""
    token = tokens[index]
    return "w" if token.text == "with" and token.end - token.start == 1 else token.text


_KINDS = frozenset({"changing", "locker", "wash", "shower", "rest", "toilet"})
"""Words before "rooms" that are told apart by sex."""


def _noun_of(token: Token) -> list[Token]:
    """Return the noun in the plural; "changing" and "locker" get theirs."""
    if token.text not in ("changing", "locker"):
        return [replace(token, plural=True)]
    return [token, Token("word", "room", token.end, token.end, plural=True)]


def _room_behind(token: Token) -> Token:
    return Token("word", "room", token.end, token.end)


def _is_led(tokens: list[Token], index: int) -> bool:
    """Whether those who use a room stand behind its noun and the entry of a list ends: "WC f, shower room ladies"."""
    room = tokens[index].text == "room" and _text(tokens, index - 1) in _KINDS
    if not (room or tokens[index].text in _ROOMS | {"dressing"}) or tokens[index].plural:
        return False
    if _text(tokens, index + 1) not in _SEXES:
        return False
    lead = _text(tokens, index - 1 - room)
    return _text(tokens, index + 2) in _ENDS and lead in _ENDS | {":", "and", "+", "&", "staff"}


def _included(tokens: list[Token], index: int) -> list[Token] | None:
    """Return "and accessible toilet" for "incl. disabled" after toilets; nothing elsewhere."""
    if tokens[index].text not in ("incl", "including", "inclusive") or _text(tokens, index - 1) not in _ROOMS:
        return None
    user = index + 1 + (_text(tokens, index + 1) == ".")
    if _text(tokens, user) not in ("disabled", "accessible", "wheelchair") or _text(tokens, user + 1) not in _ENDS:
        return None
    at = tokens[user]
    joint = replace(tokens[index], text="and", kind="word")
    return [joint, replace(at, text="accessible"), Token("word", "toilet", at.end, at.end)]


def _is_bare_one(tokens: list[Token], index: int) -> bool:
    """Whether "and one accessible" ends an entry that began with toilets."""
    one = index >= 2 and tokens[index - 1].kind == "number" and tokens[index - 1].value == 1
    if not one or _text(tokens, index - 2) not in (",", "and", "&", "plus") or _text(tokens, index + 1) not in _ENDS:
        return False
    before = [token.text for token in tokens[max(index - 12, 0) : index]]
    return not _ROOMS.isdisjoint(before) and "of" not in before[-2:]


def _either(tokens: list[Token], index: int) -> int:
    """Return where "toilets by sex" or "WC two by sex" ends after its noun; 0 where nothing of the kind is said."""
    at = index + 1
    at += at < len(tokens) and tokens[at].kind == "number" and tokens[at].value == 2
    for words in _EITHER:
        if tuple(token.text for token in tokens[at : at + len(words)]) == words:
            return at + len(words)
    return 0


def _for_both(place: Token) -> list[Token]:
    """Return the tokens of "for women and men" at the place of another one."""
    return [replace(place, kind="word", text=text, plural=text in ("woman", "man"), value=0.0)
            for text in ("for", "woman", "and", "man")]  # fmt: skip
