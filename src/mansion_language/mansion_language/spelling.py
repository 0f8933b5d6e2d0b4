"""The nearest known word to a misspelt one, by one edit (two in long words)."""

from collections.abc import Set

__all__ = ["Speller"]

LONG = 8
"""Letters from which on a word may have two mistakes."""


class Speller:
    """Finds the known word that a misspelt one stands for.

    Parameters
    ----------
    words : set of str
        What a mistake may have stood for, in the singular.
    favoured : set of str
        Those of the words that are taken before others at the same distance, and for words of four letters alone.
    own : set of str
        Those that are taken before all others at the same distance.

    Notes
    -----
    Words are indexed by each form that they take with one letter left out, so that a look-up takes time in proportion
    to the length of the word and not to the number of words.
    """

    def __init__(self, words: Set[str], favoured: Set[str], own: Set[str] = frozenset()) -> None:
        self.words, self.favoured, self.own = frozenset(words), frozenset(favoured), frozenset(own)
        self._index: dict[str, list[str]] = {}
        for word in sorted(self.words | self.favoured):
            if len(word) >= 4:
                for form in _deletions(word):
                    self._index.setdefault(form, []).append(word)

    def nearest(self, word: str) -> str:
        """Return the nearest word with the same first letter, the word itself when none is near.

        Examples
        --------
        >>> Speller({"kitchen", "counter"}, set()).nearest("kichten")
        'kitchen'
        """
        if word in self.words or word in self.favoured:
            return word
        if word[0] == "f" and "ph" + word[1:] in self.words:
            return "ph" + word[1:]
        limit = 2 if len(word) >= LONG else 1
        best, best_distance = word, limit + 1
        forms = _deletions(word)
        if limit == 2:
            forms = [*forms, *(form for one in forms[1:] for form in _deletions(one)[1:])]
        for form in forms:
            for candidate in self._index.get(form, ()):
                if candidate[0] != word[0] or abs(len(candidate) - len(word)) > limit:
                    continue
                if len(word) < 5 and candidate not in self.favoured:
                    continue
                distance = _edit_distance(word, candidate, limit)
                if (distance, *self._order(word, candidate)) < (best_distance, *self._order(word, best)):
                    best, best_distance = candidate, distance
        return best

    def completed(self, word: str) -> str:
        """Return the one word in which a vowel, or one of a double letter, was left out; else the word itself.

        Examples
        --------
        >>> Speller({"apple", "plant"}, set()).completed("plnt")
        'plant'
        >>> Speller({"lamp"}, {"move"}).completed("mov")
        'move'
        """
        longer = {
            word[:at] + letter + word[at:]
            for letter in sorted({*"aeiou", *word})
            for at in range(1, len(word) + 1)
            if letter in "aeiou" or letter in word[at - 1 : at + 1]
        }
        found = longer & self.words or longer & self.favoured
        return found.pop() if len(found) == 1 else word

    def _order(self, word: str, candidate: str) -> tuple[bool, bool, bool, str]:
        """Return what candidates at the same distance go by: the same letters in another order are the likeliest."""
        swapped = sorted(word) == sorted(candidate)
        return not swapped, candidate not in self.own, candidate not in self.favoured, candidate


def _deletions(word: str) -> list[str]:
    return [word, *sorted({word[:i] + word[i + 1 :] for i in range(len(word))})]


def _edit_distance(a: str, b: str, limit: int) -> int:
    """Edits between two words, a swap of neighbours counting one; `limit` + 1 when there are more."""
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, left in enumerate(a, 1):
        before, last, row = row, before, [i]
        for j, right in enumerate(b, 1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (left != right))
            if i > 1 and j > 1 and left == b[j - 2] and a[i - 2] == right:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]
