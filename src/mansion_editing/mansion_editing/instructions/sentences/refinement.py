"""Statements that later words tell more of: their places, storeys and numbers."""

import re
from collections.abc import Sequence
from typing import Any, Final, TypeGuard

import msgspec

from mansion_editing.instructions.clauses.items import Item, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.places import SAME_FLOOR, merged, with_place
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Clear,
    Ensure,
    Furnish,
    Keep,
    Mention,
    Move,
    Place,
    Relation,
    Remove,
    Rename,
    Replace,
    Rooms,
    Statement,
    Things,
)

__all__ = [
    "adds_it",
    "counted_by",
    "counting_those_there",
    "counts_those_brought",
    "exactly",
    "given_but_to",
    "goes_as_well",
    "goes_while_others_stay",
    "held_there",
    "in_place_of",
    "is_everything",
    "is_only_fetched",
    "is_open",
    "is_surplus",
    "left_where_brought",
    "moved_on",
    "moves_it",
    "must_contain",
    "narrowed",
    "of_none",
    "on_each_side",
    "only_so_many_stay",
    "one_more_there",
    "only_brings_it",
    "placed_at_last",
    "removes_all_of_it",
    "removes_what_went",
    "sets_as_one",
    "sharing_as_told",
    "so_many",
    "sparing_what_goes",
    "spared_of",
    "surplus_of",
    "tells_of_surplus",
    "tells_who_may_stay",
    "turned_by_list",
    "with_noun_at",
    "with_storeys",
]


def exactly(statement: Statement) -> Statement:
    """Return a statement of exactly the number that it names."""
    if isinstance(statement, Ensure | Add) and statement.things.amount.kind == "some":
        amount = Amount(kind="exactly", number=statement.things.amount.number)
        things = msgspec.structs.replace(statement.things, amount=amount)
        return Ensure(things=things, place=statement.place, each=statement.each, quote=statement.quote)
    return statement


_SURPLUS: Final = re.compile(r"\b(spare|surplus|extra|excess|superfluous|redundant|left ?over) ones?\b", re.IGNORECASE)


def is_surplus(statement: Move | Remove, last: Ensure) -> bool:
    """Whether a statement says what becomes of the things beyond the number that shall be: ``the spare ones``."""
    things, most = statement.things, last.things.amount
    named = bool(_SURPLUS.search(statement.quote)) and things.noun in ("", "one", last.things.noun)
    others = things.refers == "others" and not things.noun and isinstance(statement, Move)
    counted = things.refers == "last" and things.amount.kind == "some" and things.amount.number > 0
    fewer = counted and not (things.noun or things.definite) and isinstance(statement, Remove)
    return (
        (named or others or fewer)
        and most.kind in ("at_most", "exactly")
        and things.place is None
        and bool(last.things.noun)
    )


def tells_of_surplus(statement: Statement) -> bool:
    """Whether a statement is about ``the spare ones`` of what was counted before."""
    return isinstance(statement, Move | Remove) and bool(_SURPLUS.search(statement.quote))


def tells_who_may_stay(statement: Statement) -> bool:
    """Whether a statement only says that so many may stay, and not where: ``two plates may stay``."""
    if not isinstance(statement, Ensure) or statement.place != Place() or statement.things.amount.kind != "some":
        return False
    return bool(re.search(r"\b(may|can|could) (stay|remain|be left)$", statement.quote))


def surplus_of(last: Ensure, things: Things) -> Things:
    """Return the things beyond the number that shall be at a place."""
    most = last.things.amount.number
    whole = most + things.amount.number if things.refers and things.amount.kind == "some" else 0
    rest = Amount(kind="all_but", number=most, of=whole if whole > most else 0)
    at = None if last.place == Place() else last.place
    return msgspec.structs.replace(last.things, amount=rest, definite=True, plural=True, place=at)


def counting_those_there(statement: Statement) -> Statement:
    """Return that so many are there, those that are there already among them."""
    if isinstance(statement, Add) and statement.things.amount.kind == "some":
        return Ensure(things=statement.things, place=statement.place, each=statement.each, quote=statement.quote)
    return statement


def turned_by_list(statements: Sequence[Statement], text: str) -> list[Statement]:
    """Return statements in which a room that becomes another one is only called so, where a list furnishes it.

    ``Turn the study into a guest room: the desk goes, a bed comes in`` tells all that changes in it; without the colon
    in the `text` it must tell what stays, too, or that what goes is in it: what is furnished anew has no such desk.
    """
    out = list(statements)
    for at, statement in enumerate(out):
        if not isinstance(statement, Furnish) or not statement.kind or statement.rooms.every:
            continue
        rest = [s for s in out[at + 1 :] if _is_in_it(s, statement.rooms)]
        listed = text.partition(statement.quote)[2].lstrip().startswith(":")
        emptied = any(isinstance(s, Remove) and s.things.place is not None for s in rest)
        told = (Remove, Add) if listed or emptied else (Remove, Add, Keep)
        if all(any(isinstance(s, kind) for s in rest) for kind in told):
            name = statement.kind.capitalize()
            out[at] = Rename(room=statement.rooms, name=name, quote=statement.quote)
    return out


def sparing_what_goes(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which what stays is not what another one names more closely and moves or removes.

    After ``load the stacks of books on the cart`` the book that stays is none of those.
    """
    gone = {s.things.noun for s in statements if isinstance(s, Move | Remove) and s.things.noun}
    out: list[Statement] = []
    for statement in statements:
        noun = statement.things.noun if isinstance(statement, Keep) else ""
        closer = sorted(other for other in gone if noun and other != noun and noun in other.split())
        if isinstance(statement, Keep) and closer:
            whole = Amount(kind="all", number=0)
            beside = (*statement.things.beside, *(Things(noun=n, amount=whole, plural=True) for n in closer))
            things = msgspec.structs.replace(statement.things, beside=beside)
            statement = msgspec.structs.replace(statement, things=things)
        out.append(statement)
    return out


def sets_as_one(statements: Sequence[Statement], lexicon: Lexicon) -> list[Statement]:
    """Return statements in which new ``crayons`` without a number are one set of them."""
    out: list[Statement] = []
    for statement in statements:
        things = statement.things if isinstance(statement, Add | Ensure) else Things()
        bare = things.plural and things.amount.kind == "some" and things.amount.number <= 1 and not things.definite
        if isinstance(statement, Add | Ensure) and bare and lexicon.is_set(tuple(things.noun.split())):
            one = msgspec.structs.replace(things, amount=Amount(number=1), plural=False)
            statement = msgspec.structs.replace(statement, things=one)
        out.append(statement)
    return out


def _is_in_it(statement: Statement, rooms: Rooms) -> bool:
    """Whether what goes, comes or stays is in a room named just before, or is told without a room."""
    if not isinstance(statement, Remove | Add | Keep):
        return False
    place = statement.place if isinstance(statement, Add) else statement.things.place
    where = None if place is None else place.rooms
    return where is None or where.same or where == rooms


_INSTEAD: Final = (("instead", "of"), ("rather", "than"), ("in", "exchange", "for"), ("in", "return", "for"))


def in_place_of(reader: ClauseReader, found: list[Statement], end: int) -> tuple[list[Statement], int]:
    """Return that something new comes for what is there: ``a round table instead of the desk``."""
    after = (tuple(word.text for word in reader.words[end : end + len(words)]) == words for words in _INSTEAD)
    joint = next((len(words) for words, said in zip(_INSTEAD, after, strict=True) if said), 0)
    old = reader.item(end + joint) if joint else None
    new = found[-1]
    if old is None or old.is_room or not isinstance(new, Add | Ensure):
        return found, end
    if old.phrase.refers == "last" and not old.phrase.noun.words:
        return _so_many_afterwards(found, old)  # "six chairs instead of four"
    named = old.things() if old.phrase.noun.words[-1:] != ("one",) else _kind_of(old.things(), new.things)
    things = named if new.place.rooms is None else with_place(named, Place(rooms=new.place.rooms))
    if new.place.anchor is not None or new.place.spot:
        gone = Remove(things=things, quote=new.quote)  # it comes elsewhere: "in front of the sofa"
        return [*found[:-1], gone, new], old.end
    return [*found[:-1], Replace(things=things, by=new.things, quote=new.quote)], old.end


def _so_many_afterwards(found: list[Statement], old: Item) -> tuple[list[Statement], int]:
    """Return that there are as many as were named, in the place of the old number if no other is told."""
    new = exactly(found[-1])
    place, _ = joined_places(old.places)
    if not isinstance(new, Ensure) or (old.places and new.place != Place()):
        return [*found[:-1], new], old.phrase.end
    placed = msgspec.structs.replace(new, place=place) if old.places else new
    return [*found[:-1], placed], old.end


def _kind_of(one: Things, named: Things) -> Things:
    """Return ``the rectangular one`` as one of the kind that was named before it."""
    return msgspec.structs.replace(one, noun=named.noun)


def so_many(statement: Add | Ensure, topic: Things) -> Statement:
    """Return that there are so many of what was told before: ``There are three; make it five``."""
    amount = statement.things.amount
    kind = amount.kind if amount.kind != "some" else "exactly"
    counted = Amount(kind=kind, number=amount.number)
    things = msgspec.structs.replace(topic, amount=counted, definite=False, plural=amount.number > 1, place=None)
    place = topic.place or statement.place
    if kind == "more":
        return Add(things=things, place=place, quote=statement.quote)
    return Ensure(things=things, place=place, quote=statement.quote)


def moved_on(last: Sequence[Move], statement: Move) -> list[Move] | None:
    """Return what several things, moved together, do that then go on to another place; None where other ones do.

    ``The doll and the two cars belong upstairs. Put all three on the shelf in the study`` moves all three there.
    """
    things = statement.things
    several = things.plural or things.amount.number > 1
    bare = things.refers == "last" and not things.noun and things.place is None and several
    whole = sum(max(1, move.things.amount.number) for move in last)
    counted = all(
        move.things.amount.kind == "some" and (move.things.amount.number or not move.things.plural) for move in last
    )
    if len(last) < 2 or not bare or (things.amount.number and not (counted and things.amount.number == whole)):
        return None
    place, rooms = statement.place, last[0].place.rooms
    if rooms is not None and (place.rooms is None or (place.rooms.same and not place.rooms.words)):
        place = msgspec.structs.replace(place, rooms=rooms)
    return [msgspec.structs.replace(move, place=place, or_new=False) for move in last]


def given_but_to(statement: Add | Ensure, spared: Sequence[Things]) -> Add | Ensure | None:
    """Return what each of several places is given, but for those excepted: ``on every table but the one in the bar``.

    None where the places are not all of a kind, or what is excepted is none of them.
    """
    place = statement.place
    anchor, rooms = place.anchor, place.rooms
    spared_rooms = [one.place.rooms for one in spared if not one.noun and one.place is not None and one.place.rooms]
    one = anchor is None or anchor.amount.kind == "some"  # "on the desk in every office except office 3"
    if one and rooms is not None and rooms.every and len(spared_rooms) == len(spared):
        but = tuple(msgspec.structs.replace(one, every=False) for one in spared_rooms)
        place = msgspec.structs.replace(place, rooms=msgspec.structs.replace(rooms, but=(*rooms.but, *but)))
        return msgspec.structs.replace(statement, place=place)
    if (
        anchor is None
        or anchor.amount.kind != "all"
        or not all(one.noun in ("", "one", anchor.noun, statement.things.noun) for one in spared)
    ):
        return None
    beside = tuple(msgspec.structs.replace(one, noun=anchor.noun, refers="") for one in spared)
    holders = msgspec.structs.replace(anchor, beside=(*anchor.beside, *beside))
    return msgspec.structs.replace(statement, place=msgspec.structs.replace(place, anchor=holders))


def placed_at_last(statements: Sequence[Statement], onward: Move) -> list[Add | Ensure]:
    """Return new things of the last clause at the place that the next one names; none where it moves other ones.

    ``Add three towels to the bathroom and lay them on the shelf`` brings them to the shelf of the bathroom.
    """
    last = statements[-1] if statements else None
    if not isinstance(last, Add | Ensure):
        return []
    together = [s for s in statements if isinstance(s, Add | Ensure) and s.quote == last.quote]
    things, goal = onward.things, onward.place
    several = len(together) > 1 or last.things.plural or last.things.amount.number > 1
    bare = things.refers == "last" and not things.noun and things.place is None and things.plural == several
    counted = things.amount.number in (0, sum(max(1, new.things.amount.number) for new in together))
    rooms = [new.place.rooms for new in together if not new.each and new.place == Place(rooms=new.place.rooms)]
    where = rooms[0] if rooms else None
    same = len(rooms) == len(together) and all(other == where for other in rooms)
    elsewhere = goal.rooms is not None and bool(goal.rooms.words) and where not in (None, goal.rooms)
    if not (bare and counted and same) or elsewhere or goal.outside or (goal.anchor is None and not goal.spot):
        return []
    if statements[-len(together) :] != together or (goal.anchor is not None and goal.anchor.refers):
        return []
    place = msgspec.structs.replace(goal, rooms=where or goal.rooms)
    return [msgspec.structs.replace(new, place=place) for new in together]


def counts_those_brought(statement: Statement, last: Statement) -> bool:
    """Whether a statement only says how many there shall be of what the one before brings without a number."""
    if not isinstance(statement, Ensure) or not isinstance(last, Add | Ensure):
        return False
    things, brought = statement.things, last.things
    bare = things.refers == "last" and not things.noun and things.place is None and things.amount.number > 0
    open_number = brought.plural and brought.amount.kind == "some" and not brought.amount.number
    return bare and open_number and statement.place in (Place(), last.place)


def counted_by(last: Add | Ensure, statement: Ensure, quote: str) -> Ensure:
    """Return what is brought with the number that shall be there: ``four at most`` are no more and no fewer."""
    amount = statement.things.amount
    amount = Amount(kind="exactly", number=amount.number) if amount.kind == "at_most" else amount
    things = msgspec.structs.replace(last.things, amount=amount)
    return Ensure(things=things, place=last.place, each=last.each, quote=quote)


def is_open(statement: Statement) -> bool:
    """Whether a statement names neither rooms nor storeys."""
    return '"type":"Rooms"' not in msgspec.json.encode(statement).decode()


_EITHER_SIDE: Final = re.compile(r"\b(?:on|to|at) (?:either|each|both) sides?\b|\bleft and right of\b", re.IGNORECASE)


def on_each_side(statement: Statement) -> list[Statement]:
    """Return ``a chair on either side of the desk`` as one to the left of it and one to the right."""
    if not isinstance(statement, Add | Ensure) or statement.place.relation != "around":
        return [statement]
    one = statement.things.amount.kind == "some" and statement.things.amount.number == 1
    if not one or not _EITHER_SIDE.search(statement.quote):
        return [statement]
    sides: tuple[Relation, ...] = ("left", "right")
    return [
        msgspec.structs.replace(statement, place=msgspec.structs.replace(statement.place, relation=side))
        for side in sides
    ]


_ONLY: Final = re.compile(r"(?:(?:so|and|but) )?(?:only|just)\b", re.IGNORECASE)


def only_so_many_stay(statements: Sequence[Statement]) -> list[Statement]:
    """Return ``only four should stay`` as the rest going, where nothing else in the instruction takes any away."""
    if any(isinstance(statement, Remove | Clear | Replace | Move | Ensure) for statement in statements):
        return list(statements)
    out: list[Statement] = []
    for statement in statements:
        kept = statement.things if isinstance(statement, Keep) and _ONLY.match(statement.quote) else None
        if kept is not None and kept.noun and kept.amount.kind == "some" and kept.amount.number:
            most = Amount(kind="at_most", number=kept.amount.number)
            things = msgspec.structs.replace(kept, amount=most, definite=True, plural=True)
            statement = Remove(things=things, quote=statement.quote)
        out.append(statement)
    return out


_SHARE: Final = re.compile(r"\bone (?:per|for (?:each|every)) ", re.IGNORECASE)


def sharing_as_told(statements: Sequence[Statement]) -> list[Statement]:
    """Return ``four cups on the table, one per chair`` as four cups: the share only tells how they are counted."""
    out: list[Statement] = []
    for statement in statements:
        last = out[-1] if out else None
        if isinstance(statement, Add | Ensure) and isinstance(last, Add | Ensure):
            same = last.quote == statement.quote and last.things.noun == statement.things.noun
            if same and statement.each and last.things.amount.number > 1 and _SHARE.search(statement.quote):
                continue
        out.append(statement)
    return out


def held_there(value: Any, holder: Things) -> Any:
    """Return a statement in which ``in there`` and ``on there`` mean a piece of furniture that was mentioned."""
    if isinstance(value, Place) and value.anchor is None and value.relation and not value.spot:
        return Place(relation=value.relation, anchor=holder)
    if not isinstance(value, msgspec.Struct):
        return tuple(held_there(part, holder) for part in value) if isinstance(value, tuple) else value
    changes = {f: held_there(getattr(value, f), holder) for f in value.__struct_fields__}
    return msgspec.structs.replace(value, **changes)


def with_storeys(statements: Sequence[Statement]) -> list[Statement]:
    """Return the statements with the storey that was named before in place of ``the same floor``."""
    last: list[tuple[int, ...]] = [()]

    def filled(value: Any) -> Any:
        if isinstance(value, Rooms) and value.floors == (SAME_FLOOR,):
            return msgspec.structs.replace(value, floors=last[0], same=value.same or not last[0])
        if isinstance(value, Rooms) and value.floors:
            last[0] = value.floors
        if isinstance(value, Place) and value.relation and value.anchor is None and not value.spot:
            value = msgspec.structs.replace(value, relation="")
        if not isinstance(value, msgspec.Struct):
            return tuple(filled(part) for part in value) if isinstance(value, tuple) else value
        return msgspec.structs.replace(value, **{f: filled(getattr(value, f)) for f in value.__struct_fields__})

    return [filled(statement) for statement in statements]


def with_noun_at(value: Any, noun: str, place: Place) -> Any:
    """Return a statement in which things or rooms of a noun are at a place."""
    if isinstance(value, Things) and value.noun == noun and value.place == place:
        return value
    if isinstance(value, Things):
        changed = _replaced(value, noun, place)
        if changed.noun == noun and (changed.place is None or changed.place.rooms is None):
            return with_place(changed, place)
        return changed
    if isinstance(value, Rooms):
        if value.words == noun and place.rooms is not None and not value.floors:
            return msgspec.structs.replace(
                value, floors=place.rooms.floors, next_to=place.rooms.next_to or value.next_to
            )
        return value
    if isinstance(value, Place):
        changed = _replaced(value, noun, place)
        if value.anchor is not None and value.anchor.noun == noun and value.rooms is None and place.rooms is not None:
            return msgspec.structs.replace(changed, rooms=place.rooms)
        return changed
    if isinstance(value, msgspec.Struct):
        return _replaced(value, noun, place)
    return value


def _replaced(value: Any, noun: str, place: Place) -> Any:
    changes = {}
    for name in value.__struct_fields__:
        old = getattr(value, name)
        new = (
            tuple(with_noun_at(part, noun, place) for part in old)
            if isinstance(old, tuple)
            else with_noun_at(old, noun, place)
        )
        if new != old:
            changes[name] = new
    return msgspec.structs.replace(value, **changes) if changes else value


def narrowed(statement: Statement, place: Place) -> Statement:
    """Return the last statement at a place that the next sentence tells of ("it is on the second floor")."""
    if isinstance(statement, Move) and _tells_where_it_is_now(statement, place):
        return msgspec.structs.replace(statement, things=with_place(statement.things, place))
    if isinstance(statement, Ensure | Move) or hasattr(statement, "place"):
        own = getattr(statement, "place", None)
        if isinstance(own, Place):
            return msgspec.structs.replace(statement, place=merged(own, place))
    things = getattr(statement, "things", None)
    if isinstance(things, Things):
        return msgspec.structs.replace(statement, things=with_place(things, place))
    return statement


def _tells_where_it_is_now(statement: Move, place: Place) -> bool:
    """Whether a place is another room than the one that a thing goes to: ``it is in the hall at the moment``."""
    things, goal = statement.things, statement.place.rooms
    told = place.rooms is not None and bool(place.rooms.words) and place == Place(rooms=place.rooms)
    elsewhere = goal is not None and bool(goal.words) and place.rooms is not None and goal.words != place.rooms.words
    return told and elsewhere and things.definite and not things.refers and things.place is None


def is_everything(things: Things) -> bool:
    """Whether words mean all that is at a place, of whatever kind."""
    return not things.noun and not things.refers and things.place is not None


def moves_it(statement: Move) -> bool:
    """Whether a statement moves only what was mentioned last."""
    return statement.things.refers == "last" and not statement.things.noun


def goes_while_others_stay(statement: Statement, last: Statement | None) -> Move | None:
    """Return ``one goes to the hall`` after ``two stay`` as one of three that are there; None for other words."""
    if not isinstance(statement, Move) or not isinstance(last, Ensure) or not _counts_bare(statement.things):
        return None
    staying = re.search(r"\b(stays?|remains?)\b", last.quote) and last.things.amount.kind == "exactly"
    if not staying or last.place == Place():
        return None
    number = statement.things.amount.number
    whole = Amount(number=number, of=number + last.things.amount.number)
    things = msgspec.structs.replace(last.things, amount=whole, plural=number > 1, place=last.place)
    return Move(things=things, place=statement.place, quote=statement.quote)


def goes_as_well(statement: Statement, last: Statement | None) -> bool:
    """Whether a further number goes somewhere else after some of those that are there went: ``one goes to the bar``."""
    counted = isinstance(last, Move) and last.things.amount.of > 0
    return isinstance(statement, Move) and counted and _counts_bare(statement.things)


def _counts_bare(things: Things) -> bool:
    """Whether words are only a number: ``one``, ``two``."""
    bare = things.refers == "last" and not things.noun and not things.definite and things.place is None
    return bare and things.amount.kind == "some" and things.amount.number > 0 and not things.amount.of


def is_only_fetched(last: Statement | None) -> TypeGuard[Move]:
    """Whether a statement only tells where something comes from: ``bring one of the cases up from the cellar``."""
    return isinstance(last, Move) and last.place == Place() and last.things.place is not None


def left_where_brought(statement: Keep, last: Statement | None) -> Move | None:
    """Return ``leave them in the lounge`` after what was only fetched as where it goes; None for what stays."""
    things = statement.things
    bare = things.refers == "last" and not things.noun and things.place is not None and not things.place.outside
    if not (is_only_fetched(last) and bare) or things.place is None:
        return None
    return Move(things=msgspec.structs.replace(things, place=None), place=things.place, quote=statement.quote)


def of_none(statement: Statement) -> Statement:
    """Return what is said of none as what it means: ``no beer remains in the fridge``, ``none of them are moved``."""
    if not isinstance(statement, Keep | Move) or statement.things.amount.kind != "none":
        return statement
    things, quote = statement.things, statement.quote
    if isinstance(statement, Keep):
        place = things.place
        return (
            statement
            if place is None
            else Ensure(things=msgspec.structs.replace(things, place=None), place=place, quote=quote)
        )
    where = things.place or (statement.place if statement.place != Place() else None)
    whole = Amount(kind="all", number=0)
    return Keep(things=msgspec.structs.replace(things, amount=whole, definite=True, place=where), quote=quote)


def one_more_there(statement: Statement, before: Sequence[Statement]) -> Statement:
    """Return one more of what was mentioned before, told without a place, as one in the room that was mentioned."""
    asked = any(not isinstance(other, Mention) for other in before)
    bare = isinstance(statement, Add) and statement.things.amount.kind == "more" and statement.place == Place()
    if not (asked and bare) or not re.search(r"\bone\b", statement.quote, re.IGNORECASE):
        return statement
    return msgspec.structs.replace(statement, place=Place(rooms=Rooms(same=True)))


def must_contain(reader: ClauseReader, at: int) -> bool:
    """Whether words without a subject tell what a room must have: ``must contain a piano``."""
    return reader.text(at) in ("must", "should", "shall") and reader.text(at + 1) in ("contain", "have", "include")


def only_brings_it(statement: Move) -> bool:
    """Whether a statement only says once more of what was asked for just before that it comes: ``add it``."""
    things = statement.things
    return moves_it(statement) and statement.place == Place() and things.place is None and not things.amount.number


def removes_all_of_it(statement: Statement) -> bool:
    """Whether a statement says of what is cleared only that all of it goes."""
    if not isinstance(statement, Remove):
        return False
    things = statement.things
    bare = not things.noun and not things.refers and things.place is None and not things.beside
    return bare and things.amount.kind == "all"


def adds_it(statement: Statement) -> bool:
    """Whether a statement only says once more of what was asked for just before that it comes: ``can you add one``."""
    if not isinstance(statement, Add | Ensure):
        return False
    things = statement.things
    bare = (things.refers == "last" and not things.noun) or things.noun == "one"
    return bare and things.amount.number <= 1 and not things.colour and statement.place.anchor is None


def removes_what_went(statement: Statement) -> bool:
    """Whether a statement only says once more of what was removed just before that it goes: ``take them off``."""
    if not isinstance(statement, Remove):
        return False
    things = statement.things
    bare = things.refers == "last" and not things.noun and things.place is None and not things.beside
    return bare and not things.amount.number


def spared_of(statement: Statement) -> tuple[Things, ...]:
    """Return what stays of what is cleared just before: ``keep the lamp on it``."""
    if isinstance(statement, Keep) and (statement.things.place is None or _is_of_it(statement.things.place)):
        return (msgspec.structs.replace(statement.things, place=None),)
    if isinstance(statement, Ensure) and tells_who_may_stay(statement):
        return (statement.things,)
    return ()


def _is_of_it(place: Place) -> bool:
    anchor = place.anchor
    return place.rooms is None and anchor is not None and anchor.refers == "last" and not anchor.noun
