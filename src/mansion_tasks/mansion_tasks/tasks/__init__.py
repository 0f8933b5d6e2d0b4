"""Tasks for a robot: goals on the world, their progress, their making, and an oracle that can do them."""
