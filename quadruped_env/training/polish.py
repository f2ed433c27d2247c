"""The polish of a gait: a direct search of the last layer of a policy's network.

PPO earns a little by each step in time and on command. A foot that touches down twice in one stride of ten, or a robot
that is 2 % too slow, costs it next to nothing, so how much of this remains differs from seed to seed. Here a search by
CMA-ES (Hansen 2016, https://arxiv.org/abs/1604.00772) charges them at once: each candidate changes the last layer along
the principal directions of its inputs, walks on a few commands, and is measured as a gait is: touchdowns and clearance
of the worst foot, mean velocities, power.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np
import torch
from numpy.typing import NDArray

from quadruped_env.errors import MissingExtraError
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import BatchSimulation, flat
from quadruped_env.task import Task, TaskConfig
from quadruped_env.task.quantities import electrical_power
from quadruped_env.training.reflex import StoppedError
from quadruped_env.training.strides import Strides

Floats = NDArray[np.float64]

_COMMANDS: Final = np.array(
    [[1 / 3, 0.0], [1 / 2, 0.0], [2 / 3, 0.0], [5 / 6, 0.0], [-2 / 3, 0.0], [0.0, 5 / 8], [1 / 2, 5 / 8]]
)
"""Shares of the largest forward velocity (of the largest backwards where negative) and of the largest yaw rate."""
_IMPORTANCE: Final = np.array([0.5, 1.0, 1.0, 1.5, 0.7, 0.5, 0.3])
"""Weight of each command in a candidate's cost."""
_TOUCHDOWNS: Final = np.array([1.02, 1.02, 1.02, 1.02, 1.02, 1.2, 1.2])
"""Touchdowns of the worst foot in a stride, on each command, that cost nothing."""
_CLEARANCE: Final = 0.011
"""Clearance of the worst foot of the built-in robot from which on more is worth nothing, m."""
_EACH_TOUCHDOWN, _EACH_METRE = 80.0, 3000.0
"""Cost of another touchdown in every stride, and of a metre of clearance that is missing."""
_VELOCITY_ERROR, _YAW_ERROR = 0.009, 0.02
"""Errors of the mean forward velocity (m/s, of the built-in robot) and yaw rate (rad/s) that cost 1; the cost is
quadratic."""
_STIFF_FREE, _STIFF_VELOCITY = 0.025, 0.003
"""Share of the commanded forward velocity by which stiff contacts may change it at no cost, and the share beyond that
which costs 1; the cost is quadratic. Straight ahead and backwards only: on a curve it differs by as much from start to
start."""
_TRANSPORT: Final = 3.0
"""Cost of an electrical cost of transport of 1."""
_FALL: Final = 50.0
"""Cost of a fall."""

_DIRECTIONS: Final = 12
"""Number of principal directions of the last layer's inputs; the bias is one more."""
_CANDIDATES, _STARTS = 40, 3
"""Candidates of a generation, and starts of each on every command. From the first one each walks with stiff contacts,
too, straight ahead and backwards."""
_STIFFNESS: Final = 2
"""Physics steps in one of the task's, and the time constant of its contacts over that of stiff ones. What these change
is about half of what the stiff contacts of another engine do."""
_SIGMA: Final = 0.004
"""First standard deviation of the change of an action, in shares of its range, along each direction."""
_DIRECTION_STEPS, _DIRECTION_INTERVAL = 150, 10
"""Control steps of the walk from which the directions come, and between its samples."""
_WARM_UP_STEPS, _STEPS = 100, 350
"""Control steps before the measurement, and in all."""
_LAST_SEED: Final = 900_000
"""Bound of the starts' seeds, which are below those of evaluations."""
_GRAVITY: Final = 9.81


@dataclass(frozen=True)
class Polished:
    """Costs of the gait before and after the search, on the same starts, which the search has not seen."""

    before: float
    after: float


Report = Callable[[float, Polished | None], None]
"""Called with the fraction done, and in the end with what the search is worth."""


def polish_steps(generations: int) -> int:
    """Environment steps that the search takes, with the measurement before and after it."""
    walks, stiff_walks = len(_COMMANDS) * _STARTS, int(_straight(_COMMANDS).sum())
    return ((generations + 1) * _STEPS * (walks + stiff_walks) + _DIRECTION_STEPS * walks) * _CANDIDATES


def _straight(commands: Floats) -> NDArray[np.bool_]:
    """Mask (K,) of the commands (K, 2) without a turn."""
    return commands[:, 1] == 0.0


def polish(
    model: Any, generations: int, report: Report | None = None, stopped: Callable[[], bool] = lambda: False
) -> Polished | None:
    """Search for a better last layer of a PPO's policy.

    The policy changes only if the layer that was found costs less on starts that the search has not seen. The model's
    envs, critic and exploration stay as they are.

    Args:
        model: a PPO of `make_model`; its `num_timesteps` grows.
        generations: of the search.
        report: called after every step, and in the end with the result.
        stopped: true if the training is to end; then the policy stays as it is.

    Returns:
        Costs before and after; None if the training ended before.

    Raises:
        MissingExtraError: if cmaes is not installed.
    """
    try:
        from cmaes import CMA
    except ImportError as error:  # pragma: no cover
        raise MissingExtraError("polishing a gait", "train") from error
    search = _Search(model, generations, report, stopped)
    try:
        search.learn_directions()
        optimizer = CMA(mean=np.zeros(search.size), sigma=_SIGMA, population_size=_CANDIDATES, seed=model.seed)
        for _ in range(generations):
            candidates = np.array([optimizer.ask() for _ in range(_CANDIDATES)])
            costs = search.costs(candidates)
            optimizer.tell([(candidate, float(cost)) for candidate, cost in zip(candidates, costs, strict=True)])
        half = _CANDIDATES // 2
        both = search.costs(np.repeat([np.zeros(search.size), optimizer.mean], half, axis=0), half)
    except StoppedError:
        return None
    before, after = float(both[:half].mean()), float(both[half:].mean())
    if after < before:
        search.take(optimizer.mean)
    polished = Polished(before, min(before, after))
    if report is not None:
        report(1.0, polished)
    return polished


class _Search:
    """Candidates for the last layer of a model's policy, and what they cost; see `polish`."""

    def __init__(self, model: Any, generations: int, report: Report | None, stopped: Callable[[], bool]) -> None:
        self._model, self._report, self._stopped = model, report, stopped
        self._steps, self._all_steps = 0, polish_steps(generations)
        self._random = np.random.default_rng(model.seed)
        # A gait's measures are those of an undisturbed robot on level ground.
        config = model.env.task.config.on_terrain(flat).randomized("none")
        self._robot = config.robot
        self._scale = scale_of("m", self._robot)
        forward, turn = config.command.forward_velocity, config.command.yaw_rate
        largest = np.where(_COMMANDS[:, 0] < 0.0, -forward[0], forward[1])
        self._commands = _COMMANDS * np.stack([largest, np.full_like(largest, turn[1])], axis=1)
        self._other_commands = [0.0] * (len(config.commands) - 2)
        self._robots = _Robots(config, self._commands, _STARTS)
        self._stiff_robots = _Robots(config, self._commands[_straight(self._commands)], 1, _STIFFNESS)
        layer = model.policy.action_net
        self._layer = np.concatenate([layer.weight.numpy(force=True).T, layer.bias.numpy(force=True)[None]])
        """Weights and biases (H + 1, J)."""
        joints = np.arange(self._robot.num_joints)
        counterpart = joints if model.policy.mirror is None else np.minimum(joints, self._robot.joint_mirror)
        self._own, self._row = np.unique(counterpart, return_inverse=True)
        self._mirrored = joints != counterpart
        self._sign = np.where(self._mirrored, self._robot.joint_signs, 1.0)
        self._directions, self._mean = np.zeros((0, 0)), np.zeros(0)
        self.size = 0
        """Number of parameters of a candidate."""

    def learn_directions(self) -> None:
        """Find the principal directions of the last layer's inputs, on the policy's own walk."""
        inputs = []
        for step, seen in enumerate(self._walk(self._robots, self._layer, _DIRECTION_STEPS, self._seed())):
            if step >= _WARM_UP_STEPS and step % _DIRECTION_INTERVAL == 0:
                inputs.append(seen)
        found = np.concatenate(inputs)
        self._mean = found.mean(axis=0)
        variances, directions = np.linalg.eigh(np.cov(found.T))
        # A direction in which the inputs hardly differ would need huge weights.
        kept = np.flatnonzero(variances > 1e-6 * variances[-1])[-_DIRECTIONS:]
        self._directions = directions[:, kept] / np.sqrt(variances[kept])
        self.size = (len(kept) + 1) * len(self._own)

    def changed(self, candidates: Floats) -> Floats:
        """Last layers (C, H + 1, J) of candidates (C, size).

        A joint on the other side has the weights of its counterpart for the mirrored inputs, the other half of them.
        """
        along = candidates.reshape(len(candidates), -1, len(self._own))
        weights = self._directions @ along[:, :-1]
        bias = along[:, -1] - self._mean @ weights
        of_joints, bias = weights[..., self._row], bias[..., self._row]
        halves = np.roll(np.arange(len(self._mean)), len(self._mean) // 2)
        of_joints[..., self._mirrored] = of_joints[:, halves][..., self._mirrored]
        of_joints, bias = of_joints * self._sign, bias * self._sign
        return self._layer + np.concatenate([of_joints, bias[:, None]], axis=1)

    def costs(self, candidates: Floats, sets: int = 1) -> Floats:
        """Cost of each candidate (C,), on new starts.

        Args:
            candidates: (C, size).
            sets: number of sets of starts that the candidates take in turn; 1: all have the same.
        """
        layers, seed = self.changed(candidates), self._seed()
        own, stiff = (self._measured(robots, layers, seed, sets) for robots in (self._robots, self._stiff_robots))
        costs = self._cost_of(own.means(stiff))
        return _IMPORTANCE @ np.where(np.isfinite(costs), costs, _FALL)

    def _seed(self) -> int:
        return int(self._random.integers(_LAST_SEED))

    def _measured(self, robots: "_Robots", layers: Floats, seed: int, sets: int) -> "_Measures":
        measures = _Measures(robots)
        of_robots = np.tile(np.repeat(layers, robots.starts, axis=0), (len(robots.commands), 1, 1))
        for step, _ in enumerate(self._walk(robots, of_robots, _STEPS, seed, sets)):
            measures.add(count=step >= _WARM_UP_STEPS)
        return measures

    def _cost_of(self, means: "_Means") -> Floats:
        """Cost of each candidate on each command (K, C)."""
        touchdowns = np.maximum(means.touchdowns.max(axis=-1) - _TOUCHDOWNS[:, None], 0.0)
        missing = np.maximum(_CLEARANCE - means.clearance.min(axis=-1) / self._scale, 0.0)
        errors = (means.velocity - self._commands[:, None]) / [_VELOCITY_ERROR * np.sqrt(self._scale), _YAW_ERROR]
        speed = np.abs(self._commands[:, :1])
        moves = speed > 0.0
        speed = np.where(moves, speed, 1.0)
        transport = means.power / (_GRAVITY * self._robot.total_mass * speed) * moves
        stiff, straight = np.zeros_like(transport), _straight(self._commands)
        stiff[straight] = np.maximum(np.abs(means.stiffened) / speed[straight] - _STIFF_FREE, 0.0)
        return (
            _EACH_TOUCHDOWN * touchdowns
            + _EACH_METRE * missing
            + (errors**2).sum(axis=-1)
            + (stiff / _STIFF_VELOCITY) ** 2
            + _TRANSPORT * transport
            + _FALL * means.fallen
        )

    def _walk(self, robots: "_Robots", layers: Floats, steps: int, seed: int, sets: int = 1) -> Iterator[Floats]:
        """Walk with last layers (H + 1, J), or one for each robot (N, H + 1, J); their inputs (N, H) of each step.

        The seed is that of the first start. For `sets`, see `costs`.
        """
        task, group = robots.task, robots.number // len(robots.commands)
        candidate, start = np.divmod(np.arange(group), robots.starts)
        seeds = (seed + candidate % sets * _STARTS + start).tolist()
        for index, command in enumerate(robots.commands):
            task.reset(np.arange(index * group, (index + 1) * group), seeds, [*command, *self._other_commands])
        observations = task.observe()
        extractor = self._model.policy.mlp_extractor
        for _ in range(steps):
            if self._stopped():
                raise StoppedError
            with torch.inference_mode():
                seen = extractor.seen_by_actor(torch.from_numpy(observations))
                inputs = extractor.policy_net(seen).numpy().astype(np.float64)
            actions = (inputs[:, None] @ layers[..., :-1, :])[:, 0] + layers[..., -1, :]
            # Of a robot whose simulation diverged, nothing is finite.
            actions = np.nan_to_num(np.clip(actions, -1.0, 1.0))
            observations = task.step(actions).observation
            self._model.num_timesteps += robots.number
            self._steps += robots.number
            if self._report is not None:
                self._report(self._steps / self._all_steps, None)
            yield inputs

    def take(self, candidate: Floats) -> None:
        """Make a candidate's last layer the model's."""
        policy, layer = self._model.policy, torch.from_numpy(self.changed(candidate[None])[0].astype(np.float32))
        with torch.no_grad():
            policy.action_net.weight.copy_(layer[:-1].T)
            policy.action_net.bias.copy_(layer[-1])
        policy.project()


class _Robots:
    """All candidates on each command (K, 2), from a number of starts each (K, C, S)."""

    def __init__(self, config: TaskConfig, commands: Floats, starts: int, stiffness: int = 1) -> None:
        self.commands, self.starts = commands, starts
        self.number = len(commands) * _CANDIDATES * starts
        # No contact's time constant can be shorter than two physics steps.
        config = replace(
            config,
            physics_timestep=config.physics_timestep / stiffness,
            decimation=config.decimation * stiffness,
        )
        model = config.compiled_model()
        model.geom_solref[:, 0] /= stiffness
        self.task = Task(BatchSimulation(model, self.number, robot=config.robot), config)


@dataclass(frozen=True)
class _Means:
    """Results of candidates on each command, means over their starts (K, C, ...)."""

    touchdowns: Floats
    """Per stride, of each foot (K, C, L)"""
    clearance: Floats
    """Largest height of each sole in a stride or swing, the least of them (K, C, L), m"""
    velocity: Floats
    """Forward, m/s, and yaw rate, rad/s (K, C, 2)"""
    stiffened: Floats
    """Forward velocity from the first start in stiff contacts, minus that in the robot's own, on the commands without a
    turn (K', C), m/s"""
    power: Floats
    """Electrical (K, C), W"""
    fallen: Floats
    """Share of the starts that ended in a fall (K, C)"""


class _Measures:
    """Measures of robots while they walk."""

    def __init__(self, robots: _Robots) -> None:
        self._robots, task = robots, robots.task
        self._task = task
        num, legs = task.context.foot_contact.shape
        self._strides = Strides(num)
        self._stride, self._clock = np.zeros((num, legs)), task.control.leg_clock()
        self._contact = task.context.foot_contact.copy()
        self._velocity, self._power, self._fallen = np.zeros((num, 2)), np.zeros(num), np.zeros(num, dtype=np.bool_)
        self._joule = task.config.motor.joule_coefficients(task.config.robot.joint_kinds)
        self._counted = 0

    def add(self, count: bool) -> None:
        """Take the readings of one control step; unless they count, only falls and the strides' number."""
        readings, context = self._task.simulation.readings, self._task.context
        self._fallen |= context.fallen > 0.0
        before, self._clock = self._clock, self._task.control.leg_clock()
        self._stride = self._stride + ((self._clock > 0.0) & (before <= 0.0))  # a stride begins with the swing
        contact_before, self._contact = self._contact, context.foot_contact.copy()
        if count:
            self._counted += 1
            self._strides.add(self._stride, context.sole_height, self._contact, contact_before)
            self._velocity += self._task.smooth_velocity
            self._power += electrical_power(readings.joint_torque, readings.joint_velocity, self._joule)

    def velocity(self) -> Floats:
        """Mean of each robot, forward, m/s, and yaw rate, rad/s (K, C, S, 2)."""
        return self._by_start(self._velocity / self._counted)

    def means(self, stiff: "_Measures") -> _Means:
        """Means over the starts, and what changes in stiff contacts from the first one."""
        strides, velocity = self._strides, self.velocity()
        whole = np.maximum(strides.count, 1.0)
        return _Means(
            touchdowns=self._mean(strides.touchdowns / whole),
            clearance=self._mean(np.where(strides.count > 0.0, strides.lowest_apex, 0.0)),
            velocity=velocity.mean(axis=2),
            stiffened=(stiff.velocity() - velocity[_straight(self._robots.commands)])[:, :, 0, 0],
            power=self._mean(self._power / self._counted),
            fallen=self._mean(self._fallen.astype(np.float64)),
        )

    def _by_start(self, values: Floats) -> Floats:
        return values.reshape(len(self._robots.commands), -1, self._robots.starts, *values.shape[1:])

    def _mean(self, values: Floats) -> Floats:
        return self._by_start(values).mean(axis=2)
