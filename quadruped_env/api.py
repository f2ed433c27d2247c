"""The programs as functions, for Python and notebooks: `train`, `evaluate` and `page`.

They are in `quadruped_env`, next to `compare` (`evaluation.comparison`) and `load_policy`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

from quadruped_env.evaluation.comparison import NUM_SEEDS, Comparison, compare
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy, find_policy
from quadruped_env.evaluation.learning_gain import LearningGain, gain_beside
from quadruped_env.evaluation.rollout import DEFAULT_SECONDS
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.report.pages.page import METRICS_FILE
from quadruped_env.report.pages.report import write_numbers, write_report
from quadruped_env.report.pages.tables import summary_table
from quadruped_env.report.report_directory import REPORT_FILE, prepare_output, print_report
from quadruped_env.simulation import Terrain
from quadruped_env.utils.program import Extras
from quadruped_env.utils.progress import Progress
from quadruped_env.walking_page import PAGE_FILE, write_page

__all__ = ["Evaluation", "evaluate", "page", "train"]


@dataclass(frozen=True, eq=False)
class Evaluation:
    """Results of a policy, whose numbers are written; as text, the tables and the verdict."""

    evaluated: EvaluatedPolicy
    comparison: Comparison
    """The policy and the scripted gaits on the same commands and starts"""
    gain: LearningGain
    """The policy against the zero action"""
    suite: Mapping[str, Any] | None
    """Results of the suite; None: it was not run"""
    document: dict[str, Any]
    """All numbers, as in `numbers`"""

    @classmethod
    def measure(
        cls,
        evaluated: EvaluatedPolicy,
        command_line: str,
        seeds: int,
        seconds: float,
        terrain: str | Terrain | None,
        randomization: str,
        suite: Callable[[], Mapping[str, Any]] | None = None,
        progress: Callable[[str], Progress | None] = lambda label: None,
    ) -> Self:
        """Measure a policy, and write the numbers into its output directory.

        Args:
            evaluated: the policy.
            command_line: command that reproduces the results.
            seeds: episodes per command.
            seconds: length of an episode, s.
            terrain: ground; None: the task's own.
            randomization: preset of the episodes.
            suite: runs the suite; None: it is not run.
            progress: makes the progress callback of a part from its label.

        Raises:
            QuadrupedError: as `compare`, or if a file cannot be written.
        """
        policy = evaluated.policy
        prepare_output(evaluated.output)
        comparison = compare(
            policy, seeds, seconds, progress=progress("running"), terrain=terrain, randomization=randomization
        )
        measuring, file = progress("measuring what it learned"), evaluated.progress_file
        gain = gain_beside(policy, seeds, seconds, measuring, comparison, file)
        results = None if suite is None else suite()
        document = write_numbers(evaluated, comparison, command_line, results, gain)
        return cls(evaluated, comparison, gain, results, document)

    @property
    def numbers(self) -> Path:
        """File of the numbers."""
        return self.evaluated.output / METRICS_FILE

    def write(self, extras: Extras, with_video: bool = True, progress: Progress | None = None) -> None:
        """Write the page that walks and the report next to the numbers, and print where they are."""
        page, linked = self.evaluated.output / PAGE_FILE, None
        with extras.part(PAGE_FILE, of_some_only=True):
            write_page(self.evaluated.policy, page, self.evaluated.name)
            print(f"page:    {page}")
            linked = page.name
        with extras.part(REPORT_FILE):
            found = self.evaluated, self.comparison, self.document
            print_report(*write_report(*found, with_video, progress, self.suite, self.gain, linked))

    def __str__(self) -> str:
        judged = verdict(self.comparison, self.gain)
        return f"{summary_table(self.comparison)}\n\n{self.gain.table()}\n\n{judged.text()}"


def train(runs: str | Path = "runs", task_file: str | Path | None = None, **settings: Any) -> Path:
    """Train a policy as `mini-quadruped train` does, and return its run directory.

    Args:
        runs: parent of the run directory.
        task_file: Python file of terms or of a robot; it is executed.
        settings: fields of `quadruped_env.training.TrainConfig`, such as `recipe="walker"`, `timesteps=1_000_000` or
            `seed=1`; the recipe sets the others.

    Raises:
        QuadrupedError: if a setting is not possible, or a file cannot be written.
        MissingExtraError: if the libraries of the extra `train` are not installed.
    """
    from quadruped_env.task import BUILT_IN, load_task_file
    from quadruped_env.training.recipes import with_recipe
    from quadruped_env.training.train import train as train_run

    file = None if task_file is None else Path(task_file)
    robot = (BUILT_IN if file is None else load_task_file(file)).robot
    config = with_recipe(settings, robot)
    given = ", ".join(f"{name}={value!r}" for name, value in settings.items())
    directory, _ = train_run(config, Path(runs), f"quadruped_env.train({given})", task_file=file)
    return directory


def evaluate(
    run: str | Path | None = None,
    output: str | Path | None = None,
    *,
    seeds: int = NUM_SEEDS,
    seconds: float = DEFAULT_SECONDS,
    terrain: str | Terrain | None = None,
    randomization: str = "none",
    task_file: str | Path | None = None,
    trust_task: bool = False,
    with_video: bool = True,
) -> Evaluation:
    """Evaluate a policy as `mini-quadruped evaluate` does, and write numbers, report and the page that walks.

    Args:
        run: a run's directory or the name of a shipped policy; None: the latest run, or the default policy.
        output: directory of the results; None: `evaluation` in the run, or `results/NAME`.
        seeds: episodes per command.
        seconds: length of an episode, s.
        terrain: a terrain, or the name of one; None: the task's own.
        randomization: a preset: `none`, `moderate` or `hard`.
        task_file: Python file of the terms or the robot that the run was trained with; it is executed.
        trust_task: execute the copy of that file that the run keeps.
        with_video: render a film for the report, if OpenGL is available.

    Raises:
        QuadrupedError: if there is no such policy, an argument is not valid, or the numbers cannot be written.
    """
    evaluated = find_policy(
        None if run is None else str(run),
        None if output is None else Path(output),
        None if task_file is None else Path(task_file),
        trust_task,
    )
    found = Evaluation.measure(
        evaluated, f"quadruped_env.evaluate({evaluated.source!r})", seeds, seconds, terrain, randomization
    )
    found.write(Extras(), with_video)
    return found


def page(run: str | Path | None = None, path: str | Path = PAGE_FILE) -> Path:
    """Write the page in which a policy's robot walks, as `mini-quadruped page` does; an existing file is replaced.

    Args:
        run: as in `evaluate`.
        path: the file.

    Raises:
        QuadrupedError: if there is no such policy, it cannot run on a page, or the file cannot be written.
    """
    evaluated = find_policy(None if run is None else str(run))
    write_page(evaluated.policy, Path(path), evaluated.name)
    return Path(path)
