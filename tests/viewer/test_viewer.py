"""The viewer's controller without a browser: its clock, commands, gaits, sources and robots."""

import copy
import json
import math
import threading
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from viewing import DT, now, robot, throw_on_the_back

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, SinusoidalGait
from quadruped_env.control.policy import CARD_FILE
from quadruped_env.evaluation.episode import publish, record
from quadruped_env.gait_settings import GaitSettings, edited
from quadruped_env.policies import PolicyController, find_controllers, load_policy
from quadruped_env.robot import STANCE, TOTAL_MASS
from quadruped_env.viewer.controller import MAX_ROBOTS, RANDOMIZATIONS, RESTART_AFTER
from quadruped_env.viewer.plots import GAIT_SECONDS, gait_diagram, reward_bars
from quadruped_env.viewer.robot import Robot, contact_forces


@pytest.fixture
def recording(tmp_path):
    """A trot as a file."""
    path = tmp_path / "walk.csv"
    publish(SinusoidalGait.preset("trot"), 1.0, 50.0).save(path)
    return path


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
    assert controller.view().lag == pytest.approx(9.75)


def test_reset_zeroes_the_clock_and_puts_every_robot_at_the_start(control):
    controller = control("policy flat", "gait tuned")
    controller.set_command(0.5, 0.3)
    for _ in range(10):
        controller.advance(0.1)
    assert now(controller).base_pose[0] > 0.2
    controller.reset()
    view = controller.view()
    assert view.time == 0.0
    assert view.command == (0.5, 0.3)
    for shown in view.robots:
        assert shown.now.time == 0.0
        assert len(shown.history) == 1
        np.testing.assert_allclose(shown.now.base_pose, [0, 0, shown.now.base_pose[2], 1, 0, 0, 0], atol=1e-12)
        np.testing.assert_allclose(shown.now.joint_position, STANCE, atol=1e-12)


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
        np.testing.assert_array_equal(now(controller, index).command, [0.6, -0.8])
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


def test_the_commanded_gait_follows_the_command(control):
    controller = control("gait tuned")
    controller.set_command(-0.2, 0.0)
    for _ in range(100):
        controller.advance(0.04)
    assert now(controller).smooth_velocity[0] == pytest.approx(-0.2, abs=0.08)


# --- the gait


def test_an_edited_gait_is_the_formula(control):
    controller = control("gait article")
    controller.set_gait(GaitSettings(amplitude=0.5, frequency=1.0, phases=(0.0, 0.25, 0.5, 0.75)))
    targets = _targets(controller, 30)
    times = np.arange(30) * DT
    article = SinusoidalGait.preset("article")
    for leg, cycles in enumerate((0.0, 0.25, 0.5, 0.75)):
        angle = math.tau * (times + cycles)
        lag = article.phases[2 * leg + 1] - article.phases[2 * leg]
        np.testing.assert_allclose(targets[:, 2 * leg], 0.5 * 0.4 * np.sin(angle), atol=1e-12)
        np.testing.assert_allclose(targets[:, 2 * leg + 1], 0.5 * 0.3 * np.cos(angle + lag) - 0.3, atol=1e-12)


def _targets(controller, steps):
    """The joint targets (steps, 8) of the next control steps."""
    targets = []
    for _ in range(steps):
        controller.step()
        targets.append(robot(controller).data.ctrl.copy())
    return np.array(targets)


@pytest.mark.parametrize("preset", ["article", "trot", "walk", "bound", "pace"])
def test_gait_without_edits_is_the_preset(control, preset):
    controller = control(f"gait {preset}")
    gait = SinusoidalGait.preset(preset)
    np.testing.assert_allclose(_targets(controller, 40), gait.positions(np.arange(40) * DT), atol=1e-9)
    same = edited(gait, GaitSettings.of(preset))
    np.testing.assert_allclose(same.velocities(0.3), gait.velocities(0.3), atol=1e-9)


def test_gait_with_another_frequency_keeps_its_phase(control):
    controller = control("gait trot")
    before = _targets(controller, 33)
    gait = controller.gait
    controller.set_gait(GaitSettings(gait.amplitude, gait.frequency / 2, gait.phases))
    after = _targets(controller, 2)
    # No joint target changes by more than the joint's speed allows within a step.
    assert np.abs(after[0] - before[-1]).max() <= 5.0 * DT
    assert np.abs(after[1] - after[0]).max() < np.abs(np.diff(before, axis=0)).max()


def test_invalid_gait_settings_are_refused(control):
    controller = control("policy flat")
    assert controller.gait is None
    with pytest.raises(QuadrupedError, match="no scripted gait"):
        controller.set_gait(GaitSettings.of("trot"))
    with pytest.raises(QuadrupedError, match=r"frequency must be in 0\.1 to 4; found 0"):
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


def test_fallen_robot_that_is_not_restarted_stays_down(control):
    controller = control("stand still")
    controller.restart_after_fall = False
    throw_on_the_back(controller)
    for _ in range(20):
        controller.advance(0.2)
    assert controller.view().robots[0].fell_at is not None


def test_the_ground_carries_the_weight(control):
    controller = control("stand still")
    for _ in range(20):
        controller.advance(0.1)
    shown = robot(controller)
    points, forces = contact_forces(shown.model, copy.copy(shown.data))
    np.testing.assert_allclose(forces.sum(axis=0), [0.0, 0.0, TOTAL_MASS * 9.81], atol=0.02)
    assert len(points) >= 4
    assert np.abs(points[:, 2]).max() < 0.005


# --- sources


def test_every_source_plays(control, recording):
    controller = control(asked=[str(recording)])
    assert len(controller.sources) == 9
    for name in controller.sources:
        controller.set_source(0, name)
        controller.set_command(0.3, 0.0)
        for _ in range(10):
            controller.advance(0.1)
        assert controller.robots == (name,)
        assert now(controller).time == pytest.approx(1.0)
        assert np.isfinite(now(controller).joint_position).all()


def test_a_recording_is_played_in_a_loop(control, recording):
    controller = control(asked=[str(recording)])
    trajectory = JointTrajectory.load(recording)
    targets = _targets(controller, 60)
    np.testing.assert_allclose(targets[:51], trajectory.positions, atol=1e-12)
    np.testing.assert_allclose(targets[51:60], trajectory.positions[:9], atol=1e-12)


def test_without_runs_the_shipped_policy_walks_and_with_them_the_latest_that_fits(tmp_path):
    runs = tmp_path / "runs"
    assert find_controllers(runs=runs)[1] == ("policy flat",)
    load_policy("flat").save(runs / "20260101-000000-old")
    load_policy("flat").save(runs / "20260301-000000-new")
    broken = runs / "20260401-000000-broken"
    load_policy("flat").save(broken)
    (broken / CARD_FILE).write_text("{")
    (runs / "latest").symlink_to(broken.name)
    sources, chosen = find_controllers(runs=runs)
    assert chosen == ("run 20260301-000000-new",)
    assert [name for name in sources if name.startswith("run")] == [
        "run 20260401-000000-broken",
        "run 20260301-000000-new",
        "run 20260101-000000-old",
    ]


@pytest.fixture
def foreign_run(tmp_path):
    """A run whose policy sees other columns than this environment gives."""
    directory = tmp_path / "runs" / "foreign"
    load_policy("flat").save(directory)
    document = json.loads((directory / CARD_FILE).read_text())
    document["observation_layout"] = document["observation_layout"][:-1]
    (directory / CARD_FILE).write_text(json.dumps(document))
    return directory


def test_a_run_that_does_not_match_is_refused_and_nothing_changes(control, foreign_run):
    with pytest.raises(QuadrupedError, match=rf"{CARD_FILE}: observation_layout differs"):
        find_controllers([str(foreign_run)])
    controller = control()
    assert controller.robots == ("policy flat",)
    with pytest.raises(QuadrupedError, match="observation_layout differs"):
        controller.set_source(0, "run foreign")
    assert controller.robots == ("policy flat",)
    assert controller.advance(DT) == 1


def test_a_recording_of_another_robot_is_refused(tmp_path):
    path = tmp_path / "other.csv"
    JointTrajectory([0, 1], [*JOINT_NAMES[:-1], "tail_joint"], np.zeros((2, 8))).save(path)
    with pytest.raises(QuadrupedError, match=r"other\.csv: joint 'RH_knee_joint' is missing"):
        find_controllers([str(path)])
    with pytest.raises(QuadrupedError, match="nowhere"):
        find_controllers([str(tmp_path / "nowhere.csv")])


def test_robots_can_be_added_and_removed(control):
    controller = control("policy flat")
    controller.set_source(1, "gait trot")
    controller.set_source(2, "gait pace")
    assert controller.robots == ("policy flat", "gait trot", "gait pace")
    with pytest.raises(QuadrupedError, match=f"up to {MAX_ROBOTS}"):
        controller.set_source(3, "gait walk")
    with pytest.raises(QuadrupedError, match="there is no 'nobody'"):
        controller.set_source(1, "nobody")
    controller.watch(2)
    controller.set_source(1, None)
    assert controller.robots == ("policy flat", "gait pace")
    assert controller.view().watched == 1
    with pytest.raises(QuadrupedError, match="robot 1"):
        controller.set_source(0, None)
    with pytest.raises(QuadrupedError, match="robot 3: there are 2"):
        controller.watch(2)
    with pytest.raises(QuadrupedError, match="1 to 3 robots; found 4"):
        control(*["stand still"] * 4)


def test_robots_side_by_side_share_time_and_command(control):
    controller = control("policy flat")
    controller.set_command(0.4, 0.1)
    controller.advance(0.2)
    controller.set_source(1, "policy flat")
    controller.advance(0.2)
    first, second = controller.view().robots
    assert first.now.time == pytest.approx(0.4)
    assert second.now.time == pytest.approx(0.2)
    np.testing.assert_array_equal(second.now.command, [0.4, 0.1])
    controller.reset()
    for _ in range(5):
        controller.advance(0.2)
    first, second = controller.view().robots
    np.testing.assert_array_equal(first.now.base_pose, second.now.base_pose)


@pytest.mark.parametrize("name", RANDOMIZATIONS)
def test_randomization_of_starts_is_the_chosen_one(control, name):
    controller = control("policy flat", "policy flat")
    controller.set_randomization(name)
    starts = []
    for _ in range(2):
        controller.reset()
        first, second = controller.view().robots
        np.testing.assert_array_equal(first.now.joint_position, second.now.joint_position)
        assert abs(first.heading) < 1e-9
        starts.append(first.now.joint_position)
    assert (name == "off") == np.array_equal(*starts)
    with pytest.raises(QuadrupedError, match="there is no 'everything'"):
        controller.set_randomization("everything")


def test_turning_the_start_ahead_keeps_the_motion(control):
    controller = control("policy flat")
    controller.set_randomization("start")
    controller.reset()
    seed = controller._seed
    plain = robot(controller)
    velocity = now(controller).velocity.copy()
    plain.task.reset(np.zeros(1, np.intp), seeds=[seed], command=(0.0, 0.0))
    state = plain.task.simulation.readings
    # Forward velocity and yaw rate are the robot's own, whichever way it faces.
    np.testing.assert_allclose(velocity, [state.linear_velocity_b[0, 0], state.angular_velocity_b[0, 2]], atol=1e-12)


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
    assert controller.command == tuple(robot(controller).task.command[0])


# --- plots


def test_the_gait_diagram_shows_each_stance_once():
    robot = Robot(find_controllers(runs=Path("nowhere"))[0]["stand still"])
    moments = []
    contact = np.zeros((100, 4), bool)
    contact[10:30, 0] = contact[50:60, 0] = contact[90:, 0] = contact[:, 3] = True
    for row in contact:
        moment = robot.step()
        moments.append(type(moment)(**{f: getattr(moment, f) for f in moment.__slots__} | {"contact": row}))
    html = gait_diagram(moments, DT)
    svg = ElementTree.fromstring(html[html.index("<svg") :])  # noqa: S314
    bars = [node for node in svg.iter("rect") if node.get("fill") != "#EEF1F4"]
    right, scale = 360, 330 / GAIT_SECONDS
    assert [float(bar.get("width")) for bar in bars] == [
        pytest.approx(n * DT * scale, abs=0.06) for n in (20, 10, 10, 100)
    ]
    assert float(bars[0].get("x")) == pytest.approx(right - 90 * DT * scale, abs=0.06)
    assert [node.text for node in svg.iter("text")][:4] == ["LF", "RF", "LH", "RH"]


def test_the_reward_bars_add_up():
    html = reward_bars(["track_forward_velocity", "fall"], np.array([1.5, -0.25]))
    table = ElementTree.fromstring(html[html.index("<table") :])  # noqa: S314
    assert [[cell.text for cell in row][::2] for row in table] == [
        ["track forward velocity", "+1.50"],
        ["fall", "-0.25"],
        ["sum", "+1.25"],
    ]
