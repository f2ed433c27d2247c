"""Position servos that do not follow their targets exactly: closed forms of steps, backlash and dead band."""

import dataclasses
import json
import math

import gymnasium
import half_robot
import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.envs import ENV_ID
from quadruped_env.live.simulated import SimulatedRobot
from quadruped_env.replay.motors_file import read_motors
from quadruped_env.robot import MINI_QUADRUPED, MOTOR_PRESETS, JointMotor, MotorConfig, Robot
from quadruped_env.robot.motors import servo_target
from quadruped_env.task import TaskConfig

STEP, PLAY, BAND = 0.05, 0.03, 0.02
HALF_WITH_SERVOS = dataclasses.replace(half_robot.DESIGN, name="servos", motors=MOTOR_PRESETS["mg996r"])


def followed(targets, step=0.0, backlash=0.0, start=0.0):
    """Targets (T,) as a servo without a dead band pursues them (T,)."""
    play = np.full((1, 1), start)
    return np.array([servo_target(np.array([[t]]), play, play, step, backlash, 0.0)[0, 0] for t in targets])


def test_step_makes_a_staircase_within_half_a_step():
    targets = np.linspace(-0.3, 0.3, 6001)
    stairs = followed(targets, step=STEP)
    assert abs(stairs - targets).max() == pytest.approx(STEP / 2)
    heights, counts = np.unique(stairs.round(12), return_counts=True)
    np.testing.assert_allclose(heights, STEP * np.arange(-6, 7), atol=1e-12)
    assert set(counts[1:-1]) <= {499, 500, 501}


def test_backlash_makes_a_hysteresis_loop_of_its_width():
    """Between -A and A the loop is a parallelogram: the joint rests until the target has moved by the play."""
    up = np.linspace(-0.2, 0.2, 401)
    targets = np.concatenate([up[200::-1], up[1:], up[-2::-1]])
    found = followed(targets, backlash=PLAY)
    rising, falling = np.maximum(up - PLAY / 2, -0.2 + PLAY / 2), np.minimum(up[::-1] + PLAY / 2, 0.2 - PLAY / 2)
    np.testing.assert_allclose(found[200:], [*rising, *falling[1:]], atol=1e-12)
    # The loop does not depend on the rate of the control.
    np.testing.assert_allclose(followed(targets[::10], backlash=PLAY), found[::10], atol=1e-12)


def resting(env, action, steps=200):
    """Joint positions and torques (J,) after an action was held."""
    for _ in range(steps):
        *_, info = env.step(np.full(8, action, np.float32))
    return info["joint_position"], info["joint_torque"]


@pytest.mark.parametrize("offset", [0.0, 0.012])
@pytest.mark.parametrize(("step", "play", "band"), [(STEP, 0, 0), (0, PLAY, 0), (0, 0, BAND), (STEP, PLAY, BAND)])
def test_joint_without_load_stops_short_by_half_the_play_and_the_dead_band(step, play, band, offset):
    """Approached from either side; an encoder's offset shifts the servo's steps with everything else."""
    motor = JointMotor(kd=4.0, target_step=step, backlash=play, dead_band=band)
    config = {
        "motor": dataclasses.asdict(MotorConfig(motor, motor)),
        "randomization": {"encoder_offset": [offset, offset]},
        "termination": {"max_tilt": math.pi, "max_trunk_force": 1e9},
    }
    env = gymnasium.make(ENV_ID, config=config, max_episode_steps=None).unwrapped
    env.model.opt.gravity[:] = 0.0
    env.reset(seed=0)
    env.task.place(np.zeros(1, np.intp), env.data.qpos[None] + [[0, 0, 1] + [0] * 12], np.zeros((1, 14)))
    resting(env, -0.6)
    stance = MINI_QUADRUPED.stance
    for action, side in ((0.1, -1.0), (-0.2, 1.0)):
        position, _ = resting(env, action)
        target = stance + 0.6 * action
        rounded = step * np.rint(target / step) if step else target
        np.testing.assert_allclose(position + offset - rounded, side * (play / 2 + band), atol=2e-4)


def test_randomization_adds_to_the_motors_in_each_env_and_joint():
    ranges = {"target_step": [0.01, 0.02], "backlash": [0.0, 0.02], "dead_band": [0.0, 0.01]}
    config = {"motor": {"knee": {"backlash": 0.05}}, "randomization": ranges}
    env = gymnasium.make_vec(ENV_ID, num_envs=16, config=config).unwrapped
    for _ in range(2):
        env.reset(seed=0)
        found = {name: np.array([env.get_state()[i]["servos"][name] for i in range(16)]) for name in ranges}
        assert not np.ptp(found["target_step"], axis=1).any()
        for name, (low, high) in ranges.items():
            values = found[name] - ([0.0, 0.05] * 4 if name == "backlash" else 0.0)
            assert low <= values.min() < values.max() <= high + 1e-12
            assert len(np.unique(values.round(12))) == (16 if name == "target_step" else 128)


def test_servos_of_the_live_simulation_have_the_errors_of_the_robots_motors():
    motor = JointMotor(target_step=0.2)
    robot = dataclasses.replace(MINI_QUADRUPED, motors=MotorConfig(motor, motor))
    positions = []
    for target in (0.62, 0.68, 0.72):  # the first two are 0.6 for the servo, the last one is 0.8
        simulated = SimulatedRobot(robot=robot)
        for _ in range(100):
            simulated.command(np.array([target, -0.8] * 4))
            simulated.step()
        positions.append(simulated.state.joint_position[0, 0::2].copy())
    np.testing.assert_array_equal(positions[0], positions[1])
    assert (positions[2] - positions[0]).mean() == pytest.approx(0.2, abs=0.03)


def test_preset_is_the_data_sheet_and_stands_under_a_small_robot(tmp_path):
    """Stall torque 11 kgf cm, 60 degrees in 0.14 s, and a dead band of 5 us of 0.1 degrees each."""
    motors = MOTOR_PRESETS["mg996r"]
    motor = motors.hip
    assert motor.stall_torque == pytest.approx(11 * 9.81 / 100, rel=2e-3)
    assert motor.no_load_speed * 0.14 == pytest.approx(math.pi / 3)
    assert math.degrees(motor.dead_band) == pytest.approx(0.5)
    assert motors.delay == 0.02
    assert TaskConfig.from_dict({"motor": "mg996r"}).motor == motors
    changed = TaskConfig.from_dict({"motor": {"preset": "mg996r", "hip": {"kp": 9.0}}}).motor
    assert changed == dataclasses.replace(motors, hip=dataclasses.replace(motor, kp=9.0))
    file = tmp_path / "motors.json"
    file.write_text('{"motor": "mg996r"}')
    assert read_motors(file) == motors
    with pytest.raises(QuadrupedError, match=r"config\.motor\.preset must be one of mg996r; found 'sg90'"):
        TaskConfig.from_dict({"motor": "sg90"})
    env = gymnasium.make(ENV_ID, robot=HALF_WITH_SERVOS).unwrapped
    assert (env.model.actuator_delay == 0.02).all()
    env.reset(seed=0, options={"command": (0.0, 0.0)})
    position, torque = resting(env, 0.0)
    assert not env.task.finished.any()
    # A step and the gears, the dead band, and the load; dry friction holds the joint where it came to rest.
    allowed = (
        motor.target_step / 2 + motor.backlash / 2 + motor.dead_band + (abs(torque) + motor.friction_loss) / motor.kp
    )
    assert (abs(MINI_QUADRUPED.stance - position) <= allowed).all()


def test_robot_with_whole_numbers_in_its_motors_keeps_its_identity():
    """Older versions stored them as they were given, and the SHA-256 tells 7 from 7.0."""
    motors = MotorConfig(JointMotor(stall_torque=7, kd=1), delay=0)
    robot = dataclasses.replace(HALF_WITH_SERVOS, motors=motors).robot()
    stored = json.loads(json.dumps(robot.to_dict()))
    assert (
        {type(stored["motors"]["hip"][name]) for name in ("stall_torque", "kd")}
        == {int}
        == {type(stored["motors"]["delay"])}
    )
    assert Robot.from_dict(stored).sha256 == robot.sha256


def test_robot_without_servo_errors_keeps_its_identity():
    assert not {"target_step", "backlash", "dead_band"} & set(MINI_QUADRUPED.to_dict()["motors"]["hip"])
    robot = HALF_WITH_SERVOS.robot()
    assert Robot.from_dict(robot.to_dict()) == robot
    assert robot != dataclasses.replace(HALF_WITH_SERVOS, motors=MotorConfig()).robot()
    with pytest.raises(QuadrupedError, match=r"motor\.dead_band must be at least 0 \(rad\)"):
        JointMotor(dead_band=-0.1)
