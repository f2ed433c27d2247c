"""Stance of a robot: each foot under its hip, with the knees bent to the side that their ranges or a home pose say."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.importer.description import Description, named
from quadruped_env.importer.legs import Anatomy, Leg
from quadruped_env.utils.arrays import Floats

REACH: Final = 0.85
"""Height of the hips over the feet in the stance, relative to the length of the straight leg."""
_REACHES: Final = sorted(np.arange(0.5, 0.97, 0.01).round(2).tolist(), key=lambda share: abs(share - REACH))
_BENT: Final = (0.45, 2.3)
"""Angles of a knee at which a leg stands, rad."""
_SURE: Final = 3.0
"""Ratio of a knee's ranges to either side from which on the larger one is meant."""
_MARGIN: Final = 0.02
"""Distance of the stance from the joints' limits, rad."""
_ROOM: Final = ((0.1, 0.1), (0.1, _MARGIN), (0.06, _MARGIN), (0.0, _MARGIN))
"""Height by which the feet can be lifted from the stance, relative to the leg, and the distance in rad of the thighs
from their limits then, since a stride turns them further; most first."""
_TURN: Final = 2.0 * math.pi


@dataclass(frozen=True)
class LegPlane:
    """A leg in its plane, which its roll joint makes upright; angles about the left axis, 0 straight down."""

    leg: Leg
    roll: float
    """Position of the roll joint at which the plane is upright, rad; 0 without one."""
    hip: Floats
    """First pitch joint (3,), in the base frame, m."""
    thigh: float
    """Distance of the pitch joints, m."""
    shank: float
    """Distance of the knee and the foot's centre, m."""
    zero: tuple[float, float]
    """Angles of the thigh, and of the shank relative to it, at joint positions 0, rad."""
    signs: tuple[int, ...]
    """1 for each joint that turns about forward (roll) or left (pitch), -1 for one that turns the other way."""


@dataclass(frozen=True)
class Stance:
    """A robot's stance."""

    positions: dict[str, float]
    """Position of each joint, rad."""
    knees: str
    """Side to which each knee points, in the order of the corners: `<` back or `>` fore."""
    planes: tuple[LegPlane, ...]
    height: float
    """Height of the hips above the ground, m."""

    @property
    def thigh(self) -> float:
        """Mean length of the thighs, m."""
        return float(np.mean([plane.thigh for plane in self.planes]))

    @property
    def shank(self) -> float:
        """Mean length of the shanks, m."""
        return float(np.mean([plane.shank for plane in self.planes]))


def find_stance(described: Description, anatomy: Anatomy) -> Stance:
    """Find the stance, and give joints without limits a range about it, in place.

    Raises:
        QuadrupedError: if a leg has no length.
    """
    planes = tuple(map(_plane, anatomy.legs))
    _check_lengths(described, planes)
    knees, unsure = _knees(described, planes)
    positions = _home(described, planes)
    if positions is not None:
        described.add("found", "stance", "the home keyframe of the file")
    else:
        choices = [knees, "".join({"<": ">", ">": "<"}[knee] if i in unsure else knee for i, knee in enumerate(knees))]
        knees, positions, text = _under_hips(planes, choices)
        described.add("assumed", "stance", text)
    if unsure:
        described.add("assumed", "knees", f"{knees[0]}: the ranges allow both directions, and no home pose shows one")
    _limit(described, planes, positions, knees)
    drops = [plane.hip[2] - plane.leg.moved([positions[name] for name in plane.leg.names])[2][2] for plane in planes]
    rounded = {name: round(value, 5) + 0.0 for name, value in positions.items()}
    return Stance(rounded, knees, planes, float(np.mean(drops)) + anatomy.foot_radius)


def _plane(leg: Leg) -> LegPlane:
    left, positions = np.array([0.0, 1.0, 0.0]), [0.0] * len(leg.axes)
    roll = 0.0
    if "roll" in leg.kinds:
        place = leg.kinds.index("roll")
        roll = positions[place] = _upright(leg, place, left)
    axes, anchors, foot = leg.moved(positions)
    hip, knee = (anchor for anchor, kind in zip(anchors, leg.kinds, strict=True) if kind == "pitch")
    thigh, shank = (np.array([-v[0], -v[2]]) for v in (knee - hip, foot - knee))
    along = [[1.0, 0.0, 0.0] if kind == "roll" else left for kind in leg.kinds]
    signs = tuple(1 if axis @ way > 0.0 else -1 for axis, way in zip(axes, along, strict=True))
    first = math.atan2(*thigh)
    zero = (first, _wrapped(math.atan2(*shank) - first))
    return LegPlane(leg, roll, hip, float(np.linalg.norm(thigh)), float(np.linalg.norm(shank)), zero, signs)


def _upright(leg: Leg, place: int, left: Floats) -> float:
    """Return the position of the roll joint at which the knee's axis is along the left axis."""
    axis, knee = leg.axes[place], leg.axes[-1]
    angle = math.atan2(axis @ np.cross(knee, left), knee @ left - (knee @ axis) * (left @ axis))
    side = 1.0 if leg.corner[0] == "L" else -1.0

    def cost(position: float) -> tuple[float, float, float]:
        joint, positions = leg.joints[place], [0.0] * len(leg.axes)
        positions[place] = position
        _, anchors, _ = leg.moved(positions)
        outside = max(joint.low - position, position - joint.high, 0.0)
        return round(outside, 2), round(abs(position), 1), -side * float(anchors[-1][1])

    return min((_wrapped(angle + turn) for turn in (0.0, math.pi)), key=cost)


def _check_lengths(described: Description, planes: Sequence[LegPlane]) -> None:
    lengths = np.array([[plane.thigh, plane.shank] for plane in planes])
    if lengths.min() < 0.1 * lengths.max() or lengths.max() < 1e-4:
        found = "; ".join(f"{plane.leg.corner} {plane.thigh:.3g} and {plane.shank:.3g} m" for plane in planes)
        raise QuadrupedError(
            f"thigh and shank of the legs are {found}; expected two links of similar length, with the foot "
            f"at the end of the second: check the joints' origins and the shapes of the last links (a wheel is none)"
            f"{described.meshes_not_read()}"
        )


def _knees(described: Description, planes: Sequence[LegPlane]) -> tuple[str, set[int]]:
    """Return the side of each knee, and the indices of those that the file does not tell."""
    knees, unsure = "", set()
    for i, plane in enumerate(planes):
        joint = plane.leg.joints[-1]
        back, fore = _shares(plane, joint.low, joint.high)
        if described.home is not None and joint.name in described.home:
            bend = plane.zero[1] + plane.signs[-1] * described.home[joint.name]
            back, fore = (back if bend < -1e-3 else 0.0), (fore if bend > 1e-3 else 0.0)
        if max(back, fore) <= _SURE * min(back, fore):
            unsure.add(i)
        knees += ">" if i not in unsure and fore > back else "<"
    return knees, unsure


def _shares(plane: LegPlane, low: float, high: float) -> tuple[float, float]:
    """Return the sizes of a knee's ranges in which the leg stands, with the knee behind and in front, rad."""
    if math.isinf(low):
        return 1.0, 1.0
    ends = sorted(plane.zero[1] + plane.signs[-1] * position for position in (low, high))

    def overlap(begin: float, end: float) -> float:
        return sum(max(0.0, min(ends[1], end + turn) - max(ends[0], begin + turn)) for turn in (-_TURN, 0.0, _TURN))

    return overlap(-_BENT[1], -_BENT[0]), overlap(*_BENT)


def _home(described: Description, planes: Sequence[LegPlane]) -> dict[str, float] | None:
    """Return the home keyframe's joint positions if the robot stands on its feet in it."""
    names = [name for plane in planes for name in plane.leg.names]
    if described.home is None or not described.home.keys() >= set(names):
        return None
    home = {name: described.home[name] for name in names}
    drops = []
    for plane in planes:
        positions = [home[name] for name in plane.leg.names]
        foot, reach = plane.leg.moved(positions)[2], plane.thigh + plane.shank
        offset = np.hypot(*(foot - plane.hip)[:2])
        inside = all(
            joint.low < position < joint.high for joint, position in zip(plane.leg.joints, positions, strict=True)
        )
        if not inside or offset > 0.3 * reach or not 0.4 * reach < plane.hip[2] - foot[2] < 0.98 * reach:
            return None
        drops.append(foot[2])
    return home if np.ptp(drops) < 0.05 * reach else None


def _under_hips(planes: Sequence[LegPlane], choices: Sequence[str]) -> tuple[str, dict[str, float], str]:
    """Return the knees, the joint positions with each foot under its hip, and what a finding says about them."""
    for knees, (lift, swing), share in itertools.product(dict.fromkeys(choices), _ROOM, _REACHES):
        positions = _feet_under(planes, knees, share)
        if positions is not None and _feet_under(planes, knees, share - lift, swing) is not None:
            return knees, positions, f"each foot under its hip, at {share:.2f} of the leg's length"
    middle = {
        joint.name: 0.0 if math.isinf(joint.low) else 0.5 * (joint.low + joint.high)
        for plane in planes
        for joint in plane.leg.joints
    }
    return choices[0], middle, "the middle of the ranges, since the limits allow no foot under its hip; correct it"


def _feet_under(
    planes: Sequence[LegPlane], knees: str, share: float, swing: float = _MARGIN
) -> dict[str, float] | None:
    """Return joint positions with the feet under the hips at a share of the legs' length; None beyond limits.

    The thighs are `swing` in rad from theirs or more.
    """
    heights = np.array([[plane.hip[2], plane.thigh + plane.shank] for plane in planes])
    ground = float((heights[:, 0] - share * heights[:, 1]).mean())
    found: dict[str, float] = {}
    for plane, knee in zip(planes, knees, strict=True):
        positions = _bent(plane, float(plane.hip[2]) - ground, knee, swing)
        if positions is None:
            return None
        found.update(zip(plane.leg.names, positions, strict=True))
    return found


def _bent(plane: LegPlane, drop: float, knee: str, swing: float) -> list[float] | None:
    """Return the leg's joint positions with the foot under the hip by a height in m; None if the limits forbid it."""
    a, b, side = plane.thigh, plane.shank, 1.0 if knee == "<" else -1.0
    if not abs(a - b) < drop < a + b:
        return None
    thigh = side * math.acos((a * a + drop * drop - b * b) / (2.0 * a * drop))
    bend = -side * (math.pi - math.acos((a * a + b * b - drop * drop) / (2.0 * a * b)))
    wanted = iter([thigh - plane.zero[0], bend - plane.zero[1]])
    positions = []
    for joint, kind, sign in zip(plane.leg.joints, plane.leg.kinds, plane.signs, strict=True):
        margin = _MARGIN if kind == "roll" or joint is plane.leg.joints[-1] else swing
        position = plane.roll if kind == "roll" else sign * _wrapped(next(wanted))
        turns = [position + turn for turn in (0.0, -_TURN, _TURN)]
        inside = [x for x in turns if joint.low + margin < x < joint.high - margin]
        if not inside:
            return None
        positions.append(inside[0])
    return positions


def _limit(described: Description, planes: Sequence[LegPlane], positions: dict[str, float], knees: str) -> None:
    """Give joints without limits a range about the stance; knees bend to their side only."""
    given = []
    for plane, knee in zip(planes, knees, strict=True):
        for joint, kind, sign in zip(plane.leg.joints, plane.leg.kinds, plane.signs, strict=True):
            if math.isfinite(joint.low):
                continue
            at, is_knee = positions[joint.name], joint is plane.leg.joints[-1]
            below, above = (0.8, 0.8) if kind == "roll" else (1.2, 1.2)
            if is_knee:
                bend = abs(_wrapped(plane.zero[1] + sign * at))
                to_straight, to_folded = bend - 0.1, 2.6 - bend
                straighter_above = (sign > 0) == (knee == "<")
                below, above = (to_folded, to_straight) if straighter_above else (to_straight, to_folded)
            joint.low, joint.high = round(at - below, 4), round(at + above, 4)
            given.append(joint.name)
    if given:
        rolls = "0.8 rad (roll) and " if "roll" in planes[0].leg.kinds else ""
        text = f"{named(given)}: the file has none; {rolls}1.2 rad about the stance, and knees bent by 0.1 to 2.6 rad"
        described.add("assumed", "ranges", text)


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % _TURN - math.pi
