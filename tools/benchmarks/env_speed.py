"""Speed of the environments: each measure interleaves what it compares, and takes the median of the turns' ratios."""

import contextlib
import functools
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, Final
from unittest import mock

import gymnasium
import mujoco
import numpy as np
from gymnasium.utils.performance import benchmark_init, benchmark_step
from gymnasium.vector import AutoresetMode
from mujoco.batch import Batch
from numpy.typing import ArrayLike, NDArray

from benchmarks.measures import Measure, seconds_of
from quadruped_env.envs import ENV_ID, MiniQuadrupedEnv, MiniQuadrupedVectorEnv
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import Task

ROWS: Final = 256
SYNC_ROWS: Final = 64
ROBOT: Final = MINI_QUADRUPED
CHUNKS: Final = 15
_VECTOR_STEPS: Final = 10
"""Steps of a turn of the vector environment; few, as a machine's speed varies."""
_VECTOR_CHUNKS: Final = 90

FALLING: Final = {"randomization": {"push_velocity": 3.0, "push_interval": (1.0, 4.0)}}
"""Random actions alone hardly ever throw this robot over: pushes make it fall every few seconds."""


def joint_targets(task: Task, actions: NDArray[Any]) -> NDArray[np.float64]:
    """Joint targets for actions (..., J) in position mode, rad."""
    robot = task.control.robot
    target = robot.stance + task.config.action.position_scale * actions.astype(np.float64)
    return np.clip(target, robot.joint_position_low, robot.joint_position_high)


def vector_over_bare() -> list[Measure]:
    """The native vector environment over a bare `Batch.step` from the same states with the same controls."""
    falling, plain = _VectorTurns(FALLING), _VectorTurns({})
    for _ in range(_VECTOR_CHUNKS + 1):
        for turns in (falling, plain):
            turns.take()
        plain.take_without_physics()
    for turns in (falling, plain):
        turns.close()
    ratio = _median_ratio(falling.bare, falling.env)
    rates = (_VECTOR_STEPS * ROWS / np.median(seconds[1:]) for seconds in (falling.env, falling.bare))
    detail = "{:,.0f} of {:,.0f} env steps/s".format(*rates)
    detail += f"; {falling.falls} falls in {len(falling.env) * _VECTOR_STEPS * ROWS:,} steps"
    undisturbed = _median_ratio(plain.bare, plain.env)
    cached = _median_ratio(plain.bare, np.add(plain.alone, plain.rest))
    alone = _median_ratio(falling.bare, falling.alone)
    return [
        Measure(f"vector env, {ROWS} rows, over bare Batch.step", ratio, "", ">= 0.85", ratio >= 0.85, detail),
        Measure("the same without falls and pushes", undisturbed, "", "a bound", True, "each is a call of its own"),
        Measure(
            "and with the rest of a step as fast as alone",
            cached,
            "",
            "a bound",
            True,
            "in turns with the physics it finds neither its data nor its code in the caches",
        ),
        Measure(
            "its simulation alone, with readings of the new state",
            alone,
            "",
            "a bound",
            True,
            "no env that knows the state after a step can be faster",
        ),
    ]


class _VectorTurns:
    """Turns of the vector environment, and from the same states of a bare batch and of a simulation like its own.

    Args:
        config: changes to the task's config.
    """

    def __init__(self, config: dict[str, Any]) -> None:
        self._env = gymnasium.make_vec(ENV_ID, num_envs=ROWS, config=config)
        assert isinstance(self._env.unwrapped, MiniQuadrupedVectorEnv)
        self._task = self._env.unwrapped.task
        model = self._task.simulation.model
        self._bare, self._own = Batch(model, ROWS), BatchSimulation(model, ROWS)
        self._rng = np.random.default_rng(0)
        self._env.reset(seed=0)
        self.env: list[float] = []
        """Time of the environment in each turn, s."""
        self.bare: list[float] = []
        """Time of a bare `Batch.step`, s."""
        self.alone: list[float] = []
        """Time of a simulation like the environment's own, s."""
        self.rest: list[float] = []
        """Time of the environment without its physics, s."""
        self.falls = 0

    def take(self) -> None:
        """One turn of all three."""
        state = self._task.simulation.batch.state.copy()  # type: ignore[attr-defined]
        actions = self._actions()
        self.env.append(seconds_of(lambda: self._step(actions)))
        controls = joint_targets(self._task, actions)
        for batch, step, seconds in (
            (self._bare, self._step_bare, self.bare),
            (self._own.batch, self._own.step, self.alone),
        ):
            batch.state[:] = state
            seconds.append(seconds_of(functools.partial(self._step_physics, step, controls)))

    def take_without_physics(self) -> None:
        """One turn of the environment, in which no robot moves."""
        actions = self._actions()
        with _without_physics(self._env):
            self.rest.append(seconds_of(lambda: self._step(actions)))

    def close(self) -> None:
        """Close the environment."""
        self._env.close()

    def _actions(self) -> NDArray[np.float32]:
        return self._rng.uniform(-1.0, 1.0, (_VECTOR_STEPS, ROWS, ROBOT.num_joints)).astype(np.float32)

    def _step(self, actions: NDArray[np.float32]) -> None:
        for action in actions:
            _, _, terminated, truncated, _ = self._env.step(action)
            self.falls += int((terminated | truncated).sum())

    def _step_physics(self, step: Callable[..., None], controls: NDArray[np.float64]) -> None:
        for control in controls:
            step(control, self._task.config.decimation)

    def _step_bare(self, control: NDArray[np.float64], substeps: int) -> None:
        self._bare.bind("ctrl")[:] = control
        self._bare.step(nstep=substeps)


def _median_ratio(seconds: ArrayLike, other: ArrayLike) -> float:
    """Median of the turns' ratios, without the first turn."""
    return float(np.median(np.divide(seconds, other)[1:]))


def cost_by_rows(sizes: Sequence[int] = (64, 256, 1024, 4096), chunks: int = 40) -> list[Measure]:
    """Cost of an env step by the number of envs, and the share of it outside of the physics, by number of threads.

    Args:
        sizes: numbers of envs, the largest last.
        chunks: how often they take turns. Each turn has as many env steps, and few, as a machine's speed varies.
    """
    threads = [2**i for i in range((os.cpu_count() or 1).bit_length())]
    return [measure for count in threads for measure in _cost_by_rows(sizes, chunks, count)]


def _cost_by_rows(sizes: Sequence[int], chunks: int, num_threads: int) -> list[Measure]:
    rng = np.random.default_rng(0)
    envs = [gymnasium.make_vec(ENV_ID, num_envs=size, num_threads=num_threads) for size in sizes]
    for env in envs:
        env.reset(seed=0)
    turns = np.array([[_costs(env, sizes[-1] // env.num_envs, rng) for env in envs] for _ in range(chunks + 1)])
    for env in envs:
        env.close()
    # Ratios within a turn, so that a machine that slows down does not change them.
    costs = np.median(turns[1:] / turns[1:, -1:], axis=0) * np.median(turns[1:, -1:], axis=0)
    total, rest, cached = costs.T
    detail = ", ".join(
        f"{size}: {cost:.1f} us, {share:.0%} outside of the physics"
        for size, cost, share in zip(sizes, total, rest / total, strict=True)
    )
    spread, bound = (float(column.max() / column.min()) for column in (total, cached))
    name = f"cost per env step, {sizes[0]} to {sizes[-1]} rows, most over least, threads: {num_threads}"
    return [
        Measure(name, spread, "x", "<= 1.1", spread <= 1.1, detail),
        Measure("the same with the rest of a step as fast as alone", bound, "x", "a bound", True, "see above"),
    ]


def _run(env: Any, actions: Iterable[Any]) -> None:
    for action in actions:
        env.step(action)


def _costs(env: Any, steps: int, rng: np.random.Generator) -> tuple[float, float, float]:
    """Cost per env step in us: in all, outside of the physics, and in all with the rest as fast as alone."""
    actions = rng.uniform(-1.0, 1.0, (steps, env.num_envs, ROBOT.num_joints)).astype(np.float32)
    run = functools.partial(_run, env, actions)
    with _watched_physics(env) as physics:
        total = seconds_of(run)
    with _without_physics(env):
        alone = seconds_of(run)
    scale = 1e6 / (steps * env.num_envs)
    return scale * total, scale * (total - sum(physics)), scale * (sum(physics) + alone)


def randomized_over_plain(rows: int = ROWS, steps: int = 60, chunks: int = CHUNKS) -> list[Measure]:
    """The native vector environment with the preset `hard` over without, on robots that walk with the scripted gait.

    Args:
        rows: number of envs.
        steps: steps of each turn.
        chunks: how often both take turns.
    """
    presets = {preset: {"randomization": preset} for preset in ("none", "hard")}
    envs = {
        preset: gymnasium.make_vec(ENV_ID, num_envs=rows, action_mode="residual", config=config)
        for preset, config in presets.items()
    }
    for env in envs.values():
        env.reset(seed=0)
    no_change = np.zeros((rows, ROBOT.num_joints), np.float32)
    ratios, bounds, outside = [], [], []
    for _ in range(chunks + 1):
        seconds, physics = {}, {}
        for preset, env in envs.items():
            with _watched_physics(env) as moving:
                seconds[preset] = seconds_of(functools.partial(_run, env, [no_change] * steps))
            physics[preset] = sum(moving)
        ratios.append(seconds["none"] / seconds["hard"])
        rest = {preset: seconds[preset] - physics[preset] for preset in envs}
        bounds.append(seconds["none"] / (physics["hard"] + rest["none"]))
        outside.append([1e3 * rest[preset] / steps for preset in envs])
    for env in envs.values():
        env.close()
    ratio, bound = float(np.median(ratios[1:])), float(np.median(bounds[1:]))
    plain, randomized = np.median(outside[1:], axis=0)
    detail = f"outside of the physics {randomized:.2f} ms per step, without {plain:.2f} ms"
    what = "delays, changed models and pushes make the physics slower"
    return [
        Measure(f"vector env, {rows} rows, hard over none", ratio, "", ">= 0.90", ratio >= 0.9, detail),
        Measure("the same, if only the physics cost more", bound, "", "a bound", True, what),
    ]


@contextlib.contextmanager
def _watched_physics(env: Any) -> Iterator[list[float]]:
    """Within the context, an env's physics steps add the time that they take to the list, s."""
    simulation = env.unwrapped.task.simulation
    step, seconds = simulation.step, []

    def watched(*arguments: Any) -> None:
        seconds.append(seconds_of(lambda: step(*arguments)))

    with mock.patch.object(simulation, "step", watched):
        yield seconds


def _without_physics(env: Any) -> contextlib.AbstractContextManager[Any]:
    """Within the context, no robot of an env moves."""
    # Not a mock, each call of which takes a while.
    return mock.patch.object(env.unwrapped.task.simulation, "step", lambda *_: None)  # noqa: PT008


def single_over_ant() -> list[Measure]:
    """The single environment over Gymnasium's Ant-v5, and its time above a bare `mj_step`."""
    env, ant = gymnasium.make(ENV_ID), gymnasium.make("Ant-v5")
    assert isinstance(env.unwrapped, MiniQuadrupedEnv)
    model, decimation = env.unwrapped.model, env.unwrapped.task.config.decimation
    data = mujoco.MjData(model)
    steps = 400

    def run(environment: gymnasium.Env[Any, Any], actions: Any) -> Callable[[], None]:
        def work() -> None:
            for action in actions:
                _, _, terminated, truncated, _ = environment.step(action)
                if terminated or truncated:
                    environment.reset()

        return work

    rng = np.random.default_rng(0)
    env.reset(seed=0)
    ant.reset(seed=0)
    ratios, above, rates = [], [], []
    for _ in range(CHUNKS + 1):
        actions = rng.uniform(-1.0, 1.0, (steps, ROBOT.num_joints)).astype(np.float32)
        spec = mujoco.mjtState.mjSTATE_INTEGRATION
        state = np.empty(mujoco.mj_stateSize(model, spec))
        mujoco.mj_getState(model, env.unwrapped.data, state, spec)
        own = seconds_of(run(env, actions))
        other = seconds_of(run(ant, actions))
        mujoco.mj_setState(model, data, state, spec)
        controls = joint_targets(env.unwrapped.task, actions)

        def step_bare(controls: Any = controls) -> None:
            for control in controls:
                data.ctrl = control
                mujoco.mj_step(model, data, decimation)

        bare = seconds_of(step_bare)
        ratios.append(other / own)
        rates.append(steps / own)
        above.append((own - bare) / steps * 1e6)
    ratio, micros = float(np.median(ratios[1:])), float(np.median(above[1:]))
    return [
        Measure(
            "single env over Ant-v5, steps alone",
            ratio,
            "x",
            ">= 1.4",
            ratio >= 1.4,
            f"{np.median(rates[1:]):,.0f} steps/s, actions drawn before",
        ),
        Measure("single env above bare mj_step", micros, "us/step", "", True, ""),
    ]


def gymnasium_over_ant(chunks: int = 9, seconds: int = 1) -> list[Measure]:
    """Gymnasium's own benchmarks over Ant-v5: steps with resets and drawn actions, and making an environment.

    Args:
        chunks: how often the two environments take turns.
        seconds: of each turn.
    """
    env, ant = gymnasium.make(ENV_ID), gymnasium.make("Ant-v5")
    env.reset(seed=0)
    ant.reset(seed=0)
    steps, inits, resets, rates = [], [], [], []
    for _ in range(chunks):
        own = benchmark_step(env, seconds)
        steps.append(own / benchmark_step(ant, seconds))
        rates.append(own)
        own = benchmark_init(lambda: gymnasium.make(ENV_ID), seconds)
        inits.append(own / benchmark_init(lambda: gymnasium.make("Ant-v5"), seconds))
        resets.append(
            seconds_of(lambda: [env.reset() for _ in range(200)])
            / seconds_of(lambda: [ant.reset() for _ in range(200)])
        )
    env.close()
    ant.close()
    step, init, reset = float(np.median(steps)), float(np.median(inits)), float(np.median(resets))
    detail = f"{np.median(rates):,.0f} steps/s, drawing the actions and resets included"
    return [
        Measure("Gymnasium's benchmark_step, over Ant-v5", step, "x", ">= 1.9", step >= 1.9, detail),
        Measure("Gymnasium's benchmark_init, over Ant-v5", init, "x", ">= 1.2", init >= 1.2, "make and first reset"),
        Measure("time of a reset, over Ant-v5's", reset, "x", "<= 3", reset <= 3.0, ""),
    ]


def vector_over_sync() -> list[Measure]:
    """The native vector environment over `SyncVectorEnv` of the single one."""
    native = gymnasium.make_vec(ENV_ID, num_envs=SYNC_ROWS)
    sync = gymnasium.make_vec(
        ENV_ID,
        num_envs=SYNC_ROWS,
        vectorization_mode="sync",
        vector_kwargs={"autoreset_mode": AutoresetMode.SAME_STEP},
    )
    rng = np.random.default_rng(0)
    native.reset(seed=0)
    sync.reset(seed=0)
    ratios = []
    for _ in range(CHUNKS + 1):
        actions = rng.uniform(-1.0, 1.0, (20, SYNC_ROWS, ROBOT.num_joints)).astype(np.float32)

        def run(env: Any, actions: Any = actions) -> float:
            return seconds_of(lambda: [env.step(action) for action in actions])

        ratios.append(run(sync) / run(native))
    native.close()
    sync.close()
    ratio = float(np.median(ratios[1:]))
    return [Measure(f"vector env over SyncVectorEnv, {SYNC_ROWS} rows", ratio, "x", ">= 4", ratio >= 4.0, "")]
