"""The task: observations, rewards and ends of episodes for any number of envs.

The single and the vector environment share this code. The values of an env do not depend on the number of envs: see the
rules in CONTRIBUTING.md before changing an expression here.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from gymnasium.utils import seeding
from numpy.typing import ArrayLike, NDArray

from quadruped_env.control.control_interface import ControlInterface, Controller
from quadruped_env.control.episode_memory import EpisodeMemory, State
from quadruped_env.control.velocity_command import check_command
from quadruped_env.errors import QuadrupedError
from quadruped_env.simulation import Simulation
from quadruped_env.task.command_sampling import CommandSampler
from quadruped_env.task.context import TaskContext
from quadruped_env.task.privileged import PrivilegedReadings, TrueState
from quadruped_env.task.randomization.draws import Draws, Purposes
from quadruped_env.task.randomization.randomizer import Randomizer
from quadruped_env.task.randomization.tile_assignment import TileAssignment
from quadruped_env.task.reward_function import RewardFunction, Terminations, check_fields
from quadruped_env.task.task_config import TaskConfig
from quadruped_env.task.terrain_section import TilesSection
from quadruped_env.utils.arrays import Bools, EnvIds, Floats
from quadruped_env.utils.plain import whole_number

_PURPOSES = Purposes({"episode/shortened": 1})


@dataclass(slots=True)
class Transition:
    """Results of one control step, before any reset."""

    observation: NDArray[np.float32]
    """Observations after the step, (N, width)."""
    reward: Floats
    """Sum of the weighted terms, added in their order, (N,)."""
    terms: Floats
    """Weighted reward terms in the order of `Task.term_names`, (N, T)."""
    terminated: Bools
    """True where the robot fell or the simulation diverged, (N,)."""
    truncated: Bools
    """True where the time limit was reached, (N,)."""
    diverged: Bools
    """True where MuJoCo reported divergence, (N,)."""


class Task:
    """The episodes of N envs, truncated after a number of control steps; None: never.

    Raises:
        QuadrupedError: if another robot is simulated than the task's, or a term of the task is not valid.
    """

    def __init__(self, simulation: Simulation, config: TaskConfig, max_episode_steps: int | None = None) -> None:
        if max_episode_steps is not None:
            max_episode_steps = whole_number("max_episode_steps", max_episode_steps, 1, or_none=True)
        definition = config.definition
        if simulation.robot != config.robot:
            raise QuadrupedError(f"task: it is for {config.robot!r}; found a simulation of {simulation.robot!r}")
        self.config = config
        self.simulation = simulation
        self.max_episode_steps = max_episode_steps
        n = self.num_envs = simulation.num_envs
        self.control = ControlInterface(config.robot, config.control, n, definition.observations)
        self.command = self.control.command
        """Commanded velocities (N, V); see `ControlInterface.command`; live."""
        self.context = TaskContext(
            simulation.readings,
            self.control,
            config.reward.velocity_time_constant,
            config.reward.contact_threshold,
            simulation.height_field,
            config.motor,
        )
        self.draws = Draws(n)
        self._rewards = RewardFunction(definition.paid, config.reward, self.context)
        self._terminations = Terminations(definition.terminations, config.termination, self.context)
        self._randomizer = Randomizer(
            simulation,
            self.control,
            self.draws,
            definition.randomizations,
            config.randomization,
            CommandSampler(config.commands, config.command),
            config.motor,
        )
        terrain = config.terrain
        self.tiles = TileAssignment(terrain, n) if isinstance(terrain, TilesSection) else None
        """Tile of each env, on the terrain `tiles`; else None."""
        self._noise = config.randomization.observation_noise > 0.0
        self._own_terms = definition.file is not None
        self.term_names = self._rewards.names
        self.reward_keys = tuple(f"reward_{name}" for name in self.term_names)

        self._memory = EpisodeMemory(n)
        self._fixed: Bools = self._memory.zeros("command_is_fixed", dtype=np.bool_)
        self._started: Bools = self._memory.zeros("started", dtype=np.bool_)
        self.finished: Bools = self._memory.zeros("finished", dtype=np.bool_)
        """Mask (N,) of the envs whose episode has ended and that have not been reset since."""
        self._shortened: NDArray[np.int64] = self._memory.zeros("shortened", dtype=np.int64)
        self._all_started = False
        self.generators: list[np.random.Generator] = []
        """Random generator of each env, from which the key of its draws is taken."""
        self.seeds: list[int] = []
        """Seed of each generator; -1 for a generator that the user assigned, as in Gymnasium."""
        for _ in range(n):
            generator, seed = seeding.np_random()
            self.generators.append(generator)
            self.seeds.append(seed)
        self._keyed: list[np.random.Generator | None] = [None] * n
        if self._own_terms:
            self._check_terms()

    def __reduce__(self) -> tuple[object, ...]:
        # Made again, because its arrays are views of each other, of which pickling would make copies. A single env has
        # the same generators.
        states = [self.get_state(env_id) for env_id in range(self.num_envs)]
        return _restored, (self.config, self.simulation, self.max_episode_steps, self.generators, states)

    def reset(
        self,
        env_ids: EnvIds,
        seeds: Sequence[int | None] | None = None,
        command: Sequence[float] | Floats | None = None,
        tiles: NDArray[np.intp] | None = None,
    ) -> None:
        """Begin new episodes in some envs (R,); the others do not change.

        Args:
            env_ids: indices of the envs.
            seeds: seeds of their generators (R,); None: the generator is kept, and its next episode begins.
            command: command that stays fixed for the episode, such as (forward velocity, yaw rate); None: random.
            tiles: index of the kind and level of the tile on which each episode starts (R, 2), on the terrain `tiles`;
                None: as drawn, or as the curriculum says.

        Raises:
            QuadrupedError: if the command is not valid for the task, or there are no such tiles; in that case no env
                has changed.
        """
        if command is not None:
            command = check_command(command, self.config.commands)
        if tiles is not None:
            if self.tiles is None:
                raise QuadrupedError(f"reset: tiles need the terrain 'tiles'; found {self.config.terrain.name!r}")
            self.tiles.check(tiles, len(env_ids))
        first = np.zeros(len(env_ids), dtype=np.bool_)
        for i, env_id in enumerate(env_ids.tolist()):
            if seeds is not None and seeds[i] is not None:
                self.generators[env_id], self.seeds[env_id] = seeding.np_random(seeds[i])
            if self._keyed[env_id] is not self.generators[env_id]:
                self.draws.set_key(env_id, self.generators[env_id])
                self._keyed[env_id] = self.generators[env_id]
                first[i] = True
        self.draws.begin_episode(env_ids)
        self._memory.clear(env_ids)
        place = None if self.tiles is None else self.tiles.begin_episodes(env_ids, first, self.draws, tiles)
        fixed = None if command is None else np.tile(command, (len(env_ids), 1))
        self._randomizer.begin_episodes(env_ids, place, fixed)
        self._started[env_ids] = True
        self._fixed[env_ids] = fixed is not None
        latency = self.simulation.field_values("actuator_delay")
        self.context.begin_episodes(env_ids, latency[env_ids] if len(latency) > 1 else latency)

    def place(self, env_ids: EnvIds, qpos: Floats, qvel: Floats) -> None:
        """Set the positions (R, 7 + J) and velocities (R, 6 + J) of some envs (R,), in MuJoCo's order."""
        self.simulation.reset(env_ids, qpos, qvel)
        self._randomizer.start_servos(env_ids)
        self.context.read()

    def shorten_episodes(self) -> None:
        """Let the present episode of every env end at a random step up to the time limit; later ones have their length.

        Envs that begin together, and do not fall, would otherwise reach every time limit in the same step.
        """
        share = self.draws.uniform(_PURPOSES, slice(None), self.control.steps)[:, 0]
        self._shortened[:] = np.floor(share * (self.max_episode_steps or 0)).astype(np.int64)

    def set_command(self, env_ids: EnvIds, command: Sequence[float] | Floats) -> None:
        """Change the command of some envs (R,) within their episodes; it stays fixed from then on.

        Raises:
            QuadrupedError: if the command is not valid for the task; in that case no env has changed.
        """
        checked_command = check_command(command, self.config.commands)
        self._fixed[env_ids] = True
        self.control.set_command(env_ids, np.tile(checked_command, (len(env_ids), 1)))

    def step(self, action: ArrayLike, restart: Bools | None = None) -> Transition:
        """Advance every env by one control step. No env is reset except those in `restart`.

        Args:
            action: actions (N, J), clipped to [-1, 1].
            restart: mask (N,) of envs that begin a new episode instead of this step. Their actions are ignored, their
                observations are the first of the new episode, and their rewards are zero. None: no env.

        Raises:
            QuadrupedError: if an env was never reset, the action's shape is wrong or a value is not finite; in that
                case no env has moved.
        """
        if not self._all_started:
            self._check_started()
        values = np.asarray(action, dtype=np.float64)
        if restart is not None and values.shape == self.control.action.shape:
            values = values.copy()
            values[restart] = 0.0
        self._check_values(values, "action")
        self.control.advance()
        return self._move(self.control.joint_target(values), restart)

    def act(self, controller: Controller, observation: NDArray[np.float32]) -> Transition:
        """Advance every env by one control step with a controller's joint targets for the observations (N, width).

        Raises:
            QuadrupedError: as `step`.
        """
        if not self._all_started:
            self._check_started()
        self.control.advance()
        target = np.array(controller.act(observation, self.control), dtype=np.float64)
        self._check_values(target, "joint target")
        return self._move(self.control.within_limits(target))

    def _move(self, target: Floats, restart: Bools | None = None) -> Transition:
        """Simulate one control step, compute its results, and prepare the next step."""
        running = None if restart is None else np.flatnonzero(~restart)
        self.simulation.step(self._randomizer.motor_target(target), self.config.decimation, running)
        self.context.update(self.simulation.substeps)
        diverged = self.simulation.diverged()
        terminated = self._terminations(self.context, diverged)
        self.context.fallen[:] = terminated
        limit = self.max_episode_steps
        truncated = np.zeros(self.num_envs, np.bool_)
        if limit is not None:
            truncated = self.control.steps + self._shortened >= limit
        if self.tiles is not None:
            self.tiles.update(self.context, terminated, diverged, running)
        terms = self._rewards(self.context)
        # One by one in the declared order. `reduce`, which is faster, would add the terms of a single env in pairs.
        reward = np.add.reduce(terms, axis=0) if self.num_envs > 1 else np.add.accumulate(terms, axis=0)[-1]
        if self._own_terms and not np.isfinite(reward).all():
            self._refuse_reward(terms)
        self._randomizer.resample_commands(self._fixed, running)
        self.control.approach_requested()
        self._randomizer.within_episodes(running)
        if restart is not None:
            self.reset(np.flatnonzero(restart))
            terms[:, restart] = 0.0
            reward[restart] = 0.0
            for flags in (terminated, truncated, diverged):
                flags[restart] = False
        np.logical_or(terminated, truncated, out=self.finished)
        return Transition(self.observe(), reward, terms.T, terminated, truncated, diverged)

    def privileged_readings(self) -> PrivilegedReadings:
        """Return the privileged readings of the task's definition, which no observation has.

        Raises:
            QuadrupedError: if one of them is not valid.
        """
        state = TrueState(self.context, self.simulation, self._randomizer.sensors)
        return PrivilegedReadings(self.config.definition.privileged, state)

    def observe(self) -> NDArray[np.float32]:
        """Return the observations (N, width) of all envs in a new array."""
        noise = self._randomizer.observation_noise() if self._noise else None
        sensors = self._randomizer.sensors
        readings = self.simulation.readings if sensors is None else sensors.read(self.control.steps)
        return self.control.observe(readings, noise)

    def get_state(self, env_id: int) -> State:
        """Return the complete state of an env: physics, episode, draws and random generator."""
        return {
            "simulation": self.simulation.get_state(env_id),
            "generator": self.generators[env_id].bit_generator.state,
            "seed": self.seeds[env_id],
            "keyed": self._keyed[env_id] is self.generators[env_id],
            **{name: part.get_state(env_id) for name, part in self._parts().items()},
        }

    def set_state(self, env_id: int, state: State) -> None:
        """Restore a state from `get_state`; the env then continues identically."""
        for name, part in self._parts().items():
            part.set_state(env_id, state[name])
        self.generators[env_id].bit_generator.state = state["generator"]
        self.seeds[env_id] = state["seed"]
        self._keyed[env_id] = self.generators[env_id] if state["keyed"] else None
        self.simulation.set_state(env_id, state["simulation"])
        self.context.read()

    def _parts(self) -> dict[str, EpisodeMemory]:
        sensors, servos = self._randomizer.sensors, self._randomizer.servos
        return {
            **({} if self.tiles is None else {"tiles": self.tiles.memory}),
            **({} if sensors is None else {"sensors": sensors.memory}),
            **({} if servos is None else {"servos": servos.memory}),
            "episode": self._memory,
            "control": self.control.memory,
            "terms": self.context.memory,
            "randomizer": self._randomizer.memory,
            "draws": self.draws.memory,
        }

    def _check_started(self) -> None:
        if not self._started.all():
            raise QuadrupedError(
                f"step: call reset() first; env {np.argmin(self._started)} of {self.num_envs} has no episode yet"
            )
        self._all_started = True

    def _check_values(self, values: Floats, what: str) -> None:
        if values.shape != self.control.action.shape:
            raise QuadrupedError(
                f"{what}: expected shape {self.control.action.shape}, one value per joint; found {values.shape}"
            )
        if np.count_nonzero(np.isfinite(values)) < values.size:
            env_id, column = np.argwhere(~np.isfinite(values))[0]
            raise QuadrupedError(
                f"{what}: value {values[env_id, column]} for {self.control.robot.joint_names[column]} in env {env_id} "
                f"is not finite"
            )

    def _check_terms(self) -> None:
        """Compute a user's terms once, so that errors are raised before training starts."""
        self.control.phase[:] = 0.0
        self._rewards.check(self.context)
        self._terminations.check(self.context)
        check_fields("observation", self.control.layout, self.num_envs, self.simulation.readings, self.control)
        self.context.memory.clear(np.arange(self.num_envs))

    def _refuse_reward(self, terms: Floats) -> None:
        term, env_id = np.argwhere(~np.isfinite(terms))[0]
        raise QuadrupedError(
            f"reward {self.term_names[term]}: {terms[term, env_id]} in env {env_id}, step "
            f"{self.control.steps[env_id]}; return finite numbers"
        )


def _restored(
    config: TaskConfig,
    simulation: Simulation,
    max_episode_steps: int | None,
    generators: list[np.random.Generator],
    states: list[State],
) -> Task:
    """Return a task from what was pickled."""
    task = Task(simulation, config, max_episode_steps)
    task.generators = generators
    for env_id, state in enumerate(states):
        task.set_state(env_id, state)
    return task
