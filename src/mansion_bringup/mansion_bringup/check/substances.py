"""What surfaces are made of, by the words of their materials."""

import re

__all__ = ["made_of"]

SUBSTANCES = (
    r"\b(hard)?wood(en)?\b|timber|parquet|\bplanks?\b|laminate|panelling|\bdeck(ing)?\b|herringbone|\b(oak|walnut|pine|maple"
    r"|birch|bamboo|cherry|ash|beech|mahogany)\b",
    r"carpet",
    r"\btile[sd]?\b|ceramic|porcelain|terracotta",
    r"marble",
    r"granite",
    r"\bstone\b|slate|limestone",
    r"terrazzo",
    r"concrete|cement",
    r"vinyl|\blino(leum)?\b",
    r"rubber",
    r"resin|epoxy",
    r"brick",
    r"plaster|drywall",
)
"""Patterns of the words for one substance each."""


def made_of(surface: str, wanted: str) -> bool:
    """Whether one substance, or where no substance is wanted one colour, is in both texts."""
    here, there = (text.lower().replace("_", " ").replace("gray", "grey") for text in (surface, wanted))
    named = [pattern for pattern in SUBSTANCES if re.search(pattern, there)]
    if named:
        return any(re.search(pattern, here) for pattern in named)
    return any(re.search(rf"\b{re.escape(word)}\b", here) for word in there.split())
