"""The viewer's sources and robots: policies, gaits, recordings and runs, side by side."""

import json

import numpy as np
import pytest
from viewing import DT, joint_targets, now, robot

from quadruped_env import JointTrajectory, QuadrupedError, SinusoidalGait
from quadruped_env.evaluation.recorded_episode import publish
from quadruped_env.gait import PRESETS
from quadruped_env.policies import find_controllers, load_policy
from quadruped_env.policies.files import SHIPPED
from quadruped_env.policies.policy_data import CARD_FILE
from quadruped_env.viewer.view_controller import MAX_ROBOTS
from quadruped_env.viewer.viewed_robot import RANDOMIZATIONS


@pytest.fixture
def recording(tmp_path):
    """A trot as a file."""
    path = tmp_path / "walk.csv"
    publish(SinusoidalGait.preset("trot"), 1.0, 50.0).save(path)
    return path


def test_every_source_plays(control, recording):
    controller = control(asked=[str(recording)])
    assert len(controller.sources) == 2 + len(PRESETS) + len(SHIPPED)
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
    targets = joint_targets(controller, 60)
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
    with pytest.raises(QuadrupedError, match="policy flat: the first robot cannot be removed"):
        controller.set_source(0, None)
    with pytest.raises(QuadrupedError, match="expected an index of 0 to 1; found 2"):
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


def test_contact_is_shown_for_the_feet_on_the_ground(control):
    controller = control("policy flat")
    controller.set_command(0.4, 0.0)
    seen = []
    for _ in range(50):
        controller.advance(DT)
        force = robot(controller).task.simulation.readings.foot_force[0]
        np.testing.assert_array_equal(now(controller).contact, force > 1.0)
        seen.append(now(controller).contact)
    assert (np.any(seen, axis=0) & ~np.all(seen, axis=0)).all(), "every foot is on the ground and in the air"
