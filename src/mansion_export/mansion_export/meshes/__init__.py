"""The building as meshes, materials and nodes, which every 3D format is written from."""
