"""Train a walking policy with PPO, or with another algorithm.

mini-quadruped train                          about two minutes, then a policy that walks
mini-quadruped train --recipe walker          one policy for all ground, in an hour or more
mini-quadruped train --action-mode position   without the scripted gait underneath
mini-quadruped train --terrain rough          on uneven ground
mini-quadruped train --randomization hard     with other masses, motors, latency and pushes in each episode
mini-quadruped train --task my_robot.py       with your own robot, which 'mini-quadruped robot FILE' writes
mini-quadruped train --task my_task.py        with rewards, observations or randomizations of your own
mini-quadruped train --algo sac               with another algorithm of Stable-Baselines3 or sb3-contrib
mini-quadruped train --resume runs/latest     continue an earlier run, or the last checkpoint of an interrupted one
"""

import argparse
import json
import signal
from collections.abc import Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any, Final, get_args

from quadruped_env.cli.common_options import (
    add_output,
    add_randomization,
    add_terrain,
    add_trust_task,
    check_level_has_terrain,
)
from quadruped_env.cli.invocation import Invocation
from quadruped_env.envs import MAX_EPISODE_STEPS
from quadruped_env.envs.arguments import changed
from quadruped_env.errors import QuadrupedError, short
from quadruped_env.evaluation.conditions import COMMANDS
from quadruped_env.evaluation.learning_gain import EPISODES, MOTION_SEEDS, LearningGain, learning_gain
from quadruped_env.gait import fitness
from quadruped_env.policies import load_policy
from quadruped_env.policies.files import kept_file
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.robot.description import check_no_description
from quadruped_env.task import BUILT_IN, TaskConfig, TaskDefinition, load_task_file, preset_values
from quadruped_env.training import TrainConfig
from quadruped_env.training.recipes import RECIPES, with_recipe
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.documents import parse_json, read_json
from quadruped_env.utils.fields import hints_of
from quadruped_env.utils.files import write_whole
from quadruped_env.utils.interpreter import module_command, program_command
from quadruped_env.utils.program import stopped_status
from quadruped_env.utils.progress import ProgressLine

RUNS: Final = Path("runs")
"""Default directory of the run directories."""
_MANY: Final = 10**18
"""Bound of a count that is parsed: 1e999999999 would fill the memory."""
_TASK_RULE: Final = """expected a JSON object such as '{"command": {"yaw_rate": [-0.4, 0.4]}}'"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the settings of a training, and the places of the runs."""
    add_settings(parser)
    parser.add_argument(
        "--resume",
        type=Path,
        metavar="RUN",
        help="run or checkpoint to continue, with its settings; options change its budget, and --task its reward. "
        "Without a budget: the rest of the run's, or the same again if it was used. The schedules continue from where "
        "they were",
    )
    add_output(parser, "DIR", f"directory of the run directories (default: {RUNS})", RUNS)
    parser.add_argument(
        "--track",
        choices=("wandb", "mlflow", "trackio"),
        help="also send the metrics to a service that tracks experiments, whose package is installed",
    )
    add_trust_task(parser, "with --resume: execute the copy of the task file that the run keeps instead of --task FILE")


def add_settings(parser: argparse.ArgumentParser) -> None:
    """Add the options of `TrainConfig`, `--terrain` and `--randomization`."""
    number: dict[str, Any] = {"type": count, "metavar": "N"}
    real: dict[str, Any] = {"type": float, "metavar": "X"}
    recipes = "; ".join(f"{name}: {entry.description}" for name, entry in RECIPES.items())
    hints = hints_of(TrainConfig)

    def add(name: str, text: str, **how: Any) -> None:
        # Without a default: a recipe, an algorithm or a resumed run has its own.
        option = f"--{name.replace('_', '-')}"
        parser.add_argument(option, default=argparse.SUPPRESS, help=f"{text} (default: {_default(name)})", **how)

    def add_choice(name: str, text: str) -> None:
        add(name, text, choices=get_args(hints[name]))

    add_choice("recipe", f"named settings of the training and its task, which other options change. {recipes}")
    add_choice("algo", "algorithm: ppo, a2c, sac, td3 or ddpg of Stable-Baselines3; trpo, tqc or crossq of sb3-contrib")
    add_choice("action_mode", "position: learn from scratch; residual: learn on top of the scripted gait")
    add(
        "timesteps",
        "budget in environment steps, summed over all envs; the same kind of processor repeats the run bit for bit",
        **number,
    )
    add("seconds", "budget in seconds of wall-clock time instead; such a run cannot be repeated bit for bit", **real)
    add("seed", "seed of the envs (each further env has the next one), the network and the exploration", **number)
    add("num_envs", "number of parallel envs", **number)
    add("name", "last part of the run directory's name", metavar="NAME")
    add("checkpoint_seconds", "seconds of wall-clock time between checkpoints", **real)
    parser.add_argument(
        "--task",
        default=argparse.SUPPRESS,
        type=task_change,
        action="append",
        metavar="TASK",
        help="a Python file with a robot (docs/robots.md) or terms (docs/make-it-yours.md) of your own, a JSON file of "
        "changes to the task's config, or these changes as JSON; may be given again",
    )
    add("n_steps", "steps of each env between updates", **number)
    add("batch_size", "samples in a gradient step", **number)
    add("n_epochs", "passes over the samples of an update", **number)
    add("learning_rate", "Adam's initial step size; it decreases linearly to a tenth", **real)
    add("gamma", "discount per step of 0.02 s", **real)
    add("hidden", "widths of the hidden layers of the policy and of the value function", nargs="+", **number)
    add_choice("activation", "activation function of the hidden layers")
    flag = argparse.BooleanOptionalAction
    add("symmetric", "make the policy left/right symmetric by construction, as the robot is", action=flag)
    add("asymmetric_critic", "let the value function see privileged readings; the policy never sees them", action=flag)
    add("log_std_init", "logarithm of the exploration's initial standard deviation", **real)
    add("final_log_std", "upper bound of that logarithm at the end, reached linearly", **real)
    add_terrain(parser, "from --task, or from the --recipe")
    add_randomization(parser, "from --task, or from the --recipe")


def _default(name: str) -> str:
    """Return the default of a field of `TrainConfig`, in words."""
    value = getattr(TrainConfig, name)
    if isinstance(value, bool):
        return "yes" if value else "no"
    return " ".join(map(str, value)) if isinstance(value, tuple) else str(value).lower()


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Train, and print where the result is."""
    typed, task_file, definition, whole = typed_settings(arguments)
    runs, resume = arguments.output, arguments.resume
    before = latest.resolve().name if (latest := runs / "latest").exists() else ""
    parent = None
    if resume is None:
        if arguments.trust_task:
            raise QuadrupedError("--trust-task: found without --resume; a new training names its file with --task FILE")
        config = with_recipe(typed, definition.robot, whole)
    else:
        from quadruped_env.training.resume import Parent

        if arguments.trust_task:
            if task_file is not None:
                raise QuadrupedError(f"--trust-task: found next to --task {task_file}; give one of them")
            kept = kept_file(resume)
            task_file = None if kept is None else kept[0]
            definition = BUILT_IN if kept is None else load_task_file(*kept)
        parent = Parent.load(resume, definition)
        config = parent.resumed(typed)
        budget = f"{config.timesteps:,} steps" if config.seconds is None else f"{config.seconds:g} s"
        print(f"continuing {parent.name} at {parent.timesteps:,} steps, for {budget}", flush=True)
        for difference in filter(None, (parent.task_changes, parent.reward_changes(config))):
            print(f"note: {difference}", flush=True)
    task = TaskConfig.from_dict(config.task, definition)
    for line in fitness(task.robot, task.clock_frequency, task.motor):
        print(f"note: {task.robot.name}: {line}", flush=True)
    # Torch takes seconds to import.
    from quadruped_env.training.train import train

    directory, finished = train(config, runs, invocation.line, parent, task_file, service=arguments.track)
    card = read_json(directory / CARD_FILE)["card"]
    steps, interrupted = card["timesteps"], card.get("interrupted")
    print(f"learned from {steps:,} steps in {card['seconds']:.0f} s")
    ended = "trained" if finished else f"stopped by {interrupted}, and saved what was learned"
    print(f"{ended} -> {directory}")
    print(f"{latest} now means this run{f', and no longer {before}' if before else ''}")
    gain = measure_learning(directory, task_file, steps)
    print(f"\n{gain.table()}\nIn its own task, {gain.episodes} episodes of {gain.seconds:g} s, it {gain.verdict()}")
    print("" if gain.is_better else "give it more --timesteps or --seconds, or continue with --resume\n")
    file = ["--trust-task"] if arguments.trust_task else [] if task_file is None else ["--task", task_file]
    print(f"evaluate it:  {program_command('evaluate', directory, *file)}")
    print(f"see it walk:  {program_command('view', directory, *file)}")
    print(f"see curves:   {module_command('tensorboard.main', '--logdir', runs)}")
    return 0 if finished else stopped_status(signal.Signals[interrupted])


def measure_learning(directory: Path, task_file: Path | None, timesteps: int) -> LearningGain:
    """Compare a run's policy with the zero action, and write the result into the policy's card.

    Trainings of fewer steps than the measurement takes are measured on fewer episodes, the shortest without motions.

    Raises:
        QuadrupedError: if the policy cannot be read, or its card cannot be written.
    """
    episodes = min(EPISODES, max(2, timesteps // MAX_EPISODE_STEPS))
    seeds = min(MOTION_SEEDS, timesteps // (2 * len(COMMANDS) * MAX_EPISODE_STEPS))
    progress = ProgressLine("measuring what it learned")
    policy, file = load_policy(directory, task_file), directory / PROGRESS_FILE
    gain = learning_gain(policy, episodes, progress=progress, motion_seeds=seeds, progress_file=file)
    path = directory / CARD_FILE
    document = read_json(path)
    document["card"]["learning"] = gain.to_dict()
    write_whole({path: (json.dumps(document, indent=2) + "\n").encode()})
    return gain


def typed_settings(arguments: argparse.Namespace) -> tuple[dict[str, Any], Path | None, TaskDefinition, set[str]]:
    """Return the settings of a training that were typed.

    Returns:
        Fields of `TrainConfig`, of which `task` holds changes; the Python file of `--task`; what it defines; and the
        sections of the task's config that an option sets as a whole.

    Raises:
        QuadrupedError: if a value of an option of the task is not valid.
    """
    typed = {name: value for name, value in vars(arguments).items() if name in hints_of(TrainConfig)}
    task_file, typed_task = task_changes(typed.pop("task", []))
    check_level_has_terrain(arguments)
    definition = BUILT_IN if task_file is None else load_task_file(task_file)
    whole = set()
    if arguments.terrain is not None:
        whole.add("terrain")
        level = {} if arguments.level is None else {"level": arguments.level}
        typed_task = changed(typed_task, {"terrain": {"name": arguments.terrain, **level}})
    if arguments.randomization is not None:
        whole.add("randomization")
        # As plain values, which a run keeps whatever becomes of the preset; values of --task change them.
        typed_task = changed({"randomization": preset_values(arguments.randomization, definition.robot)}, typed_task)
    if typed_task:
        typed["task"] = typed_task
    return typed, task_file, definition, whole


def count(text: str) -> int:
    """Parse a whole number, also as `1e6`, `100k` or `1.5M`."""
    factor = {"k": 1_000, "m": 1_000_000}.get(text[-1:].lower(), 1)
    try:
        number = Decimal(text if factor == 1 else text[:-1]) * factor
        if abs(number) < _MANY and number == int(number):
            return int(number)
    except (ArithmeticError, ValueError):
        pass
    raise argparse.ArgumentTypeError(
        f"expected a whole number, such as 1500000, 1e6, 100k or 1.5M; found {short(text)}"
    )


def task_change(text: str) -> Path | dict[str, Any]:
    """Parse one `--task`: a Python file by its path, or changes to the config from a JSON file or from JSON."""
    if text.endswith(".py"):
        return Path(text)
    try:
        if text.endswith(".json"):
            values = read_json(Path(text), "fix it")
        else:
            check_no_description(text)
            values = parse_json(text, f"found {text[:60]!r}", _TASK_RULE)
    except QuadrupedError as error:
        raise argparse.ArgumentTypeError(str(error)) from error
    if not isinstance(values, dict):
        raise argparse.ArgumentTypeError(f"found {text[:60]!r}; {_TASK_RULE}")
    return values


def task_changes(given: Sequence[Path | dict[str, Any]]) -> tuple[Path | None, dict[str, Any]]:
    """The Python file among the values of `--task`, and the merged changes to the config; later ones take precedence.

    Raises:
        QuadrupedError: if there are two Python files.
    """
    files = [entry for entry in given if isinstance(entry, Path)]
    if len(files) > 1:
        raise QuadrupedError(f"--task: expected one Python file; found {files[0]} and {files[1]}; put them into one")
    changes: dict[str, Any] = {}
    for entry in given:
        if isinstance(entry, dict):
            changes = changed(changes, entry)
    return next(iter(files), None), changes
