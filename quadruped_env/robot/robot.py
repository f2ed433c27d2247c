"""Description of a robot, which other packages receive as an argument."""

import base64
import dataclasses
import functools
import hashlib
import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Self
from xml.etree import ElementTree

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot.model_completion import (
    add_sensors,
    check_structure,
    make_servos,
    own_sensors,
    parsed,
    read_model,
)
from quadruped_env.robot.model_structure import DIGITS, add_sites, foot_places
from quadruped_env.robot.motors import MOTOR_KINDS, JointMotor, MotorConfig
from quadruped_env.robot.skeleton import Pose, Skeleton
from quadruped_env.robot.written_urdf import written_urdf
from quadruped_env.utils.arrays import Floats, frozen
from quadruped_env.utils.fields import check
from quadruped_env.utils.parameters import is_quantity
from quadruped_env.utils.plain import plain

_PER_JOINT = ("joint_position_low", "joint_position_high", "velocity_limit", "effort_limit", "stance")
_OPTIONAL = ("urdf", "motor_kinds", "mirror_signs", "leg_corners", "gaits", "assets")
"""Fields that may be None; then they are not part of the content, so that robots without them keep their identity."""
_MIRROR_TOLERANCE = 1e-3
"""Difference between an axis and its mirror image, as 1 - |cosine|, about 2.5 degrees."""
_FOOTPRINT = 4.0 / 3.0
"""Footprint as a multiple of the distance of the farthest foot in the stance; at a start the legs deviate from it."""
_SIDEWAYS = 0.25
"""Least motion of a foot sideways per rad, as a multiple of the stance's height, by a joint that rolls its leg."""
_SIX_DIGITS = 5e-6
"""Tolerance between a value of the robot and its model's, relative from 1 up: MuJoCo writes six digits."""
CORNERS = ("LF", "RF", "LH", "RH")
"""Names of the corners, and of a robot's legs by default: left (L) or right (R), fore (F) or hind (H)."""
ROBOT_FILE = "mini_quadruped.xml"
"""File that a scene includes: a robot's MJCF takes its place."""
_OF_THE_MODEL: Any = None
"""Default of the fields that follow from the model and the motors."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Robot:
    """A legged robot as a value: names, stance, symmetry, motors, and its model as text.

    Arrays are read-only and in the order of `joint_names` or `leg_names`, which is the order of the model. Masses and
    kinematics are computed from the model. Two robots are equal if their content is; comments and layout of the model
    files do not count.

        ROBOT = Robot(name="dog", mjcf=Path("dog.xml"), stance=[0.0, 0.8, -1.6] * 4, motors=MotorConfig(MOTOR, MOTOR))

    Fields with "None:" follow from the model or the motors where they are not given. A value that is given is compared
    with the model's value, to six digits.

    Raises:
        QuadrupedError: if the fields contradict each other or the model.
    """

    name: str
    leg_names: tuple[str, ...] = _OF_THE_MODEL
    """Names of the legs, in the order of `foot_sites`. None: LF, RF, LH and RH, by the legs' `corners`."""
    joint_names: tuple[str, ...] = _OF_THE_MODEL
    """Names of the joints, and of their motors in the model's order. None: the model's."""
    link_names: tuple[str, ...] = _OF_THE_MODEL
    """Names of the links, the base first. None: all bodies that are named, in the model's order."""
    joint_position_low: Floats = _OF_THE_MODEL
    """Lower limits of the joint positions (J,), rad. None: the model's."""
    joint_position_high: Floats = _OF_THE_MODEL
    """Upper limits of the joint positions (J,), rad. None: the model's."""
    velocity_limit: Floats = _OF_THE_MODEL
    """Maximum joint speeds without load (J,), rad/s. None: by `motors`."""
    effort_limit: Floats = _OF_THE_MODEL
    """Maximum joint torques at rest (J,), N m. None: by `motors`."""
    stance: Floats
    """Joint positions with each foot under its hip (J,), rad; also as a dict of joint -> position."""
    stance_height: float = _OF_THE_MODEL
    """Height of the base's centre in the stance, with the feet on the ground, m. None: by the feet."""
    foot_radius: float = _OF_THE_MODEL
    """Radius of the feet, which are balls, m. None: from `foot_sites` to the lowest point of their links' shapes in the
    stance."""
    foot_sites: tuple[str, ...] = _OF_THE_MODEL
    """Sites of the model at the centres of the feet, one per leg; also as a dict of link -> position (3,) in its frame,
    m, of sites that the model gets. None: in each leg's last link the only site, or else the centre of the only ball
    that collides."""
    joint_mirror: tuple[int, ...] = _OF_THE_MODEL
    """Index of each joint's counterpart on the other side; `joint_signs` says which of them turn the other way. None:
    the joint at the same place in the leg of the other corner."""
    foot_mirror: tuple[int, ...] = _OF_THE_MODEL
    """Index of each foot's counterpart on the other side. None: the foot of the other corner."""
    sensors: Mapping[str, tuple[str, ...]] = _OF_THE_MODEL
    """Sensors of the model for each field of `quadruped_env.robot.readings.Readings`, in order. None: the model gets
    them, with the base's sensors at its origin."""
    motors: MotorConfig
    """Motors of the joints. They are written into the model, whatever actuators it has."""
    mjcf: str
    """MuJoCo model of the robot alone, with a floating base and without ground: the text, or the path of a file, whose
    meshes are searched next to it."""
    urdf: str | None = None
    """Description for ROS and Drake. None: see `description`."""
    motor_kinds: tuple[str, ...] | None = None
    """Motor of each joint, a field of `MotorConfig` (J,). None: see `joint_kinds`."""
    mirror_signs: tuple[int, ...] | None = None
    """1 for each joint that turns the same way as its counterpart under the left/right mirror, -1 for one that turns
    the other way (J,). None: see `joint_signs`."""
    leg_corners: tuple[int, ...] | None = None
    """Corner of each leg (L,), whose phase and motion it has in the scripted gaits: 0 left fore, 1 right fore, 2 left
    hind, 3 right hind. None: see `corners`."""
    gaits: Mapping[str, Mapping[str, Any]] | None = None
    """Scripted gaits tuned on this robot, by name of the preset whose place they take, as `tools/tune_gait.py` writes
    them. None: the presets."""
    assets: Mapping[str, bytes] | None = None
    """Files that the MJCF names, such as meshes, by name; with the path of a file as `mjcf` they are read from it."""

    def __post_init__(self) -> None:
        if isinstance(self.mjcf, os.PathLike):
            text, assets = read_model(Path(self.mjcf))
            self._set(mjcf=text, assets={**assets, **(self.assets or {})} or None)
        self._find_joints_and_feet()
        self._check_numbers()
        self._check_given()
        self._find_legs()
        self._check_restated()
        self._check(len(self.leg_names) == self.num_legs, "leg_names", f"{self.num_legs} names, one per foot")
        for name in ("leg_names", "joint_names", "link_names"):
            self._check(len(set(getattr(self, name))) == len(getattr(self, name)), name, "different names")

    def _find_joints_and_feet(self) -> None:
        """Fill `joint_names` and `foot_sites` where they are not given as names, and put `stance` in order."""
        if self.joint_names is None:
            self._set(joint_names=tuple(joint.name for joint in self._parsed().joints[1:]))
        if self.foot_sites is None or isinstance(self.foot_sites, Mapping):
            try:
                places = self.foot_sites or foot_places(self._compiled(self._parsed()))
                mjcf, sites = add_sites(self.mjcf, places)
            except QuadrupedError as error:
                raise self._error(str(error)) from error
            self._set(mjcf=mjcf, foot_sites=sites)
        stance: Any = self.stance
        if isinstance(stance, Mapping):
            if set(stance) != set(self.joint_names):
                expected = ", ".join(self.joint_names)
                raise self._error(f"stance must name the joints {expected}; found {', '.join(map(str, stance))}")
            self._set(stance=[stance[name] for name in self.joint_names])

    def _find_legs(self) -> None:
        """Fill `leg_names`, `joint_mirror` and `foot_mirror` where they are not given, by the legs' corners."""
        missing = [name for name in ("leg_names", "joint_mirror", "foot_mirror") if getattr(self, name) is None]
        if not missing:
            return
        legs = self.skeleton.leg_joints
        if sorted(self.corners) != [0, 1, 2, 3] or len({len(joints) for joints in legs}) > 1:
            names = ", ".join(f"{site} {CORNERS[c]}" for site, c in zip(self.foot_sites, self.corners, strict=True))
            raise self._error(
                f"{', '.join(missing)} follow only for one leg in each corner, all of as many joints; found the feet "
                f"{names} with {', '.join(str(len(joints)) for joints in legs)} joints; correct stance or foot_sites, "
                f"or give {', '.join(missing)}"
            )
        others = [self.corners.index(corner ^ 1) for corner in self.corners]
        joints = {joint: legs[others[leg]][place] for leg, of in enumerate(legs) for place, joint in enumerate(of)}
        found = {
            "leg_names": tuple(CORNERS[corner] for corner in self.corners),
            "joint_mirror": tuple(joints.get(joint, joint) for joint in range(self.num_joints)),
            "foot_mirror": tuple(others),
        }
        self._set(**{name: found[name] for name in missing})

    def _check_numbers(self) -> None:
        """Check the numbers that are given, and make the arrays read-only."""
        for name in _PER_JOINT:
            if getattr(self, name) is None and name != "stance":
                continue
            values = np.array(getattr(self, name), dtype=np.float64)
            finite = values.shape == (self.num_joints,) and bool(np.isfinite(values).all())
            self._check(finite, name, f"{self.num_joints} finite numbers, one per joint")
            self._set(**{name: frozen(values)})
        for name in ("stance_height", "foot_radius"):
            value = getattr(self, name)
            valid = value is None or (is_quantity(value) and value > 0)
            self._check(valid, name, "a positive number (m), or None for the model's")

    def _check(self, condition: bool, name: str, rule: str) -> None:
        check(condition, f"robot {self.name!r}: {name}", getattr(self, name), rule)

    def _set(self, **values: Any) -> None:
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def _check_given(self) -> None:
        """Check the optional fields, and make them plain."""
        if self.sensors is not None:
            lists = isinstance(self.sensors, Mapping) and all(
                isinstance(of, list | tuple) for of in self.sensors.values()
            )
            self._check(lists, "sensors", "a dict of field -> names of the model's sensors")
            self._set(sensors={key: tuple(names) for key, names in self.sensors.items()})
        for name, length, allowed in (
            ("motor_kinds", self.num_joints, MOTOR_KINDS),
            ("mirror_signs", self.num_joints, (1, -1)),
            ("leg_corners", self.num_legs, (0, 1, 2, 3)),
            ("joint_mirror", self.num_joints, range(self.num_joints)),
            ("foot_mirror", self.num_legs, range(self.num_legs)),
        ):
            given = plain(getattr(self, name))
            if given is None:
                continue
            valid = isinstance(given, list) and len(given) == length and all(x in allowed for x in given)
            self._check(valid, name, f"{length} of {', '.join(map(str, allowed))}")
            self._set(**{name: tuple(given)})
        if self.gaits is not None:
            self._check(isinstance(self.gaits, Mapping), "gaits", "a dict of preset -> parameters")
            self._set(gaits=plain(dict(self.gaits)))

    @property
    def base_name(self) -> str:
        """Name of the link that carries the legs."""
        return self.link_names[0]

    @property
    def num_joints(self) -> int:
        """Number of joints, J."""
        return len(self.joint_names)

    @property
    def num_legs(self) -> int:
        """Number of legs, L."""
        return len(self.foot_sites)

    @property
    def num_positions(self) -> int:
        """Length of MuJoCo's `qpos`: the base's position (3,) and quaternion wxyz (4,), then the joints."""
        return 7 + self.num_joints

    @property
    def num_velocities(self) -> int:
        """Length of MuJoCo's `qvel`: the base's linear (3,) and angular (3,) velocity, then the joints."""
        return 6 + self.num_joints

    @functools.cached_property
    def model(self) -> mujoco.MjModel:
        """The robot alone, compiled once; it must not be changed."""
        return self._compiled(self.spec())

    @functools.cached_property
    def stance_feet(self) -> Floats:
        """Centres of the feet in the stance (L, 3), in the base frame, m."""
        return self.skeleton.foot_centres(self.stance)

    @functools.cached_property
    def footprint(self) -> float:
        """Horizontal distance from the base's centre within which the feet touch the ground near the stance, m."""
        return _FOOTPRINT * float(np.hypot(self.stance_feet[:, 0], self.stance_feet[:, 1]).max())

    @functools.cached_property
    def corners(self) -> tuple[int, ...]:
        """Corner of each leg: `leg_corners`, or by the place of its foot in the stance.

        A leg is a fore leg if its foot is in front of the middle of all feet, and a left leg if it is to the left of
        the plane y = 0.
        """
        if self.leg_corners is not None:
            return self.leg_corners
        x, y, _ = self.stance_feet.T
        return tuple((2 * (x <= 0.5 * (x.min() + x.max())) + (y <= 0.0)).tolist())

    @property
    def fore_legs(self) -> NDArray[np.bool_]:
        """True for each fore leg (L,)."""
        return np.array(self.corners) < 2

    @property
    def left_legs(self) -> NDArray[np.bool_]:
        """True for each left leg (L,)."""
        return np.array(self.corners) % 2 == 0

    @property
    def leg_joints(self) -> tuple[tuple[int, ...], ...]:
        """Indices of the joints of each leg, from the base to the foot."""
        return self.skeleton.leg_joints

    @functools.cached_property
    def moves_sideways(self) -> bool:
        """True if legs of three joints move each foot to the side in the stance, so that a robot can walk sideways."""
        if min(map(len, self.leg_joints)) < 3:
            return False
        sideways = np.abs(self.skeleton.foot_jacobians(self.stance)[:, 1]).max(axis=-1)
        return bool((sideways > _SIDEWAYS * self.stance_height).all())

    @functools.cached_property
    def joint_kinds(self) -> tuple[str, ...]:
        """Kind of each joint (J,), which is its motor in a `MotorConfig`: `motor_kinds`, or by its place in the leg.

        The last joint of a leg of two or more is a knee. Of the others in a leg of three or more, those whose axis in
        the stance is closer to the base's x axis than to its y axis are abductions; all others are hips.
        """
        if self.motor_kinds is not None:
            return self.motor_kinds
        kinds = ["hip"] * self.num_joints
        axes = np.abs(self.skeleton.joint_frames(self.stance)[1])
        for joints in self.leg_joints:
            for joint in joints[:-1] if len(joints) > 2 else ():
                if axes[joint, 0] > axes[joint, 1]:
                    kinds[joint] = "abduction"
            if len(joints) > 1:
                kinds[joints[-1]] = "knee"
        return tuple(kinds)

    @functools.cached_property
    def joints_by_kind(self) -> Mapping[str, list[int]]:
        """Indices of the joints of each kind (of `MOTOR_KINDS`), which have the same motors, in order of appearance."""
        kinds: dict[str, list[int]] = {}
        for joint, kind in enumerate(self.joint_kinds):
            kinds.setdefault(kind, []).append(joint)
        return kinds

    @functools.cached_property
    def joint_signs(self) -> NDArray[np.float32]:
        """Factor from each joint's position to its counterpart's under the left/right mirror (J,), 1 or -1.

        It is `mirror_signs`, or follows from the axes in the stance: the mirror y -> -y turns the axis (x, y, z) of a
        hinge into (-x, y, -z), and the axis of a slide into (x, -y, z).

        Raises:
            QuadrupedError: if a joint's axis is not the mirror image of its counterpart's.
        """
        if self.mirror_signs is not None:
            return np.array(self.mirror_signs, dtype=np.float32)
        axes, hinges = self.skeleton.joint_frames(self.stance)[1], self.skeleton.hinges
        images = axes * np.where(hinges[:, None], [-1.0, 1.0, -1.0], [1.0, -1.0, 1.0])
        cosines = (images * axes[list(self.joint_mirror)]).sum(axis=-1)
        wrong = np.abs(cosines) < 1.0 - _MIRROR_TOLERANCE
        if wrong.any():
            joint = int(wrong.argmax())
            raise self._error(
                f"the axis of {self.joint_names[joint]} is not the mirror image of the axis of "
                f"{self.joint_names[self.joint_mirror[joint]]}, its counterpart in joint_mirror; correct joint_mirror, "
                f"or give mirror_signs"
            )
        return np.sign(cosines).astype(np.float32)

    def spec(self, scene: str = "") -> mujoco.MjSpec:
        """Return a new specification of the robot with its motors, but for their delay, to be changed and compiled.

        Args:
            scene: MJCF that includes the robot's as `ROBOT_FILE`; by default the robot is alone.

        Raises:
            QuadrupedError: if MuJoCo cannot read the MJCF, it has a ground or another geom of the world, or its joints
                or actuators differ from `joint_names`.
        """
        spec = self._parsed(scene)
        make_servos(spec, self.joint_names)
        self.motors.write(spec, self.joint_kinds)
        if self.sensors is None:
            bodies = self.skeleton.model.jnt_bodyid[[1 + joints[0] for joints in self.leg_joints]]
            hips = [self.skeleton.model.body(body).name for body in bodies]
            add_sensors(spec, self.sensor_names, self.foot_sites, self.foot_radius, hips)
        return spec

    @property
    def sensor_names(self) -> Mapping[str, tuple[str, ...]]:
        """`sensors`, or the names of those that the model gets."""
        return own_sensors(self.joint_names, self.leg_names) if self.sensors is None else self.sensors

    @functools.cached_property
    def description(self) -> str:
        """The URDF for ROS (`robot_description`) and Drake: `urdf`, or written from the model and the motors.

        Raises:
            QuadrupedError: if a URDF cannot hold the model's joints.
        """
        if self.urdf is not None:
            return self.urdf
        try:
            return written_urdf(self.name, self.model, self.motors.of_joints(self.joint_kinds))
        except QuadrupedError as error:
            raise self._error(str(error)) from error

    @property
    def simulated_mjcf(self) -> str:
        """The MJCF with the robot's motors: `mjcf` where it has them already, else as MuJoCo writes it."""
        given, simulated = self._compiled(self._parsed()), self.model
        same = given.nu == simulated.nu and all(
            np.allclose(getattr(given, name), getattr(simulated, name), rtol=_SIX_DIGITS, atol=0.0)
            for name in dir(given)
            if name.startswith(("actuator_", "dof_")) and name != "actuator_plugin"
        )
        if same and self.sensors is not None:
            return self.mjcf
        spec = self.spec()
        spec.compile()  # without which MuJoCo writes no XML
        return spec.to_xml()

    def _parsed(self, scene: str = "") -> mujoco.MjSpec:
        """Return the MJCF as it was given, or a scene that includes it."""
        try:
            spec = parsed(scene or self.mjcf, self.assets, {ROBOT_FILE: self.mjcf} if scene else None)
            if not scene:  # which has a ground
                check_structure(spec, self.joint_names)
        except QuadrupedError as error:
            raise self._error(str(error)) from error
        except ValueError as error:
            raise self._error(f"MuJoCo cannot read its MJCF ({_line(error)})") from error
        return spec

    def _compiled(self, spec: mujoco.MjSpec) -> mujoco.MjModel:
        try:
            return spec.compile()
        except ValueError as error:
            raise self._error(f"MuJoCo cannot compile its MJCF ({_line(error)})") from error

    @functools.cached_property
    def skeleton(self) -> Skeleton:
        """Kinematics of the robot; computed once."""
        spec = self._parsed()
        base, model = spec.joints[0].parent, self._compiled(spec)
        if self.link_names is None:
            bodies = (base, *base.find_all("body"))
            self._set(link_names=tuple(body.name for body in bodies if body.name))
        sensors = [name for names in (self.sensors or {}).values() for name in names]
        for kind, names in (("body", self.link_names), ("site", self.foot_sites), ("sensor", sensors)):
            for name in names:
                if mujoco.mj_name2id(model, getattr(mujoco.mjtObj, f"mjOBJ_{kind.upper()}"), name) < 0:
                    raise self._error(f"its model has no {kind} {name!r}")
        return Skeleton(spec, model, self.joint_names, self.link_names, self.foot_sites)

    def _check_restated(self) -> None:
        """Fill the fields that restate the model and are not given, and compare the others with it.

        Raises:
            QuadrupedError: if a value differs from the model's, or none is given and the model has none.
        """
        for name, value in self._found_in_model():
            given = getattr(self, name)
            if given is None:
                self._set(**{name: frozen(value) if isinstance(value, np.ndarray) else round(float(value), DIGITS)})
            elif (wrong := ~np.isclose(given, value, rtol=_SIX_DIGITS, atol=_SIX_DIGITS, equal_nan=True)).any():
                of = f" of {self.joint_names[int(wrong.argmax())]}" if wrong.shape else ""
                own, expected = (float(np.asarray(x)[wrong][0]) for x in (given, value))
                owner = "its motors" if name in ("velocity_limit", "effort_limit") else "its model"
                raise self._error(
                    f"{name}{of} is {own:.6g}, but {expected:.6g} in {owner}; correct it, "
                    f"or give {name}=None for the latter"
                )

    def _found_in_model(self) -> Iterator[tuple[str, Any]]:
        """Yield the fields that restate the model or the motors, with their values there."""
        low, high = self.skeleton.model.jnt_range[1:].T
        motors = self.motors.of_joints(self.joint_kinds)
        yield "joint_position_low", low.copy()
        yield "joint_position_high", high.copy()
        outside = (self.stance < self.joint_position_low) | (self.stance > self.joint_position_high)
        if outside.any():  # before the height, which would be another one
            raise self._error(
                f"the stance must be within the joint limits; {self.joint_names[outside.argmax()]} is not"
            )
        yield "velocity_limit", np.array([motor.no_load_speed for motor in motors])
        yield "effort_limit", np.array([motor.stall_torque for motor in motors])
        radii = self.skeleton.foot_radii(self.stance)
        if self.foot_radius is None and (np.isnan(radii).any() or np.ptp(radii) > _SIX_DIGITS):
            raise self._error(f"foot_radius does not follow from the shapes at the feet ({short(radii)} m); give it")
        yield "foot_radius", self.foot_radius if np.isnan(radii).any() else float(radii[0])
        yield "stance_height", self.foot_radius - float(self.stance_feet[:, 2].min())

    @property
    def total_mass(self) -> float:
        """Mass of the whole robot, kg."""
        return self.skeleton.total_mass

    def forward_kinematics(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> dict[str, Pose]:
        """Return the pose of every link; see `Skeleton.forward_kinematics`."""
        return self.skeleton.forward_kinematics(positions, base_pose)

    def sole_heights(self, positions: ArrayLike, base_pose: ArrayLike) -> Floats:
        """Return the height of each foot's lowest point (..., L), m; arguments as in `forward_kinematics`."""
        return self.skeleton.foot_centres(positions, base_pose)[..., 2] - self.foot_radius

    def to_dict(self) -> dict[str, Any]:
        """Return plain values for `from_dict` and JSON."""
        values = {
            entry.name: value.content() if isinstance(value, MotorConfig) else value
            for entry, value in self._content()
            if value is not None or entry.name not in _OPTIONAL
        }
        if self.assets is not None:
            values["assets"] = {name: base64.b64encode(content).decode() for name, content in self.assets.items()}
        return {name: plain(value) for name, value in values.items()}

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """Create a robot from the result of `to_dict`.

        Raises:
            QuadrupedError: if a field is missing or unknown, or as for `Robot`.
        """
        names = {entry.name for entry in fields(cls)}
        required = {entry.name for entry in fields(cls) if entry.default is dataclasses.MISSING}
        if not isinstance(values, Mapping) or not required <= set(values) <= names:
            raise QuadrupedError(f"robot: expected the fields {', '.join(sorted(names))}; found {short(values)}")
        made: dict[str, Any] = {
            name: tuple(value) if isinstance(value, (list, tuple)) and name not in _PER_JOINT else value
            for name, value in values.items()
        }
        if made.get("assets") is not None:
            made["assets"] = {name: base64.b64decode(text) for name, text in made["assets"].items()}
        motors: dict[str, Any] = {
            name: JointMotor(**value) if isinstance(value, Mapping) else value
            for name, value in values["motors"].items()
        }
        made["motors"] = MotorConfig(**motors)
        return cls(**made)

    @property
    def identity(self) -> dict[str, str]:
        """Name and SHA-256, as stored in a run's config and in policies."""
        return {"name": self.name, "sha256": self.sha256}

    @functools.cached_property
    def sha256(self) -> str:
        """SHA-256 of the content, without comments and layout of the model files, and without the URDF's sensors."""
        values = self.to_dict()
        # A URDF's sensors change neither the robot's motion nor what a policy observes.
        for name, ignored in (("mjcf", ()), ("urdf", ("sensor",))):
            if name not in values:
                continue
            try:
                values[name] = ElementTree.canonicalize(values[name], strip_text=True, exclude_tags=ignored)
            except ElementTree.ParseError as error:
                raise self._error(f"{name} is not XML ({error})") from error
        return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Robot) and (self is other or self.sha256 == other.sha256)

    def __hash__(self) -> int:
        return hash((self.name, self.joint_names, self.stance_height))  # without the model, which is long

    def __repr__(self) -> str:
        return f"Robot({self.name!r}, joints={self.num_joints}, sha256={self.sha256[:12]!r})"

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self  # nothing in it changes

    def __reduce__(self) -> tuple[Any, ...]:
        # Without the compiled models, which are many times larger and quickly compiled again.
        return functools.partial(type(self), **{entry.name: value for entry, value in self._content()}), ()

    def _content(self) -> list[tuple[dataclasses.Field[Any], Any]]:
        return [(entry, getattr(self, entry.name)) for entry in fields(self)]

    def _error(self, message: str) -> QuadrupedError:
        return QuadrupedError(f"robot {self.name!r}: {message}")


def _line(error: ValueError) -> str:
    """Return MuJoCo's message on one line, with the fix for meshes that it does not find."""
    text = " ".join(str(error).split())
    return f"{text}; meshes are searched next to a file: mjcf=Path(...)" if "opening file" in text else text


def check_same_robot(recorded: Any, robot: Robot) -> None:
    """Raise a QuadrupedError if a robot is not the one whose `identity` was recorded; None is not checked."""
    if recorded is None:
        return
    if not isinstance(recorded, Mapping) or not {"name", "sha256"} <= set(recorded):
        raise QuadrupedError(f"robot: expected name and sha256; found {short(recorded)}")
    if recorded != robot.identity:
        same = "another version of " if recorded["name"] == robot.name else ""
        raise QuadrupedError(
            f"this was made for {same}the robot {short(str(recorded['name']))} (SHA-256 "
            f"{short(str(recorded['sha256']))[:12]}), and the robot here is {robot!r}; name its file with --task FILE, "
            f"or pass robot=... or task_file=... in Python"
        )
