"""Recordings for Rerun: what MCAP files hold, drawn into the building."""
