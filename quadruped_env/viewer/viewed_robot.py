"""One robot of the viewer: its source, its task, and samples of its recent history for plots and recordings."""

from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from operator import methodcaller
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.control.controllers import GaitController
from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import Command, full_command
from quadruped_env.evaluation.trace import Array, CommandedTrace, measured
from quadruped_env.gait.gait_settings import GaitSettings
from quadruped_env.policies import ControllerSpec, task_of
from quadruped_env.robot import Robot
from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import SingleSimulation, Terrain, highest_ground
from quadruped_env.task import BUILT_IN, PRESETS, Task, TaskConfig, Transition
from quadruped_env.utils.rotations import from_yaw, multiply, rotate, yaw

HISTORY_SECONDS: Final = 5.0
LANE: Final = 0.6
"""Distance between robots of size 1 next to each other, m."""
RANDOMIZATIONS: Final[dict[str, Callable[[TaskConfig], TaskConfig]]] = {
    "off": TaskConfig.without_randomization,
    **{"start" if preset == "none" else preset: methodcaller("randomized", preset) for preset in PRESETS},
    "as trained": lambda config: config,
}
"""Name -> function that gives a source's task this randomization."""

_ROW: Final = np.zeros(1, dtype=np.intp)


@dataclass(frozen=True)
class Offered:
    """The controls that have an effect, and the readings that exist: not all for a robot observed through messages."""

    command: bool = True
    push: bool = True
    sources: bool = True
    """Choice of controllers, terrain, playback and randomization, and reward terms; fixed from the start."""
    motion: bool = True
    """Velocity of the base, and contacts of the feet."""


@dataclass(frozen=True, kw_only=True, eq=False)
class ViewedTrace(CommandedTrace):
    """Trace of a viewed robot, arrays (T, ...), or one of its samples, arrays (...)."""

    time: Array
    """Time since the start of the episode, s (T,)"""
    smooth_velocity: Array
    """Velocity averaged over about one gait cycle, m/s and rad/s (T, V)"""
    foot_position: Array
    """Centre of each foot's sphere in the world frame, m (T, L, 3)"""
    reward_terms: Array
    """Weighted terms of the last step, in the task's order (T, K); zeros at the start"""


def sample(robot: Robot, timestep: float, terrain: Terrain, readings: Readings, **values: NDArray[Any]) -> ViewedTrace:
    """Return a sample of a robot, copied from readings of one env and from further quantities (1, ...)."""
    both = {**measured(robot, readings), "foot_position": readings.foot_position, **values}
    copies: dict[str, Any] = {name: np.array(value[0]) for name, value in both.items()}
    return ViewedTrace(robot=robot, timestep=timestep, terrain=terrain, **copies)


class ViewedRobot(ABC):
    """A robot that the viewer shows and steers: a simulated one, or one that sends messages.

    Args:
        name: name of its source.
        robot: its description.
        simulation: what is drawn, with the current state.
        terrain: ground below it.
        timestep: time between samples, s.
    """

    follows_command: bool = True
    """False if the velocity command has no effect."""
    fell_at: float | None = None
    """Episode time of the fall, s; None if it has not fallen."""
    diverged: bool = False
    """True if the simulation diverged and has to be reset."""
    term_names: tuple[str, ...] = ()
    """Names of the samples' reward terms."""
    lane: float = 0.0
    """Distance of its start on uneven ground to the left of the origin, m."""
    clock: float = 0.0
    """Playback time that it has simulated, s."""

    def __init__(
        self, name: str, robot: Robot, simulation: SingleSimulation, terrain: Terrain, timestep: float
    ) -> None:
        self.name = name
        self.robot = robot
        self._simulation = simulation
        self.terrain = terrain
        self.timestep = timestep
        self.history: deque[ViewedTrace] = deque(maxlen=round(HISTORY_SECONDS / timestep))
        """Samples of the last seconds, the latest last."""
        self._scratch = mujoco.MjData(self.model)

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo's model."""
        return self._simulation.model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo's data with the current state."""
        return self._simulation.data

    def contact_forces(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return ground contact points (K, 3), m, and forces on the robot (K, 3), N, in the world frame."""
        # On a copy of the state, since a control step ends before its contact forces are known.
        model, data = self.model, self._scratch
        mujoco.mj_copyState(model, self.data, data, mujoco.mjtState.mjSTATE_INTEGRATION)
        mujoco.mj_forward(model, data)
        points, forces, wrench = [np.empty((0, 3))], [np.empty((0, 3))], np.empty(6)
        for i, contact in enumerate(data.contact):
            first, second = model.geom_bodyid[contact.geom]
            if not (first and second):
                mujoco.mj_contactForce(model, data, i, wrench)
                points.append(contact.pos[None])
                # The force acts on the second geom, which is the robot's: planes and height fields come first.
                forces.append((contact.frame.reshape(3, 3).T @ wrench[:3])[None])
        return np.concatenate(points), np.concatenate(forces)

    @property
    @abstractmethod
    def gait(self) -> GaitSettings | None:
        """The settings of its scripted gait; None if it has none."""

    @gait.setter
    @abstractmethod
    def gait(self, settings: GaitSettings) -> None: ...

    @abstractmethod
    def complaints(self) -> list[str]:
        """Return descriptions of the joint limits that its scripted gait exceeds."""

    @abstractmethod
    def reset(self, seed: int, command: Command) -> None:
        """Start again with a velocity command."""

    @abstractmethod
    def set_command(self, command: Command) -> None:
        """Set the velocity command: a number for each of the robot's `velocity_commands`, m/s and rad/s."""

    @abstractmethod
    def push(self, velocity: tuple[float, float]) -> None:
        """Add a velocity (forwards, left) in the robot's heading frame, m/s, to its base."""

    @abstractmethod
    def step(self) -> ViewedTrace:
        """Advance by one sample."""


class TaskRobot(ViewedRobot):
    """A simulated robot in the task of its source, with another randomization and on another ground if they are given.

    Raises:
        QuadrupedError: if the source does not fit the robot.
    """

    def __init__(
        self,
        source: ControllerSpec,
        randomization: Callable[[TaskConfig], TaskConfig] | None = None,
        robot: Robot = BUILT_IN.robot,
        terrain: Terrain | None = None,
        lane: float = 0.0,
    ) -> None:
        controller = source.make()
        config = task_config(controller.action_mode, task_of(controller, robot))
        if config.robot != robot:
            raise QuadrupedError(f"{source.name}: is for {config.robot!r}; the viewer shows {robot!r}")
        if randomization is not None:
            config = randomization(config)
        self._controller = controller
        self.follows_command = controller.follows_command
        if terrain is not None:
            config = config.on_terrain(terrain, terrain.seed)
        simulation = SingleSimulation(config.compiled_model(), robot)
        super().__init__(source.name, robot, simulation, config.ground, config.control_timestep)
        self.task = Task(self._simulation, config)
        self.term_names = self.task.term_names
        self.lane = lane
        self.reset(0, full_command((), robot))

    @property
    def gait(self) -> GaitSettings | None:
        """The settings of its scripted gait; None if it has none."""
        return self._controller.settings if isinstance(self._controller, GaitController) else None

    @gait.setter
    def gait(self, settings: GaitSettings) -> None:
        if not isinstance(self._controller, GaitController):
            raise QuadrupedError(f"gait: {self.name!r} has no scripted gait; choose one to change its gait")
        self._controller.settings = settings

    def complaints(self) -> list[str]:
        """Return descriptions of the joint limits that its scripted gait exceeds."""
        return self._controller.complaints() if isinstance(self._controller, GaitController) else []

    def reset(self, seed: int, command: Command) -> None:
        """Begin an episode at the origin, or in the lane, facing along x; identically with the same seed."""
        self.task.reset(_ROW, seeds=[seed], command=self._within(command))
        self._place()
        self.observation = self.task.observe()
        self.history.clear()
        self.history.append(self._sample())
        self.fell_at, self.diverged = None, False

    def set_command(self, command: Command) -> None:
        """Set the velocity command, m/s and rad/s, clipped to its task's ranges."""
        self.task.set_command(_ROW, self._within(command))

    def push(self, velocity: tuple[float, float]) -> None:
        """Add a velocity (forwards, left) in the robot's heading frame, m/s, to its base."""
        self._simulation.push(_ROW, world_vector(velocity, heading(self.data))[None])

    def step(self) -> ViewedTrace:
        """Advance by one control step. A robot that fell goes on; one whose simulation diverged does not."""
        if self.diverged:
            return self.history[-1]
        transition = self.task.act(self._controller, self.observation)
        self.observation = transition.observation
        self.diverged = bool(transition.diverged[0])
        moment = self._sample(transition)
        self.history.append(moment)
        if self.fell_at is None and transition.terminated[0]:
            self.fell_at = float(moment.time)
        return moment

    def _sample(self, transition: Transition | None = None) -> ViewedTrace:
        """Return the current sample, after a step or, without one, at the start of an episode."""
        task = self.task
        return sample(
            self.robot,
            self.timestep,
            self.terrain,
            self._simulation.readings,
            time=task.control.steps * self.timestep,
            command=task.control.requested,
            smooth_velocity=task.context.smooth_velocity,
            contact=task.context.foot_contact,
            reward_terms=np.zeros((1, len(self.term_names))) if transition is None else transition.terms,
        )

    def _within(self, command: Command) -> Command:
        ranges = (entry.range for entry in self.task.config.commands)
        return tuple(float(np.clip(v, low, high)) for v, (low, high) in zip(command, ranges, strict=False))

    def _place(self) -> None:
        """Rotate the initial state, which has a random heading, and its base velocity to face along x, in the lane."""
        qpos, qvel = self.data.qpos.copy(), self.data.qvel.copy()
        back = from_yaw(-heading(self.data))
        qpos[3:7] = multiply(back, qpos[3:7])
        # MuJoCo's angular velocity is in the body frame and turns with it.
        qvel[:3] = rotate(back, qvel[:3])
        if self._simulation.height_field is not None:
            start = qpos[:2].copy()
            qpos[1] += self.lane
            qpos[2] += highest_ground(self._simulation, qpos[:2]) - highest_ground(self._simulation, start)
        self.task.place(_ROW, qpos[None], qvel[None])


def heading(data: mujoco.MjData) -> float:
    """Return the heading of a robot from the world's x axis, rad."""
    return float(yaw(data.qpos[3:7]))


def world_vector(vector: tuple[float, float], heading: float) -> NDArray[np.float64]:
    """Return a horizontal vector (forwards, left) of a robot with a heading (rad), in the world frame (3,)."""
    return rotate(from_yaw(heading), [*vector, 0.0])
