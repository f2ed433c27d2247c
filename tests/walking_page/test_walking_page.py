"""The page that walks, in a real browser opened from the disk: against Python, and used as a reader would."""

import dataclasses
import hashlib
import json
import re
from types import SimpleNamespace

import browser
import numpy as np
import pytest
import second_robot
import twelve_joints
from comparisons import random_policy
from paths import ROOT
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.control.observations import observation
from quadruped_env.export import PolicyInterface, runtime
from quadruped_env.export.onnx_graph import Graph, policy_graph
from quadruped_env.policies import load_policy
from quadruped_env.policies.activations import ACTIVATIONS
from quadruped_env.policies.files import SHOWN
from quadruped_env.robot.motors import MOTOR_PRESETS
from quadruped_env.simulation import SingleSimulation, flat
from quadruped_env.task import BUILT_IN, Task
from quadruped_env.walking_page import write_page
from quadruped_env.walking_page.document import graph_document, page_document

SOURCES, ASSETS = ROOT / "tools" / "page", ROOT / "quadruped_env" / "walking_page" / "assets"
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
    const start = [...content.reference.start];
    start[2] += 1;
    walker.reset(start, command);
    return Array.from({ length: steps }, () => {
        walker.step();
        return ['joint_position', 'joint_torque'].map(name => [...walker.simulation.reading(name)]);
    });
}"""

GAMEPAD = """axes => {
    const { page } = quadruped, plug = (pads) => Object.defineProperty(
        navigator, 'getGamepads', { configurable: true, value: () => pads });
    page.controls.stop();
    plug([{ connected: true, axes, buttons: [] }]);
    page.controls.pollGamepad();
    plug([]);
    const found = [page.throttle, page.turn, page.left];
    page.controls.stop();
    return found;
}"""

CROSSINGS = """([content, speed, steps]) => {
    const walk = new quadruped.Walk(quadruped.walk.mujoco, content);
    return walk.terrains.map(({ name }) => {
        walk.settings.terrain = name;
        walk.rebuild();
        walk.request = [speed, 0];
        let stuck = false;
        for (let i = 0; i < steps; i++) { walk.step(); stuck ||= walk.walkers[0].stuck; }
        const [{ simulation, falls, travelled }] = walk.walkers;
        return { name, moved: Math.hypot(...simulation.position().slice(0, 2)), travelled, falls, stuck };
    });
}"""


def robot_with_mesh():
    """The second robot, whose base has the mass of a mesh, a tetrahedron of 1.5 kg, as OBJ."""
    points = ("0 0 0", "0.2 0 0", "0 0.15 0", "0 0 0.1")
    faces = ("1 3 2", "1 2 4", "1 4 3", "2 3 4")
    lines = [*(f"v {point}" for point in points), *(f"f {face}" for face in faces)]
    text = second_robot.ROBOT.mjcf.replace("<asset>", '<asset><mesh file="load.obj"/>')
    geom = '<geom type="mesh" mesh="load" pos="0.1 0.02 0.05" mass="1.5" group="1"/>'
    text, found = re.subn(r"<inertial .* mass=\"3\" .*/>", geom, text)
    assert found == 1
    return dataclasses.replace(second_robot.ROBOT, mjcf=text, assets={"load.obj": "\n".join(lines).encode()})


def test_files_of_a_model_that_are_too_large_are_refused():
    robot = dataclasses.replace(second_robot.ROBOT, assets={"trunk.stl": bytes(9_000_000), "foot.stl": b"1"})
    policy = random_policy("residual", definition=BUILT_IN.with_robot(robot))
    with pytest.raises(
        QuadrupedError, match=r"holds up to 8 MB .*'tall' has 9.0 MB, of which 'trunk.stl' has 9.0 MB; give"
    ):
        page_document(policy, "mine")


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
    first, *others = policy.weights
    wider = np.pad(first, ((0, policy.control.observation_history), (0, 0)))
    own = type(policy)(**{**vars(policy), "fields": (*policy.fields, height), "weights": (wider, *others)})
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
    """Joint positions and torques (steps, 2, J) of steps in the air in Python, with actions of `act`."""
    config, robot = policy.config.without_randomization().on_terrain(flat), policy.robot
    task = Task(SingleSimulation(config.compiled_model(), robot), config)
    task.reset(ENV, seeds=[0], command=command)
    start = np.array([[0.0, 0.0, robot.stance_height + 1.0, 1.0, 0.0, 0.0, 0.0, *robot.stance]])
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
    clock = {"clock_frequency": 2.6} if activation == "elu" else {}
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


@pytest.mark.parametrize(
    "case", ["residual", "gait", "other robot", "mesh", "twelve joints", "twelve, gait", "hobby servos"]
)
def test_joints_move_and_pull_as_in_python(opened, case):
    # In the air and with small steps: MuJoCo 3.14 and 4.0 differ in contacts, and in motors at their limits.
    policy = random_policy("residual")
    if case in ("other robot", "mesh"):
        config = policy.config.for_robot(second_robot.ROBOT if case == "other robot" else robot_with_mesh())
        policy = type(policy).for_task(policy.weights, policy.biases, policy.activation, config, {})
    elif case == "hobby servos":
        policy = random_policy("position", motor=MOTOR_PRESETS["mg996r"])
    elif "twelve" in case:
        policy = random_policy("residual", twelve_joints.ROBOT)
    zero = np.zeros((1, policy.robot.num_joints))
    command, steps = [0.03, 0.02, -0.03][: policy.control.num_velocities], 20
    content = json.loads(json.dumps(page_document(policy, case)))
    name = "gait" if case.endswith("gait") else "policy"
    found = np.array(opened.evaluate(STEPS, [content, name, command, steps]))
    expected = python_walk(policy, command, steps, (lambda _: zero) if name == "gait" else policy.predict)
    assert np.ptp(expected[:, 0], axis=0).max() > 0.02, "the joints move"
    np.testing.assert_allclose(found[:, 0], expected[:, 0], atol=1e-5)
    np.testing.assert_allclose(found[:, 1], expected[:, 1], atol=1e-3)


def test_distance_in_ten_seconds_is_that_of_python(page):
    checked = page.evaluate("quadruped.page.compare(1000), quadruped.page.checked")
    assert checked["seconds"] == pytest.approx(10.0)
    assert checked["there"] > 1.0
    assert checked["here"] == pytest.approx(checked["there"], rel=0.03)
    shown = page.locator("#check").inner_text()
    assert f"{checked['here']:.2f} m here, {checked['there']:.2f} m in Python" in shown
    assert page.locator("#engine").inner_text().startswith("MuJoCo 3.")


def state(page, expression):
    return page.evaluate(
        f"(() => {{ const {{ walk, page }} = quadruped, [walker] = walk.walkers; return {expression}; }})()"
    )


def test_keys_steer(page):
    page.locator("#view").focus()
    high, turn = state(page, "walk.content.control.forward[1]"), state(page, "walk.content.control.turn[1]")
    for _ in range(3):
        page.keyboard.press("ArrowUp")
    assert state(page, "walk.request") == pytest.approx([0.6 * high, 0.0])
    page.keyboard.down("ArrowLeft")
    page.evaluate("quadruped.page.step(150)")
    yaw = state(page, "walker.simulation.yaw()")
    assert 0.5 * turn * 3.0 < yaw < 1.5 * turn * 3.0
    page.keyboard.up("ArrowLeft")
    assert state(page, "walk.request") == pytest.approx([0.6 * high, 0.0])
    page.keyboard.press("0")
    assert state(page, "walk.request") == [0, 0]
    page.keyboard.press("ArrowDown")
    low = state(page, "walk.content.control.forward[0]")
    assert state(page, "walk.request[0]") == pytest.approx(max(-0.2 * high, low))


@pytest.fixture(scope="module")
def sideways(chromium, tmp_path_factory):
    """The page of a robot whose legs can roll, paused, with a policy of no actions; it has nothing to learn from."""
    path, policy = tmp_path_factory.mktemp("sideways") / "walk.html", random_policy("residual", twelve_joints.ROBOT)
    policy = dataclasses.replace(policy, weights=tuple(0.0 * weight for weight in policy.weights))
    write_page(policy, path)
    with browser.opened(chromium) as page:
        page.set_viewport_size({"width": 1280, "height": 720})
        page.goto(path.as_uri())
        wait_until(lambda: page.watched.errors or page.evaluate("Boolean(window.quadruped)"), "the page to load")
        page.evaluate("quadruped.page.setPaused(true)")
        yield page
        assert page.watched.errors == []
        assert page.watched.requests == [path.as_uri()]


def test_keys_walk_sideways_and_turn_a_robot_whose_legs_can_roll(sideways):
    page, walked = sideways, {}
    low, high = state(page, "walk.content.control.lateral")
    assert high == pytest.approx(-low)
    assert high > 0.1
    page.locator("#view").focus()
    for key, request in (("q", [0, 0, high]), ("E", [0, 0, low]), ("ArrowLeft", [0, page_turn(page), 0])):
        page.evaluate("quadruped.page.controls.stop(), quadruped.page.reset()")
        page.keyboard.down(key)
        assert state(page, "walk.request") == pytest.approx(request)
        page.evaluate("quadruped.page.step(150)")
        walked[key] = state(
            page, "[...walker.simulation.position(), walker.simulation.yaw(), walker.left, walker.travelled]"
        )
        page.keyboard.up(key)
        assert state(page, "walk.request") == pytest.approx([0, 0, 0])
    assert walked["q"][1] == pytest.approx(3.0 * high, rel=0.3)
    assert walked["E"][1] == pytest.approx(-3.0 * high, rel=0.3)
    assert walked["q"][4:] == pytest.approx([high, walked["q"][1]], rel=0.3)
    assert walked["ArrowLeft"][3] == pytest.approx(3.0 * page_turn(page), rel=0.3)
    page.evaluate("quadruped.page.controls.show()")
    assert page.locator("#wanted_left").is_visible()


def test_robot_of_another_shape_has_its_whole_speed_limit_and_nothing_to_learn(sideways):
    page = sideways
    assert not page.locator("#learn").is_visible()
    assert float(page.locator("#limit").input_value()) == pytest.approx(state(page, "walk.content.control.forward[1]"))


def page_turn(page):
    return state(page, "walk.content.control.turn[1]")


def test_stick_walks_sideways_and_the_slider_above_it_turns_until_they_are_released(sideways):
    page = sideways
    page.evaluate("quadruped.page.controls.stop()")
    box = page.locator("#stick").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 0.18 * box["width"], y - 0.36 * box["height"])
    assert state(page, "[page.throttle, page.turn, page.left]") == pytest.approx([1.0, 0.0, -0.5], abs=0.02)
    page.mouse.up()
    assert state(page, "[page.throttle, page.turn, page.left]") == pytest.approx([1.0, 0.0, 0.0])
    slider = page.locator("#turn")
    box = slider.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 2, box["y"] + box["height"] / 2)
    assert state(page, "page.turn") > 0.9
    page.mouse.up()
    assert state(page, "[page.throttle, page.turn]") == pytest.approx([1.0, 0.0])
    assert slider.input_value() == "0"
    assert page.evaluate("document.activeElement.id") != "turn"


def test_gamepad_walks_sideways_by_its_left_stick_and_turns_by_its_right_one(sideways, opened):
    axes = [-0.5, -1, 0.25, 0]
    assert sideways.evaluate(GAMEPAD, axes) == [1, -0.25, 0.5]
    assert opened.evaluate(GAMEPAD, axes) == [1, 0.5, 0], "legs that cannot roll: its left stick turns"


def test_robot_without_roll_joints_shows_nothing_of_it(page):
    assert state(page, "walk.request.length") == 2
    page.locator("#view").focus()
    page.keyboard.press("q")
    assert state(page, "walk.request") == [0, 0]
    assert not any(element.is_visible() for element in page.locator(".sideways").all())


def test_stick_turns_while_it_is_held_and_keeps_the_speed(page):
    box = page.locator("#stick").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 0.36 * box["width"], y - 0.36 * box["height"])
    assert state(page, "[page.throttle, page.turn]") == pytest.approx([1.0, 1.0])
    page.mouse.up()
    assert state(page, "[page.throttle, page.turn]") == pytest.approx([1.0, 0.0])


def test_a_click_on_the_robot_pushes_it_away_and_a_click_beside_does_not(page):
    page.evaluate("quadruped.page.step(25)")
    browser.draw(page)
    box = page.locator("#view").bounding_box()
    x, y = state(page, "page.view.target.clone().project(page.view.camera).toArray()")[:2]
    middle = (0.5 + 0.5 * x) * box["width"], (0.5 - 0.5 * y) * box["height"]
    assert state(page, "page.view.pick(5, 250)") is None
    before = np.array(state(page, "[...walker.simulation.data.qvel.slice(0, 3)]"))
    page.mouse.click(5, 250)
    assert state(page, "[...walker.simulation.data.qvel.slice(0, 3)]") == before.tolist()
    page.mouse.click(*middle)
    change = state(page, "[...walker.simulation.data.qvel.slice(0, 3)]") - before
    assert np.linalg.norm(change) == pytest.approx(state(page, "page.strength"))
    camera = np.array(state(page, "page.view.camera.position.toArray()"))
    base = np.array(state(page, "[...walker.simulation.position()]"))
    away = (base - camera)[:2] / np.linalg.norm((base - camera)[:2])
    assert change[2] == 0.0
    assert change[:2] @ away > 0.9 * np.linalg.norm(change)
    # It moves, and recovers.
    page.evaluate("quadruped.page.step(10)")
    moved = state(page, "[...walker.simulation.position()]") - base
    assert moved[:2] @ away > 0.01


def slide(page, name, value):
    page.locator(f"#{name}").evaluate(
        "(input, value) => { input.value = value; input.dispatchEvent(new Event('input')); }", value
    )


def test_sliders_change_physics(page):
    model, base = "walker.simulation.model", "walker.simulation.base"
    mass = state(page, f"{model}.body_subtreemass[1]")
    slide(page, "payload", 1.0)
    slide(page, "friction", 0.3)
    slide(page, "slope", 6)
    assert state(page, f"{model}.body_subtreemass[{base}]") == pytest.approx(mass + 1.0, abs=0.02)
    assert set(state(page, f"[...{model}.geom_friction].filter((_, i) => i % 3 === 0)")) == {0.3}
    gravity = state(page, "walker.simulation.projectedGravity()")
    assert gravity == pytest.approx([-np.sin(np.radians(6)), 0.0, -np.cos(np.radians(6))], abs=1e-6)
    assert page.locator("#payload").locator("xpath=..").locator("output").inner_text() == "1.0 kg"
    slide(page, "amplitude", 0)
    page.evaluate("quadruped.page.step(1)")
    assert not np.any(state(page, "[...walker.graph.values.gait_swing]"))
    phase = state(page, "walker.memory.gait_phase[0]")
    slide(page, "frequency", 0.5)
    page.evaluate("quadruped.page.step(1)")
    assert state(page, "walker.memory.gait_phase[0]") - phase == pytest.approx(0.5 * phase, rel=1e-3)
    page.locator("#standard").click()
    assert state(page, f"{model}.body_subtreemass[1]") == pytest.approx(mass)
    assert state(page, "walker.simulation.projectedGravity()") == pytest.approx([0, 0, -1], abs=1e-6)


@pytest.mark.slow
def test_terrains_carry_the_robot_and_the_gait_walks_beside_it(page):
    names = [option.get_attribute("value") for option in page.locator("#terrain option").all()]
    assert {"flat", "rough", "stairs", "wave"} <= set(names)
    page.locator("#compare").check()
    page.locator("#terrain").select_option("wave")
    page.evaluate("quadruped.page.controls.steer(0.8, 0), quadruped.page.step(100)")
    heights = state(
        page,
        """walk.walkers.map(({ simulation }) => {
            const [x, y, z] = simulation.position();
            return z - walk.terrain.highest(x, y, 0.1);
        })""",
    )
    expected = load_policy("flat").robot.stance_height
    assert heights == pytest.approx([expected] * 2, abs=0.05)
    assert page.locator("#other").is_visible()
    page.locator("#compare").uncheck()
    assert state(page, "walk.walkers.length") == 1


def test_shown_policy_crosses_every_terrain_and_flat_marches_on_the_spot_on_stairs(page):
    found = {
        name: {
            one.pop("name"): one
            for one in page.evaluate(
                CROSSINGS, [json.loads(json.dumps(page_document(load_policy(name), name))), 0.4, 400]
            )
        }
        for name in (SHOWN, "flat")
    }
    assert {"flat", "rough", "steps", "stairs", "gaps", "wave"} < set(found[SHOWN])
    for name, crossing in found[SHOWN].items():
        assert crossing["moved"] > 0.6 * 0.4 * 8.0, name
        assert (crossing["falls"], crossing["stuck"]) == (0, False), name
    on_stairs = found["flat"]["stairs"]
    assert on_stairs["stuck"]
    assert on_stairs["travelled"] < on_stairs["moved"] + 0.5, "marching on the spot is no distance"
    assert not found["flat"]["flat"]["stuck"]
    assert found["flat"]["flat"]["travelled"] == pytest.approx(found["flat"]["flat"]["moved"], abs=0.2)


def test_a_robot_that_marches_on_the_spot_is_told_so(page):
    page.evaluate("quadruped.page.setTerrain('stairs'), quadruped.page.controls.steer(0.8, 0)")
    for language, words in (("en", "It does not get on"), ("zh", "它走不动了")):
        page.evaluate("language => { quadruped.page.setLanguage(language); quadruped.page.step(350); }", language)
        browser.draw(page)
        assert page.locator("#message").inner_text().startswith(words)
    page.evaluate("quadruped.page.controls.stop(), quadruped.page.step(200)")
    browser.draw(page)
    assert not page.locator("#message").is_visible(), "it stands, as requested"


@pytest.mark.parametrize("size", [(1280, 800), (400, 800)])
@pytest.mark.parametrize("terrain", ["flat", "stairs"])
def test_both_robots_stay_in_sight(page, size, terrain):
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    browser.draw(page)
    seen = page.evaluate(
        """terrain => {
            const { page, walk } = quadruped, { view } = page, { renderer } = view;
            page.setTerrain(terrain);
            page.setCompare(true);
            page.controls.steer(0.8, 0.1);
            view.renderer = { render() {}, getPixelRatio: () => 1, setPixelRatio() {} };  // one picture takes long
            const { width, height } = view.canvas.getBoundingClientRect(), { top, right, bottom } = view.covered();
            const places = [];
            for (let i = 0; i < 1000; i++) {
                page.step(1);
                view.draw(1, 0.02);
                if (i % 10 === 0) places.push(...view.robots.map((robot) => {
                    const { x, y } = view.target.clone().set(...robot.position(1)).project(view.camera);
                    const across = (0.5 + 0.5 * x) * width, down = (0.5 - 0.5 * y) * height;
                    return [across / (width - right), (down - top) / (height - top - bottom)];
                }));
            }
            view.renderer = renderer;
            return { places, returned: walk.walkers.map(({ returned }) => returned) };
        }""",
        terrain,
    )
    page.set_viewport_size({"width": 1020, "height": 400})
    places = np.array(seen["places"])
    assert places.min() > 0.0
    assert places.max() < 1.0
    assert seen["returned"][0] == 0
    if terrain == "flat":
        assert seen["returned"][1] > 0, "alone, the gait would have been out of sight"


def test_stairs_are_drawn_with_edges(page):
    # From above, along x: treads and risers have one colour each.
    found = page.evaluate(
        """() => {
            const { page } = quadruped, { view } = page, { renderer } = view, camera = view.camera.clone();
            page.setTerrain('stairs');
            for (const { group } of view.robots) group.visible = false;
            camera.clearViewOffset();
            camera.up.set(0, 1, 0);
            camera.position.set(1.2, 0.1, 2);
            camera.lookAt(1.2, 0.1, 0);
            camera.updateMatrixWorld();
            renderer.setPixelRatio(1);
            renderer.render(view.scene, camera);
            const { width, height } = view.canvas, copy = new OffscreenCanvas(width, height).getContext('2d');
            copy.drawImage(view.canvas, 0, 0);
            for (const { group } of view.robots) group.visible = true;
            return [...copy.getImageData(width / 4, height / 2, width / 2, 1).data];
        }"""
    )
    colours = np.array(found).reshape(-1, 4)[:, 1].astype(int)
    assert np.ptp(colours) > 30, "stairs are visible"
    assert np.mean(np.abs(np.diff(colours)) > 3) < 0.2


def test_without_webgl_or_javascript_the_page_says_in_both_languages_what_to_switch_on(opened, chromium):
    address = opened.url
    with browser.opened(chromium) as page:
        page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null;")
        page.goto(address)
        wait_until(lambda: page.locator("#message p").count() == 2, "the message")
        english, chinese = page.locator("#message p").all_inner_texts()
        assert "WebGL 2 is switched off" in english
        assert "WebGL 2 没有开启" in chinese
        assert not page.locator("#panel").is_visible()
        assert page.watched.errors == []
    context = chromium.new_context(java_script_enabled=False)
    page = context.new_page()
    page.goto(address)
    assert page.locator("noscript p").count() == 2
    context.close()


def test_a_fallen_robot_stands_up_where_it_lies(page):
    page.evaluate("""() => {
        const [walker] = quadruped.walk.walkers, start = [...quadruped.walk.content.robot.start];
        [start[0], start[1], start[3], start[4]] = [1, 2, 0, 1];
        walker.simulation.reset(start);
        quadruped.page.step(20);
    }""")
    assert state(page, "walker.simulation.fallen()")
    browser.draw(page)
    assert page.locator("#message").inner_text() == "It fell. It stands up again in a moment."
    page.evaluate("quadruped.page.step(75)")
    assert not state(page, "walker.simulation.fallen()")
    assert state(page, "[...walker.simulation.position()].slice(0, 2)") == pytest.approx([1, 2], abs=0.4)


def test_language_and_phone(page):
    assert page.locator("#push").inner_text() == "Random push"
    page.locator("#language").click()
    assert page.locator("#push").inner_text() == "随机推一下"
    assert page.evaluate("document.documentElement.lang") == "zh-CN"
    left = page.evaluate(
        "[...document.querySelectorAll('[data-text], option')].map(e => e.textContent).filter(t => /^[a-z_]+$/.test(t))"
    )
    assert left == [], "words without a translation"
    page.set_viewport_size({"width": 400, "height": 720})
    for action in ("", "quadruped.page.controls.toggle(true)"):
        page.evaluate(action or "0")
        assert page.evaluate("document.documentElement.scrollWidth") <= 400
        assert page.evaluate("document.body.scrollWidth") <= 400
    for name in ("speed", "stick", "pause"):
        assert page.locator(f"#{name}").count() == 1
    page.evaluate("quadruped.page.controls.toggle(false)")
    stick, actions = (page.locator(name).bounding_box() for name in ("#stick", "#actions"))
    assert stick["x"] + stick["width"] < actions["x"]
    page.set_viewport_size({"width": 1020, "height": 400})
