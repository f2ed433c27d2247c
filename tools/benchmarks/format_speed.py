"""Speed and memory of long recordings: messages per second that one core reads and writes, and peak memory."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from benchmarks.measures import HEADER, Measure, row, run_python

MIN_RATE: Final = 30_000
"""Minimum speed of reading MCAP on one core, messages per second."""
MAX_MEMORY: Final = 300
"""Maximum resident memory, MB, independent of the length of the recording."""
BLOCK: Final = 4096

_START: Final = """
import json, sys, time
from pathlib import Path
import numpy as np
from benchmarks.render_speed import stay_on_one_core
from quadruped_env import JointTrajectory
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.trajectory import saving
from quadruped_env.trajectory.loading import Stream
from quadruped_env.trajectory.read_options import ReadOptions
stay_on_one_core()
"""
_END: Final = """
seconds = time.perf_counter() - start
(peak,) = [line.split()[1] for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM")]
print(json.dumps({"seconds": seconds, "messages": messages, "peak": int(peak) * 1024}))
"""
_WRITE: Final = f"""
rng, count = np.random.default_rng(0), int(sys.argv[2])
def pieces():
    for first in range(0, count, {BLOCK}):
        n = min({BLOCK}, count - first)
        numbers = rng.uniform(-1.0, 1.0, (3, n, MINI_QUADRUPED.num_joints))
        timestamps = 1_700_000_000_000_000_000 + 20_000_000 * np.arange(first, first + n)
        yield JointTrajectory(timestamps, MINI_QUADRUPED.joint_names, *numbers).to_rows()
start = time.perf_counter()
saving.save(pieces(), Path(sys.argv[1]), saving.WriteOptions())
messages = count
"""
_STREAM: Final = """
start = time.perf_counter()
messages = sum(len(piece) for piece in Stream(sys.argv[1]))
"""
_LOAD: Final = """
start = time.perf_counter()
messages = len(JointTrajectory.load(sys.argv[1]))
"""
_CONVERT: Final = """
from quadruped_env.trajectory.file_conversion import convert
start = time.perf_counter()
messages = convert(Path(sys.argv[1]), Path(sys.argv[2]), ReadOptions(), saving.WriteOptions()).rows
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
        take("write MCAP with /tf", _WRITE, mcap, count)
        take("read MCAP, streaming", _STREAM, mcap, goal=MIN_RATE)
        take("read MCAP into one trajectory", _LOAD, mcap, goal=MIN_RATE)
        take("convert MCAP to sqlite3", _CONVERT, mcap, db3)
        take("read sqlite3, streaming", _STREAM, db3)
        db3.unlink()
        take("convert MCAP to CSV", _CONVERT, mcap, csv)
        take("read CSV, streaming", _STREAM, csv)
    return measures


def _measures(name: str, found: dict[str, Any], goal: int | None) -> list[Measure]:
    rate, peak = found["messages"] / found["seconds"], found["peak"] / 1e6
    detail = f"{found['messages']:,} messages in {found['seconds']:.1f} s"
    reach = "" if goal is None else f">= {goal:,}"
    return [
        Measure(name, rate, "messages/s", reach, goal is None or rate >= goal, detail),
        Measure("its highest resident memory", peak, "MB", f"<= {MAX_MEMORY}", peak <= MAX_MEMORY, ""),
    ]
