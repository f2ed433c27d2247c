"""Bodies of the robot as it is written: the base in the robot's own axes, and one for each joint of a leg."""

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.importer.description import Description, Joint, Link, named, poses
from quadruped_env.importer.legs import Anatomy
from quadruped_env.importer.shapes import moved
from quadruped_env.importer.stance import Stance
from quadruped_env.utils.arrays import Floats

_LEAST_MASS = 1e-7
"""Mass of a moving link without one, relative to the robot's."""
_NO_MASS = 1e-6
"""Mass of a robot up to which the file has none, kg; MuJoCo gives its bodies 1e-9."""
_FAR = 0.25
"""Distance of the base's origin from the middle of the hips, relative to the leg or the body, that moves it there."""


def fused(described: Description, anatomy: Anatomy, stance: Stance) -> list[Link]:
    """Return the base and the legs' links, each with all that is fixed to it; the first is the base."""
    places, rotations = poses(described.links)
    turn = rotations[anatomy.base] @ anatomy.frame
    origin = places[anatomy.base] + turn @ _origin(described, anatomy, stance)
    places, rotations = (places - origin) @ turn, turn.T @ rotations
    moving = {link for leg in anatomy.legs for link in leg.links}
    owner: dict[int, int] = {anatomy.base: 0}
    base = Link(described.links[anatomy.base].name, -1, np.zeros(3), np.eye(3), Joint("", "free", np.zeros(3)))
    bodies, frames = [base], [(np.zeros(3), np.eye(3))]
    for i, link in enumerate(described.links):
        if i in moving:
            place, own = frames[owner[link.parent]]
            position, rotation = own.T @ (places[i] - place), own.T @ rotations[i]
            frames.append((places[i], rotations[i]))
            bodies.append(Link(link.name, owner[link.parent], position, rotation, link.joint))
            owner[i] = len(bodies) - 1
        elif link.parent in owner:
            owner[i] = owner[link.parent]
        if i in owner:
            place, own = frames[owner[i]]
            _join(bodies[owner[i]], link, own.T @ (places[i] - place), own.T @ rotations[i])
    _give_mass(described, bodies)
    lost = sum(link.mass for i, link in enumerate(described.links) if i not in owner)
    if lost:
        described.add("left out", "mass", f"{lost:.4g} kg of links that are not part of the robot")
    return bodies


def _origin(described: Description, anatomy: Anatomy, stance: Stance) -> Floats:
    """Return the origin of the base in the robot's axes: the file's, or the middle of the hips if that is far."""
    hips = np.array([plane.hip for plane in stance.planes])
    middle = 0.5 * (hips.min(axis=0) + hips.max(axis=0))
    length = max(float(np.ptp(hips[:, 0])), stance.height)
    if np.hypot(*middle[:2]) < _FAR * length and abs(middle[2]) < _FAR * stance.height:
        return np.zeros(3)
    described.add(
        "assumed", "base", f"its frame is in the middle of the hips; the file's is {np.linalg.norm(middle):.3g} m off"
    )
    return middle


def _join(body: Link, link: Link, position: Floats, rotation: Floats) -> None:
    """Add mass, inertia and shapes of a link that is fixed to a body."""
    if link.mass > 0.0:
        total = body.mass + link.mass
        centre = position + rotation @ link.centre
        common = (body.mass * body.centre + link.mass * centre) / total
        body.inertia = body.inertia + rotation @ link.inertia @ rotation.T
        for mass, at in ((body.mass, body.centre), (link.mass, centre)):
            away = at - common
            body.inertia = body.inertia + mass * (away @ away * np.eye(3) - np.outer(away, away))
        body.mass, body.centre = total, common
    body.shapes.extend(moved(shape, position, rotation) for shape in link.shapes)


def _give_mass(described: Description, bodies: list[Link]) -> None:
    total = sum(body.mass for body in bodies)
    if total < _NO_MASS:
        missing = described.meshes_not_read()
        raise QuadrupedError(f"no link has a mass, or a shape to assume one from; give each its inertia{missing}")
    without = [body for body in bodies if body.mass <= 1e-9 * total]
    for body in without:
        body.mass, body.centre = _LEAST_MASS * total, np.zeros(3)
        body.inertia = body.mass * 1e-4 * np.eye(3)
    if without:
        names = named([body.name for body in without])
        text = f"{names}: moves without a mass, and gets {_LEAST_MASS:g} of the robot's; give it its own"
        described.add("repaired", "mass", text)
