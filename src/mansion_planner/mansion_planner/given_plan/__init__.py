"""A plan that the user has, as the program, room graphs and solved problems of a building."""
