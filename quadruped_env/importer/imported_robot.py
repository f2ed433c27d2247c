"""A robot of a URDF, a xacro file or an MJCF, as the files of a task."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.importer import inertia, writing, xacro_file
from quadruped_env.importer.assumed_motors import AssumedMotor, assumed_motors
from quadruped_env.importer.bodies import fused
from quadruped_env.importer.description import Description, Finding, Link
from quadruped_env.importer.files import Folders
from quadruped_env.importer.legs import Anatomy, find_legs
from quadruped_env.importer.mjcf import describe_mjcf
from quadruped_env.importer.stance import Stance, find_stance
from quadruped_env.importer.urdf import Urdf
from quadruped_env.importer.xml_tree import FIX, parse, read_bytes
from quadruped_env.robot import MotorConfig, Robot

FORWARD: Final = ("x", "-x", "y", "-y", "z", "-z")
"""Axes of the base link along which a robot may walk."""


@dataclass(frozen=True)
class ImportedRobot:
    """A robot that was read from a file, and what was found, assumed and repaired."""

    source: Path
    described: Description
    """Content of the file, with what was repaired."""
    anatomy: Anatomy
    stance: Stance
    bodies: tuple[Link, ...]
    """Base and links of the legs, with all that is fixed to them."""
    motors: tuple[AssumedMotor, ...]

    @property
    def findings(self) -> list[Finding]:
        """What was found, assumed, repaired and left out."""
        return self.described.findings

    @property
    def name(self) -> str:
        """Name of the robot, of letters, digits and underscores."""
        return writing.robot_name(self.described.name)

    @cached_property
    def mjcf(self) -> str:
        """The robot alone."""
        return writing.mjcf(self.described, self.anatomy, self.stance, self.bodies)

    @property
    def mass(self) -> float:
        """Mass of the robot, kg."""
        return sum(body.mass for body in self.bodies)

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Names of the joints, in the order of the MJCF."""
        return tuple(body.joint.name for body in self.bodies[1:])

    def robot(self) -> Robot:
        """Return the robot that the task file defines.

        Raises:
            QuadrupedError: if the model cannot be simulated.
        """
        motors = {motor.field: motor.motor() for motor in self.motors}
        hip, knee, abduction = motors["hip"], motors["knee"], motors.get("abduction")
        return Robot(
            name=self.name,
            mjcf=self.mjcf,
            stance=np.array(self._joint_positions),
            motors=MotorConfig(hip, knee, abduction=None if hip == knee == abduction else abduction),
        )

    def task_file(self, model_file: str) -> str:
        """Return a Python file that defines the robot; `model_file` is the name of the MJCF next to it."""
        return writing.task_file(self.described, self.source.name, model_file, self._joint_positions, self.motors)

    @property
    def _joint_positions(self) -> list[float]:
        return [self.stance.positions[name] for name in self.joint_names]


def import_robot(path: Path, folders: Sequence[Path] = (), forward: str | None = None) -> ImportedRobot:
    """Read a robot with four legs of two or three joints.

    Args:
        path: URDF, xacro file or MJCF.
        folders: where meshes, included files and ROS packages are searched, besides the file's package.
        forward: axis of the base link along which the robot walks, of `FORWARD`, where that is a convention.

    Raises:
        MissingExtraError: if the file is xacro, and the library is not installed.
        QuadrupedError: if the file is no such robot, or damaged; the message says where and what is supported.
    """
    if forward is not None and forward not in FORWARD:
        raise QuadrupedError(f"--forward: expected one of {', '.join(FORWARD)}; found {short(forward)}")
    for folder in folders:
        if not folder.is_dir():
            raise QuadrupedError(f"--folder: {folder} is no folder")
    content = read_bytes(path)
    try:
        with np.errstate(all="ignore"):
            described = _described(content, Folders(tuple(folders), path))
            inertia.repair(described)
            anatomy = find_legs(described, forward)
            stance = find_stance(described, anatomy)
            bodies = fused(described, anatomy, stance)
            motors = assumed_motors(described, anatomy, stance, bodies)
    except QuadrupedError as error:
        raise QuadrupedError(f"{path}: {error}") from error
    return ImportedRobot(path, described, anatomy, stance, tuple(bodies), tuple(motors))


def _described(content: bytes, folders: Folders) -> Description:
    root = parse(content)
    if xacro_file.is_xacro(root):
        content = xacro_file.expanded(folders)
        root = parse(content, "expanded, ")
    if root.tag == "robot":
        return Urdf(root, folders).description()
    if root.tag == "mujoco":
        return describe_mjcf(content, root, folders)
    raise QuadrupedError(f"its root element is <{root.tag[:40]}>; expected <robot> (URDF) or <mujoco> (MJCF); {FIX}")
