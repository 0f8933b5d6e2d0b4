"""Rules that put clauses which ask for one thing only together as one order, by what they ask for."""
