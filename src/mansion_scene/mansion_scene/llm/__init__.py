"""Furniture chosen by a language model: objects with constraints for a room (section G), checked before use."""
