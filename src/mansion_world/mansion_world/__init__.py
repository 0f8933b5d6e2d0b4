"""Worlds of many buildings: requests drawn from a mixture, built, checked, split and described."""
