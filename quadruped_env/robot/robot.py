"""Description of a robot, which other packages receive as an argument."""

import dataclasses
import functools
import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Self
from xml.etree import ElementTree

import mujoco
import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.robot import link_transforms, resting_pose
from quadruped_env.robot.link_transforms import Transform
from quadruped_env.robot.motors import JOINT_KINDS, JointMotor, MotorConfig
from quadruped_env.robot.skeleton import Pose, Skeleton
from quadruped_env.utils.plain import plain

Floats = NDArray[np.float64]

_PER_JOINT = ("joint_position_low", "joint_position_high", "velocity_limit", "effort_limit", "stance")
_OPTIONAL = ("motor_kinds", "mirror_signs", "leg_corners", "gaits")
"""Fields that may be None; then they are not part of the content, so that robots without them keep their identity."""
_MIRROR_TOLERANCE = 1e-3
"""Difference between an axis and its mirror image, as 1 - |cosine|, about 2.5 degrees."""
_FOOTPRINT = 4.0 / 3.0
"""Footprint as a multiple of the distance of the farthest foot in the stance; at a start the legs deviate from it."""
_LIMIT_TOLERANCE = 1e-9
"""Difference between a limit in the model and in the robot, rad."""


@dataclass(frozen=True, eq=False, repr=False)
class Robot:
    """A legged robot as a value: names, limits, stance, symmetry, motors, and its model as text.

    Arrays are read-only and in the order of `joint_names` or `leg_names`, which is the order of the model. Masses and
    kinematics are computed from the model, which is compiled when it is first needed. Two robots are equal if their
    content is; comments and layout of the model files do not count.

    Raises:
        QuadrupedError: if the fields contradict each other, or (at the first use of the model) the model.
    """

    name: str
    leg_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    """Names of the joints, and of their motors in the model's order."""
    link_names: tuple[str, ...]
    """Names of the links, the base first."""
    joint_position_low: Floats
    """Lower limits of the joint positions (J,), rad."""
    joint_position_high: Floats
    """Upper limits of the joint positions (J,), rad."""
    velocity_limit: Floats
    """Maximum joint speeds without load (J,), rad/s."""
    effort_limit: Floats
    """Maximum joint torques at rest (J,), N m."""
    stance: Floats
    """Joint positions with each foot under its hip (J,), rad."""
    stance_height: float
    """Height of the base's centre in the stance, with the feet on the ground, m."""
    foot_radius: float
    """Radius of the feet, which are balls, m."""
    foot_sites: tuple[str, ...]
    """Sites of the model at the centres of the feet, one per leg."""
    joint_mirror: tuple[int, ...]
    """Index of each joint's counterpart on the other side; `joint_signs` says which of them turn the other way."""
    foot_mirror: tuple[int, ...]
    """Index of each foot's counterpart on the other side."""
    sensors: Mapping[str, tuple[str, ...]]
    """Sensors of the model for each field of `quadruped_env.robot.readings.Readings`, in order."""
    motors: MotorConfig
    """Motors of the model."""
    mjcf: str
    """MuJoCo model of the robot alone, with a floating base and without ground."""
    urdf: str
    """Description for ROS (`robot_description`)."""
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
    them. None: the presets, mapped to the robot."""

    def __post_init__(self) -> None:
        for name in _PER_JOINT:
            values = np.array(getattr(self, name), dtype=np.float64)
            if values.shape != (self.num_joints,) or not np.isfinite(values).all():
                raise self._error(
                    f"{name} must be {self.num_joints} finite numbers, one per joint; found {short(values)}"
                )
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        try:
            sensors = {key: tuple(names) for key, names in self.sensors.items()}
        except (AttributeError, TypeError) as error:
            raise self._error(
                f"sensors must be a dict of field -> names of the model's sensors; found {short(self.sensors)}"
            ) from error
        object.__setattr__(self, "sensors", sensors)
        for name, length, what in (
            ("foot_sites", self.num_legs, "leg"),
            ("foot_mirror", self.num_legs, "leg"),
            ("joint_mirror", self.num_joints, "joint"),
        ):
            if len(getattr(self, name)) != length:
                raise self._error(f"{name} must have {length} entries, one per {what}; found {getattr(self, name)!r}")
        self._check_given()
        for names in (self.leg_names, self.joint_names, self.link_names):
            if len(set(names)) < len(names):
                raise self._error(f"names must differ; found {names!r}")
        outside = (self.stance < self.joint_position_low) | (self.stance > self.joint_position_high)
        if outside.any():
            raise self._error(
                f"the stance must be within the joint limits; {self.joint_names[outside.argmax()]} is not"
            )

    def _check_given(self) -> None:
        """Check the optional fields, and make them plain."""
        for name, length, allowed in (
            ("motor_kinds", self.num_joints, JOINT_KINDS),
            ("mirror_signs", self.num_joints, (1, -1)),
            ("leg_corners", self.num_legs, (0, 1, 2, 3)),
        ):
            given = getattr(self, name)
            if given is None:
                continue
            if (
                not isinstance(given, list | tuple | np.ndarray)
                or len(given) != length
                or any(x not in allowed for x in given)
            ):
                raise self._error(f"{name} must be {length} of {', '.join(map(str, allowed))}; found {given!r}")
            object.__setattr__(self, name, tuple(given))
        if self.gaits is not None:
            if not isinstance(self.gaits, Mapping):
                raise self._error(f"gaits must be a dict of preset -> parameters; found {short(self.gaits)}")
            object.__setattr__(self, "gaits", plain(dict(self.gaits)))

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
        return len(self.leg_names)

    @property
    def num_positions(self) -> int:
        """Length of MuJoCo's `qpos`: the base's position (3,) and quaternion wxyz (4,), then the joints."""
        return 7 + self.num_joints

    @property
    def num_velocities(self) -> int:
        """Length of MuJoCo's `qvel`: the base's linear (3,) and angular (3,) velocity, then the joints."""
        return 6 + self.num_joints

    @property
    def total_mass(self) -> float:
        """Mass of the whole robot, kg."""
        return self.skeleton.total_mass

    @functools.cached_property
    def model(self) -> mujoco.MjModel:
        """The robot alone, compiled once; it must not be changed."""
        model = self.spec().compile()
        self.check_model(model)
        return model

    @functools.cached_property
    def stance_feet(self) -> Floats:
        """Centres of the feet in the stance (L, 3), in the base frame, m."""
        data = mujoco.MjData(self.model)
        data.qpos[:7], data.qpos[7:] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], self.stance
        mujoco.mj_kinematics(self.model, data)
        return np.array([data.site(site).xpos for site in self.foot_sites])

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
        x, y = self.stance_feet[:, 0], self.stance_feet[:, 1]
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
    def joint_kinds(self) -> tuple[str, ...]:
        """Kind of each joint (J,), which is its motor in a `MotorConfig`: `motor_kinds`, or by its place in the leg.

        The last joint of a leg of two or more is a knee, and every other joint is a hip.
        """
        if self.motor_kinds is not None:
            return self.motor_kinds
        knees = {joints[-1] for joints in self.leg_joints if len(joints) > 1}
        return tuple(JOINT_KINDS[joint in knees] for joint in range(self.num_joints))

    @functools.cached_property
    def joints_by_kind(self) -> Mapping[str, list[int]]:
        """Indices of the joints of each kind (`hip`, `knee`), which have the same motors, in order of appearance."""
        kinds: dict[str, list[int]] = {}
        for joint, kind in enumerate(self.joint_kinds):
            kinds.setdefault(kind, []).append(joint)
        return kinds

    @functools.cached_property
    def joint_signs(self) -> NDArray[np.float32]:
        """Factor from each joint's position to its counterpart's under the left/right mirror (J,), 1 or -1.

        It is `mirror_signs`, or follows from the axes in the stance: the mirror y -> -y turns the axis (x, y, z) of a
        hinge into (-x, y, -z), and that of a slide into (x, -y, z).

        Raises:
            QuadrupedError: if a joint's axis is not the mirror image of its counterpart's.
        """
        if self.mirror_signs is not None:
            return np.array(self.mirror_signs, dtype=np.float32)
        axes, hinges = self.skeleton.joint_axes(self.stance)
        images = axes * np.where(hinges[:, None], [-1.0, 1.0, -1.0], [1.0, -1.0, 1.0])
        cosines = (images * axes[list(self.joint_mirror)]).sum(axis=-1)
        wrong = np.abs(cosines) < 1.0 - _MIRROR_TOLERANCE
        if wrong.any():
            joint = int(wrong.argmax())
            raise self._error(
                f"the axis of {self.joint_names[joint]} is not the mirror image of that of "
                f"{self.joint_names[self.joint_mirror[joint]]}, its counterpart in joint_mirror; correct joint_mirror, "
                f"or give mirror_signs"
            )
        return np.sign(cosines).astype(np.float32)

    def spec(self) -> mujoco.MjSpec:
        """A new specification of the robot alone, to be changed and compiled.

        Raises:
            QuadrupedError: if MuJoCo cannot read the MJCF, or it has a ground or another geom of the world.
        """
        try:
            spec = mujoco.MjSpec.from_string(self.mjcf)
        except ValueError as error:
            raise self._error(f"MuJoCo cannot read its MJCF ({error})") from error
        if fixed := _fixed_geoms(spec.worldbody, self.base_name):
            raise self._error(
                f"its MJCF must hold the robot alone, because the scene adds the ground, and a second one would double "
                f"every contact; found a {fixed[0].type.name[7:].lower()} {fixed[0].name!r} fixed to the world: "
                f"remove it, and choose the ground with terrain=... or --terrain"
            )
        return spec

    @functools.cached_property
    def skeleton(self) -> Skeleton:
        """Kinematics of the robot; computed once."""
        return Skeleton(self.spec(), self.model, self.joint_names, self.link_names, self.foot_sites)

    def check_model(self, model: mujoco.MjModel) -> None:
        """Check that a compiled model holds this robot.

        Raises:
            QuadrupedError: if joints, motors, links, sites or sensors are missing or in another order, or a limit
                differs.
        """
        free = [i for i in range(model.njnt) if model.jnt_type[i] == mujoco.mjtJoint.mjJNT_FREE]
        if free != [0]:
            raise self._error(f"its model must have one free joint, the first; found free joints at {free}")
        joints = tuple(model.joint(i).name for i in range(1, model.njnt))
        motors = tuple(model.joint(int(model.actuator_trnid[i, 0])).name for i in range(model.nu))
        for what, found in (("joints", joints), ("motors", motors)):
            if found != self.joint_names:
                raise self._error(
                    f"the {what} of its model are in the order {', '.join(found)}; joint_names has "
                    f"{', '.join(self.joint_names)}: give all fields in the model's order"
                )
        for kind, names in (
            ("body", self.link_names),
            ("site", self.foot_sites),
            ("sensor", [name for group in self.sensors.values() for name in group]),
        ):
            for name in names:
                if mujoco.mj_name2id(model, getattr(mujoco.mjtObj, f"mjOBJ_{kind.upper()}"), name) < 0:
                    raise self._error(f"its model has no {kind} {name!r}")
        limits = np.stack([self.joint_position_low, self.joint_position_high], axis=1)
        wrong = np.abs(model.jnt_range[1:] - limits).max(axis=1) > _LIMIT_TOLERANCE
        if wrong.any():
            raise self._error(
                f"joint_position_low and joint_position_high differ from the model's range at "
                f"{self.joint_names[wrong.argmax()]}"
            )

    def forward_kinematics(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> dict[str, Pose]:
        """Pose of every link, computed with MuJoCo's kinematics.

        Args:
            positions: joint positions in rad, shape (..., J).
            base_pose: position in m and quaternion wxyz of the base in the world, shape (..., 7); without it the
                poses are in the frame of the base. Leading axes of both arguments broadcast.

        Returns:
            Position (..., 3) in m and quaternion wxyz (..., 4) of each link by name, in the order of `link_names`.

        Raises:
            QuadrupedError: if the last axis is not J (or 7), the other axes do not broadcast, a value is not finite, or
                a quaternion is zero.
        """
        return self.skeleton.forward_kinematics(positions, base_pose)

    def foot_centres(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> Floats:
        """Centres of the foot balls (..., L, 3) in m, in the order of `leg_names`.

        Arguments and errors are those of `forward_kinematics`.
        """
        return self.skeleton.foot_centres(positions, base_pose)

    def sole_heights(self, positions: ArrayLike, base_pose: ArrayLike) -> Floats:
        """Height of each foot's lowest point above the ground (..., L) in m; arguments as in `forward_kinematics`."""
        return self.foot_centres(positions, base_pose)[..., 2] - self.foot_radius

    def foot_jacobians(self, positions: ArrayLike) -> Floats:
        """Derivatives of the foot centres in the base frame by the joint positions (L, 3, J), m/rad, at (J,) in rad."""
        return self.skeleton.foot_jacobians(positions)

    def centre_of_mass(self, positions: ArrayLike) -> Floats:
        """Centre of mass of the robot (3,) in the base frame, m, for joint positions (J,) in rad."""
        return self.skeleton.centre_of_mass(positions)

    def resting_pose(self, positions: ArrayLike) -> Floats:
        """Pose (7,) of the base with the robot resting on its feet, above the origin and facing along x.

        The three feet whose support triangle contains the centre of mass touch the ground; every other foot touches it
        or is in the air. If no three feet can carry the robot, its base is level. If another part would penetrate the
        ground, the robot is raised until that part rests on the ground.

        Args:
            positions: joint positions in rad (J,).

        Returns:
            Position in m and quaternion wxyz.

        Raises:
            QuadrupedError: as `forward_kinematics`.
        """
        return resting_pose.resting_pose(self.skeleton, positions)

    def joint_transforms(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> tuple[Transform, ...]:
        """Transforms that `robot_state_publisher` sends on `/tf`: one per moving joint, from parent to child link.

        Args:
            positions: joint positions in rad, shape (..., J).
            base_pose: position in m and quaternion wxyz of the base in the world, shape (..., 7). With it the first
                transform is that of the base in `ODOMETRY_FRAME`, which `robot_state_publisher` does not send.

        Returns:
            Transforms with leading axes (...), in the order of `joint_names`.

        Raises:
            QuadrupedError: if a shape is wrong or a value is not finite.
        """
        return link_transforms.joint_transforms(self.skeleton, positions, base_pose)

    def fixed_transforms(self) -> tuple[Transform, ...]:
        """Transforms that `robot_state_publisher` sends once on `/tf_static`: one per link without a joint.

        If every link has a joint, the result is empty; the publisher then sends an empty message.
        """
        return link_transforms.fixed_transforms(self.skeleton)

    def to_dict(self) -> dict[str, Any]:
        """Plain values for `from_dict` and JSON."""
        return {
            entry.name: value.to_dict() if isinstance(value, MotorConfig) else plain(value)
            for entry, value in self._content()
            if value is not None or entry.name not in _OPTIONAL
        }

    @classmethod
    def from_dict(cls, values: Mapping[str, Any]) -> Self:
        """Create a robot from the result of `to_dict`.

        Raises:
            QuadrupedError: if a field is missing or unknown, or as for `Robot`.
        """
        names = {entry.name for entry in fields(cls)}
        if not isinstance(values, Mapping) or not names - set(_OPTIONAL) <= set(values) <= names:
            raise QuadrupedError(f"robot: expected the fields {', '.join(sorted(names))}; found {short(values)}")
        made: dict[str, Any] = {
            name: tuple(value) if isinstance(value, (list, tuple)) and name not in _PER_JOINT else value
            for name, value in values.items()
        }
        motors = values["motors"]
        made["motors"] = MotorConfig(JointMotor(**motors["hip"]), JointMotor(**motors["knee"]), motors["delay"])
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
        return type(self), tuple(value for _, value in self._content())

    def _content(self) -> list[tuple[dataclasses.Field[Any], Any]]:
        return [(entry, getattr(self, entry.name)) for entry in fields(self)]

    def _error(self, message: str) -> QuadrupedError:
        return QuadrupedError(f"robot {self.name!r}: {message}")


def _fixed_geoms(body: mujoco.MjsBody, base: str) -> list[mujoco.MjsGeom]:
    """Geoms of a body and of all that is fixed to it, except the robot's base."""
    fixed = list(body.geoms)
    for child in body.bodies:
        if child.name != base and not child.joints:
            fixed += _fixed_geoms(child, base)
    return fixed


def check_same_robot(recorded: Any, robot: Robot) -> None:
    """Check that a robot is the recorded one.

    Args:
        recorded: a robot's `identity`; None is not checked.
        robot: robot to compare.

    Raises:
        QuadrupedError: if they are not the same.
    """
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
