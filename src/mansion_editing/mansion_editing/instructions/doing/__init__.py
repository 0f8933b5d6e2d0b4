"""Statements carried out with the editor's tools, and questions answered."""
