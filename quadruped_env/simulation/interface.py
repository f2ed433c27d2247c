"""What a task may ask of a simulation, whichever driver runs it."""

from typing import NamedTuple, Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.readings import Readings
from quadruped_env.robot.robot import Robot

SETTLED = mujoco.mjtStage.mjSTAGE_VEL
"""Every control step ends with positions and velocities computed at the new state, ready for the next substep."""

DIVERGENCE_WARNINGS = slice(mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQACC + 1)
"""MuJoCo's warnings that say that a state was not a number or too large, and that it was put back to the start."""

STATE_SPEC = mujoco.mjtState.mjSTATE_INTEGRATION
"""Everything that the next step depends on."""


class SimulationState(NamedTuple):
    """All that the future of one env depends on, and its readings."""

    integration: NDArray[np.float64]
    """MuJoCo's `STATE_SPEC`, (S,)"""
    readings: NDArray[np.float64]
    """Sensor data (model.nsensordata,): forces are not a function of the state alone"""
    diverged: bool
    model_fields: dict[str, NDArray[np.float64]]
    """The env's own value of every field that was asked for with `Simulation.model_field`"""


def force_columns(model: mujoco.MjModel) -> NDArray[np.bool_]:
    """Which columns of the sensor data (model.nsensordata,) are forces or accelerations: a push leaves them alone."""
    return np.repeat(model.sensor_needstage == int(mujoco.mjtStage.mjSTAGE_ACC), model.sensor_dim)


class Simulation(Protocol):
    """N copies of the robot on its ground.

    Both drivers give the same bits for the same calls, at any number of envs and threads.
    """

    model: mujoco.MjModel
    robot: Robot
    num_envs: int
    readings: Readings
    """Live readings; see `Readings` for what is current when."""
    sensordata: NDArray[np.float64]
    """MuJoCo's sensor data (N, model.nsensordata), of which the readings are views; live, not to be written to."""
    sensor_columns: dict[str, slice]
    """Field of `Readings` -> its columns of the sensor data"""

    def step(self, joint_target: NDArray[np.float64], substeps: int, env_ids: NDArray[np.intp] | None = None) -> None:
        """Advance some envs (R,), or all, by `substeps` physics steps with joint targets (N, 8) in rad."""
        ...

    def reset(self, env_ids: NDArray[np.intp], qpos: NDArray[np.float64], qvel: NDArray[np.float64]) -> None:
        """Put some envs (R,) at qpos (R, 15) and qvel (R, 14), at rest otherwise; the others do not change.

        Derives anew what depends on model fields that were written since.
        """
        ...

    def diverged(self) -> NDArray[np.bool_]:
        """Which envs (N,) MuJoCo reported as diverged, or could not step, since their last reset."""
        ...

    def push(self, env_ids: NDArray[np.intp], velocity: NDArray[np.float64]) -> None:
        """Add world-frame velocity (R, 3) in m/s to the base of some envs (R,).

        The readings of velocities follow at once, those of forces and accelerations stay the last substep's.
        """
        ...

    def model_field(self, name: str) -> NDArray[np.float64]:
        """A field of the model with a value per env, (N, ...), to write to before `reset`.

        With one env it is the model's own field: a model that others use as well changes for them too.
        """
        ...

    def get_state(self, env_id: int) -> SimulationState:
        """Take a copy of all that the future of an env depends on, and of its readings."""
        ...

    def set_state(self, env_id: int, state: SimulationState) -> None:
        """Restore what `get_state` gave, here or in another simulation of the same model."""
        ...
