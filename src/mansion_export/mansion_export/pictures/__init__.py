"""Pictures of buildings, rooms and assets, drawn without a graphics card."""
