"""Poses of a robot's links and feet, transforms between its links, and its resting pose on level ground."""

import abc
import itertools
from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from quadruped_env.errors import QuadrupedError
from quadruped_env.robot.skeleton import Pose, Skeleton
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.rotations import from_axis_angle, multiply

ODOMETRY_FRAME: Final = "odom"
"""Parent frame of `base_link` if the pose of the base is known; the name is from REP 105."""
_EDGE: Final = 1e-9
"""Tolerance for rounding errors: distance that the centre of mass may lie outside the support polygon, m."""


@dataclass(frozen=True)
class Transform:
    """Pose of a link in the frame of its parent, over time or constant."""

    parent: str
    child: str
    translation: Floats
    """Translation (..., 3), m."""
    rotation: Floats
    """Quaternion wxyz (..., 4); ROS messages use the order xyzw."""


class Kinematics(abc.ABC):
    """Kinematics of a robot with J joints and L legs."""

    foot_radius: float

    @property
    @abc.abstractmethod
    def skeleton(self) -> Skeleton:
        """Bodies and joints of the robot."""

    @property
    def total_mass(self) -> float:
        """Mass of the whole robot, kg."""
        return self.skeleton.total_mass

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

        Arguments and errors are as in `forward_kinematics`.
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
        up = _support_normal(self.foot_centres(positions), self.centre_of_mass(positions))
        # World axes in the base frame: z is the ground's normal, and x is as close as possible to the base's x axis.
        y = np.cross(up, [1.0, 0.0, 0.0])
        y /= np.linalg.norm(y)
        pose = np.zeros(7)
        mujoco.mju_mat2Quat(pose[3:], np.stack([np.cross(y, up), y, up]).ravel())
        pose[2] = -self.skeleton.lowest(positions, up)
        return pose

    def joint_transforms(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> tuple[Transform, ...]:
        """Transforms that `robot_state_publisher` sends on `/tf`: one per moving joint, from parent to child link.

        Args:
            positions: joint positions in rad, shape (..., J).
            base_pose: position in m and quaternion wxyz of the base in the world, shape (..., 7). With it the first
                transform places the base in `ODOMETRY_FRAME`, which `robot_state_publisher` does not send.

        Returns:
            Transforms with leading axes (...), in the order of `joint_names`.

        Raises:
            QuadrupedError: if a shape is wrong or a value is not finite.
        """
        joints, base = np.asarray(positions, np.float64), np.asarray(base_pose, np.float64)
        model, names, transforms = self.skeleton.model, self.skeleton.joint_names, []
        if joints.ndim == 0 or joints.shape[-1] != len(names) or not np.isfinite(joints).all():
            raise QuadrupedError(
                f"joint_transforms: positions must be finite, of shape (..., {len(names)}); found {joints.shape}"
            )
        if base_pose is not None:
            if base.shape != (*joints.shape[:-1], 7) or not np.isfinite(base).all():
                raise QuadrupedError(
                    f"joint_transforms: base_pose must be finite, of shape {(*joints.shape[:-1], 7)}; "
                    f"found {base.shape}"
                )
            transforms.append(Transform(ODOMETRY_FRAME, self.skeleton.link_names[0], base[..., :3], base[..., 3:]))
        for column, name in enumerate(names):
            joint = model.joint(name)
            body = int(joint.bodyid[0])
            rotation = from_axis_angle(model.jnt_axis[joint.id], joints[..., column])
            place = np.tile(model.body_pos[body], (*joints.shape[:-1], 1))
            transforms.append(Transform(*_links(model, body), place, multiply(model.body_quat[body], rotation)))
        return tuple(transforms)

    def fixed_transforms(self) -> tuple[Transform, ...]:
        """Transforms that `robot_state_publisher` sends once on `/tf_static`: one per link without a joint.

        If every link has a joint, the result is empty; the publisher then sends an empty message.
        """
        model = self.skeleton.model
        fixed = [body for body in range(1, model.nbody) if not model.body_jntnum[body]]
        return tuple(
            Transform(*_links(model, body), model.body_pos[body].copy(), model.body_quat[body].copy()) for body in fixed
        )


def _links(model: mujoco.MjModel, body: int) -> tuple[str, str]:
    """Names of a body's parent and of the body."""
    return model.body(model.body_parentid[body]).name, model.body(body).name


def _support_normal(feet: Floats, centre: Floats) -> Floats:
    """Normal of the ground (3,) in the base frame, for feet (L, 3) and a centre of mass (3,)."""
    for i, j, k in itertools.combinations(range(len(feet)), 3):
        normal = np.cross(feet[j] - feet[i], feet[k] - feet[i])
        length = np.linalg.norm(normal)
        if length < _EDGE:
            continue
        normal *= np.sign(normal[2]) / length
        if normal[2] <= 0.0 or ((feet - feet[i]) @ normal).min() < -_EDGE:
            continue
        corners = feet[[i, j, k]]
        # In projection along the normal, the centre of mass lies on the same side of all three edges.
        sides = [np.cross(b - a, centre - a) @ normal for a, b in itertools.pairwise([*corners, corners[0]])]
        if min(sides) >= -_EDGE or max(sides) <= _EDGE:
            return normal
    return np.array([0.0, 0.0, 1.0])
