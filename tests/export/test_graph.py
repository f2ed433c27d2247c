"""The ONNX graph of a policy on ONNX Runtime: equal to the policy by NumPy and by torch, alone and in an env."""

import dataclasses
import math

import numpy as np
import pytest
import second_robot
import twelve_joints
from comparisons import random_policy
from policies import make_policy

from quadruped_env import QuadrupedError
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.export import PolicyInterface, runtime
from quadruped_env.export.manifest import metadata
from quadruped_env.export.onnx_graph import OPSET, policy_graph
from quadruped_env.policies import Policy, load_policy
from quadruped_env.policies.activations import ACTIVATIONS
from quadruped_env.robot.readings import Readings
from quadruped_env.task import ActionConfig, TaskConfig, load_task_file

onnx = pytest.importorskip("onnx", reason="ONNX is not installed: pip install -e '.[export]'")
onnxruntime = pytest.importorskip("onnxruntime", reason="ONNX Runtime is not installed: pip install -e '.[export]'")

SAMPLES = 4_000
TOLERANCE = 1e-5


def session_of(policy):
    return runtime.session_of(policy_graph(PolicyInterface(policy), "test"))


def random_states(policy, samples=SAMPLES, seed=0):
    """Random readings, commands, phases, last actions and observations of the steps before of many robots.

    They are from within their limits and beyond. The observations before are NaN for some.
    """
    rng, robot = np.random.default_rng(seed), policy.robot
    readings = Readings.of_a_real_robot(robot)
    shape = (samples, robot.num_joints)
    gravity = rng.standard_normal((samples, 3))
    fields = {name: np.repeat(getattr(readings, name), samples, axis=0) for name in Readings.__slots__}
    fields |= {
        "up_b": gravity / np.linalg.norm(gravity, axis=1, keepdims=True),
        "angular_velocity_b": rng.normal(0.0, 8.0, (samples, 3)),
        "joint_position": rng.uniform(robot.joint_position_low - 0.5, robot.joint_position_high + 0.5, shape),
        "joint_velocity": rng.normal(0.0, 1.6 * robot.velocity_limit.max(), shape),
    }
    low, high = np.array([command.range for command in policy.control.commands[: policy.control.num_velocities]]).T
    command = rng.uniform(low - 0.2, high + 0.2, (samples, len(low)))
    command[::10] = 0.0
    command[1::10] = rng.uniform(-0.03, 0.03, (len(command[1::10]), len(low)))
    # What float32 cannot hold is not part of the comparison.
    exact = {name: np.float32(value).astype(float) for name, value in fields.items()}
    layout = PolicyInterface(policy).layout
    past = rng.uniform(layout.low, layout.high, (samples, layout.history - 1, layout.width)).reshape(samples, -1)
    past[:5] = np.nan  # at the beginning
    others = [command, rng.uniform(0.0, math.tau, samples), rng.uniform(-1.0, 1.0, shape), past]
    return Readings(**exact), *(np.float32(value).astype(float) for value in others)


def control_of(policy, command, phase, last_action, past):
    """The package's interface in that state."""
    control = ControlInterface(policy.robot, policy.control, len(command), policy.fields)
    control.reset(np.arange(len(command)), phase, command)
    control.action[:] = last_action
    # Two steps after the reset, where there is a past.
    steps = control.layout.history - 1
    control.steps[:] = np.where(np.isnan(past).any(axis=1), 0, steps)
    control._past[:, :steps] = past.reshape(len(past), steps, -1)
    return control


def graph_inputs(readings, command, phase, last_action, past):
    """The same state as the sensors of a robot give it."""
    values = {
        "projected_gravity": -readings.up_b,
        "angular_velocity": readings.angular_velocity_b,
        "joint_position": readings.joint_position,
        "joint_velocity": readings.joint_velocity,
        "last_action": last_action,
        "command": command,
        "gait_phase": phase[:, None],
        "observation_history": past,
    }
    return {name: value.astype(np.float32) for name, value in values.items()}


def network(policy, observation):
    """Actions of the policy's network by torch."""
    import torch

    from quadruped_env.training.sb3_models import _ACTIVATIONS

    activation = _ACTIVATIONS[policy.activation]
    layers = []
    for weight, bias in zip(policy.weights, policy.biases, strict=True):
        layer = torch.nn.Linear(*weight.shape)
        layer.weight.data, layer.bias.data = torch.from_numpy(weight.T.copy()), torch.from_numpy(bias.copy())
        layers += [layer, activation()]
    with torch.no_grad():
        return torch.nn.Sequential(*layers[:-1])(torch.from_numpy(observation)).clamp(-1.0, 1.0).numpy()


def low_stepping_policy():
    """A policy on top of the gait with low steps."""
    policy = random_policy("residual")
    task = TaskConfig(action=ActionConfig(mode="residual", gait="low"), clock_frequency=5.0)
    return Policy.for_task(policy.weights, policy.biases, policy.activation, task, policy.card)


POLICIES = {
    "shipped": lambda: load_policy("flat"),
    "position": lambda: random_policy("position"),
    "low steps, residual": low_stepping_policy,
    "elu, other rate": lambda: make_policy("elu"),
    **{name: lambda name=name: make_policy(name, (24,)) for name in ACTIVATIONS if name not in ("elu", "tanh")},
    "linear": lambda: make_policy("tanh", ()),
    "other robot, residual": lambda: random_policy("residual", second_robot.ROBOT),
    "other robot, position": lambda: random_policy("position", second_robot.ROBOT),
    "twelve joints, residual": lambda: random_policy("residual", twelve_joints.ROBOT),
    "twelve joints, position": lambda: random_policy("position", twelve_joints.ROBOT),
}


@pytest.mark.parametrize("name", POLICIES)
def test_onnx_runtime_numpy_and_torch_agree(name):
    policy = POLICIES[name]()
    readings, *state = random_states(policy)
    found = runtime.run(session_of(policy), graph_inputs(readings, *state))
    control = control_of(policy, *state)
    observation = control.observe(readings)
    action = policy.predict(observation)
    control.advance()
    np.testing.assert_allclose(found["action"], action, rtol=0, atol=TOLERANCE)
    np.testing.assert_allclose(found["action"], network(policy, observation), rtol=0, atol=TOLERANCE)
    target = control.joint_target(action.astype(float))
    np.testing.assert_allclose(found["joint_target"], target, rtol=0, atol=TOLERANCE)
    turned = np.abs(found["next_gait_phase"][:, 0] - control.phase)
    assert np.minimum(turned, math.tau - turned).max() < TOLERANCE
    # The random states reach every part of the graph.
    clipped = (np.abs(observation[:, : control.layout.width]) == control.layout.high.astype(np.float32)).any(axis=0)
    for field in ("angular_velocity", "joint_position", "joint_velocity"):
        assert clipped[control.layout.slices[field]].any()
    assert (control.moving == 0.0).any()
    assert np.median(np.ptp(action, axis=0)) > 0.1


def test_metadata_are_read_as_those_of_other_exporters(tmp_path):
    task = TaskConfig(action=ActionConfig(mode="position"), decimation=5).for_robot(second_robot.ROBOT)
    policy = random_policy("position")
    policy = Policy.for_task(policy.weights, policy.biases, policy.activation, task, {})
    interface, robot = PolicyInterface(policy), second_robot.ROBOT
    content = policy_graph(interface, "test", metadata=metadata(policy, interface))
    found = onnxruntime.InferenceSession(content, providers=["CPUExecutionProvider"]).get_modelmeta()
    lists = {name: text.split(",") for name, text in found.custom_metadata_map.items()}
    scales = [np.float64(text.split()) for text in lists.pop("observation_scales")]
    numbers = {
        "default_joint_pos": robot.stance,
        "joint_stiffness": [70.0 if "hip" in name else 60.0 for name in robot.joint_names],
        "joint_damping": [motor.kd for motor in robot.motors.of_joints(robot.joint_kinds)],
        "action_scale": [task.action.scale] * 8,
        "update_rate": [1.0 / task.control_timestep],
    }
    for name, expected in numbers.items():
        assert np.float64(lists.pop(name)) == pytest.approx(np.array(expected)), name
    for entry, scale in zip(policy.fields, scales, strict=True):
        assert scale == pytest.approx(np.unique(interface.layout.scale[interface.layout.slices[entry.name]]))
    assert lists == {
        "joint_names": list(robot.joint_names),
        "observation_names": [entry.name for entry in policy.fields],
        "observation_history_lengths": ["3"] * 7,
        "command_names": ["forward_velocity", "yaw_rate"],
        "action_mode": ["position"],
    }


def test_graph_takes_any_batch():
    content = policy_graph(PolicyInterface(load_policy("flat")), "flat")
    model = onnx.load_from_string(content)
    assert (model.ir_version, [(entry.domain, entry.version) for entry in model.opset_import]) == (8, [("", OPSET)])
    session = onnxruntime.InferenceSession(content, providers=["CPUExecutionProvider"])
    policy = load_policy("flat")
    inputs = graph_inputs(*random_states(policy, 7))
    together = runtime.run(session, inputs)
    for row in range(7):
        alone = runtime.run(session, {name: value[row : row + 1] for name, value in inputs.items()})
        for name, value in alone.items():
            np.testing.assert_allclose(value[0], together[name][row], rtol=0, atol=1e-6)
    assert {entry.name: entry.shape for entry in session.get_inputs()} == {
        entry.name: ["batch", entry.width] for entry in PolicyInterface(policy).inputs
    }


def test_same_policy_gives_the_same_file():
    one, other = (policy_graph(PolicyInterface(load_policy("flat")), "flat") for _ in range(2))
    assert one == other


def test_graph_of_a_training_is_torchs_policy():
    """From SB3's own network over the saved policy to ONNX."""
    import torch
    from networks import perturb

    from quadruped_env.envs import make_sb3_vec_env
    from quadruped_env.training import TrainConfig
    from quadruped_env.training.sb3_models import make_model

    torch.manual_seed(0)
    config = TrainConfig(num_envs=2, n_steps=8, batch_size=16)
    env = make_sb3_vec_env(2, seed=0, action_mode="residual")
    model = make_model(config, env)
    perturb(model, 0.05)
    policy = Policy.from_sb3(model, {})
    readings, *state = random_states(policy)
    observation = control_of(policy, *state).observe(readings)
    with torch.no_grad():
        mean = model.policy.get_distribution(torch.from_numpy(observation)).distribution.mean.clamp(-1.0, 1.0).numpy()
    found = runtime.run(session_of(policy), graph_inputs(readings, *state))
    np.testing.assert_allclose(found["action"], mean, rtol=0, atol=TOLERANCE)
    assert (np.abs(mean) < 1.0).mean() > 0.5


@pytest.mark.parametrize("name", ["projected_gravity", "joint_position", "joint_velocity", "command", "gait_phase"])
def test_reading_that_is_nan_gives_nan_targets(name):
    policy = load_policy("flat")
    inputs = graph_inputs(*random_states(policy, 4))
    inputs[name][2] = np.nan
    found = runtime.run(session_of(policy), inputs)
    assert np.isnan(found["joint_target"][2]).all()
    assert np.isfinite(found["joint_target"][[0, 1, 3]]).all()


TERMS = """
from quadruped_env.task import Command, observation

height = Command("height", "m", (0.15, 0.19), default=0.18)


@observation(unit="m", mirror=(1.0,), scale=5.0, bound=0.9)
def height_command(readings, control):
    "Commanded height of the base."
    return control.command_of("height")[:, None]
"""


def own_policy(tmp_path, text, widths=3 * 35):
    (tmp_path / "mine.py").write_text(text)
    definition = load_task_file(tmp_path / "mine.py")
    rng = np.random.default_rng(0)
    weights = [rng.normal(0.0, 0.3, shape).astype(np.float32) for shape in ((widths, 12), (12, 8))]
    biases = [np.zeros(width, np.float32) for width in (12, 8)]
    return Policy.for_task(weights, biases, "tanh", TaskConfig(definition=definition), {})


def test_field_of_a_users_file_is_an_input_in_its_unit(tmp_path):
    policy = own_policy(tmp_path, TERMS)
    interface = PolicyInterface(policy)
    entry = next(entry for entry in interface.inputs if entry.name == "height_command")
    assert (entry.width, entry.unit) == (1, "m")
    readings, command, phase, last_action, past = random_states(policy)
    height = np.float32(np.random.default_rng(1).uniform(0.1, 0.25, (SAMPLES, 1)))
    inputs = {**graph_inputs(readings, command, phase, last_action, past), "height_command": height}
    found = runtime.run(session_of(policy), inputs)
    control = control_of(policy, np.concatenate([command, height.astype(float)], axis=1), phase, last_action, past)
    action = policy.predict(control.observe(readings))
    np.testing.assert_allclose(found["action"], action, rtol=0, atol=TOLERANCE)
    assert runtime.largest_difference(interface, policy_graph(interface, "mine")) < TOLERANCE


def test_policy_without_clock_and_gait_needs_neither_command_nor_phase(tmp_path):
    policy = own_policy(tmp_path, TERMS)
    kept = tuple(entry for entry in policy.fields if entry.name not in ("gait_clock", "command"))
    weights = (policy.weights[0][: 3 * 31], policy.weights[1])
    blind = dataclasses.replace(policy, weights=weights, fields=kept)
    interface = PolicyInterface(blind)
    assert {entry.name for entry in interface.inputs} == {entry.name for entry in kept} | {"observation_history"}
    assert [entry.name for entry in interface.outputs] == ["action", "joint_target", "next_observation_history"]
    assert runtime.largest_difference(interface, policy_graph(interface, "blind")) < TOLERANCE


def test_field_with_the_name_of_another_input_is_refused(tmp_path):
    text = TERMS.replace("def height_command", "def command")
    with pytest.raises(QuadrupedError, match=r"export: the observation 'command' .* rename it and train again"):
        PolicyInterface(own_policy(tmp_path, text, 3 * 34)).inputs  # noqa: B018


def test_graph_that_differs_from_the_policy_is_refused():
    policy = load_policy("flat")
    content = policy_graph(PolicyInterface(policy), "flat")
    changed = [*policy.weights[:-1], policy.weights[-1] + np.float32(1e-3)]
    other = Policy.for_task(changed, policy.biases, policy.activation, policy.config, policy.card)
    with pytest.raises(QuadrupedError, match=r"ONNX Runtime differs from the policy by .* nothing was written"):
        runtime.largest_difference(PolicyInterface(other), content, 100)
