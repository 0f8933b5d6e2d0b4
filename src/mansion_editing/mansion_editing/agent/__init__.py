"""The editing agent: thought, one JSON action, observation, until the facts of an instruction hold."""
