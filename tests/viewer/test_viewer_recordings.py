"""Recordings that the viewer makes."""

import threading

import numpy as np
import pytest
from viewing import DT, robot, throw_on_the_back
from waiting import DEADLINE, wait_until

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError
from quadruped_env.policies import find_controllers
from quadruped_env.viewer import ViewController
from quadruped_env.viewer.panel_text import status_html
from quadruped_env.viewer.view_controller import RESTART_AFTER
from quadruped_env.viewer.viewer_recording import MAX_WAITING


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


def test_panel_shows_the_maximum_time_of_a_recording(control, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    controller = control("stand still")
    assert "recording" not in status_html(controller.view())
    controller.start_recording()
    controller.advance(0.1)
    assert "recording, 0.1 of at most 300 s" in status_html(controller.view())


def test_recordings_that_wait_to_be_saved_are_bounded(control, tmp_path, monkeypatch):
    go_on = threading.Event()
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: go_on.wait(DEADLINE))
    controller = control("stand still")
    for _ in range(MAX_WAITING):
        controller.start_recording()
        controller.stop_recording()
    with pytest.raises(QuadrupedError, match=f"record: {MAX_WAITING} recordings are still being saved"):
        controller.start_recording()
    assert controller.view().recorded is None
    go_on.set()
    wait_until(lambda: not controller.saving)
    controller.start_recording()
    assert controller.view().recorded == 0.0


def test_recordings_of_a_show_are_bounded(control, monkeypatch):
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: None)
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.MAX_RECORDINGS", 1)
    controller = control("stand still")
    controller.start_recording()
    controller.stop_recording()
    wait_until(lambda: not controller.saving)
    with pytest.raises(QuadrupedError, match="record: 1 recordings were made; start the viewer again"):
        controller.start_recording()


@pytest.mark.parametrize(("source", "follows"), [("policy flat", True), ("gait trot", False)])
def test_film_shows_the_command_if_the_robot_follows_it(control, monkeypatch, source, follows):
    films = []
    monkeypatch.setattr("quadruped_env.viewer.viewer_recording.save_film", lambda path, clips: films.extend(clips))
    controller = control(source)
    controller.set_command(0.3, 0.1)
    controller.start_recording()
    controller.advance(0.2)
    controller.close()
    (clip,) = films
    assert clip.title == source
    assert len(clip.trace) == 11
    assert clip.trace.velocity.shape == (11, 2)
    if follows:
        np.testing.assert_array_equal(clip.trace.command[-1], [0.3, 0.1])
    else:
        assert clip.trace.command is None


@pytest.mark.slow
def test_recording_is_filmed(control, tmp_path):
    av = pytest.importorskip("av")
    controller = control("policy flat")
    controller.start_recording()
    for _ in range(10):
        controller.advance(0.1)
    controller.close()
    messages = controller.messages()
    if messages[1].startswith("No video: no OpenGL"):
        pytest.skip(messages[1])
    (path,) = tmp_path.glob("results/view-*/video.mp4")
    with av.open(path) as film:
        assert sum(1 for _ in film.decode(video=0)) == pytest.approx(25, abs=1)
