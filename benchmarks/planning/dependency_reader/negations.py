"""What a parsed brief does not want: how far "no", "without" and negated verbs reach in the tree."""

from collections.abc import Sequence

from dependency_reader.nouns import Thing
from dependency_reader.relations import APART, BESIDE
from dependency_reader.rules import Rules
from dependency_reader.tree import Node

__all__ = ["negate", "refused"]

_WANTING = frozenset(
    "want have has need needed wanted required require be is are been include included put miss".split()
)
_REFUSING = frozenset("skip omit avoid refuse exclude drop forget".split())


def refused(node: Node, rules: Rules) -> bool:
    """Whether what a noun is the object or subject of is negated."""
    if node.dep_ == "pobj":
        head = node.head
        if head.lower_ == "without" or (head.lower_ == "of" and head.head.lower_ in ("instead", "free", "rid")):
            return True
        return head.lower_ == "for" and any(child.lower_ == "no" for child in head.head.children)
    if node.dep_ not in ("dobj", "attr", "nsubj", "nsubjpass", "expl", "appos", "dep", "ROOT", "advcl"):
        return False
    verb = node.head
    if any(child.dep_ == "neg" and child.i < node.i for child in node.children):
        return True
    if verb == node:
        return False
    negated = any(child.dep_ == "neg" or child.lower_ == "never" for child in verb.children)
    there = any(child.dep_ == "expl" for child in verb.children)
    if verb.pos_ == "AUX" and not there and any(child.dep_ in ("attr", "acomp") for child in verb.children):
        return False
    if verb.dep_ == "xcomp" and verb.head.lower_ in _REFUSING:
        return True
    if verb.lower_ in _REFUSING:
        return not negated and node.dep_ == "dobj"
    beside = any(child.dep_ in ("acomp", "prep") and child.lower_ in BESIDE | APART for child in verb.subtree)
    asked = rules.any_negated_verb or verb.lower_ in _WANTING
    return negated and asked and not beside and (verb.lower_ not in BESIDE)


def negate(things: Sequence[Thing], rules: Rules) -> None:
    """Mark the things that are not wanted."""
    for thing in things:
        node = thing.node
        while True:
            no = any(
                child.lower_ in ("no", "neither") and child.dep_ in ("det", "neg", "preconj") for child in node.children
            )
            if no or refused(node, rules):
                thing.negated = not any(c.lower_ == "neither" for c in node.children)
                break
            joined = node.dep_ == "conj" and any(
                child.dep_ == "cc" and child.lower_ in ("or", "nor") for child in (*node.head.children, *node.children)
            )
            listed = node.dep_ in ("conj", "appos") and not any(
                child.dep_ in ("det", "nummod") for child in thing.node.children
            )
            if not (joined or (listed and node.head.dep_ == "pobj" and node.head.head.lower_ == "without")):
                break
            node = node.head
