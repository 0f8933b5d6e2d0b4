"""Instructions that are not understood as they stand, put in other words."""
