"""Runs of policies over the tools of an editor, which land as one transaction."""
