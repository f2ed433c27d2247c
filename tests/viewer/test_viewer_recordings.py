"""Recordings that the viewer makes."""

import numpy as np
import pytest
from viewing import DT, robot, throw_on_the_back

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError
from quadruped_env.policies import find_controllers
from quadruped_env.viewer import ViewController
from quadruped_env.viewer.view_controller import RESTART_AFTER


def test_recording_holds_the_samples_of_its_time(control, tmp_path, monkeypatch):
    films = []
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: films.append(clips))
    controller = control("policy flat")
    controller.set_command(0.4, 0.0)
    controller.advance(0.2)
    controller.start_recording()
    controller.start_recording()
    for _ in range(5):
        controller.advance(0.1)
    samples = list(robot(controller).history)[-26:]
    assert controller.view().recorded == pytest.approx(0.5)
    controller.stop_recording()
    assert controller.view().recorded is None
    controller.advance(0.1)
    controller.close()
    (path,) = tmp_path.glob("results/view-*/joint_states.csv")
    saved = JointTrajectory.load(path)
    assert saved.names == JOINT_NAMES
    np.testing.assert_array_equal(saved.times, np.round(np.arange(26) * DT, 9))
    np.testing.assert_array_equal(saved.positions, [s.joint_position for s in samples])
    np.testing.assert_array_equal(saved.velocities, [s.joint_velocity for s in samples])
    np.testing.assert_array_equal(saved.efforts, [s.joint_torque for s in samples])
    ((clip,),) = films
    np.testing.assert_array_equal(clip.trace.base_pose, [s.base_pose for s in samples])
    np.testing.assert_array_equal(clip.trace.command, [s.command for s in samples])
    messages = controller.messages()
    assert messages[0] == f"0.5 s recorded: {path}"
    assert messages[1].startswith("Video: ")
    assert controller.messages() == []


@pytest.mark.parametrize("end", ["reset", "set_source", "watch", "close", "fall"])
def test_recording_ends_where_its_robot_does(control, tmp_path, monkeypatch, end):
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    controller = control("gait trot", "stand still")
    controller.start_recording()
    controller.advance(0.2)
    match end:
        case "reset":
            controller.reset()
        case "set_source":
            controller.set_source(0, "gait pace")
        case "watch":
            controller.watch(1)
        case "fall":
            throw_on_the_back(controller)
            for _ in range(12):
                controller.advance(0.2)
    if end != "close":
        controller.advance(0.1)
    controller.close()
    (path,) = tmp_path.glob("results/view-*/joint_states.csv")
    seconds = JointTrajectory.load(path).duration
    assert seconds == pytest.approx(0.2 + RESTART_AFTER + DT if end == "fall" else 0.2, abs=1.5 * DT)


def test_recording_without_opengl_is_saved_without_a_video(control, tmp_path, monkeypatch):
    def fail(path, clips):
        raise QuadrupedError("no OpenGL to render with")

    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", fail)
    controller = control("stand still")
    assert not controller.saving
    controller.start_recording()
    assert controller.saving
    controller.advance(0.1)
    controller.close()
    assert not controller.saving
    assert list(tmp_path.glob("results/view-*/joint_states.csv"))
    assert controller.messages()[1:] == ["No video: no OpenGL to render with"]


def test_recording_that_cannot_be_saved_is_reported(tmp_path):
    (tmp_path / "results").write_text("a file where a directory should be")
    sources, chosen = find_controllers(runs=tmp_path)
    controller = ViewController(sources, chosen, tmp_path / "results")
    controller.start_recording()
    controller.advance(0.1)
    controller.close()
    (message,) = controller.messages()
    assert message.startswith("Not saved: ")


def test_recording_ends_at_the_maximum_time_with_a_message(control, tmp_path, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    monkeypatch.setattr("quadruped_env.viewer.view_controller.MAX_SECONDS", 0.5)
    controller = control("stand still")
    controller.start_recording()
    for _ in range(10):
        controller.advance(0.1)
    assert controller.view().recorded is None
    controller.close()
    (path,) = tmp_path.glob("results/view-*/joint_states.csv")
    assert JointTrajectory.load(path).duration == pytest.approx(0.5)
    assert controller.messages()[0] == "The recording has ended: the maximum is 0.5 s; record again"
