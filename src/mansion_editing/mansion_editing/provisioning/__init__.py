"""Provisioning: what a task needs of a building is checked, and provided where it is missing."""
