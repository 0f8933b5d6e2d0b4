"""The node that runs Algorithm 1 over the other nodes."""
