"""A training: from its settings to a run directory with a policy."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training.sb3_models import go_on_from, make_model

# isort: split
from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import Run, check_latest
from quadruped_env.training.tracking import service_module
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.training.training_recorder import Recorder, error_units, record
from quadruped_env.utils.program import on_stop
from quadruped_env.utils.seeds import check_training_seeds


def train(
    config: TrainConfig,
    runs: Path,
    command: str,
    parent: Parent | None = None,
    task_file: Path | None = None,
    threads: int = 0,
    service: str | None = None,
) -> tuple[Path, bool]:
    """Train a policy and leave a run directory.

    Args:
        config: settings of the training.
        runs: parent of the run directory.
        command: what the user typed, for the record.
        parent: a run or checkpoint to go on from, of which `config` is the result of `Parent.resumed`.
        task_file: a user's file of terms, which is executed.
        threads: threads of the physics; 0: one per core.
        service: one of `tracking.SERVICES`, to which the metrics go as well.

    Returns:
        The run directory, and whether the whole budget was used.

    Raises:
        QuadrupedError: if a setting is not possible, the parent's network is damaged, or a file cannot be written;
            then what was saved before is kept.
    """
    check_latest(runs)
    if service is not None:
        service_module(service)  # before there is a run directory
    env = make_sb3_vec_env(
        config.num_envs,
        seed=config.seed,
        action_mode=config.action_mode,
        config=config.task,
        task_file=task_file,
        privileged=config.asymmetric_critic,
        random_first_length=True,
        num_threads=threads,
    )
    model = make_model(config, env)
    task = env.task.config
    check_training_seeds("config.terrain.seed", task.terrain["seed"])
    if parent is not None:
        go_on_from(model, parent)
    facts, curve = (None, ()) if parent is None else (parent.facts(), parent.curve)
    columns = *error_units(env.task), *env.task.reward_keys
    run = Run(runs, config, task.to_dict(), command, facts, curve, columns, task.file)
    recorder = Recorder(run, config, task, 0.0 if parent is None else parent.seconds)

    def learn() -> None:
        timesteps = config.timesteps if config.seconds is None else sys.maxsize // 2
        with _stop_on_signal(recorder):
            model.learn(timesteps, callback=recorder, reset_num_timesteps=parent is None)

    try:
        record(run, model, recorder, learn, service)
    finally:
        env.close()
    return run.directory, not recorder.stopped


@contextmanager
def _stop_on_signal(recorder: Recorder) -> Iterator[None]:
    """Within it, the first Ctrl-C (or SIGTERM) ends the training at the next step; the second one as usual."""

    def stop(number: int) -> None:
        recorder.stopped, recorder.signal = True, signal.Signals(number).name
        restore()

    with on_stop(stop) as restore:
        yield
