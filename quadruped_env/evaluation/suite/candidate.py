"""Controller that the suite measures, and the task in which it measures it."""

import dataclasses
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from quadruped_env.envs.arguments import task_config
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import Command, evaluation_task
from quadruped_env.evaluation.rollout import BeforeStep, Rollout, roll_out
from quadruped_env.policies import Agent, Controller, Policy, PolicyController, ZeroController, as_policy
from quadruped_env.robot import Robot
from quadruped_env.simulation import Terrain, flat
from quadruped_env.task import BUILT_IN, TaskConfig
from quadruped_env.task.sections import values_for
from quadruped_env.utils.progress import Progress


@dataclass(frozen=True)
class Candidate:
    """A controller to measure, and the task that it was made for."""

    name: str
    controller: Controller
    config: TaskConfig

    @classmethod
    def of_policy(cls, policy: Policy | Agent, name: str) -> Self:
        """Make a candidate of a trained policy, or one that is code, in its own task."""
        policy = as_policy(policy, name)
        return cls(name, PolicyController(policy, name), policy.config)

    def task(
        self, commands: Iterable[Command], randomization: Mapping[str, Any] | None = None, terrain: Terrain = flat
    ) -> TaskConfig:
        """Return the task of the suite: physics, falls and randomization are the same for all controllers of a robot.

        The observation, the action, the control rate and the gait clock are the controller's own. Motors and
        terminations are the robot's and the built-in ones, whatever the controller's task has.

        Its ranges include the commands. `randomization` holds values of the config's section on top of the preset
        `none`; masses, forces and lengths are for the built-in robot, and are scaled to another one.

        Raises:
            QuadrupedError: if the controller's task replaces a built-in termination.
        """
        config = task_config(self.controller.action_mode, self.config)
        definition = dataclasses.replace(config.definition, terminations=BUILT_IN.terminations)
        config = dataclasses.replace(config.with_definition(definition), motor=config.robot.motors)
        defaults = TaskConfig().for_robot(config.robot).termination
        missing = sorted(set(defaults) - set(config.termination))
        if missing:
            raise QuadrupedError(
                f"{self.name}: its task file replaces the termination with the parameter {missing[0]!r}, and the suite "
                f"needs the built-in ones; give the file's termination another name"
            )
        config = dataclasses.replace(config, termination=config.termination.replace(**defaults))
        config = evaluation_task(config.on_terrain(terrain), list(commands), "none")
        values = values_for({"randomization": dict(randomization or {})}, config.robot)["randomization"]
        return dataclasses.replace(config, randomization=config.randomization.replace(**values))

    def run(
        self,
        commands: Iterable[Command],
        seeds: range,
        seconds: float,
        progress: Progress | None = None,
        randomization: Mapping[str, Any] | None = None,
        before_step: BeforeStep | None = None,
        reached: Iterable[Command] = (),
        terrain: Terrain = flat,
        tiles: NDArray[np.intp] | None = None,
        physics: bool = False,
    ) -> Rollout:
        """Run every command with every seed; `reached` are further commands that `before_step` sets.

        For the other arguments see `task` and `roll_out`.
        """
        commands = list(commands)
        config = self.task([*commands, *reached], randomization, terrain)
        return roll_out(
            self.controller, commands, seeds, seconds, config, progress, before_step, tiles=tiles, physics=physics
        )

    def zero_action(self) -> Self:
        """Return the zero action in the same task: a policy's gait alone, or its stance."""
        return type(self)(f"{self.name}, zero action", ZeroController(self.controller.action_mode), self.config)

    @property
    def robot(self) -> Robot:
        """Robot that is controlled."""
        return self.config.robot
