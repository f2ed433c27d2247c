"""Shapes of links as convex hulls of balls, and what is measured on them."""

import math

import numpy as np

from quadruped_env.importer.description import Shape
from quadruped_env.utils.arrays import Floats

_RIM = 16
"""Points on each rim of a cylinder."""
_MAX_POINTS = 2000
"""Points that are kept of a mesh."""


def ball(position: Floats, radius: float) -> Shape:
    """Return a ball."""
    return Shape(np.array([position]), radius, 4.0 / 3.0 * math.pi * radius**3)


def box(position: Floats, rotation: Floats, half: Floats) -> Shape:
    """Return a box of some half sizes (3,)."""
    signs = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    return Shape(position + (signs * half) @ rotation.T, 0.0, float(8.0 * np.prod(half)))


def cylinder(position: Floats, rotation: Floats, radius: float, length: float, capsule: bool = False) -> Shape:
    """Return a cylinder, or a capsule, along z."""
    volume = math.pi * radius**2 * length
    if capsule:
        ends = np.array([[0.0, 0.0, -0.5 * length], [0.0, 0.0, 0.5 * length]])
        return Shape(position + ends @ rotation.T, radius, volume + 4.0 / 3.0 * math.pi * radius**3)
    angle = np.linspace(0.0, 2.0 * np.pi, _RIM, endpoint=False)
    rim = np.stack([radius * np.cos(angle), radius * np.sin(angle), np.full(_RIM, 0.5 * length)], axis=1)
    return Shape(position + np.concatenate([rim, rim * [1.0, 1.0, -1.0]]) @ rotation.T, 0.0, volume)


def mesh(position: Floats, rotation: Floats, vertices: Floats) -> Shape:
    """Return a mesh: some of its vertices (P, 3), with the outermost, and the volume of its bounding box."""
    directions = np.concatenate([np.eye(3), -np.eye(3), np.random.default_rng(0).normal(size=(100, 3))])
    outer = np.unique((vertices @ directions.T).argmax(axis=0))
    kept = np.concatenate([vertices[outer], vertices[:: 1 + len(vertices) // _MAX_POINTS]])
    return Shape(position + kept @ rotation.T, 0.0, float(np.prod(np.ptp(vertices, axis=0))))


def moved(shape: Shape, position: Floats, rotation: Floats) -> Shape:
    """Return a shape in the frame of another link, in which its own has a pose."""
    return Shape(position + shape.points @ rotation.T, shape.radius, shape.volume, shape.collides)


def bounds(shapes: list[Shape]) -> tuple[Floats, Floats]:
    """Return the lower and the upper corner (3,) of shapes."""
    low = np.min([shape.points.min(axis=0) - shape.radius for shape in shapes], axis=0)
    high = np.max([shape.points.max(axis=0) + shape.radius for shape in shapes], axis=0)
    return low, high


def end_ball(shapes: list[Shape], across: Floats) -> tuple[Floats, float, bool]:
    """Return centre (3,) and radius of the ball at the end of a leg, and whether the file has it.

    Args:
        shapes: of the last link, whose joint is at the origin.
        across: unit vector along the joint's axis.
    """
    reach = [np.linalg.norm(shape.points, axis=1) + shape.radius for shape in shapes]
    longest = max(values.max() for values in reach)
    rounds = [(values.max(), i) for i, values in enumerate(reach) if shapes[i].radius > 0.0]
    if rounds and max(rounds)[0] > 0.97 * longest:
        shape = shapes[max(rounds)[1]]
        return shape.points[np.linalg.norm(shape.points, axis=1).argmax()], shape.radius, True
    points = np.concatenate([shape.points for shape in shapes])
    tip = points[np.linalg.norm(points, axis=1).argmax()]
    length = float(np.linalg.norm(tip))
    outward = tip / (length or 1.0)
    near = points[(points - tip) @ outward > -0.12 * length]
    radius = float(np.clip(0.5 * np.ptp(near @ across), 0.02 * length, 0.15 * length))
    middle = 0.5 * (near.min(axis=0) + near.max(axis=0))  # the tip of a box is a corner
    outward = middle / np.linalg.norm(middle)
    return (float((points @ outward).max()) - radius) * outward, radius, False
