"""Study of time steps and solver settings: the speed of a setting, and its error relative to a finer one.

Each setting is compared with itself at a fifth of its time step and with a converged solver, on three measurements:
the standing height of the robot, the walking speed of scripted gaits, and the speed at which the robot hits the ground
after a drop. The simulation speed of all settings is measured in turns, so that other load on the machine affects all
of them.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Final, Self

import mujoco
import numpy as np
from numpy.typing import NDArray

from quadruped_env._version import __version__
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import SinusoidalGait
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import BatchSimulation, build_model
from quadruped_env.utils.files import write_json
from quadruped_env.utils.progress import Progress

CONTROL_TIMESTEP: Final = 0.02
"""Control time step, s: joint targets change at this interval, independent of the physics step."""
REFINEMENT: Final = 5
TOLERANCE: Final = 0.03
"""Maximum relative error of an accurate setting."""

TIMESTEPS: Final = (0.010, 0.005, 0.004, 0.0025, 0.002, 0.001)
"""Physics time steps, s."""
ROBOT: Final = MINI_QUADRUPED
ITERATIONS: Final = ((4, 8), (10, 20), (100, 50))
"""Newton iterations, and line search iterations in each."""
CONVERGED: Final = ITERATIONS[-1]
CONES: Final = ("pyramidal", "elliptic")
INTEGRATORS: Final = ("implicitfast", "Euler", "discrete")
GAITS: Final = ("tuned", "trot", "walk", "bound")
"""Presets whose speed is compared"""

_STANDING_SECONDS: Final = 3.0
_DROP_HEIGHT: Final = 0.10
"""Height of the soles over the ground before a drop, m."""
_RAMP_SECONDS: Final = 0.5
"""Time in which a gait's amplitude grows from 0 to its full value, s."""
_WARM_UP_SECONDS: Final = 2.0
"""Time before the speed of a gait is measured, s."""
_START_JITTER: Final = 0.05
"""Maximum deviation of each joint from the stance at the start, rad."""
_FALLEN: Final = 0.5
"""Cosine of the tilt beyond which a robot counts as fallen."""
_SPEED_ROWS: Final = 32
_SPEED_STEPS: Final = 10
_SPEED_ROUNDS: Final = 30


@dataclass(frozen=True)
class Setting:
    """A time step and solver settings."""

    timestep: float
    """Physics time step, s"""
    integrator: str
    cone: str
    iterations: int
    ls_iterations: int

    @classmethod
    def of_model_file(cls) -> Self:
        """The chosen setting, from the robot's model file."""
        option = build_model(robot=ROBOT).opt
        return cls(
            timestep=float(option.timestep),
            integrator=_name(INTEGRATORS, "mjINT", option.integrator, mujoco.mjtIntegrator),
            cone=_name(CONES, "mjCONE", option.cone, mujoco.mjtCone),
            iterations=int(option.iterations),
            ls_iterations=int(option.ls_iterations),
        )

    def model(self) -> mujoco.MjModel:
        """The robot on its ground with this setting."""
        model = build_model(self.timestep, robot=ROBOT)
        model.opt.integrator = _value("mjINT", self.integrator, mujoco.mjtIntegrator)
        model.opt.cone = _value("mjCONE", self.cone, mujoco.mjtCone)
        model.opt.iterations = self.iterations
        model.opt.ls_iterations = self.ls_iterations
        return model

    def reference(self) -> "Setting":
        """Finer setting that this setting is compared with."""
        iterations, ls_iterations = CONVERGED
        return replace(self, timestep=self.timestep / REFINEMENT, iterations=iterations, ls_iterations=ls_iterations)

    def __str__(self) -> str:
        return (
            f"{1e3 * self.timestep:g} ms, {self.integrator}, {self.cone} cone, "
            f"{self.iterations} / {self.ls_iterations} iterations"
        )

    @property
    def substeps(self) -> int:
        """Number of physics steps per control step."""
        return round(CONTROL_TIMESTEP / self.timestep)


def _value(prefix: str, name: str, kind: Any) -> int:
    return int(getattr(kind, f"{prefix}_{name.upper()}"))


def _name(names: Sequence[str], prefix: str, value: int, kind: Any) -> str:
    return next(name for name in names if _value(prefix, name, kind) == value)


def settings_to_compare() -> list[Setting]:
    """The chosen setting, and every setting that differs from it in one of: time step, iterations, cone, integrator."""
    chosen = Setting.of_model_file()
    found = [
        *(replace(chosen, timestep=timestep) for timestep in TIMESTEPS),
        *(replace(chosen, iterations=newton, ls_iterations=search) for newton, search in ITERATIONS),
        *(replace(chosen, cone=cone) for cone in CONES),
        *(replace(chosen, integrator=integrator) for integrator in INTEGRATORS),
        chosen,
    ]
    return list(dict.fromkeys(found))


def standing_height(setting: Setting) -> float:
    """Height of the base, m, after some seconds of standing in the stance."""
    simulation = _at_stance(setting, 1)
    for _ in range(round(_STANDING_SECONDS / CONTROL_TIMESTEP)):
        simulation.step(ROBOT.stance[None], setting.substeps)
    return float(simulation.readings.base_position[0, 2])


def impact_velocity(setting: Setting) -> float:
    """Downward speed of the base, m/s, at the moment when the feet of a robot that was dropped meet the ground.

    Between the physics steps before and after that moment, speed is taken to be linear in the feet's height: the
    speed at a step alone would depend on how that step happens to fall.
    """
    simulation = _at_stance(setting, 1, height=_DROP_HEIGHT)
    state = simulation.readings
    height, speed = _DROP_HEIGHT, 0.0
    while True:
        simulation.step(ROBOT.stance[None], 1)
        next_height = float(state.foot_position[0, :, 2].min()) - ROBOT.foot_radius
        next_speed = -float((state.linear_velocity_b[0] * state.up_b[0]).sum())
        if next_height <= 0.0:
            return speed + (next_speed - speed) * height / (height - next_height)
        height, speed = next_height, next_speed


def gait_speeds(
    setting: Setting, gait: SinusoidalGait, starts: int, seconds: float, seed: int, num_threads: int
) -> NDArray[np.float64]:
    """Mean forward speed of a gait, m/s, from several starts (starts,); NaN where the robot fell.

    The starts are spread over the gait's cycle and have random joint positions. The mean is over whole cycles.
    """
    rng = np.random.default_rng(seed)
    jitter = _START_JITTER * rng.uniform(-1.0, 1.0, (starts, ROBOT.num_joints))
    simulation = _at_stance(setting, starts, jitter=jitter, num_threads=num_threads)
    state = simulation.readings
    offset = gait.period * np.arange(starts) / starts
    begin = round(_WARM_UP_SECONDS / CONTROL_TIMESTEP)
    cycles = max(1, int((seconds - _WARM_UP_SECONDS) / gait.period))
    end = begin + round(cycles * gait.period / CONTROL_TIMESTEP)
    travelled, fallen = np.zeros(starts), np.zeros(starts, dtype=np.bool_)
    for step in range(end):
        t = step * CONTROL_TIMESTEP
        amplitude = min(1.0, t / _RAMP_SECONDS)
        simulation.step(ROBOT.stance + amplitude * (gait.positions(t + offset) - ROBOT.stance), setting.substeps)
        fallen |= (state.up_b[:, 2] < _FALLEN) | simulation.diverged()
        if step >= begin:
            travelled += state.linear_velocity_b[:, 0]
    return np.where(fallen, np.nan, travelled / (end - begin))


def _at_stance(
    setting: Setting, rows: int, height: float = 0.0, jitter: NDArray[np.float64] | float = 0.0, num_threads: int = 1
) -> BatchSimulation:
    """Robots at rest in the stance, a height in m above touching the ground."""
    simulation = BatchSimulation(setting.model(), rows, num_threads)
    qpos = np.zeros((rows, ROBOT.num_positions))
    qpos[:, 2], qpos[:, 3], qpos[:, 7:] = ROBOT.stance_height + height, 1.0, ROBOT.stance + jitter
    simulation.reset(np.arange(rows), qpos, np.zeros((rows, ROBOT.num_velocities)))
    return simulation


def measure_speeds(settings: Sequence[Setting], gait: SinusoidalGait, progress: Progress) -> list[float]:
    """Simulated seconds per second of each setting on one thread: the best of many rounds that take turns.

    The best, because whatever else the machine does can only slow a round down.
    """
    simulations = [_at_stance(setting, _SPEED_ROWS) for setting in settings]
    targets = [np.tile(gait.positions(step * CONTROL_TIMESTEP), (_SPEED_ROWS, 1)) for step in range(_SPEED_STEPS)]
    simulated = _SPEED_ROWS * _SPEED_STEPS * CONTROL_TIMESTEP
    rates: list[list[float]] = [[] for _ in settings]
    for turn in range(_SPEED_ROUNDS):
        for setting, simulation, rate in zip(settings, simulations, rates, strict=True):
            start = time.perf_counter()
            for target in targets:
                simulation.step(target, setting.substeps)
            rate.append(simulated / (time.perf_counter() - start))
        progress((turn + 1) / _SPEED_ROUNDS)
    return [max(rate) for rate in rates]


@dataclass(frozen=True)
class Reading:
    """A quantity at a setting and at its reference."""

    value: float
    reference: float
    standard_error: float
    """Of `error`, from the spread over starts; 0 where there is nothing random"""
    fallen: int
    """Starts that are left out because the robot fell, at the setting or at its reference"""

    @property
    def error(self) -> float:
        """Relative difference between value and reference."""
        return self.value / self.reference - 1.0


@dataclass(frozen=True)
class Outcome:
    """Speed and errors of a setting."""

    setting: Setting
    speed: float
    """Simulated seconds per second, one thread"""
    readings: dict[str, Reading]

    @property
    def accurate(self) -> bool:
        """True if every error is within the tolerance."""
        return all(abs(reading.error) <= TOLERANCE for reading in self.readings.values())


@dataclass(frozen=True)
class Study:
    """All settings, fastest first."""

    outcomes: list[Outcome]
    chosen: Setting
    gaits: Sequence[str]
    starts: int
    seconds: float
    seed: int

    def _chosen_outcome(self) -> Outcome:
        return next(outcome for outcome in self.outcomes if outcome.setting == self.chosen)

    def table(self) -> str:
        """Markdown table with one row per setting, the chosen one in bold."""
        names = list(self._chosen_outcome().readings)
        header = ["step (ms)", "integrator", "cone", "iterations", "speed", *names, f"all within {TOLERANCE:.0%}"]
        lines = [f"| {' | '.join(header)} |", "|" + "---|" * len(header)]
        unit = self._chosen_outcome().speed
        for outcome in self.outcomes:
            setting = outcome.setting
            cells = [
                f"{1e3 * setting.timestep:g}",
                setting.integrator,
                setting.cone,
                f"{setting.iterations} / {setting.ls_iterations}",
                f"{outcome.speed / unit:.2f}",
                *(_percent(outcome.readings[name]) for name in names),
                "yes" if outcome.accurate else "no",
            ]
            bold = "**" if setting == self.chosen else ""
            lines.append(f"| {' | '.join(f'{bold}{cell}{bold}' for cell in cells)} |")
        return "\n".join(lines)

    def verdict(self) -> str:
        """Verdict on the accuracy of the chosen setting, and the fastest accurate setting."""
        accurate = [outcome for outcome in self.outcomes if outcome.accurate]
        says = "is" if self._chosen_outcome().accurate else "is NOT"
        text = f"The chosen setting {says} within {TOLERANCE:.0%} of a {REFINEMENT} times finer step on every reading."
        if accurate:
            text += f" The fastest that is: {accurate[0].setting}."
        return text

    def report(self) -> dict[str, Any]:
        """The study as JSON-serializable values."""
        return {
            "chosen": asdict(self.chosen),
            "tolerance": TOLERANCE,
            "refinement": REFINEMENT,
            "gaits": list(self.gaits),
            "starts": self.starts,
            "seconds": self.seconds,
            "seed": self.seed,
            "outcomes": [
                asdict(outcome)
                | {
                    "relative_speed": outcome.speed / self._chosen_outcome().speed,
                    "errors": {name: reading.error for name, reading in outcome.readings.items()},
                    "accurate": outcome.accurate,
                }
                for outcome in self.outcomes
            ],
            "version": __version__,
            "mujoco": mujoco.__version__,
        }

    def save(self, path: Path) -> None:
        """Write the report.

        Raises:
            QuadrupedError: if it cannot be written.
        """
        write_json(path, self.report())


def _percent(reading: Reading) -> str:
    spread = f" ± {100 * reading.standard_error:.1f}" if reading.standard_error else ""
    fallen = f" ({reading.fallen} fell)" if reading.fallen else ""
    return f"{100 * reading.error:+.1f}{spread} %{fallen}"


def run_study(
    gaits: Sequence[str] = GAITS,
    starts: int = 24,
    seconds: float = 8.0,
    seed: int = 0,
    num_threads: int = 1,
    progress: Callable[[str], Progress] | None = None,
) -> Study:
    """Measure every setting.

    Args:
        gaits: names of presets that walk.
        starts: starts per gait; their spread gives the standard error of the speed.
        seconds: duration of each gait, warm-up included, s.
        seed: seed of the starts.
        num_threads: threads for the errors; speed is always measured on one thread. 0 uses every core.
        progress: called with the label of each part; returns the progress callback of that part.

    Raises:
        QuadrupedError: if a preset is unknown, a number is out of range, or a gait falls from every start.
    """
    if starts < 2:
        raise QuadrupedError(f"starts: expected 2 or more; found {starts}")
    if seconds <= _WARM_UP_SECONDS:
        raise QuadrupedError(f"seconds: expected more than the {_WARM_UP_SECONDS:g} s of warm-up; found {seconds:g}")
    presets = {name: SinusoidalGait.preset(name) for name in gaits}
    progress = progress or (lambda label: lambda share: None)
    settings = settings_to_compare()
    speeds = measure_speeds(settings, SinusoidalGait.preset("trot"), progress("speed"))

    # Settings that differ in their solver's iterations alone share a reference.
    runs = list(dict.fromkeys([*settings, *(setting.reference() for setting in settings)]))
    work = np.cumsum([setting.substeps for setting in runs])
    walked: dict[Setting, dict[str, NDArray[np.float64]]] = {}
    report = progress("errors")
    for setting, done in zip(runs, work, strict=True):
        walked[setting] = {
            name: gait_speeds(setting, gait, starts, seconds, seed, num_threads) for name, gait in presets.items()
        }
        report(float(done / work[-1]))

    outcomes = []
    for setting, speed in zip(settings, speeds, strict=True):
        reference = setting.reference()
        readings = {
            "standing height": Reading(standing_height(setting), standing_height(reference), 0.0, 0),
            **{f"{name} speed": _compare(walked[setting][name], walked[reference][name], name) for name in presets},
            "impact velocity": Reading(impact_velocity(setting), impact_velocity(reference), 0.0, 0),
        }
        outcomes.append(Outcome(setting, speed, readings))
    outcomes.sort(key=lambda outcome: -outcome.speed)
    return Study(outcomes, Setting.of_model_file(), tuple(gaits), starts, seconds, seed)


def _compare(values: NDArray[np.float64], references: NDArray[np.float64], gait: str) -> Reading:
    """Means over the starts that walked to the end at both settings."""
    walked = np.isfinite(values) & np.isfinite(references)
    if walked.sum() < 2:
        raise QuadrupedError(f"gait {gait!r}: the robot falls from nearly every start; choose a gait that walks")
    value, reference = values[walked], references[walked]
    spread = np.sqrt((value.var(ddof=1) + reference.var(ddof=1)) / walked.sum())
    mean = float(reference.mean())
    return Reading(float(value.mean()), mean, abs(float(spread) / mean), int((~walked).sum()))
