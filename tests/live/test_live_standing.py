"""Getting up in physics, from every pose in which the robot went limp, lies or stands."""

import numpy as np
import pytest
import twelve_joints
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE
from live_bench import Loop
from scipy.spatial.transform import Rotation

from quadruped_env.control.joint_command import LIMP, limited
from quadruped_env.control.live_controller import Safety
from quadruped_env.control.stand_up import StandUp
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.robot import MINI_QUADRUPED

pytest.importorskip("cyclonedds")

PERIOD = 0.02
"""Period of the joint commands, s."""
SAFETY = Safety()


def plan(start):
    return StandUp.plan(MINI_QUADRUPED, np.asarray(start, dtype=np.float64), SAFETY.ramp_speed, SAFETY.min_ramp_time)


def sampled(stand_up):
    times = np.linspace(0.0, stand_up.duration, 2001)
    return times, np.array([stand_up.positions(time) for time in times])


def test_stand_up_from_upright_legs_leads_straight_to_the_stance():
    start = STANCE + np.array([0.3, -0.2] * 4)
    stand_up = plan(start)
    assert stand_up.duration == pytest.approx(1.0)
    _, positions = sampled(stand_up)
    np.testing.assert_array_equal(positions[0], start)
    np.testing.assert_allclose(stand_up.positions(0.5), (start + STANCE) / 2)
    np.testing.assert_allclose(positions[-1], STANCE)
    assert np.all(np.diff(positions, axis=0) * (STANCE - start) >= 0.0)
    np.testing.assert_array_equal(stand_up.positions(-1.0), start)
    np.testing.assert_allclose(stand_up.positions(99.0), STANCE)


def test_stand_up_in_the_stance_stays_there():
    stand_up = plan(STANCE)
    np.testing.assert_array_equal([stand_up.positions(time) for time in (0.0, 0.3, 1.0)], [STANCE] * 3)


def test_stand_up_of_legs_that_point_inward_moves_one_side_outward_and_then_the_other():
    """A robot on its nose: the fore legs point back under it; the left hind leg forward."""
    stand_up = plan([1.2, -0.1, 1.0, 0.0, 0.3, -1.2, 0.9, -0.1])
    lean = stand_up.points.reshape(-1, 4, 2).sum(axis=2)
    along = np.pi / 2
    np.testing.assert_allclose(
        lean[1:-1],
        [[along, along, -along, along], [-along, along, along, along], [-along, -along, along, along]],
        atol=0.13,
    )
    np.testing.assert_array_equal(stand_up.points[-1], STANCE)


@pytest.mark.parametrize("seed", range(5))
def test_stand_up_is_slow_from_rest_to_rest_and_within_the_range(seed):
    start = np.random.default_rng(seed).uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
    times, positions = sampled(plan(start))
    speeds = np.abs(np.diff(positions, axis=0)).max(axis=1) / times[1]
    assert speeds[[0, -1]].max() < 0.02
    assert speeds.max() <= 1.5 * SAFETY.ramp_speed + 1e-9
    np.testing.assert_array_equal(positions, np.clip(positions, JOINT_POSITION_LOW, JOINT_POSITION_HIGH))


def gets_up(robot):
    """True if it gets up from its current state without ever leaning by more than the controller allows."""
    own, safety = robot.robot, Safety.of(robot.robot)
    stand_up = StandUp.plan(own, robot.state.joint_position[0], safety.ramp_speed, safety.min_ramp_time)
    last, upright = stand_up.points[0], []
    for elapsed in np.arange(0.0, stand_up.duration + 1.0, PERIOD):
        last = limited(own, stand_up.positions(elapsed), last, PERIOD)
        robot.command(last)
        for _ in range(round(PERIOD / TIMESTEP)):
            robot.step()
            upright.append(robot.state.up_b[0, 2])
    height = robot.state.base_position[0, 2]
    return min(upright) > np.cos(1.0) and upright[-1] > 0.99 and abs(height / own.stance_height - 1.0) < 0.05


def test_robot_that_was_dropped_limp_in_any_leg_pose_gets_up():
    """Limp, with any joint positions, leaning by up to 0.5 rad each way; not on its back or flank."""
    rng = np.random.default_rng(0)
    robot, up = SimulatedRobot(), []
    while len(up) < 8:
        lean = Rotation.from_euler("xy", rng.uniform(-0.5, 0.5, 2)).as_quat(scalar_first=True)
        legs = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
        robot.reset()
        robot.put(np.concatenate([[0.0, 0.0, 0.25], lean, legs]))
        robot.command(LIMP)
        for _ in range(round(2.5 / TIMESTEP)):
            robot.step()
        if not robot.fallen:
            up.append(gets_up(robot))
    assert all(up)


@pytest.mark.parametrize("legs", ["stance", "ahead", "behind"])
def test_robot_with_three_joints_per_leg_gets_up_from_standing_and_from_its_front(legs):
    own = twelve_joints.robot()
    robot = SimulatedRobot(robot=own)
    pose = {"stance": (own.stance_height, 0.85, -1.7), "ahead": (0.08, -0.6, -1.8), "behind": (0.08, 2.2, -1.6)}
    height, thigh, shank = pose[legs]
    robot.put(np.array([0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0, *[0.0, thigh, shank] * 4]))
    robot.command(LIMP)
    for _ in range(round(2.5 / TIMESTEP)):
        robot.step()
    assert robot.state.base_position[0, 2] < 0.6 * own.stance_height, "it lies"
    assert gets_up(robot)


@pytest.mark.parametrize(
    "terrain", ["flat", *[pytest.param(name, marks=pytest.mark.slow) for name in ("rough", "hills")]]
)
def test_robot_that_went_limp_in_any_phase_of_its_step_gets_up(terrain):
    """The poses of the legs when it goes limp decide how it lies."""
    for phase in (0.0, 0.24):
        loop = Loop(terrain=terrain)
        loop.run(5.0 + phase, (0.5, 0.0))
        loop.run(3.0, commands=False)
        loop.restart_live_controller()
        _, upright = loop.run(9.0)
        assert upright.min() > np.cos(1.0), phase
        assert upright[-1] > 0.98, phase
