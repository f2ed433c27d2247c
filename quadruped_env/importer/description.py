"""A robot as a file describes it: a tree of links with joints, inertia and shapes, in SI units."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from quadruped_env.errors import escaped
from quadruped_env.utils.arrays import Floats

FIXED: Final = "fixed"
HINGE: Final = "hinge"
LARGEST: Final = 1e9
"""Largest number in a description: far beyond any robot's."""
MAX_NAMES: Final = 4
"""Names that a finding lists; of more it says how many there are."""


@dataclass(frozen=True)
class Finding:
    """Something that the importer found in a file, assumed or changed, for the table that it prints."""

    status: str
    """`found`, `assumed`, `repaired` or `left out`."""
    subject: str
    text: str
    """The number, the default and its reason."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "text", escaped(self.text))


@dataclass
class Shape:
    """Convex hull of balls of one radius, in the frame of a link."""

    points: Floats
    """Centres of the balls (P, 3), m."""
    radius: float
    """Radius of the balls, m; 0 for a box, a cylinder and a mesh."""
    volume: float
    """Volume, m^3."""
    collides: bool = True


@dataclass
class Joint:
    """Joint at the origin of a link's frame, with the numbers that the file gives; None where it gives none."""

    name: str
    kind: str
    """`hinge`, `slide`, `ball`, `free` or `fixed`."""
    axis: Floats
    """Unit vector (3,) in the frame of the link."""
    low: float = -math.inf
    """Lower limit, rad; infinite, as the upper one, where the file gives no limits."""
    high: float = math.inf
    """Upper limit, rad."""
    effort: float | None = None
    """Maximum torque, N m."""
    speed: float | None = None
    """Maximum speed, rad/s."""
    armature: float = 0.0
    """Rotor inertia at the joint, kg m^2."""
    coupled_to: str = ""
    """Joint whose position this one follows, by a mimic or an equality."""


@dataclass
class Link:
    """Rigid body, in its own frame; its pose is relative to the parent's frame, with its joint at 0."""

    name: str
    parent: int
    """Index of the parent, which comes before its children; -1 for a root."""
    position: Floats
    rotation: Floats
    joint: Joint
    mass: float = 0.0
    """Mass, kg."""
    centre: Floats = field(default_factory=lambda: np.zeros(3))
    """Centre of mass (3,), m."""
    inertia: Floats = field(default_factory=lambda: np.zeros((3, 3)))
    """Inertia about the centre of mass (3, 3), kg m^2."""
    shapes: list[Shape] = field(default_factory=list)


@dataclass
class Description:
    """Content of a robot's file."""

    name: str
    links: list[Link]
    findings: list[Finding]
    home: dict[str, float] | None = None
    """Joint positions of the file's home keyframe, rad."""
    loops: list[tuple[str, str]] = field(default_factory=list)
    """Pairs of links that close a chain."""

    def add(self, status: str, subject: str, text: str) -> None:
        """Add a finding."""
        self.findings.append(Finding(status, subject, text))

    def add_missing(self, problems: list[str]) -> None:
        """Add a finding for meshes that are not read, of which the first problem is quoted."""
        count = "1 mesh is" if len(problems) == 1 else f"{len(problems)} meshes are"
        self.add("left out", "collision", f"{count} not read: {problems[0]}; only the other shapes are used")

    def meshes_not_read(self) -> str:
        """Return the end of an error that missing meshes may have caused; nothing if none is missing."""
        texts = [finding.text for finding in self.findings if finding.subject == "collision"]
        return f" ({texts[0]})" if texts else ""


def poses(links: Sequence[Link]) -> tuple[Floats, Floats]:
    """Return positions (L, 3) and rotations (L, 3, 3) of all links in their root, with the joints at 0."""
    places, rotations = np.zeros((len(links), 3)), np.tile(np.eye(3), (len(links), 1, 1))
    for i, link in enumerate(links):
        places[i], rotations[i] = link.position, link.rotation
        if link.parent >= 0:
            places[i] = places[link.parent] + rotations[link.parent] @ link.position
            rotations[i] = rotations[link.parent] @ link.rotation
    return places, rotations


def named(names: list[str]) -> str:
    """Return names for a finding: all of a few, or the first of many and their number."""
    shown = ", ".join(names[:MAX_NAMES])
    return shown if len(names) <= MAX_NAMES else f"{shown} and {len(names) - MAX_NAMES} more"


def about(axis: Floats, angle: float) -> Floats:
    """Return the rotation (3, 3) about a unit vector by an angle in rad."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
