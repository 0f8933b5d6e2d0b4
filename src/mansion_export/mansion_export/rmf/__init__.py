"""A building for Open-RMF.

==============  ==============================================================
``maps``        the building map and the navigation graph, written
``graph``       waypoints and lanes of a building
``crossings``   ways through doors and into lifts
``free_floor``  where a robot's centre may be
``ways``        straight ways through a piece of floor
``fixtures``    walls, doors, slabs and lifts
``yaml_text``   YAML with the same bytes for the same values
==============  ==============================================================
"""
