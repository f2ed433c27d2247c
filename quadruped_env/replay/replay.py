"""Replay of a recorded joint trajectory: kinematic, or dynamic through the robot's motors."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.recorded_episode import Recording, play
from quadruped_env.evaluation.trace import Trace
from quadruped_env.replay.signal_comparison import comparison_report, comparison_table, lag, saturation, side_by_side
from quadruped_env.report.films.film import FRAME_RATE, Clip
from quadruped_env.report.report_directory import REPORT_FILE
from quadruped_env.robot import MINI_QUADRUPED, MotorConfig, Robot
from quadruped_env.robot.skeleton import Pose
from quadruped_env.simulation import Terrain, build_model
from quadruped_env.simulation.height_field import HeightField
from quadruped_env.trajectory import JointTrajectory
from quadruped_env.trajectory.formats.project_csv import write_table
from quadruped_env.utils.arrays import Floats
from quadruped_env.utils.files import check_free, shown_argument, write_json
from quadruped_env.utils.progress import Progress
from quadruped_env.utils.text_table import Table

MODES: Final = ("kinematic", "dynamic")
LIMIT_TOLERANCE: Final = 0.01
"""Distance beyond a limit that still counts as at the limit, rad: mechanical stops yield and encoders are inexact."""

TOUCHING: Final = 1e-4
"""Height of a sole over the ground below which it touches it, m."""

MAX_CLIP: Final = 100.0
"""Distance beyond a limit above which a position is corrupt and is not clipped, rad."""

POSES_FILE: Final = "link_poses.csv"
JOINTS_FILE: Final = "joint_states.csv"
NUMBERS_FILE: Final = "tracking.json"

_POSE_COLUMNS: Final = ("x", "y", "z", "qw", "qx", "qy", "qz")


@dataclass(frozen=True)
class Replay:
    """A recording and its replay. Results are cached on first use; do not modify them."""

    robot: Robot
    mode: str
    """`kinematic` or `dynamic`"""
    recorded: JointTrajectory
    """Recording, in the order of the robot's joints"""
    played: JointTrajectory
    """Played joint states on the recording's clock: its own rows (kinematic), or measurements at 50 Hz (dynamic)"""
    motion: Recording | None
    """Motion of the robot in dynamic mode; None in kinematic mode, which has no physics"""
    clipped: NDArray[np.intp]
    """Number of recorded positions of each joint that were moved to a limit (J,)"""
    targets: JointTrajectory
    """Joint targets: the recording within the joint limits"""
    motors: MotorConfig
    measured: JointTrajectory | None = None
    """Recording of the real robot on the same clock, for the comparison; None compares with `recorded`"""

    def link_poses(self) -> dict[str, Pose]:
        """Return link name -> (position in m (T, 3), quaternion wxyz (T, 4)).

        In the world in dynamic mode, and in the frame of the base in kinematic mode.
        """
        base_pose = None if self.motion is None else self.motion.base_pose
        return self.robot.forward_kinematics(self.played.positions, base_pose)

    def tracking_error(self) -> Floats:
        """Return played minus recorded position at the same time, rad (T, J)."""
        return self.played.positions - self.recorded.positions_at(self.played.times)

    @cached_property
    def torques(self) -> tuple[Floats, Floats]:
        """Requested torques and their part beyond the motors' limits in dynamic mode, N m, each (T, J)."""
        return saturation(self.targets, self.played, self.motors, self.robot.joint_kinds)

    @cached_property
    def comparison(self) -> tuple[JointTrajectory, JointTrajectory]:
        """Recorded and simulated joint states at the same times.

        Raises:
            QuadrupedError: if `measured` has no time in common with the replay.
        """
        return side_by_side(self.measured or self.recorded, self.played)

    def film(self) -> Clip:
        """Return the clip for a film; in a kinematic replay the base is level and the lowest foot on the ground."""
        name = Path(self.recorded.source.name).name
        if self.motion is not None:
            return Clip(name, self.motion)
        times = np.arange(0.0, self.played.duration + 1e-9, 1.0 / FRAME_RATE)
        positions = self.played.positions_at(times)
        base_pose = np.tile([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], (len(times), 1))
        base_pose[:, 2] = -self.robot.sole_heights(positions, base_pose).min(axis=-1)
        trace = Trace(robot=self.robot, timestep=1.0 / FRAME_RATE, base_pose=base_pose, joint_position=positions)
        return Clip(f"{name}, kinematic", trace)

    @cached_property
    def report(self) -> dict[str, Any]:
        """The replay as JSON-serializable values; errors in rad, times in s."""
        error = self.tracking_error()
        late = [None] * self.robot.num_joints if self.motion is None else lag(self.targets, self.played)
        joints = {
            name: {
                **_summary(error[:, i]),
                "max_at": float(self.played.times[np.argmax(np.abs(error[:, i]))]),
                "lag": late[i],
            }
            for i, name in enumerate(self.robot.joint_names)
        }
        gaps = [{"start": gap.start, "seconds": gap.seconds} for gap in self.recorded.gaps()]
        return {
            "recording": shown_argument(self.recorded.source.name),
            "mode": self.mode,
            "rows": len(self.recorded),
            "seconds": self.recorded.duration,
            "gaps": gaps,
            "clipped": int(self.clipped.sum()),
            "motion": self._motion_report(),
            "tracking_error": {"unit": "rad", "all": _summary(error), "joints": joints},
            "limits": self._limits,
        }

    def _motion_report(self) -> dict[str, Any] | None:
        if self.motion is None:
            return None
        start = self.motion.base_pose[0]
        clearance = self.robot.sole_heights(self.played.positions[0], start)
        field = HeightField.of(build_model(terrain=self.motion.terrain, robot=self.robot))
        if field is not None:
            clearance -= field.at(self.robot.skeleton.foot_centres(self.played.positions[0], start))
        return {
            **self.motion.terrain.provenance(),
            "seconds": self.motion.joints.duration,
            "fell_at": self.motion.fell_at,
            "base_pose_start": start.tolist(),
            "base_pose_end": self.motion.base_pose[-1].tolist(),
            "feet_on_ground_at_start": int((clearance < TOUCHING).sum()),
        }

    @cached_property
    def _limits(self) -> dict[str, dict[str, Any]]:
        """Joint name -> positions clipped, speeds and torques against the limits, and saturation."""
        speeds = self.recorded.velocities
        if speeds is None and len(self.recorded) > 1:
            speeds = self.recorded.differentiate().velocities
        found: dict[str, dict[str, Any]] = {}
        for i, name in enumerate(self.robot.joint_names):
            found[name] = {
                "positions_clipped": int(self.clipped[i]),
                "fastest_recorded": None if speeds is None else float(np.abs(speeds[:, i]).max()),
                "speed_limit": float(self.robot.velocity_limit[i]),
            }
            if self.motion is None:
                continue
            assert self.played.efforts is not None
            assert self.played.velocities is not None
            asked, excess = (torques[:, i] for torques in self.torques)
            at_limit = np.flatnonzero(excess > 0.0)
            found[name] |= {
                "saturated": {
                    "share": len(at_limit) / len(excess),
                    "largest_torque_asked": float(np.abs(asked).max()),
                    "first_at": float(self.played.times[at_limit[0]]) if len(at_limit) else None,
                },
                "largest_torque": float(np.abs(self.played.efforts[:, i]).max()),
                "fastest": float(np.abs(self.played.velocities[:, i]).max()),
            }
        return found

    def tables(self, compare: bool = False) -> list[Table]:
        """Return the report's tables, for a terminal and for a page; `compare` adds the comparison's."""
        report, recorded, ranges = self.report, self.recorded, []
        for low, high in zip(recorded.positions.min(axis=0), recorded.positions.max(axis=0), strict=True):
            # Adding 0.0 turns a rounded -0.0 into 0.0.
            ranges.append(f"{low.round(3) + 0.0:+.3f} .. {high.round(3) + 0.0:+.3f}")
        everything = report["tracking_error"]["all"]
        tracking = Table(
            "Tracking errors",
            ["", "recorded (rad)", "RMS (rad)", "largest (rad)", "at (s)", "lag (ms)"],
            [
                [name, span, _shown(error["rms"], 4), _shown(error["max"], 4), _shown(error["max_at"]), lag]
                for span, (name, error) in zip(ranges, report["tracking_error"]["joints"].items(), strict=True)
                for lag in ["-" if error["lag"] is None else f"{1000 * error['lag']:.0f}"]
            ]
            + [["all", "", _shown(everything["rms"], 4), _shown(everything["max"], 4), "", ""]],
            "Played minus recorded position at the same time. The lag is the first time shift with about the smallest "
            "error; in a motion that repeats, it is known up to whole periods.",
        )
        limits = Table(
            "Limits",
            [
                "",
                "at motor limit (% of time)",
                "first at (s)",
                "torque requested (N m)",
                "torque applied",
                "speed recorded (rad/s)",
                "speed played",
                "positions clipped",
            ],
            [
                [
                    name,
                    _shown(100 * limits["saturated"]["share"], 1),
                    _shown(limits["saturated"]["first_at"]),
                    _shown(limits["saturated"]["largest_torque_asked"]),
                    *(_shown(limits[key]) for key in ("largest_torque", "fastest_recorded", "fastest")),
                    str(limits["positions_clipped"]),
                ]
                for name, limits in (report["limits"].items() if self.motion is not None else ())
            ],
            "A motor is at its limit where its controller requests more torque than it can apply at its speed.",
        )
        tables = [tracking] if self.motion is None else [tracking, limits]
        if not compare:
            return tables
        source = self.measured or self.recorded
        derived = "" if source.velocities is not None else " Its velocities were computed from its positions."
        return [
            *tables,
            comparison_table(comparison_report(*self.comparison), f"{Path(source.source.name).name}.{derived}"),
        ]

    def text(self, compare: bool = False) -> str:
        """Return the tables and remarks as plain text."""
        return "\n".join([*(f"{table.text()}\n" for table in self.tables(compare)), *self.remarks()])

    def remarks(self) -> list[str]:
        """Return remarks on the recording and the replay, in sentences."""
        remarks = list(self.recorded.source.notes)
        if self.clipped.any():
            names = ", ".join(name for name, count in zip(self.robot.joint_names, self.clipped, strict=True) if count)
            moved = np.abs(self.recorded.positions - self.targets.positions) > LIMIT_TOLERANCE
            first = self.recorded.times[moved.any(axis=1).argmax()]
            n = self.clipped.sum()
            remarks.append(f"{n} recorded positions were moved to a joint's limit, first at {first:.2f} s: {names}.")
        if gaps := self.recorded.gaps_in_words("the recording"):
            remarks.append(f"{gaps}; positions were interpolated linearly across them.")
        fast = [
            name
            for name, entry in self._limits.items()
            if entry["fastest_recorded"] is not None and entry["fastest_recorded"] > entry["speed_limit"]
        ]
        if fast and self.motion is not None:
            limits = " or ".join(f"{limit:g}" for limit in np.unique(self.robot.velocity_limit))
            remarks.append(f"Recorded faster than the motors' {limits} rad/s: {', '.join(fast)}.")
        if self.motion is not None:
            remarks.append(self.motion.outcome())
        return remarks

    def save(
        self, directory: Path, overwrite: bool = False, progress: Progress | None = None, compare: bool = False
    ) -> None:
        """Write the link poses, the report and, in dynamic mode, the measured joints into a directory.

        Args:
            directory: where to write.
            overwrite: True to replace existing files.
            progress: called with the fraction written.
            compare: True to include the comparison in the report.

        Raises:
            QuadrupedError: if a file exists and `overwrite` is false, or cannot be written.
        """
        check_free(replay_files(directory), overwrite)
        links = self.link_poses()
        titles = [f"{name}.{column}" for name in links for column in _POSE_COLUMNS]
        poses = [part for pose in links.values() for part in pose]
        write_table(directory / POSES_FILE, self.played.stamps, titles, poses, overwrite, progress)
        if self.mode == "dynamic":
            self.played.save(directory / JOINTS_FILE, overwrite, robot=self.robot)
        comparison = {"comparison": comparison_report(*self.comparison)} if compare else {}
        write_json(directory / NUMBERS_FILE, {**self.report, **comparison})


def replay(
    trajectory: JointTrajectory,
    mode: str = "dynamic",
    progress: Progress | None = None,
    motors: MotorConfig | None = None,
    measured: JointTrajectory | None = None,
    robot: Robot = MINI_QUADRUPED,
    terrain: str | Terrain | None = None,
) -> Replay:
    """Play a recording.

    Args:
        trajectory: all joints of the robot, in any order. Positions outside the joint limits are played at the limit.
        mode: `kinematic` sets the joints to the recorded positions, without forces and ground. `dynamic` interpolates
            the positions linearly at 50 Hz as motor targets, with gravity and ground; the robot starts at rest on its
            feet in the first position.
        progress: called with the fraction done, in dynamic mode.
        motors: motors to use instead of the robot's, in dynamic mode.
        measured: recording of the real robot on the same clock, for the comparison.
        robot: robot that plays it.
        terrain: a terrain, or the name of a built-in one, in dynamic mode; None is level ground.

    Raises:
        QuadrupedError: if a joint is missing, a position is so far outside its joint's limits that it is corrupt, the
            mode or the terrain is unknown, or a kinematic replay is given a terrain.
    """
    if mode not in MODES:
        raise QuadrupedError(f"replay: unknown mode {mode!r}; valid modes are {', '.join(MODES)}")
    recorded = trajectory.in_joint_order(robot)
    playable, clipped = _within_limits(robot, recorded)
    motors = motors or robot.motors
    measured = None if measured is None else measured.in_joint_order(robot)
    if mode == "kinematic":
        if terrain is not None:
            raise QuadrupedError("replay: kinematic mode has no ground; leave the terrain out, or use mode dynamic")
        return Replay(robot, mode, recorded, playable, None, clipped, playable, motors, measured)
    motion = play(playable, progress=progress, motors=motors, robot=robot, terrain=terrain)
    return Replay(robot, mode, recorded, motion.joints, motion, clipped, playable, motors, measured)


def replay_files(directory: Path) -> list[Path]:
    """Return files that a replay may write into a directory."""
    return [directory / name for name in (POSES_FILE, JOINTS_FILE, NUMBERS_FILE, REPORT_FILE)]


def _within_limits(robot: Robot, trajectory: JointTrajectory) -> tuple[JointTrajectory, NDArray[np.intp]]:
    """Return the trajectory clipped to the joint limits, and the number of clipped positions of each joint."""
    positions, low, high = trajectory.positions, robot.joint_position_low, robot.joint_position_high
    excess = np.maximum(low - positions, positions - high)
    beyond = excess > LIMIT_TOLERANCE
    if not beyond.any():
        return trajectory, beyond.sum(axis=0)
    corrupt = np.argwhere(excess > MAX_CLIP)
    if len(corrupt):
        row, column = corrupt[0]
        raise QuadrupedError(
            f"{trajectory.source.row(row)}, position.{robot.joint_names[column]}: {positions[row, column]:g} rad at "
            f"{trajectory.times[row]:g} s is far outside {low[column]:g} to {high[column]:g} rad; fix the value, or "
            f"leave the row out"
        )
    within = positions.clip(low, high)
    return JointTrajectory(trajectory.stamps, robot.joint_names, within, source=trajectory.source), beyond.sum(axis=0)


def _summary(error: Floats) -> dict[str, float]:
    return {"rms": float(np.sqrt(np.mean(error * error))), "max": float(np.max(np.abs(error)))}


def _shown(value: float | None, digits: int = 2) -> str:
    return "-" if value is None else f"{value:.{digits}f}"
