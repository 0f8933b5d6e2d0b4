"""Tasks for a robot: goals, agents that do them, episodes that are judged, and the Gymnasium environment."""
