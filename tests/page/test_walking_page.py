"""The page that walks, in a real browser opened from the disk: against Python, and used as a reader would."""

import hashlib
import json
from types import SimpleNamespace

import browser
import numpy as np
import pytest
import second_robot
from comparisons import random_policy
from paths import ROOT
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.control.activations import ACTIVATIONS
from quadruped_env.control.observations import observation
from quadruped_env.export import PolicyInterface, runtime
from quadruped_env.export.onnx_graph import Graph, policy_graph
from quadruped_env.page import write_page
from quadruped_env.page.document import graph_document, page_document
from quadruped_env.policies import load_policy
from quadruped_env.robot.motors import MOTOR_PRESETS
from quadruped_env.simulation import SingleSimulation, flat
from quadruped_env.task import Task

SOURCES, ASSETS = ROOT / "tools" / "page", ROOT / "quadruped_env" / "page" / "assets"
ENV = np.zeros(1, dtype=np.intp)
GRAPH = """([graph, inputs]) => {
    const made = new quadruped.Graph(graph);
    const vector = values => values.map(value => value ?? NaN);
    return inputs.map(one => Object.fromEntries(Object.entries(
        made.run(Object.fromEntries(Object.entries(one).map(([name, values]) => [name, vector(values)])))
    ).map(([name, values]) => [name, [...values]])));
}"""
STEPS = """([content, name, command, steps]) => {
    const walk = new quadruped.Walk(quadruped.walk.mujoco, content), [walker] = walk.walkers;
    walker.graph = new quadruped.Graph(content[name]);
    walker.reset(content.reference.start, command);
    return Array.from({ length: steps }, () => {
        walker.step();
        return ['joint_position', 'joint_torque'].map(name => [...walker.simulation.reading(name)]);
    });
}"""


def test_assets_are_built_from_these_sources():
    built = json.loads((ASSETS / "built.json").read_text())
    lock = json.loads((SOURCES / "package-lock.json").read_text())["packages"]
    assert built["packages"] == {name: lock[f"node_modules/{name}"]["version"] for name in built["packages"]}
    ours = {str(path.relative_to(SOURCES)) for path in (SOURCES / "src").rglob("*") if path.is_file()}
    assert ours == {name for name in built["sources"] if name.startswith("src/")}
    for folder, files in ((SOURCES, built["sources"]), (ASSETS, built["outputs"])):
        for name, sha256 in files.items():
            found = hashlib.sha256((folder / name).read_bytes()).hexdigest()
            assert found == sha256, f"{name} has changed: cd tools/page && npm ci && npm run build"
    assert "Permission is hereby granted" in (ASSETS / "page.js").read_text(), "the licence of three.js"


def test_policies_that_a_page_cannot_run_are_refused(tmp_path):
    class Stand:
        def reset(self, begun):
            pass

        def predict(self, observation):
            return np.zeros((*observation.shape[:-1], 8), np.float32)

    @observation(unit="m", mirror=(1.0,))
    def height(readings, control):
        """Height of the base."""
        return readings.base_position[:, 2:]

    policy = random_policy("position")
    code = SimpleNamespace(**{**vars(policy), "agent": Stand()})
    with pytest.raises(QuadrupedError, match="is a policy of Python code"):
        write_page(type(policy)(**vars(code)), tmp_path / "walk.html")
    own = type(policy)(**{**vars(policy), "fields": (*policy.fields, height)})
    with pytest.raises(QuadrupedError, match="observes height of the task's own file"):
        write_page(own, tmp_path / "walk.html")
    assert not list(tmp_path.iterdir())


@pytest.fixture(scope="module")
def opened(chromium, tmp_path_factory):
    """The page of the shipped policy as the command writes it, paused; simulated time passes in `step` alone."""
    path = tmp_path_factory.mktemp("page") / "walk.html"
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(path.parent)
        assert main(["page", "flat"]) == 0
        assert main(["page", "flat"]) != 0, "the file exists"
    with browser.opened(chromium) as page:
        page.set_viewport_size({"width": 1020, "height": 400})
        page.goto(path.as_uri())
        wait_until(lambda: page.evaluate("Boolean(window.quadruped)"), "the page to load")
        page.evaluate("quadruped.page.setPaused(true)")
        yield page
        assert page.watched.errors == []
        assert page.watched.requests == [path.as_uri()]


@pytest.fixture
def page(opened):
    """That page at its start, standing, with its standard settings."""
    opened.evaluate("""() => {
        const { page } = quadruped;
        page.setLanguage('en'); page.controls.standard(); page.setCompare(false); page.reset(); page.controls.stop();
    }""")
    return opened


def python_walk(policy, command, steps, act):
    """Joint positions and torques (steps, 2, J) of a walk in Python from the page's start, with actions of `act`."""
    config, robot = policy.config.without_randomization().on_terrain(flat), policy.robot
    task = Task(SingleSimulation(config.compiled_model(), robot), config)
    task.reset(ENV, seeds=[0], command=command)
    start = np.array([[0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0, *robot.stance]])
    task.place(ENV, start, np.zeros((1, robot.num_velocities)))
    task.control.reset(ENV, 0.0, np.array([command]))
    seen, observed = [], task.observe()
    for _ in range(steps):
        observed = task.step(act(observed)).observation
        readings = task.simulation.readings
        seen.append([readings.joint_position[0].copy(), readings.joint_torque[0].copy()])
    return np.array(seen)


@pytest.mark.parametrize("activation", sorted(ACTIVATIONS))
def test_graph_in_javascript_equals_onnx_runtime(opened, activation):
    pytest.importorskip("onnxruntime", reason="ONNX Runtime is not installed: pip install -e '.[export]'")
    clock = {"clock_frequency": {"speeds": [0.0, 0.6], "frequencies": [2.6, 3.2]}} if activation == "elu" else {}
    policy = random_policy("position" if activation == "relu" else "residual", **clock)
    policy = type(policy)(**{**vars(policy), "activation": activation, "output": "tanh" if clock else "clip"})
    interface = PolicyInterface(policy)
    inputs = runtime.random_inputs(interface, 100)
    expected = runtime.run(runtime.session_of(policy_graph(interface, "test")), inputs)
    rows = [
        {name: [None if np.isnan(v) else float(v) for v in values[i]] for name, values in inputs.items()}
        for i in range(100)
    ]
    found = opened.evaluate(GRAPH, [graph_document(Graph.of(interface), interface), rows])
    assert set(found[0]) == set(expected)
    for name, values in expected.items():
        assert runtime.difference(name, np.array([row[name] for row in found]), values).max() < 1e-5, name


@pytest.mark.parametrize("case", ["residual", "gait", "other robot", "hobby servos"])
def test_joints_move_and_pull_as_in_python(opened, case):
    if case == "other robot":
        policy = load_policy("flat")  # replaced below
        config = policy.config.for_robot(second_robot.ROBOT)
        policy = type(policy).for_task(policy.weights, policy.biases, policy.activation, config, {})
    elif case == "hobby servos":
        policy = random_policy("position", motor=MOTOR_PRESETS["mg996r"])
    else:
        policy = load_policy("flat")
    zero = np.zeros((1, policy.robot.num_joints))
    act = (lambda _: zero) if case == "gait" else policy.predict
    high = policy.control.commands[0].range[1]
    command, steps = [0.7 * high, 0.2], 40
    content = json.loads(json.dumps(page_document(policy, case)))
    found = np.array(opened.evaluate(STEPS, [content, "gait" if case == "gait" else "policy", command, steps]))
    expected = python_walk(policy, command, steps, act)
    print(case, np.abs(found - expected).max(axis=(0, 2)))


def test_distance_in_ten_seconds_is_that_of_python(page):
    checked = page.evaluate("quadruped.page.compare(1000), quadruped.page.checked")
    assert checked["seconds"] == pytest.approx(10.0)
    assert checked["there"] > 1.0
    assert checked["here"] == pytest.approx(checked["there"], rel=0.03)
    shown = page.locator("#check").inner_text()
    assert f"{checked['here']:.2f} m here, {checked['there']:.2f} m in Python" in shown
    assert page.locator("#engine").inner_text().startswith("MuJoCo 3.")
