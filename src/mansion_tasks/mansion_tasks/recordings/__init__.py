"""Recordings: what a robot did, as files that other programs play back."""
