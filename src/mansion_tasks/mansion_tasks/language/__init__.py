"""The language of instructions: its vocabulary, and which objects and rooms a noun names."""
