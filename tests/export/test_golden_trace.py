"""The golden trace against formulas, and its check: right runtimes pass, planted bugs are named with step and field."""

import csv
import dataclasses
import functools
import os
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
import second_robot
import twelve_joints
from comparisons import random_policy
from test_graph import TERMS, own_policy

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy, find_policy
from quadruped_env.export import runtime
from quadruped_env.export.folder import export_policy
from quadruped_env.export.trace_check import ExportedTrace
from quadruped_env.policies import load_policy

pytest.importorskip("onnx", reason="ONNX is not installed: pip install -e '.[export]'")
pytest.importorskip("onnxruntime", reason="ONNX Runtime is not installed: pip install -e '.[export]'")

OTHER_RUNTIMES = "ONNXRUNTIME_PYTHONS"


def blind():
    """A policy that observes neither command nor clock, without a history."""
    policy = random_policy("position", observation_history=1)
    fields = tuple(entry for entry in policy.fields if entry.name not in ("gait_clock", "command"))
    return dataclasses.replace(policy, weights=(policy.weights[0][:30], *policy.weights[1:]), fields=fields)


POLICIES = {
    "flat": lambda directory: load_policy("flat"),
    "blind": lambda directory: blind(),
    "other robot": lambda directory: random_policy("residual", second_robot.ROBOT),
    "twelve joints, residual": lambda directory: random_policy("residual", twelve_joints.ROBOT),
    "twelve joints, position": lambda directory: random_policy("position", twelve_joints.ROBOT),
    "own field": lambda directory: own_policy(directory, TERMS),
}


@pytest.fixture(scope="module")
def flat(tmp_path_factory):
    """The shipped policy, exported."""
    return export_policy(find_policy("flat", tmp_path_factory.mktemp("none")), tmp_path_factory.mktemp("out") / "flat")


@pytest.mark.parametrize("name", POLICIES)
def test_readings_of_the_trace_are_those_of_a_robot_that_walks_and_reach_their_bounds(name, tmp_path):
    """Results of the loop are compared with the C form in `test_c` and with runtimes below."""
    policy = POLICIES[name](tmp_path)
    evaluated = EvaluatedPolicy("mine", policy, tmp_path, tmp_path / "evaluation")
    export = export_policy(evaluated, tmp_path / "export")
    document, trace = export.manifest, ExportedTrace.load(export.folder).values
    gravity, position, velocity = (trace[field] for field in ("projected_gravity", "joint_position", "joint_velocity"))
    np.testing.assert_allclose(np.linalg.norm(gravity[:160], axis=1), 1.0, atol=1e-6)
    np.testing.assert_allclose(position[0], [joint["stance_rad"] for joint in document["joints"]], atol=1e-6)
    moved = np.diff(position[:160], axis=0) / document["control"]["timestep_s"]
    assert np.corrcoef(moved.ravel(), (velocity[:159] + velocity[1:160]).ravel())[0, 1] > 0.8
    high = np.concatenate([[field["high"]] * field["width"] for field in document["observation"]["fields"]])
    joints = slice(6, 6 + 2 * policy.robot.num_joints)
    assert np.isclose(np.abs(trace["observation"][160:]).max(axis=0), high)[joints].all(), "every joint's bounds"
    state = {"command", "requested_command", "gait_phase", "observation_history"}
    assert state & trace.keys() == (set() if name == "blind" else state)
    assert name == "blind" or len(np.unique(trace["requested_command"], axis=0)) >= 4
    assert name == "blind" or (np.ptp(trace["requested_command"], axis=0) > 0.1).all(), "every velocity"
    assert name != "own field" or set(trace["height_command"][:160].ravel()) == {np.float32(0.18)}


def test_manifest_and_card_describe_three_velocities(tmp_path):
    policy = random_policy("position", twelve_joints.ROBOT)
    export = export_policy(EvaluatedPolicy("mine", policy, tmp_path, tmp_path), tmp_path / "export")
    command = export.manifest["command"]
    forward, turn, left = command["components"]
    assert [part["name"] for part in (forward, turn, left)] == ["forward_velocity", "yaw_rate", "lateral_velocity"]
    assert [part["rate_unit"] for part in (forward, turn, left)] == ["m/s^2", "rad/s^2", "m/s^2"]
    assert left["high"] == -left["low"] == policy.control.commands[2].range[1]
    assert (left["largest_rate"], left["idle"]) == (policy.control.command_rate[2], 0.0)
    assert command["meaning"].endswith("lateral along y, positive to the left")
    assert len(command["standing_up_to"]) == len(export.manifest["golden_trace"]["largest_rates"]) == 3
    (entry,) = [entry for entry in export.manifest["graph"]["inputs"] if entry["name"] == "command"]
    assert (entry["shape"], entry["unit"]) == (["batch", 3], "m/s, rad/s, m/s")
    assert entry["description"].startswith("Commanded forward velocity, yaw rate and lateral velocity, on their way")
    card = (export.folder / "README.md").read_text()
    assert "idle command [0.0, 0.0, 0.0]" in " ".join(card.split())
    assert "lateral velocity -0.249 to 0.249 m/s" in " ".join(card.split())
    assert "# of the command in a control step: m/s, rad/s, m/s" in card


def test_program_runs_the_graph_and_says_that_it_equals_the_trace(flat, capsys):
    assert main(["check-export", str(flat.folder)]) == 0
    said = capsys.readouterr().out
    assert re.search(r"^ONNX Runtime: equal; largest difference \de-0\d \(last_action, .* joint_target\)$", said)


def shifted(graph, field, change):
    """A graph whose caller gets one of its inputs wrong."""
    return lambda inputs: graph({**inputs, field: change(inputs[field])})


def changed(graph, field, change):
    """A graph with another output."""

    def run(inputs):
        outputs = graph(inputs)
        return {**outputs, field: change(outputs[field])}

    return run


BUGS = {
    "two joints are swapped": ("observation", shifted, "joint_position", lambda x: x[:, [2, 1, 0, *range(3, 8)]]),
    "gravity points up": ("observation", shifted, "projected_gravity", np.negative),
    "velocity in degrees": ("observation", shifted, "joint_velocity", np.rad2deg),
    "last action is not fed back": ("observation", shifted, "last_action", np.zeros_like),
    "clock that stands": ("gait_phase", changed, "next_gait_phase", np.zeros_like),
    "history of one step": (
        "observation_history", changed, "next_observation_history", lambda x: x * (np.arange(68) < 34)
    ),
    "weights are rounded": ("action", changed, "action", lambda x: np.float32(np.float16(x) * 1.01)),
    "targets in degrees": ("joint_target", changed, "joint_target", np.rad2deg),
    "targets are not clipped": ("joint_target", changed, "joint_target", lambda x: np.maximum(x, -0.8)),
    "NaN": ("joint_target", changed, "joint_target", lambda x: x * np.float32(np.nan)),
}  # fmt: skip


@pytest.mark.parametrize("bug", BUGS)
def test_planted_bug_is_named_with_its_first_step_and_field(flat, bug):
    field, plant, name, change = BUGS[bug]
    trace, session = ExportedTrace.load(flat.folder), runtime.session_of((flat.folder / "policy.onnx").read_bytes())
    found = trace.in_runtime("mine", plant(functools.partial(runtime.run, session), name, change))
    step = re.match(rf"differs from step (\d+) on: {field}_\d+ is .*; the trace has ", found.text)
    assert not found.passed
    assert int(step[1]) <= 60


def test_graph_that_does_not_run_is_reported(flat, tmp_path, capsys):
    folder = shutil.copytree(flat.folder, tmp_path / "flat")
    (folder / "policy.onnx").write_bytes(b"\x08\x07")
    assert main(["check-export", str(folder)]) == 1
    assert "ONNX Runtime: does not run the graph: " in capsys.readouterr().out


def write(path, columns):
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))


def columns_of(folder):
    with (folder / "golden_trace.csv").open(newline="") as file:
        header, *lines = csv.reader(file)
    return dict(zip(header, map(list, zip(*lines, strict=True)), strict=True))


def test_file_of_ones_own_program_is_compared_in_the_fields_that_it_has(flat, tmp_path, capsys):
    columns, file = columns_of(flat.folder), tmp_path / "mine.csv"
    own = {name: text for name, text in columns.items() if name.startswith(("step", "command", "joint_target"))}
    write(file, own)
    assert main(["check-export", str(flat.folder), "--trace", str(file)]) == 0
    assert capsys.readouterr().out == "mine.csv: equal; largest difference 0 (command, joint_target)\n"
    # The command is not limited: the first step in which another one is requested.
    requested = [float(text) for text in columns["requested_command_0"]]
    step = next(step for step, value in enumerate(requested) if value != 0.0)
    write(file, {**own, "command_0": columns["requested_command_0"]})
    assert main(["check-export", str(flat.folder), "--trace", str(file)]) == 1
    said = capsys.readouterr().out
    assert f"mine.csv: differs from step {step} on: command_0 is {requested[step]:.7g}; the trace has 0.02" in said
    later = list(own["joint_target_3"])
    later[37] = str(float(later[37]) + 0.01)
    write(file, {**own, "joint_target_3": later})
    assert main(["check-export", str(flat.folder), "--trace", str(file)]) == 1
    assert "mine.csv: differs from step 37 on: joint_target_3 is" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda c: {k: v for k, v in c.items() if k != "action_7"}, "has no column 'action_7'; write all 8 of action"),
        (lambda c: {k: c[k] for k in ("step", "joint_position_0")}, "no column to compare; write one .*action"),
        (lambda c: {k: v[:150] for k, v in c.items()}, "has 150 lines .*; write one for each of 200 steps"),
        (lambda c: {k: v for k, v in c.items() if k != "step"}, "line 1 has 0 columns 'step'; expected one"),
        (lambda c: {**c, "action_0": ["left", *c["action_0"][1:]]}, "could not convert string 'left' .* at row 0"),
        (lambda c: {**c, "step": c["step"][::-1]}, r"step must be 0, 1, 2, \.\.\.; write one line for each step"),
    ],
)
def test_file_that_cannot_be_compared_is_refused_with_its_fix(flat, tmp_path, change, message):
    write(tmp_path / "mine.csv", change(columns_of(flat.folder)))
    with pytest.raises(QuadrupedError, match=rf"mine\.csv: .*{message}"):
        ExportedTrace.load(flat.folder).of_file(tmp_path / "mine.csv")


def interpreters():
    """This Python, and others that have another version of ONNX Runtime."""
    found = [path for path in os.environ.get(OTHER_RUNTIMES, "").split(os.pathsep) if path]
    other = "python -m venv old && old/bin/pip install onnxruntime==1.18.1 'numpy<2'"
    skip = pytest.mark.skip(reason=f"no other ONNX Runtime: {other}; {OTHER_RUNTIMES}=old/bin/python")
    return [sys.executable, *(found or [pytest.param("", marks=skip)])]


CHECK = """
trace = np.genfromtxt("golden_trace.csv", delimiter=",", names=True)
readings = ["projected_gravity", "angular_velocity", "joint_position", "joint_velocity"]
for step in trace:
    values = lambda name: [step[column] for column in trace.dtype.names if column.rpartition("_")[0] == name]
    targets = joint_targets(command=values("requested_command"), **{name: values(name) for name in readings})
    assert np.abs(targets - values("joint_target")).max() <= 1e-4, f"step {int(step['step'])}"
print(len(trace), onnxruntime.__version__)
"""


@pytest.mark.parametrize("python", interpreters())
def test_cards_code_passes_the_trace_in_this_and_in_other_versions_of_onnx_runtime(flat, python):
    def run(code):
        return subprocess.run([python, "-c", code], cwd=flat.folder, capture_output=True, text=True, check=False)

    (use,) = re.findall("```python\n(.*?)```", (flat.folder / "README.md").read_text(), re.DOTALL)
    done = run(use + CHECK)
    assert done.stdout.startswith("200 "), done.stderr
    # Without the limit of the command's change, the code is wrong from the first change on.
    done = run(use.replace("largest_change = np.float32([", "largest_change = 9.9 * np.float32([") + CHECK)
    assert re.search(r"AssertionError: step \d+", done.stderr)
