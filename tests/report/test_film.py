import dataclasses
import io
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from paths import ROOT
from PIL import Image
from synthetic import falls

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.evaluation.recorded_episode import play, publish
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.evaluation.trace import Trace
from quadruped_env.gait import SinusoidalGait
from quadruped_env.policies import GaitController
from quadruped_env.replay.replay import replay
from quadruped_env.report.films import film, overlay, video
from quadruped_env.report.films.film import Camera, Clip
from quadruped_env.report.palette import leg_colours
from quadruped_env.robot import MINI_QUADRUPED


@pytest.fixture(scope="module")
def camera():
    try:
        camera = Camera(MINI_QUADRUPED)
    except QuadrupedError as error:
        pytest.skip(str(error))
    yield camera
    camera.close()


@pytest.fixture(scope="module")
def walk():
    rollout = roll_out(GaitController(), [(0.4, 0.0)], [7], 2.0)
    return Clip.of_rollout(rollout, 0, "a walk", 1.0, 2.0)


def standing_at(*places, timestep=0.02, **more):
    pose = np.array([[x, y, MINI_QUADRUPED.stance_height, 1.0, 0.0, 0.0, 0.0] for x, y in places])
    joints = np.tile(MINI_QUADRUPED.stance, (len(places), 1))
    return Trace(robot=MINI_QUADRUPED, timestep=timestep, base_pose=pose, joint_position=joints, **more)


def robot_pixels(picture):
    """The blue hips: nothing else in the scene is that blue."""
    r, g, b = np.moveaxis(picture.astype(int), -1, 0)
    return (b > 120) & (b > r + 60) & (b > g + 50)


def test_robot_is_in_the_middle_of_every_picture_and_moves(camera, walk):
    pictures = list(camera.film([walk]))
    assert len(pictures) == 25
    assert pictures[0].shape == (film.HEIGHT, film.WIDTH, 3)
    for picture in pictures:
        rows, columns = np.nonzero(robot_pixels(picture[:380]))
        assert len(rows) > 500
        assert abs(columns.mean() - film.WIDTH / 2) < 80
    assert not np.array_equal(pictures[0], pictures[-1])


def test_camera_follows_and_no_robot_leaves_the_ground(camera):
    here = camera.picture(standing_at((0.0, 0.0)), 0)
    # The ground's pattern repeats every metre.
    far = camera.picture(standing_at((1000.0, -2000.0)), 0)
    assert np.abs(here.astype(int) - far).mean() < 0.5
    between = camera.picture(standing_at((0.1, 0.0)), 0)
    assert np.abs(here.astype(int) - between).mean() > 0.5


def test_episode_is_turned_to_begin_at_the_origin_facing_ahead():
    half = np.sqrt(0.5)
    pose = np.array([[3.0, 4.0, 0.2, half, 0.0, 0.0, half], [3.0, 5.0, 0.2, half, 0.0, 0.0, half]])
    joints = np.tile(MINI_QUADRUPED.stance, (2, 1))
    turned = film.facing_ahead(Trace(robot=MINI_QUADRUPED, timestep=0.02, base_pose=pose, joint_position=joints))
    np.testing.assert_allclose(turned.base_pose[:, :3], [[0, 0, 0.2], [1, 0, 0.2]], atol=1e-12)
    np.testing.assert_allclose(turned.base_pose[:, 3:], [[1, 0, 0, 0]] * 2, atol=1e-12)
    np.testing.assert_array_equal(pose[:, 0], [3.0, 3.0])


def test_film_of_an_episode_ends_at_its_fall():
    rollout = roll_out(GaitController(), [(0.4, 0.0)], [7], 1.0)
    valid = rollout.valid.copy()
    valid[20:] = False
    fallen = dataclasses.replace(rollout, fell=falls(valid))
    assert len(Clip.of_rollout(fallen, 0, "").trace) == 21
    assert Clip.of_rollout(rollout, 0, "").trace.seconds == pytest.approx(1.0)


def test_overlay_draws_the_mean_speed_up_to_its_command():
    velocity = np.array([[0.6, 0.0], [0.0, 0.0]])
    command = np.array([[0.3, 0.0], [0.3, 0.0]])
    trace = standing_at((0.0, 0.0), (0.0, 0.0), timestep=0.5, velocity=velocity, command=command)
    shown = overlay.Overlay("", trace)
    drawn = shown.draw(np.zeros((480, 640, 3), np.uint8), 0)
    blue = np.array([int(overlay.ACTUAL[i : i + 2], 16) for i in (1, 3, 5)])
    row = 480 - overlay._PANEL_HEIGHT + 14 + 8
    columns = np.flatnonzero((drawn[row] == blue).all(axis=-1))
    middle = (overlay._BAR_LEFT + overlay._BAR_RIGHT) / 2
    assert columns.min() == pytest.approx(middle, abs=2)
    assert columns.max() == pytest.approx(overlay._BAR_RIGHT, abs=2)


def test_speed_is_averaged_over_past_samples():
    values = np.array([[1.0], [2.0], [6.0], [10.0]])
    np.testing.assert_allclose(overlay.trailing_mean(values, 2), [[1.0], [1.5], [4.0], [8.0]])
    np.testing.assert_allclose(overlay.trailing_mean(values, 9), [[1.0], [1.5], [3.0], [4.75]])


def test_gait_strip_colours_feet_on_the_ground():
    contact = np.zeros((100, 4), bool)
    contact[50:, 2] = True
    strip = overlay.gait_strip(MINI_QUADRUPED, contact, 0.02)
    band = strip[overlay._GAIT_HEIGHT // 4 * 2 + 1]
    colour = [int(leg_colours(MINI_QUADRUPED)["LH"][i : i + 2], 16) for i in (1, 3, 5)]
    assert len(band) == overlay._GAIT_WIDTH
    assert (band[: len(band) // 2] == overlay._AIR).all()
    assert (band[len(band) // 2 :] == colour).all()
    assert (strip[1] == overlay._AIR).all()


def test_mp4_holds_the_pictures(camera, walk):
    import av

    pictures = list(camera.film([walk]))[:5]
    with av.open(io.BytesIO(video.encode_mp4(pictures))) as container:
        stream = container.streams.video[0]
        assert stream.codec_context.name == "h264"
        assert stream.average_rate == film.FRAME_RATE
        decoded = [frame.to_ndarray(format="rgb24") for frame in container.decode(stream)]
    assert len(decoded) == 5
    assert np.abs(decoded[0].astype(int) - pictures[0]).mean() < 5.0


def test_pictures_for_pages_keep_their_speed_and_colours(tmp_path):
    colours = np.linspace(0, 255, 10).astype(np.uint8)
    pictures = [np.full((480, 640, 3), c, np.uint8) for c in colours]
    video.save_video(tmp_path / "film.webp", pictures)
    with Image.open(tmp_path / "film.webp") as image:
        assert image.n_frames == len(pictures)
        assert image.size == (480, 360)
        image.seek(7)
        image.load()
        assert image.info["duration"] == 1000 // film.FRAME_RATE
        assert image.info.get("loop", 0) == 0


def test_bad_video_files_are_named_before_any_work(tmp_path, monkeypatch):
    with pytest.raises(QuadrupedError, match=r"walk\.avi: a video's name ends in \.mp4 or \.webp; found '\.avi'"):
        video.prepare_video(Path("walk.avi"))
    taken = tmp_path / "walk.mp4"
    taken.write_bytes(b"")
    with pytest.raises(QuadrupedError, match="exists already"):
        video.prepare_video(taken)
    monkeypatch.setattr("quadruped_env.envs.rendering.opengl_failure", lambda: "no OpenGL")
    with pytest.raises(QuadrupedError, match="no OpenGL"):
        video.prepare_video(taken, overwrite=True)
    video.prepare_video(None)


def test_recordings_and_replays_can_be_filmed():
    commands = publish(SinusoidalGait.preset("trot"), 0.5, 50.0)
    recording = play(commands)
    assert len(Clip("trot", recording).frame_samples()) == 13
    assert recording.timestep == pytest.approx(0.02)
    assert recording.contact.shape == (26, 4)
    assert 0.3 < recording.contact[1:].mean() < 0.9
    travelled = np.abs(np.diff(recording.base_pose[:, 0])).sum()
    assert travelled == pytest.approx(np.abs(recording.velocity[:, 0]).sum() * 0.02, rel=0.3)

    played = replay(JointTrajectory(commands.stamps, commands.names, commands.positions), "kinematic").film().trace
    assert played.velocity is None
    assert played.seconds == pytest.approx(0.52)
    np.testing.assert_allclose(played.joint_position[5], commands.positions[10], atol=1e-9)


@pytest.mark.slow
def test_every_program_that_runs_the_robot_films_it(tmp_path, camera):
    def run(name, *arguments):
        command = [sys.executable, ROOT / name, *map(str, arguments)]
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)

    short = ("--seeds", 1, "--seconds", 2, "--no-video")
    assert run("evaluate/baseline.py", "--seconds", 1, "--episodes", 1, "-o", "walk.csv").returncode == 0
    programs = {
        "evaluate/replay.py": ("walk.csv",),
        "evaluate/policy.py": ("flat", *short),
        "tools/picture.py": (),
    }
    for name, arguments in programs.items():
        option = "--output" if name == "tools/picture.py" else "--video"
        file = tmp_path / f"{Path(name).stem}.webp"
        result = run(name, *arguments, option, file)
        assert result.returncode == 0, result.stderr
        assert str(file) in result.stdout
        with Image.open(file) as image:
            assert image.size == (480, 360)
    again = run("evaluate/policy.py", "flat", *short, "--video", tmp_path / "policy.webp")
    assert again.returncode == 2
    assert "exists already" in again.stderr
