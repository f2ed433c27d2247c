"""The viewer's controller without a browser: its clock, commands, gaits, pushes and threads."""

import math
import threading

import numpy as np
import pytest
from viewing import DT, joint_targets, now, robot, throw_on_the_back

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.evaluation.recorded_episode import record
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.policies import PolicyController, load_policy
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.viewer.view_controller import RESTART_AFTER

# --- the clock


@pytest.mark.parametrize(("speed", "steps"), [(1.0, 50), (0.5, 25), (2.0, 100)])
def test_a_second_of_real_time_is_a_second_times_the_speed(control, speed, steps):
    controller = control("stand still")
    controller.set_speed(speed)
    # In pieces that are not whole numbers of steps.
    assert sum(controller.advance(1.0 / 30.0) for _ in range(30)) == steps
    assert controller.view().time == pytest.approx(speed)
    assert now(controller).time == pytest.approx(speed)


def test_pause_stops_the_clock_and_a_step_is_one_control_step(control):
    controller = control("policy flat")
    controller.advance(0.1)
    assert controller.toggle_pause()
    before = now(controller)
    assert controller.advance(5.0) == 0
    np.testing.assert_array_equal(now(controller).base_pose, before.base_pose)
    controller.step()
    assert now(controller).time == pytest.approx(before.time + DT)
    assert controller.paused
    assert not controller.toggle_pause()
    assert controller.advance(DT) == 1


def test_long_delay_is_caught_up_with_only_in_part(control):
    controller = control("stand still")
    assert controller.advance(10.0) == pytest.approx(0.25 / DT, abs=1)


def test_reset_zeroes_the_clock_and_puts_every_robot_at_the_start(control):
    controller = control("policy flat", "gait tuned")
    controller.set_command(0.5, 0.3)
    for _ in range(10):
        controller.advance(0.1)
    assert now(controller).base_pose[0] > 0.1
    controller.reset()
    view = controller.view()
    assert view.time == 0.0
    assert controller.command == (0.5, 0.3)
    for shown in view.robots:
        assert shown.now.time == 0.0
        assert len(shown.history) == 1
        np.testing.assert_allclose(shown.now.base_pose, [0, 0, shown.now.base_pose[2], 1, 0, 0, 0], atol=1e-12)
        np.testing.assert_allclose(shown.now.joint_position, MINI_QUADRUPED.stance, atol=1e-12)


def test_robot_walks_as_far_as_in_a_recording_of_the_same_policy(control):
    controller = control("policy flat")
    controller.set_command(0.4, 0.0)
    controller.reset()
    for _ in range(50):
        controller.advance(0.04)
    # The gait clock begins at another phase, so the two are similar, not equal.
    expected = record(PolicyController(load_policy("flat")), 2.0, (0.4, 0.0)).base_pose[-1, 0]
    assert now(controller).base_pose[0] == pytest.approx(expected, abs=0.1)
    assert expected > 0.5


# --- the command


def test_a_command_reaches_every_robot_cut_to_its_range(control):
    controller = control("policy flat", "gait tuned")
    assert controller.set_command(0.3, -0.2) == (0.3, -0.2)
    assert controller.set_command(99.0, -99.0) == (0.6, -0.8)
    for shown in controller.view().robots:
        np.testing.assert_array_equal(shown.now.command if shown.now.time else [0.6, -0.8], [0.6, -0.8])
    controller.advance(DT)
    for index in range(2):
        # The request is shown at once; the command that acts approaches it.
        np.testing.assert_array_equal(now(controller, index).command, [0.6, -0.8])
        np.testing.assert_allclose(robot(controller, index).task.command, [[0.02, -0.08]], atol=1e-12)
    with pytest.raises(QuadrupedError, match="finite"):
        controller.set_command(math.nan, 0.0)
    assert controller.command == (0.6, -0.8)


def test_keys_go_in_whole_steps_and_stop_at_the_range(control):
    controller = control("stand still")
    controller.set_command(0.37, 0.0)
    assert controller.nudge(1, 0) == (0.5, 0.0)
    assert controller.nudge(0, -1) == (0.5, -0.2)
    assert controller.nudge(-5, 1) == (0.0, 0.0)
    for _ in range(20):
        controller.nudge(1, 1)
    assert controller.command == (0.6, 0.8)


# --- the gait


def test_an_edited_gait_is_the_formula(control):
    controller = control("gait article")
    controller.set_gait(GaitSettings(amplitude=0.5, frequency=1.0, phases=(0.0, 0.25, 0.5, 0.75)))
    targets = joint_targets(controller, 30)
    times = np.arange(30) * DT
    article = SinusoidalGait.preset("article")
    for leg, cycles in enumerate((0.0, 0.25, 0.5, 0.75)):
        angle = math.tau * (times + cycles)
        lag = article.phases[2 * leg + 1] - article.phases[2 * leg]
        np.testing.assert_allclose(targets[:, 2 * leg], 0.5 * 0.4 * np.sin(angle), atol=1e-12)
        np.testing.assert_allclose(targets[:, 2 * leg + 1], 0.5 * 0.3 * np.cos(angle + lag) - 0.3, atol=1e-12)


@pytest.mark.parametrize("preset", ["article", "trot", "walk", "bound", "pace"])
def test_gait_without_edits_is_the_preset(control, preset):
    controller = control(f"gait {preset}")
    gait = SinusoidalGait.preset(preset)
    np.testing.assert_allclose(joint_targets(controller, 40), gait.positions(np.arange(40) * DT), atol=1e-9)
    same = edited(gait, GaitSettings.of(SinusoidalGait.preset(preset)))
    np.testing.assert_allclose(same.velocities(0.3), gait.velocities(0.3), atol=1e-9)


def test_gait_with_another_frequency_keeps_its_phase(control):
    controller = control("gait trot")
    before = joint_targets(controller, 33)
    gait = controller.gait
    controller.set_gait(GaitSettings(gait.amplitude, gait.frequency / 2, gait.phases))
    after = joint_targets(controller, 2)
    # No joint target changes by more than the joint's speed allows within a step.
    assert np.abs(after[0] - before[-1]).max() <= 5.0 * DT
    assert np.abs(after[1] - after[0]).max() < np.abs(np.diff(before, axis=0)).max()


def test_invalid_gait_settings_are_refused(control):
    controller = control("policy flat")
    assert controller.gait is None
    with pytest.raises(QuadrupedError, match="no scripted gait"):
        controller.set_gait(GaitSettings.of(SinusoidalGait.preset("trot")))
    with pytest.raises(QuadrupedError, match=r"frequency must be in \[0\.1, 6\] \(Hz\); found 0"):
        GaitSettings(1.0, 0.0, (0.0,) * 4)
    with pytest.raises(QuadrupedError, match="4 finite numbers"):
        GaitSettings(1.0, 1.0, (0.0, math.nan, 0.0, 0.0))


def test_gait_beyond_the_motors_is_reported(control):
    controller = control("gait trot")
    assert not controller.view().robots[0].complaints
    gait = controller.gait
    controller.set_gait(GaitSettings(2.0, 4.0, gait.phases))
    controller.step()
    assert any("rad/s is over 5 rad/s" in complaint for complaint in controller.view().robots[0].complaints)


# --- pushes, falls, forces


@pytest.mark.parametrize("heading", [0.0, 2.0])
@pytest.mark.parametrize(("direction", "expected"), [(0.0, (0.7, 0.0)), (math.pi / 2, (0.0, 0.7))])
def test_a_push_changes_the_velocity_as_the_robot_faces(control, heading, direction, expected):
    controller = control("stand still")
    data = robot(controller).data
    data.qpos[3:7] = [math.cos(heading / 2), 0.0, 0.0, math.sin(heading / 2)]
    before = data.qvel.copy()
    controller.push(direction, 0.7)
    gained = (data.qvel - before)[:3]
    c, s = math.cos(heading), math.sin(heading)
    turned = [c * expected[0] - s * expected[1], s * expected[0] + c * expected[1], 0.0]
    np.testing.assert_allclose(gained, turned, atol=1e-12)
    np.testing.assert_array_equal(data.qvel[3:], before[3:])


def test_pushes_in_a_pause_add_up_to_a_limit(control):
    controller = control("stand still")
    controller.paused = True
    for _ in range(3):
        controller.push(0.0, 9.0)  # at most 1.5 m/s each
    with pytest.raises(QuadrupedError, match=r"push: \[1.5, 0.0\] m/s and .* add up to 6 m/s"):
        controller.push(0.0, 1.5)
    assert robot(controller).data.qvel[0] == pytest.approx(4.5)
    controller.reset()
    controller.push(0.0, 1.5)


def test_a_fallen_robot_lies_for_a_while_and_stands_up_again(control):
    controller = control("gait trot", "stand still")
    controller.advance(0.2)
    throw_on_the_back(controller)
    controller.step()
    assert now(controller).time > 0.0
    assert controller.view().robots[0].fell_at is not None
    assert controller.view().robots[1].fell_at is None
    controller.paused = False
    for _ in range(round(RESTART_AFTER / 0.2) + 1):
        controller.advance(0.2)
    first, second = controller.view().robots
    assert first.fell_at is None
    assert first.now.time < 0.3
    assert second.now.time == pytest.approx(controller.view().time)


def test_the_ground_carries_the_weight(control):
    controller = control("stand still")
    for _ in range(20):
        controller.advance(0.1)
    points, forces = robot(controller).contact_forces()
    np.testing.assert_allclose(forces.sum(axis=0), [0.0, 0.0, MINI_QUADRUPED.total_mass * 9.81], atol=0.02)
    assert len(points) >= 4
    assert np.abs(points[:, 2]).max() < 0.005


# --- threads


def test_controller_can_be_used_from_any_thread(control):
    controller = control("policy flat", "gait tuned")
    stop = threading.Event()
    failures = []

    def call_at_random(index):
        generator = np.random.default_rng(index)
        try:
            while not stop.is_set():
                controller.set_command(*generator.uniform(-0.3, 0.6, 2))
                controller.push(generator.uniform(-3, 3), 0.2)
                controller.set_source(1, ("gait trot", "gait tuned", "stand still")[generator.integers(3)])
                controller.toggle_pause()
                controller.toggle_pause()
                controller.reset()
                assert len(controller.view().robots) == 2
        except Exception as error:
            failures.append(error)

    threads = [threading.Thread(target=call_at_random, args=(i,)) for i in range(3)]
    for thread in threads:
        thread.start()
    for _ in range(60):
        controller.paused = False
        controller.advance(0.02)
    stop.set()
    for thread in threads:
        thread.join()
    assert not failures
    assert controller.command == tuple(robot(controller).task.control.requested[0])
