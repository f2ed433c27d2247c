"""A user's own terms and robots: the code of docs/make-it-yours.md and docs/robots.md, and refusal of bad terms."""

import copy
import json
import re

import gymnasium
import numpy as np
import pytest
from paths import ROOT
from policies import save_policy

from quadruped_env import QuadrupedError, QuadrupedWarning
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.live_controller import LiveController
from quadruped_env.control.task_file import load_robot, load_terms
from quadruped_env.envs import ENV_ID
from quadruped_env.policies import find_controllers, load_policy
from quadruped_env.task import RewardConfig, TaskConfig, load_task_file

PAGES = "".join((ROOT / "docs" / f"{name}.md").read_text() for name in ("make-it-yours", "robots"))
EXAMPLES = [
    example
    for example in re.findall(r"```python\n(.*?)```", PAGES, re.S)
    if "gymnasium" not in example and "dog.xml" not in example  # tests/robot/test_robot_model.py runs it
]
SERVOS = next(example for example in EXAMPLES if "hobby_servo" in example)
"""A whole task file, with a robot of its own."""


@pytest.fixture
def my_task(tmp_path):
    """All other examples of the page in one file."""
    file = tmp_path / "my_task.py"
    file.write_text("\n\n".join(example for example in EXAMPLES if example is not SERVOS))
    return file


def write(tmp_path, text):
    file = tmp_path / "own.py"
    file.write_text(text)
    return file


@pytest.mark.parametrize("example", EXAMPLES, ids=range(len(EXAMPLES)))
def test_an_example_of_the_page_is_under_fifteen_lines_and_works_alone(example, tmp_path):
    assert len([line for line in example.splitlines() if line.strip()]) < 15
    env = gymnasium.make(ENV_ID, task_file=write(tmp_path, example))
    env.reset(seed=0)
    for _ in range(3):
        env.step(env.action_space.sample())


def test_terms_of_a_file_appear_in_env_info_and_config(my_task):
    env = gymnasium.make(ENV_ID, task_file=my_task, config={"reward": {"weights": {"hip_usage": -2.0}, "free": 0.0}})
    built_in = gymnasium.make(ENV_ID)
    assert env.observation_space.shape[0] == built_in.observation_space.shape[0] + 3 * (8 + 1)
    observation, _ = env.reset(seed=1, options={"command": (0.3, 0.0, 0.16)})
    assert observation[34 + 8] == pytest.approx(5.0 * 0.16)
    _, reward, _, _, info = env.step(np.zeros(8))
    terms = {name: value for name, value in info.items() if name.startswith("reward_")}
    assert reward == pytest.approx(sum(terms.values()))
    assert list(terms)[-3:] == ["reward_hip_usage", "reward_air_time", "reward_height_error"]
    task = env.unwrapped.task
    hips = info["joint_position"][0::2] - task.control.robot.stance[0::2]
    assert terms["reward_hip_usage"] == pytest.approx(-2.0 * 0.02 * (hips**2).sum())
    assert terms["reward_height_error"] == pytest.approx(-50.0 * 0.02 * (info["base_position"][2] - 0.16) ** 2)
    document = json.loads(json.dumps(task.config.to_dict()))
    assert document["task_file"]["name"] == "my_task.py"
    assert document["randomization"]["leg_mass"] == [0.8, 1.2]
    assert TaskConfig.from_dict(document, load_task_file(my_task)) == task.config


def test_terrain_of_the_page_is_the_ground_of_envs_that_name_it(my_task):
    env = gymnasium.make_vec(ENV_ID, num_envs=2, task_file=my_task, terrain="ridges", config={"terrain": {"seed": 1}})
    env.reset(seed=0)
    field = env.unwrapped.task.simulation.height_field
    np.testing.assert_allclose(field.at(np.array([[2.2, 3.0], [2.6, 3.0], [0.0, 0.0]])), [0.02, 0.0, 0.0], atol=1e-9)
    expected = {"name": "ridges", "seed": 1, "level": None, "height": 0.02, "width": 0.4}
    assert env.unwrapped.task.config.to_dict()["terrain"] == expected


def test_randomized_model_field_is_drawn_per_env_and_scales_inertia_too(my_task):
    env = gymnasium.make_vec(ENV_ID, num_envs=50, task_file=my_task).unwrapped
    plain = env.task.simulation.model
    env.reset(seed=0)
    legs = [plain.body(f"{leg}_leg").id for leg in env.task.control.robot.leg_names]
    mass = env.task.simulation.model_field("body_mass")[:, legs]
    shares = mass / plain.body_mass[legs]
    assert 0.8 <= shares.min() < 0.83
    assert 1.17 < shares.max() <= 1.2
    assert len(np.unique(shares)) == shares.size, "each leg on its own"
    inertia = env.task.simulation.model_field("body_inertia")[:, legs]
    np.testing.assert_allclose(inertia / plain.body_inertia[legs], shares[..., None].repeat(3, -1))
    others = np.delete(np.arange(plain.nbody), legs)
    np.testing.assert_array_equal(
        env.task.simulation.model_field("body_mass")[:, others], [plain.body_mass[others]] * 50
    )


def test_a_term_that_is_added_changes_no_other_draw(my_task):
    envs = [gymnasium.make(ENV_ID, **kwargs).unwrapped for kwargs in ({"task_file": my_task}, {})]
    for episode in range(3):
        own, built_in = (env.reset(seed=5 if episode == 0 else None)[1] for env in envs)
        offsets = [
            info["joint_position"] - env.task.control.robot.stance
            for info, env in zip((own, built_in), envs, strict=True)
        ]
        np.testing.assert_allclose(*offsets, rtol=0, atol=1e-12, err_msg="both start near their stance")
        shares = [
            info["command"] / [env.task.config.command.forward_velocity[1], env.task.config.command.yaw_rate[1]]
            for info, env in zip((own, built_in), envs, strict=True)
        ]
        np.testing.assert_allclose(*shares, rtol=1e-5, err_msg="the ranges follow the file's robot")
        assert envs[0].task.control.phase == envs[1].task.control.phase


def test_single_and_vector_environment_with_own_terms_are_bit_identical(my_task):
    single = gymnasium.make(ENV_ID, task_file=my_task, disable_env_checker=True).unwrapped
    vector = gymnasium.make_vec(ENV_ID, num_envs=3, task_file=my_task, autoreset_mode="Disabled")
    one, many = single.reset(seed=7)[0], vector.reset(seed=7)[0]
    np.testing.assert_array_equal(one, many[0])
    rng = np.random.default_rng(0)
    for _ in range(40):
        action = rng.uniform(-0.5, 0.5, (3, 8)).astype(np.float32)
        one, reward, fallen, _, _ = single.step(action[0])
        many, rewards, falls, _, _ = vector.step(action)
        np.testing.assert_array_equal(one, many[0])
        assert (reward, fallen) == (rewards[0], falls[0])
        if falls.any():
            break


def test_defaults_of_a_users_file_are_those_of_its_config(tmp_path):
    file = write(
        tmp_path,
        "from quadruped_env.task import Command, reward\n"
        "speed = Command('forward_velocity', 'm/s', (0.0, 0.3))\n"
        "@reward(weight=-7.0)\n"
        "def upright(context):\n"
        "    return context.readings.up_b[:, 0] ** 2\n",
    )
    definition = load_task_file(file)
    config = TaskConfig(definition=definition)
    assert config == TaskConfig.from_dict({}, definition) == TaskConfig().with_definition(definition)
    assert (config.reward.weights.upright, config.command.forward_velocity) == (-7.0, (0.0, 0.3))
    changed = TaskConfig(reward=RewardConfig(foot_lift=0.03, weights={"fall": -1.0})).with_definition(definition)
    assert (changed.reward.weights.upright, changed.reward.weights.fall, changed.reward.foot_lift) == (-7.0, -1.0, 0.03)
    # A section that is given counts as it is.
    assert TaskConfig(reward=RewardConfig(), definition=definition).reward.weights.upright == -10.0


LOGS = """
from pathlib import Path
from quadruped_env.robot import QuadrupedDesign
from quadruped_env.task import reward

with Path(__file__).with_suffix(".log").open("a") as log:
    log.write("executed\\n")

ROBOT = QuadrupedDesign(name="logged", leg_length=0.2)

@reward(weight=-7.0)
def upright(context):
    return context.readings.up_b[:, 0] ** 2
"""


def test_file_is_executed_once_per_path_and_content(tmp_path, monkeypatch):
    file = write(tmp_path, LOGS)
    log = file.with_suffix(".log")
    definition, terms, robot = load_task_file(file), load_terms(file), load_robot(file)
    monkeypatch.chdir(tmp_path)
    assert load_task_file(file.name, definition.file).robot is definition.robot is terms.robot is robot
    assert load_task_file(file) is definition
    find_controllers(["tuned", "trot"], task_file=file)
    for _ in range(2):
        gymnasium.make(ENV_ID, task_file=file)
    assert log.read_text() == "executed\n"
    (tmp_path / "copy").mkdir()
    copied = load_task_file(write(tmp_path / "copy", LOGS))
    assert copied == definition
    assert (tmp_path / "copy" / log.name).read_text() == log.read_text() == "executed\n"
    write(tmp_path, LOGS + "# changed\n")
    assert load_task_file(file) != definition
    assert log.read_text() == "executed\n" * 2


REFUSED = {
    "nothing": ("x = 1\n", r"own.py: defines no term and no robot; use @reward.* or @terrain, or make a Randomization"),
    "syntax": ("def f(:\n", r"own.py, line 1: SyntaxError"),
    "failure": ("\n\n1 / 0\n", r"own.py, line 3: ZeroDivisionError"),
    "no default": (
        "from quadruped_env.task import reward\n@reward(1.0)\ndef a(context, b): ...\n",
        r"a: argument 'b' needs a number as its default.*found none",
    ),
    "a termination that is no condition": (
        "from quadruped_env.task import termination\n@termination\ndef low(context):\n    return context.base_height\n",
        r"termination low must be an array of bool, one value per env; found 'float64'",
    ),
    "half of a group": (
        "from quadruped_env.task import reward\n@reward(1.0)\ndef turn_progress(context): ...\n",
        r"turn_progress would replace a part of forward_progress and turn_progress",
    ),
}


MINE = "from quadruped_env.task import reward\n@reward(1.0)\ndef mine(context):\n    "
REFUSED |= {
    "a number": (f"{MINE}return 1.0", r"reward mine must be an array of shape \(1,\).*found 'float'"),
    "columns": (f"{MINE}return context.joint_offset", r"reward mine must be an .* \(1,\).*found \(1, 8\)"),
    "no attribute": (f"{MINE}return context.nothing", r"reward mine: AttributeError: .*nothing"),
}


@pytest.mark.parametrize(("text", "message"), REFUSED.values(), ids=REFUSED)
def test_a_file_that_does_not_work_is_refused_before_any_step(text, message, tmp_path):
    with pytest.raises(QuadrupedError, match=message):
        gymnasium.make(ENV_ID, task_file=write(tmp_path, text))


def test_a_reward_that_is_not_finite_is_refused_with_its_name_and_step(tmp_path):
    text = f"import numpy as np\n{MINE}return np.where(context.control.steps == 2, np.nan, 0.0)\n"
    env = gymnasium.make(ENV_ID, task_file=write(tmp_path, text))
    env.reset(seed=0)
    env.step(np.zeros(8))
    with pytest.raises(QuadrupedError, match=r"reward mine: nan in env 0, step 2; return finite numbers"):
        env.step(np.zeros(8))


def test_policy_of_an_own_robot_requires_its_file(my_task, tmp_path):
    directory = save_policy(tmp_path / "run", my_task)
    with pytest.raises(
        QuadrupedError, match=r"policy.json: this policy has the robot 'long_legs' from 'my_task.py', which is not exec"
    ):
        load_policy(directory)
    policy = load_policy(directory, my_task)
    assert policy.config.definition.file.name == "my_task.py"
    env = policy.make_env()
    observation, _ = env.reset(seed=0)
    env.step(policy.predict(observation))
    my_task.write_text(my_task.read_text() + "\n# another version\n")
    with pytest.warns(QuadrupedWarning, match="my_task.py is not the version of the training"):
        assert load_policy(directory, my_task).config.reward == policy.config.reward
    my_task.write_text(my_task.read_text().replace("leg_length=0.2", "leg_length=0.21"))
    with pytest.raises(QuadrupedError, match=r"another version of the robot 'long_legs'"):
        load_policy(directory, my_task)


def test_policy_of_position_only_servos_does_without_joint_feedback(tmp_path):
    ranges = json.loads(re.search(r'( {4}{"randomization": {"preset".*?}}\n)', PAGES, re.S)[1])
    file = write(tmp_path, SERVOS)
    policy = load_policy(save_policy(tmp_path / "run", file, ranges), file)
    expected = ["projected_gravity", "angular_velocity", "last_action", "command", "gait_clock"]
    assert [entry.name for entry in policy.fields] == expected
    LiveController(PolicyController(policy), robot=policy.robot)
    env = policy.make_env()
    observation, info = env.reset(seed=0)
    assert observation.shape == (3 * (34 - 2 * 8),)
    assert info["joint_position"].shape == (8,)
    motors = env.unwrapped.task.config.motor
    assert motors.hip.backlash == pytest.approx(np.radians(1.0))
    assert motors.delay == 0.02
    # The layout is the file's, so a policy of the built-in robot needs the file, too.
    file = write(tmp_path, "joint_position = joint_velocity = None\n")
    directory = save_policy(tmp_path / "other", file)
    with pytest.raises(QuadrupedError, match=r"has the observation joint_position, joint_velocity from .own\.py."):
        load_policy(directory)
    assert load_policy(directory, file).fields == load_terms(file).observations


def test_observation_that_the_robot_does_not_measure_is_refused_live(tmp_path):
    file = write(tmp_path, EXAMPLES[2].replace("joint_torque", "foot_force").replace('"joints"', '"feet"'))
    policy = load_policy(save_policy(tmp_path / "run", file), file)
    assert load_terms(file).observations[-1].name == "foot_force"
    with pytest.raises(QuadrupedError, match=r"observes foot_force, which the robot does not measure"):
        LiveController(PolicyController(policy))


NOISY = {"randomization": {"observation_noise": 1.0, "push_velocity": 0.4, "push_interval": [0.1, 0.3]}}


def test_a_copied_env_with_own_terms_continues_identically(my_task):
    env = gymnasium.make(ENV_ID, task_file=my_task, config=NOISY)
    env.reset(seed=1)
    for _ in range(10):
        env.step(np.full(8, -0.1))
    copied = copy.deepcopy(env)
    rewards, again = ([one.step(np.full(8, 0.1))[1] for _ in range(20)] for one in (env, copied))
    assert again == rewards


def test_an_env_with_own_terms_runs_in_workers(my_task):
    env = gymnasium.make(ENV_ID, task_file=my_task)
    # Not forked: other tests leave threads in this process.
    vector_kwargs = {"context": "spawn"}
    workers = gymnasium.make_vec(
        ENV_ID, num_envs=2, vectorization_mode="async", vector_kwargs=vector_kwargs, task_file=my_task
    )
    np.testing.assert_array_equal(workers.reset(seed=0)[0][0], env.reset(seed=0)[0])
    workers.close()
