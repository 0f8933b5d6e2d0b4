"""A building for Open-RMF.

==============  ==============================================================
``maps``        the building map and the navigation graph, as YAML
``graph``       waypoints and lanes of a building
``lane_paths``  straight lanes through a region of free floor
``free_floor``  where a robot's centre may be
==============  ==============================================================
"""
