"""Train a walking policy with PPO.

python train/ppo.py                          two minutes or less, then a policy that walks
python train/ppo.py --action-mode position   without the scripted gait underneath
python train/ppo.py --resume runs/latest     go on from an earlier run
"""

import argparse
import dataclasses
import json
import shlex
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, get_args

from quadruped_env import QuadrupedError
from quadruped_env.training import TrainConfig


@dataclass(frozen=True)
class Args(TrainConfig):
    """`TrainConfig`, and where to put and find runs."""

    runs: Path = Path("runs")
    """Directory of the run directories"""
    resume: Path | None = None
    """Run or checkpoint to go on from, with its task and network"""


def parse(argv: list[str]) -> Args:
    """Arguments as typed."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    helps = {**field_docs(TrainConfig), **field_docs(Args)}
    for field in dataclasses.fields(Args):
        option = f"--{field.name.replace('_', '-')}"
        default = field.default if field.default is not dataclasses.MISSING else {}
        text = f"{helps[field.name]} (default: {default})".replace("%", "%%")
        if field.name == "hidden":
            parser.add_argument(option, type=int, nargs="+", default=default, help=text)
        elif field.name == "task":
            parser.add_argument(option, type=json.loads, default={}, metavar="JSON", help=text)
        elif isinstance(default, bool):
            parser.add_argument(option, action=argparse.BooleanOptionalAction, default=default, help=text)
        elif get_args(field.type) and isinstance(default, str):
            parser.add_argument(option, choices=get_args(field.type), default=default, help=text)
        else:
            kind = {"seconds": float, "log_std_init": float, "resume": Path}.get(field.name, type(default))
            parser.add_argument(option, type=kind, default=default, help=text)
    values = vars(parser.parse_args(argv))
    return Args(**{**values, "hidden": tuple(values["hidden"])})


def field_docs(kind: type) -> dict[str, str]:
    """The docstring under each field of a dataclass: said once, in the source, and shown by --help."""
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
    """Train, and say where the result lies."""
    try:
        args = parse(sys.argv[1:])
        values: dict[str, Any] = {field.name: getattr(args, field.name) for field in dataclasses.fields(TrainConfig)}
        # Torch and Stable-Baselines3 take seconds to import: not before --help and the checks of the arguments.
        from quadruped_env.training.ppo import train

        directory, finished = train(TrainConfig(**values), args.runs, shlex.join(["python", *sys.argv]), args.resume)
    except QuadrupedError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    print("trained" if finished else "stopped, and saved what was learned", f"-> {directory}")
    print(f"evaluate it:  python evaluate/policy.py {directory}")
    print(f"see curves:   tensorboard --logdir {args.runs}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
