"""Speed and memory of long recordings: messages per second that one core reads and writes, and peak memory."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from benchmarks.measures import HEADER, Measure, row, run_python

MIN_RATE: Final = 30_000
"""Minimum speed of reading MCAP on one core, messages per second."""

_START: Final = """
import json, sys, time
from pathlib import Path
import numpy as np
from benchmarks.render_speed import stay_on_one_core
from quadruped_env import JointTrajectory
from quadruped_env.robot import MINI_QUADRUPED
stay_on_one_core()
"""
_END: Final = """
seconds = time.perf_counter() - start
(peak,) = [line.split()[1] for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM")]
print(json.dumps({"seconds": seconds, "messages": messages, "peak": int(peak) * 1024}))
"""
_WRITE: Final = """
count = int(sys.argv[2])
numbers = np.random.default_rng(0).uniform(-1.0, 1.0, (3, count, MINI_QUADRUPED.num_joints))
timestamps = 1_700_000_000_000_000_000 + 20_000_000 * np.arange(count)
trajectory = JointTrajectory(timestamps, MINI_QUADRUPED.joint_names, *numbers)
start = time.perf_counter()
trajectory.save(Path(sys.argv[1]))
messages = count
"""
_LOAD: Final = """
start = time.perf_counter()
messages = len(JointTrajectory.load(sys.argv[1]))
"""


def measure_formats(count: int, say: Callable[[str], None]) -> list[Measure]:
    """Write, read and convert a recording of `count` messages with 8 positions, velocities and efforts.

    Every work runs in a process of its own on one core; memory is the highest that the process ever had.
    """
    measures: list[Measure] = []

    def take(name: str, program: str, *arguments: Path | int, goal: int | None = None) -> None:
        found = run_python(_START + program + _END, *map(str, arguments))
        measures.extend(_measures(name, found, goal))
        for measure in measures[-2:]:
            say(row(measure))

    say(HEADER)
    with tempfile.TemporaryDirectory() as directory:
        mcap, db3, csv = (Path(directory) / f"recording.{suffix}" for suffix in ("mcap", "db3", "csv"))
        for name, path in (("MCAP", mcap), ("sqlite3", db3), ("CSV", csv)):
            take(f"write {name}", _WRITE, path, count)
            take(f"read {name}", _LOAD, path, goal=MIN_RATE if path is mcap else None)
    return measures


def _measures(name: str, found: dict[str, Any], goal: int | None) -> list[Measure]:
    rate, peak = found["messages"] / found["seconds"], found["peak"] / 1e6
    detail = f"{found['messages']:,} messages in {found['seconds']:.1f} s"
    reach = "" if goal is None else f">= {goal:,}"
    return [
        Measure(name, rate, "messages/s", reach, goal is None or rate >= goal, detail),
        Measure("its highest resident memory", peak, "MB", "", True, ""),
    ]
