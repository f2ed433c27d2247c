"""The page of an exported policy: README.md of its folder, which model hubs show as the model's card."""

import json
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Final

from quadruped_env.envs import ENV_ID
from quadruped_env.evaluation.learning_gain import GAIN_HEADER, gain_rows, reward_in_words, table_note
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.c_source import HEADER_FILE, SKETCH_FILE, SOURCE_FILE
from quadruped_env.export.golden_trace import TRACE_FILE
from quadruped_env.export.manifest import CONTROLLERS_FILE, GRAPH_FILE, MANIFEST_FILE, PAGE_FILE
from quadruped_env.export.onnx_interface import PolicyInterface

CARD_PAGE: Final = "README.md"
LIBRARY: Final = "mini-quadruped"
TAGS: Final = ("reinforcement-learning", "robotics", "quadruped", "locomotion", "mujoco", "gymnasium", "onnx")

_SHOWN: Final = {
    "forward_velocity_error": "velocity error (m/s)",
    "yaw_rate_error": "yaw rate error (rad/s)",
    "lateral_velocity_error": "lateral velocity error (m/s)",
    "fall_rate": "falls",
    "electrical_cost_of_transport": "electrical cost of transport",
    "mechanical_cost_of_transport": "mechanical cost of transport",
}


def card_page(interface: PolicyInterface, manifest: Mapping[str, Any], film: str | None, files: Iterable[str]) -> str:
    """Return the page in Markdown, with front matter for model hubs; `files` are the other files of the folder."""
    sections = [
        _front_matter(manifest),
        f"# {manifest['name']}\n\n{_introduction(manifest)}",
        "" if film is None else f"![The robot walks.]({film})",
        f"## Use\n\n{_use(interface, manifest)}",
        f"## Check your loop\n\n{_check(manifest['golden_trace'])}",
        f"## Before it walks\n\n{_entry(manifest)}",
        f"## Results\n\n{_results(manifest['evaluation'])}",
        _learning(manifest["learning"]),
        f"## Training\n\n```text\n{json.dumps(manifest['training'], indent=2)}\n```",
        f"## Files\n\n{_files(files)}",
    ]
    return "\n\n".join(section for section in sections if section) + "\n"


def _front_matter(manifest: Mapping[str, Any]) -> str:
    """Return metadata for hubs, as YAML; the results in it are JSON, which YAML contains."""
    fields = [
        "tags:",
        *(f"  - {tag}" for tag in TAGS),
        "pipeline_tag: reinforcement-learning",
        "library_name: " + LIBRARY,
    ]
    if results := _by_motion(manifest["evaluation"]):
        fields.append(f"model-index: {json.dumps(_model_index(manifest['name'], results))}")
    return "\n".join(["---", *fields, "---"])


def _introduction(manifest: Mapping[str, Any]) -> str:
    control, command = manifest["control"], manifest["command"]["components"]
    ranges = ", ".join(f"{c['name'].replace('_', ' ')} {c['low']:.3g} to {c['high']:.3g} {c['unit']}" for c in command)
    mode = {
        "position": "Its actions are relative to the stance.",
        "residual": "Its actions are added to a scripted gait, which is part of the graph.",
    }[control["action_mode"]]
    return _filled(
        f"A policy for the robot `{manifest['robot']['name']}` ({len(manifest['joints'])} joints), made with "
        f"{manifest['package']}. It follows a command ({ranges}) at {control['rate_hz']:g} Hz. {mode}"
    )


def _use(interface: PolicyInterface, manifest: Mapping[str, Any]) -> str:
    inputs, outputs = (
        _table(
            [title, "columns", "unit", ""],
            [[f"`{entry.name}`", str(entry.width), entry.unit, entry.description] for entry in entries],
        )
        for title, entries in (("input", interface.inputs), ("output", interface.outputs))
    )
    joints = ", ".join(manifest["robot"]["joints"])
    text = _filled(
        f"`{GRAPH_FILE}` takes readings in SI units, float32 with a batch as first axis, and returns joint targets. "
        f"Offsets, scales and clipping are in the graph. The order of the joints is {joints}; `{MANIFEST_FILE}` has "
        f"their stance, limits and gains. The graph's command approaches the requested one at a limited rate, as in "
        f"the code. Vectors are in the frame of the base: x forward, y left, z up."
    )
    return f"{text}\n\n{inputs}\n\n{outputs}\n\n```python\n{example(interface)}```"


def _check(trace: Mapping[str, Any]) -> str:
    return _filled(
        f"`{trace['file']}` holds {trace['steps']} steps of readings and all that the loop makes of them, and "
        f"`{MANIFEST_FILE}` its columns and tolerances. `mini-quadruped check-export` compares the runtimes on a "
        f"computer, or a file that your own program wrote, and names the first step and field that differ."
    )


def example(interface: PolicyInterface) -> str:
    """Return Python code that runs the graph with ONNX Runtime and NumPy alone, in the folder of the policy."""
    feedback = graph_io.FEEDBACK
    own = {entry.name: entry.width for entry in interface.inputs if entry.name in feedback}
    kept_inputs = {entry.name: entry.width for entry in interface.inputs if entry.name in (*feedback, graph_io.COMMAND)}
    values = {graph_io.HISTORY: "np.full((1, {}), np.nan, np.float32)"}
    first = ", ".join(
        f'"{name}": {values.get(name, "np.zeros((1, {}), np.float32)").format(width)}'
        for name, width in kept_inputs.items()
    )
    control, largest, limited = interface.policy.control, "", ""
    if graph_io.COMMAND in kept_inputs:
        change = ", ".join(f"{rate * control.timestep:.7g}" for rate in control.command_rate)
        largest = (
            f"\nlargest_change = np.float32([{change}])  # of the command in a control step: {interface.velocity_units}"
        )
        limited = (
            f'\n    missing = inputs["{graph_io.COMMAND}"] - memory["{graph_io.COMMAND}"]'
            f'\n    memory["{graph_io.COMMAND}"] += np.clip(missing, -largest_change, largest_change)'
        )
    kept = "".join(f'\n    memory["{name}"] = outputs["{feedback[name]}"]' for name in own)
    readings = ", ".join(entry.name for entry in interface.inputs if entry.name not in own)
    return f'''\
import numpy as np
import onnxruntime

session = onnxruntime.InferenceSession("{GRAPH_FILE}")
names = [output.name for output in session.get_outputs()]
memory = {{{first}}}{largest}


def joint_targets(**readings):
    """Joint targets in rad, once every {1000.0 * control.timestep:g} ms, for the readings
    {readings}."""
    inputs = {{name: np.array([value], np.float32) for name, value in readings.items()}}\
{limited}
    outputs = dict(zip(names, session.run(names, {{**inputs, **memory}})))\
{kept}
    return outputs["{graph_io.JOINT_TARGET}"][0]
'''


def _entry(manifest: Mapping[str, Any]) -> str:
    entry, idle = manifest["entry"], [component["idle"] for component in manifest["command"]["components"]]
    gains = sorted({(joint["kp_n_m_rad"], joint["kd_n_m_s_rad"]) for joint in manifest["joints"]})
    servo = " or ".join(f"{kp:g} N m/rad and {kd:g} N m s/rad" for kp, kd in gains)
    stop = entry["stop"]
    return "\n".join(
        [
            _item(f"Position servos with the gains {servo}, within each joint's limits (`{MANIFEST_FILE}`)."),
            _item(
                f"Move slowly to the stance, in {entry['min_time_s']:.3g} s or more, and hold it for "
                f"{entry['settle_s']:.3g} s. Then call the policy, beginning with the idle {graph_io.COMMAND} {idle}."
            ),
            _item(
                f"Keep commands within their ranges. Send the idle one after {stop['no_command_s']:g} s without a "
                f"command, hold the targets after {stop['no_reading_hold_s']:g} s without readings, and switch the "
                f"motors off after {stop['no_reading_limp_s']:g} s, or at a tilt of {stop['tilt_rad']:g} rad."
            ),
            _item("Check the targets before you send them: NaN in any reading makes all of them NaN."),
            _item("Test it in a simulation of your robot first, then on a stand."),
        ]
    )


def _results(evaluation: Mapping[str, Any] | None) -> str:
    if evaluation is None:
        return "It was not evaluated before the export."
    parts = []
    if verdict := evaluation.get("verdict"):
        parts.append(verdict["headline"] if isinstance(verdict, Mapping) else f"```text\n{verdict}\n```")
    if (suite := evaluation.get("suite")) and "score" in suite:
        name = suite.get("suite", suite)
        quick = ", quick" if name.get("quick") else ""
        score = suite["score"]["total"]
        parts.append(f"Score in the suite {name['name']} {name['version']}{quick}: {score:.3f} of 1.")
    if results := _by_motion(evaluation):
        shown = [metric for metric in _SHOWN if any(metric in found for found in results.values())]
        rows = [
            [motion, *("-" if found.get(metric) is None else f"{found[metric]:.3g}" for metric in shown)]
            for motion, found in results.items()
        ]
        parts.append(_table(["", *map(_SHOWN.__getitem__, shown)], rows))
    return "\n\n".join(parts)


def _by_motion(evaluation: Mapping[str, Any] | None) -> dict[str, dict[str, float | None]]:
    """Return motion -> metric -> mean, None where it was not measured; empty without an evaluation."""
    found = {} if evaluation is None else evaluation.get("by_motion") or evaluation.get("metrics") or {}
    return {
        motion: {metric: value["mean"] if isinstance(value, Mapping) else value for metric, value in values.items()}
        for motion, values in found.items()
    }


def _learning(learning: Mapping[str, Any] | None) -> str:
    """Return the section of the gain over the zero action; empty for a policy whose card has none."""
    if learning is None:
        return ""
    text = _filled(
        f"Policy and zero action in its own task, over {learning['episodes']} episodes of {learning['seconds']:g} s: "
        f"{learning['verdict']}; {reward_in_words(learning)}. 95 % intervals are in brackets. {table_note(learning)}"
    )
    return f"## What learning added\n\n{text}\n\n{_table(GAIN_HEADER, gain_rows(learning))}"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown."""
    return "\n".join(f"| {' | '.join(cells)} |" for cells in (head, ["---"] * len(head), *rows))


def _files(files: Iterable[str]) -> str:
    meanings = {
        GRAPH_FILE: "the policy: readings to joint targets, ONNX",
        TRACE_FILE: "readings and all that the loop makes of them, step by step, to compare your own loop with",
        MANIFEST_FILE: "joints, gains, limits, command, entry pose, training, results, and the SHA-256 of every file",
        "policy.json": 'the policy for this package: `load_policy(FOLDER)`, or from a hub `load_policy("hf://OWNER/NAME")`',
        "policy.safetensors": "its weights",
        "progress.csv": "the learning curve",
        PAGE_FILE: "the robot walks in your browser: one file, which makes no request",
        "film.webp": "the robot walks forwards, turns, and walks backwards",
        HEADER_FILE: "the policy for a microcontroller: readings and functions",
        SOURCE_FILE: "its weights and code, C99 without allocation",
        SKETCH_FILE: "a loop for an ESP32 with a PCA9685 and an MPU-6050; not run on hardware",
        CONTROLLERS_FILE: "parameters of ros2_control's controllers, for `controller --arrays`",
        "robot.urdf": "the robot, for ROS and other simulators",
        "robot.xml": "the robot, for MuJoCo",
    }
    return _table(["file", ""], [[f"`{name}`", meanings.get(name, "")] for name in files])


def _filled(text: str) -> str:
    return textwrap.fill(text, 120, break_long_words=False, break_on_hyphens=False)


def _item(text: str) -> str:
    return textwrap.fill(text, 120, initial_indent="- ", subsequent_indent="  ", break_on_hyphens=False)


def _model_index(name: str, results: Mapping[str, Mapping[str, float | None]]) -> list[dict[str, Any]]:
    """Return results (motion -> metric -> mean) as a hub lists them with a model."""
    listed = [
        {"type": metric, "name": f"{metric.replace('_', ' ')}, {motion}", "value": found[metric]}
        for motion, found in results.items()
        for metric in _SHOWN
        if found.get(metric) is not None
    ]
    task = {"type": "reinforcement-learning", "name": "walking as commanded"}
    return [{"name": name, "results": [{"task": task, "dataset": {"name": ENV_ID, "type": ENV_ID}, "metrics": listed}]}]
