"""Instructions in English: what they ask for, done with the editor's tools, and checked on the scene."""
