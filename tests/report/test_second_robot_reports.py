"""Metrics, reports, figures, films, replays, bags, identification and the viewer, for another robot."""

import base64
import importlib.util
import json
import re
from html.parser import HTMLParser

import mujoco
import numpy as np
import pytest
from comparisons import write_evaluation
from renamed_robot import ROBOT

from quadruped_env import JointTrajectory, QuadrupedError, SinusoidalGait
from quadruped_env.cli.main import main
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.control.task_file import load_robot
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.measures import GRAVITY, METRICS, joint_limit_share, measure
from quadruped_env.evaluation.recorded_episode import play, publish
from quadruped_env.evaluation.rollout import roll_out
from quadruped_env.identification import identification_report, identify
from quadruped_env.identification.fit import joint_spec
from quadruped_env.identification.fitted_parameters import with_values
from quadruped_env.policies import GaitController, Policy, find_controllers, load_policy
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.replay.replay import replay
from quadruped_env.replay.replay_report import write_replay_report
from quadruped_env.report import palette
from quadruped_env.report.films.film import Camera, Clip, size_of
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.task import TaskConfig

CONFIG = TaskConfig().for_robot(ROBOT)
LABELS = [name.removesuffix("_joint").replace("_", " ") for name in ROBOT.joint_names]
COMMANDS = ((0.3, 0.0), (0.0, 0.4))
"""Stride frequency of the searched gait, Hz"""


def texts(svg):
    """The texts of a figure, which matplotlib draws as paths, with the text as a comment."""
    return re.findall(r"<!-- (.*?) -->", svg)


class Figures(HTMLParser):
    """The figures of a page by caption's title: title -> SVG document."""

    def __init__(self, text):
        super().__init__()
        self.found = {}
        self._title = ""
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        source = dict(attrs).get("src") or ""
        if source.startswith("data:image/svg+xml"):
            self.found[self._title] = base64.b64decode(source.partition("base64,")[2]).decode()

    def handle_data(self, data):
        self._title = data.strip() or self._title


def on_a_stand(targets):
    """Measurements of the robot with its feet in the air, by MuJoCo alone, at 200 Hz."""
    model = joint_spec(ROBOT, 0.005).compile()
    data = mujoco.MjData(model)
    data.qpos = targets.positions[0]
    rows = [(data.qpos.copy(), data.qvel.copy(), np.zeros(ROBOT.num_joints))]
    for target in targets.positions[:-1]:
        data.ctrl = target
        for _ in range(4):
            mujoco.mj_step(model, data)
            rows.append((data.qpos.copy(), data.qvel.copy(), data.actuator_force.copy()))
    return JointTrajectory(np.arange(len(rows)) * 5_000_000, ROBOT.joint_names, *map(np.array, zip(*rows, strict=True)))


def shuffled(trajectory):
    return trajectory.select(sorted(trajectory.names))


@pytest.fixture(scope="module")
def rollout():
    return roll_out(GaitController(), COMMANDS, [1, 2], 3.0, CONFIG, physics=True)


@pytest.fixture(scope="module")
def policy():
    """A policy that holds the stance, which is enough for a report."""
    width = len(ObservationLayout(ROBOT, CONFIG.definition.observations).low) * CONFIG.observation_history
    weights, biases = np.zeros((width, ROBOT.num_joints), np.float32), np.zeros(ROBOT.num_joints, np.float32)
    return Policy.for_task((weights,), (biases,), "tanh", CONFIG, {"command": "python train/ppo.py", "seed": 0})


@pytest.fixture(scope="module")
def report(policy, tmp_path_factory):
    """The page of an evaluation without no-break spaces, and its numbers."""
    comparison = compare(policy, num_seeds=2, seconds=2.5, commands=COMMANDS)
    output = tmp_path_factory.mktemp("report")
    page, numbers, missing = write_evaluation(EvaluatedPolicy("second", policy, output, output), comparison)
    assert not missing
    return page.read_text().replace("\N{NO-BREAK SPACE}", " "), json.loads(numbers.read_text())


@pytest.fixture(scope="module")
def targets():
    # Four legs with four phases: in a trot two of a symmetric robot's legs move as one.
    return publish(SinusoidalGait.preset("walk", ROBOT), 2.5, 50.0)


@pytest.fixture(scope="module")
def recording(targets):
    return play(targets, robot=ROBOT)


@pytest.fixture
def robot_file(tmp_path):
    """A file as users write it, which defines the robot."""
    path = tmp_path / "my_robot.py"
    path.write_text("from renamed_robot import ROBOT\n")
    return path


class TestMetrics:
    def test_roll_out_records_the_joints_and_feet_of_the_robot(self, rollout):
        assert rollout.robot is ROBOT
        assert rollout.joint_position.shape[2:] == (ROBOT.num_joints,)
        assert rollout.contact.shape[2:] == (ROBOT.num_legs,)
        # A foot that stands sinks in by less than the difference of the two robots' foot radii.
        assert abs(rollout.physics.height[-100:][rollout.physics.force[-100:] > 1.0].mean()) < 0.001
        assert ROBOT.foot_radius - MINI_QUADRUPED.foot_radius > 0.0015

    def test_measure_uses_the_mass_of_the_robot(self, rollout):
        values = measure(rollout)
        assert ROBOT.total_mass == pytest.approx(3.0 + 4 * (0.3 + 0.3))
        for kind in ("electrical", "mechanical"):
            expected = values[f"{kind}_power"] / (ROBOT.total_mass * GRAVITY * np.abs(values["forward_velocity"]))
            np.testing.assert_allclose(values[f"{kind}_cost_of_transport"][:2], expected[:2])
        np.testing.assert_allclose(values["stride_frequency"][:2], CONFIG.clock_frequency, rtol=0.05)

    def test_limits_are_those_of_the_robot(self):
        assert METRICS["peak_torque"].limit_of(ROBOT) == 14.0
        assert METRICS["peak_joint_speed"].limit_of(ROBOT) == 7.0
        assert METRICS["distance"].limit_of(ROBOT) is None
        position = np.tile(ROBOT.stance, (10, 1, 1))
        position[:5, 0, 1] = -2.095  # a knee at its limit, beyond the limit of the built-in robot
        position[5:8, 0, 0] = -1.395
        assert joint_limit_share(position, np.ones((10, 1), bool), ROBOT) == pytest.approx(0.8)
        position[:] = ROBOT.stance
        position[:, 0, 1] = -2.05
        assert joint_limit_share(position, np.ones((10, 1), bool), ROBOT) == 0.0


class TestReport:
    def test_page_describes_the_robot_and_its_limits(self, report):
        html, document = report
        assert "A robot with 4 legs and 8 motors, of 5.4 kg and with its base 24 cm above the ground, walks" in html
        assert "L and R: left and right" not in html
        assert document["metrics"]["peak_torque"]["limit"] == 14.0
        assert "<small>N m limit 14</small>" in html
        assert document["config"]["robot"] == ROBOT.identity

    def test_scripted_gait_is_no_searched_one_and_the_articles_is_left_to_robots_of_its_shape(self, report):
        html, document = report
        assert list(document["controllers"]) == ["policy", "tuned", "zero"]
        assert "Scripted gait" in html
        assert not re.search("[Ss]earched gait|Article's gait", html)

    def test_figures_follow_the_legs_and_joints_of_the_robot(self, report):
        figures = Figures(report[0]).found
        gait = texts(figures["Gait: which feet are on the ground"])
        assert [text for text in gait if text in ROBOT.leg_names][: ROBOT.num_legs] == list(ROBOT.leg_names)
        motors = texts(figures["Torque and speed against the motors' limits"])
        assert [text for text in motors if text in LABELS][: ROBOT.num_joints] == LABELS

    def test_policies_of_different_robots_are_not_compared(self, policy):
        with pytest.raises(QuadrupedError, match=r"flat: is a policy for Robot\('mini_quadruped'.* for one robot"):
            compare({"second": policy, "flat": load_policy("flat")}, 1, 2.0, COMMANDS)


class TestFigures:
    def test_colours_of_legs_do_not_depend_on_names_and_order(self):
        built_in, second = palette.leg_colours(MINI_QUADRUPED), palette.leg_colours(ROBOT)
        assert list(second) == list(ROBOT.leg_names)
        assert second["front_left"] == built_in["LF"] == palette.BLUE
        assert second["front_right"] == built_in["RF"]
        assert second["back_left"] == built_in["LH"]
        assert second["back_right"] == built_in["RH"]
        assert palette.joint_colours(ROBOT)[1] == ("back_right", second["back_right"])


class TestFilms:
    def test_camera_shows_the_whole_robot_from_a_distance_that_suits_its_size(self, rollout):
        assert size_of(MINI_QUADRUPED) == pytest.approx(1.0, abs=0.01)
        assert size_of(ROBOT) / size_of(MINI_QUADRUPED) == pytest.approx(
            ROBOT.stance_height / MINI_QUADRUPED.stance_height
        )
        trace = Clip.of_rollout(rollout, 0, "second").trace
        try:
            with Camera(ROBOT) as camera:
                picture = camera.picture(trace, 20)
                assert camera._view.distance == pytest.approx(0.95 * size_of(ROBOT))
        except QuadrupedError as error:
            pytest.skip(str(error))
        red, green, blue = np.moveaxis(picture.astype(int), -1, 0)
        rows, columns = np.nonzero((blue > 120) & (blue > red + 60) & (blue > green + 50))  # the hips
        assert len(rows) > 500
        assert 40 < columns.min() < columns.max() < 600


class TestReplay:
    def test_replay_repeats_a_recording_whatever_the_order_of_its_columns(self, targets, recording, tmp_path):
        shuffled(targets).save(tmp_path / "targets.csv")
        found = replay(JointTrajectory.load(tmp_path / "targets.csv"), robot=ROBOT)
        assert found.played.names == ROBOT.joint_names
        np.testing.assert_array_equal(found.played.positions, recording.joints.positions)
        np.testing.assert_array_equal(found.motion.base_pose, recording.base_pose)
        assert found.motors == ROBOT.motors
        assert found.report["motion"]["feet_on_ground_at_start"] >= 3

    def test_report_of_a_replay_names_its_joints_links_and_limits(self, targets, tmp_path):
        found = replay(targets, robot=ROBOT, measured=shuffled(targets))
        found.save(tmp_path, compare=True)
        write_replay_report(found, tmp_path, "", compare=True)
        numbers = json.loads((tmp_path / "tracking.json").read_text())
        assert list(numbers["tracking_error"]["joints"]) == list(ROBOT.joint_names)
        assert [entry["speed_limit"] for entry in numbers["limits"].values()] == [7.0, 6.0] * 4
        header = (tmp_path / "link_poses.csv").read_text().splitlines()[0]
        assert all(f"{link}.qz" in header for link in ROBOT.link_names)
        figures = Figures((tmp_path / "report.html").read_text()).found
        assert len(figures) == 5
        for svg in figures.values():
            assert [text for text in texts(svg) if text in LABELS] == LABELS


@pytest.mark.skipif(
    importlib.util.find_spec("scipy") is None, reason="SciPy is not installed: pip install -e '.[identify]'"
)
class TestIdentification:
    def test_identify_finds_the_gains_of_the_robot(self, targets, tmp_path):
        start = with_values(ROBOT.motors, {"hip.kp": 55.0, "knee.kp": 55.0})
        found = identify(on_a_stand(targets), targets, start=start, fitted=["kp"], robot=ROBOT)
        assert found.after.hip.kp == pytest.approx(70.0, rel=0.01)
        assert found.after.knee.kp == pytest.approx(60.0, rel=0.01)
        assert found.after.hip.stall_torque == 14.0
        numbers = identification_report.save_numbers(found, tmp_path, "")
        identification_report.write_report(found, tmp_path, numbers)
        assert read_motors(tmp_path / "motors.json", ROBOT) == found.after
        errors = json.loads((tmp_path / "identification.json").read_text())["errors"]["held_out"]["after"]["position"]
        assert list(errors) == list(ROBOT.joint_names)
        figures = Figures((tmp_path / "report.html").read_text()).found
        assert len(figures) == 3
        for svg in figures.values():
            assert [text for text in texts(svg) if text in LABELS] == LABELS


class TestViewer:
    @pytest.fixture
    def controller(self, robot_file, tmp_path):
        from quadruped_env.viewer import ViewController

        sources, chosen = find_controllers(["trot"], runs=tmp_path / "runs", task_file=robot_file)
        controller = ViewController(sources, chosen, tmp_path / "results", load_robot(robot_file))
        yield controller
        controller.close()

    def test_viewed_robot_is_the_one_of_the_file(self, controller):
        controller.advance(0.2)
        (view,) = controller.view().robots
        assert view.now.robot == ROBOT
        assert view.now.base_pose[2] > 0.2
        with pytest.raises(QuadrupedError, match="mini_quadruped"):
            controller.set_source(0, "policy flat")


class TestPrograms:
    def test_programs_read_the_robot_from_a_file(self, robot_file, tmp_path, capsys, monkeypatch):
        monkeypatch.chdir(tmp_path)
        task = ["--task", str(robot_file)]
        assert main(["baseline", "--preset", "trot", "--seconds", "1", "--episodes", "1", "-o", "walk.csv", *task]) == 0
        assert "14 N m" in capsys.readouterr().out
        assert JointTrajectory.load("walk.csv").names == ROBOT.joint_names
        assert main(["replay", "walk.csv", "-o", "again", *task]) == 0
        assert "back_right_knee_joint" in capsys.readouterr().out
        pytest.importorskip("rosbags")
        assert main(["convert", "walk.csv", "bag", *task]) == 0
        assert b"renamed" in next((tmp_path / "bag").glob("*.mcap")).read_bytes()
        assert main(["replay", "walk.csv", "-o", "built-in"]) == 2
        assert "joint 'LF_hip_joint' is missing" in capsys.readouterr().err
