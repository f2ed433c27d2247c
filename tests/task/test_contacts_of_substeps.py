"""Landings and slip at the physics' rate: by closed forms of falls, and of readings made by hand."""

import math

import numpy as np
import pytest
from built_in import STANCE, STANCE_HEIGHT
from tasks import NEVER_FALLS, STILL_START, Terms, make_env, make_task, random_readings

from quadruped_env.robot.readings import Readings

HEIGHTS = np.array([0.05, 0.1, 0.2, 0.3])
SPEEDS = np.sqrt(2.0 * 9.81 * HEIGHTS)
GRAVITY_STEP = 9.81 * 0.005
"""Change of the speed within a physics step, which is not resolved, m/s."""


@pytest.mark.parametrize("driver", ["single", "batch"])
def test_feet_of_a_robot_that_falls_land_once_at_the_speed_of_the_fall(driver):
    config = {"randomization": STILL_START, "termination": NEVER_FALLS}
    if driver == "batch":
        tasks = [make_task(len(HEIGHTS), fixed_command=(0.0, 0.0), **config)]
    else:
        tasks = [make_env((0.0, 0.0), **config).task for _ in HEIGHTS]
    qpos = np.zeros((len(HEIGHTS), 15))
    qpos[:, 2], qpos[:, 3], qpos[:, 7:] = STANCE_HEIGHT + HEIGHTS, 1.0, STANCE
    starts = np.split(qpos, len(tasks))
    for task, start in zip(tasks, starts, strict=True):
        task.place(np.arange(len(start)), start, np.zeros((len(start), 14)))
    landings = []
    for _ in range(20):
        for task in tasks:
            task.step(np.zeros((task.num_envs, 8)))
        landings.append(np.concatenate([task.context.landing_speed for task in tasks]))
    landings = np.array(landings)
    first = np.argmax(landings > 0.0, axis=0)
    # All feet, in the control step in which the fall ends.
    ends = np.sqrt(2.0 * HEIGHTS / 9.81) / 0.02
    assert (abs(first - ends[:, None]) <= 1.0).all()
    speeds = np.take_along_axis(landings, first[None], axis=0)[0]
    np.testing.assert_allclose(speeds, np.tile(SPEEDS[:, None], 4), atol=1.5 * GRAVITY_STEP)
    np.testing.assert_array_equal((landings > 0.5 * SPEEDS[:, None]).sum(axis=0), 1)


def substeps_of(force, down, along=0.0, spin=0.0):
    """Readings of the physics steps of one robot: forces (S, 4) and velocities of its feet (S, 4)."""
    count = len(force)
    one = random_readings(np.random.default_rng(0), count)
    values = {name: getattr(one, name)[:, None].copy() for name in Readings.__slots__}
    values["foot_force"][:, 0] = force
    values["foot_velocity"][:] = 0.0
    values["foot_velocity"][:, 0, :, 2] = -np.asarray(down)
    values["foot_velocity"][:, 0, :, 0] = along
    values["foot_angular_velocity"][:] = 0.0
    values["foot_angular_velocity"][:, 0, :, 1] = spin
    return Readings(**values)


def test_landing_is_the_first_contact_after_a_physics_step_in_the_air():
    context = Terms(random_readings(np.random.default_rng(0), 1)).context
    down = np.array([[0.1], [0.2], [0.3], [0.4]]) * np.array([1.0, 2.0, 3.0, 4.0])

    def landed(*force):
        context.update(substeps_of(np.array(force), down))
        return context.landing_speed[0].tolist()

    # On the ground at the start; 1 N, the threshold, is no contact.
    assert landed([9, 9, 9, 9], [9, 1, 9, 0], [9, 9, 9, 0], [9, 9, 0, 0]) == [0.0, pytest.approx(0.6), 0.0, 0.0]
    # The third and the fourth foot were in the air at the end of the step before.
    assert landed([9, 9, 9, 0], [9, 9, 9, 0], [9, 9, 9, 9], [9, 9, 9, 9]) == [
        0.0, 0.0, pytest.approx(0.3), pytest.approx(1.2)
    ]  # fmt: skip
    # Nothing lands twice; of two landings in one step the faster one counts.
    assert landed([9, 9, 9, 9], [9, 9, 9, 9], [9, 9, 9, 9], [9, 9, 9, 9]) == [0.0] * 4
    assert landed([0, 9, 9, 9], [9, 9, 9, 9], [0, 9, 9, 9], [9, 9, 9, 0]) == [pytest.approx(0.4), 0.0, 0.0, 0.0]
    # After a reset no foot was in the air, and a foot that rises at its contact does not land.
    context.memory.clear(np.array([0]))
    assert landed([9, 9, 9, 9], [9, 9, 9, 9], [9, 9, 9, 9], [9, 9, 9, 9]) == [0.0] * 4
    down *= -1.0
    assert landed([0, 9, 9, 9], [9, 9, 9, 9], [9, 9, 9, 9], [9, 9, 9, 9]) == [0.0] * 4


def test_copy_steps_when_no_env_does():
    """All envs begin an episode instead of the first step after the task was pickled."""
    import pickle

    task = make_task(2, termination=NEVER_FALLS)
    task.step(np.full((2, 8), 0.3))
    copied = pickle.loads(pickle.dumps(task))  # noqa: S301
    one, other = (each.step(np.zeros((2, 8)), np.array([True, True])) for each in (task, copied))
    np.testing.assert_array_equal(one.observation, other.observation)
    assert math.isfinite(copied.step(np.zeros((2, 8))).reward.sum())
