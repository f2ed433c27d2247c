"""Speed of the environments: each measure interleaves what it compares, and takes the median of the turns' ratios."""

from collections.abc import Callable, Iterable
from typing import Any, Final

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode
from mujoco.batch import Batch
from numpy.typing import ArrayLike, NDArray

from benchmarks.measures import Measure, seconds_of
from quadruped_env.envs import ENV_ID, MiniQuadrupedVectorEnv
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import Task
from quadruped_env.utils.arrays import Floats

NUM_ENVS: Final = 256
SYNC_ENVS: Final = 64
ROBOT: Final = MINI_QUADRUPED
CHUNKS: Final = 15
"""Turns of each environment; the first one does not count."""
_SINGLE_STEPS: Final = 300
"""Steps of a turn of a single environment."""
_VECTOR_STEPS: Final = 10
"""Steps of a turn of a vector environment; few, as a machine's speed varies."""


def single_over_ant(chunks: int = CHUNKS) -> list[Measure]:
    """Return the single environment, as `gymnasium.make` gives it, over Gymnasium's Ant-v5."""
    env, ant = gymnasium.make(ENV_ID), gymnasium.make("Ant-v5")
    rng = np.random.default_rng(0)
    own, other, resets = [], [], []
    for each in (env, ant):
        each.reset(seed=0)
    for _ in range(chunks + 1):
        actions = rng.uniform(-1.0, 1.0, (_SINGLE_STEPS, ROBOT.num_joints)).astype(np.float32)
        own.append(seconds_of(lambda: _run(env, actions)))  # noqa: B023  called here
        other.append(seconds_of(lambda: _run(ant, actions)))  # noqa: B023
        resets.append([seconds_of(lambda: [each.reset() for _ in range(20)]) for each in (env, ant)])  # noqa: B023
    env.close()
    ant.close()
    ratio, reset = median_ratio(other, own), median_ratio(*zip(*resets, strict=True))
    detail = f"{_SINGLE_STEPS / np.median(own[1:]):,.0f} steps/s, actions drawn before"
    return [
        Measure("single env over Ant-v5, steps alone", ratio, "x", ">= 1.1", ratio >= 1.1, detail),
        Measure("time of a reset, over Ant-v5's", reset, "x", "", True, ""),
    ]


def vector_over_sync(chunks: int = CHUNKS) -> list[Measure]:
    """Return the native vector environment over `SyncVectorEnv` of the single one."""
    native = gymnasium.make_vec(ENV_ID, num_envs=SYNC_ENVS)
    vector_kwargs = {"autoreset_mode": AutoresetMode.SAME_STEP}
    sync = gymnasium.make_vec(ENV_ID, num_envs=SYNC_ENVS, vectorization_mode="sync", vector_kwargs=vector_kwargs)
    rng = np.random.default_rng(0)
    seconds: tuple[list[float], list[float]] = [], []
    for env in (native, sync):
        env.reset(seed=0)
    for _ in range(chunks + 1):
        actions = _actions(rng, SYNC_ENVS)
        for env, times in zip((native, sync), seconds, strict=True):
            times.append(seconds_of(lambda: [env.step(action) for action in actions]))  # noqa: B023
    native.close()
    sync.close()
    ratio = median_ratio(seconds[1], seconds[0])
    return [Measure(f"vector env over SyncVectorEnv, {SYNC_ENVS} envs", ratio, "x", ">= 4", ratio >= 4.0, "")]


def vector_over_bare(chunks: int = 6 * CHUNKS) -> list[Measure]:
    """Return the native vector environment over a bare `Batch.step` from the same states with the same controls.

    Random actions alone hardly ever throw this robot over: pushes make it fall every few seconds.
    """
    config = {"randomization": {"push_velocity": 3.0, "push_interval": (1.0, 4.0)}}
    env = gymnasium.make_vec(ENV_ID, num_envs=NUM_ENVS, config=config)
    assert isinstance(env.unwrapped, MiniQuadrupedVectorEnv)
    task = env.unwrapped.task
    bare, rng = Batch(task.simulation.model, NUM_ENVS), np.random.default_rng(0)
    env.reset(seed=0)
    own, physics = [], []

    def step_bare(controls: Iterable[Floats]) -> None:
        for control in controls:
            bare.bind("ctrl")[:] = control
            bare.step(nstep=task.config.decimation)

    for _ in range(chunks + 1):
        state, actions = task.simulation.batch.state.copy(), _actions(rng, NUM_ENVS)  # type: ignore[attr-defined]
        own.append(seconds_of(lambda: [env.step(action) for action in actions]))  # noqa: B023
        bare.state[:] = state
        controls = joint_targets(task, actions)
        physics.append(seconds_of(lambda: step_bare(controls)))  # noqa: B023
    env.close()
    ratio = median_ratio(physics, own)
    rates = (_VECTOR_STEPS * NUM_ENVS / np.median(seconds[1:]) for seconds in (own, physics))
    detail = "{:,.0f} of {:,.0f} env steps/s".format(*rates)
    return [Measure(f"vector env, {NUM_ENVS} envs, over bare Batch.step", ratio, "", ">= 0.85", ratio >= 0.85, detail)]


def joint_targets(task: Task, actions: NDArray[Any]) -> Floats:
    """Joint targets for actions (..., J) in position mode, rad."""
    robot = task.control.robot
    target = robot.stance + task.config.action.position_scale * actions.astype(np.float64)
    return np.clip(target, robot.joint_position_low, robot.joint_position_high)


def median_ratio(seconds: ArrayLike, other: ArrayLike) -> float:
    """Median of the turns' ratios, without the first turn."""
    return float(np.median(np.divide(seconds, other)[1:]))


def _actions(rng: np.random.Generator, num_envs: int) -> NDArray[np.float32]:
    return rng.uniform(-1.0, 1.0, (_VECTOR_STEPS, num_envs, ROBOT.num_joints)).astype(np.float32)


def _run(env: gymnasium.Env[Any, Any], actions: Iterable[Any]) -> None:
    for action in actions:
        _, _, terminated, truncated, _ = env.step(action)
        if terminated or truncated:
            env.reset()


WORKS: Final[dict[str, Callable[[], list[Measure]]]] = {
    "single": single_over_ant,
    "sync": vector_over_sync,
    "vector": vector_over_bare,
}
