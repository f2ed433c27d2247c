"""The least-squares problem of identification: simulated joints against measured ones."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Final

import mujoco
import numpy as np
from mujoco import minimize
from mujoco.rollout import rollout

from quadruped_env.identification.dataset import Recorded
from quadruped_env.identification.fitted_parameters import (
    DELAY,
    HIGHEST,
    LOWEST,
    MAX_FIT_DELAY,
    coordinate_derivatives,
    from_coordinates,
    names_of,
    quantity,
    to_coordinates,
    value_of,
    with_values,
)
from quadruped_env.identification.rough_least_squares import derivatives, half_widths, search
from quadruped_env.robot import MotorConfig, Robot
from quadruped_env.robot.motors import fill_command_history
from quadruped_env.simulation.model import scene
from quadruped_env.utils.arrays import Bools, Floats
from quadruped_env.utils.progress import Progress

_UNDETERMINED: Final = 1.0
"""Maximum half-width of a 95 % interval under white noise, relative to the start value or its scale. A parameter with a
wider interval is not determined and keeps its start value."""
_STEP: Final = 1e-3
"""Step of the finite differences, in coordinates."""
_TOLERANCE: Final = 1e-4
"""Relative step tolerance."""
_ITERATIONS: Final = 30
_DIVERGED: Final = 1e6
_ITERATIONS_PER_DELAY: Final = 8
_DELAY_SECONDS: Final = 6.0
"""Part of the recording that the search for the delay uses, s."""
_FINEST_DELAY: Final = 0.001
"""Resolution of the search for the delay, s."""
_EXPECTED_ITERATIONS: Final = 120


class MotorFit:
    """Fit of motor parameters to a recording.

    Args:
        recorded: joint targets and measurements.
        start: initial motors.
        fitted: parameters to fit, names in `QUANTITIES`.
        progress: called with the approximate fraction done.
        on_ground: True for a robot that begins at rest on flat ground; otherwise it hangs on a stand, feet in the air.
    """

    def __init__(
        self,
        recorded: Recorded,
        start: MotorConfig,
        fitted: Sequence[str],
        progress: Progress | None = None,
        on_ground: bool = False,
    ) -> None:
        self.recorded = recorded
        self.on_ground = on_ground
        self.start = start
        self.names = names_of(fitted, recorded.robot)
        self.half_width: dict[str, float] = {}
        self._progress = progress
        self._iterations = 0
        self._spec = joint_spec(recorded.robot, recorded.timestep, on_ground)
        self._max_delay = max(MAX_FIT_DELAY, start.delay)
        self._datas = [mujoco.MjData(self._model(start)) for _ in range(os.cpu_count() or 1)]
        """One for each thread of a rollout"""
        self._weights = np.ones(recorded.measured.shape[1])
        self._horizon = np.inf
        """End of the time that the fit uses, s."""

    def run(self) -> MotorConfig:
        """Fit the motors; `half_width` then has the 95 % intervals of the parameters that the recording determines.

        Parameters that it does not determine (a motor's strength, if no motor was at its limit) are reset to their
        start values, and the others are fitted again.
        """
        values = {name: value_of(self.start, name) for name in self.names}
        train = self.recorded.measured[self.recorded.train]
        # The noise is not known yet, so each signal is weighted by the inverse of its own variation.
        self._weights = self._inverse_spread(_centered(train))
        if DELAY in values:
            self._horizon = _DELAY_SECONDS
            values = self._find_delay(values)
            self._horizon = np.inf
        while values:
            values = self._solve(values)
            # The maximum-likelihood motors, if the residuals are noise.
            self._weights = self._inverse_spread(
                self.predict(with_values(self.start, values))[self.recorded.train] - train
            )
            values = self._search(values)
            self.half_width = self._intervals(values)
            if len(self.half_width) == len(values):
                break
            values = {name: value for name, value in values.items() if name in self.half_width}
        if self._progress is not None:
            self._progress(1.0)
        return with_values(self.start, values)

    def predict(self, motors: MotorConfig) -> Floats:
        """Return simulated signals over the whole recording, at the times of the measurements, (T, S)."""
        (signals,) = self._simulate([motors], self.recorded.times)
        return signals

    def mismatch(self) -> float:
        """Return the smallest error over a grid of delays with all other parameters at the start.

        Computed from positions and, if measured, efforts over the first seconds of the fit, relative to the motion
        itself. Velocities are not used because they hardly depend on the load.
        """
        train = self.recorded.measured[self.recorded.train]
        self._weights = self._inverse_spread(_centered(train))
        self._horizon = _DELAY_SECONDS
        delay = self._scan_delay({DELAY: value_of(self.start, DELAY)})
        rows = self._rows()
        predicted = np.nan_to_num(self.predict(with_values(self.start, {DELAY: delay})), nan=_DIVERGED)
        predicted = predicted.clip(-_DIVERGED, _DIVERGED)
        left = (predicted - self.recorded.measured)[rows] * self._weights
        parts = [self.recorded.columns(name) for name in ("position", "effort") if name in self.recorded.signals]
        return float(np.exp(np.mean([np.log(np.nanmean(left[:, part] ** 2)) / 2.0 for part in parts])))

    def _find_delay(self, values: dict[str, float]) -> dict[str, float]:
        """Return values fitted at the best of many fixed delays.

        A delay that is free from the start gets stuck between two physics steps, where the motion has a kink.
        """
        delay = self._scan_delay(values)
        error, values = self._solve_at(delay, values)
        step = max(self.recorded.timestep, _FINEST_DELAY)
        while step >= _FINEST_DELAY:
            improved = False
            for direction in (-step, step):
                while not improved or direction * (values[DELAY] - delay) > 0:
                    nearby = values[DELAY] + direction
                    if not 0.0 <= nearby <= MAX_FIT_DELAY:
                        break
                    found, candidate = self._solve_at(nearby, values)
                    if found >= error:
                        break
                    error, values, improved = found, candidate, True
                if improved:
                    break
            delay = values[DELAY]
            step *= 0.5
        return values

    def _scan_delay(self, values: dict[str, float]) -> float:
        """Return the best of a grid of delays, with all other parameters at the start."""
        residuals, start, _, _ = self._problem(values)
        candidates = np.arange(0.0, 0.5 * MAX_FIT_DELAY, max(self.recorded.timestep, _FINEST_DELAY))
        points = np.tile(start, (len(candidates), 1))
        points[:, list(values).index(DELAY)] = candidates / quantity(DELAY).scale
        self._tell()
        return float(candidates[np.argmin((residuals(points) ** 2).sum(axis=(1, 2)))])

    def _search(self, values: Mapping[str, float]) -> dict[str, float]:
        """Return the best values near a solution, which may be a local minimum of the rough error."""
        found = search(*self._problem(values), self._tell)
        return from_coordinates(dict(zip(values, found.tolist(), strict=True)))

    def _solve_at(self, delay: float, values: Mapping[str, float]) -> tuple[float, dict[str, float]]:
        """Return the smallest error at a fixed delay, and its values."""
        free = {name: value for name, value in values.items() if name != DELAY}
        found = self._solve(free, _ITERATIONS_PER_DELAY, {DELAY: delay})
        residuals, point, _, _ = self._problem(found, {DELAY: delay})
        every = {name: found.get(name, delay) for name in values}
        return float((residuals(point[None]) ** 2).sum()), every

    def _solve(
        self,
        values: Mapping[str, float],
        iterations: int = _ITERATIONS,
        fixed: Mapping[str, float] = {},
    ) -> dict[str, float]:
        """Return values at a local optimum, which may be due to the roughness of the error."""
        if not values:
            return {}
        residuals, start, low, high = self._problem(values, fixed)
        # The fit could stall on a bound.
        margin = 2e-3 * (high - low)

        def columns(points: Floats) -> Floats:
            """Return residuals (M, n) of points (P, n)."""
            found = residuals(points.reshape(len(values), -1).T)
            return found.reshape(len(found), -1).T

        found, _ = minimize.least_squares(
            np.clip(start, low + margin, high - margin),
            columns,
            [low, high],
            eps=_STEP,
            xtol=_TOLERANCE,
            max_iter=iterations,
            verbose=minimize.Verbosity.SILENT,
            iter_callback=lambda trace: self._tell(),
            x_scale="jac",
        )
        return from_coordinates(dict(zip(values, np.maximum(found, 0.0).ravel().tolist(), strict=True)))

    def _problem(
        self,
        values: Mapping[str, float],
        fixed: Mapping[str, float] = {},
    ) -> tuple[Callable[[Floats], Floats], Any, Any, Any]:
        """Return the weighted residuals (n, T, S) as a function of coordinates (n, P), the start, and both bounds."""
        rows = self._rows()
        measured = self.recorded.measured[rows]

        def residual(signals: Floats) -> Floats:
            # A diverged simulation gets the maximum error.
            signals = np.nan_to_num(signals, nan=_DIVERGED, posinf=_DIVERGED, neginf=-_DIVERGED)
            return np.where(np.isfinite(measured), (signals - measured) * self._weights, 0.0) / np.sqrt(len(measured))

        def residuals(points: Floats) -> Floats:
            coordinates = (dict(zip(values, point, strict=True)) for point in np.maximum(points, 0.0).tolist())
            motors = [with_values(self.start, {**from_coordinates(one), **fixed}) for one in coordinates]
            return np.stack([residual(signals) for signals in self._simulate(motors, self.recorded.times[rows])])

        low = np.array([LOWEST if quantity(name).positive else 0.0 for name in values])
        high = np.array([MAX_FIT_DELAY / quantity(name).scale if name == DELAY else HIGHEST for name in values])
        return residuals, np.clip(list(to_coordinates(values).values()), low, high), low, high

    def _tell(self) -> None:
        self._iterations += 1
        if self._progress is not None:
            # The number of iterations is unknown; the estimate grows when it is exceeded.
            self._progress(self._iterations / max(_EXPECTED_ITERATIONS, 1.25 * self._iterations))

    def _intervals(self, values: Mapping[str, float]) -> dict[str, float]:
        """Return half-widths of the 95 % intervals of the values that are determined.

        The others are removed one after another, the least certain first: if the recording determines only the sum of
        two parameters, fixing one determines the other.
        """
        jacobian, left_over = derivatives(*self._problem(values))
        times, robot = self.recorded.times[self._rows()], self.recorded.robot
        joints, kinds = robot.num_joints, len(robot.joints_by_kind)
        scales = np.array([quantity(name).scale for name in values])
        jacobian = jacobian @ coordinate_derivatives(values) * scales
        influence = np.sqrt((jacobian**2).sum(axis=(0, 1)))
        # Relative to the start: a value that runs away would allow itself any interval.
        allowed = _UNDETERMINED * np.maximum([value_of(self.start, name) for name in values] / scales, 1.0)
        left = np.flatnonzero(influence > 1e-9 * influence.max())
        while len(left):
            white, widths = half_widths(jacobian[..., left], left_over, times, joints, kinds)
            # Judged under white noise: a parameter with an influence is kept, however wide its full interval is.
            doubt = np.nan_to_num(white / allowed[left], nan=np.inf)
            if doubt.max() <= 1.0:
                names = list(values)
                return {names[k]: float(width * scales[k]) for k, width in zip(left, widths, strict=True)}
            hopeless = np.isinf(doubt)
            worst = np.where(hopeless, -influence[left], -np.inf).argmax() if hopeless.any() else doubt.argmax()
            left = np.delete(left, worst)
        return {}

    def _inverse_spread(self, values: Floats) -> Floats:
        """Return weights (S,): the inverse RMS of each signal in values (T, S); 0 for missing signals."""
        weights = np.zeros(values.shape[1])
        for name in self.recorded.signals:
            part = self.recorded.columns(name)
            weights[part] = 1.0 / max(np.sqrt(np.nanmean(values[:, part] ** 2)), 1e-9)
        return weights

    def _rows(self) -> Bools:
        """Return the mask of the measurements that the fit uses (T,)."""
        times = self.recorded.times
        return self.recorded.train & (times >= self.recorded.timestep - 1e-9) & (times <= self._horizon)

    def _model(self, motors: MotorConfig) -> mujoco.MjModel:
        spec = self._spec.copy()
        motors.write(spec, self.recorded.robot.joint_kinds)
        motors.write_delay(spec, self._max_delay)
        return spec.compile()

    def _simulate(self, motors: Sequence[MotorConfig], times: Floats) -> Iterator[Floats]:
        """Yield the signals (T, S) simulated with each of these motors, at times (T,) from the start in s."""
        recorded, joints = self.recorded, self.recorded.robot.num_joints
        data = mujoco.MjData(model := self._model(self.start))
        positions, velocities = recorded.start
        if self.on_ground:
            data.qpos[:7] = recorded.robot.skeleton.resting_pose(positions)
        data.qpos[-joints:], data.qvel[-joints:] = positions, velocities
        fill_command_history(model, data.history[None], recorded.control[:1])
        kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
        start = np.empty(mujoco.mj_stateSize(model, kind))
        mujoco.mj_getState(model, data, start, kind)
        control = recorded.control[: int(np.ceil(times[-1] / recorded.timestep)) + 1]
        # A state is the time, the positions, the velocities, and what the motors remember.
        after_positions, after_velocities = 1 + model.nq, 1 + model.nq + model.nv
        # A few models at a time, because the states of all models over a minute take a gigabyte.
        for first in range(0, len(motors), len(self._datas)):
            models = [self._model(one) for one in motors[first : first + len(self._datas)]]
            states, sensors = rollout(models, self._datas[: len(models)], start[None], control[None])
            for state, sensordata in zip(states, sensors, strict=True):
                parts = [
                    state[:, after_positions - joints : after_positions],
                    state[:, after_velocities - joints : after_velocities],
                    sensordata[:, recorded.columns("effort")],
                ]
                yield self._at(times, np.concatenate(parts, axis=1))

    def _at(self, times: Floats, signals: Floats) -> Floats:
        """Return signals (K, S) after each physics step, at times (T,) in s; linear in between."""
        place = np.clip(times / self.recorded.timestep - 1.0, 0.0, len(signals) - 1.0)
        whole = np.rint(place)
        place = np.where(np.abs(place - whole) < 1e-6, whole, place)
        before = place.astype(np.intp)
        after = np.minimum(before + 1, len(signals) - 1)
        share = (place - before)[:, None]
        return (1.0 - share) * signals[before] + share * signals[after]


def joint_spec(robot: Robot, timestep: float, on_ground: bool = False) -> mujoco.MjSpec:
    """Return a robot with its joint sensors only, on a stand or on the ground."""
    spec = scene(robot)
    spec.option.timestep = timestep
    wanted = {
        sensor for field in ("joint_position", "joint_velocity", "joint_torque") for sensor in robot.sensor_names[field]
    }
    for sensor in list(spec.sensors):
        if sensor.name not in wanted:
            spec.delete(sensor)
    # A fit compiles thousands of models, and the textures' pixels would take nine tenths of that.
    for geom in spec.geoms:
        geom.material = ""
    for looks in [*spec.materials, *spec.textures]:
        spec.delete(looks)
    if not on_ground:
        for key in list(spec.keys):
            spec.delete(key)
        spec.delete(spec.joints[0])  # the free one
        # In the air there are no contacts, and with contacts disabled the motion is a smooth function of the motors.
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return spec


def _centered(values: Floats) -> Floats:
    """Return values (T, S) less the mean of each column, NaN aside."""
    count = np.isfinite(values).sum(axis=0)
    return values - np.nansum(values, axis=0) / np.maximum(count, 1)
