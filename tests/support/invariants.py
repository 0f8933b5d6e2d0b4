"""What is true of a world whatever happened in it."""

from mansion_skills.world.world import World

__all__ = ["check_world"]


def check_world(world: World) -> None:
    """Every object is in exactly one place, and every robot stands where it can."""
    listed: dict[str, int] = {}
    for floor in world.building.floors:
        for state in world.objects.on_floor(floor):
            assert state.id not in listed, f"{state.id} is on two floors"
            assert state.floor == floor
            listed[state.id] = floor
    for name in world.objects:
        state = world.objects.state(name)
        held = state.held_by is not None
        assert held != (name in listed), f"{name} is held and on a floor, or neither"
        assert (state.floor is None) == held
        if held and state.parent is None:
            assert world.objects.held_by(state.held_by) == name
        assert state.position is not None or (held and state.parent is None)
        if state.parent is not None:
            carrier = world.objects.state(state.parent)
            assert name in world.objects.children(state.parent)
            assert (carrier.floor, carrier.held_by) == (state.floor, state.held_by)
            seen = {name}
            while state.parent is not None:
                assert state.parent not in seen, f"{name} carries itself"
                seen.add(state.parent)
                state = world.objects.state(state.parent)
    for robot in world.robots.values():
        assert robot.floor in world.building.floors
        assert world.view(robot.floor).map.room_at(*robot.place) is not None
    for lift in world.lifts.values():
        waiting = [call.session for call in lift.queue]
        assert len(waiting) == len(set(waiting)) and lift.session not in waiting
        assert min(lift.elevations.values()) <= lift.position <= max(lift.elevations.values())
        assert 0.0 <= lift.opening <= 1.0
