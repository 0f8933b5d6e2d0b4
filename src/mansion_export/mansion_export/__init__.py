"""What other programs and people read, made from `FloorScene` payloads.

Every function here is pure: payloads in, bytes, text or a dictionary out. The coordinates of the formats (AI2-THOR's
left-handed y-up, glTF's right-handed y-up) are converted in `mansion_geometry.thor.house_format` and in `glb`.

=============  =========================================================
``plan``       floor plan as SVG and PNG
``overview``   axonometric picture of the whole building
``nav2``       occupancy map for the Navigation2 map server
``thor``       AI2-THOR house JSON, and its validator
``glb``        binary glTF of a floor or of the building
``mjcf``       MuJoCo model of a floor
``sdf``        Gazebo world
``rmf``        building map and navigation graph for Open-RMF
``usd``        OpenUSD stage (needs the ``usd`` extra)
``html``       self-contained page with a 3D viewer
=============  =========================================================
"""

__version__ = "0.1.0"
