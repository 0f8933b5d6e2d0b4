"""Whether what statements ask for is true of the finished scene, and nothing else has changed."""
