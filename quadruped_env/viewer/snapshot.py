"""Snapshots of the viewer's state, which are drawn while the simulation continues."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quadruped_env.simulation import Terrain
from quadruped_env.viewer.viewed_robot import Offered, ViewedRobot, ViewedTrace, heading


@dataclass(frozen=True)
class RobotView:
    """Snapshot of a robot to draw; all arrays are copies."""

    name: str
    """Name of its source, with a number if another robot has the same."""
    follows_command: bool
    body_position: NDArray[np.float64]
    """Body positions in the world frame (bodies, 3), m."""
    body_rotation: NDArray[np.float64]
    """Body rotation matrices in the world frame (bodies, 3, 3)."""
    heading: float
    """Heading from the world's x axis, rad."""
    contact_points: NDArray[np.float64]
    """Contact points in the world frame (K, 3), m."""
    contact_forces: NDArray[np.float64]
    """Contact forces in the world frame (K, 3), N."""
    history: tuple[ViewedTrace, ...]
    """Samples of the last seconds, oldest first."""
    term_names: tuple[str, ...]
    """Names of the samples' reward terms."""
    complaints: tuple[str, ...]
    """Descriptions of the joint limits that its gait exceeds."""
    fell_at: float | None
    """Episode time of the fall, s; None if it has not fallen."""

    @property
    def now(self) -> ViewedTrace:
        """The latest sample."""
        return self.history[-1]


@dataclass(frozen=True)
class View:
    """Snapshot of the whole viewer state."""

    time: float
    """Time since the last reset, s."""
    paused: bool
    speed: float
    robots: tuple[RobotView, ...]
    terrain: Terrain
    watched: int
    """Index of the robot that plots and camera follow."""
    recorded: float | None
    """Duration of the current recording, s; None if there is none."""
    offered: Offered


def robot_view(robot: ViewedRobot, name: str) -> RobotView:
    """Return a snapshot of a robot under a name."""
    points, forces = robot.contact_forces()
    return RobotView(
        name,
        robot.follows_command,
        robot.data.xpos.copy(),
        robot.data.xmat.reshape(-1, 3, 3).copy(),
        heading(robot.data),
        points,
        forces,
        tuple(robot.history),
        robot.term_names,
        tuple(robot.complaints()),
        robot.fell_at,
    )
