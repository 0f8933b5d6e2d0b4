"""From the program of a floor to its room graph and its solver problem."""
