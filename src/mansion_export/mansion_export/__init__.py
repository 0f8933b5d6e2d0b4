"""What other programs and people read, made from `FloorScene` payloads.

Every function here is pure: payloads in, bytes, text or a dictionary out. The coordinates of the formats (AI2-THOR's
left-handed y-up, glTF's right-handed y-up) are converted in `mansion_geometry.thor.house_format` and in `glb`.
The formats are registered in `formats`.
"""
