"""Words, and the phrases they make: amounts, nouns, places, storeys and verbs."""
