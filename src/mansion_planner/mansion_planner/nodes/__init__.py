"""The planner package's ROS nodes: thin shells around pure functions."""
