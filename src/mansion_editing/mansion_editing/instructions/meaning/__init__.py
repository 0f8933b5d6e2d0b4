"""What the words of statements mean in a scene; nothing here changes it."""
