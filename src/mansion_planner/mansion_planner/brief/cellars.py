"""Tell cellars that are rooms of another storey from those that are storeys."""

from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["keeps_goods"]


def keeps_goods(reading: Reading, index: int) -> bool:
    """Whether a cellar is one of the rooms of another storey: "on the ground floor a kitchen, a cellar for wine"."""
    lead = index - 1 - (reading.word(index - 1) in ("a", "one", "the"))
    listed = reading.word(lead) in (",", "and", ":") and reading.word(index + 1) in ("for", "of")
    kept = index + 2 + (reading.word(index + 2) in ("the", "our", "my"))
    alone = reading.kind(kept) == "word" and reading.word(kept + 1) in (",", "and", ".", ";", "", "with", "(")
    before = reading.words(reading.sentence.index(reading.sentence[index]), index)
    return listed and alone and not FLOOR_WORDS.isdisjoint(before)
