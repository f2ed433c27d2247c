"""Make a policy of a model that another program trained: an ONNX file, or the zip of model.save of Stable-Baselines3.

A zip and its statistics are pickled: LOADING THEM EXECUTES WHATEVER CODE IS IN THEM, so import only files that you
trust. An ONNX file and the policy that is written are data, and execute nothing; all other programs take the policy.

    mini-quadruped import-policy policy.onnx                                      runs/policy; of rsl_rl or mjlab
    mini-quadruped import-policy model.zip --action-mode residual -o runs/mine    trained with action_mode="residual"
    mini-quadruped import-policy model.zip --vecnormalize vecnormalize.pkl        trained in a VecNormalize

The files do not hold their env: give the action mode and the task of the training.
"""

import argparse
from pathlib import Path

from quadruped_env.cli.common_options import add_output, add_overwrite
from quadruped_env.cli.invocation import Invocation
from quadruped_env.cli.train import task_change, task_changes
from quadruped_env.control.control_config import ACTION_MODES


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the model, its task, and the folder."""
    parser.add_argument(
        "model", type=Path, metavar="MODEL", help="an ONNX file, or the zip that model.save wrote, which is unpickled"
    )
    parser.add_argument(
        "--vecnormalize",
        type=Path,
        metavar="FILE",
        help="statistics of the VecNormalize in which a zip was trained, from VecNormalize.save; unpickled, too",
    )
    parser.add_argument(
        "--action-mode",
        choices=ACTION_MODES,
        help="action mode of the training's env (default: from --task, or position, as for gymnasium.make)",
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
    add_overwrite(parser, "replace a policy that is there")
    add_output(parser, "DIR", "folder of the policy (default: runs/ and the model's name)")


def run(arguments: argparse.Namespace, invocation: Invocation) -> int:
    """Import the model, and print what was assumed and how the policy is used."""
    from quadruped_env.envs.arguments import task_config
    from quadruped_env.errors import QuadrupedError
    from quadruped_env.policies import Policy
    from quadruped_env.policies.policy_data import CARD_FILE
    from quadruped_env.utils.files import check_free
    from quadruped_env.utils.interpreter import program_command

    model, vecnormalize = arguments.model, arguments.vecnormalize
    output = arguments.output or Path("runs", model.stem)
    check_free([output / CARD_FILE], arguments.overwrite)
    file, changes = task_changes(arguments.task)
    config = task_config(arguments.action_mode, changes, file)
    if model.suffix.lower() == ".onnx":
        if vecnormalize is not None:
            raise QuadrupedError("--vecnormalize: found with an ONNX file, whose graph normalizes itself; leave it out")
        policy = Policy.from_onnx(model, config=config)
    else:
        from quadruped_env.training.policy_import import import_policy

        unpickled = " and ".join(str(path) for path in (model, vecnormalize) if path)
        print(f"unpickling {unpickled}: whatever code is in there is executed", flush=True)
        policy = import_policy(model, config, vecnormalize)
    policy.save(output)
    algo, steps = policy.card.get("algo"), policy.card.get("timesteps")
    trained = f"{algo.upper()} of {steps:,} steps, " if algo else ""
    print(f"{trained}{len(policy.weights)} layers, {policy.activation} -> {output}")
    normalized = "with" if vecnormalize else "without"
    print(
        f"assumed: action mode {policy.action_mode} (--action-mode), actions of {policy.control.action.scale:g} rad, "
        f"{normalized} VecNormalize"
    )
    task = [] if file is None else ["--task", file]
    for text, name in (("evaluate it:  ", "evaluate"), ("see it walk:  ", "view")):
        print(f"{text}{program_command(name, output, *task)}")
    return 0
