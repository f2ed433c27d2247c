"""A robot whose motors are not its joints: other names, signs, zeros and units, and joints that two motors move."""

import threading
import time
from unittest.mock import MagicMock

import numpy as np
import pytest
from built_in import STANCE
from live_bench import Loop
from live_nodes import joint_state, received_from
from waiting import wait_until

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import Safety
from quadruped_env.live import Node, motor_swing
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointMerger, JointReader, command_message, read_target
from quadruped_env.live.middleware.topics import ESTOP, JOINT_COMMANDS, JOINT_STATES, TF
from quadruped_env.live.nodes import calibrate
from quadruped_env.live.nodes.calibrate import parsed_answer
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr
from quadruped_env.trajectory import JointMap, JointRule

MOTORS = tuple(f"m{i}" for i in range(8))
A = np.zeros((8, 8))
"""Angle of each joint per angle of each motor: two five-bar legs, a knee driven from the body, a geared leg."""
for leg in (0, 1):
    A[2 * leg : 2 * leg + 2, 2 * leg : 2 * leg + 2] = [[0.5, -0.5], [0.5, 0.5]]
A[4:6, 4:6] = [[-1.0, 0.0], [1.0, -1.0]]
A[6, 7], A[7, 6] = -0.5, 1.0
B = np.array([0.3, -0.8, 0.1, -0.6, 0.0, -0.4, 1.2, 0.2])
"""Angle of each joint where its motors are at 0, rad."""


@pytest.fixture(name="map_file")
def _map_file(tmp_path):
    """The robot's map, in degrees and with velocities in rpm, the joints in another order."""
    tables = []
    for joint, name in enumerate(JOINT_NAMES):
        weights = ", ".join(f"{MOTORS[i]} = {A[joint, i]}" for i in np.flatnonzero(A[joint]))
        tables.append(
            f"[joints.{name}]\nsources = {{ {weights} }}\noffset = {np.degrees(B[joint]):.17g}\nunit = 'deg'\n"
            f"velocity_unit = 'rpm'\n"
        )
    path = tmp_path / "robot.toml"
    path.write_text("\n".join(reversed(tables)))
    return path


def motor_angles(joints):
    """Degrees."""
    return np.degrees(np.linalg.solve(A, joints - B))


class MappedLoop(Loop):
    """The loop with messages of the motors between robot and controller, converted by the arrays above."""

    def __init__(self, path, velocities):
        super().__init__("tuned")
        self.driver = DriverJoints.load(path, MINI_QUADRUPED)
        self.velocities = velocities
        self.read = JointReader(self.driver, states=True)
        self.merger = JointMerger(self.driver, True, rates=self.driver.rates)
        robot, self._commands = self.robot, JointReader(self.driver)
        self.set_target, robot.command = robot.command, self.command

    def measurement(self):
        true = super().measurement()
        order = np.random.default_rng(self.steps).permutation(8)
        rpm = np.linalg.solve(A, true.velocities) * 30.0 / np.pi
        for half in (order[:3], order[3:]):
            message = joint_state(
                true.stamp,
                [MOTORS[i] for i in half] + ["tail"],
                [*motor_angles(true.positions)[half], 9.0],
                [*rpm[half], 9.0] if self.velocities else (),
            )
            state = self.merger.add(self.read(cdr.serialize(message)))
        if state is None:
            return true  # the first one, which has no velocities yet
        joints = self.driver.to_robot(state)
        return true._replace(positions=joints.positions, velocities=joints.velocities)

    def command(self, target):
        data = command_message(self.driver, 1, self.driver.target_to_driver(target))
        sent = read_target(self._commands(data))
        assert cdr.deserialize(data, JOINT_COMMANDS.type_name).name == list(self.driver.joint_names)
        degrees = np.zeros(8)
        degrees[[MOTORS.index(name) for name in self.driver.joint_names]] = sent
        self.set_target(LIMP if sent is LIMP else A @ np.radians(degrees) + B)


def test_controller_walks_through_the_map_as_without_it(map_file):
    plain, mapped = Loop("tuned"), MappedLoop(map_file, velocities=True)
    for loop in (plain, mapped):
        loop.run(4.0, (0.2, 0.1))
    assert mapped.time == plain.time
    assert plain.robot.state.base_position[0, 0] != 0.0
    for name in ("base_position", "joint_position"):
        np.testing.assert_allclose(
            getattr(mapped.robot.state, name), getattr(plain.robot.state, name), atol=1e-6, err_msg=name
        )
    measured, true = mapped.measurement(), Loop.measurement(mapped)
    np.testing.assert_allclose(measured.positions, true.positions, atol=1e-12)
    np.testing.assert_allclose(measured.velocities, true.velocities, atol=1e-9)
    mapped.live_controller.emergency_stop(True)
    mapped.command(LIMP)
    assert mapped.robot.limp


def test_missing_velocities_are_computed_in_the_maps_unit(map_file):
    loop = MappedLoop(map_file, velocities=False)
    loop.run(4.0, (0.2, 0.0))
    errors, sizes = [], []
    for _ in range(100):
        loop.run(0.01)
        measured, true = loop.measurement(), Loop.measurement(loop)
        errors.append(measured.velocities - true.velocities)
        sizes.append(true.velocities)
    # A filter of 10 ms lags; a wrong unit would be wrong by a factor.
    assert np.std(errors) < 0.6 * np.std(sizes)
    assert np.std(np.add(errors, sizes)) == pytest.approx(np.std(sizes), rel=0.3)


def test_joint_is_known_once_all_of_its_motors_are(map_file):
    """For drivers with a message per motor: `state` and `view` use what they know."""
    driver = DriverJoints.load(map_file, MINI_QUADRUPED)
    read = JointReader(driver, states=True)
    degrees = motor_angles(STANCE)
    known = []
    for motor in (5, 4, 0, 5):
        message = joint_state(1, [MOTORS[motor]], [degrees[motor]], [1.0], [2.0])
        joints = driver.to_robot(read(cdr.serialize(message)))
        found = np.flatnonzero(np.isfinite(joints.positions))
        np.testing.assert_allclose(joints.positions[found], STANCE[found])
        assert np.isfinite(joints.efforts[found]).all()
        known.append(found.tolist())
    # Joint 4 has motor 4 alone, joint 5 has motors 4 and 5, joints 0 and 1 need motor 1 too.
    assert known == [[], [4, 5], [], [5]]
    other = driver.to_robot(read(cdr.serialize(joint_state(2, ["tail"], [1.0]))))
    assert (other.others, np.isnan(other.positions).all()) == (("tail",), True)


UNITS = (
    ({"unit": "turn", "velocity_unit": "rpm"}, 9.0 / (2 * np.pi), 270.0 / np.pi),
    ({"unit": "ticks", "ticks_per_turn": 65536, "velocity_unit": "rpm"}, 9.0 * 65536 / (2 * np.pi), 270.0 / np.pi),
    ({"unit": "ticks", "ticks_per_turn": 65536}, *[9.0 * 65536 / (2 * np.pi)] * 2),
)


@pytest.mark.parametrize(("units", "position", "velocity"), UNITS)
@pytest.mark.parametrize("states", [True, False])
def test_limits_of_messages_hold_after_the_map(units, position, velocity, states):
    """Motors before a gear of 9, in units of which a rad and a rad/s of the joint are `position` and `velocity`.

    They count 5000 rad where the joint is at 0, as encoders of many turns may.
    """
    offset = -5000.0 * position / 9.0
    rules = {name: JointRule(f"m{i}", gear=9.0, offset=offset, **units) for i, name in enumerate(JOINT_NAMES)}
    driver = DriverJoints(MINI_QUADRUPED, JointMap(rules))
    read = JointReader(driver, states=states)

    def joints(angle, speed):
        message = joint_state(1, MOTORS, np.full(8, (angle + 5000.0) * position), np.full(8, speed * velocity))
        return driver.to_robot(read(cdr.serialize(message)))

    for angle, speed in ((0.7, 0.0), (1.5, 31.0), (-999.0, 999.0)):
        found = joints(angle, speed)
        np.testing.assert_allclose([found.positions, found.velocities], np.outer([angle, speed], np.ones(8)), atol=1e-9)
    for angle, speed, field in ((1001.0, 0.0, "position"), (0.0, -1001.0, "velocity")):
        with pytest.raises(QuadrupedError, match=rf"{field} of m0 is .*; send finite numbers of at most \d"):
            joints(angle, speed)


def test_map_that_does_not_fit_the_robot_is_refused(tmp_path, map_file):
    def refused(text, words):
        path = tmp_path / "wrong.toml"
        path.write_text(text)
        with pytest.raises(QuadrupedError, match=f"wrong.toml: .*{words}"):
            DriverJoints.load(path, MINI_QUADRUPED)

    whole = map_file.read_text()
    refused(whole.replace("LF_hip", "FL_hip"), r"one for each joint of mini_quadruped: LF_hip_joint, ")
    refused(whole.replace("m6 = 1.0", "m7 = 1.0"), r"8 joints .* do not determine the 7 sources")
    units = r"m0 is in deg and rpm for \[joints\.LF_knee_joint\], and in deg and deg/s for \[joints\.LF_hip_joint\]"
    refused("deg/s".join(whole.rsplit("rpm", 1)), units)
    assert len(DriverJoints.load(map_file, MINI_QUADRUPED, commands=False).joint_names) == 8


def test_nodes_speak_the_drivers_joints(run_node, nodes, map_file):
    listener = nodes("listener")
    states, poses = listener.subscribe(JOINT_STATES), listener.subscribe(TF)
    commands = listener.subscribe(JOINT_COMMANDS)
    run_node("sim", "--map", str(map_file))
    run_node("state", "--map", str(map_file))
    log = run_node("controller", "tuned", "--map", str(map_file))
    wait_until(lambda: "following the command" in log.said, lambda: log.said)
    command = commands.decode(received_from(commands, 1)[-1])
    assert sorted(command.name) == [*MOTORS]
    # Standing, each joint is near its target; the transforms follow from the measured joints.
    targets = A @ np.radians(command.position)[np.argsort(command.name)] + B
    np.testing.assert_allclose(targets, STANCE, atol=0.05)
    state = states.decode(received_from(states, 1)[-1])
    joints = A @ np.radians(state.position)[np.argsort(state.name)] + B
    np.testing.assert_allclose(joints, STANCE, atol=0.2)
    messages = [poses.decode(one) for one in received_from(poses, 200)]
    sent = next(one for one in reversed(messages) if len(one.transforms) == 8)
    knee = next(one.transform.rotation for one in sent.transforms if one.child_frame_id == "RH_leg")
    assert 2.0 * np.arcsin(knee.y) == pytest.approx(joints[7], abs=0.2)
    with pytest.raises(AssertionError):
        np.testing.assert_allclose(joints, np.radians(state.position), atol=0.2)


TICKS = 65536 / (2.0 * np.pi)
"""Ticks of the motors' encoders per rad."""


class Hanging:
    """A driver of motors that follow their targets, in ticks; their angles here are in rad."""

    def __init__(self):
        self.node = Node("driver")
        self.names = (*MOTORS, "gripper")
        self.states = self.node.publish(JOINT_STATES)
        self.stops = self.node.publish(ESTOP)
        motors = type("Motors", (), {"joint_names": self.names, "limits": {"position": np.inf}})
        self.read = JointReader(motors)
        self.commands = self.node.subscribe(JOINT_COMMANDS, Qos(1000), read=self.read)
        self.motors = np.radians(np.append(motor_angles(0.1 * STANCE), 0.7))
        self.rest = self.motors.copy()
        self.targets = []
        self.limp = True
        self.fault = ""
        self.running = True
        self.thread = threading.Thread(target=self.run)

    def run(self):
        while self.running:
            for _, joints in self.commands.messages(pytest.fail):
                self.limp = read_target(joints) is LIMP
                if not self.limp:
                    self.targets.append(joints.positions / TICKS)
            if self.targets and not self.limp:
                way = self.targets[-1] - self.rest
                self.motors = self.rest + (-way if self.fault == "reversed" else way)
            if self.fault != "silent" or self.limp:
                half = len(self.names) // 2
                for part in (slice(half), slice(half, None)):
                    self.states.send(joint_state(time.time_ns(), self.names[part], TICKS * self.motors[part]))
            time.sleep(0.005)


class Person:
    """Keys of a person, instead of a keyboard."""

    gone = False
    log = None

    def __init__(self, robot):
        self.robot = robot
        self.answered = 0
        self.reasons = {
            "stop": "",
            "reversed": "rad away from its target",
            "silent": "no state for 1 s",
            "estop": "emergency stop (/estop)",
        }
        self.faults = list(self.reasons)
        self.seen_reasons = set()
        self.wrong = False

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def pressed(self, seconds):
        time.sleep(min(seconds, 0.005))
        lines = [line for line in self.log.said.splitlines() if line.startswith("[calibrate] ")]
        if seconds == 0.0:
            return self._stopped(lines[-1])
        fresh = [line.removeprefix("[calibrate] ") for line in lines[self.answered :]]
        self.answered = len(lines)
        self.reason = next((line for line in fresh if line.startswith("m0: stopped, limp: ")), "")
        answers = [answer for line in fresh if (answer := self._answer(line)) is not None]
        return [*answers[0], "\n"] if answers else []

    def _stopped(self, line):
        """A key once the motor is out, or as soon as something is wrong."""
        robot = self.robot
        robot.fault = self.faults[0] if self.faults else ""
        if robot.fault == "estop" and robot.targets:
            robot.stops.send(cdr.message(ESTOP.type_name, data=True))
        if robot.fault in ("reversed", "silent", "estop"):
            return []
        return ["x"] if robot.targets and np.abs(robot.targets[-1] - robot.rest).max() > 0.9 * motor_swing.ANGLE else []

    def _answer(self, line):
        robot = self.robot
        if "hang free? Type yes" in line:
            assert not robot.targets, "nothing moves before"
            return "yes"
        if "which joints turned" in line:
            wait_until(lambda: robot.limp)
            if self.faults:
                # Another reason, as where this machine was busy for 1 s, is no answer to the fault: again.
                expected = self.reasons[self.faults[0]]
                if bool(expected) == bool(self.reason) and self.reason.endswith(expected):
                    self.seen_reasons.add(self.faults.pop(0))
                robot.stops.send(cdr.message(ESTOP.type_name, data=False))
                robot.targets.clear()
                return ""
            return self._seen(line)
        if "a motor to move again" in line:
            return "" if line.startswith("Enter") else "m6"
        if "hold the leg still" in line:
            leg = [JOINT_NAMES.index(name) for name in line.split(": ")[0].split(", ")]
            angles = [0.0, 0.0] if leg[0] else [20.0, -30.0]
            joints = A @ robot.motors[:8] + B
            joints[leg] = np.radians(angles)
            robot.motors[:8] = np.radians(motor_angles(joints))
            # All states that the wizard can average are of this angle: each is two messages.
            count = robot.states.count
            wait_until(lambda: robot.states.count > count + 4 * Safety.fresh_states)
            return "" if leg[0] else "20 -30"
        return None

    def _seen(self, line):
        """Joints that turned on the way out, by their true motion."""
        robot, name = self.robot, line.split(":")[0]
        targets = np.array(robot.targets)
        robot.targets.clear()
        motor = robot.names.index(name)
        assert np.ptp(np.delete(targets, motor, axis=1), axis=0).max() == 0.0, "the others hold"
        np.testing.assert_allclose(targets[0], robot.rest, atol=0.02)
        robot.motors = robot.rest.copy()
        out = targets[-1] - targets[0]
        turned = (A @ out[:8]) / np.abs(out[motor])
        if name == "m6" and not self.wrong:
            # A wrong answer first: the map is refused, and the motor moves again.
            self.wrong = True
            return "RH_hip+"
        words = [f"{i + 1}{turned[i]:+.2f}" for i in np.flatnonzero(turned)]
        return " ".join(words) or "none"


def test_wizard_recovers_the_map_and_stops_when_something_is_wrong(domain_id, run_node, tmp_path, monkeypatch):
    robot = Hanging()
    person = Person(robot)
    monkeypatch.setattr(calibrate, "Keyboard", lambda: person)
    # Faster than with a real robot.
    monkeypatch.setattr(motor_swing, "_SWING_TIME", 0.15)
    path = tmp_path / "found.toml"
    unit = ["--unit", "ticks", "--ticks-per-turn", "65536"]
    person.log = log = run_node("calibrate", str(path), *unit)
    robot.thread.start()
    try:
        wait_until(lambda: "wrote" in log.said or "ended after" in log.said, lambda: log.said)
    finally:
        robot.running = False
        robot.thread.join()
        robot.node.close()
    found = JointMap.load(path)
    assert tuple(found.rules) == JOINT_NAMES
    positions = np.random.default_rng(0).uniform(-1.0, 1.0, (20, 8))
    expected = positions @ A.T + B
    measured = found.to_joints(MOTORS, {"position": TICKS * positions})["position"]
    np.testing.assert_allclose(measured, expected, atol=2e-3)
    assert found.rules["RH_knee_joint"].source == "m6"
    assert found.rules["RH_hip_joint"].sign == -1.0
    assert person.seen_reasons == set(person.reasons)
    assert "no motor moves RH_knee_joint" in log.said


def test_swing_is_smooth_and_peaks_at_the_angle_and_the_speed(monkeypatch):
    unit = 2.0 * np.pi / 65536
    for name in ("JointReader", "JointMerger", "CommandPublisher", "EmergencyStop"):
        monkeypatch.setattr(motor_swing, name, MagicMock())
    swing = motor_swing.MotorSwing(MagicMock(), motor_swing.Motors(MOTORS, unit))
    times = np.linspace(0.0, 5.0, 50_001)
    way = unit * np.array([swing._offset(t) for t in times])
    assert way.min() == 0.0
    assert way.max() == pytest.approx(0.15)
    velocity = np.diff(way) / np.diff(times)
    assert np.abs(velocity).max() == pytest.approx(0.3, rel=1e-3)
    assert np.abs(np.diff(velocity)).max() < 1e-2, "no step in the velocity"


@pytest.mark.parametrize("answer", ["9+", "LF+", "1", "+1", "1+0", "1+ LF_hip-0.5", "1*2"])
def test_answer_that_names_no_joint_is_refused(answer):
    assert parsed_answer("LF_hip+, 2-0.5", JOINT_NAMES) == {0: 1.0, 1: -0.5}
    with pytest.raises(QuadrupedError, match="expected the number or the beginning of a joint's name"):
        parsed_answer(answer, JOINT_NAMES)
