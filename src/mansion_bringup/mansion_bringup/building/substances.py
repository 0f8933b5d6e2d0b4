"""What surfaces are made of, in the words of a wish, a program or a scene."""

import re

__all__ = ["is_made_of"]

_SUBSTANCES = {
    "wood": "wood wooden hardwood timber parquet plank planks laminate panelling deck decking herringbone"
    " oak walnut pine maple birch bamboo cherry ash beech mahogany",
    "carpet": "carpet carpeted carpeting",
    "tiles": "tile tiles tiled ceramic porcelain terracotta",
    "marble": "marble",
    "granite": "granite",
    "stone": "stone slate limestone",
    "terrazzo": "terrazzo",
    "concrete": "concrete cement",
    "vinyl": "vinyl linoleum lino",
    "rubber": "rubber",
    "resin": "resin epoxy",
    "brick": "brick bricks",
    "plaster": "plaster plastered drywall",
}
"""What surfaces are made of, and the words that say so in a wish, a program or a scene."""


def is_made_of(surface: str, wanted: str) -> bool:
    """Whether a surface is of the substance that is wanted; where only colours are, whether it has one of them."""
    substances = _substances(wanted)
    if substances:
        return not substances.isdisjoint(_substances(surface))
    return not _material_words(wanted).isdisjoint(_material_words(surface))


def _substances(text: str) -> set[str]:
    words = _material_words(text)
    return {name for name, known in _SUBSTANCES.items() if not words.isdisjoint(known.split())}


def _material_words(text: str) -> set[str]:
    return set(re.findall("[a-z]+", text.lower().replace("gray", "grey")))
