"""Leave out what a building is converted from: "conversion of one bay of a former mill into a home"."""

from mansion_language import Token

__all__ = ["without_conversions"]

_CONVERTING = frozenset(
    "conversion refurbishment transformation remodelling remodeling adaptation reuse convert converting turn turning "
    "transform transforming rebuild rebuilding".split()
)
_LONGEST = 16
_OPENS = frozenset({"", ".", "!", "\n", ":", "the", "a", "an", "for", "is", "we", "to", "please", "project"})
_NEW = frozenset({"a", "an", "our", "my", "one", "two", "three", "four", "some", "several"})
_HAPPENING = frozenset({"happen", "happens", "happening", "everything", "place"})
_DONE = frozenset("cooking sleeping eating working living dining reading playing relaxing bathing".split())


def without_conversions(tokens: list[Token]) -> list[Token]:
    """Return the tokens without the old building, and without what is done in a room where everything happens."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        before = tokens[index - 1].text if index else ""
        host = _floor_of_host(tokens, index)
        if host:
            first, last = tokens[index], tokens[host - 1]
            result += [Token("word", word, first.start, last.end) for word in ("on", "one", "floor")]
            result[-2] = Token("number", "one", first.start, last.end, 1.0)
            index = host
            continue
        end = _converted(tokens, index) if tokens[index].text in _CONVERTING and before in _OPENS else 0
        if end:
            index = end
            continue
        if not _is_done_there(tokens, index):
            result.append(tokens[index])
        index += 1
    return result


_FLOORS = frozenset({"floor", "storey", "level"})
_OLD = frozenset({"old", "former", "existing", "disused", "historic"})
_STANDING = frozenset(
    """
    block building house tower bank mill church warehouse factory barn hall school villa mall centre center hotel
    """.split()
)


def _floor_of_host(tokens: list[Token], index: int) -> int:
    """Return where "on the first floor of an existing office block" ends; 0 where a token opens no such words."""
    if index and tokens[index - 1].text in ("the", "whole", "each", "every"):
        return 0
    texts = [token.text for token in tokens[index : index + 12]]
    at = int(texts[:1] in (["on"], ["in"], ["at"]))
    at += texts[at : at + 1] == ["the"]
    named = at < len(texts) and (tokens[index + at].kind == "ordinal" or texts[at] in ("ground", "top", "upper"))
    if not named or texts[at + 1 : at + 2] == [] or texts[at + 1] not in _FLOORS:
        return 0
    at += 2
    if texts[at : at + 1] != ["of"] or texts[at + 1 : at + 2] not in (["a"], ["an"], ["the"], ["our"]):
        return 0
    noun = next((k for k in range(at + 2, len(texts)) if texts[k] in _STANDING), 0)
    old = not _OLD.isdisjoint(texts[at + 2 : noun])
    return index + noun + 1 if noun and old and noun - at < 6 else 0


def _converted(tokens: list[Token], index: int) -> int:
    """Return where the new building stands after "conversion of ... into"; 0 where none does."""
    for at in range(index + 1, min(index + _LONGEST, len(tokens) - 1)):
        if tokens[at].text in (".", ";", "\n", "!"):
            return 0
        if tokens[at].text in ("into", "to") and tokens[at + 1].text in _NEW:
            return at + 1
    return 0


def _is_done_there(tokens: list[Token], index: int) -> bool:
    """Whether a token only lists what people do in a hall where "everything happens": "- cooking, sleeping, ..."."""
    if tokens[index].text not in _DONE or not index:
        return False
    alone = tokens[index - 1].text in (",", "-", "–", ":", "(", "and")
    alone = alone and index + 1 < len(tokens) and tokens[index + 1].text in (",", ".", "and", ")", "-", "–")
    first = index
    while first > 0 and tokens[first - 1].text not in (".", "\n", "!"):
        first -= 1
    return alone and not _HAPPENING.isdisjoint(token.text for token in tokens[first:index])
