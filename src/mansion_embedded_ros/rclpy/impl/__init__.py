"""The parts of rclpy behind its public modules."""
