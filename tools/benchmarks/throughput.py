"""Speed and memory, as ratios taken within one run: the machine's own speed cancels."""

import tempfile
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from benchmarks import env_speed, terrain_speed
from benchmarks.env_speed import CHUNKS, NUM_ENVS, ROBOT
from benchmarks.measures import Measure, Say, row, run_python, seconds_of


def terrain_over_plane(chunks: int = CHUNKS) -> list[Measure]:
    """Physics on tiles of all kinds and levels over that on the plane; `chunks`: how often the grounds take turns."""
    ratio, step = terrain_speed.ratios(NUM_ENVS, chunks)
    detail = f"a physics step on the plane takes {step:.1f} us"
    return [Measure("physics on tiles over that on the plane", ratio, "x", "<= 1.5", ratio <= 1.5, detail)]


_MEMORY_PROGRAM: Final = """
import json, os, sys
from pathlib import Path
import psutil
from quadruped_env.training import TrainConfig, train
process, seen = psutil.Process(), []
class Watched(train.Recorder):
    def _on_rollout_end(self):
        super()._on_rollout_end()
        seen.append((self.num_timesteps, process.memory_info().rss))
train.Recorder = Watched
train.train(TrainConfig(timesteps=int(sys.argv[1]), name="memory"), Path(sys.argv[2]), "memory benchmark")
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


_ENVS_PROGRAM: Final = """
import json, sys
import gymnasium, numpy, psutil
import quadruped_env
def resident(num_envs):
    env = gymnasium.make_vec("MiniQuadruped-v0", num_envs=num_envs)
    env.reset(seed=0)
    for _ in range(5):
        env.step(numpy.zeros(env.action_space.shape, numpy.float32))
    used = psutil.Process().memory_info().rss
    env.close()
    return used
few, many = resident(4), resident(int(sys.argv[1]))
print(json.dumps({"bytes": many - few}))
"""


def env_memory(num_envs: int = 4096) -> list[Measure]:
    """Resident memory that the native vector environment takes for many envs."""
    used = run_python(_ENVS_PROGRAM, str(num_envs))["bytes"] / 2**20
    detail = f"{1024 * used / num_envs:.0f} KiB per env"
    return [Measure(f"resident memory of {num_envs} envs", used, "MiB", "<= 100", used <= 100, detail)]


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


def kinematics() -> list[Measure]:
    """Forward kinematics of a million poses of the whole robot, on one core."""
    low, high = ROBOT.joint_position_low, ROBOT.joint_position_high
    positions = np.random.default_rng(0).uniform(low, high, (1_000_000, ROBOT.num_joints))
    seconds = float(np.median([seconds_of(lambda: ROBOT.forward_kinematics(positions)) for _ in range(3)]))
    links = f"all {len(ROBOT.link_names)} links"
    return [Measure("forward kinematics of 1,000,000 poses", seconds, "s", "< 3", seconds < 3.0, links)]


WORKS: Final[dict[str, Callable[[], list[Measure]]]] = {
    "import": import_time,
    "kinematics": kinematics,
    **env_speed.WORKS,
    "terrain": terrain_over_plane,
    "env-memory": env_memory,
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
