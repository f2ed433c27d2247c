"""Effect of each randomization of the model, against models that MuJoCo compiled with these values."""

import gymnasium
import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from settings import settings

from quadruped_env.envs import ENV_ID
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation.model import scene

BASE = 1
LINKS = slice(1, 10)
JOINTS = slice(6, 14)
KP, KD, STALL, NO_LOAD, VOLTAGE = 40.0, 1.0, 10.0, 5.0, 24.0
"""Motors of the built-in robot (assets/mini_quadruped/README.md)."""


def fixed(**values):
    """Ranges of one value each."""
    return {name: [value, value] if isinstance(value, float) else value for name, value in values.items()}


def randomized(driver, **ranges):
    """Model of an env after its second reset: nothing may add up over the episodes."""
    config = settings(randomization=ranges)
    if driver == "single":
        env = gymnasium.make(ENV_ID, config=config).unwrapped
        for seed in (3, 4):
            env.reset(seed=seed)
        return env.model
    env = gymnasium.make_vec(ENV_ID, num_envs=2, config=config)
    for seed in (2, 3):
        env.reset(seed=seed)
    return env.task.simulation.batch.get_model(1)


@pytest.fixture(params=["single", "vector"])
def driver(request):
    return request.param


def compiled(change):
    """The built-in robot's model with a changed specification."""
    spec = scene(MINI_QUADRUPED)
    change(spec)
    return spec.compile()


def states(model, count=12):
    """Random states on and above the ground, with joint targets: qpos (15,), qvel (14,), ctrl (8,)."""
    rng = np.random.default_rng(0)
    home = model.key("home").qpos
    for i in range(count):
        qpos = home.copy()
        qpos[2] += 0.3 if i % 3 == 0 else rng.uniform(-0.006, 0.0)
        qpos[3:7] = Rotation.from_rotvec(rng.normal(0.0, 0.05, 3)).as_quat(scalar_first=True)
        qpos[7:] += rng.uniform(-0.1, 0.1, 8)
        yield qpos, rng.uniform(-1.0, 1.0, 14), qpos[7:] + rng.uniform(-0.4, 0.4, 8)


def acceleration(model, qpos, qvel, ctrl):
    data = mujoco.MjData(model)
    data.qpos, data.qvel, data.ctrl = qpos, qvel, ctrl
    mujoco.mj_forward(model, data)
    return data.qacc.copy()


def assert_same_physics(model, expected):
    """Equal accelerations in every state, and equal constants that MuJoCo derives."""
    contacts = 0
    for qpos, qvel, ctrl in states(expected):
        wanted = acceleration(expected, qpos, qvel, ctrl)
        # Rounding errors of 1e-16, times the condition number of mass matrix and contacts: 1.6e-12 with MuJoCo 3.17.
        tolerance = 1e-11 * abs(wanted).max()
        np.testing.assert_allclose(acceleration(model, qpos, qvel, ctrl), wanted, rtol=0.0, atol=tolerance)
        contacts += qpos[2] < 0.19
    assert contacts > 3
    np.testing.assert_allclose(model.dof_invweight0, expected.dof_invweight0, rtol=1e-12)
    np.testing.assert_allclose(model.body_subtreemass[BASE], expected.body_subtreemass[BASE], rtol=1e-12)
    np.testing.assert_allclose(model.body_invweight0[LINKS], expected.body_invweight0[LINKS], rtol=1e-12)
    different = compiled(lambda spec: None)
    assert any(
        abs(acceleration(model, *state) - acceleration(different, *state)).max() > 1e-3 for state in states(expected)
    ), "the change must matter"


# --- masses ---


def payload_of(mass, offset):
    """A body of the base's shape, fixed to the base."""

    def change(spec):
        base = spec.body("base_link")
        body = base.add_body(name="payload", pos=offset)
        body.mass, body.inertia = mass, np.asarray(base.inertia) * mass / base.mass
        body.ipos, body.explicitinertial = [0.0, 0.0, 0.0], True

    return change


def assert_carries(model, mass, offset):
    expected = compiled(payload_of(mass, offset))
    for qpos, qvel, ctrl in states(expected):
        wanted = acceleration(expected, qpos, qvel, ctrl)
        found = acceleration(model, qpos, qvel, ctrl)
        np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-12 * abs(wanted).max())
    np.testing.assert_allclose(model.dof_invweight0, expected.dof_invweight0, rtol=1e-12)
    assert model.body_subtreemass[BASE] == pytest.approx(4.0 + mass)


@pytest.mark.parametrize("mass", [1.0, 0.3])
def test_payload_at_the_centre_equals_a_body_compiled_there(driver, mass):
    assert_carries(randomized(driver, payload=[mass, mass]), mass, [0.0, 0.0, 0.0])


def test_payload_away_from_the_centre_equals_a_body_compiled_there(driver):
    model = randomized(driver, payload=[1.0, 1.0], payload_position=0.08)
    # The common centre of mass lies on the line to the payload.
    offset = model.body_ipos[BASE] * (2.2 + 1.0) / 1.0
    assert (abs(offset) <= 0.08).all()
    assert abs(offset).max() > 0.02
    assert_carries(model, 1.0, offset)


def test_payload_on_a_base_with_a_shifted_centre_lies_relative_to_it(driver):
    model = randomized(
        driver, payload=[0.8, 0.8], payload_position=[0.04, 0.04], base_com=[-0.02, -0.02], link_mass=[1.1, 1.1]
    )

    def change(spec):
        for body in spec.bodies[1:]:
            body.mass, body.inertia = 1.1 * body.mass, 1.1 * np.asarray(body.inertia)
        spec.body("base_link").ipos = [-0.02] * 3
        payload_of(0.8, [0.02] * 3)(spec)

    expected = compiled(change)
    for state in states(expected):
        wanted = acceleration(expected, *state)
        np.testing.assert_allclose(acceleration(model, *state), wanted, rtol=0.0, atol=1e-12 * abs(wanted).max())


def test_missing_mass_is_missing_everywhere_in_the_base(driver):
    model = randomized(driver, payload=[-0.5, -0.5], payload_position=0.08)
    share = 1.7 / 2.2

    def change(spec):
        base = spec.body("base_link")
        base.mass, base.inertia = 1.7, share * np.asarray(base.inertia)

    assert_same_physics(model, compiled(change))


def test_masses_and_inertia_of_links_equal_a_compiled_model(driver):
    model = randomized(driver, link_mass=[0.8, 1.2], link_inertia=[0.8, 1.2])
    plain = compiled(lambda spec: None)
    masses = model.body_mass[LINKS] / plain.body_mass[LINKS]
    inertias = model.body_inertia[LINKS] / plain.body_inertia[LINKS] / masses[:, None]
    for factors in (masses, inertias[:, 0]):
        assert len(set(factors)) == 9, "each link on its own"
        assert factors.min() >= 0.8
        assert factors.max() <= 1.2
    np.testing.assert_allclose(inertias, inertias[:, :1].repeat(3, axis=1), rtol=1e-12)

    def change(spec):
        for body, mass, inertia in zip(spec.bodies[1:], masses, inertias, strict=True):
            body.mass, body.inertia = body.mass * mass, np.asarray(body.inertia) * mass * inertia

    assert_same_physics(model, compiled(change))


def test_shifted_centre_of_the_base_equals_a_compiled_model(driver):
    model = randomized(driver, base_com=0.03)
    offset = model.body_ipos[BASE].copy()
    assert len(set(offset)) == 3
    assert (abs(offset) <= 0.03).all()

    def change(spec):
        spec.body("base_link").ipos = offset

    assert_same_physics(model, compiled(change))


# --- joints and motors ---


def joints_of(change):
    def change_all(spec):
        for index, actuator in enumerate(spec.actuators):
            change(index, spec.joint(actuator.target))

    return change_all


@pytest.mark.parametrize(
    ("name", "setting", "field", "attribute"),
    [
        ("joint_damping", [0.5, 3.0], "dof_damping", "damping"),
        ("joint_friction", [0.05, 0.3], "dof_frictionloss", "frictionloss"),
        ("rotor_inertia", [0.5, 2.0], "dof_armature", "armature"),
    ],
)
def test_damping_friction_and_rotor_inertia_equal_a_compiled_model(driver, name, setting, field, attribute):
    model = randomized(driver, **{name: setting})
    values = getattr(model, field)
    np.testing.assert_array_equal(values[:6], 0.0)
    assert len(set(values[JOINTS])) == 8, "each joint on its own"

    def change(index, joint):
        if attribute == "damping":
            joint.damping[0] = values[6 + index]
        else:
            setattr(joint, attribute, values[6 + index])

    assert_same_physics(model, compiled(joints_of(change)))


def motors_of(kp=1.0, kd=1.0, strength=1.0, voltage=1.0):
    """Motors compiled with factors (8,) or one for all."""
    factors = np.broadcast_arrays(kp, kd, strength, voltage, np.zeros(8))[:4]

    def change(spec):
        for actuator, p, d, s, v in zip(spec.actuators, *factors, strict=True):
            actuator.set_to_dcmotor(
                motorconst=[0.0, 0.0],
                resistance=0.0,
                nominal=[VOLTAGE, s * STALL, NO_LOAD],
                saturation=[s * v * STALL, 0.0, 0.0],
                controller=[p * KP, 0.0, d * KD, 0.0, 0.0, v * VOLTAGE],
                ctrlspec=actuator.ctrlspec,
            )

    return change


@pytest.mark.parametrize(
    ("name", "factor"), [("position_gain", "kp"), ("velocity_gain", "kd"), ("motor_strength", "strength")]
)
def test_gains_and_strengths_equal_a_compiled_model(driver, name, factor):
    model = randomized(driver, **{name: [0.7, 1.4]})
    values = {
        "kp": model.actuator_gainprm[:, 4] / KP,
        "kd": model.actuator_gainprm[:, 6] / KD,
        "strength": model.actuator_forcerange[:, 1] / STALL,
    }
    assert len(set(values[factor])) == 8, "each motor on its own"
    assert 0.7 <= values[factor].min() < values[factor].max() <= 1.4
    assert_same_physics(model, compiled(motors_of(**{factor: values[factor]})))
    for other in {"kp", "kd", "strength"} - {factor}:
        np.testing.assert_allclose(values[other], 1.0)


def test_supply_voltage_equals_a_compiled_model_with_the_same_voltage_for_all_motors(driver):
    model = randomized(driver, supply_voltage=[0.8, 0.8])
    assert_same_physics(model, compiled(motors_of(voltage=0.8)))


@pytest.mark.parametrize(("strength", "voltage"), [(1.2, 1.0), (0.8, 1.0), (1.0, 0.85), (0.8, 0.85)])
def test_torque_speed_line_has_the_scaled_stall_torque_and_no_load_speed(driver, strength, voltage):
    model = randomized(driver, motor_strength=[strength] * 2, supply_voltage=[voltage] * 2)
    stall, no_load = strength * voltage * STALL, voltage * NO_LOAD
    data = mujoco.MjData(model)
    for speed in (0.0, 1.0, 2.5, 4.0, no_load):
        data.qpos[7:] = [-1.0, -1.9] * 4
        data.qvel[JOINTS] = speed
        data.ctrl = [1.5, 0.0] * 4  # far enough that the motor does what it can
        mujoco.mj_forward(model, data)
        np.testing.assert_allclose(data.actuator_force, stall * (1.0 - speed / no_load), rtol=1e-12, atol=1e-12)


def test_everything_of_the_model_together_equals_one_compiled_model(driver):
    ranges = fixed(
        friction=0.5,
        link_mass=0.9,
        link_inertia=1.1,
        motor_strength=0.9,
        supply_voltage=0.95,
        position_gain=1.1,
        velocity_gain=0.8,
        joint_friction=0.05,
        joint_damping=1.5,
        rotor_inertia=1.3,
    )
    model = randomized(driver, **ranges)

    def change(spec):
        for body in spec.bodies[1:]:
            body.mass, body.inertia = 0.9 * body.mass, 0.9 * 1.1 * np.asarray(body.inertia)
        for geom in spec.geoms:
            geom.friction[0] = 0.5
        motors_of(1.1, 0.8, 0.9, 0.95)(spec)
        for actuator in spec.actuators:
            joint = spec.joint(actuator.target)
            joint.damping[0], joint.frictionloss, joint.armature = 0.075, 0.05, 0.013

    assert_same_physics(model, compiled(change))
