"""The node that serves the skills."""
