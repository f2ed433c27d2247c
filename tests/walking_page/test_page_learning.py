"""Learning on the page: mathematics against NumPy and torch, the task against the package's, a page that learns."""

import itertools
import json
import math
import shutil
import subprocess
from pathlib import Path

import browser
import numpy as np
import pytest
import second_robot
import torch
import twelve_joints
import waiting
from half_robot import ROBOT as HALF

from quadruped_env.policies import load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import SingleSimulation
from quadruped_env.task import Task, TaskConfig
from quadruped_env.walking_page import write_page
from quadruped_env.walking_page.learning import TERMS, learning_document

STANCE = np.array([0.6, -0.72] * 4)


def computed(name, **given):
    """A value of `learning_values.mjs`."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("no Node.js to run the page's programs with")
    text = json.dumps({"name": name, "input": given}, default=lambda array: np.asarray(array).tolist())
    script = Path(__file__).with_name("learning_values.mjs")
    return json.loads(subprocess.run([node, script], input=text, capture_output=True, text=True, check=True).stdout)


# --- mathematics


def test_advantages_of_two_robots_equal_values_by_hand():
    # Robots in columns. The first falls in its second step, so nothing after it counts before.
    rewards, values, ends = (
        [[1.0, 0.0], [2.0, 0.0], [3.0, 4.0]],
        [[0.5, 1.0], [1.0, 2.0], [2.0, 0.0]],
        [[0, 0], [1, 0], [0, 0]],
    )
    found = computed(
        "advantages", rewards=np.ravel(rewards), values=np.ravel(values), ends=np.ravel(ends), last=[4.0, 2.0],
        gamma=0.5, **{"lambda": 0.5},
    )  # fmt: skip
    # Errors r + V' / 2 - V: 1, 1, 3 and 0, -2, 5. A quarter of an advantage is added to the one before it.
    expected = np.array([[1.25, 0.0 + 0.25 * (-2 + 0.25 * 5)], [1.0, -2 + 0.25 * 5], [3.0, 5.0]])
    np.testing.assert_allclose(np.reshape(found["advantages"], (3, 2)), expected)
    np.testing.assert_allclose(np.reshape(found["returns"], (3, 2)), expected + values)


def test_episode_whose_time_is_up_is_continued_by_the_value_and_a_fall_is_not():
    ends = [{"step": 3, "fell": False}, {"step": 2, "fell": True}, {"step": 9, "fell": False}]
    found = computed("rollout", steps=4, ends=ends)
    assert found["totals"] == [12.0, 0.0, 1.0]
    np.testing.assert_array_equal(np.reshape(found["ends"], (4, 3)), [[0, 0, 0], [0, 1, 0], [1, 0, 0], [0, 0, 0]])
    rewards = np.ones((4, 3))
    rewards[2, 0] += 0.98 * 10.0
    np.testing.assert_allclose(np.reshape(found["rewards"], (4, 3)), rewards, rtol=1e-6)


def perceptron(parameters, sizes, inputs):
    """Outputs of a perceptron with elu (M, sizes[-1]), and the parameters that are left."""
    for inner, (n, m) in enumerate(itertools.pairwise(sizes), start=2):
        weights, biases, parameters = np.split(parameters, [n * m, (n + 1) * m])
        inputs = inputs @ weights.reshape(m, n).T + biases
        if inner < len(sizes):
            inputs = np.where(inputs > 0, inputs, np.expm1(np.minimum(inputs, 0)))
    return inputs, parameters


def loss(parameters, sizes, log_std, rollout, samples):
    """PPO's loss, summed over some samples, by its definition."""
    n, hidden, m = sizes
    observations, actions = (
        rollout[name].reshape(-1, width)[samples] for name, width in (("observations", n), ("actions", m))
    )
    mean, rest = perceptron(parameters, (n, *hidden, m), observations)
    value, _ = perceptron(rest, (n, *hidden, 1), observations)
    density = (-0.5 * ((actions - mean) / np.exp(log_std)) ** 2 - log_std).sum(axis=1)
    ratio, advantage = np.exp(density - rollout["logDensities"][samples]), rollout["advantages"][samples]
    surrogate = np.minimum(ratio * advantage, np.clip(ratio, 0.8, 1.2) * advantage)
    return (-surrogate + 0.5 * (value[:, 0] - rollout["returns"][samples]) ** 2).sum()


def test_gradient_equals_finite_differences_of_the_loss():
    rng, sizes, log_std, count = np.random.default_rng(0), (5, (4, 3), 2), -0.7, 40
    length = (6 * 4 + 5 * 3 + 4 * 2) + (6 * 4 + 5 * 3 + 4)
    parameters = rng.normal(size=length).astype(np.float32).astype(np.float64)
    rollout = {
        "observations": rng.normal(size=count * 5),
        "actions": rng.normal(size=count * 2),
        "advantages": rng.normal(size=count),
        "returns": rng.normal(size=count),
    }
    mean, _ = perceptron(parameters, (5, 4, 3, 2), rollout["observations"].reshape(-1, 5))
    away = (rollout["actions"].reshape(-1, 2) - mean) / math.exp(log_std)
    # Ratios on both sides of both clips, for advantages of both signs.
    rollout["logDensities"] = (-0.5 * away**2 - log_std).sum(axis=1) - rng.uniform(-0.6, 0.6, size=count)
    samples = np.arange(3, count)
    found = np.array(
        computed("gradient", sizes=sizes, parameters=parameters, logStd=log_std, rollout=rollout, samples=samples)
    )
    small = 1e-6 * np.eye(length)
    expected = [
        (
            loss(parameters + d, sizes, log_std, rollout, samples)
            - loss(parameters - d, sizes, log_std, rollout, samples)
        )
        / 2e-6
        for d in small
    ]
    np.testing.assert_allclose(found[:length], expected, rtol=1e-4, atol=1e-4)
    assert found[length + 1] == len(samples)


def test_adam_equals_torchs():
    rng = np.random.default_rng(1)
    start, gradients = rng.normal(size=6), rng.normal(size=(7, 6))
    parameter = torch.tensor(start, requires_grad=True)
    optimizer = torch.optim.Adam([parameter], lr=0.01)
    for gradient in gradients:
        parameter.grad = torch.tensor(gradient)
        optimizer.step()
    found = computed("adam", parameters=start, gradients=gradients, rate=0.01)
    np.testing.assert_allclose(found, parameter.detach().numpy(), rtol=1e-6)


def test_sums_over_workers_are_identical_and_in_order():
    first, second = np.random.default_rng(2).normal(size=(2, 3, 5)).astype(np.float32)
    found = computed("sums", first=first, second=second)
    assert found[0] == found[1] == found[2]
    np.testing.assert_allclose(found[0], [first.sum(axis=0), second.sum(axis=0)], rtol=1e-6, atol=1e-6)


# --- task


@pytest.mark.parametrize("robot", [MINI_QUADRUPED, HALF], ids=lambda robot: robot.name)
def test_terms_and_observation_equal_the_packages(robot):
    config, rng = TaskConfig(), np.random.default_rng(3)
    if robot is not MINI_QUADRUPED:
        config = config.for_robot(robot)
    task, document, steps = (
        Task(SingleSimulation(config.compiled_model(), robot), config),
        learning_document(config),
        [],
    )
    task.reset(np.zeros(1, dtype=np.intp), [0], (0.4, 0.3))
    steps, observed, terms = [], [], []
    for _ in range(60):
        command = task.control.command[0].copy()
        action = rng.uniform(-0.4, 0.4, size=robot.num_joints)
        transition = task.step(action[None])
        readings = task.simulation.readings
        names = (
            "joint_position",
            "joint_velocity",
            "linear_velocity_b",
            "angular_velocity_b",
            "foot_force",
            "foot_position",
        )
        steps.append(
            {name: getattr(readings, name)[0].ravel().tolist() for name in names}
            | {"projected_gravity": (-readings.up_b[0]).tolist(), "fallen": bool(transition.terminated[0])}
            | {"action": action.tolist(), "command": command.tolist(), "phase": float(task.control.phase[0])}
        )
        observed.append(transition.observation[0, : document_width(document)])
        terms.append(dict(zip(task.term_names, transition.terms[0], strict=True)))
    control = {"timestep": config.control_timestep, "command_rate": [9.0] * len(command)}
    found = computed("terms", learning=document, control=control, steps=steps)
    for step, (mine, package) in enumerate(zip(found, terms, strict=True)):
        weighted = {name: config.control_timestep * document["weights"][name] * mine["terms"][name] for name in TERMS}
        assert weighted == pytest.approx({name: package[name] for name in TERMS}, abs=1e-5), step
        assert mine["reward"] == pytest.approx(sum(weighted.values()), abs=1e-5)
    np.testing.assert_allclose([step["observation"] for step in found], observed, atol=1e-5)
    if robot is not MINI_QUADRUPED:
        return
    phase, action = steps[-1]["phase"], np.array(steps[-1]["action"])
    swing = np.sin(phase + np.repeat([0.0, math.pi, math.pi, 0.0], 2))
    marching = STANCE + np.array([0.1 / math.pi, -0.2 / math.pi] * 4) + np.array([0.05, -0.1] * 4) * swing
    np.testing.assert_allclose(found[-1]["target"], np.clip(marching + 0.4 * action, -2.0, 1.5), atol=1e-6)


def test_robots_of_another_shape_have_nothing_to_learn():
    for robot in (twelve_joints.ROBOT, second_robot.ROBOT):
        assert learning_document(TaskConfig().for_robot(robot)) is None


@pytest.fixture
def walking():
    """Numbers of learning, of control, and readings of a robot that walks at 0.4 m/s and turns at 0.3 rad/s."""
    step = {name: np.zeros(8) for name in ("joint_position", "joint_velocity", "action")}
    step |= {"linear_velocity_b": [0.4, 0, 0], "angular_velocity_b": [0, 0, 0.3], "projected_gravity": [0, 0, -1]}
    step |= {"foot_force": np.zeros(4), "foot_position": np.zeros(12), "fallen": False, "command": [0.4, 0.3]}
    config = TaskConfig()
    control = {"timestep": config.control_timestep, "command_rate": [9.0, 9.0]}
    return {"learning": learning_document(config), "control": control, "step": step}


def test_smoothed_velocity_and_last_action_begin_again_with_an_episode(walking):
    walking["step"]["action"] = np.full(8, 0.5)
    first, second, again = computed("reset", **walking)
    assert second["forward_progress"] > 1.5 * first["forward_progress"] > 0.0
    assert (first["action_rate"], second["action_rate"]) == (2.0, 0.0)
    for name in ("forward_progress", "turn_progress", "track_forward_velocity", "track_yaw_rate", "action_rate"):
        assert again[name] == first[name], name


@pytest.mark.parametrize(("fallen", "time", "ended"), [(False, 7.0, False), (False, 7.99, True), (True, 1.0, True)])
def test_episode_ends_by_a_fall_or_after_8_seconds(walking, fallen, time, ended):
    walking["step"]["fallen"] = fallen
    found = computed("end", **walking, time=time)
    assert (found["fell"], found["ended"]) == (fallen, ended)


def test_reward_of_a_simulation_that_diverges_is_that_of_a_fall(walking):
    walking["step"] |= {"linear_velocity_b": [None, 0, 0], "foot_position": ["x"] * 12, "fallen": True}
    found = computed("end", **walking, time=1.0)
    assert found["ended"]
    assert found["reward"] == pytest.approx(0.02 * walking["learning"]["weights"]["fall"])


def test_pushes_come_from_all_sides_at_their_rate_each_with_a_new_command(walking):
    count = 60_000
    found = computed("pushes", **walking, count=count, turns=0.8)
    pushes, requests = np.array(found["pushes"]), np.array(found["requests"])
    expected = count * 0.02 / 3.0
    assert len(pushes) == pytest.approx(expected, abs=5 * math.sqrt(expected))
    size, direction = np.hypot(*pushes[:, :2].T), np.arctan2(*pushes[:, 1::-1].T)
    assert (pushes[:, 2] == 0.0).all()
    assert size.max() < 0.3
    assert size.mean() == pytest.approx(0.15, abs=0.03)
    quadrants = np.histogram(direction, bins=8, range=(-math.pi, math.pi))[0]
    assert quadrants.min() > 0.5 * len(pushes) / 8
    # Every second command is the one to learn; the others are slower and turn to both sides.
    same = (requests == walking["step"]["command"]).all(axis=1)
    assert same.mean() == pytest.approx(0.5, abs=0.15)
    assert ((requests[~same, 0] >= 0.0) & (requests[~same, 0] < 0.4)).all()
    assert np.abs(requests[~same, 1]).max() < 0.8
    assert 0.3 < (requests[~same, 1] > 0.0).mean() < 0.7


def document_width(document):
    return sum(field["width"] for field in document["observations"])


# --- the page


@pytest.fixture
def learning_page(chromium, tmp_path):
    """A page from the disk that has begun to learn; it must make no request and no error."""
    write_page(load_policy("flat"), tmp_path / "walk.html", "flat")
    with browser.opened(chromium) as page:
        page.goto((tmp_path / "walk.html").as_uri())
        waiting.wait_until(lambda: page.evaluate("Boolean(window.quadruped)"), "the page")
        page.evaluate("document.getElementById('learn_go').click()")
        yield page
        assert page.watched.errors == []
        assert page.watched.outside() == []


def results(page, after):
    """Steps, reward per second and speed of each iteration (I, 3), once there are more than some."""
    found = "quadruped.page.learning.results"
    waiting.wait_until(lambda: page.evaluate(f"{found}.length") > after, "an iteration", interval=0.2)
    assert page.evaluate("quadruped.page.learning.error") is None
    return np.array(page.evaluate(f"{found}.map(({{ steps, reward, speed }}) => [steps, reward, speed])"))


@pytest.mark.slow
def test_robot_walks_with_what_is_learned_until_it_is_forgotten(learning_page):
    page = learning_page
    [steps, reward, speed] = results(page, after=0)[0]
    # Marching on the spot earns for the clock, upright and straight, and nothing for speed.
    assert steps == 0
    assert 9.0 < reward < 14.0
    assert abs(speed) < 0.03
    page.evaluate("quadruped.page.controls.steer(-1, 1)")
    assert page.evaluate("[quadruped.walk.learned === quadruped.page.learning.policy, quadruped.walk.request]") == [
        True,
        [0.5, 0.0],
    ], "steered beyond what it learns"
    page.evaluate("document.getElementById('learn_turn').click(), quadruped.page.controls.steer(-1, 1)")
    assert page.evaluate("quadruped.walk.request") == pytest.approx([0.0, 0.48])
    page.evaluate("document.getElementById('learn_go').click()")
    assert page.locator("#learn_go").text_content() == "Go on"
    page.evaluate("document.getElementById('learn_again').click(), quadruped.page.controls.steer(-1, 1)")
    assert page.evaluate("[quadruped.walk.learned, quadruped.walk.request]") == [None, [-0.3, 0.8]]


@pytest.mark.slow
def test_page_learns_more_than_a_zero_action_earns(learning_page):
    found = results(learning_page, after=0)
    # The noise of the first steps costs a quarter of the reward.
    while found[-1, 1] < found[0, 1] + 1.0 or found[-1, 2] < 0.1:
        assert found[-1, 0] < 200_000, found[-1]
        found = results(learning_page, after=len(found))
