"""The least-squares problem of identification, in the terms of MuJoCo's toolbox `mujoco.sysid`."""

import io
from collections.abc import Mapping, Sequence
from typing import Any, Final

import mujoco
import numpy as np
from numpy.typing import NDArray

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
from quadruped_env.utils.progress import Progress

_UNDETERMINED: Final = 1.0
"""Maximum half-width of a 95 % interval under white noise, relative to the value or its scale. A parameter with a wider
interval is not determined and keeps its start value."""
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
        base: `fixed` or `free`.
        start: initial motors.
        fitted: parameters to fit, names in `QUANTITIES`.
        progress: called with the approximate fraction done.
    """

    def __init__(
        self, recorded: Recorded, base: str, start: MotorConfig, fitted: Sequence[str], progress: Progress | None = None
    ) -> None:
        from mujoco import sysid

        self.sysid = sysid
        self.recorded = recorded
        self.base = base
        self.start = start
        self.names = names_of(fitted, recorded.robot)
        self.half_width: dict[str, float] = {}
        self._progress = progress
        self._iterations = 0
        self._spec = joint_spec(recorded.robot, base, recorded.timestep)
        self._max_delay = max(MAX_FIT_DELAY, start.delay)
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

    def predict(self, motors: MotorConfig) -> NDArray[np.float64]:
        """Simulated signals over the whole recording, at the times of the measurements, (T, S)."""
        trajectory = self._sequences(len(self.recorded.control)).measured_rollout[0]
        model = self._model(motors)
        (rollout,) = self.sysid.sysid_rollout(
            [model], [mujoco.MjData(model)], [trajectory.control], [trajectory.initial_state]
        )
        return self._at(self.recorded.times, self._signals(rollout.state.data, rollout.sensordata.data))

    def mismatch(self) -> float:
        """Smallest error over a grid of delays with all other parameters at the start: the misfit of this base.

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
        """Values fitted at the best of many fixed delays.

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
        """The best of a grid of delays, with all other parameters at the start."""
        parameters = self._parameters(values)
        candidates = np.arange(0.0, 0.5 * MAX_FIT_DELAY, max(self.recorded.timestep, _FINEST_DELAY))
        points = np.tile(parameters.as_vector()[:, None], (1, len(candidates)))
        points[list(values).index(DELAY)] = candidates / quantity(DELAY).scale
        residuals, _, _ = self._residual_function()(points, parameters)
        self._tell(())
        return float(candidates[np.argmin((residuals[0] ** 2).sum(axis=0))])

    def _search(self, values: Mapping[str, float]) -> dict[str, float]:
        """The best values near a solution, which may be a local minimum of the rough error."""
        found = search(*self._problem(values), lambda: self._tell(()))
        return from_coordinates(dict(zip(values, found.tolist(), strict=True)))

    def _problem(self, values: Mapping[str, float]) -> tuple[Any, Any, Any, Any]:
        """The residuals as a function of coordinates (n, P), the coordinates of the values, and their bounds."""
        parameters = self._parameters(values)
        evaluate = self._residual_function()
        rows = int(np.count_nonzero(self._rows()))

        def residuals(points: NDArray[np.float64]) -> NDArray[np.float64]:
            found = evaluate(np.ascontiguousarray(points.T), parameters)[0][0]
            result: NDArray[np.float64] = np.asarray(found).T.reshape(len(points), rows, -1)
            return result

        low, high = map(np.asarray, parameters.get_bounds())
        # Not the parameters' own coordinates, which have a margin to the bounds.
        return residuals, np.clip(list(to_coordinates(values).values()), low, high), low, high

    def _solve_at(self, delay: float, values: Mapping[str, float]) -> tuple[float, dict[str, float]]:
        """The smallest error at a fixed delay, and its values."""
        found = self._solve({**values, DELAY: delay}, frozen=(DELAY,), iterations=_ITERATIONS_PER_DELAY)
        parameters = self._parameters(found)
        residuals = self._residual_function()(parameters.as_vector(), parameters)[0]
        return float((residuals[0] ** 2).sum()), found

    def _solve(
        self, values: Mapping[str, float], frozen: Sequence[str] = (), iterations: int = _ITERATIONS
    ) -> dict[str, float]:
        """Values at a local optimum, which may be due to the roughness of the error."""
        parameters = self._parameters(values, frozen)
        found, _ = self.sysid.optimize(
            parameters,
            self._residual_function(),
            optimizer="mujoco",
            verbose=False,
            max_iters=iterations,
            eps=_STEP,
            xtol=_TOLERANCE,
            x_scale="jac",
            output=io.StringIO(),
            iter_callback=self._tell,
        )
        return _values_of(found)

    def _tell(self, trace: Sequence[Any]) -> None:
        self._iterations += 1
        if self._progress is not None:
            # The number of iterations is unknown; the estimate grows when it is exceeded.
            self._progress(self._iterations / max(_EXPECTED_ITERATIONS, 1.25 * self._iterations))

    def _intervals(self, values: Mapping[str, float]) -> dict[str, float]:
        """Half-widths of the 95 % intervals of the values that are determined.

        The others are removed one after another, the least certain first: if the recording determines only the sum of
        two parameters, fixing one determines the other.
        """
        jacobian, left_over = derivatives(*self._problem(values))
        times, robot = self.recorded.times[self._rows()], self.recorded.robot
        joints, kinds = robot.num_joints, len(robot.joints_by_kind)
        scales = np.array([quantity(name).scale for name in values])
        jacobian = jacobian @ coordinate_derivatives(values) * scales
        influence = np.sqrt((jacobian**2).sum(axis=(0, 1)))
        allowed = _UNDETERMINED * np.maximum(np.array(list(values.values())) / scales, 1.0)
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

    def _inverse_spread(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Weights (S,): the inverse RMS of each signal in values (T, S); 0 for missing signals."""
        weights = np.zeros(values.shape[1])
        for name in self.recorded.signals:
            part = self.recorded.columns(name)
            weights[part] = 1.0 / max(np.sqrt(np.nanmean(values[:, part] ** 2)), 1e-9)
        return weights

    def _parameters(self, values: Mapping[str, float], frozen: Sequence[str] = ()) -> Any:
        parameters = self.sysid.ParameterDict()
        for name, coordinate in to_coordinates(values).items():
            low = LOWEST if quantity(name).positive else 0.0
            high = MAX_FIT_DELAY / quantity(name).scale if name == DELAY else HIGHEST
            # The fit could stall on a bound.
            margin = 0.0 if name in frozen else 2e-3 * (high - low)
            inside = float(np.clip(coordinate, low + margin, high - margin))
            parameters.add(self.sysid.Parameter(name, inside, low, high, frozen=name in frozen))
        return parameters

    def _residual_function(self) -> Any:
        def build(parameters: Any, spec: mujoco.MjSpec) -> mujoco.MjModel:
            return self._model(with_values(self.start, _values_of(parameters)))

        steps = int(np.ceil(self.recorded.times[self._rows()][-1] / self.recorded.timestep)) + 1
        return self.sysid.build_residual_fn(
            models_sequences=[self._sequences(steps)],
            build_model=build,
            modify_residual=self._residual,
            custom_rollout=self._rollout,
            resample_true=False,
        )

    def _rollout(
        self, models: Sequence[Any], datas: Sequence[Any], control_signal: Any, initial_states: Any, **rest: Any
    ) -> list[Any]:
        """The toolbox's `CustomRolloutFn`, without the motors' command history, which is most of a state.

        A few models at a time, because the states of all models over a minute take a gigabyte.
        """
        del rest
        kept = []
        for first in range(0, len(models), len(datas)):
            part = slice(first, first + len(datas))
            trajectories = self.sysid.sysid_rollout(
                models[part], datas[: len(models[part])], control_signal[part], initial_states[part]
            )
            for trajectory in trajectories:
                state = trajectory.state.data[:, : 1 + sum(self._sizes)].copy()
                kept.append(trajectory.replace(state=self.sysid.TimeSeries(trajectory.state.times, state)))
        return kept

    @property
    def _sizes(self) -> tuple[int, int]:
        """Numbers of positions and velocities."""
        robot = self.recorded.robot
        if self.base == "fixed":
            return robot.num_joints, robot.num_joints
        return robot.num_positions, robot.num_velocities

    def _residual(
        self, params: Any, predicted: Any, measured: Any, model: Any, return_all: bool, state: Any
    ) -> tuple[NDArray[np.float64], Any, Any]:
        """The toolbox's `ModifyResidualFn`: weighted differences over the fit's time."""
        rows = self._rows()
        signals = self._at(self.recorded.times[rows], self._signals(state, predicted.data))
        measured_here = self.recorded.measured[rows]
        # A diverged simulation gets the maximum error.
        signals = np.nan_to_num(signals, nan=_DIVERGED, posinf=_DIVERGED, neginf=-_DIVERGED)
        difference = np.where(np.isfinite(measured_here), (signals - measured_here) * self._weights, 0.0)
        series = self.sysid.TimeSeries(self.recorded.times[rows], difference)
        return difference / np.sqrt(len(difference)), series, series

    def _rows(self) -> NDArray[np.bool_]:
        """Mask of the measurements that the fit uses (T,)."""
        times = self.recorded.times
        return self.recorded.train & (times >= self.recorded.timestep - 1e-9) & (times <= self._horizon)

    def _model(self, motors: MotorConfig) -> mujoco.MjModel:
        spec = self._spec.copy()
        motors.write(spec, self.recorded.robot.joint_kinds, self._max_delay)
        return spec.compile()

    def _sequences(self, steps: int) -> Any:
        """The recording's first physics steps, for the toolbox."""
        spec = self._spec.copy()
        self.start.write(spec, self.recorded.robot.joint_kinds, self._max_delay)
        model = spec.compile()
        data = mujoco.MjData(model)
        positions, velocities = self.recorded.start
        if self.base == "free":
            data.qpos[:7] = self.recorded.robot.resting_pose(positions)
        data.qpos[-len(positions) :] = positions
        data.qvel[-len(velocities) :] = velocities
        fill_command_history(model, data.history[None], self.recorded.control[:1])
        kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
        state = np.empty(mujoco.mj_stateSize(model, kind))
        mujoco.mj_getState(model, data, state, kind)
        # The toolbox drops the last control: it expects no measurement after it.
        control = self.recorded.control[:steps]
        control = np.concatenate([control, control[-1:]])
        clock = np.arange(len(control)) * self.recorded.timestep
        measured = self.sysid.TimeSeries(self.recorded.times, self.recorded.measured)
        return self.sysid.ModelSequences(
            self.recorded.robot.name, spec, "recording", state, self.sysid.TimeSeries(clock, control), measured
        )

    def _signals(self, state: NDArray[np.float64], sensordata: NDArray[np.float64]) -> NDArray[np.float64]:
        """Positions, velocities and efforts (K, S) after each physics step, from the toolbox's rollout."""
        joints = self.recorded.robot.num_joints
        positions, velocities = self._sizes
        # A state is the time, the positions, the velocities, and what the motors remember.
        after_positions = 1 + positions
        after_velocities = after_positions + velocities
        return np.concatenate(
            [
                state[:, after_positions - joints : after_positions],
                state[:, after_velocities - joints : after_velocities],
                sensordata[:, self.recorded.columns("effort")],
            ],
            axis=1,
        )

    def _at(self, times: NDArray[np.float64], signals: NDArray[np.float64]) -> NDArray[np.float64]:
        """Signals (K, S) after each physics step, at times (T,) in s; linear in between."""
        place = np.clip(times / self.recorded.timestep - 1.0, 0.0, len(signals) - 1.0)
        whole = np.rint(place)
        place = np.where(np.abs(place - whole) < 1e-6, whole, place)
        before = place.astype(np.intp)
        after = np.minimum(before + 1, len(signals) - 1)
        share = (place - before)[:, None]
        return (1.0 - share) * signals[before] + share * signals[after]


def joint_spec(robot: Robot, base: str, timestep: float) -> mujoco.MjSpec:
    """A robot with its joint sensors only, on a stand (`fixed`) or on the ground (`free`)."""
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
    if base == "fixed":
        for key in list(spec.keys):
            spec.delete(key)
        spec.delete(spec.joints[0])  # the free one
        # In the air there are no contacts, and with contacts disabled the motion is a smooth function of the motors.
        spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    return spec


def _centered(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Values (T, S) less the mean of each column, NaN aside."""
    count = np.isfinite(values).sum(axis=0)
    return values - np.nansum(values, axis=0) / np.maximum(count, 1)


def _values_of(parameters: Any) -> dict[str, float]:
    """The values behind the toolbox's parameters."""
    # The toolbox's steps to a bound may end a rounding error beyond it.
    return from_coordinates({name: max(0.0, float(parameter.value[0])) for name, parameter in parameters.items()})
