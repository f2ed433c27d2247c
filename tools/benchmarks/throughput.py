"""Speed and memory, as ratios taken within one run: the machine's own speed cancels.

Each measure interleaves the two things that it compares, chunk by chunk, and reports the median of the chunks' ratios.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Final

import gymnasium
import mujoco
import numpy as np
from gymnasium.utils.performance import benchmark_init, benchmark_step
from gymnasium.vector import AutoresetMode
from mujoco.batch import Batch
from numpy.typing import NDArray

from benchmarks import terrain_speed
from quadruped_env.envs import ENV_ID, MiniQuadrupedEnv, MiniQuadrupedVectorEnv
from quadruped_env.files import write_json
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation.interface import SETTLED
from quadruped_env.task import Task

ROWS: Final = 256
SYNC_ROWS: Final = 64
ROBOT: Final = MINI_QUADRUPED
CHUNKS: Final = 15

FALLING: Final = {"randomization": {"push_velocity": 3.0, "push_interval": (1.0, 4.0)}}
"""Random actions alone hardly ever throw this robot over: pushes make it fall every few seconds."""

Say = Callable[[str], None]


@dataclass(frozen=True)
class Measure:
    """One measurement, a row of the table."""

    name: str
    value: float
    unit: str
    reach: str
    """Target value, as text"""
    reached: bool
    detail: str


def _seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def _joint_targets(task: Task, actions: NDArray[Any]) -> NDArray[np.float64]:
    """Joint targets for actions (..., J) in position mode, rad."""
    robot = task.control.robot
    target = robot.stance + task.config.action.position_scale * actions.astype(np.float64)
    return np.clip(target, robot.joint_position_low, robot.joint_position_high)


def vector_over_bare() -> list[Measure]:
    """The native vector environment over a bare `Batch.step` from the same states with the same controls."""
    env = gymnasium.make_vec(ENV_ID, num_envs=ROWS, config=FALLING)
    assert isinstance(env.unwrapped, MiniQuadrupedVectorEnv)
    simulation = env.unwrapped.task.simulation
    batch: Batch = simulation.batch  # type: ignore[attr-defined]
    decimation = env.unwrapped.task.config.decimation
    bare = Batch(simulation.model, ROWS)
    own = Batch(simulation.model, ROWS, persistent=True)
    rng = np.random.default_rng(0)
    env.reset(seed=0)
    steps = 60
    ratios, own_ratios, rates, bare_rates, resets = [], [], [], [], 0
    for _ in range(CHUNKS + 1):
        actions = rng.uniform(-1.0, 1.0, (steps, ROWS, ROBOT.num_joints)).astype(np.float32)
        state = batch.state.copy()
        controls = _joint_targets(env.unwrapped.task, actions)
        env_seconds = 0.0
        for action in actions:
            start = time.perf_counter()
            _, _, terminated, truncated, _ = env.step(action)
            env_seconds += time.perf_counter() - start
            resets += int((terminated | truncated).sum())

        def step(batch: Batch, stage: Any, state: Any = state, controls: Any = controls) -> float:
            batch.state[:] = state
            ctrl = batch.bind("ctrl")
            start = time.perf_counter()
            for control in controls:
                ctrl[:] = control
                batch.step(nstep=decimation, stage=stage)
            return time.perf_counter() - start

        bare_seconds = step(bare, mujoco.mjtStage.mjSTAGE_NONE)
        own_ratios.append(bare_seconds / step(own, SETTLED))
        ratios.append(bare_seconds / env_seconds)
        rates.append(steps * ROWS / env_seconds)
        bare_rates.append(steps * ROWS / bare_seconds)
    env.close()
    ratio = float(np.median(ratios[1:]))
    detail = (
        f"{np.median(rates[1:]):,.0f} of {np.median(bare_rates[1:]):,.0f} env steps/s; {resets} falls in "
        f"{(CHUNKS + 1) * steps * ROWS:,} steps"
    )
    alone = float(np.median(own_ratios[1:]))
    what = "no env that knows the state after a step can be faster"
    return [
        Measure(f"vector env, {ROWS} rows, over bare Batch.step", ratio, "", ">= 0.92", ratio >= 0.92, detail),
        Measure("its batch alone, with readings of the new state", alone, "", "a bound", True, what),
    ]


def cost_by_rows(sizes: Sequence[int] = (64, 256, 1024, 4096), chunks: int = 5) -> list[Measure]:
    """Cost of an env step by the number of envs, and the share of it outside of the physics, by number of threads.

    Args:
        sizes: numbers of envs.
        chunks: how often they take turns; each turn has as many env steps.
    """
    threads = [2**i for i in range((os.cpu_count() or 1).bit_length())]
    measures = []
    rng = np.random.default_rng(0)
    for count in threads:
        envs = {size: gymnasium.make_vec(ENV_ID, num_envs=size, num_threads=count) for size in sizes}
        physics: dict[int, float] = {}
        for size, env in envs.items():
            _watch_physics(env, physics, size)
            env.reset(seed=0)
        turns: dict[int, list[float]] = {size: [] for size in sizes}
        steps = {size: max(4, 4 * max(sizes) // size) for size in sizes}
        for chunk in range(chunks + 1):
            for size, env in envs.items():
                actions = rng.uniform(-1.0, 1.0, (steps[size], size, ROBOT.num_joints)).astype(np.float32)
                start = time.perf_counter()
                for action in actions:
                    env.step(action)
                turns[size].append(time.perf_counter() - start)
                if chunk == 0:
                    turns[size].clear()
                    physics[size] = 0.0
        for env in envs.values():
            env.close()
        costs = {size: float(np.median(turns[size])) / (steps[size] * size) * 1e6 for size in sizes}
        spread = max(costs.values()) / min(costs.values())
        detail = ", ".join(
            f"{size}: {costs[size]:.1f} us, {1.0 - physics[size] / sum(turns[size]):.0%} outside of the physics"
            for size in sizes
        )
        name = f"cost per env step, {min(sizes)} to {max(sizes)} rows, most over least, threads: {count}"
        measures.append(Measure(name, spread, "x", "<= 1.1", spread <= 1.1, detail))
    return measures


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
    physics: dict[str, float] = {}
    for preset, env in envs.items():
        _watch_physics(env, physics, preset)
        env.reset(seed=0)
    no_change = np.zeros((rows, ROBOT.num_joints), np.float32)
    ratios, physics_ratios, own = [], [], []
    for _ in range(chunks + 1):
        seconds = {}
        physics.clear()
        for preset, env in envs.items():
            start = time.perf_counter()
            for _ in range(steps):
                env.step(no_change)
            seconds[preset] = time.perf_counter() - start
        ratios.append(seconds["none"] / seconds["hard"])
        physics_ratios.append(physics["none"] / physics["hard"])
        own.append([1e3 * (seconds[preset] - physics[preset]) / steps for preset in envs])
    for env in envs.values():
        env.close()
    ratio, alone, outside = np.median(ratios[1:]), np.median(physics_ratios[1:]), np.median(own[1:], axis=0)
    detail = f"outside of the physics {outside[0]:.2f} and {outside[1]:.2f} ms per step"
    what = "delays and changed models cost more physics"
    return [
        Measure(f"vector env, {rows} rows, hard over none", float(ratio), "", ">= 0.90", bool(ratio >= 0.9), detail),
        Measure("its physics alone", float(alone), "", "a bound", True, what),
    ]


def _watch_physics(env: Any, seconds: dict[Any, float], size: Any) -> None:
    """Add the time of an env's physics steps to `seconds[size]`."""
    simulation = env.unwrapped.task.simulation
    step = simulation.step

    def watched(*arguments: Any) -> None:
        seconds[size] = seconds.get(size, 0.0) + _seconds(lambda: step(*arguments))

    simulation.step = watched


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
        own = _seconds(run(env, actions))
        other = _seconds(run(ant, actions))
        mujoco.mj_setState(model, data, state, spec)
        controls = _joint_targets(env.unwrapped.task, actions)

        def step_bare(controls: Any = controls) -> None:
            for control in controls:
                data.ctrl = control
                mujoco.mj_step(model, data, decimation)

        bare = _seconds(step_bare)
        ratios.append(other / own)
        rates.append(steps / own)
        above.append((own - bare) / steps * 1e6)
    ratio, micros = float(np.median(ratios[1:])), float(np.median(above[1:]))
    return [
        Measure(
            "single env over Ant-v5, steps alone",
            ratio,
            "x",
            ">= 2.2",
            ratio >= 2.2,
            f"{np.median(rates[1:]):,.0f} steps/s, actions drawn before",
        ),
        Measure("single env above bare mj_step", micros, "us/step", "<= 60", micros <= 60.0, ""),
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
            _seconds(lambda: [env.reset() for _ in range(200)]) / _seconds(lambda: [ant.reset() for _ in range(200)])
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
            return _seconds(lambda: [env.step(action) for action in actions])

        ratios.append(run(sync) / run(native))
    native.close()
    sync.close()
    ratio = float(np.median(ratios[1:]))
    return [Measure(f"vector env over SyncVectorEnv, {SYNC_ROWS} rows", ratio, "x", ">= 4", ratio >= 4.0, "")]


def training_over_bare() -> list[Measure]:
    """PPO end to end over a bare `Batch.step` on all cores."""
    from quadruped_env.envs import make_sb3_vec_env
    from quadruped_env.training.config import TrainConfig, defaults
    from quadruped_env.training.models import make_model

    config = TrainConfig(action_mode="position", **defaults("ppo", "position"))
    env = make_sb3_vec_env(config.num_envs, seed=0, action_mode="position")
    model = make_model(config, env)
    steps = config.n_steps * config.num_envs
    model.learn(4 * steps)
    simulation = env.task.simulation
    batch: Batch = simulation.batch  # type: ignore[attr-defined]
    bare = Batch(simulation.model, config.num_envs)
    ctrl = bare.bind("ctrl")
    rng = np.random.default_rng(0)
    ratios, rates = [], []
    for _ in range(CHUNKS):
        state = batch.state.copy()
        seconds = _seconds(lambda: model.learn(4 * steps, reset_num_timesteps=False))
        bare.state[:] = state
        shape = 4 * config.n_steps, config.num_envs, ROBOT.num_joints
        controls = _joint_targets(env.task, 0.3 * rng.uniform(-1.0, 1.0, shape))

        def step_bare(controls: Any = controls) -> None:
            for control in controls:
                ctrl[:] = control
                bare.step(nstep=env.task.config.decimation)

        ratios.append(_seconds(step_bare) / seconds)
        rates.append(4 * steps / seconds)
    ratio = float(np.median(ratios))
    detail = f"{np.median(rates):,.0f} training steps/s"
    return [Measure("PPO end to end over bare Batch.step", ratio, "", ">= 0.70", ratio >= 0.70, detail)]


def terrain_over_plane(chunks: int = CHUNKS) -> list[Measure]:
    """Physics on tiles of all kinds and levels over that on the plane; `chunks`: how often the grounds take turns."""
    ratio, step = terrain_speed.ratios(ROWS, chunks)
    detail = f"a physics step on the plane takes {step:.1f} us"
    return [Measure("physics on tiles over that on the plane", ratio, "x", "<= 1.5", ratio <= 1.5, detail)]


_MEMORY_PROGRAM: Final = """
import json, os, sys
from pathlib import Path
import psutil
from quadruped_env.training import TrainConfig
from quadruped_env.training import ppo
process, seen = psutil.Process(), []
class Watched(ppo.Recorder):
    def _on_rollout_end(self):
        super()._on_rollout_end()
        seen.append((self.num_timesteps, process.memory_info().rss))
ppo.Recorder = Watched
ppo.train(TrainConfig(timesteps=int(sys.argv[1]), name="memory"), Path(sys.argv[2]), "memory benchmark")
start = next(rss for steps, rss in seen if steps >= 0.1 * seen[-1][0])
print(json.dumps({"peak": max(rss for _, rss in seen), "growth": seen[-1][1] - start}))
"""


def training_memory(timesteps: int) -> list[Measure]:
    """Resident memory of a training with 256 envs, and its growth over the last 90 % of the steps."""
    with tempfile.TemporaryDirectory() as directory:
        found = run_python(_MEMORY_PROGRAM, str(timesteps), directory)
    peak, growth = found["peak"] / 2**20, found["growth"] / 2**20
    return [
        Measure("resident memory, training with 256 envs", peak, "MiB", "<= 1024", peak <= 1024, ""),
        # An allocator varies by a few pages; a leak of one float per step would be 40 MB in 5 million steps.
        Measure(f"its growth over {timesteps:,} steps", growth, "MiB", "none (< 16)", growth < 16.0, ""),
    ]


_IMPORT_PROGRAM: Final = """
import json, time
import gymnasium, mujoco
start = time.perf_counter()
import quadruped_env
print(json.dumps({"seconds": time.perf_counter() - start}))
"""


def import_time() -> list[Measure]:
    """Time of `import quadruped_env` after gymnasium and mujoco."""
    seconds = float(np.median([run_python(_IMPORT_PROGRAM)["seconds"] for _ in range(7)]))
    return [Measure("import quadruped_env, above gymnasium and mujoco", seconds, "s", "<= 0.5", seconds <= 0.5, "")]


# Without this package, whose import is measured.
_END_WITH_PARENT: Final = """
import os, threading
threading.Thread(target=lambda: (os.read(0, 1), os._exit(1)), daemon=True).start()
"""
"""Ends a program with the one that started it and holds its standard input open."""


def run_python(program: str, *arguments: str) -> dict[str, Any]:
    """The JSON that a program prints as its last line, run in a process of its own that can import this package."""
    paths = str(Path(__file__).parents[1]), os.environ.get("PYTHONPATH")
    with subprocess.Popen(  # noqa: S603
        [sys.executable, "-c", _END_WITH_PARENT + program, *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONWARNINGS": "ignore", "PYTHONPATH": os.pathsep.join(filter(None, paths))},
    ) as process:
        assert process.stdout is not None
        output = process.stdout.read()
    if process.returncode:
        raise RuntimeError(f"a measurement ended with status {process.returncode}")
    return json.loads(output.strip().splitlines()[-1])


def kinematics() -> list[Measure]:
    """Forward kinematics of a million poses of the whole robot, on one core."""
    low, high = ROBOT.joint_position_low, ROBOT.joint_position_high
    positions = np.random.default_rng(0).uniform(low, high, (1_000_000, ROBOT.num_joints))
    seconds = float(np.median([_seconds(lambda: ROBOT.forward_kinematics(positions)) for _ in range(3)]))
    links = f"all {len(ROBOT.link_names)} links"
    return [Measure("forward kinematics of 1,000,000 poses", seconds, "s", "< 3", seconds < 3.0, links)]


WORKS: Final[dict[str, Callable[[], list[Measure]]]] = {
    "import": import_time,
    "kinematics": kinematics,
    "single": single_over_ant,
    "gymnasium": gymnasium_over_ant,
    "sync": vector_over_sync,
    "vector": vector_over_bare,
    "rows": cost_by_rows,
    "randomization": randomized_over_plain,
    "training": training_over_bare,
    "terrain": terrain_over_plane,
}
"""Name -> what is measured; `memory` comes after them"""
MEMORY: Final = "memory"


def run_all(memory_steps: int, say: Say, only: Sequence[str] = ()) -> list[Measure]:
    """Every measure of the table, or only those named, one after the other."""
    measures: list[Measure] = []
    works: dict[str, Callable[[], list[Measure]]] = {**WORKS, MEMORY: lambda: training_memory(memory_steps)}
    for name, work in works.items():
        if only and name not in only:
            continue
        found = work()
        measures += found
        for measure in found:
            say(row(measure))
    return measures


HEADER: Final = "| measure | value | reach | | detail |\n|---|---|---|---|---|"


def row(measure: Measure) -> str:
    """A row of the Markdown table."""
    value = f"{measure.value:.3g} {measure.unit}".strip()
    return f"| {measure.name} | {value} | {measure.reach} | {'yes' if measure.reached else 'NO'} | {measure.detail} |"


def write(measures: list[Measure], machine: str, versions: dict[str, str], path: Path) -> None:
    """Write the measures as JSON."""
    measured = [asdict(measure) for measure in measures]
    write_json(path, {"machine": machine, "versions": versions, "measures": measured})
