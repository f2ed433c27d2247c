"""Measure the speed of the task and of training on a GPU, with MuJoCo Warp and rsl-rl."""

import argparse
import sys
from dataclasses import asdict
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a checkout need not be installed

import quadruped_env  # noqa: F401  (first, since it checks this Python)
from quadruped_env.utils.files import write_json
from quadruped_env.utils.program import run_program
from quadruped_env.utils.provenance import machine, versions


def main() -> int:
    """Parse the arguments and measure; fails where a goal is not reached on a GPU."""
    parser = argparse.ArgumentParser(
        description="Environment steps and training steps per second and memory at several numbers of envs, and the "
        "wall clock of learning until a policy walks, without compilation. Prints a Markdown table and writes JSON. "
        "On a CPU (--device warp-cpu, with small numbers) it shows only that everything runs.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("--device", default="cuda", help="cuda, cuda:N, or warp-cpu")
    parser.add_argument("--num-envs", type=int, nargs="+", default=[1024, 2048, 4096, 8192, 16384], metavar="N")
    parser.add_argument("--steps", type=int, default=24, help="control steps of each env in an update")
    parser.add_argument("--updates", type=int, default=10, help="updates that are measured")
    parser.add_argument("--walk", type=int, default=4096, metavar="N", help="envs of the training to walk; 0: none")
    parser.add_argument("--action-mode", default="position", help="action mode of that training")
    parser.add_argument("--limit", type=float, default=120.0, help="s of learning after which that training ends")
    parser.add_argument("--interval", type=float, default=1.0, help="s of learning between tests of the policy")
    parser.add_argument("-o", "--output", type=Path, default=Path("results/gpu_speed.json"), help="where to write JSON")
    arguments = parser.parse_args()
    return run_program(parser.prog, lambda: run(arguments))


def run(arguments: argparse.Namespace) -> int:
    """Do the work, and print and write the results."""
    from benchmarks.gpu_speed import check_counts, measure, table, unreached, walk

    check_counts(arguments.num_envs)
    device = arguments.device
    print(f"MuJoCo Warp compiles its kernels for {device} once per machine, which takes minutes", flush=True)
    speeds = [measure(device, count, arguments.steps, arguments.updates) for count in arguments.num_envs]
    walked = None
    if arguments.walk:
        print(f"training {arguments.walk} envs until the policy walks", flush=True)
        walked = walk(
            device,
            arguments.walk,
            arguments.steps,
            arguments.limit,
            arguments.interval,
            action_mode=arguments.action_mode,
        )
    print(f"\n{table(speeds)}\n")
    if walked is not None:
        found = "not within the limit" if walked.seconds is None else f"{walked.seconds:.1f} s"
        print(f"time to walk with {walked.num_envs} envs, without compilation: {found}, {walked.timesteps:,} steps")
    document = {
        "device": device_name(device),
        "machine": machine(),
        "versions": versions(),
        "speeds": [asdict(speed) for speed in speeds],
        "walk": None if walked is None else asdict(walked),
    }
    write_json(arguments.output, document)
    print(f"measured on {document['device']}; written to {arguments.output}")
    missed = unreached(speeds) if device.startswith("cuda") else []
    for line in missed:
        print(f"not reached: {line}")
    return 1 if missed else 0


def device_name(device: str) -> str:
    """Name of the GPU, or of the machine whose CPU stands for it."""
    import torch

    return torch.cuda.get_device_name(device) if device.startswith("cuda") else f"the CPU of {machine()}"


if __name__ == "__main__":
    sys.exit(main())
