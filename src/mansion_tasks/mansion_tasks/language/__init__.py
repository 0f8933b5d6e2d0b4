"""Words of tasks and instructions: synonyms, and the objects and rooms that a noun names."""
