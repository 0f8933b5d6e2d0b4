"""AI2-THOR as scene and skills use it: its axes, and a controller that starts, acts and says why it did not."""
