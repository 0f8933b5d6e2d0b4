"""From floor layouts to furnished scenes: structure, openings, objects and light.

Every stage is a pure function from payload to payload that is handed its random generator; `nodes` holds the thin
ROS 2 nodes around them.
"""
