"""Objects normalised into groups: an anchor and members in its frame (supplement G, input of Algorithm 4)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.placement import MatrixStructure, PairedStructure, PlacementObject, PlacementRoom, RelationKind
from mansion_scene.placement.roles import Role, role_of

__all__ = ["Group", "Link", "Manner", "Spec", "make_groups"]

Manner: TypeAlias = Literal[RelationKind, "at_head", "opposite", "in_run", "sat_at", "towards"]
"""A relation as the two objects mean it: beside a bed is at its head, a seat around a table faces it."""

Link: TypeAlias = Literal["paired", "around", "in_front_of", "side_of", "near", "center_aligned"]

_LINKS: tuple[Link, ...] = ("around", "in_front_of", "side_of", "near", "center_aligned")
"""Relations that bind a member to an anchor, the strongest first."""


@dataclass(frozen=True)
class Spec:
    """One object of the request with its references resolved.

    Attributes
    ----------
    index : int
        Position in the request.
    rows, cols : int
        Matrix size, 0 where it is none.
    host : int
        Index of the object whose frame it is placed in, -1 for an anchor.
    link : Link or None
        The relation that binds it to its host.
    relations : tuple of (manner, index)
        All relations to other objects, "paired" not among them.
    first : bool
        Whether it is placed before what is not.
    """

    index: int
    name: str
    size: tuple[float, float, float]
    smaller: tuple[tuple[float, float, float], ...]
    quantity: int
    where: str
    rows: int
    cols: int
    host: int
    link: Link | None
    relations: tuple[tuple[Manner, int], ...]
    role: Role
    first: bool = False

    @property
    def area(self) -> float:
        """Footprint of all copies, square metres."""
        return self.size[0] * self.size[1] * self.quantity

    @property
    def front_needed(self) -> bool:
        """Whether its front must be approachable (not for small round objects, seats, beds and worktops in corners)."""
        if self.role.seat or self.role.bed or self.role.symmetric or self.role.fitment == "worktop":
            return False
        return self.where == "edge" or self.rows > 0


@dataclass(frozen=True)
class Group:
    """An anchor and its members, hosts before what they host."""

    anchor: Spec
    members: tuple[Spec, ...] = ()

    @property
    def priority(self) -> int:
        """0 edge+matrix, 1 edge, 2 matrix, 3 middle, 4 free (Algorithm 4, line 1); below 0 for what comes first."""
        if any(spec.first for spec in (self.anchor, *self.members)):
            return self._kind - 10
        return self._kind

    @property
    def _kind(self) -> int:
        if self.anchor.rows:
            # Tills need the place by the way out before the rows that take the rest of the floor.
            if self.anchor.where == "edge" or self.anchor.role.entrance:
                return 0
            return 1 if self._tables or self.anchor.role.driven_between else 2
        if self._dining_table:
            return 1  # it and its chairs need a place of their own before cupboards take it
        return {"edge": 1, "middle": 3}.get(self.anchor.where, 4)

    @property
    def _dining_table(self) -> bool:
        return self._tables and self.anchor.quantity == 1

    @property
    def _tables(self) -> bool:
        """Whether people sit around it, so that it needs its place before cupboards line the walls."""
        return self.anchor.role.table and any(m.link == "around" and m.role.seat for m in self.members)

    @property
    def area(self) -> float:
        """Footprint of the whole group, square metres."""
        return self.anchor.area + sum(member.area for member in self.members)


def make_groups(room: PlacementRoom) -> tuple[list[Spec], list[Group]]:
    """Normalise the objects of a room into groups, in priority order, larger groups first.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a repeated name, an unknown target, or a quantity other than rows x cols.
    """
    index = _index(room.objects)
    hosts = _hosts(room.objects, index)
    roles = [role_of(obj.name, obj.category) for obj in room.objects]
    specs = [_spec(i, obj, index, hosts, roles) for i, obj in enumerate(room.objects)]
    members: dict[int, list[Spec]] = {spec.index: [] for spec in specs if spec.host < 0}
    # Hosts are joined before what they host; `_hosts` leaves no cycle, so every round joins some.
    pending = [spec for spec in specs if spec.host >= 0]
    root = {i: i for i in members}
    while pending:
        later = []
        for spec in pending:
            if spec.host in root:
                root[spec.index] = root[spec.host]
                members[root[spec.host]].append(spec)
            else:
                later.append(spec)
        pending = later
    order = {link: rank for rank, link in enumerate(("paired", *_LINKS))}
    depth = dict.fromkeys(members, 0)
    for own in members.values():
        for member in own:
            depth[member.index] = depth[member.host] + 1

    def rank(member: Spec) -> tuple[int, int, bool, float, int]:
        return depth[member.index], order[member.link or "near"], member.where != "edge", -member.area, member.index

    groups = [Group(specs[i], tuple(sorted(own, key=rank))) for i, own in members.items()]
    ranked = sorted(groups, key=lambda g: (g.priority, -g.area, g.anchor.index))
    return specs, ranked


def _index(objects: list[PlacementObject]) -> dict[str, int]:
    index: dict[str, int] = {}
    for i, obj in enumerate(objects):
        if obj.name in index:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"object name {obj.name!r} occurs twice; names must be unique in a room",
                path=f"$.objects[{i}].name",
            )
        index[obj.name] = i
    for i, obj in enumerate(objects):
        targets = [(f"relative[{j}].target", r.target) for j, r in enumerate(obj.relative)]
        if isinstance(obj.structure, PairedStructure):
            targets.append(("structure.with", obj.structure.with_))
        for place, target in targets:
            if target not in index or target == obj.name:
                raise MansionError(
                    ErrorCode.INVALID_PAYLOAD,
                    f"{obj.name!r} refers to {target!r}; the name of another object of the room is needed",
                    path=f"$.objects[{i}].{place}",
                )
    return index


def _hosts(objects: list[PlacementObject], index: dict[str, int]) -> dict[int, tuple[int, Link]]:
    """Return each member's host and link; a link that would close a cycle stays a relation only."""
    hosts: dict[int, tuple[int, Link]] = {}

    def closes_circle(i: int, host: int) -> bool:
        while host != i and host in hosts:
            host = hosts[host][0]
        return host == i

    for i, obj in enumerate(objects):
        if isinstance(obj.structure, PairedStructure):
            host = index[obj.structure.with_]
            if not closes_circle(i, host):
                hosts[i] = (host, "paired")
    for link in _LINKS:
        for i, obj in enumerate(objects):
            if i in hosts or isinstance(obj.structure, MatrixStructure):
                continue
            for relation in obj.relative:
                host = index[relation.target]
                if relation.kind == link and not closes_circle(i, host):
                    hosts[i] = (host, link)
                    break
    return hosts


def _manner(kind: RelationKind, own: Role, target: Role) -> Manner:
    """Return how a relation is meant between objects of two roles."""
    if own.bedside and target.bed and kind == "side_of":
        return "at_head"
    if own.screen and target.sofa and kind == "center_aligned":
        return "opposite"
    if own.fitment and target.fitment and kind in ("side_of", "near"):
        return "in_run"
    if own.seat and kind in ("around", "near"):
        return "sat_at" if kind == "around" else "towards"
    return kind


def _spec(
    i: int, obj: PlacementObject, index: dict[str, int], hosts: dict[int, tuple[int, Link]], roles: Sequence[Role]
) -> Spec:
    rows = cols = 0
    quantity = obj.quantity
    if isinstance(obj.structure, MatrixStructure):
        rows, cols = obj.structure.rows, obj.structure.cols
        if quantity not in (1, rows * cols):
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"{obj.name!r}: a matrix of {rows} x {cols} has quantity {rows * cols}, not {quantity}",
                path=f"$.objects[{i}].quantity",
            )
        quantity = rows * cols
    host, link = hosts.get(i, (-1, None))
    return Spec(
        index=i,
        name=obj.name,
        size=obj.size,
        smaller=tuple(obj.smaller),
        quantity=quantity,
        where=obj.global_,
        rows=rows,
        cols=cols,
        host=host,
        link=link,
        relations=tuple((_manner(r.kind, roles[i], roles[index[r.target]]), index[r.target]) for r in obj.relative),
        role=roles[i],
        first=obj.first,
    )
