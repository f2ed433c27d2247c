"""The single environment."""

import os
from typing import Any

import gymnasium
import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs import arguments
from quadruped_env.envs import spaces_and_info as spaces
from quadruped_env.envs.specification import with_tables
from quadruped_env.errors import QuadrupedError
from quadruped_env.robot import QuadrupedDesign, Robot
from quadruped_env.simulation import SingleSimulation
from quadruped_env.task import Task, TaskConfig

_ENV_IDS = np.zeros(1, dtype=np.intp)


@with_tables
class MiniQuadrupedEnv(spaces.BaseEnv, gymnasium.Env[NDArray[np.float32], NDArray[np.float32]]):
    """A small four-legged robot that follows velocity commands.

    ## Description
    The robot of a ROS 2 tutorial: a 0.30 m long base on four legs, each with a hip and a knee that turn about the y
    axis. It weighs 4 kg; its motors are limited to 10 N m and 5 rad/s. No leg can move sideways, so the command is a
    forward velocity and a yaw rate, and the robot turns by longer strides on one side.

    ## Action space
    `Box(-1, 1, (8,), float32)`, one joint target per joint, at 50 Hz:

    | index | joint | range of the target |
    |---|---|---|
    | 0, 1 | `LF_hip_joint`, `LF_knee_joint` | hips -1.5 to 1.5 rad, knees -2.0 to 0.0 rad |
    | 2, 3 | `RF_hip_joint`, `RF_knee_joint` | |
    | 4, 5 | `LH_hip_joint`, `LH_knee_joint` | |
    | 6, 7 | `RH_hip_joint`, `RH_knee_joint` | |

    `action_mode="position"`: target = stance + 0.6 rad * action, the stance being 0.6 rad in the hips and -0.72 rad in
    the knees. `action_mode="residual"`: target = scripted gait(clock, command) + 0.4 rad * action, so that a zero
    action is the gait: a trot in closed form (docs/gaits.md). Targets are clipped to the joint's range. Each motor is a
    40 N m/rad, 1 N m s/rad position servo with the torque-speed line of a DC motor (assets/mini_quadruped/README.md).

    ## Observation space
    `Box((102,), float32)` with finite bounds: 34 readings that a real robot can measure, at this and the two control
    steps before, the latest first. Value = reading * scale, clipped to the bounds:

    {observations}

    The config's `observation_history` sets the number of steps.

    ## Command
    Forward velocity uniform in -0.3 to 0.6 m/s and yaw rate uniform in -0.8 to 0.8 rad/s; 10 % of the commands are
    zero, another 25 % have zero yaw rate, another 15 % zero forward velocity. A new command is drawn every 1 to 5 s,
    and approached by at most 1 m/s^2 and 4 rad/s^2. `reset(options={"command": (vx, wz)})` fixes it for the episode.

    A robot with three joints per leg that move its feet sideways has a third velocity, `lateral_velocity`, positive to
    the left: -0.2 to 0.2 m/s in the built-in robot's units, 1 m/s^2; 15 % of the commands have nothing else.
    `{"command": (vx, wz, vy)}` fixes all three.

    ## Reward
    The sum of the terms below, each times its weight and the control step of 0.02 s, added in this order. `info` has
    each weighted term as `reward_<name>`; they add up to the reward exactly. Velocities are the base's in the
    body frame; v~ and w~ are averaged over about one gait cycle (first-order low-pass filter, 0.4 s). Landings, slip
    and power are measured at every physics step.

    {rewards}

    With a lateral velocity u, v_y in `base_motion` is less its command, and `track_lateral_velocity` and
    `lateral_progress` pay u as the terms of the forward velocity pay v.

    ## Terrain
    Level ground, or a height field with level ground in its middle, where episodes start, and around it. It is the same
    for all episodes and envs of a config. Heights in rewards and starts are those over the ground below. `level`, 1 to
    10, sets height, depth or angle of a terrain that has levels. On `tiles`, the seed gives the tile on which an
    episode starts.

    {terrains}

    ## Starting state
    The stance, 1 cm above the highest ground below it, with uniform offsets: joints +-0.1 rad and +-0.5 rad/s, base
    +-0.2 m/s and +-0.2 rad/s on each axis, roll and pitch +-0.05 rad, any heading. `config={"randomization": "hard"}`,
    or `"moderate"`, also draws masses, motors, sensor errors, latency and pushes (docs/environment.md). Every random
    number depends only on the seed, the episode, the step and its purpose.

    ## Episode end
    Terminated when MuJoCo reports that the simulation diverged (`info["diverged"]`), or as a fall:

    {terminations}

    Truncated after 1000 steps (20 s) by `gymnasium.make`'s time limit.

    ## Information
    `command`, `base_position`, `base_linear_velocity` and `base_angular_velocity` (body frame), `joint_position`,
    `joint_velocity`, `joint_torque`, `foot_force`, `foot_contact`; after a step also `diverged` and the reward terms.
    Every value is a NumPy array or scalar with constant shape and dtype. Torques and forces are taken in the step's
    last physics substep.

    ## Arguments
    | argument | default | meaning |
    |---|---|---|
    | `action_mode` | `"position"` | `"position"` or `"residual"` |
    | `config` | `{}` | changes to `quadruped_env.task.TaskConfig`, as nested values; `motor` for other motors |
    | `task_file` | `None` | Python file with your own terms or robot (docs/make-it-yours.md); it is executed |
    | `robot` | `None` | a `quadruped_env.robot.Robot` or `QuadrupedDesign`; `None`: the one described above |
    | `terrain` | `None` | name of a terrain, short for the config's `terrain.name` |
    | `render_mode` | `None` | `"rgb_array"` or `"human"` |
    | `width`, `height` | 640, 480 | size of the image in pixels, limited by OpenGL |

    ## Version history
    * v0: initial version.
    """

    # gymnasium.make reads the render modes from the class; an instance has its own frame rate.
    metadata = spaces.metadata(TaskConfig())

    def __init__(
        self,
        action_mode: str | None = None,
        config: dict[str, Any] | TaskConfig | None = None,
        task_file: str | os.PathLike[str] | None = None,
        robot: Robot | QuadrupedDesign | dict[str, Any] | None = None,
        terrain: str | None = None,
        render_mode: str | None = None,
        width: int = 640,
        height: int = 480,
    ) -> None:
        self.render_mode, self._frame_size = arguments.rendering(render_mode, width, height)
        task_config = arguments.task_config(action_mode, config, task_file, robot, terrain, self.default_config)
        self.metadata = spaces.metadata(task_config)
        self._simulation = SingleSimulation(task_config.compiled_model(), task_config.robot)
        self.task = Task(self._simulation, task_config)
        self._info = spaces.Info(self.task)
        self.action_space = spaces.action_space(self.task.control.robot)
        self._action_shape = self.action_space.shape
        self.observation_space = spaces.observation_space(self.task.control.layout)
        if render_mode == "human":
            self._make_renderer(self.model, self.data)

    @property
    def model(self) -> mujoco.MjModel:
        """MuJoCo model."""
        return self._simulation.model

    @property
    def data(self) -> mujoco.MjData:
        """MuJoCo data, the state of the robot."""
        return self._simulation.data

    @property
    def dt(self) -> float:
        """Time between actions, s."""
        return self.task.config.control_timestep

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.float32], dict[str, Any]]:
        """Begin an episode; `options` is described in the class."""
        command, _ = arguments.reset_options(options, self.task.config)
        super().reset(seed=arguments.seed(seed))
        self.task.generators[0], self.task.seeds[0] = self.np_random, self.np_random_seed
        self.task.reset(_ENV_IDS, command=command)
        if self.render_mode == "human":
            self.render()
        return self.task.observe()[0], self._info.readings(0)

    def step(self, action: NDArray[np.float32]) -> tuple[NDArray[np.float32], float, bool, bool, dict[str, Any]]:
        """Advance by one control step."""
        values = np.asarray(action, dtype=np.float64)
        if values.shape != self._action_shape:
            raise QuadrupedError(
                f"action: expected shape {self._action_shape}, one value per joint; found {values.shape}"
            )
        transition = self.task.step(values[None])
        info: dict[str, Any] = self._info.readings(0)
        # A 0-d array: from a NumPy bool, Gymnasium's vector environments would create an array of objects.
        info["diverged"] = transition.diverged.reshape(())
        info.update(zip(self.task.reward_keys, transition.terms[0], strict=True))
        if self.render_mode == "human":
            self.render()
        terminated = bool(transition.terminated[0])
        return transition.observation[0], float(transition.reward[0]), terminated, False, info

    def render(self) -> NDArray[np.uint8] | None:
        """Image (height, width, 3) in `rgb_array` mode; updates the window in `human` mode."""
        if self.render_mode is None:
            gymnasium.logger.warn(
                "render() was called without a render mode; use gymnasium.make(..., render_mode='rgb_array')"
            )
            return None
        return self._make_renderer(self.model, self.data).render(self.data)

    def get_state(self) -> dict[str, Any]:
        """Complete state of the environment, including the random generator."""
        return self.task.get_state(0)

    def set_state(self, state: dict[str, Any]) -> None:
        """Restore a state from `get_state`."""
        self.task.generators[0] = self.np_random  # used by the next reset
        self.task.set_state(0, state)
        self._np_random_seed = self.task.seeds[0]

    def close(self) -> None:
        """Close the window or the renderer, if there is one."""
        self._close_renderer()


class MiniQuadrupedRoughEnv(MiniQuadrupedEnv):
    """`MiniQuadrupedEnv` on tiles of seven kinds of terrain at ten levels, with a curriculum.

    The seed of an env gives the kind of its tiles and its first level, which the curriculum changes from episode to
    episode (docs/environment.md). A reset with a seed begins again. `info` has also `terrain_kind`, the index of the
    kind, and `terrain_level`. The default config has the changes of `ROUGH_CONFIG`; the argument `config` may change
    them again, or name another terrain. All else is as in `MiniQuadrupedEnv`.
    """

    default_config = arguments.ROUGH_CONFIG
