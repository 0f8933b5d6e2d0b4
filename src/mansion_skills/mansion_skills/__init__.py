"""The robot in the building: world state, navigation, skills, tasks and agents.

The world is a scene plus an overlay of what the robot did; a skill is a pure step from world to world with a
result. `nodes` holds the thin ROS 2 node around them.
"""

__version__ = "0.1.0"
