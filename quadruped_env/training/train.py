"""A training: from its settings to a run directory with a policy."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, Final

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training.sb3_models import go_on_from, make_model

# isort: split
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.task import BUILT_IN, load_task_file
from quadruped_env.training.group import ALONE, Group
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import Run, check_latest
from quadruped_env.training.step_statistics import StepStatistics
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.training.training_recorder import Observer, Recorder, record
from quadruped_env.utils.program import on_stop
from quadruped_env.utils.seeds import check_training_seeds

try:
    from stable_baselines3.common.logger import Logger
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("training", "train") from error


class Trainer:
    """Envs, model and callbacks of a training on the CPU; a subclass has those of another device."""

    recorder: type[Recorder] = Recorder
    """Callback of rank 0"""
    statistics: type[StepStatistics] = StepStatistics
    """Callback of the other ranks"""

    def make(self, config: TrainConfig, task_file: Path | None, group: Group, threads: int) -> tuple[Any, Any]:
        """A rank's share of the envs, and a fresh model with Stable-Baselines3's `learn`; see `prepare`."""
        if config.device != "cpu":
            raise QuadrupedError(f"--device: {config.device} needs the trainer quadruped_env.scale.gpu.warp_training")
        share = config.num_envs // group.ranks
        env = make_sb3_vec_env(
            share,
            seed=config.seed + group.rank * share,
            action_mode=config.action_mode,
            config=config.task,
            task_file=task_file,
            privileged=config.asymmetric_critic,
            random_first_length=True,
            num_threads=threads or group.threads,
        )
        if group.ppo is None:
            return env, make_model(config, env)
        return env, make_model(config, env, group.ppo, group=group, batch_size=config.batch_size // group.ranks)

    def go_on_from(self, model: Any, parent: Parent) -> None:
        """Take over a run's network, optimizer, step count and place in the schedules."""
        go_on_from(model, parent)


ON_CPU: Final = Trainer()


def train(
    config: TrainConfig,
    runs: Path,
    command: str,
    resume: Path | None = None,
    task_file: Path | None = None,
    group: Group = ALONE,
    observer: Observer | None = None,
    threads: int = 0,
    trainer: Trainer = ON_CPU,
) -> tuple[Path, bool]:
    """Train a policy and leave a run directory.

    Args:
        config: settings of the training.
        runs: parent of the run directory.
        command: what the user typed, for the record.
        resume: a run or checkpoint to go on from, whose task and network `config` has: `Parent.resumed` makes one.
        task_file: a user's file of terms, which is executed.
        group: rank 0 of the training, if it has several.
        observer: watches the training; the clock stands still meanwhile.
        threads: threads of the physics; 0: one per core, or those of the group.
        trainer: that of the device.

    Returns:
        The run directory, and whether the whole budget was used.

    Raises:
        QuadrupedError: if a setting is not possible, the run to resume is not complete, or a file cannot be
            written; then what was saved before is kept.
    """
    check_latest(runs)
    config, parent, env, model = prepare(config, resume, task_file, group, threads, trainer)
    task = env.task.config
    facts, curve = (None, ()) if parent is None else (parent.facts(), parent.curve)
    run = Run(runs, config, task.to_dict(), command, facts, curve, env.task.term_names, task.file)
    recorder = trainer.recorder(run, config, task, 0.0 if parent is None else parent.seconds, group, observer)
    try:
        record(run, model, recorder, lambda: learn(config, model, recorder, fresh=parent is None))
    finally:
        env.close()
    return run.directory, not recorder.stopped


def follow(
    config: TrainConfig, resume: Path | None, task_file: Path | None, group: Group, trainer: Trainer = ON_CPU
) -> None:
    """Train as a rank other than 0, which writes no files; see `train`."""
    config, parent, env, model = prepare(config, resume, task_file, group, trainer=trainer)
    try:
        model.set_logger(Logger(None, []))
        learn(config, model, trainer.statistics(group), fresh=parent is None)
    finally:
        env.close()


def prepare(
    config: TrainConfig,
    resume: Path | None,
    task_file: Path | None,
    group: Group = ALONE,
    threads: int = 0,
    trainer: Trainer = ON_CPU,
) -> tuple[TrainConfig, Parent | None, Any, Any]:
    """Everything that a training, or one rank of it, needs to learn; see `train`.

    Returns:
        The settings with the whole task, the run to go on from, the rank's share of the envs, and the model.

    Raises:
        QuadrupedError: if a setting is not possible, or the run to resume is not complete.
    """
    parent = None
    if resume is not None:
        parent = Parent.load(resume, BUILT_IN if task_file is None else load_task_file(task_file))
        parent.check(asdict(config))
        config = replace(config, task=parent.with_reward(config.task))
    env, model = trainer.make(config, task_file, group, threads)
    check_training_seeds("config.terrain.seed", env.task.config.terrain["seed"])
    if parent is not None:
        trainer.go_on_from(model, parent)
    return config, parent, env, model


def learn(config: TrainConfig, model: Any, statistics: StepStatistics, fresh: bool) -> None:
    """Train a model until its budget is used, or a signal stops it.

    Args:
        config: settings of the training.
        model: of `prepare`.
        statistics: callback that knows when to stop.
        fresh: False if the training goes on from a run.
    """
    timesteps = config.timesteps if config.seconds is None else sys.maxsize // 2
    with stop_on_signal(statistics):
        model.learn(timesteps, callback=statistics, reset_num_timesteps=fresh)


@contextmanager
def stop_on_signal(statistics: StepStatistics) -> Iterator[None]:
    """Within it, the first Ctrl-C (or SIGTERM) ends the training at the next step; the second one as usual."""

    def stop(number: int) -> None:
        statistics.stopped, statistics.signal = True, signal.Signals(number).name
        restore()

    with on_stop(stop) as restore:
        yield
