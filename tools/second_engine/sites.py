"""Sensors' sites of a robot's MJCF, on the links of the same robot in Drake."""

from dataclasses import dataclass
from typing import Final, Self

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError
from quadruped_env.utils import rotations
from quadruped_env.utils.arrays import Floats
from second_engine.drake_robot import BodyState, DrakeRobot

_SPHERE: Final = int(mujoco.mjtGeom.mjGEOM_SPHERE)
_BOX: Final = int(mujoco.mjtGeom.mjGEOM_BOX)


@dataclass(frozen=True)
class Site:
    """A site: where a sensor is on its link, and the zone of a touch sensor."""

    name: str
    link: str
    position: Floats
    """In the frame of the link (3,), m."""
    quaternion: Floats
    """Orientation wxyz in the frame of the link (4,)."""
    shape: int
    """MuJoCo's number of the zone's shape."""
    size: Floats
    """Radius of a sphere in the first place, half sides of a box (3,), m."""

    @classmethod
    def of_sensor(cls, model: mujoco.MjModel, sensor: str) -> Self:
        """Return the site of a sensor of the model."""
        site = model.site(int(model.sensor(sensor).objid[0]))
        link = model.body(int(site.bodyid[0])).name
        return cls(site.name, link, site.pos.copy(), site.quat.copy(), int(site.type[0]), site.size.copy())

    def motion(self, robot: DrakeRobot) -> BodyState:
        """Return the motion of the site; its rotation is its link's."""
        body = robot.body(self.link)
        arm = body.rotation @ self.position
        velocity = body.linear_velocity + np.cross(body.angular_velocity, arm)
        return body._replace(position=body.position + arm, linear_velocity=velocity)

    def acceleration(self, robot: DrakeRobot) -> Floats:
        """Return the acceleration in the last step (3,), in the world frame, m/s^2."""
        body = robot.body(self.link)
        arm = body.rotation @ self.position
        angular, linear = robot.acceleration(self.link)
        turning = np.cross(body.angular_velocity, np.cross(body.angular_velocity, arm))
        return linear + np.cross(angular, arm) + turning

    def holds(self, robot: DrakeRobot, link: str, point: Floats) -> bool:
        """Return True for a contact on the site's link at a point (3,) of the world within the zone.

        Raises:
            QuadrupedError: if the zone is neither a sphere nor a box.
        """
        if link != self.link:
            return False
        body = robot.body(link)
        from_site = body.rotation.T @ (point - body.position) - self.position
        if self.shape == _SPHERE:
            return float(np.linalg.norm(from_site)) <= self.size[0]
        if self.shape == _BOX:
            turned = rotations.rotate_inverse(self.quaternion, from_site)
            return bool((np.abs(turned) <= self.size).all())
        raise QuadrupedError(
            f"Drake: the site {self.name!r} of a touch sensor must be a sphere or a box; found "
            f"{mujoco.mjtGeom(self.shape).name}"
        )
