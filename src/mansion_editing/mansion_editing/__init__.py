"""The task-semantic scene editor: tools over a building's scenes, physics on demand, and the agent that uses them."""
