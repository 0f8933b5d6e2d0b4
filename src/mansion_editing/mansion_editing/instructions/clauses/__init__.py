"""Clauses of instructions: a verb or a predicate with its noun phrases and places, read into statements."""
