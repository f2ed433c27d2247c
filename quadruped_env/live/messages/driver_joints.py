"""The joints that a robot's driver names in its messages, and their conversion to the robot's joints."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from quadruped_env.control.joint_command import LIMP, MAX_MEASURED, MAX_TARGET, Target
from quadruped_env.errors import QuadrupedError
from quadruped_env.live.messages.joint_messages import Joints
from quadruped_env.robot.robot import Robot
from quadruped_env.utils.arrays import Floats

if TYPE_CHECKING:
    from quadruped_env.trajectory.joint_map import JointMap

_KINDS: Final = ("position", "velocity", "effort")


class DriverJoints:
    """Conversion between the driver's joints and the robot's. Without a map they are the same.

    Args:
        robot: the robot.
        joint_map: rule of each joint of the robot, with the driver's joints as sources; None without a map.
        commands: True if commands are converted too, so that the robot's joints have to determine the driver's.

    Raises:
        QuadrupedError: if the map's joints are not the robot's, do not determine the driver's, or would send
            targets beyond `MAX_TARGET`.
    """

    def __init__(self, robot: Robot, joint_map: "JointMap | None" = None, commands: bool = True) -> None:
        self.joint_names = robot.joint_names if joint_map is None else joint_map.sources
        """Names of the driver's joints, in the order of its values (D,)."""
        self.rates = np.ones(len(self.joint_names)) if joint_map is None else joint_map.rates
        """Velocity of each joint, in the driver's unit, per unit of position and second (D,)."""
        self.limits = {} if joint_map is None else joint_map.limits(MAX_MEASURED)
        """Kind -> largest accepted value of each joint, in the driver's unit (D,); without a map: `MAX_MEASURED`."""
        self._map = joint_map
        if joint_map is None:
            return
        if tuple(joint_map.rules) != robot.joint_names:
            raise QuadrupedError(
                f"{joint_map.name}: has tables [joints.<joint>] for {', '.join(joint_map.rules)}; expected one for "
                f"each joint of {robot.name}: {', '.join(robot.joint_names)}"
            )
        if commands:
            self._check_targets(robot, joint_map)
        self._uses = np.array([[name in rule.gears for name in joint_map.sources] for rule in joint_map.rules.values()])
        self._last = dict.fromkeys(_KINDS, np.full(len(self.joint_names), np.nan))

    @classmethod
    def load(cls, path: Path | None, robot: Robot, commands: bool = True) -> Self:
        """Load the conversion from a map in a TOML file (`quadruped_env.trajectory.joint_map`); None: no map.

        Raises:
            QuadrupedError: if the file is not such a map, or does not fit the robot.
        """
        if path is None:
            return cls(robot)
        # Here, because a controller without a map does without the code for recordings.
        from quadruped_env.trajectory.joint_map import JointMap

        loaded = JointMap.load(path)
        given = sorted(loaded.rules, key=lambda name: (*robot.joint_names, name).index(name))
        return cls(robot, JointMap({name: loaded.rules[name] for name in given}, loaded.name), commands)

    def _check_targets(self, robot: Robot, joint_map: "JointMap") -> None:
        """Refuse a map that does not determine the driver's joints, or with which their targets are absurd."""
        ends = np.array([robot.joint_position_low, robot.joint_position_high])
        with np.errstate(over="ignore", invalid="ignore"):
            targets = joint_map.to_sources({"position": ends})["position"]
        invalid = ~(np.abs(targets) <= MAX_TARGET)
        if invalid.any():
            end, joint = np.argwhere(invalid)[0]
            raise QuadrupedError(
                f"{joint_map.name}: within the joints' ranges, targets of {self.joint_names[joint]} reach "
                f"{targets[end, joint]:.3g}, and at most {MAX_TARGET:g} may be sent; check sources, scale and offset"
            )

    def to_robot(self, joints: Joints) -> Joints:
        """Convert a message of the driver's joints (D,) to the robot's (J,).

        Driver's joints that the message lacks are taken from earlier ones. Joints none of whose sources it holds, or
        with a source that no message has held yet, are NaN.
        """
        if self._map is None:
            return joints
        assert joints.positions is not None
        given = {"position": joints.positions, "velocity": joints.velocities, "effort": joints.efforts}
        found = np.isfinite(joints.positions)
        for kind, values in given.items():
            self._last[kind] = np.where(found, np.nan if values is None else values, self._last[kind])
        known = {kind: self._last[kind] for kind, values in given.items() if values is not None}
        held = found.any() & ((self._uses & found).any(axis=1) | ~self._uses.any(axis=1))
        mapped = self._map.to_joints(self.joint_names, known)
        position, velocity, effort = (np.where(held, mapped[k], np.nan) if k in mapped else None for k in _KINDS)
        return Joints(joints.stamp, position, velocity, effort, joints.others)

    def target_to_robot(self, target: Target) -> Target:
        """Convert a target for the driver's joints (D,) to the robot's (J,); `LIMP` stays `LIMP`.

        Raises:
            QuadrupedError: if a target is not finite.
        """
        if target is not LIMP and self._map is not None:
            with np.errstate(over="ignore", invalid="ignore"):
                target = self._map.to_joints(self.joint_names, {"position": target})["position"]
        if target is not LIMP and not np.isfinite(target).all():
            raise QuadrupedError(f"a joint target is not finite: {target.tolist()}; send finite numbers")
        return target

    def target_to_driver(self, target: Target) -> Target:
        """Convert a target for the robot's joints (J,) to the driver's (D,); `LIMP` stays `LIMP`."""
        return LIMP if target is LIMP else self.to_driver(target)[0]

    def to_driver(self, *values: Floats) -> tuple[Floats, ...]:
        """Convert positions, velocities and efforts of the robot's joints (J,), as far as given, to the driver (D,)."""
        if self._map is None:
            return values
        return tuple(self._map.to_sources(dict(zip(_KINDS, values, strict=False))).values())


def add_map_argument(parser: argparse.ArgumentParser) -> None:
    """Add `--map`: the joints that the robot's driver names."""
    parser.add_argument(
        "--map",
        type=Path,
        metavar="MAP.toml",
        help="joints, signs, zeros and units of the robot's driver on /joint_states and /joint_commands, as "
        "'calibrate' writes them (docs/live.md; default: the robot's joints, in rad)",
    )
