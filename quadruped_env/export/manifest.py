"""The manifest of an exported policy: everything that a program needs to run it, as JSON."""

from collections.abc import Mapping, Sequence
from typing import Any, Final

import numpy as np

from quadruped_env._version import __version__
from quadruped_env.control.live_controller import Safety
from quadruped_env.control.task_file import TASK_FILE
from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.evaluation.results import CardResults
from quadruped_env.export.golden_trace import trace_document
from quadruped_env.export.onnx_graph import OPSET
from quadruped_env.export.onnx_interface import HISTORY, LAST_ACTION, Input, PolicyInterface
from quadruped_env.policies import Policy
from quadruped_env.utils.plain import plain

MANIFEST_FILE: Final = "manifest.json"
GRAPH_FILE: Final = "policy.onnx"
PAGE_FILE: Final = "walk.html"
"""The page that walks; `quadruped_env.walking_page` writes it, also next to a report."""
CONTROLLERS_FILE: Final = "controllers.yaml"
FORMAT: Final = "mini-quadruped policy"
FORMAT_VERSION: Final = 1

_MEANING: Final = {
    2: "velocity of the base in its own frame: forward along x, and yaw rate about z, positive to the left",
    3: "velocity of the base in its own frame: forward along x, yaw rate about z, and lateral along y, positive to the "
    "left",
}
"""Meaning of the commanded velocities, by their number."""
_FIRST_INPUTS: Final = {LAST_ACTION: 0.0, HISTORY: "NaN"}

_TARGET: Final = {
    "position": "clip(stance + action_scale * action, lower, upper)",
    "residual": "clip(residual_gait + action_scale * action, lower, upper)",
}


def manifest(
    policy: Policy,
    interface: PolicyInterface,
    name: str,
    evaluation: Mapping[str, Any] | None,
    difference: float,
    learning: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Return the manifest without its list of files.

    `difference` is the largest one between the graph on ONNX Runtime and the policy; `learning` is the gain over the
    zero action.
    """
    control = policy.control
    facts = {key: value for key, value in policy.card.items() if key not in CardResults.__optional_keys__}
    return {
        "format": FORMAT,
        "format_version": FORMAT_VERSION,
        "name": name,
        "package": f"mini-quadruped {__version__}",
        "robot": {**policy.robot.identity, "joints": list(policy.robot.joint_names)},
        "joints": _joints(policy),
        "control": {
            "rate_hz": 1.0 / control.timestep,
            "timestep_s": control.timestep,
            "action_mode": policy.action_mode,
            "action_scale_rad": control.action.scale,
            "joint_target": _TARGET[policy.action_mode],
            "motor_delay_s": policy.config.motor.delay,
        },
        "graph": {
            "file": GRAPH_FILE,
            "onnx_opset": OPSET,
            "type": "float32",
            "inputs": [_value(entry) for entry in interface.inputs],
            "outputs": [_value(entry) for entry in interface.outputs],
            "largest_difference_from_the_policy": difference,
        },
        "golden_trace": trace_document(interface),
        "observation": _observation(interface),
        "command": _command(interface),
        "entry": _entry(policy, interface),
        "task": {"config": policy.task, "task_file": policy.task.get(TASK_FILE)},
        "training": facts,
        "learning": learning,
        "evaluation": None if evaluation is None else dict(evaluation),
    }


def metadata(policy: Policy, interface: PolicyInterface) -> dict[str, str]:
    """Return the graph's `metadata_props` under the names of mjlab's exporter, and `update_rate` of exploy's.

    A list is one text with commas, one value per joint, observation or command.
    """
    robot, fields = policy.robot, interface.layout.document()
    motors = policy.config.motor.of_joints(robot.joint_kinds)
    scales = [np.ravel(field["scale"]) for field in fields]
    values: dict[str, Sequence[Any]] = {
        "joint_names": robot.joint_names,
        "default_joint_pos": robot.stance.tolist(),
        "joint_stiffness": [motor.kp for motor in motors],
        "joint_damping": [motor.kd for motor in motors],
        "action_scale": [policy.control.action.scale] * robot.num_joints,
        "action_mode": [policy.action_mode],
        "observation_names": [field["name"] for field in fields],
        # More than one if the columns differ.
        "observation_scales": [" ".join(f"{number:.9g}" for number in scale) for scale in scales],
        "observation_history_lengths": [interface.layout.history] * len(fields),
        "command_names": [entry.name for entry in policy.control.commands],
    }
    lists = {
        key: ",".join(f"{entry:.9g}" if isinstance(entry, float) else str(entry) for entry in entries)
        for key, entries in values.items()
    }
    return {**lists, "update_rate": f"{1.0 / policy.control.timestep:.9g}"}


def _joints(policy: Policy) -> list[dict[str, Any]]:
    robot = policy.robot
    joints = []
    motors = policy.config.motor.of_joints(robot.joint_kinds)
    for i, (name, motor) in enumerate(zip(robot.joint_names, motors, strict=True)):
        joints.append(
            {
                "name": name,
                "stance_rad": float(robot.stance[i]),
                "lower_rad": float(robot.joint_position_low[i]),
                "upper_rad": float(robot.joint_position_high[i]),
                "velocity_limit_rad_s": float(robot.velocity_limit[i]),
                "effort_limit_n_m": float(robot.effort_limit[i]),
                "kp_n_m_rad": motor.kp,
                "kd_n_m_s_rad": motor.kd,
                "stall_torque_n_m": motor.stall_torque,
                "no_load_speed_rad_s": motor.no_load_speed,
                "damping_n_m_s_rad": motor.damping,
                "friction_n_m": motor.friction_loss,
                "rotor_inertia_at_joint_kg_m2": motor.armature,
            }
        )
    return joints


def _value(entry: Input) -> dict[str, Any]:
    return {"name": entry.name, "shape": ["batch", entry.width], "unit": entry.unit, "description": entry.description}


def _observation(interface: PolicyInterface) -> dict[str, Any]:
    """Return the graph's own arithmetic: for those who compute the observation themselves."""
    layout = interface.layout
    return {
        "formula": "clip((input - offset) * scale, low, high); the graph computes it",
        "order": "fields of this step, then of the history - 1 steps before, the latest first; before the first "
        "step, the first observation stands for them",
        "width": layout.width,
        "history": layout.history,
        "fields": [
            {
                **document,
                "columns": [layout.slices[entry.name].start, layout.slices[entry.name].stop],
                "offset": plain(interface.offset(entry)),
                "description": entry.description,
            }
            for entry, document in zip(layout.fields, layout.document(), strict=True)
        ],
    }


def _command(interface: PolicyInterface) -> dict[str, Any]:
    policy = interface.policy
    rates = dict(enumerate(policy.control.command_rate))
    components = [
        {
            "name": entry.name,
            "unit": entry.unit,
            "low": entry.range[0],
            "high": entry.range[1],
            "idle": 0.0 if i in rates else entry.default,
            **({"largest_rate": rates[i], "rate_unit": f"{entry.unit}^2"} if i in rates else {}),
        }
        for i, entry in enumerate(policy.control.commands)
    ]
    return {
        "meaning": _MEANING[len(interface.velocities)],
        "idle": "the robot stands",
        "input": "the velocity command on its way to the requested one. Once per control step, before the graph: "
        "command = command + clip(requested - command, -largest_rate * timestep, largest_rate * timestep), from the "
        "idle command on. The graph does not limit it",
        "standing_up_to": plain(moving_threshold(policy.robot)),
        "components": components,
    }


def _entry(policy: Policy, interface: PolicyInterface) -> dict[str, Any]:
    """Return the state in which the policy may start, and reasons to stop; the numbers are the live controller's."""
    safety = Safety.of(policy.robot)
    own = {entry.name for entry in interface.inputs}
    return {
        "pose": "the stance, at rest, on its feet",
        "joint_positions_rad": plain(policy.robot.stance),
        "base_height_m": policy.robot.stance_height,
        "mean_speed_rad_s": safety.ramp_speed,
        "min_time_s": safety.min_ramp_time,
        "settle_s": safety.settle,
        "first_inputs": {name: value for name, value in _FIRST_INPUTS.items() if name in own},
        "command": "idle",
        "stop": {
            "tilt_rad": safety.max_tilt,
            "no_command_s": safety.command_timeout,
            "no_reading_hold_s": safety.hold_after,
            "no_reading_limp_s": safety.limp_after,
        },
    }
