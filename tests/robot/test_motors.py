"""Motors with other parameters than the model file's, as identified on a robot."""

import copy
import dataclasses

import gymnasium
import mujoco
import numpy as np
import pytest
from built_in import STANCE, STANCE_HEIGHT
from test_joint_structure import three_joints

from quadruped_env import QuadrupedError
from quadruped_env.robot import (
    JOINT_KINDS,
    JOINT_NAMES,
    MINI_QUADRUPED,
    MOTOR_PRESETS,
    JointMotor,
    MotorConfig,
    asset_path,
)
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model
from quadruped_env.task import BUILT_IN, TaskConfig

OTHER = MotorConfig(
    hip=JointMotor(stall_torque=7.0, kp=30.0, kd=0.6, damping=0.2, friction_loss=0.15, armature=0.02),
    knee=JointMotor(stall_torque=12.0, no_load_speed=8.0, kp=55.0),
    delay=0.01,
)
KINDS = JOINT_KINDS * 4
ROW = np.zeros(1, dtype=np.intp)
START = np.array([[0.0, 0.0, STANCE_HEIGHT, 1.0, 0.0, 0.0, 0.0, *STANCE]])


def hung_up(motors):
    """The robot without its floating base and its ground."""
    spec = mujoco.MjSpec.from_file(str(asset_path("mini_quadruped.xml")))
    spec.delete(spec.joint("floating_base"))
    for key in list(spec.keys):
        spec.delete(key)
    motors.write(spec, KINDS)
    motors.write_delay(spec, motors.delay)
    return spec.compile()


def swing(model, steps):
    """Joint positions and torques (T, 8) after a jump of all targets from zero at t = 0."""
    data = mujoco.MjData(model)
    position, torque = np.empty((2, steps, 8))
    for step in range(steps):
        data.ctrl[:] = [0.1, -0.1] * 4
        mujoco.mj_step(model, data)
        position[step], torque[step] = data.qpos, data.actuator_force
    return position, torque


def test_the_defaults_are_the_model_files(model):
    spec = mujoco.MjSpec.from_file(str(asset_path("scene.xml")))
    MotorConfig().write(spec, KINDS)
    written = spec.compile()
    for name in dir(model):
        value = getattr(model, name)
        if isinstance(value, np.ndarray):
            np.testing.assert_array_equal(getattr(written, name), value, err_msg=name)


def test_each_number_reaches_its_joint():
    model = build_model(motors=OTHER)
    for name, motor in zip(JOINT_NAMES, [OTHER.hip, OTHER.knee] * 4, strict=True):
        dof, actuator = model.joint(name).dofadr[0], model.actuator(name).id
        assert model.dof_damping[dof] == motor.damping
        assert model.dof_frictionloss[dof] == motor.friction_loss
        assert model.dof_armature[dof] == motor.armature
        resistance, constant = model.actuator_gainprm[actuator, :2]
        assert constant * 24.0 / resistance == pytest.approx(motor.stall_torque)
        assert 24.0 / constant == pytest.approx(motor.no_load_speed)
        assert (motor.torque_constant, motor.resistance) == pytest.approx((constant, resistance), rel=1e-12)
        assert tuple(model.actuator_gainprm[actuator, [4, 6]]) == (motor.kp, motor.kd)
        assert model.actuator_delay[actuator] == OTHER.delay


def test_heat_is_that_of_the_current_in_the_winding():
    # 24 V / 5 rad/s = 4.8 V s/rad; 4.8 * 24 / 10 = 11.52 Ohm; a torque of 6 N m takes 1.25 A, and 18 W of heat.
    motor = JointMotor()
    assert (motor.torque_constant, motor.resistance) == pytest.approx((4.8, 11.52))
    assert motor.joule_coefficient * 6.0**2 == pytest.approx(1.25**2 * 11.52) == pytest.approx(18.0)
    # At rest and full voltage all of the power becomes heat: voltage^2 / R.
    for other in (OTHER.hip, OTHER.knee):
        assert other.joule_coefficient * other.stall_torque**2 == pytest.approx(24.0**2 / other.resistance)
    expected = [OTHER.hip.joule_coefficient, OTHER.knee.joule_coefficient] * 4
    np.testing.assert_array_equal(OTHER.joule_coefficients(KINDS), expected)


def test_a_stronger_motor_gives_its_torque_and_no_more():
    for strength in (4.0, 16.0):
        motor = JointMotor(stall_torque=strength, kp=500.0)
        _, torque = swing(hung_up(MotorConfig(hip=motor, knee=motor)), 40)
        assert np.abs(torque).max() == pytest.approx(strength, rel=1e-6)


def test_a_delay_of_whole_steps_is_the_undelayed_motion_later():
    prompt, _ = swing(hung_up(MotorConfig()), 60)
    late, _ = swing(hung_up(MotorConfig(delay=0.015)), 63)
    np.testing.assert_allclose(late[3:], prompt, rtol=0, atol=1e-12)
    np.testing.assert_allclose(late[:3], 0.0, atol=1e-12)


@pytest.mark.parametrize("make", [SingleSimulation, lambda model: BatchSimulation(model, 1, 1)])
def test_delayed_motors_start_as_if_they_had_held_the_start(make):
    """Without the history the legs would jerk towards zero at every reset."""
    simulations = [make(build_model(motors=MotorConfig(delay=delay))) for delay in (0.0, 0.02)]
    for simulation in simulations:
        for _ in range(2):
            simulation.reset(ROW, START, np.zeros((1, 14)))
            simulation.step(STANCE[None] + 0.3, 3)
        simulation.reset(ROW, START, np.zeros((1, 14)))
        simulation.step(STANCE[None], 4)
    prompt, late = (simulation.readings.joint_position.copy() for simulation in simulations)
    np.testing.assert_array_equal(late, prompt)


CONFIG = {"motor": {"delay": 0.012, "hip": {"kp": 35.0, "friction_loss": 0.2}}}


def test_targets_that_are_still_delayed_belong_to_the_state():
    env = gymnasium.make("MiniQuadruped-v0", config=CONFIG).unwrapped
    env.reset(seed=0)
    rng = np.random.default_rng(0)
    actions = rng.uniform(-1, 1, (20, 8)).astype(np.float32)
    for action in actions[:10]:
        env.step(action)
    state, twin = env.get_state(), copy.deepcopy(env)
    ahead = [env.step(action)[0] for action in actions[10:]]
    env.set_state(state)
    for action, expected in zip(actions[10:], ahead, strict=True):
        np.testing.assert_array_equal(env.step(action)[0], expected)
        np.testing.assert_array_equal(twin.step(action)[0], expected)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"hip": {"kp": -1.0}}, r"config\.motor\.hip\.kp must be at least 0 \(N m/rad\); found -1\.0"),
        ({"knee": {"armature": 0.0}}, r"armature must be positive \(kg m\^2\), 1e-09 or more; found 0\.0"),
        ({"hip": {"stall_torque": "strong"}}, r"config\.motor\.hip\.stall_torque: expected a number; found 'strong'"),
        ({"ankle": {}}, "unknown field 'ankle'; valid fields are hip, knee, delay, abduction"),
        ({"delay": 12.0}, r"delay must be in \[0, 0\.5\] \(s\); found 12\.0"),
    ],
)
def test_invalid_motors_are_refused(values, message):
    with pytest.raises(QuadrupedError, match=message):
        TaskConfig.from_dict({"motor": values})


class TestAbduction:
    KINDS = ("abduction", "hip", "knee")

    def test_has_the_hips_motor_unless_it_is_given(self):
        weak = JointMotor(stall_torque=3.0)
        assert OTHER.of_joints(self.KINDS) == [OTHER.hip, OTHER.hip, OTHER.knee]
        assert dataclasses.replace(OTHER, abduction=weak).of_joints(self.KINDS) == [weak, OTHER.hip, OTHER.knee]
        changed = dataclasses.replace(OTHER, abduction={"kp": 9})
        assert changed.abduction == dataclasses.replace(OTHER.hip, kp=9.0)
        assert "abduction" not in OTHER.to_dict()
        assert changed.to_dict()["abduction"]["kp"] == 9.0
        assert "backlash" not in changed.content()["abduction"]

    def test_is_set_by_a_config_in_part(self):
        definition = BUILT_IN.with_robot(three_joints())
        motor = TaskConfig.from_dict({"motor": {"abduction": {"kp": 9.0}}}, definition).motor
        assert motor.abduction == dataclasses.replace(three_joints().motors.hip, kp=9.0)
        assert TaskConfig.from_dict(TaskConfig(motor=motor, definition=definition).to_dict(), definition).motor == motor
        preset = TaskConfig.from_dict({"motor": {"preset": "mg996r", "abduction": {"kd": 1.0}}}, definition).motor
        assert preset.abduction == dataclasses.replace(MOTOR_PRESETS["mg996r"].hip, kd=1.0)

    @pytest.mark.parametrize(
        ("robot", "value", "message"),
        [
            (three_joints, {"kp": -1.0}, r"config\.motor\.abduction\.kp must be at least 0 \(N m/rad\); found -1"),
            (three_joints, {"strength": 1.0}, r"config\.motor\.abduction: unknown field 'strength'"),
            (three_joints, 3, r"config\.motor\.abduction must be fields of a motor, or None; found 3"),
            (lambda: MINI_QUADRUPED, {"kp": 1.0}, r"abduction: 'mini_quadruped' has joints of the kinds hip, knee"),
        ],
    )
    def test_invalid_one_is_refused(self, robot, value, message):
        with pytest.raises(QuadrupedError, match=message):
            TaskConfig.from_dict({"motor": {"abduction": value}}, BUILT_IN.with_robot(robot()))
