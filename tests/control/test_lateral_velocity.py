"""The lateral velocity: the third command of robots whose legs move their feet sideways."""

import dataclasses

import gymnasium
import half_robot
import mujoco
import numpy as np
import pytest
from twelve_joints import ROBOT

from quadruped_env.control.control_config import COMMANDS, ControlConfig, velocity_commands
from quadruped_env.control.control_interface import ControlInterface
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.steering import key_steps
from quadruped_env.control.velocity_command import check_command, moving_threshold
from quadruped_env.envs import ENV_ID
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.units import scale_of
from quadruped_env.task import TaskConfig, load_task_file

ENV = np.zeros(1, dtype=np.intp)


def test_only_robots_with_roll_joints_move_sideways():
    assert (ROBOT.moves_sideways, MINI_QUADRUPED.moves_sideways) == (True, False)
    assert velocity_commands(MINI_QUADRUPED) == COMMANDS
    names = [entry.name for entry in velocity_commands(ROBOT)]
    assert names == ["forward_velocity", "yaw_rate", "lateral_velocity"]
    left = 0.2 * scale_of("m/s", ROBOT)
    np.testing.assert_allclose(velocity_commands(ROBOT)[2].range, (-left, left), rtol=1e-5)
    np.testing.assert_array_equal(
        np.argsort(ROBOT.corners), [ROBOT.leg_names.index(x) for x in ("LF", "RF", "LH", "RH")]
    )


def turned(robot, axes):
    """The robot with other axes of some joints, by name."""
    spec = mujoco.MjSpec.from_string(robot.mjcf)
    for name, axis in axes.items():
        spec.joint(name).axis = axis
    return dataclasses.replace(robot, mjcf=spec.to_xml(), stance_height=None)


@pytest.mark.parametrize(
    ("robot", "axes"),
    [
        (ROBOT, dict.fromkeys(("RH_roll", "LH_roll"), (0.0, 1.0, 0.0))),
        (MINI_QUADRUPED, dict.fromkeys(MINI_QUADRUPED.joint_names[::2], (1.0, 0.0, 0.0))),
    ],
    ids=["fore legs alone", "two joints"],
)
def test_robots_with_some_legs_that_roll_or_without_a_third_joint_do_not_move_sideways(robot, axes):
    assert not turned(robot, axes).moves_sideways


def test_roll_joints_turn_the_other_way_under_the_mirror():
    np.testing.assert_array_equal(ROBOT.joint_signs, [-1.0, 1.0, 1.0] * 4)


def test_lateral_velocity_approaches_at_its_own_rate():
    config = ControlConfig.of_task({}, ROBOT)
    assert config.num_velocities == 3
    # One m/s^2 has no size: lengths grow as squared times.
    np.testing.assert_allclose(config.command_rate, [1.0, 4.0 * scale_of("rad/s^2", ROBOT), 1.0], rtol=1e-5)
    control = ControlInterface(ROBOT, config)
    control.set_command(ENV, np.array([[0.0, 0.0, 0.05]]))
    found = []
    for _ in range(4):
        control.approach_requested()
        found.append(control.command[0].tolist())
    np.testing.assert_allclose(found, [[0.0, 0.0, v] for v in (0.02, 0.04, 0.05, 0.05)])


def test_a_lateral_velocity_alone_starts_the_gait_clock():
    control = ControlInterface(ROBOT, ControlConfig.of_task({}, ROBOT), 2)
    least = moving_threshold(ROBOT)[2]
    control.reset(np.arange(2), command=np.array([[0.0, 0.0, 0.99 * least], [0.0, 0.0, -1.01 * least]]))
    np.testing.assert_array_equal(control.moving, [0.0, 1.0])


@pytest.mark.parametrize(("given", "full"), [((0.1, 0.2), (0.1, 0.2, 0.0)), ((0.1, 0.2, -0.1), (0.1, 0.2, -0.1))])
def test_a_fixed_command_may_leave_the_lateral_velocity_out(given, full):
    np.testing.assert_array_equal(check_command(given, velocity_commands(ROBOT)), full)


def test_a_step_observes_and_pays_the_lateral_velocity():
    """By hand: the smoothed velocity from those in `info`, and the kernel about the command."""
    env = gymnasium.make(ENV_ID, robot=ROBOT, config={"action": {"mode": "position"}})
    env.reset(seed=0, options={"command": (0.2, 0.1, -0.1)})
    rng, smooth = np.random.default_rng(0), 0.0
    size, gain = scale_of("m/s", ROBOT), 1.0 - np.exp(-0.02 / (0.4 * scale_of("s", ROBOT)))
    for _ in range(20):
        observation, *_, info = env.step(0.3 * rng.standard_normal(12))
        _, sideways, up = info["base_linear_velocity"]
        roll, pitch, _ = info["base_angular_velocity"]
        smooth += gain * (sideways - smooth)
        kernel = np.exp(-(((smooth + 0.1) / (0.07 * size)) ** 2))
        assert info["reward_track_lateral_velocity"] == pytest.approx(0.02 * 9.0 * kernel, rel=1e-4)
        # Less than 0.1 m/s in units of the robot is paid in proportion.
        whole = 0.1 / max(0.1, 0.1 * size)
        share = -smooth / (0.1 * size)
        progress = max(share - 2.0 * max(share - whole, 0.0), -1.0)
        assert info["reward_lateral_progress"] == pytest.approx(0.02 * 9.0 * progress, rel=1e-4)
        motion = (sideways + 0.1) ** 2 + up**2 + (0.2 * scale_of("m", ROBOT)) ** 2 * (roll**2 + pitch**2)
        assert info["reward_base_motion"] == pytest.approx(-0.02 * 2.0 / size**2 * motion, rel=1e-4)
    np.testing.assert_array_equal(info["command"], [0.2, 0.1, -0.1])
    scale = 4.0 / np.array([scale_of(unit, ROBOT) for unit in ("m/s", "rad/s", "m/s")])
    columns = ObservationLayout(ROBOT).slices["command"]
    np.testing.assert_allclose(observation[columns], scale * [0.2, 0.1, -0.1], rtol=1e-6)


def test_config_of_a_robot_that_moves_sideways_has_more_fields():
    config, other = (TaskConfig().for_robot(robot).to_dict() for robot in (ROBOT, half_robot.ROBOT))
    added = {section: set(config[section]) - set(other[section]) for section in ("command", "reward")}
    assert added == {
        "command": {"lateral_velocity", "lateral_acceleration", "sideways_fraction"},
        "reward": {"lateral_velocity_std"},
    }
    weights = (set(one["reward"]["weights"]) for one in (config, other))
    assert set.difference(*weights) == {"track_lateral_velocity", "lateral_progress"}
    assert (config["command"]["lateral_acceleration"], config["command"]["sideways_fraction"]) == (1.0, 0.15)


def test_layout_and_keys_have_the_lateral_velocity_in_its_units():
    entry = next(one for one in ObservationLayout(ROBOT).document() if one["name"] == "command")
    assert (entry["width"], entry["unit"]) == (3, "m/s, rad/s, m/s")
    metres, turns = scale_of("m/s", ROBOT), scale_of("rad/s", ROBOT)
    np.testing.assert_allclose(key_steps(ROBOT), [0.1 * metres, 0.2 * turns, 0.1 * metres], rtol=0.5)
    assert key_steps(ROBOT)[0] == key_steps(ROBOT)[2]


def test_a_task_file_may_replace_the_lateral_velocity(tmp_path):
    file = tmp_path / "task.py"
    file.write_text(
        "from twelve_joints import ROBOT\n"
        "from quadruped_env.task import Command\n"
        "height = Command('height', 'm', (0.1, 0.2), 0.15)\n"
        "sideways = Command('lateral_velocity', 'm/s', (-0.05, 0.1))\n"
    )
    task = TaskConfig(definition=load_task_file(file))
    assert [entry.name for entry in task.commands] == ["forward_velocity", "yaw_rate", "lateral_velocity", "height"]
    assert task.commands[2].range == (-0.05, 0.1)
    assert task.control.num_velocities == 3
    np.testing.assert_array_equal(check_command((0.1, 0.2), task.commands), [0.1, 0.2, 0.0, 0.15])
    assert ControlConfig.of_task(task.to_dict(), ROBOT, task.definition.commands) == task.control
