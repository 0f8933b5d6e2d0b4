"""The grammar of an instruction: what its words are, where its clauses begin, and which of them ask for something."""
