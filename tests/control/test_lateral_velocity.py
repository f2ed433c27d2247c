"""The lateral velocity: the third command of robots whose legs move their feet sideways."""

import gymnasium
import numpy as np
import pytest
from twelve_joints import ROBOT

from quadruped_env.control import ControlInterface, ObservationLayout
from quadruped_env.control.control_config import COMMANDS, ControlConfig, velocity_commands
from quadruped_env.control.velocity_command import check_command, moving_threshold
from quadruped_env.envs import ENV_ID
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.units import scale_of

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


def test_roll_joints_turn_the_other_way_under_the_mirror():
    np.testing.assert_array_equal(ROBOT.joint_signs, [-1.0, 1.0, 1.0] * 4)


def test_lateral_velocity_approaches_at_its_own_rate():
    config = ControlConfig.of_robot(ROBOT)
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
    control = ControlInterface(ROBOT, ControlConfig.of_robot(ROBOT), 2)
    least = moving_threshold(ROBOT)[2]
    control.reset(np.arange(2), command=np.array([[0.0, 0.0, 0.99 * least], [0.0, 0.0, -1.01 * least]]))
    np.testing.assert_array_equal(control.moving, [0.0, 1.0])


@pytest.mark.parametrize(("given", "full"), [((0.1, 0.2), (0.1, 0.2, 0.0)), ((0.1, 0.2, -0.1), (0.1, 0.2, -0.1))])
def test_a_fixed_command_may_leave_the_lateral_velocity_out(given, full):
    np.testing.assert_array_equal(check_command(given, velocity_commands(ROBOT)), full)


def test_twelve_joints_walk_in_position_mode():
    env = gymnasium.make(ENV_ID, robot=ROBOT, config={"action": {"mode": "position"}})
    env.reset(seed=0, options={"command": (0.2, 0.1, -0.1)})
    for _ in range(50):
        observation, *_, info = env.step(np.zeros(12))
    np.testing.assert_array_equal(info["command"], [0.2, 0.1, -0.1])
    scale = 4.0 / np.array([scale_of(unit, ROBOT) for unit in ("m/s", "rad/s", "m/s")])
    columns = ObservationLayout(ROBOT).slices["command"]
    np.testing.assert_allclose(observation[columns], scale * [0.2, 0.1, -0.1], rtol=1e-6)
