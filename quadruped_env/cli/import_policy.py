"""Make a policy of a model that Stable-Baselines3 or sb3-contrib saved: the zip of model.save.

The zip and the statistics are pickled: LOADING THEM EXECUTES WHATEVER CODE IS IN THEM, so import only files that you
trust. The policy that is written is data, and executes nothing; all other programs take it.

    mini-quadruped import-policy model.zip                                        runs/model
    mini-quadruped import-policy model.zip --action-mode residual -o runs/mine    trained with action_mode="residual"
    mini-quadruped import-policy model.zip --vecnormalize vecnormalize.pkl        trained in a VecNormalize

A zip does not hold its env: give the action mode and the task of the training.
"""

import argparse
from pathlib import Path

from quadruped_env.cli.common_options import add_output, add_overwrite
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.train import task_change, task_changes
from quadruped_env.control.control_config import ACTION_MODES


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the model, its task, and the folder."""
    parser.add_argument("model", type=Path, metavar="MODEL", help="the zip that model.save wrote; it is unpickled")
    parser.add_argument(
        "--vecnormalize",
        type=Path,
        metavar="FILE",
        help="statistics of the VecNormalize in which the model was trained, from VecNormalize.save; unpickled, too",
    )
    parser.add_argument(
        "--action-mode",
        choices=ACTION_MODES,
        help="action mode of the training's env (default: that of --task, or position, as of gymnasium.make)",
    )
    parser.add_argument(
        "--task",
        type=task_change,
        action="append",
        default=[],
        metavar="TASK",
        help="task of the training, if not the default: a Python file, which is executed, a JSON file of changes to "
        "its config, or these changes as JSON; may be given again",
    )
    parser.add_argument(
        "--algo",
        metavar="NAME",
        help="algorithm of the model (default: recognized), or FILE.py:CLASS for a class of your own; FILE is executed",
    )
    add_overwrite(parser, "replace a policy that is there")
    add_output(parser, "DIR", "folder of the policy (default: runs/ and the model's name)")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Import the model, and print what was assumed and how the policy is used."""
    from quadruped_env.envs.arguments import task_config
    from quadruped_env.policies.policy_data import CARD_FILE
    from quadruped_env.training.policy_import import algorithm_of, import_policy
    from quadruped_env.utils.files import check_free
    from quadruped_env.utils.interpreter import program_command

    output = arguments.output or Path("runs", arguments.model.stem)
    check_free([output / CARD_FILE], arguments.overwrite)
    file, changes = task_changes(arguments.task)
    config = task_config(arguments.action_mode, changes, file)
    algo = arguments.algo or algorithm_of(arguments.model)
    unpickled = " and ".join(str(path) for path in (arguments.model, arguments.vecnormalize) if path)
    print(f"unpickling {unpickled}: whatever code is in there is executed", flush=True)
    policy = import_policy(arguments.model, algo, config, arguments.vecnormalize)
    policy.save(output)
    card = policy.card
    print(f"{card['algo'].upper()} of {card['timesteps']:,} steps, {len(policy.weights)} layers -> {output}")
    normalized = "with" if arguments.vecnormalize else "without"
    print(f"assumed: action mode {policy.action_mode} (--action-mode), {normalized} VecNormalize")
    task = [] if file is None else ["--task", file]
    for text, name in (("evaluate it:  ", "evaluate"), ("see it walk:  ", "view")):
        print(f"{text}{program_command(name, output, *task)}")
    return 0
