"""Measure a sweep over several seeds against as many trainings in a row, and what its processes need in memory."""

import argparse
import contextlib
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env.errors import QuadrupedError
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions

ROOT = Path(__file__).parents[1]
SAMPLE_INTERVAL = 0.5
"""Time between samples of the memory, s."""


def main() -> int:
    """Parse the arguments, measure, and print the ratio."""
    parser = argparse.ArgumentParser(
        description="Train some seeds of one config one after another with 'train' on all cores, and the same "
        "seeds with 'sweep'; compare the wall clock, with all starts of programs and of Ray. Let nothing else "
        "run meanwhile.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--seeds", type=int, default=8, help="number of seeds")
    parser.add_argument("--timesteps", type=int, default=3_000_000, help="budget of each training")
    parser.add_argument("--cores-per-trial", type=int, default=1, help="cores of each trial of the sweep")
    parser.add_argument("--score", default="none", help="score of the sweep's trials; trainings by hand have none")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path("results/sweep_speed.json"), help="where to write JSON"
    )
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    budget = ["--timesteps", str(arguments.timesteps)]
    with tempfile.TemporaryDirectory() as name:
        by_hand = []
        for seed in range(arguments.seeds):
            seconds, _ = timed(["train/ppo.py", *budget, "--seed", str(seed), "-o", f"{name}/runs"])
            by_hand.append(seconds)
            print(f"by hand, seed {seed}: {seconds:.1f} s", flush=True)
        options = ["--cores-per-trial", str(arguments.cores_per_trial), "--score", arguments.score]
        sweep, memory = timed(
            ["train/sweep.py", *budget, "--seeds", str(arguments.seeds), *options, "-o", f"{name}/sweeps"]
        )
    ratio = sweep / sum(by_hand)
    print(f"sweep: {sweep:.1f} s\nby hand: {sum(by_hand):.1f} s\nratio: {ratio:.2f}")
    print("memory of the sweep at its peak: " + ", ".join(f"{kind} {value:.0f} MB" for kind, value in memory.items()))
    document = {
        "machine": machine(),
        "versions": versions(),
        **{name: getattr(arguments, name) for name in ("seeds", "timesteps", "cores_per_trial", "score")},
        "by_hand_seconds": by_hand,
        "sweep_seconds": sweep,
        "ratio": ratio,
        "memory_mb": memory,
    }
    write_json(arguments.output, document)
    print(f"numbers: {arguments.output}")
    return 0


def timed(command: Sequence[str]) -> tuple[float, dict[str, float]]:
    """Run a program of the checkout; its wall clock in s, and the peak memory of its processes in MB, by kind.

    Raises:
        QuadrupedError: if it fails.
    """
    began = time.perf_counter()
    process = subprocess.Popen(  # noqa: S603
        [sys.executable, *command], cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8"
    )
    peak: dict[str, float] = {}
    ended = threading.Event()
    sampler = threading.Thread(target=sample_memory, args=(process.pid, peak, ended))
    sampler.start()
    _, errors = process.communicate()
    seconds = time.perf_counter() - began
    ended.set()
    sampler.join()
    if process.returncode:
        raise QuadrupedError(f"{' '.join(command)}: ended with status {process.returncode}: {errors[-300:]}")
    return seconds, peak


def sample_memory(pid: int, peak: dict[str, float], ended: threading.Event) -> None:
    """Keep the largest memory of the processes of a sweep: its driver, each trial, and Ray's own together.

    Pages that several processes share count for each in proportion (PSS).
    """
    import psutil

    while not ended.wait(SAMPLE_INTERVAL):
        found: dict[str, float] = {"driver": 0.0, "one trial": 0.0, "Ray": 0.0}
        with contextlib.suppress(psutil.NoSuchProcess):
            driver = psutil.Process(pid)
            for process in (driver, *driver.children(recursive=True)):
                with contextlib.suppress(psutil.NoSuchProcess, psutil.AccessDenied):
                    memory = process.memory_full_info().pss / 1e6
                    trial = " ".join(process.cmdline()).startswith("ray::ImplicitFunc")
                    kind = "driver" if process == driver else "one trial" if trial else "Ray"
                    found[kind] = max(found[kind], memory) if trial else found[kind] + memory
        for kind, value in found.items():
            peak[kind] = max(peak.get(kind, 0.0), value)


if __name__ == "__main__":
    sys.exit(main())
