"""A building folder as the robot's world reads it."""

from mansion_skills.building.folder import LoadedBuilding

__all__ = ["LoadedBuilding"]
