"""The robot's camera: pictures of the world as it is now, rendered offscreen from the building's own geometry."""

from mansion_skills.vision.camera import Camera
from mansion_skills.vision.frame import Frame, Intrinsics

__all__ = ["Camera", "Frame", "Intrinsics"]
