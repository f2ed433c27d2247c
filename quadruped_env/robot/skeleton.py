"""Kinematics of a robot: poses of its links and feet, transforms between its links, its resting pose on the ground."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import mujoco
import numpy as np
from mujoco.batch import Batch
from numpy.typing import ArrayLike, NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.fields import check
from quadruped_env.utils.rotations import from_axis_angle, multiply, rotate

Pose = tuple[Floats, Floats]

MAX_VALUE: Final = mujoco.mjMAXVAL
"""Maximum coordinate, above which MuJoCo treats a simulation as diverged, rad or m."""

_ORIGIN: Final = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
"""Position and quaternion wxyz of the base in its own frame."""
_BLOCK: Final = 4096
"""Poses per batch: enough to make Python's overhead negligible, few enough to fit in the processor's cache."""

_RIM: Final = 64
"""Points on the rim of a cylinder: its radius appears up to 0.1 % smaller."""


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


class Skeleton:
    """Bodies, joints and collision points of a robot, for kinematics at a third of the cost of the full model.

    The specification of the robot alone, from which the `whole` model was compiled, is changed.
    """

    def __init__(
        self,
        spec: mujoco.MjSpec,
        whole: mujoco.MjModel,
        joint_names: tuple[str, ...],
        link_names: tuple[str, ...],
        foot_sites: Sequence[str],
    ) -> None:
        self.joint_names, self.link_names = joint_names, link_names
        sites = [whole.site(name) for name in foot_sites]
        self.feet = [(whole.body(int(site.bodyid[0])).name, site.pos.copy()) for site in sites]
        """Link of each foot, and the foot's centre in the frame of that link, m."""
        self._collision = _collision_points(whole)
        for body in spec.bodies[1:]:
            if not body.explicitinertial:  # inferred from the geoms, which are deleted
                compiled = whole.body(body.name)
                body.explicitinertial = True
                body.mass, body.inertia = compiled.mass[0], compiled.inertia.copy()
                body.ipos, body.iquat = compiled.ipos.copy(), compiled.iquat.copy()
        for elements in (spec.sensors, spec.actuators, spec.pairs, spec.keys, spec.sites, spec.geoms, spec.cameras):
            for element in list(elements):
                spec.delete(element)
        self.model = spec.compile()
        """Model with only the robot's bodies and joints."""
        self.total_mass = float(self.model.body_mass.sum())
        """Sum of all masses, kg."""
        self.leg_joints = tuple(self._joints_up_to(link) for link, _ in self.feet)
        """See `Robot.leg_joints`."""
        self.hinges: NDArray[np.bool_] = self.model.jnt_type[1:] == mujoco.mjtJoint.mjJNT_HINGE
        """True for each joint that turns, False for a slide (J,)."""

    def _joints_up_to(self, link: str) -> tuple[int, ...]:
        """Return the indices of the joints between the base and a link, from the base on."""
        model, body, joints = self.model, self.model.body(link).id, []
        while body != model.body(self.link_names[0]).id:
            # Joint 0 is the free joint of the base.
            joints += [model.body_jntadr[body] - 1 + i for i in reversed(range(model.body_jntnum[body]))]
            body = model.body_parentid[body]
        return tuple(int(joint) for joint in reversed(joints))

    def forward_kinematics(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> dict[str, Pose]:
        """Return the pose of every link, computed with MuJoCo's kinematics.

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
        links = [self.model.body(name).id for name in self.link_names]
        xpos, xquat = (values[..., links, :] for values in self._computed(positions, base_pose, "xpos", "xquat"))
        return {name: (xpos[..., i, :], xquat[..., i, :]) for i, name in enumerate(self.link_names)}

    def joint_frames(self, positions: ArrayLike) -> tuple[Floats, Floats]:
        """Return the points about which the joints turn, in m, and their axes, (..., J, 3) each, in the base frame.

        Arguments and errors are as in `forward_kinematics`.
        """
        anchors, axes = (values[..., 1:, :] for values in self._computed(positions, None, "xanchor", "xaxis"))
        return anchors, axes

    def _computed(self, positions: ArrayLike, base_pose: ArrayLike | None, *names: str) -> list[Floats]:
        """Return fields of MuJoCo's data (..., rows, columns); arguments and errors are as in `forward_kinematics`."""
        num_joints = len(self.joint_names)
        joints = np.asarray(positions, dtype=np.float64)
        base = np.asarray(_ORIGIN if base_pose is None else base_pose, dtype=np.float64)
        rule, both = f"of shape (..., {num_joints}), one value per joint", "forward_kinematics: positions and base_pose"
        check(joints.shape[-1:] == (num_joints,), "forward_kinematics: positions", joints.shape, rule)
        check(base.shape[-1:] == (7,), "forward_kinematics: base_pose", base.shape, "of shape (..., 7), xyz and wxyz")
        try:
            leading = np.broadcast_shapes(joints.shape[:-1], base.shape[:-1])
        except ValueError as error:
            raise QuadrupedError(f"{both}: their shapes {joints.shape} and {base.shape} do not fit") from error
        joints = np.broadcast_to(joints, (*leading, num_joints)).reshape(-1, num_joints)
        base = np.broadcast_to(base, (*leading, 7)).reshape(-1, 7)
        for values in (joints, base):
            # The minimum and maximum of an array with NaN are NaN, and comparisons with NaN are false.
            if values.size and not (values.min() >= -MAX_VALUE and values.max() <= MAX_VALUE):
                wrong = values[~(np.abs(values) <= MAX_VALUE)][0]
                raise QuadrupedError(f"{both} must be finite and within {MAX_VALUE:g}; found {wrong:g}")
        if not base[:, 3:].any(axis=1).all():
            raise QuadrupedError("forward_kinematics: base_pose has a zero quaternion; identity is (1, 0, 0, 0)")

        batch = Batch(self.model, max(1, min(_BLOCK, len(joints))), nthread=1)
        qpos, fields = batch.bind("qpos"), [batch.bind(name) for name in names]
        found = [np.empty((len(joints), *field.shape[1:])) for field in fields]
        for start in range(0, len(joints), batch.nsim):
            block = slice(start, min(start + batch.nsim, len(joints)))
            count = block.stop - start
            qpos[:count, :7], qpos[:count, 7:] = base[block], joints[block]
            batch.forward(None if count == batch.nsim else np.arange(count), stage=mujoco.mjtStage.mjSTAGE_POS)
            for values, field in zip(found, fields, strict=True):
                values[block] = field[:count]
        return [values.reshape(*leading, *values.shape[1:]) for values in found]

    def foot_centres(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> Floats:
        """Return the centres of the foot balls (..., L, 3) in m, in the order of `leg_names`.

        Arguments and errors are as in `forward_kinematics`.
        """
        return self._points(self.feet, self.forward_kinematics(positions, base_pose))

    def foot_jacobians(self, positions: ArrayLike) -> Floats:
        """Return derivatives (..., L, 3, J) in m/rad of the foot centres in the base frame by the joint positions.

        Arguments and errors are as in `forward_kinematics`.
        """
        feet, (anchors, axes) = self.foot_centres(positions), self.joint_frames(positions)
        arms = feet[..., :, None, :] - anchors[..., None, :, :]
        axes = np.broadcast_to(axes[..., None, :, :], arms.shape)
        moved = np.where(self.hinges[:, None], np.cross(axes, arms), axes)
        own = [np.isin(np.arange(len(self.joint_names)), joints) for joints in self.leg_joints]
        return np.where(np.array(own)[..., None], moved, 0.0).swapaxes(-1, -2)

    def foot_radii(self, positions: ArrayLike) -> Floats:
        """Return the distance (L,) of each foot's centre from its link's lowest point, m; NaN without a shape."""
        (points, radii), poses = self._collision, self.forward_kinematics(positions)
        heights = self._points(points, poses)[..., 2] - radii if points else np.zeros(0)
        found = []
        for link, centre in self.feet:
            own = [height for (of, _), height in zip(points, heights, strict=True) if of == link]
            found.append(self._points([(link, centre)], poses)[0, 2] - min(own, default=np.nan))
        return np.array(found)

    def lowest(self, positions: ArrayLike, up: Floats) -> float:
        """Return the height of the robot's lowest point over its base's centre, m, for joint positions (J,) in rad.

        The height is along `up`, a unit vector (3,) in the base frame.
        """
        points, radii = self._collision
        return float((self._points(points, self.forward_kinematics(positions)) @ up - radii).min())

    def centre_of_mass(self, positions: ArrayLike) -> Floats:
        """Return the centre of mass of the robot (3,) in the base frame, m, for joint positions (J,) in rad."""
        data = mujoco.MjData(self.model)
        data.qpos[:7], data.qpos[7:] = _ORIGIN, positions
        mujoco.mj_kinematics(self.model, data)
        mujoco.mj_comPos(self.model, data)
        return data.subtree_com[self.model.body(self.link_names[0]).id].copy()

    def resting_pose(self, positions: ArrayLike) -> Floats:
        """Return the pose of the base with the robot resting on its feet, above the origin and facing along x.

        Position in m and quaternion wxyz (7,), for joint positions (J,) in rad.

        The three feet whose support triangle contains the centre of mass touch the ground; every other foot touches it
        or is in the air. If no three feet can carry the robot, its base is level. If another part would penetrate the
        ground, the robot is raised until that part rests on the ground.

        Raises:
            QuadrupedError: as `forward_kinematics`.
        """
        up = _support_normal(self.foot_centres(positions), self.centre_of_mass(positions))
        # World axes in the base frame: z is the ground's normal, and x is as close as possible to the base's x axis.
        y = np.cross(up, [1.0, 0.0, 0.0])
        y /= np.linalg.norm(y)
        pose = np.zeros(7)
        mujoco.mju_mat2Quat(pose[3:], np.stack([np.cross(y, up), y, up]).ravel())
        pose[2] = -self.lowest(positions, up)
        return pose

    def joint_transforms(self, positions: ArrayLike, base_pose: ArrayLike | None = None) -> tuple[Transform, ...]:
        """Return the transforms that `robot_state_publisher` sends on `/tf`: one per joint, from parent to child link.

        They have leading axes (...), for positions (..., J) and base poses (..., 7) as in `forward_kinematics`. With
        poses the first one places the base in `ODOMETRY_FRAME`, which `robot_state_publisher` does not send.

        Raises:
            QuadrupedError: if a shape is wrong or a value is not finite.
        """
        joints, base = np.asarray(positions, np.float64), np.asarray(base_pose, np.float64)
        model, names, transforms = self.model, self.joint_names, []
        valid = joints.shape[-1:] == (len(names),) and bool(np.isfinite(joints).all())
        check(valid, "joint_transforms: positions", joints.shape, f"finite, of shape (..., {len(names)})")
        if base_pose is not None:
            shape = (*joints.shape[:-1], 7)
            valid = base.shape == shape and bool(np.isfinite(base).all())
            check(valid, "joint_transforms: base_pose", base.shape, f"finite, of shape {shape}")
            transforms.append(Transform(ODOMETRY_FRAME, self.link_names[0], base[..., :3], base[..., 3:]))
        for column, name in enumerate(names):
            joint = model.joint(name)
            body = int(joint.bodyid[0])
            rotation = from_axis_angle(model.jnt_axis[joint.id], joints[..., column])
            place = np.tile(model.body_pos[body], (*joints.shape[:-1], 1))
            transforms.append(Transform(*_links(model, body), place, multiply(model.body_quat[body], rotation)))
        return tuple(transforms)

    def fixed_transforms(self) -> tuple[Transform, ...]:
        """Return the transforms that `robot_state_publisher` sends once on `/tf_static`: one per link without a joint.

        If every link has a joint, the result is empty; the publisher then sends an empty message.
        """
        model = self.model
        fixed = [body for body in range(1, model.nbody) if not model.body_jntnum[body]]
        return tuple(
            Transform(*_links(model, body), model.body_pos[body].copy(), model.body_quat[body].copy()) for body in fixed
        )

    @staticmethod
    def _points(points: Sequence[tuple[str, Floats]], poses: dict[str, Pose]) -> Floats:
        """Return the positions (..., P, 3) of points that are given by link and position in the link's frame, m."""
        found = []
        for link, point in points:
            origin, orientation = poses[link]
            found.append(origin + rotate(orientation, point))
        return np.stack(found, axis=-2)


def _links(model: mujoco.MjModel, body: int) -> tuple[str, str]:
    """Return the names of a body's parent and of the body."""
    return model.body(model.body_parentid[body]).name, model.body(body).name


def _support_normal(feet: Floats, centre: Floats) -> Floats:
    """Return the normal of the ground (3,) in the base frame, for feet (L, 3) and a centre of mass (3,)."""
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


def _collision_points(model: mujoco.MjModel) -> tuple[list[tuple[str, Floats]], Floats]:
    """Return the points by link and radii (P,) of the balls whose convex hulls are the collision shapes."""
    points: list[tuple[str, Floats]] = []
    radii: list[float] = []
    for geom in np.flatnonzero(model.geom_contype | model.geom_conaffinity):
        local, radius = _balls(model, int(geom))
        quaternion, link = model.geom_quat[geom], model.body(int(model.geom_bodyid[geom])).name
        for point in local:
            # Rounded, because MuJoCo states centre and half length where a model states the two ends.
            points.append((link, np.round(rotate(quaternion, point) + model.geom_pos[geom], 12)))
            radii.append(radius)
    return points, np.array(radii)


def _balls(model: mujoco.MjModel, geom: int) -> tuple[Floats, float]:
    """Return the centres (P, 3) in the frame of a geom, and the radius, of the balls whose convex hull is its shape."""
    kind, size = model.geom_type[geom], model.geom_size[geom]
    signs = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return np.zeros((1, 3)), float(size[0])
    if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return np.array([[0.0, 0.0, -size[1]], [0.0, 0.0, size[1]]]), float(size[0])
    if kind == mujoco.mjtGeom.mjGEOM_BOX:
        return signs * size, 0.0
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        angle = np.linspace(0.0, 2.0 * np.pi, _RIM, endpoint=False)
        rim = np.stack([size[0] * np.cos(angle), size[0] * np.sin(angle), np.full(_RIM, size[1])], axis=1)
        return np.concatenate([rim, rim * [1.0, 1.0, -1.0]]), 0.0
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = model.geom_dataid[geom]
        start = model.mesh_vertadr[mesh]
        return model.mesh_vert[start : start + model.mesh_vertnum[mesh]].astype(np.float64), 0.0
    return np.zeros((1, 3)), float(model.geom_rbound[geom])
