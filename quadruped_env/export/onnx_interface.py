"""Inputs and outputs of an exported policy: readings of a robot in SI units, as its sensors give them."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Final

import numpy as np

from quadruped_env.control import observations
from quadruped_env.control.control_config import Command
from quadruped_env.control.observations import Field, ObservationLayout
from quadruped_env.errors import QuadrupedError
from quadruped_env.gait import CommandedGait, joint_phases
from quadruped_env.policies.policy import Policy
from quadruped_env.utils.arrays import Floats

COMMAND: Final = "command"
GAIT_PHASE: Final = "gait_phase"
LAST_ACTION: Final = "last_action"
ACTION: Final = "action"
JOINT_TARGET: Final = "joint_target"
NEXT_GAIT_PHASE: Final = "next_gait_phase"
HISTORY: Final = "observation_history"
NEXT_HISTORY: Final = "next_observation_history"
OBSERVATION: Final = "observation"
REQUESTED: Final = "requested_command"
"""Fields of the golden trace that are neither input nor output of the graph."""
FEEDBACK: Final = {LAST_ACTION: ACTION, GAIT_PHASE: NEXT_GAIT_PHASE, HISTORY: NEXT_HISTORY}
"""Inputs that are outputs of the step before."""

_ABSOLUTE: Final = "Joint positions as in the URDF; the stance is subtracted in the graph."
_PHASE: Final = "Phase of the gait clock in [0, 2 pi): 0 at first, then next_gait_phase of the step before."
_HISTORY: Final = (
    "Scaled observations of the steps before, the latest first: NaN at first, then next_observation_history of the "
    "step before. Where it is NaN, the present observation stands for it."
)


@dataclass(frozen=True)
class Input:
    """One input of the graph, float32 (N, width)."""

    name: str
    width: int
    unit: str
    description: str


@dataclass(frozen=True, eq=False)
class PolicyInterface:
    """Inputs and outputs of a policy's graph, and the arithmetic between them.

    An input has the name, the unit and the columns of a field of the policy's observation, with two differences: joint
    positions are absolute, and the gait clock is given by its phase.

    Raises:
        QuadrupedError: if a field of a user's file has the name of an input with another meaning.
    """

    policy: Policy

    def __post_init__(self) -> None:
        reserved = {
            COMMAND: observations.command,
            LAST_ACTION: observations.last_action,
            GAIT_PHASE: None,
            HISTORY: None,
            OBSERVATION: None,
            REQUESTED: None,
        }
        for entry in self.policy.fields:
            if entry.name in reserved and entry is not reserved[entry.name]:
                raise QuadrupedError(
                    f"export: the observation {entry.name!r} of the task's file has the name of an input of every "
                    f"exported policy; rename it and train again"
                )

    @cached_property
    def layout(self) -> ObservationLayout:
        """Columns of the observation, which the graph computes."""
        return ObservationLayout(self.policy.robot, self.policy.fields, self.policy.control.observation_history)

    @property
    def history_width(self) -> int:
        """Columns of the observations of the steps before; 0 for a policy without a history."""
        return (self.layout.history - 1) * self.layout.width

    @cached_property
    def gait(self) -> CommandedGait | None:
        """The scripted gait to which the actions are added; None for a policy without one."""
        return self.policy.control.action.scripted_gait(self.policy.robot, self.policy.control.clock_frequency)

    @property
    def has_clock(self) -> bool:
        """True if the policy needs the gait clock: in its observation, or for the scripted gait."""
        return self.gait is not None or observations.gait_clock in self.policy.fields

    @cached_property
    def inputs(self) -> tuple[Input, ...]:
        """Inputs in the order of the observation, then those that only the clock and the gait need."""
        robot = self.policy.robot
        found = [
            Input(
                entry.name,
                entry.width(robot),
                entry.unit_of(robot),
                _ABSOLUTE if entry is observations.joint_position else entry.description,
            )
            if entry is not observations.command
            else self._command
            for entry in self.policy.fields
            if entry is not observations.gait_clock
        ]
        if self.has_clock:
            if observations.command not in self.policy.fields:
                found.append(self._command)
            found.append(Input(GAIT_PHASE, 1, "rad", _PHASE))
        if self.history_width:
            found.append(Input(HISTORY, self.history_width, "1", _HISTORY))
        return tuple(found)

    @property
    def velocities(self) -> tuple[Command, ...]:
        """Commanded velocities, in the order of the input `command`."""
        return self.policy.control.commands[: self.policy.control.num_velocities]

    @property
    def velocity_names(self) -> str:
        """Names of the commanded velocities as an enumeration."""
        *names, last = (entry.name.replace("_", " ") for entry in self.velocities)
        return f"{', '.join(names)} and {last}"

    @property
    def velocity_units(self) -> str:
        """Units of the commanded velocities."""
        return ", ".join(entry.unit for entry in self.velocities)

    @property
    def _command(self) -> Input:
        text = f"Commanded {self.velocity_names}, on their way to the requested ones at the rates of the manifest."
        return Input(COMMAND, len(self.velocities), self.velocity_units, text)

    @cached_property
    def outputs(self) -> tuple[Input, ...]:
        """Outputs; `next_gait_phase` only with a clock, and `next_observation_history` only with a history."""
        joints = self.policy.robot.num_joints
        found = [
            Input(ACTION, joints, "1", "Action in [-1, 1]: last_action of the next step."),
            Input(JOINT_TARGET, joints, "rad", "Joint targets within the joints' ranges."),
        ]
        if self.has_clock:
            found.append(Input(NEXT_GAIT_PHASE, 1, "rad", "Phase of the gait clock for the next step."))
        if self.history_width:
            found.append(Input(NEXT_HISTORY, self.history_width, "1", "Scaled observations for the next step."))
        return tuple(found)

    def offset(self, entry: Field) -> Floats:
        """Return what is subtracted from the input of a field before it is scaled, in its unit (width,)."""
        if entry is observations.joint_position:
            return self.policy.robot.stance
        return np.zeros(entry.width(self.policy.robot))

    @cached_property
    def offsets(self) -> Floats:
        """Offsets of all columns of the observation (width,), in the units of their fields."""
        return np.concatenate([self.offset(entry) for entry in self.policy.fields])

    @property
    def phase_step(self) -> float:
        """Advance of the gait clock per control step, rad."""
        return math.tau * self.policy.control.clock_frequency * self.policy.control.timestep

    @cached_property
    def joint_phases(self) -> Floats:
        """Phase of each joint's leg relative to the gait clock (J,), rad."""
        return joint_phases(self.policy.robot)
