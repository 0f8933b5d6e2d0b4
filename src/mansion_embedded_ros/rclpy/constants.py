"""Constants shared by the time types."""

S_TO_NS = 1000 * 1000 * 1000
