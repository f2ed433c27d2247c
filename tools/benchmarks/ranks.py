"""Two ranks against one, with the same envs in total: steps per second, time to walk, and what an update exchanges.

Every measurement runs in processes of its own, and the ranks are those of `quadruped_env.scale.ranks`.
"""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Final

from quadruped_env.scale.ranks.job import threads_per_rank
from quadruped_env.utils.program import end_with_parent

NEVER: Final = float("inf")
_ITERATIONS: Final = 2
"""Rollouts and updates of each turn of the speed measurement."""
_WALKING: Final[Mapping[str, Any]] = {
    "action_mode": "position",
    "num_envs": 64,
    "batch_size": 256,
    "n_epochs": 6,
    "learning_rate": 5e-3,
    "log_std_init": -1.0,
    "task": {
        "command": {
            "forward_velocity": [0.3, 0.5],
            "standing_fraction": 0.0,
            "straight_fraction": 1.0,
            "turning_fraction": 0.0,
        }
    },
}
"""Settings of a training that walks soon and on every seed: straight ahead only, with many small updates. With the
default settings, seeds differ by more than anything that is compared here."""
_EPISODES: Final = 8
"""Episodes of a test of walking, few, so that it does not take as long as the training between."""
_COMMAND: Final = (0.5, 0.0)
_SPEED_TOLERANCE: Final = 0.1
"""Largest difference from the commanded speed with which a policy counts as walking, m/s."""


def run_ranks(measure: str, ranks: int, **values: Any) -> dict[str, Any]:
    """The result of a function of this module's `MEASURES` on rank 0, run on all ranks in processes of this machine."""
    with TemporaryDirectory() as folder, ExitStack() as stack:
        processes = []
        for rank in range(ranks):
            # One rank is plain training, which uses all cores.
            place = {"rank": rank, "ranks": ranks, "threads": threads_per_rank(ranks) if ranks > 1 else 0}
            arguments = json.dumps({"measure": measure, **place, "store": f"{folder}/store", **values})
            paths = str(Path(__file__).parents[1]), os.environ.get("PYTHONPATH")
            process = subprocess.Popen(  # noqa: S603
                [sys.executable, "-m", "benchmarks.ranks", arguments],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                encoding="utf-8",
                env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))},
            )
            processes.append(stack.enter_context(process))
        # Not `communicate`, which ends the input of one rank, and with it the rank, while others need it.
        outputs = [process.stdout.read() for process in processes if process.stdout is not None]
        for process in processes:
            process.wait()
    for rank, process in enumerate(processes):
        if process.returncode:
            raise RuntimeError(f"rank {rank} of {measure} ended with status {process.returncode}")
    return json.loads(outputs[0].strip().splitlines()[-1])


@dataclass(frozen=True)
class Speed:
    """Speed of the default training in one round."""

    steps_per_second: float
    rollout_seconds: float
    """Mean time of a rollout on rank 0, s"""
    update_seconds: float
    """Mean time of an update on rank 0, with its exchanges, s"""


def speeds(ranks: int, rounds: int) -> list[tuple[Speed, Speed]]:
    """Speed on one rank and on several, which train in turns: (one, several) of each round."""
    found = run_ranks("speed", ranks, rounds=rounds)
    return [(Speed(**one), Speed(**several)) for one, several in found["rounds"]]


@dataclass(frozen=True)
class Exchange:
    """Sizes and times of what the ranks exchange."""

    parameters: int
    gradient_steps: int
    """Gradient steps of an update"""
    samples: int
    """Environment steps between two updates"""
    all_reduce_microseconds: Mapping[str, float]
    """Median time of a sum over the ranks, us, by its number of values (float32)"""


def exchange(ranks: int, rounds: int) -> Exchange:
    """Measure sums over ranks on loopback, of the default network's gradients and of larger ones."""
    return Exchange(**run_ranks("exchange", ranks, rounds=rounds))


@dataclass(frozen=True)
class Walked:
    """Result of the training with one seed."""

    ranks: int
    seed: int
    seconds: float
    """Time of learning until the policy walked, s, without the tests; infinite if it never did"""
    timesteps: float
    """Environment steps until then"""


def time_to_walk(ranks: int, seed: int, timesteps: int, every: int) -> Walked:
    """Train from scratch until the policy walks, for `timesteps` at most; tested after every `every` steps.

    It walks if it does not fall in 8 episodes of 10 s, with a mean speed within 0.1 m/s of the commanded 0.5 m/s. The
    settings are `_WALKING`.
    """
    found = run_ranks("walk", ranks, seed=seed, timesteps=timesteps, every=every)
    return Walked(ranks, seed, **{name: NEVER if value is None else value for name, value in found.items()})


# --- in the processes ---


def _prepared(group: Any, **settings: Any) -> tuple[Any, Any]:
    from stable_baselines3.common.logger import Logger

    from quadruped_env.robot import MINI_QUADRUPED
    from quadruped_env.training import train
    from quadruped_env.training.default_settings import with_recipe
    from quadruped_env.training.train_config import TrainConfig

    config = TrainConfig(**with_recipe({"ranks": group.ranks, **settings}, MINI_QUADRUPED, ()))
    _, _, _, model = train.prepare(config, None, None, group)
    model.set_logger(Logger(None, []))
    return config, model


def _measure_speed(group: Any, rounds: int) -> dict[str, Any]:
    """Rank 0 also trains alone, in turns; meanwhile the others wait for it without using a core."""
    from stable_baselines3.common.callbacks import BaseCallback

    from quadruped_env.training.group import ALONE

    class Clock(BaseCallback):
        def _on_training_start(self) -> None:
            self.rollouts: list[tuple[float, float]] = []

        def _on_step(self) -> bool:
            return True

        def _on_rollout_start(self) -> None:
            self._began = time.perf_counter()

        def _on_rollout_end(self) -> None:
            self.rollouts.append((self._began, time.perf_counter()))

    def measured(config: Any, model: Any) -> dict[str, float]:
        clock, count = Clock(), _ITERATIONS
        # SB3 counts the envs of this rank.
        model.learn(count * model.n_steps * model.n_envs, callback=clock, reset_num_timesteps=False)
        end = time.perf_counter()
        starts = [start for start, _ in clock.rollouts]
        updates = [
            following - rolled for (_, rolled), following in zip(clock.rollouts, [*starts[1:], end], strict=True)
        ]
        assert len(updates) == count
        return {
            "steps_per_second": count * config.num_envs * config.n_steps / (end - starts[0]),
            "rollout_seconds": sum(rolled - start for start, rolled in clock.rollouts) / count,
            "update_seconds": sum(updates) / count,
        }

    several, one = _prepared(group), None if group.rank else _prepared(ALONE)
    found = []
    for _ in range(rounds + 1):
        alone = None if one is None else measured(*one)
        group.check_same([], "before a round")
        found.append((alone, measured(*several)))
    return {"rounds": found[1:]}  # the first one loads code and fills caches


def _measure_exchange(group: Any, rounds: int) -> dict[str, Any]:
    import numpy as np
    import torch

    config, model = _prepared(group)
    parameters = sum(parameter.numel() for parameter in model.policy.parameters())
    found = {}
    for size in (1, parameters, 10 * parameters, 100 * parameters):
        values, times = torch.zeros(size), []
        for _ in range(rounds):
            start = time.perf_counter()
            group.sum(values)
            times.append(time.perf_counter() - start)
        found[str(size)] = 1e6 * float(np.median(times))
    samples = config.num_envs * config.n_steps
    steps = -(-samples // config.batch_size) * config.n_epochs
    return {
        "parameters": parameters,
        "gradient_steps": steps,
        "samples": samples,
        "all_reduce_microseconds": found,
    }


def _measure_walk(group: Any, seed: int, timesteps: int, every: int) -> dict[str, float | None]:
    from quadruped_env.evaluation.rollout import FIRST_SEED, roll_out
    from quadruped_env.policies import Policy, PolicyController
    from quadruped_env.training import train
    from quadruped_env.training.step_statistics import StepStatistics

    config, model = _prepared(group, seed=seed, timesteps=timesteps, **_WALKING)
    result: dict[str, float | None] = {"seconds": None, "timesteps": None}

    class Watch(StepStatistics):
        def _on_training_start(self) -> None:
            super()._on_training_start()
            self._next, self._learned, self._resumed = every, 0.0, time.perf_counter()

        def _on_rollout_start(self) -> None:
            super()._on_rollout_start()
            if group.rank or self.stopped or self.num_timesteps < self._next:
                return
            self._next += every
            self._learned += time.perf_counter() - self._resumed
            policy = Policy.from_sb3(self.model, {})
            seeds = range(FIRST_SEED, FIRST_SEED + _EPISODES)
            rollout = roll_out(PolicyController(policy), [_COMMAND], seeds, 10.0, policy.config.randomized("none"))
            speed = float(rollout.velocity[..., 0].mean())
            if not rollout.fallen.any() and abs(speed - _COMMAND[0]) <= _SPEED_TOLERANCE:
                result.update(seconds=self._learned, timesteps=self.num_timesteps)
                self.stopped = True
            self._resumed = time.perf_counter()

    train.learn(config, model, Watch(group), fresh=True)
    return result


MEASURES: Final[Mapping[str, Callable[..., dict[str, Any]]]] = {
    "speed": _measure_speed,
    "exchange": _measure_exchange,
    "walk": _measure_walk,
}


def _main() -> None:
    # First, because it sets a variable that torch reads when it is loaded.
    import quadruped_env.training.train  # noqa: F401

    # isort: split
    from quadruped_env.scale.ranks.torch_group import on_this_machine
    from quadruped_env.training.group import ALONE

    end_with_parent()
    values = json.loads(sys.argv[1])
    measure, rank, ranks, threads, store = (
        values.pop(name) for name in ("measure", "rank", "ranks", "threads", "store")
    )
    group = ALONE if ranks == 1 else on_this_machine(store, rank, ranks, threads)
    try:
        found = MEASURES[measure](group, **values)
    finally:
        if ranks > 1:
            group.close()
    if rank == 0:
        print(json.dumps(found))


def as_dict(result: Speed | Exchange | Walked) -> dict[str, Any]:
    """A result as JSON has it, which has no infinity."""
    return {name: None if value == NEVER else value for name, value in asdict(result).items()}


if __name__ == "__main__":
    _main()
