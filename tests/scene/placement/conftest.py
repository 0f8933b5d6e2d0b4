"""Makes the sample rooms of this folder importable by its tests."""
