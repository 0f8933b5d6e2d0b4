"""The vocabulary of instructions: names of things, rooms and colours, and the grammar of nouns."""
