"""Agents that carry out tasks with the skills, behind one interface."""
