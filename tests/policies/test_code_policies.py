"""Policies that are code: an object with two methods, from Python or a file, and the uses that need a policy's file."""

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.control.live_controller import LiveController
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.export.folder import export_policy
from quadruped_env.policies import PolicyController, as_policy, find_controllers, load_policy
from quadruped_env.policies.files import read_policy
from quadruped_env.viewer.viewed_robot import TaskRobot

FILE = """
import numpy as np


class Swinging:
    env_kwargs = {"action_mode": "residual", "config": {"command": {"yaw_rate": [-0.2, 0.2]}}}

    def __init__(self):
        self.resets, self.widths = [], []

    def reset(self, begun):
        self.resets.append(begun.copy())
        if begun.all():
            self.steps = np.zeros(len(begun))
        self.steps[begun] = 0.0

    def predict(self, observation):
        assert observation.dtype == np.float32
        self.widths.append(observation.shape)
        self.steps += 1.0
        return 3.0 * np.sin(0.3 * self.steps)[:, None] * np.ones(8)


policy = Swinging()
"""


@pytest.fixture
def path(tmp_path):
    file = tmp_path / "swinging.py"
    file.write_text(FILE)
    return file


def agent_of(path):
    return load_policy(path).agent


def test_object_is_compared_in_its_env_and_told_where_episodes_begin(path):
    agent = agent_of(path)
    comparison = compare(agent, num_seeds=2, seconds=3.0, commands=[(0.3, 0.0), (0.0, 0.0)])
    assert comparison.config.action.mode == "residual"
    assert comparison.rollouts["policy"].valid.shape[1] == 4
    assert set(agent.widths) == {(4, 102)}
    assert [begun.tolist() for begun in agent.resets] == [[True] * 4]
    again = compare({"code": agent, "flat": load_policy("flat")}, 1, 3.0, [(0.3, 0.0)])
    assert set(again.rollouts) == {"code", "flat", "tuned", "article", "zero"}
    assert [begun.tolist() for begun in agent.resets[1:]] == [[True]]
    assert Candidate.of_policy(agent, "code").config.action.mode == "residual"


def test_file_defines_a_policy_with_its_name_hash_and_env(path):
    policy = load_policy(path)
    assert policy.card["name"] == "swinging.py"
    assert len(policy.card["sha256"]) == 64
    assert policy.config.command.yaw_rate == (-0.2, 0.2)
    assert policy.make_env().unwrapped.task.config == policy.config
    policy.agent.reset(np.ones(3, dtype=bool))
    actions = policy.predict(np.zeros((3, 102)))
    assert actions.dtype == np.float32
    np.testing.assert_allclose(actions, min(1.0, 3.0 * np.sin(0.3)), atol=1e-6)
    evaluated = find_policy(str(path))
    assert (evaluated.name, evaluated.source, str(evaluated.output)) == ("swinging", "swinging.py", "results/swinging")
    assert (evaluated.progress_file, evaluated.task_file, evaluated.recipe) == (None, None, "swinging")


def test_agent_is_told_of_the_envs_that_begin_among_others(path):
    policy = load_policy(path)
    env = policy.make_vec_env(3)
    env.reset(seed=0)
    task, controller = env.unwrapped.task, PolicyController(policy)
    for steps in ([1, 1, 1], [2, 2, 2], [1, 3, 1]):
        task.control.steps[:] = steps
        controller.act(task.observe(), task.control)
    assert [begun.tolist() for begun in policy.agent.resets] == [[True] * 3, [True, False, True]]


def test_class_in_a_file_is_made_for_each_use(path):
    path.write_text(FILE.replace("policy = Swinging()", "policy = Swinging"))
    assert type(agent_of(path)).__name__ == "Swinging"


def test_viewer_shows_files_and_objects_with_a_memory_for_each_robot(path):
    agent = agent_of(path)
    specs, chosen = find_controllers([str(path), agent])
    assert chosen == ("policy swinging.py", "policy Swinging")
    for name in chosen:
        robots = [TaskRobot(specs[name]) for _ in range(2)]
        robots[0].step()
        robots[0].step()
        robots[1].step()
        own = [robot._controller.policy.agent for robot in robots]
        assert [len(one.widths) for one in own] == [2, 1]
        robots[0].reset(0, (0.2, 0.0))
        robots[0].step()
        assert len(own[0].resets) == 2
    assert agent.widths == []


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("policy =", "other =", r"swinging.py: defines no 'policy'; name an object with reset\(begun\) and predict"),
        ("policy = Swinging()", "policy = 3", r"swinging.py: int has no method reset; .*your-own-algorithm"),
        ("def predict", "def act", r"Swinging has no method predict"),
        ('"action_mode"', '"mode"', r"env_kwargs: expected a dict with action_mode, config, .*; found"),
        ('"residual"', '"walking"', r"swinging.py: env_kwargs: config.action.mode.*'walking'"),
        ("self.resets, self.widths =", "open(3.5) #", r"TypeError"),
        ("policy = Swinging()", "policy = Swinging(1)", r"line \d+: TypeError"),
        ("policy = Swinging()", "policy = (lambda: (yield))()", r"policy cannot be made or copied \(TypeError"),
    ],
)
def test_bad_file_is_named(path, old, new, message):
    path.write_text(FILE.replace(old, new))
    with pytest.raises(QuadrupedError, match=message):
        load_policy(path)


@pytest.mark.parametrize(
    ("returned", "found"),
    [
        ("np.zeros(8)", r"expected an .* \(1, 8\); found float64 of shape \(8,\)"),
        ("np.zeros((1, 8), int)", r"expected an .* \(1, 8\); found int64 of shape \(1, 8\)"),
        ("None", r"expected an .* \(1, 8\); found object of shape \(\)"),
        ("np.full((1, 8), np.nan)", r"an action is not finite"),
    ],
)
def test_bad_actions_are_named(path, returned, found):
    path.write_text(FILE.replace("return 3.0 *", f"return {returned}; 3.0 *"))
    policy = load_policy(path)
    policy.agent.reset(np.ones(1, dtype=bool))
    with pytest.raises(QuadrupedError, match=f"swinging.py: predict: {found}"):
        policy.predict(np.zeros((1, 102)))


def test_uses_that_need_a_file_say_so(path, tmp_path):
    policy, message = load_policy(path), r"swinging.py is a policy of Python code.*Policy.from_sb3\(model\).save"
    with pytest.raises(QuadrupedError, match=rf"save: \S+{message}"):
        policy.save(tmp_path / "saved")
    with pytest.raises(QuadrupedError, match=rf"export: \S+{message}"):
        export_policy(find_policy(str(path)), tmp_path / "exported")
    with pytest.raises(QuadrupedError, match=rf"live controller: \S+{message}"):
        LiveController(PolicyController(policy))
    with pytest.raises(QuadrupedError, match=r"swinging.py: is Python code, and a robot's controller runs policies of"):
        read_policy(path)
    with pytest.raises(QuadrupedError, match=r"leave trust_task out"):
        load_policy(path, trust_task=True)
    assert not (tmp_path / "saved").exists()
    assert as_policy(policy) is policy


@pytest.mark.slow
def test_programs_evaluate_and_compare_a_file(path, tmp_path, monkeypatch, capsys):
    pytest.importorskip("jinja2", reason="jinja2 is not installed: pip install -e '.[report]'")
    monkeypatch.chdir(tmp_path)
    short = ["--seeds", "1", "--seconds", "3"]
    assert main(["evaluate", "swinging.py", "--no-video", *short]) == 0
    assert main(["compare", "swinging.py", "flat", *short]) == 0
    assert "numbers: results/swinging/metrics.json" in capsys.readouterr().out
    assert "swinging.py" in (tmp_path / "results" / "swinging" / "report.html").read_text()
