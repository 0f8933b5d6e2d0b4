"""Tell cellars that are rooms of another storey from those that are storeys."""

from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["keeps_goods"]


_PROCESSES = frozenset({"fermentation", "fermenting", "maturing", "maturation", "ageing", "ripening", "barrel", "cask"})
"""What is done in a room that breweries and dairies call a cellar, on whatever storey."""


def keeps_goods(reading: Reading, index: int) -> bool:
    """Whether a cellar is one of the rooms of another storey: "on the ground floor a kitchen, a cellar for wine"."""
    if reading.word(index - 1) in _PROCESSES and index - 1 not in reading.taken:
        return True  # "brewhouse, fermentation cellar with eight tanks"
    lead = index - 1 - (reading.word(index - 1) in ("a", "one", "the"))
    listed = reading.word(lead) in (",", "and", ":") and reading.word(index + 1) in ("for", "of")
    kept = index + 2 + (reading.word(index + 2) in ("the", "our", "my"))
    alone = reading.kind(kept) == "word" and reading.word(kept + 1) in (",", "and", ".", ";", "", "with", "(")
    before = reading.words(reading.sentence.index(reading.sentence[index]), index)
    return listed and alone and not FLOOR_WORDS.isdisjoint(before)
