"""Episodes: an agent at a task, judged, logged, repeated and shown."""
