"""The fit and what it is worth."""

import importlib.util
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env._version import __version__
from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.evaluation.identification.fit import MotorFit
from quadruped_env.evaluation.identification.quantities import FITTED, quantity, value_of
from quadruped_env.evaluation.identification.recorded import UNITS, Recorded, align, columns, remarks
from quadruped_env.evaluation.rollout import Progress
from quadruped_env.robot import JOINT_NAMES, MotorConfig
from quadruped_env.task import TaskConfig
from quadruped_env.trajectory import JointTrajectory

BASES: Final = ("fixed", "free")


@dataclass(frozen=True)
class Estimated:
    """One number of the motors, before and after."""

    name: str
    """`delay`, or kind of joint and field of `JointMotor`: `hip.kp`"""
    unit: str
    before: float
    after: float
    half_width: float | None
    """of the 95 % confidence interval; None for a number that the recording does not determine and that stayed"""


@dataclass(frozen=True)
class Identification:
    """What the fit found."""

    source: str
    commands: str
    base: str
    recorded: Recorded
    estimates: tuple[Estimated, ...]
    before: MotorConfig
    after: MotorConfig
    predicted_before: NDArray[np.float64]
    """What the simulator does with the motors before, (T, 24) at the times of the measurements"""
    predicted_after: NDArray[np.float64]
    remarks: tuple[str, ...]
    """What the reader should know about the recording"""

    def errors(self, after: bool, held_out: bool = True) -> dict[str, NDArray[np.float64]]:
        """Root mean square error (8,) of every measured signal, over the held-out time or the fit's.

        NaN for a joint whose signal was not measured.
        """
        predicted = self.predicted_after if after else self.predicted_before
        rows = ~self.recorded.train if held_out else self.recorded.train
        squared = (predicted - self.recorded.measured)[rows] ** 2
        count = np.isfinite(squared).sum(axis=0)
        rms = np.sqrt(np.nansum(squared, axis=0) / np.where(count, count, np.nan))
        return {name: rms[columns(name)] for name in self.recorded.signals}

    def verdict(self) -> str:
        """Whether the fit helped, in a sentence."""
        before, after = self._held_out()
        change = f"from {before:.4f} to {after:.4f} rad"
        if self.helps:
            return f"On held-out time the position error falls {change} ({100 * (1 - after / before):.0f} % less)."
        return f"On held-out time the position error does not fall: {change}. Do not use these motors."

    @property
    def helps(self) -> bool:
        """Whether the position error on held-out time is less than before."""
        before, after = self._held_out()
        return after < before

    def _held_out(self) -> tuple[float, float]:
        """Position error on held-out time before and after, rad."""
        return pooled(self.errors(after=False)["position"]), pooled(self.errors(after=True)["position"])

    def report(self) -> dict[str, Any]:
        """The identification in numbers, as JSON takes them."""
        times = self.recorded.times
        return {
            "recording": self.source,
            "commands": self.commands,
            "base": self.base,
            "seconds": float(times[-1]),
            "fit_seconds": float(times[self.recorded.train][-1]),
            "measurements": len(times),
            "physics_timestep": self.recorded.timestep,
            "verdict": self.verdict(),
            "remarks": list(self.remarks),
            "estimates": [vars(estimate) for estimate in self.estimates],
            "errors": {
                part: {
                    when: {name: _as_json(rms) for name, rms in self.errors(after, part == "held_out").items()}
                    for when, after in (("before", False), ("after", True))
                }
                for part in ("fit", "held_out")
            },
            "version": __version__,
        }

    def config(self) -> dict[str, Any]:
        """The motors as the environment's `config` takes them."""
        return {"motor": TaskConfig(motor=self.after).to_dict()["motor"]}

    def table(self) -> str:
        """The report for people."""
        lines = [f"{'':<20}{'before':>10}{'after':>10}  {'95 % interval':<22}unit"]
        for estimate in self.estimates:
            if estimate.half_width is None:
                interval = "not determined: stays"
            else:
                low = max(0.0, estimate.after - estimate.half_width)
                interval = f"{low:.4g} to {estimate.after + estimate.half_width:.4g}"
            lines.append(
                f"{estimate.name:<20}{estimate.before:>10.4g}{estimate.after:>10.4g}  {interval:<22}{estimate.unit}"
            )
        lines += ["", f"{'RMS error':<20}{'fit before':>12}{'after':>10}{'held out before':>18}{'after':>10}  unit"]
        for name in self.recorded.signals:
            fit, held_out = (
                [pooled(self.errors(after, part)[name]) for after in (False, True)] for part in (False, True)
            )
            lines.append(
                f"{name:<20}{fit[0]:>12.4f}{fit[1]:>10.4f}{held_out[0]:>18.4f}{held_out[1]:>10.4f}  {UNITS[name]}"
            )
        return "\n".join([*lines, "", *self.remarks, self.verdict()])


def identify(
    measured: JointTrajectory,
    commands: JointTrajectory,
    base: str = "fixed",
    start: MotorConfig | None = None,
    fitted: Sequence[str] = FITTED,
    train_share: float = 0.7,
    timestep: float | None = None,
    without: Sequence[str] = (),
    progress: Progress | None = None,
) -> Identification:
    """Estimate the motors from commands and measurements of one recording.

    Args:
        measured: positions, and velocities and efforts if they were recorded, of all eight joints. An effort is the
            motor's torque over the physics step before its stamp, as this package records it.
        commands: joint targets on the same clock; each holds until the next.
        base: `fixed` for a robot that hangs on a stand with its feet in the air; `free` for one that stands or walks
            on flat ground, beginning at rest.
        start: where the fit begins; None takes the model file's motors.
        fitted: names in `QUANTITIES`.
        train_share: share of the time, from the beginning, that is for the fit.
        timestep: s, of the physics; None takes the task's own. Motors that are fitted with another time step explain
            the robot with that one: a coarse step damps by itself.
        without: joints whose measurements do not count.
        progress: is told about how far the fit is.

    Raises:
        QuadrupedError: if the two do not overlap, nothing moves, or an argument makes no sense.
        MissingExtraError: if MuJoCo's toolbox is not installed.
    """
    if importlib.util.find_spec("tabulate") is None or importlib.util.find_spec("scipy") is None:
        raise MissingExtraError("Identification", "identify")
    if base not in BASES:
        raise QuadrupedError(f"identify: base must be one of {', '.join(BASES)}; found {base!r}")
    if not 0.1 <= train_share <= 0.9:
        raise QuadrupedError(f"identify: the share for the fit must be from 0.1 to 0.9; found {train_share:g}")
    timestep = TaskConfig().physics_timestep if timestep is None else timestep
    if not 1e-4 <= timestep <= 0.01:
        raise QuadrupedError(f"identify: the time step must be from 0.0001 to 0.01 s; found {timestep:g}")
    before = start or MotorConfig()
    measured, commands = measured.in_joint_order(), commands.in_joint_order()
    recorded = align(measured, commands, train_share, timestep, without)
    fit = MotorFit(recorded, base, before, fitted, progress)
    after = fit.run()
    estimates = tuple(
        Estimated(name, quantity(name).unit, value_of(before, name), value_of(after, name), fit.half_width.get(name))
        for name in fit.names
    )
    return Identification(
        measured.source.name,
        commands.source.name,
        base,
        recorded,
        estimates,
        before,
        after,
        fit.predict(before),
        fit.predict(after),
        remarks(recorded, measured, commands),
    )


def pooled(rms: NDArray[np.float64]) -> float:
    """One root mean square of those of the joints (8,), NaN aside."""
    return float(np.sqrt(np.nanmean(rms**2)))


def _as_json(rms: NDArray[np.float64]) -> dict[str, float | None]:
    return {name: float(value) if np.isfinite(value) else None for name, value in zip(JOINT_NAMES, rms, strict=True)}
