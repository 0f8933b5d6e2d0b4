"""Forms of English verbs: which verb a word may be, and in which form."""

from functools import cache
from importlib.resources import files
from typing import Final, Literal, NamedTuple, TypeAlias

__all__ = ["Form", "VerbForm", "verb_forms"]

Form: TypeAlias = Literal["base", "third", "past", "participle", "gerund"]

_VOWELS: Final = frozenset("aeiou")
_NOT_DOUBLED: Final = frozenset("wxy")


class VerbForm(NamedTuple):
    """A verb in its base form, and the form of it that a word is."""

    verb: str
    form: Form


def verb_forms(word: str) -> tuple[VerbForm, ...]:
    """Return what verbs a word in lower case may be a form of.

    Examples
    --------
    >>> verb_forms("left")
    (VerbForm(verb='leave', form='past'), VerbForm(verb='leave', form='participle'))
    >>> verb_forms("wobbles")
    (VerbForm(verb='wobble', form='third'),)
    >>> verb_forms("sofa")
    ()
    """
    return _table().get(word, ())


@cache
def _table() -> dict[str, tuple[VerbForm, ...]]:
    table: dict[str, list[VerbForm]] = {}
    for line in files(__package__).joinpath("data/verbs.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            for word, form in _forms(line.split()):
                table.setdefault(word, []).append(form)
    return {word: tuple(dict.fromkeys(forms)) for word, forms in table.items()}


def _forms(parts: list[str]) -> list[tuple[str, VerbForm]]:
    """Return the forms of a verb of which the base, and irregular ones, are given."""
    base = parts[0]
    regular = _with_ending(base, "ed")
    past, participle = parts[1:3] if len(parts) > 2 else (regular, regular)
    said: list[tuple[str, Form]] = [
        (base, "base"), (_third(base), "third"), (past, "past"), (participle, "participle"),
        (_with_ending(base, "ing"), "gerund"),
    ]  # fmt: skip
    if past != regular:
        said += [(regular, "past"), (regular, "participle")]  # "leaned", "burned"
    return [(word, VerbForm(base, form)) for word, form in said]


def _third(base: str) -> str:
    if base in ("be", "have"):
        return "is" if base == "be" else "has"
    if base.endswith(("s", "x", "z", "ch", "sh", "o")):
        return f"{base}es"
    return f"{base[:-1]}ies" if base.endswith("y") and base[-2] not in _VOWELS else f"{base}s"


def _with_ending(base: str, ending: str) -> str:
    """Return a verb with ``ed`` or ``ing``: ``carried``, ``dropping``."""
    if ending == "ing" and base in ("lie", "die"):
        return f"{base[:-2]}ying"
    if base.endswith("e") and not base.endswith("ee") and base != "be":
        return f"{base[:-1]}{ending}"
    if ending == "ed" and base.endswith("y") and base[-2] not in _VOWELS:
        return f"{base[:-1]}ied"
    short = len([letter for letter in base if letter in _VOWELS]) == 1
    doubled = base[-1] not in _VOWELS | _NOT_DOUBLED and base[-2:-1] in tuple(_VOWELS) and short
    return f"{base}{base[-1] if doubled or base in ('transfer', 'prefer', 'swivel', 'label', 'travel') else ''}{ending}"
