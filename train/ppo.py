"""Train a walking policy with PPO.

python train/ppo.py                          a policy that walks, in two minutes or less
python train/ppo.py --action-mode position   without the scripted gait underneath
python train/ppo.py --resume runs/latest     continue a run, or the last checkpoint of one that was killed
"""

import argparse
import dataclasses
import json
import shlex
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

sys.path.append(str(Path(__file__).parents[1]))  # for a Python without the package, which then names the one to use

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import module_command, pasteable, program_command
from quadruped_env.cli.options import plain_warnings
from quadruped_env.policies import load_policy
from quadruped_env.training import TrainConfig
from quadruped_env.training.config import shortness
from quadruped_env.training.resume import Parent


@dataclass(frozen=True)
class Args(TrainConfig):
    """`TrainConfig`, and the directories of runs."""

    runs: Path = Path("runs")
    """Directory of the run directories"""
    resume: Path | None = None
    """Run or checkpoint to continue, with its task and network; options change the other settings. Without a budget:
    the rest of the run's, or the same amount again if it was complete. The schedules continue where they were"""


def parse(argv: list[str]) -> dict[str, Any]:
    """The fields of `Args` that were typed."""
    # Without defaults: a resumed run has other ones.
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__),
        formatter_class=argparse.RawDescriptionHelpFormatter,
        argument_default=argparse.SUPPRESS,
    )
    helps = {**field_docs(TrainConfig), **field_docs(Args)}
    for field in dataclasses.fields(Args):
        option = f"--{field.name.replace('_', '-')}"
        default = field.default if field.default is not dataclasses.MISSING else {}
        text = f"{helps[field.name]} (default: {default})".replace("%", "%%")
        if field.name == "hidden":
            parser.add_argument(option, type=int, nargs="+", help=text)
        elif field.name == "task":
            parser.add_argument(option, type=json_object, metavar="JSON", help=text)
        elif isinstance(default, bool):
            parser.add_argument(option, action=argparse.BooleanOptionalAction, help=text)
        elif get_args(field.type) and isinstance(default, str):
            parser.add_argument(option, choices=get_args(field.type), help=text)
        else:
            kind = {"seconds": float, "log_std_init": float, "resume": Path}.get(field.name, type(default))
            parser.add_argument(option, type=kind, help=text)
    typed = vars(parser.parse_args(argv))
    return {name: tuple(value) if name == "hidden" else value for name, value in typed.items()}


def json_object(text: str) -> dict[str, Any]:
    """A JSON object, as an argument."""
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
    """The docstring under each field of a dataclass: stated once, in the source, and shown by --help."""
    import ast
    import inspect
    import itertools

    body = ast.parse(inspect.getsource(kind)).body[0].body  # type: ignore[attr-defined]
    docs = {}
    for statement, following in itertools.pairwise(body):
        if isinstance(statement, ast.AnnAssign) and isinstance(following, ast.Expr):
            docs[statement.target.id] = following.value.value  # type: ignore[attr-defined]
    return docs


def main() -> int:
    """Train, and print where the result is."""
    try:
        typed = parse(sys.argv[1:])
        runs, resume = typed.pop("runs", Args.runs), typed.pop("resume", None)
        before = latest.resolve().name if (latest := runs / "latest").exists() else ""
        if resume is None:
            config = TrainConfig(**typed)
        else:
            with plain_warnings("ppo.py"):
                parent = Parent.load(resume)
            config, resume = parent.resumed(typed), parent.directory
            budget = f"{config.timesteps:,} steps" if config.seconds is None else f"{config.seconds:g} s"
            print(f"continuing {parent.name} at {parent.timesteps:,} steps, for {budget}", flush=True)
        # Torch and Stable-Baselines3 take seconds to import: not before --help and the checks of the arguments.
        from quadruped_env.training.ppo import train

        directory, finished = train(config, runs, shlex.join(["python", *sys.argv]), resume)
        word = shortness(config.action_mode, load_policy(directory).card["timesteps"])
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print("trained" if finished else "stopped, and saved what was learned", f"-> {directory}")
    print(f"{latest} now means this run{f', and no longer {before}' if before else ''}")
    if word:
        print(word)
    print(f"evaluate it:  {program_command('evaluate/policy.py', directory)}")
    print(f"see it walk:  {program_command('evaluate/view.py', directory)}")
    print(f"see curves:   {module_command('tensorboard.main', '--logdir', runs)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
