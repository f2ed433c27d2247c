"""Everything in units of the robot: the built-in robot at half its size has the same task."""

import dataclasses

import mujoco
import numpy as np
import pytest
from half_robot import ROBOT, SIZE, TIME
from second_robot import ROBOT as OTHER
from twelve_joints import ROBOT as TWELVE

from quadruped_env.control.control_config import ControlConfig
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.live_controller import Safety
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.measures import mean_velocities
from quadruped_env.evaluation.suite.candidate import Candidate
from quadruped_env.gait import CommandedGait
from quadruped_env.policies import GaitController
from quadruped_env.robot import MINI_QUADRUPED, QuadrupedDesign
from quadruped_env.robot.units import motor_heat, scale_of, scaled_values, steadiness
from quadruped_env.simulation import BatchSimulation
from quadruped_env.task import BUILT_IN, PRESETS, Section, Task, TaskConfig, load_task_file, preset_values
from quadruped_env.task.sections import values_for
from quadruped_env.training.recipes import RECIPES
from quadruped_env.utils.fields import units_of

MASS = SIZE**3


@pytest.mark.parametrize(
    ("unit", "expected"),
    [
        ("1", 1.0),
        ("", 1.0),
        ("rad", 1.0),
        ("m", SIZE),
        ("kg", MASS),
        ("s", TIME),
        ("Hz", 1 / TIME),
        ("m/s", TIME),
        ("rad/s", 1 / TIME),
        ("m/s, rad/s", TIME),
        ("m/s^2", 1.0),
        ("rad^2/s^2", 1 / SIZE),
        ("m^2/s^2", SIZE),
        ("N", MASS),
        ("N m", MASS * SIZE),
        ("N m s/rad", MASS * SIZE * TIME),
        ("W", MASS * SIZE / TIME),
        ("kg m^2/s^2", MASS * SIZE),
        ("1/(m^2/s^2)", 1 / SIZE),
        ("W/(N m)^2", 1 / (MASS * SIZE * TIME)),
    ],
)
def test_scale_of_a_unit_is_that_of_similar_motions(unit, expected):
    assert scale_of(unit, ROBOT) == pytest.approx(expected, rel=1e-12)
    assert scale_of(unit, MINI_QUADRUPED) == 1.0


@pytest.mark.parametrize("unit", ["points", "m/", "m/(s", "m^x"])
def test_unknown_unit_is_refused(unit):
    with pytest.raises(QuadrupedError, match="expected products and powers of 1, rad, kg, m, s"):
        scale_of(unit, ROBOT)


def tree(config):
    """Numbers of a config and their units by path."""
    numbers = {"clock_frequency": (config.clock_frequency, "Hz")}

    def walk(values, units, path):
        for name, value in values.items():
            if isinstance(value, Section):
                walk(value, units[name], f"{path}{name}.")
            else:
                numbers[f"{path}{name}"] = value, units[name]

    for name in ("command", "reward", "termination", "randomization", "terrain"):
        section = getattr(config, name)
        walk(section, units_of(type(section)), f"{name}.")
    return numbers


@pytest.mark.parametrize("terrain", [{"name": "flat"}, {"name": "rough"}, {"name": "stairs", "level": 7}])
@pytest.mark.parametrize("preset", PRESETS)
def test_every_number_of_the_config_has_the_same_size_in_units_of_the_robot(preset, terrain):
    changes = {"randomization": preset, "terrain": terrain}
    built_in = TaskConfig.from_dict(changes)
    half = TaskConfig.from_dict(changes, built_in.definition.with_robot(ROBOT))
    assert (half.decimation, half.physics_timestep, half.action) == (4, 0.005, built_in.action)
    numbers = tree(half)
    for path, (value, unit) in tree(built_in).items():
        if isinstance(value, (float, tuple)):
            np.testing.assert_allclose(
                numbers[path][0], np.array(value) * scale_of(unit, ROBOT), rtol=1e-5, err_msg=path
            )
        else:
            assert numbers[path][0] == value, path
    assert numbers["command.forward_velocity"][0] == (-0.212132, 0.424264)
    assert numbers["reward.weights.foot_slip"][0] == 2.0 * built_in.reward.weights.foot_slip
    assert numbers["termination.max_trunk_force"][0] == 0.125


def test_a_config_takes_the_defaults_of_its_robot_and_keeps_what_a_person_set():
    config = TaskConfig.from_dict({"clock_frequency": 3.0, "reward": {"foot_lift": 0.03}}).for_robot(ROBOT)
    assert (config.clock_frequency, config.reward.foot_lift, config.reward.base_arm) == (3.0, 0.03, 0.1)
    assert TaskConfig().for_robot(OTHER).for_robot(ROBOT).for_robot(MINI_QUADRUPED) == TaskConfig()
    assert TaskConfig.from_dict(TaskConfig().for_robot(ROBOT).to_dict(), config.definition) == TaskConfig().for_robot(
        ROBOT
    )


def test_values_of_the_built_in_robot_become_those_of_another_one():
    values = {
        "clock_frequency": 3.0,
        "command": {"yaw_rate": [-1.0, 1.0]},
        "reward": {"weights": {"foot_slip": -1.0, "fall": -300.0}, "foot_lift": 0.02},
        "randomization": {"preset": "hard", "push_interval": [1.0, 2.0], "noise_amplitude": {"angular_velocity": 0.2}},
        "terrain": {"name": "rough", "height": 0.02},
        "decimation": 5,
    }
    half = values_for(values, ROBOT)
    assert half["clock_frequency"] == 4.24264
    assert half["command"] == {"yaw_rate": [-1.41421, 1.41421]}
    assert half["reward"] == {"weights": {"foot_slip": -2.0, "fall": -300.0}, "foot_lift": 0.01}
    assert half["randomization"] == preset_values("hard", ROBOT) | {
        "push_interval": [0.707107, 1.41421],
        "noise_amplitude": {"angular_velocity": 0.282843},
    }
    assert half["terrain"] == {"name": "rough", "height": 0.01}
    assert half["decimation"] == 5
    assert values_for(values, MINI_QUADRUPED) == values | {
        "randomization": preset_values("hard")
        | {name: v for name, v in values["randomization"].items() if name != "preset"}
    }
    for recipe in RECIPES.values():
        definition = TaskConfig().for_robot(ROBOT).definition
        TaskConfig.from_dict(values_for(recipe.task, ROBOT), definition)
    assert scaled_values({"a": {"b": (1.0, None)}, "c": True, "d": 3}, {"a": {"b": "m"}, "c": "m"}, ROBOT) == {
        "a": {"b": (0.5, None)},
        "c": True,
        "d": 3,
    }


NARROW = QuadrupedDesign(name="narrow", base_size=(0.3, 0.07, 0.08), hip_offset=(0.15, 0.06)).robot()
"""The built-in robot with its left and right feet at 0.6 times the distance."""
WIDE = QuadrupedDesign(name="wide", hip_offset=(0.15, 0.2)).robot()
STILTS = QuadrupedDesign(name="stilts", leg_length=0.25).robot()


def fast(factor):
    """The built-in robot with motors of another no-load speed."""
    motors = MINI_QUADRUPED.motors
    hip, knee = (dataclasses.replace(m, no_load_speed=factor * m.no_load_speed) for m in (motors.hip, motors.knee))
    return QuadrupedDesign(name="fast", motors=dataclasses.replace(motors, hip=hip, knee=knee)).robot()


@pytest.mark.parametrize("law", [steadiness, motor_heat])
def test_a_similar_robot_is_as_steady_and_its_motors_heat_as_much(law):
    assert (law(MINI_QUADRUPED), law(ROBOT)) == (1.0, 1.0)


def slopes(robot):
    """Distances of the centre of mass from the outermost feet, fore, left, hind and right, over its height."""
    model = mujoco.MjSpec.from_string(robot.mjcf).compile()
    data = mujoco.MjData(model)
    data.qpos[:] = [0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0, *robot.stance]
    mujoco.mj_forward(model, data)
    x, y, z = data.subtree_com[1]
    feet = np.array([data.site(name).xpos for name in robot.foot_sites])
    return np.array([feet[:, 0].max() - x, feet[:, 1].max() - y, x - feet[:, 0].min(), y - feet[:, 1].min()]) / z


def test_pushes_follow_the_distance_of_the_feet_from_each_other():
    """What tips a rigid robot is in proportion to the feet's distance from its centre of mass, over its height."""
    assert steadiness(NARROW) == pytest.approx(0.6, abs=1e-3)
    assert steadiness(WIDE) == 1.0, "no larger pushes than the built-in robot's"
    for robot in (NARROW, STILTS, TWELVE):
        assert steadiness(robot) == pytest.approx((slopes(robot) / slopes(MINI_QUADRUPED)).min(), abs=1e-3)
    for preset in ("moderate", "hard"):
        full, narrow = preset_values(preset), preset_values(preset, NARROW)
        pushes = {"push_velocity", "push_rotation", "push_speed", "push_force"} & full.keys()
        assert len(pushes) == {"moderate": 3, "hard": 2}[preset]
        for name, value in full.items():
            expected = np.array(value) * (0.6 if name in pushes else 1.0)
            np.testing.assert_allclose(narrow[name], expected, rtol=2e-3, err_msg=name)
        assert values_for({"randomization": preset}, NARROW)["randomization"] == narrow
        assert TaskConfig.from_dict({}, BUILT_IN.with_robot(NARROW)).randomized(preset).randomization.to_dict() == (
            TaskConfig.from_dict({"randomization": preset}, BUILT_IN.with_robot(NARROW)).randomization.to_dict()
        )


def test_the_cost_of_power_follows_what_the_motors_heat():
    """At the same torque a motor of five times the speed takes five times the power for the winding's heat."""
    assert motor_heat(fast(5.0)) == pytest.approx(5.0, rel=1e-3)
    assert motor_heat(fast(0.5)) == 1.0, "no larger weight than the built-in robot's"
    plain, quick = BUILT_IN.weights, BUILT_IN.with_robot(fast(5.0)).weights
    assert {name for name in plain if plain[name] != quick[name]} == {"electrical_power"}
    assert quick["electrical_power"] == pytest.approx(0.2 * plain["electrical_power"], rel=1e-3)
    weights = {"electrical_power": -0.01, "fall": -300.0}
    assert values_for({"reward": {"weights": weights}}, fast(5.0))["reward"]["weights"] == {
        "electrical_power": -0.002,
        "fall": -300.0,
    }


TWIN = dataclasses.replace(MINI_QUADRUPED, name="twin")
"""The built-in robot with the scripted gait of every other robot."""


def similar_contacts(model):
    """Give the half-size model contacts and limits of half the size."""
    for kind in ("geom", "jnt", "dof"):
        getattr(model, f"{kind}_solref")[:, 0] *= TIME
        getattr(model, f"{kind}_solimp")[:, 2] *= SIZE


@pytest.mark.parametrize(
    ("preset", "terrain"),
    [("none", {"name": "flat"}), ("hard", {"name": "flat"}), ("moderate", {"name": "tiles", "levels": 3})],
)
def test_episodes_of_the_half_size_robot_are_the_same_in_its_units(preset, terrain):
    """With a time step of its own, too: similar starts, commands, pushes, ground and noise, equal observations."""
    mode = "position" if preset == "hard" else "residual"
    changes = {"randomization": preset, "terrain": terrain, "action": {"mode": mode}}
    tasks = []
    for robot, timestep in ((TWIN, 0.005), (ROBOT, 0.005 * TIME)):
        definition = TaskConfig().definition.with_robot(robot)
        config = TaskConfig.from_dict({**changes, "physics_timestep": timestep}, definition)
        # Every term counts.
        weights = {name: scale_of(f"1/({t.unit})", robot) for t in definition.paid for name in t.names}
        reward = config.reward.replace(weights=weights)
        config = TaskConfig.from_dict({**config.to_dict(), "reward": reward.to_dict()}, definition)
        model = config.compiled_model()
        if robot is ROBOT:
            similar_contacts(model)
        tasks.append(Task(BatchSimulation(model, 8, robot=robot, num_threads=1), config))
        tasks[-1].reset(np.arange(8), list(range(8)))
    full, half = tasks
    rng = np.random.default_rng(0)
    np.testing.assert_allclose(half.observe(), full.observe(), atol=2e-5)
    similar, counts = np.ones(8, dtype=bool), np.zeros(len(full.term_names), dtype=bool)
    for step in range(30):
        action = 0.4 * np.sin(full.control.phase[:, None] + np.arange(8)) + 0.2 * rng.uniform(-1.0, 1.0, (8, 8))
        ours, theirs = half.step(action), full.step(action)
        # A contact that one robot just misses sets an episode apart for good.
        similar &= abs(ours.observation - theirs.observation).max(axis=1) < 2e-3
        assert similar.sum() >= 6, f"step {step}"
        sizes = np.maximum(1e-3, abs(theirs.terms[similar]).max(axis=0))
        np.testing.assert_array_less(abs(ours.terms[similar] / TIME - theirs.terms[similar]) / sizes, 0.02)
        np.testing.assert_array_equal(ours.terminated[similar], theirs.terminated[similar])
        np.testing.assert_allclose(half.command, full.command * [TIME, 1 / TIME], rtol=1e-4)
        counts |= theirs.terms.any(axis=0)
    assert {name for name, count in zip(full.term_names, counts, strict=True) if not count} <= {"stand_still", "fall"}
    true, scaled = (task.privileged_readings().values()[similar] for task in tasks)
    np.testing.assert_allclose(scaled, true, atol=0.02)


@pytest.mark.parametrize("speed", [0.2, 0.5])
def test_the_scripted_gait_walks_on_the_half_size_robot(speed):
    config = TaskConfig().for_robot(ROBOT)
    measured = Candidate("sinusoid", GaitController(CommandedGait.preset("sinusoid", ROBOT), "sinusoid"), config)
    rollout = measured.run([(speed * TIME, 0.0)], [0, 1], 8.0)
    assert not rollout.fallen.any()
    np.testing.assert_allclose(mean_velocities(rollout)[:, 0], speed * TIME, rtol=0, atol=0.08)


def test_standing_ends_at_the_same_speed_in_units_of_the_robot():
    control = ControlInterface(ROBOT, ControlConfig.of_task({}, ROBOT), 4)
    commands = np.array([[0.0141, 0.0], [0.0142, 0.0], [0.0, 0.0282], [0.0, -0.0283]])
    control.reset(np.arange(4), command=commands)
    assert control.moving.tolist() == [0.0, 1.0, 0.0, 1.0]
    assert ControlConfig.of_task({}, ROBOT) == TaskConfig().for_robot(ROBOT).control
    assert ControlConfig.of_task({}, MINI_QUADRUPED) == ControlConfig()
    safety = Safety.of(ROBOT)
    assert (safety.ramp_speed, safety.min_ramp_time, safety.limp_after) == (2.12132, 0.707107, 1.0)
    assert Safety.of(MINI_QUADRUPED) == Safety()


def test_numbers_of_a_users_file_are_those_of_its_robot(tmp_path):
    file = tmp_path / "task.py"
    file.write_text(
        "from typing import Annotated\n"
        "from half_robot import ROBOT\n"
        "from quadruped_env.task import Command, Parameter, Randomization, observation, reward, terrain\n"
        "height = Command('height', 'm', (0.07, 0.09))\n"
        "@reward(weight=-2.0, unit='points')\n"
        "def own(context, size: Annotated[float, Parameter('m')] = 0.03):\n"
        "    return context.base_height * 0.0\n"
        "@observation(unit='rad/s', mirror=(1.0,), scale=0.5, noise=0.1)\n"
        "def turning(readings, control):\n"
        "    return readings.angular_velocity_b[:, 2:]\n"
        "@terrain(size=4.0, hardest={'height': 0.02})\n"
        "def bump(grid, height: Annotated[float, Parameter('m')] = 0.01):\n"
        "    return height * grid.fade\n"
        "nudge = Randomization('nudge', lambda event, v: None, 0.3, 'm/s', interval=('nudge_interval', (1.0, 2.0)))\n"
    )
    config = TaskConfig(definition=load_task_file(file)).on_terrain("bump")
    assert config.command.height == (0.07, 0.09)
    assert (config.reward.weights.own, config.reward.size, config.reward.foot_lift) == (-2.0, 0.03, 0.006)
    assert (config.randomization.nudge, config.randomization.nudge_interval) == (0.3, (1.0, 2.0))
    assert config.randomization.noise_amplitude.turning == 0.1
    assert (config.ground.extent, config.terrain.height, config.ground.heights().max()) == ((4.0, 4.0), 0.01, 0.01)
    tiles = TaskConfig.from_dict({"terrain": {"name": "tiles", "kinds": ["bump", "steps"]}}, config.definition).ground
    assert [tiles.tile(kind, 10).max() for kind in (0, 1)] == pytest.approx([0.02, 0.0275])
    layout = ObservationLayout(ROBOT, config.definition.observations)
    assert layout.scale[layout.slices["turning"]] == 0.5
