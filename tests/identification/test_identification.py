"""Identification of motors: simulated recordings with known motors must give these motors."""

import html
import json
from dataclasses import replace as changed
from pathlib import Path

import mujoco
import numpy as np
import pytest
import twelve_joints
from paths import DYNA1

from quadruped_env import JOINT_NAMES, JointTrajectory, QuadrupedError, SinusoidalGait
from quadruped_env.cli.main import main
from quadruped_env.evaluation.recorded_episode import play, publish
from quadruped_env.identification import FITTED, QUANTITIES, identify, rough_least_squares
from quadruped_env.identification.dataset import align, held
from quadruped_env.identification.fit import MotorFit, joint_spec
from quadruped_env.identification.fitted_parameters import (
    coordinate_derivatives,
    from_coordinates,
    names_of,
    to_coordinates,
    value_of,
    with_values,
)
from quadruped_env.identification.identification_report import save_numbers
from quadruped_env.identification.recording_checks import check, check_stand
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.replay.replay import replay
from quadruped_env.robot import MINI_QUADRUPED, JointMotor, MotorConfig, asset_path
from quadruped_env.robot.motors import fill_command_history

pytest.importorskip("scipy")

TRUTH = MotorConfig(
    hip=JointMotor(stall_torque=7.5, kp=32.0, kd=0.7, damping=0.12, friction_loss=0.25, armature=0.016),
    knee=JointMotor(stall_torque=8.5, kp=48.0, kd=1.3, damping=0.09, friction_loss=0.15, armature=0.008),
    delay=0.017,
)
STANCE = MINI_QUADRUPED.stance
NOISE = (0.002, 0.05, 0.1)
"""Standard deviations: rad, rad/s, N m"""


def commanded(seconds, rate=50.0, steps=0.35, seed=1, robot=MINI_QUADRUPED):
    """Waves and steps on every joint: fast, back and forth, and up to the motors' limits."""
    rng = np.random.default_rng(seed)
    t = np.arange(round(seconds * rate) + 1) / rate
    low, high = robot.joint_position_low, robot.joint_position_high
    half = (high - low) / 2
    targets = np.tile((low + high) / 2, (len(t), 1))
    for joint in range(robot.num_joints):
        for frequency in (0.4, 0.9, 1.7, 2.9):
            wave = np.sin(2 * np.pi * frequency * (1 + joint / 80) * t + rng.uniform(0, 2 * np.pi))
            targets[:, joint] += 0.18 * half[joint] * wave
        jumps = rng.uniform(-steps, steps, int(seconds / 0.4) + 1)
        targets[:, joint] += jumps[(t / 0.4).astype(int)] * half[joint]
    targets = np.clip(targets, low + 0.1, high - 0.1)
    return JointTrajectory(np.rint(t * 1e9).astype(np.int64), robot.joint_names, targets)


def measured(commands, motors, noise=NOISE, every=2, seed=0, robot=MINI_QUADRUPED):
    """Recording of a robot on a stand under the commands, by MuJoCo alone: 5 ms steps, every second one measured."""
    spec = joint_spec(robot, 0.005)
    motors.write(spec, robot.joint_kinds)
    motors.write_delay(spec, motors.delay)
    model = spec.compile()
    data = mujoco.MjData(model)
    data.qpos = commands.positions[0]
    fill_command_history(model, data.history[None], commands.positions[:1])
    rows = [(0, data.qpos.copy(), data.qvel.copy(), np.zeros(robot.num_joints))]
    command_steps = commands.stamps // 5_000_000
    for step in range(int(command_steps[-1])):
        data.ctrl = commands.positions[np.searchsorted(command_steps, step, side="right") - 1]
        mujoco.mj_step(model, data)
        if (step + 1) % every == 0:
            rows.append(((step + 1) * 5_000_000, data.qpos.copy(), data.qvel.copy(), data.actuator_force.copy()))
    stamps, *signals = map(np.array, zip(*rows, strict=True))
    return noisy(JointTrajectory(stamps, robot.joint_names, *signals), noise, seed)


def noisy(trajectory, noise=NOISE, seed=0):
    rng = np.random.default_rng(seed)
    signals = trajectory.positions, trajectory.velocities, trajectory.efforts
    disturbed = [signal + rng.normal(0.0, sigma, signal.shape) for signal, sigma in zip(signals, noise, strict=True)]
    return JointTrajectory(trajectory.stamps, trajectory.names, *disturbed)


def without(trajectory, *kinds):
    return JointTrajectory(
        trajectory.stamps,
        trajectory.names,
        trajectory.positions,
        None if "velocities" in kinds else trajectory.velocities,
        None if "efforts" in kinds else trajectory.efforts,
    )


@pytest.fixture
def few_rounds(monkeypatch):
    """A short search, where it does not matter how good the fit is."""
    monkeypatch.setattr(rough_least_squares, "_ROUNDS", 2)
    monkeypatch.setattr(rough_least_squares, "_DRAWS", 1)
    monkeypatch.setattr("quadruped_env.identification.fit._FINEST_DELAY", 0.02)


@pytest.fixture(scope="module")
def short():
    """Commands over 3 s, and the recording of a robot on a stand under them."""
    commands = commanded(3.0)
    return commands, measured(commands, TRUTH)


class TestRecorded:
    def test_a_held_command_is_averaged_over_the_step(self):
        times, values = np.array([0.0, 0.02, 0.03]), np.array([[1.0], [3.0], [-1.0]])
        means = held(times, values, np.array([-0.01, 0.0, 0.01, 0.025, 0.03, 0.05]))
        # By hand: before the first command it holds too; from 0.01 to 0.025, two thirds of 1 and one third of 3.
        np.testing.assert_allclose(means[:, 0], [1.0, 1.0, 1.0 * 2 / 3 + 3.0 / 3, 3.0, -1.0], atol=1e-12)

    def test_commands_and_measurements_are_aligned_on_the_physics_steps(self):
        commands = commanded(4.0)
        late = JointTrajectory(commands.stamps[10:] + 3, JOINT_NAMES, commands.positions[10:])
        recorded = align(MINI_QUADRUPED, late, commands, 0.5, 0.005)
        assert recorded.times[0] == 0.0
        assert len(recorded.times) == len(late) - 1  # the last timestamp is after the last command
        # The control is the command before; 3 ns later it is already the next one's for nearly the whole step.
        np.testing.assert_allclose(recorded.control[0], commands.positions[10], atol=1e-5)
        assert recorded.train.sum() == pytest.approx(len(recorded.times) / 2, abs=1)
        assert recorded.signals == ("position",)

    def test_recordings_and_settings_that_cannot_be_fitted_are_refused(self):
        commands = commanded(4.0)
        still = JointTrajectory([0, 10**10], JOINT_NAMES, np.tile(STANCE, (2, 1)))
        stamps = np.arange(4001) * 100_000_000
        longer = JointTrajectory(stamps, JOINT_NAMES, np.tile(STANCE, (4001, 1)) + np.sin(stamps)[:, None] / 10)
        elsewhere = JointTrajectory(commands.stamps + 10**15, JOINT_NAMES, commands.positions)
        for recording, told, message in (
            (commands, still, "no command changes"),
            (elsewhere, commands, r"0 measurements over 0 s in common .*one clock"),
            (commands.slice(0.0, 1.0), commands, "at least 2 s"),
            (longer, longer, r"400 s in common with its commands, over 300 s; cut out"),
        ):
            with pytest.raises(QuadrupedError, match=message):
                align(MINI_QUADRUPED, recording, told, 0.7, 0.005)
        for arguments, message in (
            ({"fitted": ["mass"]}, r"cannot estimate 'mass'; valid names are stall_torque"),
            ({"train_share": 1.0}, "share for the fit must be from 0.1 to 0.9; found 1"),
            ({"timestep": 0.1}, "time step must be from 0.0001 to 0.01 s"),
            ({"without": ["tail"]}, "no joint 'tail' to leave out"),
            ({"without": JOINT_NAMES}, "no joint is left"),
        ):
            with pytest.raises(QuadrupedError, match=message):
                identify(commands, commands, **arguments)

    def test_servos_without_feedback_are_named_with_what_they_do_not_tell(self):
        """A driver that repeats the target, at once or later and rounded to 0.01 degrees, or that reports nothing."""
        commands = commanded(4.0)
        stamps = np.arange(60_000_000, 4_000_000_000, 12_345_678)

        def targets_at(when):
            return commands.positions[np.searchsorted(commands.stamps, when, side="right") - 1]

        rounded = np.radians(np.degrees(targets_at(stamps - 40_000_000)).round(2))
        late = JointTrajectory(stamps, JOINT_NAMES, rounded)
        constant = JointTrajectory(stamps, JOINT_NAMES, np.tile(STANCE, (len(stamps), 1)))
        real = measured(commands, TRUTH)
        positions = np.where(np.arange(8) % 2, targets_at(real.stamps), real.positions)
        later = JointTrajectory(commands.stamps + 1, JOINT_NAMES, commands.positions)
        mixed = JointTrajectory(real.stamps, JOINT_NAMES, positions)
        unknown = r"so stall_torque, .*, delay, target_step, backlash, dead_band cannot be identified.*--without"
        for recording, message in (
            (later, rf"positions of {', '.join(JOINT_NAMES)} are their targets, 0 s later: .*{unknown}"),
            (late, rf"are their targets, 0\.0(3|4)\d s later.*{unknown}"),
            (constant, r"LF_hip_joint does not move .* its servo reports no position.*--without"),
            (mixed, rf"positions of {', '.join(JOINT_NAMES[1::2])} are their targets"),
        ):
            with pytest.raises(QuadrupedError, match=message):
                identify(recording, commands)


def test_columns_that_are_read_twice_are_named_and_servos_are_not_accused():
    commands = commanded(4.0)
    with pytest.raises(
        QuadrupedError, match=r"same columns were read twice; .*--commands-columns.*--commands-topic"
    ) as e:
        identify(commands, JointTrajectory(commands.stamps, JOINT_NAMES, commands.positions))
    assert "report no position" not in str(e.value)


@pytest.mark.usefixtures("few_rounds")
def test_one_servo_on_a_bench_is_fitted_from_a_file_without_the_other_joints():
    commands, moved = commanded(4.0), np.tile(STANCE, (201, 1))
    moved[:, 0] = commands.positions[:, 0]
    alone = JointTrajectory(commands.stamps, JOINT_NAMES, moved)
    start = with_values(TRUTH, {"hip.kp": 20.0})
    bench = measured(alone, TRUTH).select(["LF_hip_joint"])
    found = identify(bench, alone.select(["LF_hip_joint"]), start=start, fitted=["kp"], without=JOINT_NAMES[1:])
    estimates = {one.name: one for one in found.estimates}
    assert estimates["hip.kp"].after == pytest.approx(TRUTH.hip.kp, rel=0.05)
    assert (estimates["knee.kp"].half_width, estimates["knee.kp"].after) == (None, TRUTH.knee.kp)
    assert any(
        one.endswith("RH_knee_joint: not recorded, and simulated at rest in the stance.") for one in found.remarks
    )
    with pytest.raises(QuadrupedError, match=r"joint 'LF_knee_joint' is missing.*\(--without\)"):
        identify(bench, alone, without=JOINT_NAMES[2:])


class TestRefusals:
    """A recording that would spoil the fit is refused, with the reason and the repair."""

    @pytest.mark.parametrize(
        ("lie", "message"),
        [
            ("q[100, 2] -= 2.0", r"jump away and back .* RF_hip_joint, .*\(row 100\).*--repair despike"),
            ("q[:, 0] = q[0, 0]", r"positions freeze .* in LF_hip_joint"),
            ("v *= 180 / np.pi", r"velocities .* 5\d.* times"),
            ("e[:] = 0.0", r"efforts .* are 0 in every row"),
            ("e *= -1", r"the effort of LF_knee_joint pulls away .*effort_scale"),
            ("s += 500_000_000", r"come 0\.5\d s after the commands, so .* different clocks"),
            ("v = e = None; q[:, 2] *= -1", r"RF_hip_joint moves against its command: .*sign = -1"),
            ("v = e = None; q[:, :2] = q[:, [1, 0]]", r"LF_hip_joint follows the command of LF_knee_joint: .*swapped"),
            ("v = e = None; q[:, 3] += 0.9", r"RF_knee_joint is \+0\.\d+ rad from its command on average.*offset"),
            ("v = e = None; q[:, 2] *= 4", r"RF_hip_joint moves \d\.\d+ times as far as it is commanded.*unit"),
            ("v = e = None; q[:, 3] = 0.3", r"RF_knee_joint does not move .*--without RF_knee_joint"),
        ],
    )
    def test_lie_is_named(self, short, lie, message):
        commands, recording = short
        with pytest.raises(QuadrupedError, match=rf"would spoil the fit.*: .*{message}"):
            identify(self.changed(recording, lie), commands)

    @staticmethod
    def changed(recording, lie):
        """The recording after statements have changed timestamps s, positions q, velocities v, efforts e."""
        arrays = recording.stamps, recording.positions, recording.velocities, recording.efforts
        names = {"np": np, **{name: array.copy() for name, array in zip("sqve", arrays, strict=True)}}
        exec(lie, names)  # noqa: S102
        return JointTrajectory(names["s"], JOINT_NAMES, names["q"], names["v"], names["e"])

    def test_joints_that_are_left_out_and_time_without_commands_do_not_matter(self, short):
        commands, recording = short
        lying = self.changed(recording, "q[50, 2] -= 2.0")
        recorded = align(MINI_QUADRUPED, lying, commands, 0.7, 0.005)
        check(recorded, lying, commands, ["RF_hip_joint"])
        later = commands.slice(0.7)
        check(align(MINI_QUADRUPED, lying, later, 0.5, 0.005), lying, later, [])

    @pytest.mark.parametrize(
        ("robot", "preset"),
        [(twelve_joints.ROBOT, "sinusoid"), (twelve_joints.ROBOT, "article"), (MINI_QUADRUPED, "walk")],
    )
    def test_efforts_on_the_ground_have_their_sign(self, robot, preset):
        """Where the ground moves the joints, damping pulls them away from their commands for half of the time."""
        commands = publish(SinusoidalGait.preset(preset, robot), 4.0, 50.0)
        walked = play(commands, robot=robot).joints
        check(align(robot, walked, commands, 0.7, 0.005), walked, commands, [])
        flipped = changed(walked, efforts=-walked.efforts)
        with pytest.raises(QuadrupedError, match=r"would spoil the fit.*the effort of \w+ pulls away from its command"):
            check(align(robot, flipped, commands, 0.7, 0.005), flipped, commands, [])


class TestCoordinates:
    def test_conversion_there_and_back_and_its_derivatives(self):
        values = {name: value_of(TRUTH, name) for name in names_of(QUANTITIES, MINI_QUADRUPED)}
        assert from_coordinates(to_coordinates(values)) == pytest.approx(values)
        assert with_values(MotorConfig(), values) == TRUTH
        base = np.array(list(to_coordinates(values).values()))
        found = coordinate_derivatives(values)
        for column, name in enumerate(values):
            step = 1e-7 * values[name]
            moved = np.array(list(to_coordinates({**values, name: values[name] + step}).values()))
            np.testing.assert_allclose(found[:, column], (moved - base) / step, rtol=1e-5, atol=1e-5)


class TestPrediction:
    def test_true_motors_leave_only_noise(self, short):
        commands, _ = short
        exact = measured(commands, TRUTH, noise=(0.0, 0.0, 0.0))
        fit = MotorFit(align(MINI_QUADRUPED, exact, commands, 0.7, 0.005), MotorConfig(), ["kp"])
        predicted = fit.predict(TRUTH)
        signals = np.concatenate([exact.positions, exact.velocities, exact.efforts], axis=1)
        np.testing.assert_allclose(predicted[1:], signals[1:], rtol=0, atol=1e-9)

    def test_free_base_on_the_ground_equals_the_task(self):
        """The free robot of the fit does what the task's does with the same targets."""
        commands = publish(SinusoidalGait.preset("tuned"), 2.0, 50.0)
        walked = play(commands).joints
        fit = MotorFit(align(MINI_QUADRUPED, walked, commands, 0.7, 0.005), MotorConfig(), ["kp"], on_ground=True)
        predicted = fit.predict(MotorConfig())
        np.testing.assert_allclose(predicted[1:, :8], walked.positions[1:], rtol=0, atol=1e-6)
        np.testing.assert_allclose(predicted[1:, 16:], walked.efforts[1:], rtol=0, atol=1e-4)


class TestIntervals:
    def test_value_that_runs_away_does_not_allow_itself_a_wider_interval(self):
        """The knees were not measured, and load the hip a little."""
        commands, moved = commanded(3.0), np.tile(STANCE, (151, 1))
        moved[:, 0] = commands.positions[:, 0]
        alone = JointTrajectory(commands.stamps, JOINT_NAMES, moved)
        recorded = align(MINI_QUADRUPED, measured(alone, TRUTH), alone, 0.7, 0.005, JOINT_NAMES[1:])
        fit = MotorFit(recorded, TRUTH, ["kp"])
        for knee in (48.0, 1741.0):
            assert set(fit._intervals({"hip.kp": 32.0, "knee.kp": knee})) == {"hip.kp"}


class TestIdentify:
    @pytest.mark.usefixtures("few_rounds")
    def test_two_known_gains_are_recovered(self, short, tmp_path):
        commands, recording = short
        start = with_values(TRUTH, {"hip.kp": 40.0, "knee.kp": 40.0})
        shares = []
        found = identify(recording, commands, start=start, fitted=["kp"], progress=shares.append)
        assert found.after.hip.kp == pytest.approx(32.0, rel=0.02)
        assert found.after.knee.kp == pytest.approx(48.0, rel=0.02)
        assert found.after.hip.kd == TRUTH.hip.kd
        assert found.helps
        assert "held-out time the position error falls from" in found.verdict()
        for name, sigma in zip(("position", "velocity", "effort"), NOISE, strict=True):
            np.testing.assert_allclose(found.errors(after=True)[name], sigma, rtol=0.25)
        assert all(e.half_width < 1.0 and abs(e.after - e.before) > e.half_width for e in found.estimates)
        assert (shares[-1], shares) == (1.0, sorted(shares))

        save_numbers(found, tmp_path / "fit", "identify walk.csv")
        assert read_motors(tmp_path / "fit" / "motors.json") == found.after
        numbers = json.loads((tmp_path / "fit" / "identification.json").read_text())
        assert numbers["errors"]["held_out"]["after"]["position"]["LF_hip_joint"] == pytest.approx(0.002, rel=0.25)
        with pytest.raises(QuadrupedError, match=r"motors\.json: exists already"):
            save_numbers(found, tmp_path / "fit", "")

    @pytest.mark.usefixtures("few_rounds")
    def test_parameter_that_the_recording_does_not_determine_stays_and_is_named(self):
        """A motor that never comes to its limit has unknown strength."""
        commands = commanded(3.0, steps=0.0)
        gentle = JointTrajectory(commands.stamps, JOINT_NAMES, STANCE + 0.1 * (commands.positions - STANCE))
        recording = measured(gentle, TRUTH)
        start = with_values(TRUTH, {"hip.kp": 40.0, "hip.stall_torque": 10.0})
        found = identify(recording, gentle, start=start, fitted=["stall_torque", "kp"])
        widths = {estimate.name: estimate.half_width for estimate in found.estimates}
        assert widths["hip.stall_torque"] is widths["knee.stall_torque"] is None
        assert found.after.hip.stall_torque == 10.0
        assert found.after.hip.kp == pytest.approx(32.0, rel=0.05)
        assert "not determined: stays" in found.text()
        assert found.assumed == ("stall_torque", "no_load_speed", "kd", "damping", "friction_loss", "armature", "delay")

    @pytest.mark.usefixtures("few_rounds")
    def test_subset_is_fitted_under_a_condition_that_every_result_states(self, short, tmp_path):
        """With wrong values of the others the intervals exclude the truth: nothing in the recording tells."""
        commands, recording = short
        start = with_values(TRUTH, {"hip.kd": 3.0, "knee.kd": 3.0})
        found = identify(recording, commands, start=start, fitted=["kp"])
        estimate = found.estimates[0]
        assert abs(estimate.after - TRUTH.hip.kp) > estimate.half_width
        words = (
            "Estimates and intervals hold only if the motors' other values are right, which keep their start values: "
            "stall_torque, no_load_speed, kd, damping, friction_loss, armature, delay."
        )
        assert words in found.text()
        assert save_numbers(found, tmp_path, "")["assumed"] == list(found.assumed)

    @pytest.mark.usefixtures("few_rounds")
    def test_joint_that_hardly_follows_its_commands_is_named_and_can_be_left_out(self, short):
        commands, recording = short
        positions, velocities = recording.positions.copy(), recording.velocities.copy()
        positions[:, 2] = positions[0, 2] + 0.1 * (positions[:, 2] - positions[0, 2])
        velocities[:, 2] *= 0.1
        broken = JointTrajectory(recording.stamps, JOINT_NAMES, positions, velocities, recording.efforts)
        start = with_values(TRUTH, {"hip.kp": 40.0})
        whole = identify(broken, commands, start=start, fitted=["kp"])
        assert "RF_hip_joint moved 0." in whole.text()
        assert "--without RF_hip_joint" in whole.text()
        part = identify(broken, commands, start=start, fitted=["kp"], without=["RF_hip_joint"])
        assert part.after.hip.kp == pytest.approx(32.0, rel=0.02)
        assert np.isnan(part.errors(after=True)["position"][2])
        assert "RF_hip" not in part.text()

    @pytest.mark.parametrize(
        ("motors", "missing"),
        [
            (TRUTH, ("velocities", "efforts")),
            (with_values(MotorConfig(), {"hip.kp": 25.0, "knee.kp": 25.0, "delay": 0.03}), ()),
        ],
        ids=["positions alone", "weak and late"],
    )
    def test_recording_on_the_ground_is_refused_and_one_on_a_stand_is_not(self, motors, missing):
        commands = publish(SinusoidalGait.preset("article"), 2.0, 50.0)
        hung, stood = measured(commands, motors), noisy(play(commands, motors=motors).joints)
        on_stand, on_ground = (
            align(MINI_QUADRUPED, without(done, *missing), commands, 0.7, 0.005) for done in (hung, stood)
        )
        check_stand(on_stand, MotorConfig())
        with pytest.raises(QuadrupedError, match=r"seems to stand on the ground, .*record it on a stand.*\(--start\)"):
            check_stand(on_ground, MotorConfig())

    @pytest.mark.slow
    def test_intervals_contain_the_true_values(self):
        """Over two recordings, of all signals and of positions alone; of the intervals of 95 %, one of ten may miss."""
        start = with_values(TRUTH, {"hip.kp": 40.0, "knee.kp": 40.0, "hip.kd": 1.0, "knee.kd": 1.0, "delay": 0.0})
        missed = []
        for seed, missing in enumerate([(), ("velocities", "efforts")]):
            commands = commanded(5.0, seed=seed)
            recording = without(measured(commands, TRUTH, seed=seed), *missing)
            for estimate in identify(recording, commands, start=start, fitted=["kp", "kd", "delay"]).estimates:
                truth = value_of(TRUTH, estimate.name)
                assert estimate.half_width is not None
                assert estimate.half_width < 0.1 * truth
                missed += [estimate.name] * (abs(estimate.after - truth) > estimate.half_width)
        assert len(missed) <= 1, missed

    @pytest.mark.slow
    def test_known_motors_are_recovered_within_a_tenth(self):
        """All of them at once, starting from the model file's motors, from a noisy recording."""
        commands = commanded(10.0)
        found = identify(measured(commands, TRUTH), commands)
        for estimate in found.estimates:
            assert estimate.half_width is not None, estimate.name
            assert estimate.after == pytest.approx(value_of(TRUTH, estimate.name), rel=0.1), estimate.name
        before, after = found.errors(after=False), found.errors(after=True)
        np.testing.assert_allclose(after["position"], NOISE[0], rtol=0.1)
        assert (before["position"] > 10 * after["position"]).all()

    @pytest.mark.slow
    def test_motors_of_three_kinds_are_recovered(self):
        robot = twelve_joints.ROBOT
        own = robot.motors.hip
        truth = MotorConfig(
            hip=changed(own, kp=1.2 * own.kp, kd=0.7 * own.kd),
            knee=changed(own, kp=0.8 * own.kp, kd=1.3 * own.kd),
            abduction=changed(own, kp=0.9 * own.kp, kd=1.1 * own.kd),
            delay=0.012,
        )
        commands = commanded(5.0, robot=robot)
        found = identify(measured(commands, truth, robot=robot), commands, fitted=["kp", "kd", "delay"], robot=robot)
        assert len(found.estimates) == 7
        for estimate in found.estimates:
            assert estimate.after == pytest.approx(value_of(truth, estimate.name), rel=0.1), estimate.name

    @pytest.mark.slow
    @pytest.mark.skipif(not DYNA1.is_dir(), reason="needs the recording of Dyna1 in ../shared/data/dyna1")
    def test_legs_of_a_real_robot_are_fitted(self):
        """Dyna1 lifts and lowers itself; two of its hips do not move, whatever their commands."""
        layout = asset_path("dyna1.toml")
        recording, commands = (
            JointTrajectory.load(DYNA1 / name, columns=layout, joint_map=layout)
            for name in ("measured.csv", "control.csv")
        )
        broken = ["LF_hip_joint", "LH_hip_joint"]
        # It never came near its motors' limits.
        fitted = [name for name in FITTED if name != "stall_torque"]
        found = identify(recording, commands, without=broken, fitted=fitted)
        before, after = (found.errors(after=after)["position"] for after in (False, True))
        counted = np.array([name not in broken for name in JOINT_NAMES])
        assert (after[counted] < 0.6 * before[counted]).all()
        played = [replay(commands, measured=recording, motors=one).comparison for one in (found.before, found.after)]
        differences = [simulated.positions - recorded.positions for recorded, simulated in played]
        rms = [np.sqrt((difference[:, counted] ** 2).mean(axis=0)) for difference in differences]
        assert (rms[1] < 0.8 * rms[0]).all()


class TestProgram:
    @pytest.mark.usefixtures("few_rounds")
    def test_program_fits_motors_to_files(self, short, tmp_path, monkeypatch, capsys):
        monkeypatch.chdir(tmp_path)
        commands, recording = short
        recording.save("walk.csv")
        assert main(["identify", "walk.csv", "--fit", "kp", "delay"]) == 2
        assert capsys.readouterr().err.startswith(
            "mini-quadruped identify: error: walk.csv: no joint targets: there is no walk-commands.csv"
        )
        commands.save("walk-commands.csv")
        assert main(["identify", "walk.csv", "--fit", "kp"]) == 0
        output = capsys.readouterr().out
        assert "On held-out time the position error falls" in output
        report = "results/identify-walk/report.html"
        assert output.endswith(f"\nmotors and numbers: results/identify-walk\nreport: {report}\n")
        page = html.unescape(Path(report).read_text(encoding="utf-8"))
        assert page.count("data:image/svg+xml") == 3
        assert "hold only if the motors' other values are right" in page
        assert main(["identify", "walk.csv", "-o", "results/identify-walk"]) == 2
        assert "motors.json: exists already" in capsys.readouterr().err

    def test_targets_and_measured_joints_in_one_log(self, tmp_path, monkeypatch):
        """By the same map of joints, in the same file or in a file of their own."""
        monkeypatch.chdir(tmp_path)
        rng = np.random.default_rng(0)
        targets, positions = rng.uniform(-0.5, 0.5, (2, 30, 8))
        titles = ["time", *(f"q_des_{i}" for i in range(8)), *(f"q_{i}" for i in range(8))]
        table = np.column_stack([np.arange(30) * 0.02, targets, positions])
        lines = [",".join(titles), *(",".join(map(repr, row)) for row in table.tolist())]
        Path("log.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

        rules = "".join(f"[joints.{name}]\nsource = 'q_{i}'\n" for i, name in enumerate(JOINT_NAMES))
        measured = [f"q_{i}" for i in range(8)]
        told = "{ " + ", ".join(f"q_{i} = 'q_des_{i}'" for i in range(8)) + " }"
        for file, columns in (("q.toml", measured), ("des.toml", told)):
            Path(file).write_text(f"[columns]\nstamp = 'time'\npositions = {columns}\n{rules}", encoding="utf-8")

        def stop(measured, commands, *_, **__):
            found.append((measured.positions, commands.positions))
            raise QuadrupedError("seen")

        found = []
        monkeypatch.setattr("quadruped_env.identification.identify", stop)
        options = ["identify", "log.csv", "--columns", "q.toml", "--map", "q.toml", "--commands-columns", "des.toml"]
        assert main(options) == 2
        np.testing.assert_allclose(found[0], [positions, targets])
        assert main([*options, "--commands", "log.csv"]) == 2
        np.testing.assert_allclose(found[1], [positions, targets])
