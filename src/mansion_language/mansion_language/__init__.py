"""English as people write of buildings and robots: tokens, numbers and units, inflection."""

from mansion_language.inflection import is_plural, plural, singular
from mansion_language.tokens import Token, tokenize

__all__ = ["Token", "is_plural", "plural", "singular", "tokenize"]
