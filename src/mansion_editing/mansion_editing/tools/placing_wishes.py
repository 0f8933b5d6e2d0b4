"""Wishes for the place of an object: the objects that they name, and how they are put into words when refused."""

from collections import Counter

from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import InRoom
from mansion_editing.tools.perception import object_named
from mansion_editing.tools.relations import PlacingWish, footprint_gap
from mansion_msgs_py.editing.objects import PlacingWishes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.wording import with_article

__all__ = ["hangs", "hindered", "refusal", "wish_of", "wish_words"]

MOST_NAMED = 4


def wish_of(state: SceneState, args: PlacingWishes) -> PlacingWish:
    """Return the wish with its objects.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``CONFLICT`` for a name that fits no object or several, ``INVALID_PAYLOAD`` for a side or a gap
        without a landmark, and for ``between`` without a second one.
    """
    if not args.near and (args.side or args.within is not None or args.apart is not None):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "side, within and apart need near, an object", path="$.near")
    if (args.side == "between") != bool(args.other):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, "between needs other, a second object; nothing else does", path="$.other"
        )
    if args.door and args.spot != "door":
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "door tells which door the spot door means", path="$.door")
    near, other = _named(state, args.near, "near"), _named(state, args.other, "other")
    if near is not None and near == other:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"near and other are both {near.id}", path="$.other")
    return PlacingWish(
        near=near,
        side=args.side,
        other=other,
        within=args.within,
        apart=args.apart,
        spot=args.spot,
        door=args.door,
        facing=_named(state, args.facing, "facing"),
    )


def _named(state: SceneState, reference: str, field: str) -> SceneObject | None:
    return object_named(state, reference, f"$.{field}")[1] if reference else None


def _why_none(thing: SceneObject, wish: PlacingWish, room: SceneRoom) -> str:
    """Say why not even an empty room has such a place."""
    h = thing.size[2]
    near, other = wish.near, wish.other
    if near is not None and other is not None:
        return f"{near.id} and {other.id}, {footprint_gap(near, other):.2f} m apart, leave no room for it between them"
    if near is not None and wish.side == "under" and not wish.spot and wish.facing is None:
        most = " x ".join(f"{value:.2f}" for value in near.size)
        return f"{near.id} of {most} m is not large enough for what is {h:.2f} m high"
    if near is not None and wish.side == "above":
        return f"{near.id} is not at a wall" if thing.mount == "wall" else f"{room.id} is too small for it"
    if wish.spot in ("window", "door", "corner") and near is None:
        return f"{room.id} has no {wish.spot} that it fits at"
    both = sum((near is not None, bool(wish.spot), wish.facing is not None)) > 1
    if both or near is None:
        return f"nowhere in {room.id} does all of this hold{' together' if both else ''}"
    return f"the walls of {room.id} leave no room on that side of {near.id}"


def refusal(message: str, path: str = "$") -> MansionError:
    """Return the error for what cannot be done."""
    return MansionError(ErrorCode.INFEASIBLE, message, path=path)


def wish_words(wish: PlacingWish) -> str:
    """Return a wish in words."""
    near = "" if wish.near is None else wish.near.id
    words = {
        "between": f"between {near} and {'' if wish.other is None else wish.other.id}",
        "front": f"in front of {near}",
        "left": f"left of {near}",
        "right": f"right of {near}",
    }
    parts = [words.get(wish.side, f"{wish.side or 'near'} {near}")] if near else []
    if wish.within is not None:
        parts.append(f"within {wish.within:g} m of it")
    if wish.apart is not None:
        parts.append(f"at least {wish.apart:g} m from it")
    if wish.door:
        parts.append(f"at {wish.door}")
    elif wish.spot:
        parts.append({"corner": "in a corner", "middle": "in the middle"}.get(wish.spot, f"at a {wish.spot}"))
    if wish.facing is not None:
        parts.append(f"turned to {wish.facing.id}")
    return ", ".join(parts)


def hangs(thing: SceneObject, consequence: str) -> MansionError:
    """Return the refusal to put what hangs on walls or ceilings anywhere else."""
    return refusal(f"{with_article(thing.name)} hangs on {with_article(thing.mount)}, {consequence}")


def hindered(thing: SceneObject, where: InRoom, reasons: Counter[str]) -> MansionError:
    """Return the refusal of a wish that names what is most often in the way."""
    wish, room = where.wish, where.room
    marks = [mark for mark in (wish.near, wish.other, wish.facing) if mark is not None]
    elsewhere = [mark for mark in marks if mark.room != room.id]
    if elsewhere:
        return refusal(f"{elsewhere[0].id} is not in {room.id}")
    w, d, _ = thing.size
    what = f"no place for {with_article(thing.name)} of {w:.2f} x {d:.2f} m {wish_words(wish)} in {room.id}"
    if not reasons:
        return refusal(f"{what}: {_why_none(thing, wish, room)}")
    named = [name for name, _ in sorted(reasons.items(), key=lambda entry: (-entry[1], entry[0]))][:MOST_NAMED]
    verb = "is" if len(named) == 1 else "are"
    return refusal(f"{what}: {', '.join(named)} {verb} in the way")
