"""The reward of whole motions, made by hand: doing what is commanded earns most."""

import dataclasses
import math
from dataclasses import dataclass

import numpy as np
import pytest
from tasks import Terms, random_readings

from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.robot.readings import Readings
from quadruped_env.task import TaskConfig
from quadruped_env.training.recipes import RECIPES, with_recipe

DT, SUBSTEPS, SECONDS = 0.02, 4, 5.0
LEG_PHASES = np.array([0.0, math.pi, math.pi, 0.0])
SWING, LANDING = 1.25, 0.3
"""Height of a sole in its swing over what the reward asks for, and its speed at touchdown, m/s."""
FOOT_RADIUS, FOOT_DISTANCE = 0.02, 0.18
"""Of a foot's ball, and of the feet from the centre, m."""
COMMANDS = np.array(
    [
        (v, w)
        for v in np.linspace(-0.3, 0.6, 10).round(1)
        for w in np.linspace(-0.8, 0.8, 9).round(1)
        if abs(v) >= 0.1 or abs(w) >= 0.2
    ]
)


@dataclass
class Motion:
    """A motion of the robot; its feet step with the gait clock or stay on the ground."""

    follows: bool
    """True if it moves as commanded; else it stays in its place."""
    steps: bool
    power: float
    """Electrical power, W."""
    fall_interval: float = math.inf
    """Time from one fall to the next, s."""


WALKING = Motion(follows=True, steps=True, power=20.0)
OTHERS = {
    "standing": Motion(follows=False, steps=False, power=4.0),
    "marching in place": Motion(follows=False, steps=True, power=20.0),
    "dragging": Motion(follows=True, steps=False, power=4.0),
    "falling": Motion(follows=True, steps=True, power=20.0, fall_interval=0.5),
}


def still(*shape):
    """Readings (*shape, ...) of robots that stand upright and at rest."""
    one = random_readings(np.random.default_rng(0), 1)
    fields = {field.name: getattr(one, field.name)[0].shape for field in dataclasses.fields(Readings)}
    readings = Readings(**{name: np.zeros((*shape, *width)) for name, width in fields.items()})
    readings.up_b[..., 2] = 1.0
    return readings


def set_motion(readings, motion, phase, lift):
    """Write a motion at the clock's phases (..., N) into readings (..., N, ...); the soles rise by `lift`, m."""
    velocity = COMMANDS if motion.follows else np.zeros_like(COMMANDS)
    sine = np.sin(phase[..., None] + LEG_PHASES)
    height = lift * np.maximum(sine, 0.0) if motion.steps else np.zeros_like(sine)
    on_ground = (sine <= 0.0) | (not motion.steps)
    readings.linear_velocity_b[..., 0], readings.angular_velocity_b[..., 2] = velocity.T
    # The base of a robot that steps bobs and rolls.
    readings.linear_velocity_b[..., 2], readings.angular_velocity_b[..., 0] = 0.05 * motion.steps, 0.3 * motion.steps
    readings.foot_position[..., 2] = FOOT_RADIUS + height
    readings.foot_force[:] = 10.0 * on_ground
    readings.foot_velocity[..., 2] = np.where(on_ground, -LANDING * motion.steps, 0.0)
    if motion.follows and not motion.steps:
        readings.foot_velocity[..., 0] = np.hypot(velocity[:, 0], FOOT_DISTANCE * velocity[:, 1])[:, None]
    # The heat of 1 N m is 0.5 W.
    readings.joint_torque[:] = 1.0
    readings.joint_velocity[:] = motion.power / 8.0 - 0.5


def earned(motion, config):
    """Reward per second of a motion under each of the commands (N,), and its landings per second (N,)."""
    n = len(COMMANDS)
    readings, substeps = still(n), still(SUBSTEPS, n)
    terms = Terms(readings, config)
    terms.set_command(COMMANDS)
    control, context, weights = terms.control, terms.context, np.array(list(config.reward.weights.values()))
    total, landings = np.zeros(n), np.zeros(n)
    fall_steps, lift = motion.fall_interval / DT, SWING * config.reward.foot_lift
    for step in range(1, round(SECONDS / DT) + 1):
        before = control.phase.copy()
        control.advance()
        control.action[:] = 0.05 * (-1) ** step
        part = (control.phase - before) % math.tau / SUBSTEPS
        set_motion(substeps, motion, before + part * np.arange(SUBSTEPS)[:, None], lift)
        set_motion(readings, motion, control.phase, lift)
        context.update(substeps)
        context.fallen[:] = step % fall_steps == 0
        total += DT * weights @ terms.function(context)
        landings += (context.landing_speed > 0.0).sum(axis=1)
        if context.fallen[0]:
            context.memory.clear(np.arange(n))
    return total / SECONDS, landings / SECONDS


@pytest.fixture(scope="module", params=RECIPES)
def config(request):
    return TaskConfig.from_dict(with_recipe({"recipe": request.param}, MINI_QUADRUPED).task)


@pytest.fixture(scope="module")
def walking(config):
    return earned(WALKING, config)


def test_walking_as_commanded_earns_at_every_command(walking, config):
    reward, landings = walking
    assert reward.min() > 5.0
    np.testing.assert_allclose(landings, 4 * config.clock_frequency, atol=1.0)


@pytest.mark.parametrize("name", OTHERS)
def test_walking_as_commanded_earns_more_than_other_motions(walking, config, name):
    difference = walking[0] - earned(OTHERS[name], config)[0]
    worst = np.argmin(difference)
    assert difference[worst] > 1.0, f"{name} at {COMMANDS[worst]}"
