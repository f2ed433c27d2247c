"""Joint targets that are not finite: from policies, observations and maps, they reach no motor on any output."""

import itertools
import json
import math
from dataclasses import replace
from hashlib import sha256
from types import SimpleNamespace

import numpy as np
import pytest
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE
from live_bench import EPOCH, Bench, Recording
from live_nodes import joint_state, received_from
from policies import make_policy
from safetensors.numpy import save
from waiting import wait_until

from quadruped_env import JOINT_NAMES, QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.control.controllers import PolicyController
from quadruped_env.control.joint_command import INVALID_TIMEOUT, LIMP, MAX_TARGET, TargetGate, limited
from quadruped_env.control.live_controller import LiveController, Measurement, Mode
from quadruped_env.control.observations import ObservationLayout
from quadruped_env.live.command_publisher import CommandPublisher
from quadruped_env.live.messages.driver_joints import DriverJoints
from quadruped_env.live.messages.joint_messages import JointReader, read_target
from quadruped_env.live.middleware.topics import (
    CLOCK,
    DIAGNOSTICS,
    IMU,
    JOINT_COMMANDS,
    JOINT_POSITIONS,
    JOINT_STATES,
)
from quadruped_env.live.motor_swing import MotorSwing
from quadruped_env.live.nodes import controller as controller_node
from quadruped_env.policies import load_policy
from quadruped_env.policies.activations import ACTIVATIONS
from quadruped_env.policies.files import read_policy
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.ros import Qos, cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

INVALID = [math.nan, math.inf, -math.inf, 1e30]
PERIOD = 10_000_000
"""Of the states, ns."""


# --- the gate


def test_limited_targets_are_finite_and_slow_whatever_target_and_last_one_are():
    rng = np.random.default_rng(0)
    values = np.array([*INVALID, -1e30, 0.3, -0.4])
    for _ in range(500):
        target, last = rng.choice(values, (2, 8))
        found = limited(MINI_QUADRUPED, target, last, 0.02)
        assert ((found >= JOINT_POSITION_LOW) & (found <= JOINT_POSITION_HIGH)).all()
        within = rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH)
        assert np.abs(limited(MINI_QUADRUPED, target, within, 0.02) - within).max() <= 0.1 + 1e-12
    target = STANCE.copy()
    target[3] = math.nan
    np.testing.assert_array_equal(limited(MINI_QUADRUPED, target, STANCE, 0.02), STANCE)


@pytest.mark.parametrize("value", INVALID)
def test_gate_holds_for_its_timeout_and_then_demands_that_the_motors_are_disabled(value):
    said = []
    gate = TargetGate(JOINT_NAMES, said.append)
    invalid = np.array([0.0, 0.0, value, *[0.0] * 5])
    assert gate.passes(np.full(8, MAX_TARGET), 4.9)
    assert not gate.passes(invalid, 5.0)
    assert not gate.passes(invalid, 5.0 + 0.9 * INVALID_TIMEOUT)
    # A valid one in between does not begin the time again.
    assert gate.passes(STANCE, 5.0 + 0.95 * INVALID_TIMEOUT)
    assert gate.fault == f"the joint target of RF_hip_joint is {value}"
    with pytest.raises(QuadrupedError, match="the joint target of RF_hip_joint is"):
        gate.passes(invalid, 5.0 + INVALID_TIMEOUT)
    assert gate.passes(STANCE, 5.1 + 2 * INVALID_TIMEOUT)
    assert gate.fault == ""
    assert not gate.passes(invalid, 9.0)
    assert said == [f"{gate.fault}: the last valid targets are held"] * 2


@pytest.mark.parametrize("arrays", [False, True])
@pytest.mark.parametrize("value", INVALID)
def test_publisher_sends_the_last_valid_targets_and_then_limp(nodes, monkeypatch, value, arrays):
    now = 100.0
    monkeypatch.setattr("quadruped_env.live.command_publisher.time", SimpleNamespace(monotonic=lambda: now))
    topic = JOINT_POSITIONS if arrays else JOINT_COMMANDS
    commands = nodes().subscribe(topic, Qos(100))
    publisher = CommandPublisher(session_of(nodes(), []), MINI_QUADRUPED, arrays)
    wait_until(lambda: commands.writers)
    invalid = np.where(np.arange(8) == 5, value, STANCE)
    publisher.send(1, STANCE)
    for _ in range(3):
        publisher.send(2, invalid)
    now += INVALID_TIMEOUT
    with pytest.raises(QuadrupedError, match="the joint target of LH_knee_joint is"):
        publisher.send(3, invalid)
    sent = [targets_of(commands, one) for one in received_from(commands, 4 if arrays else 5)]
    np.testing.assert_array_equal(sent[:4], [STANCE] * 4)
    assert sent[4:] == [] if arrays else sent[4:] == [LIMP]
    # After limp there is nothing to hold.
    now += 10.0
    with pytest.raises(QuadrupedError):
        publisher.send(4, invalid)
    assert arrays or targets_of(commands, received_from(commands, 1)[0]) is LIMP


def session_of(node, said):
    """What a publisher of commands needs of a session, which does not listen for other publishers."""
    return SimpleNamespace(
        node=node, say=said.append, running=False, every_turn=[], refuse=pytest.fail,
        turns=lambda remaining: itertools.cycle([None]),
    )  # fmt: skip


def targets_of(commands, received):
    """The targets of a message in either format, or `LIMP`."""
    if commands.topic == JOINT_POSITIONS:
        return np.array(commands.decode(received).data)
    return read_target(JointReader(MINI_QUADRUPED)(received.data))


# --- the live controller


class Failing(Recording):
    """A controller whose targets are `value` from its n-th call on, as long as `broken`."""

    def __init__(self, value, after=1):
        super().__init__()
        self.value, self.after, self.broken = value, after, True

    def act(self, observation, control):
        target = super().act(observation, control)
        if self.broken and len(self.commands) > self.after:
            target[0, 5] = self.value
        return target


@pytest.mark.parametrize("value", INVALID)
def test_live_controller_holds_then_goes_limp_and_recovers_as_after_any_limp(value):
    bench = Bench(Failing(value, after=80))
    bench.walk()
    last = bench.answers[-1].target
    answers = bench.pass_time(2.0, command=(0.3, 0.0))
    limp = [i for i, answer in enumerate(answers) if answer.target is LIMP]
    assert len(limp) >= 1
    held = answers[: limp[0]]
    assert len(held) >= INVALID_TIMEOUT / 0.02
    np.testing.assert_array_equal([answer.target for answer in held], [last] * len(held))
    assert f"the joint target of LH_knee_joint is {value}: the last valid targets are held" in bench.said
    assert any(text.startswith(f"limp (the joint target of LH_knee_joint is {value}") for text in bench.said)
    assert all(np.isfinite(answer.target).all() for answer in bench.answers if answer.target is not LIMP)
    assert bench.live_controller.fault
    assert bench.live_controller.fail("the driver's targets are invalid").target is LIMP
    assert (bench.mode, bench.live_controller.fault) == (Mode.LIMP, "the driver's targets are invalid")
    bench.controller.broken = False
    bench.pass_time(4.0, command=(0.3, 0.0))
    assert bench.mode is Mode.WALKING
    assert bench.live_controller.fault == ""


def test_one_invalid_target_does_not_stay_in_the_last_action_or_the_history():
    """The memory stays as it was before the step in which a policy gave NaN."""
    policy = load_policy("flat")
    assert policy.control.observation_history > 1
    bench = Bench(PolicyController(policy))
    bench.walk()
    predict, asked = policy.predict, []

    def once(observation):
        asked.append(observation)
        return predict(observation) * (np.nan if len(asked) == 3 else 1.0)

    object.__setattr__(policy, "predict", once)
    bench.pass_time(1.0, command=(0.3, 0.0))
    assert len(asked) >= 49
    assert np.isfinite(asked).all()
    assert bench.mode is Mode.WALKING
    assert bench.live_controller.fault == ""
    assert all(np.isfinite(answer.target).all() for answer in bench.answers)


@pytest.mark.parametrize("value", [math.nan, math.inf, 1e30])
@pytest.mark.parametrize("field", ["positions", "velocities", "orientation", "angular_velocity"])
def test_measurement_that_is_not_finite_is_refused_and_counts_as_none(field, value):
    bench = Bench(PolicyController(load_policy("flat")))
    bench.walk()
    good = Measurement(0, bench.positions, np.zeros(8), bench.orientation, np.zeros(3))
    for _ in range(50):
        bench.now += 0.01
        bad = getattr(good, field).copy()
        bad[1] = value
        with pytest.raises(QuadrupedError, match=r"the measurement holds .* expected finite numbers of at most 1000"):
            bench.live_controller.measured(
                good._replace(**{field: bad, "stamp": EPOCH + round(bench.now * 1e9)}), bench.now
            )
        if (answer := bench.live_controller.silent(bench.now)) is not None:
            bench.answers.append(answer)
    assert bench.mode is Mode.HOLDING
    bench.pass_time(4.0, command=(0.3, 0.0))
    assert bench.mode is Mode.WALKING
    assert all(np.isfinite(answer.target).all() for answer in bench.answers)


# --- policies


def spoiled(policy, change, layers=None):
    """A copy of a policy whose weights are changed."""
    weights = [change(weight) if layers is None or i in layers else weight for i, weight in enumerate(policy.weights)]
    return replace(policy, weights=tuple(np.float32(weight) for weight in weights))


def planted(value):
    def change(weight):
        weight = weight.copy()
        weight[0, 0] = value
        return weight

    return change


SPOILED = {
    "NaN": (planted(math.nan), (1,)),
    "infinity": (planted(math.inf), (0,)),
    "1e30 in all layers": (planted(1e30), None),
    "times 1e20": (lambda weight: weight * np.float32(1e20), None),
}


@pytest.mark.parametrize("name", SPOILED)
def test_policy_that_is_not_finite_within_its_observations_bounds_is_refused_by_every_loader(
    name, tmp_path, capsys, domain_id
):
    good = load_policy("flat")
    policy, directory = spoiled(good, *SPOILED[name]), tmp_path / "run"
    with pytest.raises(QuadrupedError, match=r"save: layer\d (can exceed float32|holds NaN or infinity), so that"):
        policy.save(directory)
    with pytest.raises(QuadrupedError, match="live controller: layer"):
        LiveController(PolicyController(policy))
    # Another program wrote the weights, and put the card's hash right.
    good.save(directory)
    tensors = {f"layer{i}.weight": weight for i, weight in enumerate(policy.weights)}
    tensors |= {f"layer{i}.bias": bias for i, bias in enumerate(policy.biases)}
    content = save(tensors)
    (directory / TENSORS_FILE).write_bytes(content)
    card = json.loads((directory / CARD_FILE).read_text()) | {"weights_sha256": sha256(content).hexdigest()}
    (directory / CARD_FILE).write_text(json.dumps(card))
    for load in (load_policy, read_policy):
        with pytest.raises(QuadrupedError, match=r"policy\.safetensors: layer\d .*, so that joint targets become NaN"):
            load(directory)
    for command in (["export", str(directory), "-o", str(tmp_path / "out")], ["live", "controller", str(directory)]):
        assert main(command) == 2
        assert "so that joint targets become NaN" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def last_layer(policy, x):
    """Its values, on a processor without fused multiply-add, which would hide NaN between infinities."""
    for i, (weight, bias) in enumerate(zip(policy.weights, policy.biases, strict=True)):
        x = (ACTIVATIONS[policy.activation](x) if i else x)[..., None] * weight
        x = x.sum(axis=-2, dtype=np.float32) + bias
    return x


@pytest.mark.parametrize("activation", ["elu", "relu", "silu", "gelu", "selu", "mish", "softplus", "tanh"])
def test_policy_that_passes_the_check_is_finite_in_all_corners_of_the_bounds(activation):
    """Weights are scaled to where the check just passes. One corner reaches the bound of the hidden layers."""
    good = spoiled(make_policy(activation), np.abs, layers=(0, 1))

    def passes(factor):
        try:
            spoiled(good, lambda weight: weight * factor).check_is_data("test")
        except QuadrupedError:
            return False
        return True

    low, high = 1.0, 1e38
    for _ in range(60):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if passes(middle) else (low, middle)
    policy = spoiled(good, lambda weight: weight * low)
    assert high / low < 1.001
    bounds = np.tile(ObservationLayout(MINI_QUADRUPED).high, policy.control.observation_history)
    corners = np.random.default_rng(0).choice([-1.0, 1.0], (1000, len(bounds))) * bounds
    aligned = np.sign(policy.weights[0].T) * bounds
    with np.errstate(all="ignore"):
        for observations in (corners, aligned, -aligned, np.zeros((1, len(bounds)))):
            assert np.isfinite(policy.predict(observations.astype(np.float32))).all()
            assert np.isfinite(last_layer(policy, observations.astype(np.float32))).all()


# --- maps


def map_file(path, **changes):
    """A map of the robot's joints on motors m0 to m7."""
    tables = []
    for i, name in enumerate(JOINT_NAMES):
        rule = {"source": f'"m{i}"', **changes}
        tables.append(f"[joints.{name}]\n" + "\n".join(f"{key} = {value}" for key, value in rule.items()))
    path.write_text("\n".join(tables))
    return path


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"scale": "nan"}, "scale: expected a finite number; found nan"),
        ({"scale": "inf"}, "scale: expected a finite number; found inf"),
        ({"offset": "nan"}, "offset: expected a finite number; found nan"),
        ({"scale": "1e-30"}, r"targets of m0 reach .*e\+30, and at most 1e\+12 may be sent; check sources, scale and"),
        ({"offset": "1e14"}, r"targets of m0 reach -1e\+14, and at most"),
    ],
)
def test_map_with_which_targets_would_be_absurd_is_refused(tmp_path, changes, words):
    with pytest.raises(QuadrupedError, match=words):
        DriverJoints.load(map_file(tmp_path / "robot.toml", **changes), MINI_QUADRUPED)


def test_states_of_an_absurd_map_never_move_the_robot(tmp_path):
    """Joints turn by 1e14 rad per rad of their motors: their states are refused."""
    driver = DriverJoints.load(map_file(tmp_path / "robot.toml", scale=1e14), MINI_QUADRUPED)
    read = JointReader(driver, states=True)
    with pytest.raises(QuadrupedError, match=r"position of m0 is 0\.1; send finite numbers of at most 1e-11"):
        read(cdr.serialize(joint_state(1, driver.joint_names)))
    with pytest.raises(QuadrupedError, match="a joint target is not finite"):
        driver.target_to_robot(np.full(8, 1e300))


# --- the nodes


def drive(nodes, run_node, *arguments, every=1):
    """Run a controller in simulated time.

    Returns a function that advances it by 10 ms and sends a state every so many times, the ends of the topics of
    commands and diagnostics, and the log.
    """
    robot = nodes("driver")
    ends = {topic: robot.publish(topic) for topic in (CLOCK, IMU, JOINT_STATES)}
    commands = robot.subscribe(JOINT_POSITIONS if "--arrays" in arguments else JOINT_COMMANDS, Qos(5000))
    statuses = robot.subscribe(DIAGNOSTICS, Qos(100))
    log = run_node("controller", "--sim-time", *arguments)
    wait_until(lambda: all(end.readers for end in ends.values()), lambda: log.said)
    stamp, rng = 10**9, np.random.default_rng(0)

    def send():
        nonlocal stamp
        stamp += PERIOD
        header = cdr.header(stamp)
        ends[CLOCK].send(cdr.message(CLOCK.type_name, clock=header.stamp))
        if stamp // PERIOD % every:
            return
        # Sensors that repeat themselves bit for bit while the robot moves would be refused.
        noise = rng.normal(0.0, 1e-5, 9)
        turning = {"x": noise[0]}
        ends[IMU].send(cdr.message(IMU.type_name, header=header, orientation={"w": 1.0}, angular_velocity=turning))
        ends[JOINT_STATES].send(joint_state(stamp, JOINT_NAMES, STANCE + noise[1:], np.zeros(8)))

    return send, commands, statuses, log


@pytest.mark.parametrize(("value", "arrays"), [(math.nan, ()), (1e30, ("--arrays",))])
def test_controller_node_with_a_controller_that_fails_sends_finite_targets_then_limp(
    nodes, run_node, monkeypatch, value, arrays
):
    spec = SimpleNamespace(make=lambda: Failing(value, after=20))
    monkeypatch.setattr(controller_node, "find_controller", lambda *rest: spec)
    send, commands, statuses, log = drive(nodes, run_node, *arrays)
    sent, levels = [], []

    def limp():
        send()
        sent.extend(targets_of(commands, one) for one in commands.take())
        for one in statuses.take():
            (status,) = statuses.decode(one).status
            levels.append((status.level, status.message))
        return any(level == 2 and "the joint target of LH_knee_joint is" in message for level, message in levels)

    wait_until(limp, lambda: log.said, interval=0.002)
    assert f"the joint target of LH_knee_joint is {value}: the last valid targets are held" in log.said
    assert f"limp (the joint target of LH_knee_joint is {value}" in log.said
    assert all(np.isfinite(target).all() for target in sent if target is not LIMP)
    assert arrays or any(target is LIMP for target in sent)


def test_controller_node_that_ends_with_an_error_lets_the_robot_go_limp(nodes, run_node, monkeypatch):
    class Broken(Recording):
        def act(self, observation, control):
            raise ZeroDivisionError

    monkeypatch.setattr(controller_node, "find_controller", lambda *rest: SimpleNamespace(make=Broken))
    send, commands, _, log = drive(nodes, run_node)
    sent = []

    def ended():
        send()
        sent.extend(targets_of(commands, one) for one in commands.take())
        return sent and sent[-1] is LIMP

    wait_until(ended, lambda: log.said, interval=0.002)


def test_controller_node_whose_map_fails_lets_the_robot_go_limp(nodes, run_node, monkeypatch):
    to_driver, calls = DriverJoints.target_to_driver, itertools.count()

    def failing(self, target):
        if target is not LIMP and next(calls) >= 20:
            raise QuadrupedError("the map fails")
        return to_driver(self, target)

    monkeypatch.setattr(DriverJoints, "target_to_driver", failing)
    send, commands, _, log = drive(nodes, run_node)
    sent = []

    def limp():
        send()
        sent.extend(targets_of(commands, one) for one in commands.take())
        return len(sent) > 20 and sent[20] is LIMP

    wait_until(limp, lambda: log.said, interval=0.002)
    assert "limp (the map fails" in log.said


def test_calibration_whose_targets_fail_ends_the_motion_limp(nodes, monkeypatch):
    monkeypatch.setattr(MotorSwing, "_offset", lambda self, elapsed: math.nan if elapsed > 0.1 else 0.0)
    monkeypatch.setattr(MotorSwing, "_danger", lambda self, *rest: "")
    node, robot, said = nodes("calibrate"), nodes("driver"), []
    commands = robot.subscribe(JOINT_COMMANDS, Qos(5000))
    swing = MotorSwing(session_of(node, said), SimpleNamespace(joint_names=JOINT_NAMES, unit=1.0))
    monkeypatch.setattr(swing, "positions", STANCE.copy)
    wait_until(lambda: commands.writers)
    swing._recent.append(STANCE)
    swing._stamp, swing._heard = 1, math.inf
    assert "the joint target of LF_knee_joint is nan" in swing.swing(1, 1.0, lambda: False)
    sent = [targets_of(commands, one) for one in received_from(commands, 2)]
    assert sent[-1] is LIMP
    assert all(np.isfinite(target).all() for target in sent if target is not LIMP)
    assert len(said) == 1
