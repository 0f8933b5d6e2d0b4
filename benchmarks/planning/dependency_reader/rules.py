"""The choices that a reader by dependency parse leaves open."""

from dataclasses import dataclass

__all__ = ["Rules"]


@dataclass(frozen=True)
class Rules:
    """The choices of the reader, which `compare_readers.py` makes by cross-validation.

    Attributes
    ----------
    lines : bool
        The parser gets whole lines and parts them into sentences itself, rather than the product's sentences.
    headings : bool
        A storey before a colon, or alone on its line, places all that follows.
    carry : bool
        A sentence that names no storey goes on about the storey of the sentence before.
    conjuncts_placed : bool
        "A, B and C on the top floor" places all three, not C alone.
    reach : int
        The longest path in the tree from the words of a relation up to the room on its left.
    coreference : bool
        "the kitchen" is the kitchen that was named before.
    definite_only : bool
        Only with a definite determiner; else every repetition of an uncounted name.
    unknown_rooms : bool
        "honey room" is a room, though the knowledge base does not have it.
    topic_owns : bool
        Furniture that no preposition or verb gives a room belongs to the room that heads its sentence.
    any_negated_verb : bool
        The object of every negated verb is unwanted, not only that of "want", "have", "need" and their like.
    numbered_noun : bool
        A number after the noun counts it: "meeting rooms: 4", "bedrooms x3".
    purposes : bool
        "a room for books" is named after what it is for.
    unknown_objects : bool
        What a room has, or is "with", is furniture, though the catalogue does not have it.
    """

    lines: bool = False
    headings: bool = True
    carry: bool = False
    conjuncts_placed: bool = True
    reach: int = 4
    coreference: bool = True
    definite_only: bool = True
    unknown_rooms: bool = True
    topic_owns: bool = True
    any_negated_verb: bool = False
    numbered_noun: bool = True
    purposes: bool = True
    unknown_objects: bool = False
