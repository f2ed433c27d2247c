"""Both simulation drivers behind one interface, with random starts and joint targets."""

import copy
from dataclasses import fields

import numpy as np
from built_in import JOINT_POSITION_HIGH, JOINT_POSITION_LOW, STANCE, STANCE_HEIGHT

from quadruped_env.robot.readings import Readings
from quadruped_env.simulation import BatchSimulation, SingleSimulation, build_model

ROWS = 5
ALL = np.arange(ROWS)
SUBSTEPS = 4


class Singles:
    """Several `SingleSimulation`s behind the interface of one simulation with as many envs."""

    def __init__(self, model, num_envs):
        # One model each: a single simulation writes the model fields of its env into its own.
        self.singles = [SingleSimulation(copy.copy(model)) for _ in range(num_envs)]

    def step(self, joint_target, substeps):
        for single, target in zip(self.singles, joint_target, strict=True):
            single.step(target[None], substeps)

    def reset(self, rows, qpos, qvel):
        for i, row in enumerate(rows):
            self.singles[row].reset(np.array([0]), qpos[i : i + 1], qvel[i : i + 1])

    def push(self, rows, velocity):
        for i, row in enumerate(rows):
            self.singles[row].push(np.array([0]), velocity[i : i + 1])

    def write_model_field(self, name, values):
        for single, value in zip(self.singles, values, strict=True):
            single.model_field(name)[0] = value

    def diverged(self):
        return np.concatenate([single.diverged() for single in self.singles])

    def get_state(self, row):
        return self.singles[row].get_state(0)

    def set_state(self, row, state):
        self.singles[row].set_state(0, state)

    def reading(self, name):
        return np.concatenate([getattr(single.readings, name) for single in self.singles])


class Batched(BatchSimulation):
    """`BatchSimulation` with the two helpers that `Singles` has."""

    def write_model_field(self, name, values):
        self.model_field(name)[:] = values

    def reading(self, name):
        return getattr(self.readings, name).copy()


DRIVERS = {
    "singles": Singles,
    "1 thread": lambda model, rows: Batched(model, rows, 1),
    "2 threads": lambda model, rows: Batched(model, rows, 2),
    "3 threads": lambda model, rows: Batched(model, rows, 3),
}
READINGS = tuple(field.name for field in fields(Readings))


def side_by_side(columns):
    return np.concatenate([np.reshape(column, (len(column), -1)) for column in columns], axis=1)


def readings_of(state):
    """Every reading of a `Readings` side by side (N, ...), a copy."""
    return side_by_side([getattr(state, name) for name in READINGS])


def snapshot(simulation):
    """Readings and full state of every env, side by side."""
    states = np.array([simulation.get_state(row).integration for row in ALL])
    return side_by_side([*(simulation.reading(name) for name in READINGS), states])


def physics_of(simulation, row):
    """qpos (15,) and qvel (14,) of an env, from its state, in which time comes first."""
    state = simulation.get_state(row).integration
    return state[1:16], state[16:30]


def draw_starts(rng, rows):
    """Random starts (R, 15), (R, 14) a little over the ground."""
    qpos = np.zeros((rows, 15))
    qpos[:, 2] = STANCE_HEIGHT + rng.uniform(0.0, 0.1, rows)
    qpos[:, 3] = 1.0
    qpos[:, 4:7] = 0.1 * rng.standard_normal((rows, 3))
    qpos[:, 3:7] /= np.linalg.norm(qpos[:, 3:7], axis=1, keepdims=True)
    qpos[:, 7:] = STANCE + 0.1 * rng.standard_normal((rows, 8))
    return qpos, 0.3 * rng.standard_normal((rows, 14))


def draw_targets(rng):
    return rng.uniform(JOINT_POSITION_LOW, JOINT_POSITION_HIGH, (ROWS, 8))


def start(driver, seed=0, model=None):
    simulation = DRIVERS[driver](model or build_model(), ROWS)
    simulation.reset(ALL, *draw_starts(np.random.default_rng(seed), ROWS))
    return simulation


def run(simulation, steps, seed):
    """Random controls for some steps; the snapshots after each, (steps, N, ...)."""
    rng = np.random.default_rng(seed)
    snapshots = []
    for _ in range(steps):
        simulation.step(draw_targets(rng), SUBSTEPS)
        snapshots.append(snapshot(simulation))
    return np.array(snapshots)


def diverge_by_velocity(simulation, row):
    simulation.push(np.array([row]), np.full((1, 3), 1e12))
