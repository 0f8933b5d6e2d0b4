"""Algorithm 1 from request to furnished floors, over stages that run here or behind services."""
