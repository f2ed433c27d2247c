"""Presets of the randomization, and refusal of ranges that are not physical."""

import json
import math

import gymnasium
import numpy as np
import pytest
from second_robot import DESIGN
from tasks import make_task

from quadruped_env import QuadrupedError
from quadruped_env.envs import ENV_ID
from quadruped_env.robot import MINI_QUADRUPED, QuadrupedDesign
from quadruped_env.robot.units import steadiness
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import (
    PRESETS,
    ModelField,
    Randomization,
    RandomizationConfig,
    SensorError,
    Task,
    TaskConfig,
    load_task_file,
    preset_values,
)
from quadruped_env.task.randomization.randomization import Active


def test_each_preset_contains_the_ranges_of_the_one_before():
    moderate, hard = (RandomizationConfig(preset=name) for name in ("moderate", "hard"))
    for name in PRESETS["moderate"].keys() - {"push_interval", "push_velocity", "push_rotation"}:
        ends = []
        for section in (moderate, hard):
            value = section[name]
            ends.append(value if isinstance(value, tuple) else (-value, value))
        (low, high), (lower, higher) = ends
        assert higher >= high, name
        assert lower <= low or name == "push_speed", name
        assert (low, high) != (lower, higher), name
    # Its pushes are horizontal and of one size, as often on the average.
    assert hard.push_speed[0] > math.hypot(moderate.push_velocity, moderate.push_velocity)
    assert np.mean(hard.push_interval) <= np.mean(moderate.push_interval)


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_is_saved_as_plain_values(name):
    config = TaskConfig.from_dict({"randomization": name})
    document = json.loads(json.dumps(config.to_dict()))
    assert isinstance(document["randomization"], dict)
    assert "preset" not in document["randomization"]
    assert TaskConfig.from_dict(document) == config
    assert config == TaskConfig().randomized(name) == TaskConfig.from_dict({"randomization": preset_values(name)})


@pytest.mark.parametrize("name", PRESETS)
def test_an_env_takes_a_preset_by_its_name(name):
    single = gymnasium.make(ENV_ID, config={"randomization": name})
    vector = gymnasium.make_vec(ENV_ID, num_envs=2, config={"randomization": name})
    one, many = single.reset(seed=1)[0], vector.reset(seed=1)[0]
    np.testing.assert_array_equal(one, many[0])
    assert json.loads(single.spec.to_json())["kwargs"]["config"] == {"randomization": name}
    for _ in range(5):
        action = np.full((2, 8), 0.1, dtype=np.float32)
        one, many = single.step(action[0])[0], vector.step(action)[0]
        np.testing.assert_array_equal(one, many[0])


def test_fields_next_to_a_preset_change_it():
    config = TaskConfig.from_dict({"randomization": {"preset": "hard", "payload": None, "friction": [0.8, 0.8]}})
    assert config.randomization == RandomizationConfig(preset="hard").replace(payload=None, friction=(0.8, 0.8))


@pytest.mark.parametrize("value", ["extreme", {"preset": "extreme"}, {"preset": 3}])
def test_an_unknown_preset_is_refused_with_those_that_there_are(value):
    with pytest.raises(
        QuadrupedError, match=r"config.randomization must be one of none, moderate, hard, or .*found .*(extreme|3)"
    ):
        TaskConfig.from_dict({"randomization": value})


def test_numbers_of_a_preset_follow_the_robot():
    robot = QuadrupedDesign(name="heavy", leg_length=0.24, base_mass=6.0).robot()
    mass, length = robot.total_mass / 4.0, robot.stance_height / MINI_QUADRUPED.stance_height
    values, built_in = preset_values("hard", robot), preset_values("hard")
    np.testing.assert_allclose(values["payload"], mass * np.array(built_in["payload"]), rtol=1e-5)
    # Its feet are as far apart under a body that is higher, so that less tips it.
    steady = steadiness(robot)
    assert steady < 1.0
    np.testing.assert_allclose(values["push_force"], steady * mass * np.array(built_in["push_force"]), rtol=1e-3)
    np.testing.assert_allclose(values["push_speed"], steady * length**0.5 * np.array(built_in["push_speed"]), rtol=1e-3)
    assert values["base_com"] == pytest.approx(length * built_in["base_com"], rel=1e-5)
    for name in ("push_interval", "action_latency"):
        np.testing.assert_allclose(values[name], length**0.5 * np.array(built_in[name]), rtol=1e-5)
    for name in ("friction", "link_mass", "encoder_offset"):
        assert values[name] == built_in[name], name
    env = gymnasium.make(ENV_ID, robot=robot, config={"randomization": "hard"})
    env.reset(seed=0)
    assert env.unwrapped.task.config.randomization.payload == tuple(values["payload"])


def test_another_robot_runs_with_every_preset():
    for name in PRESETS:
        env = gymnasium.make(ENV_ID, robot=DESIGN, config={"randomization": name})
        env.reset(seed=0)
        assert np.isfinite(env.step(env.action_space.sample())[1])


# --- ranges that are not possible ---


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"link_mass": [1.2, 0.8]}, r"randomization.link_mass must be a pair .*low <= high.*\(1.2, 0.8\)"),
        ({"rotor_inertia": [0.0, 1.0]}, r"randomization.rotor_inertia must be positive"),
        ({"base_com": 1.0}, r"randomization.base_com must be .* in \[-0.2, 0.2\] \(m\); found 1"),
        ({"encoder_offset": 2.0}, r"randomization.encoder_offset must be .* in \[-0.5, 0.5\] \(rad\); found 2"),
        ({"action_latency": [0.0, 60.0]}, r"randomization.action_latency must be in \[0, 0.5\] \(s\); found \(0.0, 60"),
        ({"noise_amplitude": {"joint_position": -0.1}}, r"noise_amplitude.joint_position must be at least 0 \(rad\)"),
        ({"noise_amplitude": {"gyro": 0.1}}, r"noise_amplitude: unknown field 'gyro'; valid .*angular_velocity"),
        ({"noise_amplitude": 0.1}, r"noise_amplitude: expected a mapping of fields; found 0.1"),
        ({"motor_strenth": [0.8, 1.2]}, r"unknown field 'motor_strenth'; valid fields are .*motor_strength"),
    ],
)
def test_a_range_that_is_not_physical_is_refused_by_field_value_and_rule(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TaskConfig.from_dict({"randomization": values})


def make(**ranges):
    return gymnasium.make(ENV_ID, config={"randomization": ranges})


def test_ranges_that_together_leave_no_mass_are_refused_before_the_first_episode(tmp_path):
    make(payload=[-0.9, 0.0], link_mass=[0.5, 1.0])
    with pytest.raises(
        QuadrupedError, match=r"randomization.payload: \[-0.9, 0.0\] kg makes body_mass -0.02.*raise the lower end"
    ):
        make(payload=[-0.9, 0.0], link_mass=[0.4, 1.0])
    light = QuadrupedDesign(name="light", base_mass=0.6)
    with pytest.raises(QuadrupedError, match=r"randomization.payload: \[-0.7, 0.0\] kg makes body_mass -0.1"):
        gymnasium.make(ENV_ID, robot=light, config={"randomization": {"payload": [-0.7, 0.0]}})


@pytest.mark.parametrize(
    ("field", "setting", "message"),
    [
        ('ModelField("geom_friction", column=0, mode="add")', (-1.0, 0.0), r"\[-1.0, 0.0\] makes geom_friction -0.2"),
        ('ModelField("dof_damping", mode="set")', (-1.0, 0.0), r"makes dof_damping -1, which must be 0 or more"),
        ('ModelField("body_inertia", ["LF_leg"], mode="set")', (0.0, 1.0), r"makes body_inertia 0, .*positive"),
    ],
)
def test_own_range_of_a_model_field_that_is_not_physical_is_refused(tmp_path, field, setting, message):
    file = tmp_path / "own.py"
    file.write_text(
        f"from quadruped_env.task import ModelField, Randomization\nx = Randomization('x', {field}, {setting})\n"
    )
    with pytest.raises(QuadrupedError, match=rf"randomization.x: .*{message}"):
        gymnasium.make(ENV_ID, task_file=file)


def test_own_latency_of_the_actions_gets_a_buffer_that_holds_it(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.task import ModelField, Randomization\n"
        "own = Randomization('own', ModelField('actuator_delay', mode='add'), (0.1, 0.1))\n"
    )
    env = gymnasium.make(ENV_ID, task_file=file, config={"randomization": {"action_latency": [0.05, 0.05]}})
    env.reset(seed=0)
    np.testing.assert_allclose(env.unwrapped.model.actuator_delay, 0.15)
    assert load_task_file(file).randomizations[-1].name == "own"


@pytest.mark.parametrize("simulation", [SingleSimulation, lambda model: BatchSimulation(model, 2, 1)])
def test_a_model_whose_buffer_is_too_short_for_the_latency_is_refused_with_the_fix(simulation):
    config = TaskConfig.from_dict({"randomization": {"action_latency": [0.0, 0.06]}})
    with pytest.raises(
        QuadrupedError,
        match=r"action_latency: \[0.0, 0.06\] s makes the delay .*0.06 s.* holds 0 s.*compiled_model\(\)",
    ):
        Task(simulation(build_model()), config)
    Task(simulation(config.compiled_model()), config)


def test_motors_of_another_type_are_refused_by_name():
    model = build_model()
    model.actuator_gaintype[3] = 0
    with pytest.raises(QuadrupedError, match=r"randomization motor_strength: .*dcmotor; set the randomization to null"):
        Task(SingleSimulation(model), TaskConfig.from_dict({"randomization": {"motor_strength": [0.8, 1.2]}}))


def test_an_unknown_error_of_the_sensors_is_refused():
    with pytest.raises(QuadrupedError, match=r"quantity must be one of encoder_offset, imu_mounting, latency"):
        SensorError("gyro_bias")


@pytest.mark.parametrize(("quantity", "width"), [("encoder_offset", 3), ("imu_mounting", 1), ("latency", 2)])
def test_an_error_of_the_sensors_with_the_wrong_number_of_values_is_refused(quantity, width):
    randomization = Randomization("x", SensorError(quantity), 0.1, width=width)
    with pytest.raises(QuadrupedError, match=rf"randomization x: SensorError.*width must be .*; found {width}"):
        Active.of(randomization, 0.1, SingleSimulation(build_model()))


# --- several randomizations of one field ---


def test_randomizations_of_one_field_apply_in_their_order_and_start_anew_in_each_episode(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.task import ModelField, Randomization\n"
        "leg = Randomization('leg', ModelField('body_mass', ['LF_leg'], mode='add'), (0.05, 0.05))\n"
        "half = Randomization('half', ModelField('body_mass', ['LF_leg'], mode='divide'), (2.0, 2.0))\n"
    )
    for rows in (1, 3):
        config = TaskConfig.from_dict({"randomization": {"link_mass": [1.5, 1.5]}}, load_task_file(file))
        model = config.compiled_model()
        simulation = SingleSimulation(model) if rows == 1 else BatchSimulation(model, rows, 1)
        leg = model.body("LF_leg").id
        task = Task(simulation, config)
        for _ in range(3):
            task.reset(np.arange(rows))
            np.testing.assert_allclose(simulation.model_field("body_mass")[:, leg], (0.2 * 1.5 + 0.05) / 2.0)
            plain = simulation.compiled_field("body_inertia")[leg] * (0.175 / 0.2)
            np.testing.assert_allclose(simulation.model_field("body_inertia")[:, leg], [plain] * rows)


def test_model_field_that_changes_within_an_episode_ends_with_it(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.task import ModelField, Randomization\n"
        "ground = ModelField('geom_friction', column=0)\n"
        "ice = Randomization('ice', ground, (0.1, 0.1), interval=('every', (0.04, 0.04)))\n"
    )
    env = gymnasium.make(ENV_ID, task_file=file).unwrapped
    env.reset(seed=0)
    frictions = []
    for _ in range(6):
        env.step(np.zeros(8))
        frictions.append(float(env.model.geom_friction[0, 0]))
    np.testing.assert_allclose(frictions, [0.8] + [0.08] * 5)
    env.reset()
    assert env.model.geom_friction[0, 0] == 0.8


def test_a_field_of_several_columns_takes_one_value_for_each(tmp_path):
    randomization = Randomization("x", ModelField("body_ipos", ["LF_leg"], mode="add"), (0.0, 1.0), width=3)
    task = make_task(2)
    event = task._randomizer._event(np.array([1]))
    Active.of(randomization, (0.0, 1.0), task.simulation).apply(event, np.array([[0.1, 0.2, 0.3]]))
    leg = task.simulation.model.body("LF_leg").id
    moved = task.simulation.model_field("body_ipos")[:, leg] - task.simulation.model.body_ipos[leg]
    np.testing.assert_allclose(moved, [[0.0, 0.0, 0.0], [0.1, 0.2, 0.3]], atol=1e-15)


def test_two_randomizations_may_share_an_interval_and_not_with_two_defaults(tmp_path):
    file = tmp_path / "own.py"
    file.write_text(
        "from quadruped_env.task import Randomization\n"
        "def nothing(event, values): ...\n"
        "x = Randomization('x', nothing, 1.0, interval=('push_interval', (1.0, 2.0)))\n"
    )
    with pytest.raises(QuadrupedError, match=r"two terms have a field 'push_interval' with different"):
        TaskConfig.from_dict({}, load_task_file(file))
