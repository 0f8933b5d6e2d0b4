"""What physics engines need of a building: collision shapes, room for loose objects, parts on joints."""
