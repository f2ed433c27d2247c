"""The published gait, changed while it runs: by messages, by the viewer, and in the browser."""

from dataclasses import replace

import numpy as np
import pytest
from live_nodes import joint_state, usable
from waiting import wait_until

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.gait.gait_settings import GaitSettings, edited
from quadruped_env.live.live_robot import NAME, LiveRobot
from quadruped_env.live.messages.joint_messages import JointReader
from quadruped_env.live.messages.steering_messages import read_settings, settings_message
from quadruped_env.live.middleware.topics import CMD_VEL, GAIT, GAIT_SETTINGS, JOINT_STATES, ODOMETRY, PUSH
from quadruped_env.live.nodes.gait import AdjustableGait
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr
from quadruped_env.viewer import ViewController
from quadruped_env.viewer.panel_text import status_html
from quadruped_env.viewer.viewed_robot import Offered

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

CHANGED = GaitSettings(0.5, 1.25, (0.0, 0.25, 0.5, 0.75))


def test_adjustable_gait_unchanged_is_the_preset():
    gait, preset = AdjustableGait("article", MINI_QUADRUPED), SinusoidalGait.preset("article")
    for t in (0.0, 0.05, 123.45):
        np.testing.assert_array_equal(gait.positions(t), preset.positions(t))
        np.testing.assert_array_equal(gait.velocities(t), preset.velocities(t))


def test_adjustable_gait_with_another_frequency_keeps_its_phase():
    gait = AdjustableGait("walk", MINI_QUADRUPED)
    for t, frequency in ((3.3, 2.0), (4.7, 0.3), (5.1, 1.0)):
        before = gait.positions(t)
        gait.change(GaitSettings(1.0, frequency, gait.settings.phases), t)
        np.testing.assert_allclose(gait.positions(t), before, atol=1e-9)
        numeric = (gait.positions(t + 1e-6) - gait.positions(t - 1e-6)) / 2e-6
        np.testing.assert_allclose(gait.velocities(t), numeric, atol=1e-5)


def test_settings_are_read_as_they_are_written():
    assert read_settings(settings_message(CHANGED), MINI_QUADRUPED) == CHANGED


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ([], "holds 0 numbers; send 6: amplitude"),
        ([1.0] * 7, "holds 7 numbers; send 6: amplitude"),
        ([9.0, 1.0, 0.0, 0.0, 0.0, 0.0], r"amplitude must be in \[0, 2\]; found 9"),
        ([np.nan, 1.0, 0.0, 0.0, 0.0, 0.0], "amplitude: expected a number .*found nan"),
        ([1.0, 0.0, 0.0, 0.0, 0.0, 0.0], r"frequency must be in \[0.1, 6\] \(Hz\); found 0"),
        ([1.0, 1.0, np.inf, 0.0, 0.0, 0.0], "phases must be 4 finite numbers"),
    ],
)
def test_invalid_settings_are_refused(data, words):
    with pytest.raises(QuadrupedError, match=words):
        read_settings(cdr.message(GAIT.type_name, data=data), MINI_QUADRUPED)


def test_gait_node_applies_settings_and_publishes_them(run_node, nodes):
    node = nodes()
    states = node.subscribe(JOINT_STATES, Qos(1000), read=JointReader(MINI_QUADRUPED))
    actual, wanted = node.subscribe(GAIT_SETTINGS, read=lambda data: data), node.publish(GAIT)
    gait = run_node("gait")
    found = []

    def published():
        found.extend(read_settings(cdr.deserialize(one.data, GAIT.type_name), MINI_QUADRUPED) for one in actual.take())
        return found

    wait_until(published, alive=gait)
    assert found == [GaitSettings.of(SinusoidalGait.preset("article"))]
    wait_until(lambda: wanted.readers, alive=gait)
    wanted.send(cdr.message(GAIT.type_name, data=[1.0]))
    wait_until(lambda: "refused: /gait: holds 1 numbers; send 6" in gait.said, lambda: gait.said, alive=gait)
    wanted.send(settings_message(CHANGED))
    wait_until(lambda: published()[-1] == CHANGED, alive=gait)
    states.take()
    received = []
    wait_until(lambda: received.extend(states.messages(pytest.fail)) or len(received) > 25, alive=gait)
    assert gait.interrupt() == 0
    # The first ones may have been sent before the change.
    received = received[5:]
    # The phase of the change is not known here: it is fitted to the first state.
    changed = edited(SinusoidalGait.preset("article"), CHANGED)
    times = 1e-9 * (np.array([one.stamp for _, one in received]) - received[0][1].stamp)
    candidates = np.linspace(0.0, 1.0 / CHANGED.frequency, 8001)
    errors = [np.abs(changed.positions(at) - received[0][1].positions).max() for at in candidates]
    at = candidates[int(np.argmin(errors))]
    positions = [one.positions for _, one in received]
    np.testing.assert_allclose(positions, changed.positions(at + times), atol=2e-3)


def test_viewer_offers_the_controls_that_a_node_subscribes_to(nodes, tmp_path):
    robot, live = nodes("robot"), LiveRobot(nodes("viewer"), MINI_QUADRUPED)
    show = ViewController({NAME: lambda: live}, [NAME], tmp_path)
    nothing = Offered(command=False, push=False, sources=False, motion=False)
    assert live.offered() == nothing
    assert show.gait is None
    with pytest.raises(QuadrupedError, match="no scripted gait"):
        show.set_gait(CHANGED)
    robot.subscribe(CMD_VEL)
    wait_until(lambda: live.offered() == replace(nothing, command=True))
    robot.subscribe(PUSH)
    wait_until(lambda: live.offered() == replace(nothing, command=True, push=True))
    odometry = robot.publish(ODOMETRY)

    def sends_odometry():
        odometry.send_bytes(usable(ODOMETRY))
        show.advance(0.02)
        return live.offered() == replace(nothing, command=True, push=True, motion=True)

    wait_until(sends_odometry)
    wanted = robot.subscribe(GAIT, read=lambda data: cdr.deserialize(data, GAIT.type_name))
    robot.publish(GAIT_SETTINGS).send(settings_message(CHANGED))
    wait_until(lambda: show.advance(0.02) and show.gait == CHANGED)
    other = GaitSettings(1.5, 1.25, CHANGED.phases)
    show.set_gait(other)
    assert show.gait == other
    received = []
    wait_until(lambda: received.extend(wanted.messages(pytest.fail)) or received)
    assert read_settings(received[-1][1], MINI_QUADRUPED) == other
    show.close()


def test_viewer_shows_the_limits_that_a_published_gait_exceeds(nodes, tmp_path):
    """Without odometry it shows no velocity, contacts or reward."""
    robot, live = nodes("robot"), LiveRobot(nodes("viewer"), MINI_QUADRUPED)
    show = ViewController({NAME: lambda: live}, [NAME], tmp_path)
    states = robot.publish(JOINT_STATES)

    def status(knee, speed):
        """The status after a joint state with these knees, rad and rad/s."""
        states.send(joint_state(position=(0.1, knee) * 4, velocity=(0.0, speed) * 4))
        show.advance(0.02)
        show.available = live.offered()
        return status_html(show.view())

    wait_until(lambda: "live robot" in status(0.1, 6.0) and live.receives_states)
    assert "exceeds" not in status(0.1, 6.0), "without the gait node, they may be any robot's joints"
    robot.subscribe(GAIT)
    robot.publish(GAIT_SETTINGS).send(settings_message(CHANGED))
    wait_until(lambda: "The gait exceeds limits: LF_knee_joint: " in status(0.1, 6.0))
    assert "rad is outside -2 to 0 rad, and 7 more" in status(0.1, 6.0)
    assert "m/s" not in status(0.1, 6.0)
    assert "real time" not in status(0.1, 6.0)
    wait_until(lambda: "exceeds" not in status(-1.0, 1.0))
    show.close()
