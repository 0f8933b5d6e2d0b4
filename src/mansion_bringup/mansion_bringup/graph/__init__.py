"""The node graph as processes: starting, watching and ending it where no launch system is needed."""
