"""A reflex against falls: learned from replays of falls, then taught to the policy's network.

PPO with as little noise as keeps a gait does not learn to survive a push: falls are rare, and the noise does not decide
them. Here the states before falls are kept, and each is repeated several times with much noise while the robot is
disturbed, so that some repetitions survive. What they did differently is the gradient of a reflex: a linear function of
tilt and rates of rotation, which is zero while the robot is not disturbed, and has so few weights that some thousand
repetitions are enough for a natural gradient step (Kakade 2001; each state's mean over its repetitions is the baseline,
as in Kool et al. 2019, https://openreview.net/forum?id=r1lgTGL5DE). In the end the network learns to do by itself what
policy and reflex do together, from the observations of a robot (Ross et al. 2011, https://arxiv.org/abs/1011.0686).
"""

import copy
import math
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
import torch
from numpy.typing import NDArray

from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.task import Task

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]

_CALM_TILT, _TILT_RANGE = 0.10, 0.08
"""Sine of the tilt below which a robot is not disturbed, and above that, until it counts as fully disturbed."""
_CALM_RATE, _RATE_RANGE = 1.7, 1.0
"""The same for the rate of roll and pitch, rad/s, of the built-in robot. Its gaits stay below it on level ground."""
_TILT_UNIT, _RATE_UNIT = 0.2, 3.0
"""Tilt and rate (rad/s) at which an input of the reflex is 1."""

_NOISE: Final = 0.3
"""Standard deviation of the noise on the actions of a disturbed robot, in the replays."""
_NOISE_KEPT: Final = 0.85
"""Correlation of the noise with itself one control step later. White noise moves a joint less than its motor can."""
_REPEATS: Final = 8
"""Repetitions of each state with other noise."""
_REPLAYS, _REPLAY_STEPS = 6144, 100
"""Replays of a round, and control steps of each: 2 s, in which a robot falls, gets stuck or walks on."""
_SHARE_OF_FALLS: Final = 5 / 8
"""Share of the replays that begin before a fall. The others keep the reflex from costing falls elsewhere."""
_WALKING_SHARE, _WALKING_STEPS = 0.6, 30
"""Share of a survivor's score that depends on how it walks in the last steps of the replay."""
_TRACKING_WIDTH: Final = (0.15, 0.3)
"""Errors of forward velocity (m/s) and yaw rate (rad/s) at which an undisturbed robot counts as walking by 1 / e."""

_BEFORE_FALL: Final = 30
"""Control steps before a fall at which its replays begin at the latest: 0.6 s."""
_KEEP_INTERVAL: Final = 20
"""Control steps between the states of an env that are kept in case it falls."""
_KEPT_STATES: Final = 400
"""Number of the latest states from which replays begin, of each kind."""
_FIRST_STEPS, _ROUND_STEPS = 512_000, 256_000
"""Environment steps in which states are collected, before the first round and after each."""

_STEP: Final = 0.15
"""Root mean square of the change of a disturbed robot's actions by the first rounds' steps."""
_LAST_STEP: Final = 0.25
"""Smallest share of it in later rounds."""
_DAMPING: Final = 0.1
"""Share of the Fisher matrix's diagonal that is added to it."""

_LESSON_STEPS, _LESSON_EPOCHS = 768_000, 8
"""Environment steps of the network's lesson, and passes over them."""
_LESSON_BATCH, _LESSON_RATE = 4096, 1e-3
"""Samples in a gradient step of the lesson, and Adam's first step size, which falls to 0 as half a cosine."""


class StoppedError(Exception):
    """Raised in the parts after PPO's budget if the training is to end."""


class Reflex:
    """Linear function of how a robot tilts and turns over, zero while it is not disturbed.

    A joint and its counterpart on the other side share their weights; their inputs are mirror images.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: Robot) -> None:
        joints = np.arange(robot.num_joints)
        _, self._row = np.unique(np.minimum(joints, robot.joint_mirror), return_inverse=True)
        self._sign = np.where(joints > np.array(robot.joint_mirror), robot.joint_signs, 1.0)
        self._leg = np.empty_like(joints)
        for leg, own in enumerate(robot.leg_joints):
            self._leg[list(own)] = leg
        self._side = np.where(robot.left_legs, 1.0, -1.0)[self._leg]
        # The time in which a robot tips over grows with the square root of its size.
        self._rate_scale = 1.0 / math.sqrt(scale_of("m", robot))
        self.weights: Floats = np.zeros((int(self._row.max()) + 1, 12))
        """Weights (pairs of joints, inputs); an action's unit is its range."""

    def disturbance(self, task: Task) -> Floats:
        """Size of the disturbance of each robot (N,), from 0 to 1."""
        tilt, rate = self._tilt_and_rate(task)
        return np.maximum(
            np.clip((np.hypot(*tilt) - _CALM_TILT) / _TILT_RANGE, 0.0, 1.0),
            np.clip((np.hypot(*rate) - _CALM_RATE) / _RATE_RANGE, 0.0, 1.0),
        )

    def _tilt_and_rate(self, task: Task) -> tuple[Floats, Floats]:
        """Horizontal part of the up axis (2, N), and roll and pitch rate (2, N), in the base frame."""
        readings = task.context.readings
        return readings.up_b[:, :2].T, readings.angular_velocity_b[:, :2].T / self._rate_scale

    def inputs(self, task: Task) -> Floats:
        """Inputs of each joint, without the factor of the disturbance (N, J, inputs).

        A constant, pitch and roll with their rates, the sizes of the latter, and the first five of these times the sine
        of the leg's clock. Roll has the sign of the leg's side.
        """
        (pitch, roll), (roll_rate, pitch_rate) = self._tilt_and_rate(task)
        pitch, roll = pitch / _TILT_UNIT, roll / _TILT_UNIT
        roll_rate, pitch_rate = roll_rate / _RATE_UNIT, pitch_rate / _RATE_UNIT
        both = [np.ones_like(pitch), pitch, pitch_rate]
        parts = [np.repeat(part[:, None], len(self._side), axis=1) for part in both]
        parts += [roll[:, None] * self._side, roll_rate[:, None] * self._side]
        sizes = [np.repeat(np.abs(part)[:, None], len(self._side), axis=1) for part in (roll, roll_rate)]
        clock = task.control.leg_clock()[:, self._leg]
        return np.stack([*parts, *sizes, *(part * clock for part in parts)], axis=-1)

    def actions(self, disturbance: Floats, inputs: Floats) -> Floats:
        """Share of the reflex in the actions (N, J)."""
        return self.response(inputs, self.weights) * disturbance[:, None]

    def response(self, inputs: Floats, weights: Floats) -> Floats:
        """Actions of fully disturbed robots by a reflex with these weights (N, J)."""
        return self._sign * np.einsum("njf,jf->nj", inputs, weights[self._row])

    def products(self, per_joint: Floats, inputs: Floats) -> Floats:
        """Sum of numbers (N, J) times inputs, over the joints that share weights (N, pairs of joints, inputs)."""
        products = (self._sign * per_joint)[..., None] * inputs
        sums = np.zeros((len(inputs), *self.weights.shape))
        for joint, row in enumerate(self._row):
            sums[:, row] += products[:, joint]
        return sums


@dataclass(frozen=True)
class ReflexRound:
    """Results of a round of learning a reflex."""

    survived: float
    """Share of the replays of falls that survived, with noise, before the round's step."""
    fall_rate: float
    """Falls per 20 s of the policy with the reflex after it, without noise, as the policy is trained."""


Report = Callable[[float, list[ReflexRound]], None]
"""Called with the fraction done, and the rounds so far."""


def reflex_steps(rounds: int, num_envs: int) -> int:
    """Environment steps that learning a reflex takes."""
    batches, first, each, lesson = _control_steps(num_envs)
    return num_envs * (first + rounds * (batches * _REPLAY_STEPS + each) + lesson)


def _control_steps(num_envs: int) -> tuple[int, ...]:
    """Batches of replays in a round; control steps before the first round, after each round, and of the lesson."""
    return tuple(math.ceil(steps / num_envs) for steps in (_REPLAYS, _FIRST_STEPS, _ROUND_STEPS, _LESSON_STEPS))


def add_reflex(
    model: Any, rounds: int, report: Report | None = None, stopped: Callable[[], bool] = lambda: False
) -> list[ReflexRound]:
    """Learn a reflex on top of a PPO's policy, and teach it to the policy's network.

    The critic and the exploration stay as they are, and so do the model's envs. If no robot falls, or the training is
    to end before the lesson, the policy stays as it is.

    Args:
        model: a PPO of `make_model`; its `num_timesteps` grows.
        rounds: number of gradient steps of the reflex.
        report: called now and then with the fraction done, and the rounds so far.
        stopped: true if the training is to end.

    Returns:
        The rounds; empty if the policy stays as it is.
    """
    practice = _Practice(model, rounds, report, stopped)
    with practice.own_states():
        try:
            return practice.run(rounds)
        except StoppedError:
            return []


class _Practice:
    """The learning of a reflex; see `add_reflex`."""

    def __init__(self, model: Any, rounds: int, report: Report | None, stopped: Callable[[], bool]) -> None:
        self._model, self._report, self._stopped = model, report, stopped
        self._rounds: list[ReflexRound] = []
        self.task: Task = model.env.task
        self.num_envs: int = model.env.num_envs
        self.reflex = Reflex(self.task.control.robot)
        self._random = np.random.default_rng(model.seed)
        self._falls: deque[dict[str, Any]] = deque(maxlen=_KEPT_STATES)
        """States before falls."""
        self._others: deque[dict[str, Any]] = deque(maxlen=_KEPT_STATES)
        """States at any time."""
        self._batches, self._first, self._round, self._lesson = _control_steps(self.num_envs)
        self._steps, self._all_steps = 0, reflex_steps(rounds, self.num_envs) // self.num_envs

    def run(self, rounds: int) -> list[ReflexRound]:
        """See `add_reflex`."""
        self._collect(self._first)
        for index in range(rounds if self._falls else 0):
            survived = self._improve(_STEP * min(1.0, max(_LAST_STEP, 1.3 - 0.15 * index)))
            self._rounds.append(ReflexRound(survived, self._collect(self._round)))
        if self._rounds:
            teacher = copy.deepcopy(self._actor())
            try:
                self._teach(teacher)
            except StoppedError:
                self._actor().load_state_dict(teacher.state_dict())
                raise
        return self._rounds

    @contextmanager
    def own_states(self) -> Iterator[None]:
        """Within it, the envs may take any states; in the end each gets back its own, with its random numbers."""
        before = [self.task.get_state(env_id) for env_id in range(self.num_envs)]
        try:
            yield
        finally:
            for env_id, state in enumerate(before):
                self.task.set_state(env_id, state)

    def _note(self, share: float) -> None:
        if self._report is not None:
            self._report(share, self._rounds)

    def _observe(self) -> NDArray[np.float32]:
        return self._model.env.observe()

    def _act(self, observations: NDArray[np.float32]) -> tuple[Floats, Floats, Floats]:
        """Actions of policy and reflex (N, J), disturbance (N,) and inputs of the reflex (N, J, inputs)."""
        with torch.inference_mode():
            actions = self._model.policy.mean_action(torch.from_numpy(observations)).numpy().astype(np.float64)
        disturbance, inputs = self.reflex.disturbance(self.task), self.reflex.inputs(self.task)
        return actions + self.reflex.actions(disturbance, inputs), disturbance, inputs

    def _step(self, actions: Floats) -> tuple[NDArray[np.float32], Mask, Mask]:
        """Observations after a step (N, width), where an episode ended, and where it did in a fall."""
        if self._stopped():
            raise StoppedError
        observations, _, ended, infos = self._model.env.step(np.clip(actions, -1.0, 1.0).astype(np.float32))
        fell = ended.copy()
        for env_id in np.flatnonzero(ended):
            fell[env_id] = not infos[env_id]["TimeLimit.truncated"]
        self._model.num_timesteps += self.num_envs
        self._steps += 1
        self._note(self._steps / self._all_steps)
        return observations, ended, fell

    def _collect(self, steps: int) -> float:
        """Walk, and keep states; falls per 20 s."""
        self.task.reset(np.arange(self.num_envs))
        observations = self._observe()
        recent: list[deque[tuple[int, dict[str, Any]]]] = [deque(maxlen=4) for _ in range(self.num_envs)]
        falls = 0
        for step in range(steps):
            for env_id in range(step % _KEEP_INTERVAL, self.num_envs, _KEEP_INTERVAL):
                recent[env_id].append((step, self.task.get_state(env_id)))
            if step % 100 == 99:
                self._others += [self.task.get_state(i) for i in self._random.integers(self.num_envs, size=8).tolist()]
            observations, ended, fell = self._step(self._act(observations)[0])
            for env_id in np.flatnonzero(ended).tolist():
                early = [state for kept_at, state in recent[env_id] if kept_at <= step - _BEFORE_FALL]
                if fell[env_id] and early:
                    self._falls.append(early[-1])
                recent[env_id].clear()
            falls += int(fell.sum())
        return falls / (steps * self.num_envs * self.task.config.control_timestep / 20.0)

    def _improve(self, size: float) -> float:
        """One gradient step of the reflex, from replays; the share of the replays of falls that survived.

        Args:
            size: root mean square of the change of a disturbed robot's actions.
        """
        number = self.reflex.weights.size
        gradient, fisher = np.zeros(number), np.zeros((number, number))
        survived = []
        inputs: list[Floats] = []
        # Else all envs with the same state would go on with the same episodes.
        with self.own_states():
            for _ in range(self._batches):
                score, share, scores, disturbed = self._replay()
                survived.append(share)
                inputs.append(disturbed)
                gradient += score @ scores
                fisher += scores.T @ scores
        fisher[np.diag_indices(number)] *= 1.0 + _DAMPING
        # A weight whose input never differs from 0 has no gradient either.
        fisher[np.diag_indices(number)] += 1e-9 * max(1.0, float(fisher.trace()))
        step = np.linalg.solve(fisher, gradient).astype(np.float64).reshape(self.reflex.weights.shape)
        change = self.reflex.response(np.concatenate(inputs), step)
        self.reflex.weights += step * (size / max(1e-9, float(np.sqrt(np.mean(change * change)))))
        return float(np.mean(survived))

    def _replay(self) -> tuple[Floats, float, Floats, Floats]:
        """One batch of replays.

        Returns:
            Score of each replay, less the mean of the same state's (N,); share of the replays of falls that survived;
            gradient of the log probability of each replay's noise (N, weights); inputs of disturbed robots
            (M, J, inputs).
        """
        n = self.num_envs
        groups = math.ceil(n / _REPEATS)
        of_falls = math.ceil(_SHARE_OF_FALLS * groups)
        states = self._some(self._falls, of_falls)
        if self._others:
            states += self._some(self._others, groups - of_falls)
        group = np.arange(n) * len(states) // n
        for env_id in range(n):
            self.task.set_state(env_id, states[group[env_id]])
        observations = self._observe()
        joints = self.task.control.robot.num_joints
        alive, walking = np.ones(n, dtype=np.bool_), np.zeros(n)
        noise = self._random.standard_normal((n, joints))
        scores = np.zeros((n, *self.reflex.weights.shape))
        disturbed: list[Floats] = []
        for step in range(_REPLAY_STEPS):
            actions, disturbance, inputs = self._act(observations)
            self._advance(noise)
            scores += self.reflex.products(noise * (alive * disturbance)[:, None], inputs)
            disturbed.append(inputs[alive & (disturbance > 0.3)][:8])
            observations, _, fell = self._step(actions + _NOISE * disturbance[:, None] * noise)
            alive &= ~fell
            if step >= _REPLAY_STEPS - _WALKING_STEPS:
                walking += self._walking() / _WALKING_STEPS
        # A robot that survives by sitting down is not saved.
        score = alive * (1.0 - _WALKING_SHARE + _WALKING_SHARE * walking)
        means = np.bincount(group, score) / np.bincount(group)
        falls = group < of_falls
        return score - means[group], float(alive[falls].mean()), scores.reshape(n, -1), np.concatenate(disturbed)

    def _walking(self) -> Floats:
        """Quality of each robot's walk just now (N,), from 0 to 1: 1 if undisturbed and without a tracking error."""
        tracking = np.exp(-((self.task.tracking_error / _TRACKING_WIDTH) ** 2)).mean(axis=1)
        return (1.0 - self.reflex.disturbance(self.task)) * tracking

    def _advance(self, noise: Floats) -> None:
        """Advance correlated noise by a control step, in place."""
        noise *= _NOISE_KEPT
        noise += math.sqrt(1.0 - _NOISE_KEPT**2) * self._random.standard_normal(noise.shape)

    def _some(self, states: Sequence[dict[str, Any]], number: int) -> list[dict[str, Any]]:
        """As many states, chosen by chance."""
        return [states[i] for i in self._random.integers(len(states), size=number).tolist()]

    def _teach(self, teacher: torch.nn.Sequential) -> None:
        """Teach the network what the policy, whose copy is given, and the reflex do together.

        In the first half of the lesson these act, in the second the network itself: it would else not know the states
        into which its own small errors lead.
        """
        self.task.reset(np.arange(self.num_envs))
        observations = self._observe()
        policy = self._model.policy
        joints = self.task.control.robot.num_joints
        seen = torch.empty((self._lesson, self.num_envs, policy.actor_width))
        wanted = torch.empty((self._lesson, self.num_envs, joints))
        # Half of the robots are led astray, so that the network learns to return as well.
        astray = (np.arange(self.num_envs) % 2)[:, None]
        noise = self._random.standard_normal((self.num_envs, joints))
        half = self._lesson // 2
        for step in range(self._lesson):
            seen[step] = policy.mlp_extractor.seen_by_actor(torch.from_numpy(observations))
            disturbance, inputs = self.reflex.disturbance(self.task), self.reflex.inputs(self.task)
            with torch.inference_mode():
                actions = teacher(seen[step]).numpy() + self.reflex.actions(disturbance, inputs)
                wanted[step] = torch.from_numpy(np.clip(actions, -1.0, 1.0))
                if step >= half:
                    actions = self._model.policy.mean_action(torch.from_numpy(observations)).numpy().astype(np.float64)
            self._advance(noise)
            observations, *_ = self._step(actions + _NOISE * astray * disturbance[:, None] * noise)
            if step + 1 in (half, self._lesson):
                self._fit(seen[: step + 1].flatten(0, 1), wanted[: step + 1].flatten(0, 1))

    def _actor(self) -> torch.nn.Sequential:
        policy = self._model.policy
        return torch.nn.Sequential(*policy.mlp_extractor.policy_net, policy.action_net)

    def _fit(self, seen: torch.Tensor, wanted: torch.Tensor) -> None:
        """Fit the actor to actions (M, J) for observations (M, width)."""
        policy = self._model.policy
        policy.set_training_mode(True)
        actor = self._actor()
        optimizer = torch.optim.Adam(actor.parameters(), lr=_LESSON_RATE)
        steps = _LESSON_EPOCHS * math.ceil(len(seen) / _LESSON_BATCH)
        schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, steps)
        for _ in range(_LESSON_EPOCHS):
            for batch in torch.randperm(len(seen)).split(_LESSON_BATCH):
                loss = (actor(seen[batch]) - wanted[batch]).square().sum(1).mean()
                optimizer.zero_grad()
                loss.backward()
                optimizer.step()
                schedule.step()
        # Where the steps are not elementwise, rounding would add up to a difference between the sides.
        policy.project()
