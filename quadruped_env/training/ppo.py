"""A training: from its settings to a run directory with a policy."""

import io
import shutil
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import asdict, replace
from pathlib import Path
from types import FrameType
from typing import Any, cast

import numpy as np

# First, because it sets a variable that torch reads when it is loaded.
from quadruped_env.training.models import NativeModel, export_policy, make_model

# isort: split
from quadruped_env.control.policy import CHECKPOINTS
from quadruped_env.envs import MAX_EPISODE_STEPS, make_sb3_vec_env
from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.files import unwritable, whole, write_whole
from quadruped_env.policies import Policy
from quadruped_env.seeds import check_training_seeds
from quadruped_env.task import BUILT_IN, TaskConfig, load_task_file
from quadruped_env.training.config import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run import CONFIG_FILE, PROGRESS_FILE, RESUME_FILE, Run, check_latest

try:
    from stable_baselines3.common.callbacks import BaseCallback
    from stable_baselines3.common.logger import configure
    from tqdm import tqdm
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("training", "train") from error

_LOG_INTERVAL = 1.0
"""Interval of the progress bar, progress.csv and TensorBoard, s."""

Observer = Callable[[int, Callable[[], Policy]], None]
"""Called after each rollout with the number of time steps and a function that makes the policy at this point."""


def train(
    config: TrainConfig,
    runs: Path,
    command: str,
    resume: Path | None = None,
    task_file: Path | None = None,
    observer: Observer | None = None,
    threads: int = 0,
) -> tuple[Path, bool]:
    """Train a policy and leave a run directory.

    Args:
        config: settings of the training.
        runs: parent of the run directory.
        command: what the user typed, for the record.
        resume: a run or checkpoint to go on from, whose task and network `config` has: `Parent.resumed` makes one.
        task_file: a user's file of terms, which is executed.
        observer: watches the training; the clock stands still meanwhile.
        threads: threads of the physics and of an update; 0: one per core.

    Returns:
        The run directory, and whether the whole budget was used.

    Raises:
        QuadrupedError: if a setting is not possible, the run to resume is not complete, or a file cannot be
            written; then what was saved before is kept.
    """
    check_latest(runs)
    definition = BUILT_IN if task_file is None else load_task_file(task_file)
    parent = None if resume is None else Parent.load(resume, definition)
    if parent is not None:
        parent.check(asdict(config))
        config = replace(config, task=parent.config.task)
    env = make_sb3_vec_env(
        config.num_envs,
        seed=config.seed,
        action_mode=config.action_mode,
        config=config.task,
        task_file=task_file,
        privileged=config.asymmetric_critic,
        num_threads=threads,
    )
    task = env.task.config
    check_training_seeds("config.terrain.seed", task.terrain["seed"])
    model = make_model(config, env)
    if parent is not None:
        model.go_on_from(parent)
    model.budget_seconds = config.seconds
    model.update_threads = threads

    if parent is None:
        run = Run(runs, config, task.to_dict(), command)
    else:
        run = Run(runs, config, task.to_dict(), command, parent.facts(), parent.curve)
    recorder = Recorder(run, config, task, 0.0 if parent is None else parent.seconds, observer)
    try:
        with ExitStack() as stack:
            # In the end the last of these comes first, and each though another fails.
            stack.enter_context(_quiet_threads())
            stack.callback(env.close)
            stack.callback(run.close)
            model.set_logger(configure(str(run.directory / "tensorboard"), ["tensorboard"]))
            stack.callback(recorder.finish)
            stack.callback(recorder.save)
            with _stop_on_signal(recorder):
                timesteps = config.timesteps if config.seconds is None else sys.maxsize // 2
                model.learn(timesteps, callback=recorder, reset_num_timesteps=parent is None)
    except (OSError, QuadrupedError) as error:
        cause = error if isinstance(error, QuadrupedError) else unwritable(run.directory, error)
        raise QuadrupedError(f"{cause}; what was saved before is kept in {run.directory}") from error
    return run.directory, not recorder.stopped


@contextmanager
def _quiet_threads() -> Iterator[None]:
    """Within it, a thread that cannot write a file ends without a traceback."""
    usual = threading.excepthook

    def say(failure: threading.ExceptHookArgs) -> None:
        # TensorBoard's writer raises the error of its thread again, at its next write.
        if not issubclass(failure.exc_type, OSError):
            usual(failure)

    threading.excepthook = say
    try:
        yield
    finally:
        threading.excepthook = usual


class _stop_on_signal:  # noqa: N801
    """Within it, the first Ctrl-C (or SIGTERM) ends the training at the next step; the second one as usual."""

    def __init__(self, recorder: "Recorder") -> None:
        self._recorder = recorder
        self._previous: dict[int, Any] = {}

    def __enter__(self) -> None:
        try:
            for number in (signal.SIGINT, signal.SIGTERM):
                self._previous[number] = signal.signal(number, self._stop)
        except ValueError:
            pass  # not in the main thread, where no signals arrive

    def __exit__(self, *exception: object) -> None:
        for number, handler in self._previous.items():
            signal.signal(number, handler)

    def _stop(self, number: int, frame: FrameType | None) -> None:
        self._recorder.stopped = True
        signal.signal(number, self._previous[number])


class Recorder(BaseCallback):
    """Watches a training: progress bar, progress.csv, TensorBoard, checkpoints, and the end of the budget.

    Args:
        run: the run directory.
        config: settings of the training.
        task: its task.
        seconds_before: wall clock of the training that it goes on from.
        observer: called after each rollout.
    """

    def __init__(
        self,
        run: Run,
        config: TrainConfig,
        task: TaskConfig,
        seconds_before: float = 0.0,
        observer: Observer | None = None,
    ) -> None:
        super().__init__()
        self._observer = observer
        self._run, self._config, self._task_config = run, config, task
        self._seconds_before = seconds_before
        self.stopped = False
        self.elapsed = 0.0

    @property
    def seconds(self) -> float:
        """Wall clock of learning, with that of the training that this one goes on from."""
        return self._seconds_before + self.elapsed

    def _on_training_start(self) -> None:
        self._start = time.perf_counter()
        self._env = cast(MiniQuadrupedSB3VecEnv, self.training_env)
        self._task = self._env.task
        self._next_log = _LOG_INTERVAL
        self._next_checkpoint = self._config.checkpoint_seconds
        start = self.model.num_timesteps
        total = start + self._config.timesteps if self._config.seconds is None else None
        self._bar = tqdm(
            total=total,
            initial=start,
            unit=" steps",
            unit_scale=True,
            mininterval=0.0,
            disable=None,
            dynamic_ncols=True,
        )
        self._clear()

    def _clear(self) -> None:
        self._squares = np.zeros(2)
        self._terms = np.zeros(len(self._task.term_names))
        self._steps = 0
        self._falls = 0

    def _on_step(self) -> bool:
        error = self._task.tracking_error
        self._squares += (error * error).mean(axis=0)
        self._terms += self._env.last_terms.mean(axis=0)
        self._steps += 1
        if self.locals["dones"].any():
            self._falls += sum(
                not self.locals["infos"][row]["TimeLimit.truncated"] for row in np.flatnonzero(self.locals["dones"])
            )
        self.elapsed = time.perf_counter() - self._start
        return not (self.stopped or (self._config.seconds is not None and self.elapsed >= self._config.seconds))

    def _on_rollout_end(self) -> None:
        self._bar.update(self.num_timesteps - self._bar.n)
        if self.elapsed >= self._next_log:
            self._next_log = self.elapsed + _LOG_INTERVAL
            self._log()
        if self.elapsed >= self._next_checkpoint:
            self._next_checkpoint = self.elapsed + self._config.checkpoint_seconds
            self._save_checkpoint(self._run.directory / CHECKPOINTS / f"{round(self.seconds):05d}s")
        if self._observer is not None:
            began = time.perf_counter()
            self._observer(self.num_timesteps, lambda: self._policy(self._card()))
            self._start += time.perf_counter() - began

    def _log(self) -> None:
        errors = np.sqrt(self._squares / self._steps)
        # Robots that do not fall finish their episodes all at once and seldom: rates are known all the time.
        episodes = self._steps * self._config.num_envs / MAX_EPISODE_STEPS
        row = {
            "timesteps": self.num_timesteps,
            "seconds": round(self.seconds, 3),
            "return": float(self._terms.sum() / self._steps * MAX_EPISODE_STEPS),
            "fall_rate": self._falls / episodes,
            "forward_velocity_error": float(errors[0]),
            "yaw_rate_error": float(errors[1]),
        }
        self._run.log(row)
        for name, value in row.items():
            if name != "timesteps":
                self.logger.record(f"progress/{name}", value)
        rate = 1.0 / self._task_config.control_timestep
        for name, value in zip(self._task.term_names, self._terms / self._steps * rate, strict=True):
            self.logger.record(f"reward_per_second/{name}", float(value))
        for name, value in ({} if self._task.tiles is None else self._task.tiles.mean_levels()).items():
            self.logger.record(f"terrain/{name}", value)
        self.logger.dump(self.num_timesteps)
        self._bar.set_postfix_str(
            f"return {row['return']:.1f}, falls {row['fall_rate']:.2f}, "
            f"errors {errors[0]:.2f} m/s {errors[1]:.2f} rad/s{self._remaining()}"
        )
        self._clear()

    def _remaining(self) -> str:
        """Rest of a budget in seconds; the bar itself shows that of a budget in steps."""
        return "" if self._config.seconds is None else f", {max(0.0, self._config.seconds - self.elapsed):.0f} s left"

    def save(self) -> None:
        """Write the policy as data into the run directory, and the files that resuming needs.

        Raises:
            QuadrupedError: if a file cannot be written, or the training diverged; then no file is written.
        """
        write_whole({self._run.directory / name: content for name, content in self._files().items()})

    def _save_checkpoint(self, directory: Path) -> None:
        """Write a checkpoint, which appears when it is complete and does not depend on the run's files."""
        with whole(directory) as part:
            part.mkdir()
            for name in (CONFIG_FILE, PROGRESS_FILE):
                shutil.copyfile(self._run.directory / name, part / name)
            for name, content in self._files().items():
                (part / name).write_bytes(content)

    def _files(self) -> dict[str, bytes]:
        """Name -> content; the policy's card, which marks a directory as complete, is the last."""
        archive = io.BytesIO()
        self.model.save(archive)
        return {RESUME_FILE: archive.getvalue(), **self._policy(self._card()).files()}

    def _card(self) -> dict[str, Any]:
        model = cast(NativeModel, self.model)
        return {
            **self._run.facts,
            "recipe": self._config.recipe,
            "algo": self._config.algo,
            "seed": self._config.seed,
            "timesteps": int(model.num_timesteps),
            "seconds": round(self.seconds, 1),
            "budget_left": model.budget_left(),
        }

    def _policy(self, card: dict[str, Any]) -> Policy:
        return export_policy(self.model, self._task_config, self._config.activation, card)

    def finish(self) -> None:
        """Log the remaining steps, and close the progress bar."""
        if hasattr(self, "_bar"):
            if self._steps:
                self._log()
            self._bar.close()
