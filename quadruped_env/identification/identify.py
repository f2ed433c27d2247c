"""Identification of the motors: the fit, its confidence intervals and its validation on held-out time."""

import importlib.util
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

import numpy as np

from quadruped_env._version import __version__
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.identification.dataset import UNITS, Recorded, align, remarks, whole
from quadruped_env.identification.fit import MotorFit
from quadruped_env.identification.fitted_parameters import FITTED, QUANTITIES, names_of, quantity, value_of
from quadruped_env.identification.recording_checks import check, check_stand
from quadruped_env.robot import MINI_QUADRUPED, MotorConfig, Robot
from quadruped_env.robot.motors import SERVO_ERRORS
from quadruped_env.task import TaskConfig
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.files import shown_argument
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.text_table import Table

_INTERVALS: Final = (
    "Intervals account for residuals that are correlated over up to a second, between signals and between joints; "
    "not for external forces."
)


@dataclass(frozen=True)
class Estimated:
    """One parameter of the motors, before and after the fit."""

    name: str
    """`delay`, or kind of joint and field of `JointMotor`: `hip.kp`"""
    unit: str
    before: float
    after: float
    half_width: float | None
    """Half-width of the 95 % confidence interval, in `unit`, if those `Identification.assumed` are right; None if the
    recording does not determine the parameter, which then keeps its start value"""


@dataclass(frozen=True)
class Identification:
    """Result of an identification."""

    source: str
    commands: str
    recorded: Recorded
    estimates: tuple[Estimated, ...]
    before: MotorConfig
    after: MotorConfig
    predicted_before: Floats
    """Simulated signals with the motors before the fit, at the times of the measurements (T, S)"""
    predicted_after: Floats
    """Simulated signals with the motors after the fit (T, S)"""
    remarks: tuple[str, ...]
    """Remarks on the recording, in sentences"""

    @property
    def assumed(self) -> tuple[str, ...]:
        """Parameters that keep their start values, which the estimates and their intervals assume to be right.

        A quantity in `QUANTITIES`, or one of its parameters, such as `hip.kp`.
        """
        estimated = {estimate.name for estimate in self.estimates if estimate.half_width is not None}
        found: list[str] = []
        for field in QUANTITIES:
            names = names_of([field], self.recorded.robot)
            kept = [name for name in names if name not in estimated]
            found += [field] if kept == names else kept
        return tuple(found)

    def condition(self) -> str:
        """Return the condition of the estimates in a sentence."""
        return (
            f"Estimates and intervals hold only if the motors' other values are right, which keep their start values: "
            f"{', '.join(self.assumed)}."
        )

    def errors(self, after: bool, held_out: bool = True) -> dict[str, Floats]:
        """Return the root mean square error (J,) of every measured signal, over the held-out time or the fit's.

        NaN for a joint whose signal was not measured.
        """
        predicted = self.predicted_after if after else self.predicted_before
        rows = ~self.recorded.train if held_out else self.recorded.train
        squared = (predicted - self.recorded.measured)[rows] ** 2
        count = np.isfinite(squared).sum(axis=0)
        rms = np.sqrt(np.nansum(squared, axis=0) / np.where(count, count, np.nan))
        return {name: rms[self.recorded.columns(name)] for name in self.recorded.signals}

    def verdict(self) -> str:
        """Return the verdict on the fit, from the position error on held-out time."""
        before, after = self._held_out()
        change = f"from {before:.4f} to {after:.4f} rad"
        if self.helps:
            return f"On held-out time the position error falls {change} ({100 * (1 - after / before):.0f} % less)."
        return f"On held-out time the position error does not fall: {change}. Do not use these motors."

    @property
    def helps(self) -> bool:
        """True if the fit reduces the position error on held-out time."""
        before, after = self._held_out()
        return after < before

    def _held_out(self) -> tuple[float, float]:
        """Return the position error on held-out time before and after, rad."""
        return pooled(self.errors(after=False)["position"]), pooled(self.errors(after=True)["position"])

    def report(self) -> dict[str, Any]:
        """Return the identification as JSON-serializable values."""
        times = self.recorded.times
        return {
            "recording": shown_argument(self.source),
            "commands": self.commands,
            "seconds": float(times[-1]),
            "fit_seconds": float(times[self.recorded.train][-1]),
            "measurements": len(times),
            "physics_timestep": self.recorded.timestep,
            "verdict": self.verdict(),
            "remarks": list(self.remarks),
            "assumed": list(self.assumed),
            "estimates": [vars(estimate) for estimate in self.estimates],
            "errors": {
                part: {
                    when: {
                        name: dict(zip(self.recorded.robot.joint_names, map(_as_json, rms.tolist()), strict=True))
                        for name, rms in self.errors(after, part == "held_out").items()
                    }
                    for when, after in (("before", False), ("after", True))
                }
                for part in ("fit", "held_out")
            },
            "version": __version__,
        }

    def config(self) -> dict[str, Any]:
        """Return the motors as a part of the environment's `config`."""
        return {"motor": self.after.to_dict()}

    def tables(self) -> list[Table]:
        """Return the motors and errors before and after the fit, for a terminal and for a page."""
        rows = []
        for estimate in self.estimates:
            interval = "not determined: stays"
            if estimate.half_width is not None:
                low = max(0.0, estimate.after - estimate.half_width)
                interval = f"{low:.4g} to {estimate.after + estimate.half_width:.4g}"
            rows.append([estimate.name, f"{estimate.before:.4g}", f"{estimate.after:.4g}", interval, estimate.unit])
        condition = f" {self.condition()}" if self.assumed else ""
        motors = Table(
            "The motors",
            ["", "before", "after", "95 % interval", "unit"],
            rows,
            f"{_INTERVALS}{condition} Parameters that the recording does not "
            f"determine keep their start values: a motor's strength, for example, can be identified only where a motor "
            f"is at its limit.",
        )
        times = self.recorded.times
        errors = Table(
            "Before and after",
            ["RMS error", "held out, before", "after", "fit, before", "after"],
            [
                [f"{name} ({UNITS[name]})"]
                + [
                    f"{pooled(self.errors(after, held_out)[name]):.4f}"
                    for held_out in (True, False)
                    for after in (False, True)
                ]
                for name in self.recorded.signals
            ],
            f"Of {len(times)} measurements over {times[-1]:.1f} s, those up to {times[self.recorded.train][-1]:.1f} s "
            f"are used for the fit; the later ones are held out.",
        )
        return [motors, errors]

    def text(self) -> str:
        """Return the tables, the remarks and the verdict as plain text."""
        return "\n".join([*(f"{table.text()}\n" for table in self.tables()), *self.remarks, self.verdict()])


def identify(
    measured: JointTrajectory,
    commands: JointTrajectory,
    start: MotorConfig | None = None,
    fitted: Sequence[str] = FITTED,
    train_share: float = 0.7,
    timestep: float | None = None,
    without: Sequence[str] = (),
    progress: Progress | None = None,
    robot: Robot = MINI_QUADRUPED,
) -> Identification:
    """Estimate the motors of a robot on a stand, its feet in the air, from commands and measurements of one recording.

    Args:
        measured: positions, and velocities and efforts if they were recorded, of all joints but those that are left
            out. An effort is the motor's torque in the physics step before its timestamp, as this package records it.
        commands: joint targets on the same clock; each holds until the next.
        start: initial motors; None takes the robot's.
        fitted: parameters to fit, names in `QUANTITIES`.
        train_share: fraction of the time, from the beginning, used for the fit.
        timestep: physics time step, s; None takes the task's. Fitted motors are valid for this time step only, because
            a coarse step adds numerical damping.
        without: joints whose measurements are excluded. Where they are missing they are at rest, in the stance.
        progress: called with the approximate fraction done.
        robot: robot that was recorded.

    Raises:
        QuadrupedError: if the recordings do not overlap, the commands are constant, something in them would spoil the
            fit (the message says what repairs it), or an argument is out of range.
        MissingExtraError: if SciPy is not installed.
    """
    if importlib.util.find_spec("scipy") is None:
        raise MissingExtraError("Identification", "identify")
    if not 0.1 <= train_share <= 0.9:
        raise QuadrupedError(f"identify: the share for the fit must be from 0.1 to 0.9; found {train_share:g}")
    timestep = TaskConfig().physics_timestep if timestep is None else timestep
    if not 1e-4 <= timestep <= 0.01:
        raise QuadrupedError(f"identify: the time step must be from 0.0001 to 0.01 s; found {timestep:g}")
    before = start or robot.motors
    absent = [name for name in robot.joint_names if name not in measured.names]
    measured = whole(measured, robot, without, robot.stance)
    commands = whole(commands, robot, without, measured.positions[0])
    recorded = align(robot, measured, commands, train_share, timestep, without)
    fit = MotorFit(recorded, before, fitted, progress)
    check(recorded, measured, commands, without)
    check_stand(recorded, before)
    after = fit.run()
    notes = remarks(recorded, measured, commands)
    if absent:
        notes += (f"{', '.join(absent)}: not recorded, and simulated at rest in the stance.",)
    if any(errors.any() for errors in before.servo_errors(robot.joint_kinds)):
        notes += (f"The fit leaves out the motors' {', '.join(SERVO_ERRORS)}, which stay as they are.",)
    found = Identification(
        measured.source.name,
        commands.source.name,
        recorded,
        (),
        before,
        after,
        fit.predict(before),
        fit.predict(after),
        notes,
    )
    estimates = []
    for name in fit.names:
        values = quantity(name).unit, value_of(before, name), value_of(after, name)
        estimates.append(Estimated(name, *values, fit.half_width.get(name)))
    return replace(found, estimates=tuple(estimates))


def pooled(rms: Floats) -> float:
    """Return RMS over the joints of their RMS values (J,), without NaN."""
    return float(np.sqrt(np.nanmean(rms**2)))


def _as_json(value: float) -> float | None:
    return value if np.isfinite(value) else None
