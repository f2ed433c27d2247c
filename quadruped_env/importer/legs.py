"""Base, legs, corners, feet and knees of a robot: from the tree and the geometry of its links, never from names."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.importer.description import FIXED, HINGE, Description, Joint, about, named, poses
from quadruped_env.importer.shapes import end_ball, moved
from quadruped_env.robot.robot import CORNERS
from quadruped_env.utils.arrays import Floats

SUPPORTED: Final = (
    "supported are four legs of two joints (pitch, pitch) or three (roll, pitch, pitch or pitch, roll, pitch)"
)
_PARALLEL: Final = 0.95
"""Smallest cosine of axes that count as parallel."""
_CROSSED: Final = 0.3
"""Largest cosine of axes that count as perpendicular."""
_ALIKE: Final = 0.03
"""Difference of feet that were fitted to shapes, relative to the shank, up to which they are meant to be the same."""
_SNAP: Final = 0.98
"""Cosine of a base's axis and a direction of the robot from which on they are the same."""


@dataclass(frozen=True)
class Leg:
    """A leg in the frame of the base (x forward, y left, z up), with its joints at 0."""

    corner: str
    links: tuple[int, ...]
    """Indices of the links that its joints move, from the base to the foot."""
    axes: Floats
    """Axes (n, 3) of the joints."""
    anchors: Floats
    """Points (n, 3) on the axes, m."""
    foot: Floats
    """Centre (3,) of the foot's ball, m."""
    foot_in_link: Floats
    """The same in the frame of the last link."""
    joints: tuple[Joint, ...]
    kinds: tuple[str, ...]
    """`roll` or `pitch`, of each joint."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the joints."""
        return tuple(joint.name for joint in self.joints)

    def moved(self, positions: Sequence[float]) -> tuple[Floats, Floats, Floats]:
        """Return axes (n, 3), anchors (n, 3) and the foot's centre (3,) at joint positions (n,) in rad."""
        axes, anchors, foot = self.axes.copy(), self.anchors.copy(), self.foot.copy()
        for i in reversed(range(len(positions))):
            turn, pivot = about(self.axes[i], float(positions[i])), self.anchors[i]
            axes[i:] = axes[i:] @ turn.T
            anchors[i:] = pivot + (anchors[i:] - pivot) @ turn.T
            foot = pivot + turn @ (foot - pivot)
        return axes, anchors, foot


@dataclass(frozen=True)
class Anatomy:
    """What a robot's legs are."""

    base: int
    """Index of the link that carries the legs."""
    legs: tuple[Leg, ...]
    """One for each of `CORNERS`."""
    frame: Floats
    """Rotation (3, 3) from the robot's axes, forward, left and up, to the base link's."""
    foot_radius: float
    locked: tuple[str, ...]
    """Joints that are no part of a leg."""

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds of the joints of each leg."""
        return self.legs[0].kinds


def find_legs(described: Description, forward: str | None) -> Anatomy:
    """Find the legs, and fix every joint that is no part of one, in place.

    Args:
        described: content of a file; its joints of legs stay.
        forward: axis of the base link along which the robot walks, such as `-y`; None takes the convention.

    Raises:
        QuadrupedError: if it is no robot with four legs of two or three joints.
    """
    tree = _Tree(described)
    base, chains = _four_chains(tree)
    kinds = _kinds(tree, base, chains)
    if described.links[base].parent >= 0:
        above = [
            link.joint.name for i, link in enumerate(tree.links) if link.joint.kind != FIXED and tree.is_below(base, i)
        ]
        described.add("left out", "base", f"{named(above)}: joints above it; the robot floats by itself")
    locked = tree.lock(base, {link for chain in chains for link in chain})
    if locked:
        described.add("left out", "joints", f"{named(locked)}: no part of a leg; locked at 0, or at the nearest limit")
    return _Geometry(tree, base, chains, kinds).anatomy(forward, tuple(locked))


class _Tree:
    """Links that move together, by the index of the first of them."""

    def __init__(self, described: Description) -> None:
        self.described, self.links = described, described.links
        self.top: list[int] = []
        self.below: dict[int, list[int]] = {}
        for i, link in enumerate(self.links):
            alone = link.parent < 0 or link.joint.kind != FIXED
            self.top.append(i if alone else self.top[link.parent])
            if alone:
                self.below[i] = []
                if link.parent >= 0:
                    self.below[self.top[link.parent]].append(i)
        self.depth, self.mass = dict.fromkeys(self.below, 0), dict.fromkeys(self.below, 0.0)
        for i in reversed(range(len(self.links))):
            self.mass[self.top[i]] += self.links[i].mass
            if i in self.below:
                self.depth[i] = 1 + max((self.depth[child] for child in self.below[i]), default=0)
                if self.links[i].parent >= 0:
                    self.mass[self.top[self.links[i].parent]] += self.mass[i]

    def chain(self, first: int) -> tuple[int, ...]:
        """Return the first links of the groups down to the end of the chain with the most joints."""
        chain = [first]
        while self.below[chain[-1]]:
            chain.append(max(self.below[chain[-1]], key=lambda child: (self.depth[child], self.mass[child])))
        return tuple(chain)

    def name(self, link: int) -> str:
        return self.links[link].joint.name

    def lock(self, base: int, moving: set[int]) -> list[str]:
        """Fix all other joints at 0, or at the nearest limit; return the names of those below the base."""
        locked = []
        for i, link in enumerate(self.links):
            joint = link.joint
            if i in moving or i == base or joint.kind == FIXED or link.parent < 0:
                continue
            at = float(np.clip(0.0, joint.low, joint.high))
            if joint.kind == HINGE:
                link.rotation = link.rotation @ about(joint.axis, at)
            elif joint.kind == "slide":
                link.position = link.position + link.rotation @ joint.axis * at
            joint.kind = FIXED
            if self.is_below(i, base):
                locked.append(joint.name)
        return locked

    def is_below(self, link: int, other: int) -> bool:
        """Return True for a link of the tree below another one."""
        while link >= 0 and link != other:
            link = self.links[link].parent
        return link == other


def _four_chains(tree: _Tree) -> tuple[int, list[tuple[int, ...]]]:
    """Return the link that carries four chains of as many joints, and these."""
    total = max((tree.mass[i] for i, link in enumerate(tree.links) if link.parent < 0), default=0.0)
    carriers = [g for g, below in tree.below.items() if sum(tree.depth[child] > 1 for child in below) >= 4]
    carriers = [g for g in carriers if tree.mass[g] >= 0.5 * total]  # a hand has fingers, too
    if not carriers:
        forks = [(len(below) > 1, tree.mass[g], g) for g, below in tree.below.items() if below]
        what = "no joints"
        if forks:
            fork = max(forks)[-1]
            depths = ", ".join(str(tree.depth[child]) for child in tree.below[fork])
            what = f"{tree.links[fork].name!r} with chains of {depths} joints"
        raise QuadrupedError(f"no link carries four chains of two or more joints; found {what}; {SUPPORTED}")
    base = max(carriers, key=lambda g: (tree.mass[g], g))
    chains = [tree.chain(child) for child in tree.below[base] if tree.depth[child] > 1]
    counts = [len(chain) for chain in chains]
    counted = ", ".join(map(str, counts))
    where = f"{tree.links[base].name!r} carries {len(chains)} chains, of {counted} joints"
    if counts.count(2) == 8:
        raise QuadrupedError(f"{where}: pairs, as of five-bar legs, which are closed chains; {SUPPORTED}")
    of = next((n for n in (3, 2) if counts.count(n) >= 4), None) or max(
        set(counts), key=lambda n: (counts.count(n), -n)
    )
    legs = [chain for chain in chains if len(chain) == of]
    if len(legs) < 4:
        raise QuadrupedError(f"{where}; {SUPPORTED}")
    if of not in (2, 3):
        last = tree.name(legs[0][-1])
        raise QuadrupedError(f"{where}: a wheel, an ankle or a passive joint ({last!r}) makes {of} a leg; {SUPPORTED}")
    if len(legs) > 4:
        legs = _most_alike(tree, legs, where)
    _check_serial(tree, legs)
    return base, legs


def _most_alike(tree: _Tree, chains: list[tuple[int, ...]], where: str) -> list[tuple[int, ...]]:
    """Return the four chains of more whose segments are most alike."""
    lengths = np.array([[np.linalg.norm(tree.links[link].position) for link in chain[1:]] for chain in chains])
    spreads = {
        four: float(np.ptp(lengths[list(four)], axis=0).sum()) for four in itertools.combinations(range(len(chains)), 4)
    }
    best = min(spreads, key=spreads.__getitem__)
    others = [i for i in range(len(chains)) if i not in best]
    near = 0.02 * lengths.sum(axis=1).mean()
    if any(np.abs(lengths[i] - lengths[list(best)].mean(axis=0)).sum() < near + spreads[best] for i in others):
        raise QuadrupedError(f"{where}, and {len(chains)} of these are alike; {SUPPORTED}")
    return [chains[i] for i in best]


def _check_serial(tree: _Tree, chains: list[tuple[int, ...]]) -> None:
    """Refuse legs with slides, with joints that follow others, and with closed chains."""
    in_leg = {link for chain in chains for link in chain}
    for link in sorted(in_leg):
        joint = tree.links[link].joint
        if joint.kind != HINGE:
            raise QuadrupedError(f"{joint.name!r} in a leg is a {joint.kind} joint; its joints must be hinges")
        if joint.coupled_to:
            raise QuadrupedError(
                f"the leg's joint {joint.name!r} follows {joint.coupled_to!r}; supported are legs whose "
                f"joints move independently, so model the transmission as joints with motors of their own"
            )
    index = {link.name: i for i, link in enumerate(tree.links)}
    for pair in tree.described.loops:
        if any(tree.top[index[name]] in in_leg for name in pair if name in index):
            raise QuadrupedError(f"{pair[0]!r} and {pair[1]!r} close a chain in a leg; {SUPPORTED}")


def _kinds(tree: _Tree, base: int, chains: list[tuple[int, ...]]) -> tuple[str, ...]:
    """Return `roll` or `pitch` of the joints of all legs, by angles between their axes that no joint changes."""
    _, rotations = poses(tree.links)
    axes = np.array([[rotations[link] @ tree.links[link].joint.axis for link in chain] for chain in chains])
    cosines = np.abs(np.einsum("lni,lni->ln", axes[:, :-1], axes[:, 1:]))
    first = np.abs(axes[:, 0] @ axes[:, 0].T).min()
    forms = {
        ("pitch", "pitch"): [1],
        ("roll", "pitch", "pitch"): [0, 1],
        ("pitch", "roll", "pitch"): [0, 0],
    }
    for kinds, parallel in forms.items():
        fits = len(kinds) == len(chains[0]) and all(
            (cosines[:, i] > _PARALLEL).all() if same else (cosines[:, i] < _CROSSED).all()
            for i, same in enumerate(parallel)
        )
        if fits and first > _PARALLEL:
            return kinds
    found = "; ".join(
        f"{named([tree.name(link) for link in chain])}: {np.round(axes[i], 2).tolist()}"
        for i, chain in enumerate(chains[:2])
    )
    raise QuadrupedError(f"the axes of the legs' joints are {found}; {SUPPORTED}")


class _Geometry:
    """Geometry of four legs in the frame of the base link, with the joints at 0."""

    def __init__(self, tree: _Tree, base: int, chains: list[tuple[int, ...]], kinds: tuple[str, ...]) -> None:
        self.tree, self.base, self.chains, self.kinds = tree, base, chains, kinds
        self.links = tree.links
        places, rotations = poses(tree.links)
        own = rotations[base].T
        self.places, self.rotations = (places - places[base]) @ own.T, own @ rotations
        self.anchors = self.places[np.array(chains)]
        self.axes = np.array(
            [[self.rotations[link] @ self.links[link].joint.axis for link in chain] for chain in chains]
        )

    def anatomy(self, forward: str | None, locked: tuple[str, ...]) -> Anatomy:
        feet, radii, fitted = self._feet()
        frame = self._frame(feet, forward)
        anchors, axes, feet = self.anchors @ frame, self.axes @ frame, feet @ frame
        if fitted:
            feet = _mirrored(anchors, feet)
        in_links = [
            (foot @ frame.T - self.places[chain[-1]]) @ self.rotations[chain[-1]]
            for chain, foot in zip(self.chains, feet, strict=True)
        ]
        hips = anchors[:, 0] - 0.5 * (anchors[:, 0].min(axis=0) + anchors[:, 0].max(axis=0))
        if np.abs(hips[:, 1]).min() < 0.05 * np.ptp(hips[:, 0]):  # first axes near the middle, as of some roll joints
            hips = anchors[:, 1] - 0.5 * (anchors[:, 1].min(axis=0) + anchors[:, 1].max(axis=0))
        corners = [2 * int(x <= 0.0) + int(y <= 0.0) for x, y, _ in hips]
        if sorted(corners) != [0, 1, 2, 3]:
            found = ", ".join(
                f"{self.tree.name(chain[0])} {CORNERS[c]}" for chain, c in zip(self.chains, corners, strict=True)
            )
            raise QuadrupedError(f"expected a leg in each corner; found {found}")
        legs = [
            Leg(
                CORNERS[c],
                self.chains[i],
                axes[i],
                anchors[i],
                feet[i],
                in_links[i],
                tuple(self.links[j].joint for j in self.chains[i]),
                self.kinds,
            )
            for i, c in sorted(enumerate(corners), key=lambda entry: entry[1])
        ]
        return Anatomy(self.base, tuple(legs), frame, float(np.median(radii)), locked)

    def _feet(self) -> tuple[Floats, Floats, bool]:
        """Return centres (4, 3) and radii (4,) of the feet's balls, and whether one of them is not in the file."""
        feet, radii, fitted, notes = [], [], False, set()
        for chain in self.chains:
            last = chain[-1]
            centre, radius, given, note = self._foot(last)
            fitted |= not given
            notes.add(note)
            feet.append(self.places[last] + self.rotations[last] @ centre)
            radii.append(radius)
        described = self.tree.described
        if fitted:
            text = f"balls of radius {np.median(radii):.3g} m, fitted to {named(sorted(notes))}"
            described.add("assumed", "feet", text)
        return np.array(feet), np.array(radii), fitted

    def _foot(self, last: int) -> tuple[Floats, float, bool, str]:
        """Return centre (3,) and radius of a foot in the last link, whether it is a ball, and where they come from."""
        group = [i for i, top in enumerate(self.tree.top) if top == last]
        turn = self.rotations[last].T
        for collides, note in ((True, "the end of the collision shapes"), (False, "the end of the visual shapes")):
            shapes = [
                moved(shape, turn @ (self.places[i] - self.places[last]), turn @ self.rotations[i])
                for i in group
                for shape in self.links[i].shapes
                if shape.collides == collides
            ]
            if shapes and max(np.abs(shape.points).max() for shape in shapes) > 1e-6:
                return *end_ball(shapes, self.links[last].joint.axis), note
        ends = [turn @ (self.places[i] - self.places[last]) for i in group]
        end = max(ends, key=lambda point: float(np.linalg.norm(point)))
        note = "the last frame of the leg, as its shapes are missing"
        if np.linalg.norm(end) < 1e-6:
            end, note = 2.0 * self.links[last].centre, "twice the distance of the last link's centre of mass"
        return end, 0.06 * float(np.linalg.norm(end)), False, note

    def _frame(self, feet: Floats, forward: str | None) -> Floats:
        """Return the robot's forward, left and up as columns, in the base link's frame."""
        main = np.linalg.eigh(np.einsum("li,lj->ij", self.axes[:, 0], self.axes[:, 0]))[1][:, -1]
        hips = self.anchors[:, 0] - self.anchors[:, 0].mean(axis=0)
        scale = float(np.linalg.norm(feet - self.anchors[:, -1], axis=1).mean())
        if np.linalg.svd(hips)[1][1] < 0.02 * scale:  # in one line
            hips = self.anchors[:, 1] - self.anchors[:, 1].mean(axis=0)
        normal = np.linalg.svd(hips)[2][-1]
        if abs(normal @ main) > 0.7:
            first = named([self.tree.name(chain[0]) for chain in self.chains])
            raise QuadrupedError(f"{first} turn about the vertical (yaw hips); {SUPPORTED}")
        across = hips - np.outer(hips @ main, main)
        second = np.linalg.svd(across)[2][0]
        ahead = main if self.kinds[0] == "roll" else second
        up = np.cross(main, second)
        snapped = [self._snapped(direction) for direction in (ahead, up)]
        if all(np.abs(direction).max() == 1.0 for direction in snapped) and snapped[0] @ snapped[1] == 0.0:
            ahead, up = snapped
        up = up * self._up_sign(up, feet, scale)
        ahead = ahead * self._forward_sign(ahead, forward)
        return np.stack([ahead, np.cross(up, ahead), up], axis=1)

    @staticmethod
    def _snapped(direction: Floats) -> Floats:
        nearest = np.zeros(3)
        k = int(np.abs(direction).argmax())
        nearest[k] = np.sign(direction[k])
        return nearest if abs(direction[k]) > _SNAP else direction

    def _up_sign(self, up: Floats, feet: Floats, scale: float) -> float:
        """Return the sign with which a vertical direction points away from the feet, or along the base's z axis."""
        below = float(((self.anchors[:, 0] - feet) @ up).mean())
        upright = up[2] if abs(up[2]) > _SNAP else 0.0
        return float(np.sign(below if abs(below) > 0.5 * scale or not upright else upright) or 1.0)

    def _forward_sign(self, ahead: Floats, forward: str | None) -> float:
        """Return the sign of a direction along which the robot walks: as given, or by convention."""
        axis = int(np.abs(ahead).argmax())
        sign = float(np.sign(ahead[axis]))
        name = "xyz"[axis]
        if forward is not None:
            if forward.lstrip("+-") != name:
                raise QuadrupedError(f"--forward: expected {name} or -{name}, along the body; found {forward}")
            return -sign if forward.startswith("-") else sign
        text = f"{name} of {self.links[self.base].name!r}, along the body; the sign is a convention: or --forward"
        self.tree.described.add("assumed", "forward", f"{text} -{name}")
        return sign


def _mirrored(anchors: Floats, feet: Floats) -> Floats:
    """Return feet (4, 3) that were fitted to shapes, made alike where legs are: meshes of left and right differ."""
    side = np.where(anchors[:, -1:, 1] > 0.0, 1.0, -1.0) * [[0.0, 1.0, 0.0]] + [[1.0, 0.0, 1.0]]
    shanks = (feet - anchors[:, -1]) * side
    if np.ptp(shanks, axis=0).max() > _ALIKE * np.linalg.norm(shanks, axis=1).mean():
        return feet
    return anchors[:, -1] + shanks.mean(axis=0) * side
