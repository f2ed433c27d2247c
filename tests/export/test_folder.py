"""The folder of an exported policy: complete, consistent, and enough to walk without this package."""

import dataclasses
import hashlib
import json
import re
import subprocess
import sys

import gymnasium
import numpy as np
import pytest
import second_robot
from comparisons import TINY, random_policy
from paths import ROOT

from quadruped_env import MissingExtraError, QuadrupedError, QuadrupedWarning
from quadruped_env.cli.main import main
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.live_controller import Safety
from quadruped_env.envs import ENV_ID
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy, find_policy
from quadruped_env.evaluation.learning_gain import gain_rows, learning_gain, reward_in_words
from quadruped_env.export import folder as folder_module
from quadruped_env.export import runtime
from quadruped_env.export.c_source import HEADER_FILE, SKETCH_FILE, SOURCE_FILE
from quadruped_env.export.folder import export_policy, results_of
from quadruped_env.export.manifest import metadata
from quadruped_env.export.onnx_interface import PolicyInterface
from quadruped_env.policies import Policy, find_controllers, load_policy
from quadruped_env.report.pages.report import write_numbers
from quadruped_env.task import ActionConfig, TaskConfig

pytest.importorskip("onnx", reason="ONNX is not installed: pip install -e '.[export]'")

FILES = {"README.md", "controllers.yaml", "golden_trace.csv", "manifest.json", "policy.json", "policy.onnx"}
FILES |= {"policy.safetensors", "robot.urdf", "robot.xml"}
FOR_HUB = {"walk.html"}

WALK = """
import json, re, sys
import mujoco
import numpy as np

page = open("README.md").read()
exec(re.search("```python\\n(.*?)```", page, re.DOTALL)[1])
manifest = json.load(open("manifest.json"))

spec = mujoco.MjSpec.from_file("robot.xml")
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[20, 20, 1], friction=[0.8, 0.005, 0.0001])
model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_resetDataKeyframe(model, data, model.key("home").id)
assert [model.joint(i + 1).name for i in range(model.nu)] == [joint["name"] for joint in manifest["joints"]]
np.testing.assert_allclose(data.qpos[7:], manifest["entry"]["joint_positions_rad"])
substeps = round(manifest["control"]["timestep_s"] / model.opt.timestep)
mujoco.mj_forward(model, data)
path = []
for step in range(400):
    command = [0.0, 0.0] if step < 50 else [float(sys.argv[1]), float(sys.argv[2])]
    rotation = data.body("base_link").xmat.reshape(3, 3)
    target = joint_targets(
        projected_gravity=-rotation[2],
        angular_velocity=data.qvel[3:6],
        joint_position=data.qpos[7:],
        joint_velocity=data.qvel[6:],
        command=command,
    )
    data.ctrl[:] = target
    mujoco.mj_step(model, data, substeps)
    assert rotation[2, 2] > 0.8
    path.append([*data.qpos[:2], np.arctan2(rotation[1, 0], rotation[0, 0])])
assert "quadruped_env" not in sys.modules
path = np.array(path)
path[:, 2] = np.unwrap(path[:, 2])
print(json.dumps({"standing": path[49].tolist(), "begin": path[99].tolist(), "end": path[-1].tolist()}))
"""


def save_run(directory, policy):
    policy.save(directory)
    return find_policy(str(directory))


@pytest.fixture(scope="module")
def flat(tmp_path_factory):
    """The shipped policy, exported."""
    folder = tmp_path_factory.mktemp("exports") / "flat"
    return export_policy(find_policy("flat", tmp_path_factory.mktemp("none")), folder)


@pytest.fixture
def run(tmp_path):
    """A run with random weights."""
    return save_run(tmp_path / "20260101-000000-ppo", random_policy("residual"))


@pytest.fixture(scope="module")
def compared():
    """A short comparison of the run's policy."""
    return compare(random_policy("residual"), num_seeds=1, seconds=2.0, commands=TINY)


def walk(folder, *command):
    done = subprocess.run(
        [sys.executable, "-c", WALK, *map(str, command)], cwd=folder, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return {name: np.array(value) for name, value in json.loads(done.stdout).items()}


def test_folder_walks_with_its_own_page_and_models_and_without_this_package(flat):
    places = walk(flat.folder, 0.4, 0.0)
    assert np.abs(places["standing"][:2]).max() < 0.03, "idle at first"
    # 6 s at 0.4 m/s, which the policy exceeds by up to a tenth.
    assert places["end"][0] - places["begin"][0] == pytest.approx(2.4, rel=0.15)
    assert abs(places["end"][1]) < 0.3
    assert abs(places["end"][2]) < 0.1
    turned = walk(flat.folder, 0.0, 0.5)
    assert turned["end"][2] - turned["begin"][2] == pytest.approx(6.0 * 0.5, rel=0.4)
    assert np.hypot(*(turned["end"] - turned["begin"])[:2]) < 0.3


@pytest.mark.parametrize("mode", ["residual", "position"])
def test_exported_file_walks_in_the_env(flat, mode, tmp_path):
    if mode == "position":
        # Not trained: it has to do what the policy does, not to walk.
        flat = export_policy(save_run(tmp_path / "run", random_policy("position")), tmp_path / "export")
    manifest = json.loads((flat.folder / "manifest.json").read_text())
    policy = load_policy(flat.folder)
    session = runtime.session_of((flat.folder / "policy.onnx").read_bytes())
    env, other = (gymnasium.make(ENV_ID, config=policy.config.randomized("none")) for _ in range(2))
    observation, _ = env.reset(seed=1, options={"command": (0.4, 0.0)})
    expected, _ = other.reset(seed=1, options={"command": (0.4, 0.0)})
    fields = {field["name"]: field for field in manifest["observation"]["fields"]}
    clock = slice(*fields.pop("gait_clock")["columns"])
    phase = np.arctan2(*observation[clock])[None, None].astype(np.float32)
    past = np.full((1, 2 * 34), np.nan, np.float32)
    speeds = []
    for step in range(250):
        inputs = {
            name: (observation[slice(*field["columns"])] / field["scale"] + field["offset"])[None].astype(np.float32)
            for name, field in fields.items()
        }
        found = runtime.run(session, {**inputs, "gait_phase": phase, "observation_history": past})
        phase, past = found["next_gait_phase"], found["next_observation_history"]
        observation, _, terminated, _, info = env.step(found["action"][0])
        if step < 50:
            # Later, rounding errors have grown with every contact.
            expected, *_ = other.step(policy.predict(expected))
            np.testing.assert_allclose(observation, expected, rtol=0, atol=1e-3)
        if terminated:
            break
        speeds.append(info["base_linear_velocity"][0])
    if mode == "residual":
        assert not terminated
        assert np.mean(speeds[50:]) == pytest.approx(0.4, abs=0.05)


def test_manifest_lists_every_file_with_its_checksum(flat):
    document = json.loads((flat.folder / "manifest.json").read_text())
    names = {path.name for path in flat.folder.iterdir()}
    assert names == FILES | {"progress.csv"} == set(flat.files)
    assert set(document["files"]) == names - {"manifest.json"}
    for name, entry in document["files"].items():
        content = (flat.folder / name).read_bytes()
        assert entry == {"sha256": hashlib.sha256(content).hexdigest(), "bytes": len(content)}
    shipped = json.loads((find_policy("flat").directory / "policy.json").read_text())
    assert document["weights_sha256"] == shipped["weights_sha256"]
    assert document == flat.manifest
    loaded, policy = load_policy(flat.folder), load_policy("flat")
    assert loaded.config == policy.config
    for one, other in zip(loaded.weights, policy.weights, strict=True):
        np.testing.assert_array_equal(one, other)


def test_manifest_states_the_robot_its_joints_and_the_control(flat):
    document, policy = flat.manifest, load_policy("flat")
    robot = policy.robot
    assert document["robot"] == {**robot.identity, "joints": list(robot.joint_names)}
    for i, joint in enumerate(document["joints"]):
        assert joint["name"] == robot.joint_names[i]
        assert (joint["lower_rad"], joint["upper_rad"]) == ((-1.5, 1.5), (-2.0, 0.0))[i % 2]
        assert joint["stance_rad"] == (0.6, -0.72)[i % 2]
        assert (joint["kp_n_m_rad"], joint["kd_n_m_s_rad"]) == (40.0, 1.0)
        assert (joint["velocity_limit_rad_s"], joint["effort_limit_n_m"]) == (5.0, 10.0)
        assert joint["rotor_inertia_at_joint_kg_m2"] == 0.01
    assert document["control"]["rate_hz"] == pytest.approx(50.0)
    assert document["control"]["action_mode"] == "residual"
    assert document["control"]["action_scale_rad"] == 0.4
    assert [component["idle"] for component in document["command"]["components"]] == [0.0, 0.0]
    assert [(c["low"], c["high"]) for c in document["command"]["components"]] == [(-0.3, 0.6), (-0.8, 0.8)]
    assert document["entry"]["joint_positions_rad"] == robot.stance.tolist()
    safety, stop = Safety.of(robot), document["entry"]["stop"]
    limits = (safety.max_tilt, safety.command_timeout, safety.hold_after, safety.limp_after)
    assert (
        tuple(stop[name] for name in ("tilt_rad", "no_command_s", "no_reading_hold_s", "no_reading_limp_s")) == limits
    )
    assert document["training"]["seed"] == policy.card["seed"]
    assert document["training"]["recipe"] == policy.card["recipe"]
    assert document["training"]["command"] == policy.card["command"]
    assert not {"metrics", "verdict", "acceptance"} & set(document["training"])
    assert document["evaluation"]["verdict"] == policy.card["verdict"]
    assert 0.0 < document["graph"]["largest_difference_from_the_policy"] < 1e-5


def test_example_limits_the_command_as_the_manifest_says_and_as_the_control_interface_does(tmp_path, monkeypatch):
    rates = {"forward_acceleration": 1.5, "yaw_acceleration": 3.0}
    policy = random_policy("residual", command=TaskConfig().command.replace(**rates))
    export = export_policy(save_run(tmp_path / "run", policy), tmp_path / "export")
    components = export.manifest["command"]["components"]
    assert [(c["largest_rate"], c["rate_unit"]) for c in components] == [(1.5, "m/s^2"), (3.0, "rad/s^2")]
    timestep = export.manifest["control"]["timestep_s"]
    monkeypatch.chdir(export.folder)
    code = re.search("```python\n(.*?)```", (export.folder / "README.md").read_text(), re.DOTALL)[1]
    names = {}
    exec(code, names)  # noqa: S102
    control = ControlInterface(policy.robot, policy.control)
    readings = {entry["name"]: np.zeros(entry["shape"][1]) for entry in export.manifest["graph"]["inputs"]}
    readings = {name: value for name, value in readings.items() if name not in names["memory"]}
    limited = np.zeros(2)
    for step in range(80):
        requested = np.array([0.4, -0.5] if step < 40 else [-0.1, 0.0])
        names["joint_targets"](**readings, command=requested)
        bound = timestep * np.array([component["largest_rate"] for component in components])
        limited = limited + np.clip(requested - limited, -bound, bound)
        control.set_command(np.arange(1), requested[None])
        control.approach_requested()
        control.advance()
        np.testing.assert_allclose(names["memory"]["command"], control.command, atol=1e-6)
        np.testing.assert_allclose(limited, control.command[0], atol=1e-12)
        np.testing.assert_allclose(names["memory"]["gait_phase"], control.phase[:, None], atol=1e-5)


def test_observation_follows_from_the_manifests_numbers_alone(flat):
    """The action by the manifest's observation, through the policy's network, is the graph's."""
    document, rng, n = flat.manifest, np.random.default_rng(3), 500
    session = runtime.session_of((flat.folder / "policy.onnx").read_bytes())
    command = rng.uniform([-0.5, -0.9], [0.8, 0.9], (n, 2))
    command[::7] = 0.0
    phase = rng.uniform(0.0, 2.0 * np.pi, n)
    widths = {entry["name"]: entry["shape"][1] for entry in document["graph"]["inputs"]}
    inputs = {name: rng.normal(0.0, 1.0, (n, width)) for name, width in widths.items()}
    inputs |= {"command": command, "gait_phase": phase[:, None]}
    found = runtime.run(session, {name: value.astype(np.float32) for name, value in inputs.items()})
    moving = (np.abs(command) > document["command"]["standing_up_to"]).any(axis=1, keepdims=True)
    inputs["gait_clock"] = np.stack([np.sin(phase), np.cos(phase)], axis=1) * moving
    columns = [
        np.clip((inputs[field["name"]] - field["offset"]) * field["scale"], field["low"], field["high"])
        for field in document["observation"]["fields"]
    ]
    observation = np.concatenate([*columns, inputs["observation_history"]], axis=1).astype(np.float32)
    np.testing.assert_allclose(found["action"], load_policy("flat").predict(observation), rtol=0, atol=1e-5)


def test_policy_that_was_not_evaluated_has_no_results(run, tmp_path):
    export = export_policy(run, tmp_path / "export")
    assert export.manifest["evaluation"] is None
    assert export.manifest["training"]["best return"] is None, "NaN is no JSON"
    assert "not evaluated" in (tmp_path / "export" / "README.md").read_text()
    assert "progress.csv" not in export.files


def test_results_of_the_evaluation_are_in_the_manifest_and_on_the_page(run, compared, tmp_path):
    write_numbers(run, compared, "python evaluate/policy.py")
    export = export_policy(run, tmp_path / "export")
    results = export.manifest["evaluation"]
    error = compared.estimate("policy", "forward_velocity_error", "forwards").mean
    assert results["by_motion"]["forwards"]["forward_velocity_error"]["mean"] == pytest.approx(error)
    assert results["verdict"]["headline"] in (tmp_path / "export" / "README.md").read_text()
    forwards = results["by_motion"]["forwards"]
    shown = [forwards[metric]["mean"] for metric in ("forward_velocity_error", "yaw_rate_error", "fall_rate")]
    row = " | ".join(f"{value:.3g}" for value in shown)
    assert f"| forwards | {row} |" in (tmp_path / "export" / "README.md").read_text()


def test_an_export_names_no_directories(run, compared, tmp_path):
    command = "mini-quadruped train --task=/secret/place/my_task.py -o ../secret/runs --resume secret/runs/latest"
    told = dataclasses.replace(run, policy=run.policy.with_card({"command": command}))
    told.policy.save(run.directory)
    write_numbers(told, compared, "mini-quadruped evaluate secret/a --task /secret/b.py")
    export = export_policy(told, tmp_path / "export")
    shown = "mini-quadruped train --task=my_task.py -o runs --resume latest"
    assert export.manifest["training"]["command"] == shown
    assert export.manifest["evaluation"]["command_line"] == "mini-quadruped evaluate a --task b.py"
    assert load_policy(tmp_path / "export").card["command"] == shown
    files = {name: (tmp_path / "export" / name).read_bytes() for name in export.files}
    assert [name for name, content in files.items() if b"secret" in content] == []


def test_gain_over_the_zero_action_is_on_the_page_and_in_the_manifest(run, tmp_path):
    gain = learning_gain(run.policy, 2, 2.0)
    learned = dataclasses.replace(run, policy=run.policy.with_card({"seed": 0, "learning": gain.to_dict()}))
    learned.policy.save(run.directory)
    export = export_policy(learned, tmp_path / "export")
    assert export.manifest["learning"]["verdict"] == gain.verdict()
    assert export.manifest["training"] == {"seed": 0}
    page = " ".join((tmp_path / "export" / "README.md").read_text().split())
    assert f"over 2 episodes of 2 s: {gain.verdict()}; {reward_in_words(gain.to_dict())}." in page
    for row in gain_rows(gain.to_dict()):
        assert " ".join(f"| {' | '.join(row)} |".split()) in page


def test_results_of_another_policy_are_left_out_with_a_warning(run, compared):
    write_numbers(run, compared, "python evaluate/policy.py")
    other = run.policy.with_card({**run.policy.card, "seed": 7})
    evaluated = EvaluatedPolicy(run.name, other, run.directory, run.output)
    with pytest.warns(QuadrupedWarning, match=r"metrics\.json: is the evaluation of another policy"):
        assert results_of(evaluated) == ({}, None)
    (run.output / "metrics.json").write_text("{}")
    with pytest.warns(QuadrupedWarning, match=r"metrics\.json: command_line is missing; it is"):
        assert results_of(run) == ({}, None)


def test_folder_is_written_whole_or_not_at_all(run, tmp_path, monkeypatch):
    target = tmp_path / "exports" / "mine"

    def fail(*arguments):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(folder_module, "write_json", fail)
        with pytest.raises(QuadrupedError, match=r"mine: cannot be written \(No space left on device\); make room"):
            export_policy(run, target)
    assert list(target.parent.iterdir()) == []
    before = export_policy(run, target)
    with monkeypatch.context() as patch:
        patch.setattr(folder_module, "write_json", fail)
        with pytest.raises(QuadrupedError, match="cannot be written"):
            export_policy(run, target, overwrite=True)
    assert {path.name for path in target.iterdir()} == set(before.files)
    assert [path.name for path in target.parent.iterdir()] == ["mine"]
    assert json.loads((target / "manifest.json").read_text()) == before.manifest


def test_only_an_empty_directory_or_an_earlier_export_is_replaced(run, tmp_path):
    target = tmp_path / "mine"
    target.mkdir()
    export_policy(run, target)
    with pytest.raises(QuadrupedError, match=r"mine: exists already; .*\(--overwrite\)"):
        export_policy(run, target)
    (target / "notes.txt").write_text("old")
    export_policy(run, target, overwrite=True)
    assert not (target / "notes.txt").exists()
    home = tmp_path / "home"
    home.mkdir()
    (home / "thesis.tex").write_text("precious")
    (home / "manifest.json").write_text('{"format": "another"}')
    for place in (home, home / "thesis.tex"):
        with pytest.raises(QuadrupedError, match="exists already and is not an exported policy; name another place"):
            export_policy(run, place, overwrite=True)
    assert (home / "thesis.tex").read_text() == "precious"


@pytest.mark.parametrize("library", ["onnx", "onnxruntime"])
def test_missing_library_names_the_extra_and_writes_nothing(run, tmp_path, monkeypatch, library):
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(MissingExtraError, match=r"needs the 'export' extra: .*pip install .*\[export\]'"):
        export_policy(run, tmp_path / "export")
    assert not (tmp_path / "export").exists()


def test_program_exports_into_the_run_and_names_what_it_wrote(run, capsys):
    assert main(["export", str(run.directory)]) == 0
    folder = run.directory / "export"
    said = capsys.readouterr().out
    assert f"folder: {folder}" in said
    assert "evaluate the policy first" in said
    assert {path.name for path in folder.iterdir()} == FILES
    assert main(["export", str(run.directory)]) == 2
    assert "--overwrite" in capsys.readouterr().err
    assert main(["export", str(run.directory), "--overwrite"]) == 0
    # The run is as it was, and its export can be evaluated and exported like a run.
    assert find_policy(str(folder)).policy.card.keys() == run.policy.card.keys()
    assert main(["export", str(folder), "-o", str(run.directory / "again")]) == 0
    one, other = ((place / "policy.onnx").read_bytes() for place in (folder, run.directory / "again"))
    assert one == other


def test_documentation_lists_the_inputs_outputs_and_files(flat):
    text = (ROOT / "docs" / "export.md").read_text()
    graph = flat.manifest["graph"]
    first_cells = re.findall(r"^\| (`.*?`) \|", text, re.MULTILINE)
    named = {name for cell in first_cells for name in re.findall(r"`(.*?)`", cell)}
    of_history = {"observation_history", "next_observation_history"}
    of_graph = {entry["name"] for entry in graph["inputs"] + graph["outputs"]}
    policy = load_policy("flat")
    of_metadata = metadata(policy, PolicyInterface(policy)).keys()
    in_c = {HEADER_FILE, SOURCE_FILE, SKETCH_FILE}
    assert named == of_graph | of_history | of_metadata | set(flat.files) | {"film.webp"} | in_c | FOR_HUB
    assert f"opset {graph['onnx_opset']} |" in text
    assert f"{graph['largest_difference_from_the_policy']:.0e}".replace("e-0", "e-") in text


@pytest.mark.parametrize("mode", ["residual", "position"])
def test_program_exports_the_policy_of_another_robot_with_its_joints(mode, tmp_path, capsys):
    (tmp_path / "my_robot.py").write_text("from second_robot import ROBOT\n")
    policy = random_policy(mode)
    task = TaskConfig(action=ActionConfig(mode=mode)).for_robot(second_robot.ROBOT)
    Policy.for_task(policy.weights, policy.biases, policy.activation, task, policy.card).save(tmp_path / "run")
    assert main(["export", str(tmp_path / "run")]) == 2
    assert "--task FILE" in capsys.readouterr().err
    assert main(["export", str(tmp_path / "run"), "--task", str(tmp_path / "my_robot.py")]) == 0
    folder = tmp_path / "run" / "export"
    document = json.loads((folder / "manifest.json").read_text())
    assert document["robot"]["joints"][:3] == ["RH_hip_joint", "RH_knee_joint", "LF_hip_joint"]
    assert document["control"]["action_mode"] == mode
    assert {joint["kp_n_m_rad"] for joint in document["joints"]} == {70.0, 60.0}
    assert (folder / "robot.urdf").read_text() == second_robot.ROBOT.urdf
    assert 'joints:  # in the order of the arrays\n      - "RH_hip_joint"' in (folder / "controllers.yaml").read_text()
    assert "70 N m/rad and 1.5 N m s/rad" in (folder / "README.md").read_text()


@pytest.mark.slow
def test_film_is_on_the_page(opengl, run, tmp_path, monkeypatch):
    monkeypatch.setattr(folder_module, "FILM_COMMANDS", ((0.4, 0.0),))
    export = export_policy(run, tmp_path / "export", with_film=True)
    assert (tmp_path / "export" / "film.webp").read_bytes()[8:12] == b"WEBP"
    assert "![The robot walks.](film.webp)" in (tmp_path / "export" / "README.md").read_text()
    assert "film.webp" in export.manifest["files"]


@pytest.fixture(scope="module")
def for_hub(tmp_path_factory):
    """The shipped policy, exported for a hub, without a film."""
    folder = tmp_path_factory.mktemp("exports") / "hub"
    evaluated = find_policy("flat", tmp_path_factory.mktemp("none"))
    return export_policy(evaluated, folder, write_page=lambda path: path.write_text("page")).folder


def test_folder_for_a_hub_has_the_page_and_its_card_the_results_that_a_hub_lists(for_hub):
    hub = pytest.importorskip("huggingface_hub", reason="the hub's client is not installed: pip install -e '.[hub]'")
    document = json.loads((for_hub / "manifest.json").read_text())
    assert (for_hub / "walk.html").read_text() == "page"
    assert set(document["files"]) >= FOR_HUB
    card = hub.ModelCard.load(for_hub / "README.md")
    found = {result.metric_name: result for result in card.data.eval_results}
    for motion, values in document["evaluation"]["metrics"].items():
        for metric in ("fall_rate", "forward_velocity_error"):
            assert found[f"{metric.replace('_', ' ')}, {motion}"].metric_value == values[metric]
    assert {result.dataset_name for result in found.values()} == {ENV_ID}
    assert card.data.pipeline_tag == "reinforcement-learning"
    # A hub's own check of the field.
    assert hub.ModelCard(f"---\n{card.data.to_yaml()}\n---\n").data.to_dict() == card.data.to_dict()


@pytest.mark.parametrize("name", ["läufer 🤖", "a.py", "flat", "with 'quotes\" and \\"])
def test_run_of_any_name_is_exported_next_to_it(tmp_path, monkeypatch, capsys, name):
    monkeypatch.chdir(tmp_path)
    run = tmp_path / "mine" / name
    random_policy("residual").save(run)
    assert main(["export", f"mine/{name}", "--c"]) == 0
    assert f"folder: mine/{name}/export (" in capsys.readouterr().out
    document = json.loads((run / "export" / "manifest.json").read_text())
    assert document["name"] == name
    assert find_policy(f"mine/{name}").source == f"runs/{name}"
    assert main(["check-export", f"mine/{name}/export"]) == 0
    assert main(["page", f"mine/{name}", "-o", f"{name}.html"]) == 0
    _, (controller,) = find_controllers([f"mine/{name}"])
    assert controller == f"run mine/{name}"


@pytest.mark.parametrize(
    ("part", "value", "message"),
    [
        ("learning", {"verdict": "better"}, "card: learning.difference is missing; it is left out"),
        ("metrics", {"return": 1.5}, "card: metrics.return: expected a table; found 1.5; it is left out"),
        ("suite", {"suite": {"name": "mq-eval"}}, "card: suite.suite.quick is missing; it is left out"),
        ("verdict", {"level": "good"}, r"card: verdict: expected a text; found \{'level': 'good'\}; it is left out"),
    ],
)
def test_results_on_a_card_of_another_form_are_left_out_and_named(tmp_path, part, value, message):
    policy = load_policy("flat")
    evaluated = save_run(tmp_path / "run", policy.with_card({**policy.card, part: value, "later": {"x": 1}}))
    with pytest.warns(QuadrupedWarning, match=rf"run/policy\.json: {message}$") as warned:
        on_card, evaluation = results_of(evaluated)
    assert len(warned) == 1
    assert "learning" not in evaluation
    kept = {**evaluation, "learning": on_card.get("learning")}
    known = ("metrics", "acceptance", "disturbed", "suite", "verdict", "learning")
    assert {name: kept.get(name) for name in known} == {**{n: policy.card[n] for n in known}, part: None}
