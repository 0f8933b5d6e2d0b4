"""From a sentence to floor layouts: the building program, the room graph of each floor, and its floor plan.

Every stage is a pure function from payload to payload that is handed its random generator; `nodes` holds the thin
ROS 2 nodes around them.
"""
