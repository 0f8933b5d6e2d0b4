"""The skills: each checks what it needs, changes the world, and says what it did."""
