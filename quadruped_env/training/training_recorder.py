"""Record of a training: its progress, its files, and what it leaves after an error."""

import io
import shutil
import socket
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import asdict
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, cast

import numpy as np
from numpy.typing import NDArray

# First, because it sets a variable that torch reads when it is loaded.
import quadruped_env.training.sb3_models  # noqa: F401

# isort: split
from quadruped_env.envs import MAX_EPISODE_STEPS
from quadruped_env.envs.sb3 import MiniQuadrupedSB3VecEnv
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.policies import Policy
from quadruped_env.policies.files import CHECKPOINTS
from quadruped_env.task import Task, TaskConfig
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_FILE, RESUME_FILE, TERM_COLUMN, Run
from quadruped_env.training.schedules import Scheduled
from quadruped_env.training.tracking import ServiceWriter
from quadruped_env.training.train_config import TrainConfig
from quadruped_env.utils.files import unwritable, whole, write_whole
from quadruped_env.utils.progress import ProgressLine

try:
    from stable_baselines3.common.logger import configure
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("training", "train") from error

_LOG_INTERVAL = 1.0
"""Interval of progress.csv and TensorBoard, s."""

NO_FIELDS: Final[Mapping[str, Any]] = MappingProxyType({})


class Recorder(Scheduled):
    """Watches a training: progress line, progress.csv, TensorBoard, checkpoints, and the end of the budget.

    Args:
        run: the run directory.
        config: settings of the training.
        task: its task.
        seconds_before: wall clock of the training that it goes on from.
    """

    def __init__(
        self,
        run: Run,
        config: TrainConfig,
        task: TaskConfig,
        seconds_before: float = 0.0,
    ) -> None:
        super().__init__()
        self._run, self.config, self._task_config = run, config, task
        self._seconds_before = seconds_before
        self.elapsed = 0.0
        self.stopped = False
        """True if a signal asked to stop"""
        self.signal = "SIGTERM"
        """Name of the signal that asked to stop, if one did"""

    @property
    def seconds(self) -> float:
        """Wall clock of learning, s, including the training that this one continues."""
        return self._seconds_before + self.elapsed

    def _on_training_start(self) -> None:
        self._start = time.perf_counter()
        super()._on_training_start()
        self._env = cast(MiniQuadrupedSB3VecEnv, self.training_env)
        self._task = self._env.task
        self._errors = error_units(self._task)
        self._clear()
        self._next_log = _LOG_INTERVAL
        self._next_checkpoint = self.config.checkpoint_seconds
        self._state = ""
        self._first = self.model.num_timesteps
        self._line = ProgressLine("training")

    def _clear(self) -> None:
        """Begin to sum over the steps of the next row of progress.csv."""
        self._squares: NDArray[np.float64] = np.zeros(len(self._errors))
        """Mean over envs of the squared error of each velocity, summed over steps"""
        self._terms: NDArray[np.float64] = np.zeros(len(self._task.term_names))
        """Mean over envs of each term, summed over steps"""
        self._steps = self._falls = 0

    def _on_step(self) -> bool:
        self.elapsed = time.perf_counter() - self._start
        error = self._task.context.tracking_error
        self._squares += (error * error).mean(axis=0)
        self._terms += self._env.last_terms.mean(axis=0)
        self._steps += 1
        if self.locals["dones"].any():
            self._falls += sum(
                not self.locals["infos"][env_id]["TimeLimit.truncated"]
                for env_id in np.flatnonzero(self.locals["dones"])
            )
        # Not only after a rollout, which on a slow machine takes seconds.
        budget, learned = self.config.seconds, self.num_timesteps - self._first
        share = learned / self.config.timesteps if budget is None else self.elapsed / budget
        speed = learned / max(self.elapsed, 1e-9)
        self._line(min(share, 0.99), f", {self.num_timesteps:,} steps, {speed:,.0f} steps/s{self._state}")
        return not (self.stopped or (budget is not None and self.elapsed >= budget))

    def _on_rollout_end(self) -> None:
        super()._on_rollout_end()
        if self.elapsed >= self._next_log:
            self._next_log = self.elapsed + _LOG_INTERVAL
            self._log()
        if self.elapsed >= self._next_checkpoint:
            self._next_checkpoint = self.elapsed + self.config.checkpoint_seconds
            self._save_checkpoint(self._run.directory / CHECKPOINTS / f"{round(self.seconds):05d}s")

    def _log(self) -> None:
        errors = np.sqrt(self._squares / self._steps)
        # Robots that do not fall finish their episodes all at once and seldom: rates are known all the time.
        episodes = self._steps * self.config.num_envs / MAX_EPISODE_STEPS
        row = {
            "timesteps": self.num_timesteps,
            "seconds": round(self.seconds, 3),
            "return": float(self._terms.sum() / self._steps * MAX_EPISODE_STEPS),
            "fall_rate": self._falls / episodes,
            **dict(zip(self._errors, errors.tolist(), strict=True)),
        }
        rates = self._terms / self._steps / self._task_config.control_timestep
        by_term = dict(zip(self._task.term_names, rates.tolist(), strict=True))
        self._run.log(row | {f"{TERM_COLUMN}{name}": value for name, value in by_term.items()})
        for name, value in row.items():
            if name != "timesteps":
                self.logger.record(f"progress/{name}", value)
        for name, value in by_term.items():
            self.logger.record(f"reward_per_second/{name}", value)
        for name, value in ({} if self._task.tiles is None else self._task.tiles.mean_levels()).items():
            self.logger.record(f"terrain/{name}", value)
        self.logger.dump(self.num_timesteps)
        shown = " ".join(f"{error:.2f} {unit}" for error, unit in zip(errors, self._errors.values(), strict=True))
        self._state = f", return {row['return']:.1f}, falls {row['fall_rate']:.2f}, errors {shown}"
        self._clear()

    def save_after(self, kind: object, error: BaseException | None, trace: object) -> None:
        """Save at the end of a training."""
        self.save("an error" if error is not None else self.signal if self.stopped else None)

    def save(self, interrupted: str | None = None) -> None:
        """Write the policy as data into the run directory, and the files that resuming needs.

        Args:
            interrupted: what ended the training before its budget was used, if it was, for the policy's card.

        Raises:
            QuadrupedError: if a file cannot be written, or the training diverged; then no file is written.
        """
        files = self._files({"interrupted": interrupted})
        write_whole({self._run.directory / name: content for name, content in files.items()})

    def _save_checkpoint(self, directory: Path) -> None:
        """Write a checkpoint, which appears when it is complete and does not depend on the run's files."""
        with whole(directory) as part:
            part.mkdir()
            for name in (CONFIG_FILE, PROGRESS_FILE, *self._run.kept):
                if (self._run.directory / name).exists():
                    (part / name).parent.mkdir(parents=True, exist_ok=True)
                    _copy(self._run.directory / name, part / name, changes=name == PROGRESS_FILE)
            for name, content in self._files().items():
                (part / name).write_bytes(content)

    def _files(self, ending: Mapping[str, Any] = NO_FIELDS) -> dict[str, bytes]:
        """Return name -> content of the files; the policy's card, which marks a directory as complete, is the last."""
        archive = io.BytesIO()
        self.model.save(archive)
        return {RESUME_FILE: archive.getvalue(), **self._policy(ending).files()}

    def _policy(self, ending: Mapping[str, Any] = NO_FIELDS) -> Policy:
        card = {
            **self._run.facts,
            "recipe": self.config.recipe,
            "algo": self.config.algo,
            "seed": self.config.seed,
            "timesteps": int(self.model.num_timesteps),
            "seconds": round(self.seconds, 1),
            "budget_left": self.schedule.left_after(self.model.num_timesteps),
            **ending,
        }
        return Policy.from_sb3(self.model, card)

    def finish(self) -> None:
        """Log the remaining steps."""
        if hasattr(self, "_line"):
            if self._steps:
                self._log()
            self._line.close()


def record(run: Run, model: Any, recorder: Recorder, learning: Callable[[], None], service: str | None = None) -> None:
    """Train a model, and leave what it learned in the run directory, also after an error.

    Args:
        run: the run directory.
        model: the model, with SB3's `set_logger`.
        recorder: its recorder.
        learning: the training.
        service: one of `tracking.SERVICES`, to which the metrics go as well.

    Raises:
        QuadrupedError: the error of the training or of its files, with the run directory.
    """
    try:
        with ExitStack() as stack:
            # In the end the last of these comes first, and each though another fails.
            stack.callback(run.close)
            with _nameless_host():
                model.set_logger(configure(str(run.directory / "tensorboard"), ["tensorboard"]))
            if service is not None:
                writer = ServiceWriter(service, run.directory.name, asdict(recorder.config))
                stack.callback(writer.close)
                model.logger.output_formats.append(writer)
            stack.callback(recorder.finish)
            stack.push(recorder.save_after)
            learning()
    except (OSError, QuadrupedError) as error:
        cause = error if isinstance(error, QuadrupedError) else unwritable(run.directory, error)
        raise QuadrupedError(f"{cause}; what was saved before is kept in {run.directory}") from error


def _copy(source: Path, target: Path, changes: bool) -> None:
    """Copy a file, without its content where it never changes and the file system knows links: meshes are large."""
    if not changes:
        with suppress(OSError):
            target.hardlink_to(source)
            return
    shutil.copyfile(source, target)


def error_units(task: Task) -> dict[str, str]:
    """Return the columns of progress.csv with the errors of the velocities of a task's command, and their units."""
    return {f"{entry.name}_error": entry.unit for entry in task.config.commands[: task.control.config.num_velocities]}


@contextmanager
def _nameless_host() -> Iterator[None]:
    """Within it, TensorBoard does not name its file after this machine: runs are published."""
    usual, socket.gethostname = socket.gethostname, lambda: "training"
    try:
        yield
    finally:
        socket.gethostname = usual
