"""The viewer as a follower: it draws the robot where the messages say, and sends commands and pushes as messages."""

import time
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait_settings import GaitSettings
from quadruped_env.live.gaits import read_settings, settings_message
from quadruped_env.live.joints import JointReader, Joints
from quadruped_env.live.node import Node, Refused, message_reader
from quadruped_env.live.topics import CMD_VEL, GAIT, GAIT_SETTINGS, JOINT_STATES, ODOMETRY, PUSH
from quadruped_env.policies import ControllerSpec
from quadruped_env.robot import STANCE, resting_pose
from quadruped_env.ros import SENSOR_DATA_QOS, cdr
from quadruped_env.simulation import SingleSimulation
from quadruped_env.task import Task, TaskConfig, Transition
from quadruped_env.viewer.controller import Offered

NAME: Final = "live robot"
_ROW: Final = np.zeros(1, dtype=np.intp)
_ODOMETRY_LASTS: Final = 1.0
"""s; without a newer one the robot is drawn resting on its feet where it was"""
_STOP: Final = 1.0
"""s for which a zero command is repeated; then others may steer"""
_COMMAND_PERIOD: Final = 0.1
_CHANGING: Final = 1.0
"""s after a change of the gait's settings"""
_FARTHEST: Final = 1e6
"""m, m/s or rad/s; nothing is drawn beyond"""
_SHORTEST: Final = 1e-3
"""Length of a quaternion that still says where to"""


class Mirror:
    """`quadruped_env.policies.Controller` that puts the robot where the topics say.

    Args:
        node: that listens, and publishes the viewer's command.
        refused: is called with the reason for each message that cannot be drawn.
    """

    name = NAME
    action_mode = "position"

    def __init__(self, node: Node, refused: Refused = lambda reason: None) -> None:
        self._states = node.subscribe(JOINT_STATES, SENSOR_DATA_QOS, read=JointReader(JOINT_STATES.name, ["positions"]))
        self._odometry = node.subscribe(ODOMETRY, SENSOR_DATA_QOS, read=message_reader(ODOMETRY, _read_odometry))
        self._velocities, self._pushes = node.publish(CMD_VEL), node.publish(PUSH)
        self._gaits = node.publish(GAIT)
        self._gait_settings = node.subscribe(GAIT_SETTINGS, read=message_reader(GAIT_SETTINGS, read_settings))
        self._settings: GaitSettings | None = None
        self._changed_at = -_CHANGING
        self._joints = Joints(0, STANCE, np.zeros(8), None)
        self._pose = resting_pose(STANCE)
        self._twist = np.zeros(6)
        self._velocity = np.zeros(3)
        self._odometry_at = -_ODOMETRY_LASTS
        self._moved_at = -_STOP
        self._sent_at = 0.0
        self._refused = refused

    def step(self, task: Task, observation: NDArray[np.float32]) -> Transition:
        """Take the newest state from the topics in place of a step of physics."""
        now = time.monotonic()
        self._listen(now)
        self._steer(task.command[0], now)
        simulation = task.simulation
        assert isinstance(simulation, SingleSimulation)
        if task.steps[0] > 0:
            self._pass_push_on(simulation.data.qvel[:3])
        positions, velocities = self._joints.positions, self._joints.velocities
        assert positions is not None
        transition = task.step_joint_target(positions[None].copy())
        if now - self._odometry_at > _ODOMETRY_LASTS:
            resting = resting_pose(positions)
            self._pose, self._twist = np.concatenate([self._pose[:2], resting[2:]]), np.zeros(6)
        qpos = np.concatenate([self._pose, positions])
        qvel = np.concatenate([self._twist, np.zeros(8) if velocities is None else velocities])
        simulation.reset(_ROW, qpos[None], qvel[None])
        self._velocity = qvel[:3]
        transition.terminated[:] = False
        transition.diverged[:] = False
        return transition

    @property
    def settings(self) -> GaitSettings | None:
        """The settings of the `gait` node's gait; None while there is no such node."""
        return self._settings if self._gaits.readers else None

    @settings.setter
    def settings(self, settings: GaitSettings) -> None:
        self._gaits.send(settings_message(settings))
        self._settings, self._changed_at = settings, time.monotonic()

    def complaints(self) -> list[str]:
        """Nothing: the `gait` node says what its gait asks for beyond the robot's limits."""
        return []

    def offered(self) -> Offered:
        """What a person can do: commands and pushes where a node takes them; the clock is that of a simulation."""
        commands, pushes = bool(self._velocities.readers), bool(self._pushes.readers)
        return Offered(command=commands, push=pushes, clock=pushes, sources=False)

    @property
    def hears(self) -> bool:
        """Whether joint states have come."""
        return self._states.count > 0

    def _listen(self, now: float) -> None:
        state = self._states.newest(self._refused)
        if state is not None:
            self._joints = state[1]
        newest = self._odometry.newest(self._refused)
        if newest is not None:
            self._odometry_at = now
            self._pose, self._twist = newest[1]
        settings = self._gait_settings.newest(self._refused)
        # While a slider is dragged, what comes is what it was before.
        if settings is not None and now - self._changed_at > _CHANGING:
            self._settings = settings[1]

    def _pass_push_on(self, velocity: NDArray[np.float64]) -> None:
        """Send what somebody added to the base's velocity (3,) since it was put where it is: a push in the viewer."""
        added = velocity - self._velocity
        if added.any():
            x, y, z = added.tolist()
            self._pushes.send(cdr.message(PUSH.type_name, x=x, y=y, z=z))

    def _steer(self, command: NDArray[np.float64], now: float) -> None:
        """Send the viewer's command, for as long as it asks for something and a little longer."""
        if command.any():
            self._moved_at = now
        if now - self._moved_at > _STOP or now - self._sent_at < _COMMAND_PERIOD:
            return
        self._sent_at = now
        twist = {"linear": {"x": command[0]}, "angular": {"z": command[1]}}
        self._velocities.send(cdr.message(CMD_VEL.type_name, **twist))


def mirror_source(mirror: Mirror) -> ControllerSpec:
    """A mirror as the viewer takes it."""
    return ControllerSpec(NAME, lambda: (mirror, TaskConfig()))


def _read_odometry(odometry: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Pose (7,) and velocities (6,) of the base, as MuJoCo has them, of a message of `/odom`.

    Raises:
        QuadrupedError: if a value is not finite or too large, or the orientation has no length.
    """
    place, turn = odometry.pose.pose.position, odometry.pose.pose.orientation
    linear, angular = odometry.twist.twist.linear, odometry.twist.twist.angular
    pose = np.array([place.x, place.y, place.z, turn.w, turn.x, turn.y, turn.z])
    velocity = np.array([linear.x, linear.y, linear.z])
    rate = np.array([angular.x, angular.y, angular.z])
    length = float(np.linalg.norm(pose[3:]))
    if not (np.abs(np.concatenate([pose, velocity, rate])) <= _FARTHEST).all() or length < _SHORTEST:
        raise QuadrupedError(
            f"{ODOMETRY.name}: a value is not finite or over {_FARTHEST:g}, or the orientation is zero; send finite "
            f"numbers and a unit quaternion"
        )
    pose[3:] /= length
    return pose, np.concatenate([_in_world(pose[3:], velocity), rate])


def _in_world(orientation: NDArray[np.float64], vector: NDArray[np.float64]) -> NDArray[np.float64]:
    """A vector (3,) of the axes of a base, whose attitude is a unit quaternion, in the world's."""
    import mujoco

    turned = np.empty(3)
    mujoco.mju_rotVecQuat(turned, vector, orientation)
    return turned
