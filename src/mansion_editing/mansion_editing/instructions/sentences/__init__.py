"""Sentences of instructions: their clauses in order, questions, and what one sentence tells of another."""
