"""The editor's tools: pure functions from a state and arguments to a reply."""
