"""Instructions that a language model reads: into the same statements as the rules, carried out and checked alike."""
