"""Interface between a task and a simulation, common to both drivers."""

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env.robot.readings import Readings
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation.height_field import HeightField

SETTLED = mujoco.mjtStage.mjSTAGE_VEL
"""Stage at which every control step ends: positions and velocities are computed at the new state."""

DIVERGENCE_WARNINGS = slice(mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQACC + 1)
"""MuJoCo's warnings for a state that was NaN or too large and was therefore reset."""

STATE_SPEC = mujoco.mjtState.mjSTATE_INTEGRATION
"""Components of the state that determine the next step."""


class SimulationState(NamedTuple):
    """Complete state of one env, from which its simulation continues identically, and its readings."""

    integration: NDArray[np.float64]
    """MuJoCo's state with the components of `STATE_SPEC`, (S,)."""
    readings: NDArray[np.float64]
    """Sensor data (model.nsensordata,), stored because forces are not a function of the state alone."""
    diverged: bool
    model_fields: dict[str, NDArray[np.float64]]
    """Values in this env of every field that was requested with `Simulation.model_field`."""


class Simulation(Protocol):
    """N copies of the robot on its ground.

    All drivers return bit-identical results for the same calls, for any number of envs and threads.
    """

    model: mujoco.MjModel
    robot: Robot
    num_envs: int
    height_field: HeightField | None
    """Heights of the ground; None if it is a plane at height 0."""
    readings: Readings
    """Live readings; `Readings` says at which substep each is taken."""
    substeps: Readings
    """Readings at the beginning of each physics step of the latest control step, (S, N, ...): all of one instant, also
    the forces. Live, and meaningless before the first step. Of envs that a step leaves out they are older."""
    sensordata: NDArray[np.float64]
    """MuJoCo's sensor data (N, model.nsensordata), live and read-only; the readings are views of it."""
    sensor_columns: dict[str, slice]
    """Columns of the sensor data for each field of `Readings`."""

    def step(self, joint_target: NDArray[np.float64], substeps: int, env_ids: NDArray[np.intp] | None = None) -> None:
        """Advance some envs (R,), or all, by `substeps` physics steps with joint targets (N, J) in rad."""
        ...

    def reset(self, env_ids: NDArray[np.intp], qpos: NDArray[np.float64], qvel: NDArray[np.float64]) -> None:
        """Set some envs (R,) to qpos (R, 15) and qvel (R, 14), at rest otherwise; the others do not change.

        Constants that depend on changed model fields are recomputed.
        """
        ...

    def diverged(self) -> NDArray[np.bool_]:
        """Mask (N,) of the envs that MuJoCo reported as diverged, or could not step, since their last reset."""
        ...

    def push(self, env_ids: NDArray[np.intp], velocity: NDArray[np.float64]) -> None:
        """Add a velocity to the base of some envs (R,); readings change with the next step.

        It is linear in the world frame in m/s (R, 3), or with the angular velocity in the body frame in rad/s (R, 6).
        """
        ...

    def set_force(self, env_ids: NDArray[np.intp], force: NDArray[np.float64]) -> None:
        """Apply forces (R, 3) in the world frame, in N, at the centre of mass of the base of some envs (R,).

        A force lasts until the next call or reset.
        """
        ...

    def model_field(self, name: str) -> NDArray[np.float64]:
        """A field of the model with one value per env, (N, ...), writable; call `reset` after writing to it.

        In `SingleSimulation` this is the field of the model itself, so other users of the model see the change too.
        """
        ...

    def compiled_field(self, name: str) -> NDArray[np.float64]:
        """A field of the model as it was before `model_field` was first called for it; read-only."""
        ...

    def field_values(self, name: str) -> NDArray[np.float64]:
        """A field of the model in each env (N, ...), or (1, ...) if it is the same in all; read-only."""
        ...

    def restore_model_fields(self, env_ids: NDArray[np.intp]) -> None:
        """Set every field that was requested with `model_field` back to the model's values, in some envs (R,)."""
        ...

    def get_state(self, env_id: int) -> SimulationState:
        """Copy the complete state of an env, with its readings."""
        ...

    def set_state(self, env_id: int, state: SimulationState) -> None:
        """Restore a state from `get_state`, of this or of another simulation of the same model."""
        ...


def restored(
    kind: Callable[..., Simulation], arguments: tuple[object, ...], states: Sequence[SimulationState]
) -> Simulation:
    """Return a new simulation whose envs have states of `Simulation.get_state`: pickling and copying call it."""
    simulation = kind(*arguments)
    for env_id, state in enumerate(states):
        simulation.set_state(env_id, state)
    return simulation


def highest_ground(simulation: Simulation, positions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Height (...,) of the highest ground below a simulation's robot at positions (..., 2 or 3), m."""
    if simulation.height_field is None:
        return np.zeros_like(positions[..., 0])
    return simulation.height_field.highest(positions, simulation.robot.footprint)
