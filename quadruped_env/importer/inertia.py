"""Masses and inertia that no body can have, and what takes their place."""

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.importer.description import Description, Link, named, poses
from quadruped_env.importer.shapes import bounds
from quadruped_env.utils.arrays import Floats

_DENSITY = 1000.0
"""Density of the cube that takes the place of a link without shapes, kg/m^3."""
_SLACK = 1e-6
"""Relative error of the triangle inequality that rounding in a file causes."""
_POINT = 1e-12
"""Inertia per mass below which a link counts as a point, m^2."""
_ROUNDING = 1e-3
"""Negative eigenvalue, relative to the largest, that rounding in a file causes."""


def repair(described: Description) -> None:
    """Replace inertia that no link of the robot can have by a box's; changes the links.

    Raises:
        QuadrupedError: if a link's inertia has a negative eigenvalue, which no rounding explains.
    """
    repaired: dict[str, list[str]] = {}
    places, _ = poses(described.links)
    size = float(np.linalg.norm(np.ptp(places, axis=0))) if len(places) else 0.0
    for link in described.links:
        if link.mass == 0.0:
            link.inertia = np.zeros((3, 3))
            continue
        moments = np.linalg.eigvalsh(link.inertia)
        if np.abs(moments).max() < _POINT * link.mass:
            link.inertia = np.diag(_box_inertia(link))
            repaired.setdefault("zero", []).append(link.name)
        elif moments[0] < -_ROUNDING * max(abs(moments)):
            xx, yy, zz = _box_inertia(link)
            raise QuadrupedError(
                f"the inertia of {link.name!r} has the eigenvalue {moments[0]:.3g}, which is "
                f"negative; correct it, or take a box of its mass: ixx {xx:.3g}, iyy {yy:.3g}, izz {zz:.3g}, others 0"
            )
        elif 2.0 * moments[2] > moments.sum() * (1.0 + _SLACK) or moments[0] <= 0.0:
            link.inertia = np.diag(_box_inertia(link))
            repaired.setdefault("against the triangle inequality", []).append(link.name)
        elif moments[2] > link.mass * size**2:
            link.inertia = np.diag(_box_inertia(link))
            repaired.setdefault("larger than that of a link of the robot's size", []).append(link.name)
    for cause, names in repaired.items():
        described.add("repaired", "inertia", f"{named(names)}: {cause}; now a box of the link's size and mass")


def _box_inertia(link: Link) -> Floats:
    """Return the moments of inertia (3,) of a box of the link's size and mass."""
    shapes = [shape for shape in link.shapes if shape.collides] or link.shapes
    if shapes:
        low, high = bounds(shapes)
        size = np.maximum(high - low, 1e-3)
    else:
        size = np.full(3, (link.mass / _DENSITY) ** (1.0 / 3.0))
    square = size**2
    return link.mass / 12.0 * (square.sum() - square)
