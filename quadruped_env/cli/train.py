"""Train a walking policy with PPO.

mini-quadruped train                          two minutes or less, then a policy that walks
mini-quadruped train --action-mode position   without the scripted gait underneath
mini-quadruped train --terrain rough          on uneven ground
mini-quadruped train --randomization hard     with other masses, motors, latency and pushes in each episode
mini-quadruped train --task my_task.py        with rewards, observations or randomizations of your own
mini-quadruped train --resume runs/latest     continue an earlier run, or the last checkpoint of an interrupted one
"""

import argparse
import dataclasses
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final, get_args

from quadruped_env._python import module_command, program_command
from quadruped_env.cli.commands import Invocation
from quadruped_env.cli.options import add_output, add_randomization, add_terrain, check_level_has_terrain
from quadruped_env.documents import read_json
from quadruped_env.errors import QuadrupedError
from quadruped_env.task import BUILT_IN, load_task_file, preset_values
from quadruped_env.training import TrainConfig

RUNS: Final = Path("runs")
"""Default directory of the run directories."""
_METAVARS: Final[dict[type, str]] = {int: "N", float: "X", str: "NAME"}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the fields of `TrainConfig`, and the places of the runs."""
    docs = field_docs(TrainConfig)
    for field in dataclasses.fields(TrainConfig):
        option = f"--{field.name.replace('_', '-')}"
        default = field.default if field.default is not dataclasses.MISSING else {}
        # Without defaults: those of a resumed run are the run's.
        options: dict[str, Any] = {
            "default": argparse.SUPPRESS,
            "help": f"{docs[field.name]} (default: {default})".replace("%", "%%"),
        }
        if field.name == "hidden":
            options.update(type=int, nargs="+", metavar="N")
        elif field.name == "task":
            options.update(
                type=task_change,
                action="append",
                metavar="TASK",
                help="a Python file of terms (docs/make-it-yours.md), a JSON file of changes to the task's config, or "
                "these changes as JSON; may be given again (default: {})",
            )
        elif isinstance(default, bool):
            options.update(action=argparse.BooleanOptionalAction)
        elif get_args(field.type) and isinstance(default, str):
            options.update(choices=get_args(field.type))
        else:
            kind = {"seconds": float, "log_std_init": float}.get(field.name, type(default))
            options.update(type=kind, metavar=_METAVARS[kind])
        parser.add_argument(option, **options)
    add_terrain(parser, "that of --task, or flat")
    add_randomization(parser, "that of --task, or none")
    add_output(parser, "DIR", f"directory of the run directories (default: {RUNS})", RUNS, alias="--runs")
    parser.add_argument(
        "--resume",
        type=Path,
        metavar="RUN",
        help="run or checkpoint to continue, with its task, network and other settings; options change the others. "
        "Without a budget: the rest of the run's budget, or the same again if it was complete. The schedules continue "
        "from where they were",
    )


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Train, and print where the result is."""
    names = {field.name for field in dataclasses.fields(TrainConfig)}
    typed = {name: value for name, value in vars(arguments).items() if name in names}
    if "hidden" in typed:
        typed["hidden"] = tuple(typed["hidden"])
    task_file, typed_task = task_changes(typed.pop("task", []))
    check_level_has_terrain(arguments)
    whole: dict[str, str] = {}
    if arguments.terrain is not None:
        whole["terrain"] = "terrain"
        level = {} if arguments.level is None else {"level": arguments.level}
        typed_task = merged(typed_task, {"terrain": {"name": arguments.terrain, **level}})
    if arguments.randomization is not None:
        whole["randomization"] = "randomization"
        # As plain values, which a run keeps whatever becomes of the preset; those of --task change them.
        robot = (BUILT_IN if task_file is None else load_task_file(task_file)).robot
        typed_task = merged({"randomization": preset_values(arguments.randomization, robot)}, typed_task)
    if typed_task:
        typed["task"] = typed_task
    runs, resume = arguments.output, arguments.resume
    before = latest.resolve().name if (latest := runs / "latest").exists() else ""
    if resume is None:
        config = TrainConfig(**typed)
    else:
        from quadruped_env.training.resume import Parent

        parent = Parent.load(resume, BUILT_IN if task_file is None else load_task_file(task_file))
        config, resume = parent.resumed(typed, whole), parent.directory
        budget = f"{config.timesteps:,} steps" if config.seconds is None else f"{config.seconds:g} s"
        print(f"continuing {parent.name} at {parent.timesteps:,} steps, for {budget}", flush=True)
    # Torch and Stable-Baselines3 take seconds to import: not before --help and the checks of the arguments.
    from quadruped_env.policies import load_policy
    from quadruped_env.training.config import shortness
    from quadruped_env.training.ppo import train

    directory, finished = train(config, runs, invocation.line, resume, task_file)
    advice = shortness(config.action_mode, load_policy(directory, task_file).card["timesteps"])
    print("trained" if finished else "stopped, and saved what was learned", f"-> {directory}")
    print(f"{latest} now means this run{f', and no longer {before}' if before else ''}")
    if advice:
        print(advice)
    task = [] if task_file is None else ["--task", task_file]
    print(f"evaluate it:  {program_command('evaluate', directory, *task)}")
    print(f"see it walk:  {program_command('view', directory, *task)}")
    print(f"see curves:   {module_command('tensorboard.main', '--logdir', runs)}")
    return 0


def task_change(text: str) -> Path | dict[str, Any]:
    """Parse one `--task`: a Python file by its path, or changes to the config from a JSON file or from JSON."""
    if text.endswith(".py"):
        return Path(text)
    if text.endswith(".json"):
        try:
            values = read_json(Path(text), "fix it")
        except QuadrupedError as error:
            raise argparse.ArgumentTypeError(str(error)) from error
        if not isinstance(values, dict):
            raise argparse.ArgumentTypeError(f"{text}: expected a JSON object of changes to the task's config")
        return values
    return json_object(text)


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
            changes = merged(changes, entry)
    return next(iter(files), None), changes


def merged(values: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    """Nested values with changes applied."""
    result = dict(values)
    for name, value in changes.items():
        both = isinstance(value, dict) and isinstance(result.get(name), dict)
        result[name] = merged(result[name], value) if both else value
    return result


def json_object(text: str) -> dict[str, Any]:
    """Parse an argument that is a JSON object."""
    try:
        value = json.loads(text)
    except (ValueError, RecursionError) as error:
        found = f"{text[:60]!r} ({error})"
    else:
        if isinstance(value, dict):
            return value
        found = f"{text[:60]!r}"
    example = '\'{"command": {"yaw_rate": [-0.4, 0.4]}}\''
    raise argparse.ArgumentTypeError(f"expected a JSON object such as {example}; found {found}")


def field_docs(kind: type) -> dict[str, str]:
    """Docstring of each field of a dataclass in the source, by name of the field."""
    import ast
    import inspect
    import itertools

    body = ast.parse(inspect.getsource(kind)).body[0].body  # type: ignore[attr-defined]
    return {
        ast.unparse(statement.target): ast.literal_eval(following.value)
        for statement, following in itertools.pairwise(body)
        if isinstance(statement, ast.AnnAssign) and isinstance(following, ast.Expr)
    }
