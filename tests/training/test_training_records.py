"""Training's schedules, records and checkpoints against known answers.

The training is the real one with two parts replaced: a clock that each step of the env advances by a fixed time, and
an env that keeps what it gave and, before an update, makes the exploration grow without bound.
"""

import itertools
import json
import math
import types

import gymnasium
import numpy as np
import pytest
from stable_baselines3 import PPO
from trainings import progress, tensorboard

from quadruped_env.envs import ENV_ID, make_sb3_vec_env
from quadruped_env.policies import load_policy
from quadruped_env.training import TrainConfig, sb3_models, schedules, train, training_recorder
from quadruped_env.training.resume import Parent

ENVS, N_STEPS, ROLLOUTS = 8, 8, 12
SAMPLES = ENVS * N_STEPS
STEP_SECONDS = 0.0625
"""A rollout takes half a second, so that every other one ends with a row of progress.csv."""
ROWS_EVERY = 2
EPISODE_STEPS = 20
SEED = 3
LEARNING_RATE = 1e-3
UPDATE = PPO.train


def config(**changes):
    values = {
        "timesteps": ROLLOUTS * SAMPLES,
        "num_envs": ENVS,
        "n_steps": N_STEPS,
        "batch_size": 32,
        "n_epochs": 3,
        "hidden": (8,),
        "seed": SEED,
        "learning_rate": LEARNING_RATE,
        "checkpoint_seconds": 1.75,
        "log_std_init": -2.0,
        "final_log_std": -3.0,
        # Some fall, and others do not.
        "task": {"termination": {"max_tilt": 0.055}, "command": {"resample_interval": [100.0, 100.0]}},
    }
    return TrainConfig(**values | changes)


class Watched:
    """A training by `train.train` with a manual clock, and a record of its actions, rewards, falls and episodes."""

    def __init__(self, monkeypatch):
        self.clock = 1000.0
        self.actions, self.rewards, self.falls, self.dones, self.episodes = [], [], [], [], []
        self.exploration, self.learning_rates = [], []
        self.model, self.closed = None, 0
        for module in (schedules, training_recorder):
            monkeypatch.setattr(module, "time", types.SimpleNamespace(perf_counter=lambda: self.clock))
        monkeypatch.setattr(train, "make_sb3_vec_env", self._make_env)
        monkeypatch.setattr(train, "make_model", self._make_model(sb3_models.make_model))
        # On the class, because SB3 saves the attributes of an instance.
        monkeypatch.setattr(PPO, "train", self._update())

    def train(self, runs, config, parent=None):
        self.directory, self.finished = train.train(config, runs, "a test", parent)
        return self

    def _make_env(self, num_envs, **kwargs):
        env = make_sb3_vec_env(num_envs, max_episode_steps=EPISODE_STEPS, **kwargs)
        act, wait = env.step_async, env.step_wait

        def step_async(actions):
            self.actions.append(np.array(actions))
            self.exploration.append(float(self.model.policy.log_std.detach().max()))
            act(actions)

        def step_wait():
            self.clock += STEP_SECONDS
            results = wait()
            _, rewards, dones, infos = results
            self.rewards.append(rewards.astype(np.float64))
            self.dones.append(dones.copy())
            self.episodes.append([info.get("episode") for info in infos])
            self.falls.append(sum(not infos[i]["TimeLimit.truncated"] for i in np.flatnonzero(dones)))
            return results

        def close():
            self.closed += 1

        env.step_async, env.step_wait, env.close = step_async, step_wait, close
        return env

    def _make_model(self, make):
        def made(*arguments):
            self.model = make(*arguments)
            return self.model

        return made

    def _update(self):
        def train(model):
            UPDATE(model)
            self.learning_rates.append(model.policy.optimizer.param_groups[0]["lr"])
            model.policy.log_std.data.fill_(5.0)

        return train


@pytest.fixture
def watched(monkeypatch):
    return lambda: Watched(monkeypatch)


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A finished training."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        return Watched(monkeypatch).train(tmp_path_factory.mktemp("runs"), config())


def windows(values):
    """Values (steps, ...) grouped by the row of progress.csv that covers them."""
    size = ROWS_EVERY * N_STEPS
    return [np.array(values[start : start + size]) for start in range(0, len(values), size)]


def column(run, name):
    return [float(row[name]) for row in progress(run.directory)]


def test_envs_are_closed_once_at_the_end(run):
    assert run.finished
    assert run.closed == 1


# --- schedules ---


def explorations(run):
    """Log standard deviation of the actions in every rollout, which must not change within it."""
    by_rollout = np.reshape(run.exploration, (-1, N_STEPS))
    assert (by_rollout == by_rollout[:, :1]).all()
    return by_rollout[:, 0]


def test_exploration_is_clamped_to_a_bound_that_falls_linearly(run):
    left = 1.0 - np.arange(ROLLOUTS) / ROLLOUTS
    np.testing.assert_allclose(explorations(run), -3.0 + (-2.0 + 3.0) * left, atol=1e-6)


def test_exploration_begins_as_asked_and_is_never_widened(watched, tmp_path):
    narrow = watched().train(tmp_path, config(log_std_init=-1.0, timesteps=4 * SAMPLES))
    np.testing.assert_allclose(explorations(narrow), [-1.0, -1.5, -2.0, -2.5], atol=1e-6)
    flat = watched().train(tmp_path, config(log_std_init=-5.0, timesteps=2 * SAMPLES))
    np.testing.assert_allclose(explorations(flat), -5.0, atol=1e-6)


def test_learning_rate_follows_the_divergence_of_the_updates(watched, tmp_path):
    given, kl = [0.05, 0.03, 0.015, 0.019, 0.0051, 0.004, 0.001, 0.0, 0.0, 0.03, 0.01, 0.01], []
    # From the first update on: less by 1.5 over 0.02, more under 0.005, never over the schedule.
    expected = [1, 1 / 1.5, 1 / 1.5**2, 1 / 1.5**2, 1 / 1.5**2, 1 / 1.5**2, 1 / 1.5, 1, 1, 1, 1 / 1.5, 1 / 1.5]
    training = watched()
    update = PPO.train

    def with_divergence(model):
        update(model)
        kl.append(given[len(kl)])
        model.logger.record("train/approx_kl", kl[-1])

    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(PPO, "train", with_divergence)
        training.train(tmp_path, config(desired_kl=0.01))
    left = 1.0 - np.arange(1, ROLLOUTS + 1) / ROLLOUTS
    np.testing.assert_allclose(training.learning_rates, LEARNING_RATE * (0.1 + 0.9 * left) * expected, rtol=1e-6)


def test_learning_rate_falls_linearly_to_a_tenth(run):
    left = 1.0 - np.arange(1, ROLLOUTS + 1) / ROLLOUTS
    np.testing.assert_allclose(run.learning_rates, LEARNING_RATE * (0.1 + 0.9 * left), rtol=1e-9)
    assert run.learning_rates[-1] == pytest.approx(0.1 * LEARNING_RATE)


def test_schedules_follow_the_clock_with_a_budget_in_seconds(watched, tmp_path):
    seconds = 2.6
    run = watched().train(tmp_path, config(seconds=seconds))
    steps = math.ceil(seconds / STEP_SECONDS)
    assert len(run.rewards) == steps, "ends at the first step past the budget"
    whole = steps // N_STEPS
    ends = np.arange(1, whole + 1) * N_STEPS * STEP_SECONDS
    left = 1.0 - ends / seconds
    np.testing.assert_allclose(run.learning_rates, LEARNING_RATE * (0.1 + 0.9 * left), rtol=1e-6)
    bounds = -3.0 + np.concatenate([[1.0], left])
    np.testing.assert_allclose(run.exploration[::N_STEPS], bounds[: len(run.exploration[::N_STEPS])], atol=1e-6)
    assert run.finished


def test_options_reach_the_algorithm(watched, tmp_path):
    options = {"gamma": 0.9, "gae_lambda": 0.8, "clip_range": 0.3, "ent_coef": 0.01, "max_grad_norm": 0.7}
    model = watched().train(tmp_path, config(timesteps=SAMPLES, activation="relu", **options)).model
    assert model.clip_range(0.5) == options["clip_range"]
    for name in ("gamma", "gae_lambda", "ent_coef", "max_grad_norm"):
        assert getattr(model, name) == options[name], name
    assert (model.n_epochs, model.batch_size, model.n_steps, model.seed) == (3, 32, N_STEPS, SEED)
    assert model.policy.optimizer.state_dict()["state"][0]["step"] == 3 * SAMPLES / 32


# --- records ---


def test_progress_has_one_row_per_second_with_steps_and_seconds(run):
    rows = np.arange(1, ROLLOUTS // ROWS_EVERY + 1)
    np.testing.assert_array_equal(column(run, "timesteps"), rows * ROWS_EVERY * SAMPLES)
    np.testing.assert_allclose(column(run, "seconds"), rows * 1.0, atol=1e-3)


def test_progress_return_is_the_mean_reward_over_a_whole_episode(run):
    expected = [1000 * rewards.mean() for rewards in windows(run.rewards)]
    np.testing.assert_allclose(column(run, "return"), expected, rtol=1e-5)


def test_progress_fall_rate_counts_falls_and_not_the_time_limit(run):
    falls = np.array([falls.sum() for falls in windows(run.falls)])
    dones = np.array([dones.sum() for dones in windows(run.dones)])
    assert 0 < falls.sum() < dones.sum(), "both happen"
    robot_steps = ROWS_EVERY * SAMPLES
    np.testing.assert_allclose(column(run, "fall_rate"), falls * 1000 / robot_steps, rtol=1e-9)


def test_episodes_are_reported_with_their_length_and_return(run):
    rewards, dones = np.array(run.rewards), np.array(run.dones)
    lengths = set()
    for i in range(ENVS):
        ends = np.flatnonzero(dones[:, i]) + 1
        for start, end in itertools.pairwise([0, *ends]):
            episode = run.episodes[end - 1][i]
            assert episode["l"] == end - start
            assert episode["r"] == pytest.approx(rewards[start:end, i].sum(), rel=1e-5, abs=1e-6)
            lengths.add(end - start)
        assert sum(step[i] is not None for step in run.episodes) == len(ends)
    assert len(lengths) > 1


def replayed(run):
    """The same training in the native vector env: its `info` after every step, before a reset."""
    env = gymnasium.make_vec(
        ENV_ID, num_envs=ENVS, action_mode="residual", config=config().task, max_episode_steps=EPISODE_STEPS
    )
    _, info = env.reset(seed=SEED)
    env.unwrapped.task.shorten_episodes()  # as in a training
    command, infos = info["command"], []
    for actions in run.actions:
        _, _, terminated, truncated, info = env.step(actions)
        done = terminated | truncated
        last = {name: np.array(info[name]) for name in info if not name.startswith(("_", "final"))}
        for name in last if done.any() else ():
            last[name][done] = info["final_info"][name][done]
        if done.all():
            last = {name: np.array(value) for name, value in info["final_info"].items() if not name.startswith("_")}
        infos.append({**last, "done": done, "in_force": command})
        command = info["command"]
    return infos


def test_progress_has_the_mean_of_every_reward_term_per_second(run):
    infos = replayed(run)
    for name in (name for name in infos[0] if name.startswith("reward_")):
        expected = [values.mean() / 0.02 for values in windows([info[name] for info in infos])]
        np.testing.assert_allclose(column(run, name), expected, rtol=1e-4, atol=1e-6, err_msg=name)


def test_tensorboard_has_the_columns_of_progress(run):
    shown = tensorboard(run.directory)
    for name in progress(run.directory)[0].keys() - {"timesteps"}:
        group = "reward_per_second/" if name.startswith("reward_") else "progress/"
        steps, values = shown[group + name.removeprefix("reward_")]
        assert steps == column(run, "timesteps")
        np.testing.assert_allclose(values, column(run, name), rtol=1e-5, err_msg=name)


def test_tensorboard_has_the_levels_of_the_curriculum(watched, tmp_path):
    terrain = {"name": "tiles", "kinds": ["stairs", "rough"], "levels": 4, "curriculum": True}
    task = {"termination": {"max_tilt": 0.03}, "terrain": terrain}
    run = watched().train(tmp_path, config(timesteps=4 * SAMPLES, task=task))
    env = gymnasium.make_vec(
        ENV_ID, num_envs=ENVS, action_mode="residual", config=task, max_episode_steps=EPISODE_STEPS
    )
    env.reset(seed=SEED)
    env.unwrapped.task.shorten_episodes()  # as in a training
    levels, means = env.unwrapped.task.tiles, []
    for number, actions in enumerate(run.actions, 1):
        env.step(actions)
        if number % (ROWS_EVERY * N_STEPS) == 0:
            means.append([levels.level.mean(), levels.level[levels.kind == 0].mean()])
    shown = tensorboard(run.directory)
    assert {name for name in shown if name.startswith("terrain/")} == {
        "terrain/mean_level",
        "terrain/level_stairs",
        "terrain/level_rough",
    }
    assert len(means) == 2
    found = [shown[f"terrain/{name}"][1] for name in ("mean_level", "level_stairs")]
    np.testing.assert_allclose(np.transpose(found), means, rtol=1e-6)


def test_first_episodes_of_new_and_of_resumed_trainings_end_at_different_steps(watched, tmp_path):
    standing = {"termination": {"max_tilt": 3.1}}
    first = watched().train(tmp_path / "first", config(task=standing, timesteps=3 * SAMPLES))
    parent = Parent.load(first.directory)
    again = watched().train(tmp_path / "again", parent.resumed({}), parent)
    for run in (first, again):
        assert sum(run.falls) == 0
        ends = np.array(run.dones)[:EPISODE_STEPS]
        assert (ends.sum(axis=0) >= 1).all()
        assert len(np.unique(ends.argmax(axis=0))) > ENVS / 2


def test_progress_errors_are_those_of_the_averaged_velocities(watched, tmp_path):
    """Of the command that was in force, though commands change and episodes end all the time."""
    run = watched()
    task = {
        "termination": {"max_tilt": 0.03},
        "command": {"resample_interval": [0.04, 0.1]},
        "reward": {"velocity_time_constant": 0.3},
    }
    run.train(tmp_path, config(timesteps=2 * SAMPLES, task=task))
    env = gymnasium.make_vec(
        ENV_ID,
        num_envs=ENVS,
        action_mode="residual",
        config=task,
        autoreset_mode="Disabled",
        max_episode_steps=EPISODE_STEPS,
    )
    _, info = env.reset(seed=SEED)
    env.unwrapped.task.shorten_episodes()  # as in a training
    average, squares, ends = np.zeros((ENVS, 2)), [], 0
    for actions in run.actions:
        command = info["command"]  # in force in the step
        *_, terminated, truncated, info = env.step(actions)
        velocity = np.stack([info["base_linear_velocity"][:, 0], info["base_angular_velocity"][:, 2]], axis=1)
        average += (1.0 - math.exp(-0.02 / 0.3)) * (velocity - average)
        squares.append((average - command) ** 2)
        done = terminated | truncated
        if done.any():
            ends += done.sum()
            average[done] = 0.0
            _, fresh = env.reset(options={"reset_mask": done})
            info["command"] = np.where(done[:, None], fresh["command"], info["command"])
    assert ends > 3
    expected = np.sqrt(np.mean(squares, axis=(0, 1)))
    found = [column(run, name)[0] for name in ("forward_velocity_error", "yaw_rate_error")]
    np.testing.assert_allclose(found, expected, rtol=1e-6)


# --- checkpoints and the run's end ---


def test_checkpoints_are_saved_at_their_times_with_their_step_counts(run):
    # Ends of rollouts are at multiples of 0.5 s; each checkpoint is due 1.75 s after the one before.
    expected = {2.0: "00002s", 4.0: "00004s", 6.0: "00006s"}
    directories = sorted((run.directory / "checkpoints").iterdir())
    assert [path.name for path in directories] == list(expected.values())
    for (seconds, _), path in zip(expected.items(), directories, strict=True):
        card = load_policy(path).card
        steps = round(seconds / STEP_SECONDS) * ENVS
        assert (card["timesteps"], card["seconds"]) == (steps, seconds)
        assert card["budget_left"] == pytest.approx(1.0 - steps / (ROLLOUTS * SAMPLES))
        assert [float(row["timesteps"]) for row in progress(path)][-1] <= steps


def test_a_checkpoint_that_is_due_at_the_end_of_a_rollout_is_saved_then(watched, tmp_path):
    run = watched().train(tmp_path, config(checkpoint_seconds=3.0))
    assert sorted(path.name for path in (run.directory / "checkpoints").iterdir()) == ["00003s", "00006s"]


def test_card_of_a_finished_run_has_its_steps_seconds_and_no_budget_left(run):
    card = load_policy(run.directory).card
    assert (card["timesteps"], card["seconds"], card["budget_left"]) == (ROLLOUTS * SAMPLES, 6.0, 0.0)
    assert (card["seed"], card["command"]) == (SEED, "a test")
    assert run.finished
    assert json.loads((run.directory / "config.json").read_text())["training"]["learning_rate"] == LEARNING_RATE


def test_policy_that_is_saved_is_the_one_that_was_trained(run):
    width = run.model.observation_space.shape[0]
    seen = np.random.default_rng(0).uniform(-1.0, 1.0, (20, width)).astype(np.float32)
    expected, _ = run.model.predict(seen, deterministic=True)
    observation = seen[:, : run.model.policy.actor_width]  # without the privileged readings
    np.testing.assert_allclose(load_policy(run.directory).predict(observation), expected, atol=1e-5)


@pytest.mark.parametrize("budget", [{}, {"seconds": 6.0}])
def test_run_that_is_resumed_twice_uses_the_budget_of_the_first_once(watched, tmp_path, budget):
    """After 4, 8 and 12 of its 12 rollouts, which take half a second each."""
    first = watched().train(tmp_path / "first", config(**budget))
    second = resume(watched(), first, "00002s", tmp_path / "second")
    third = resume(watched(), second, "00004s", tmp_path / "third")
    assert [len(one.rewards) // N_STEPS for one in (first, second, third)] == [12, 8, 4]
    for one, begun in ((second, 4), (third, 8)):
        left = 1.0 - np.arange(begun, ROLLOUTS + 1) / ROLLOUTS
        rates = LEARNING_RATE * (0.1 + 0.9 * left[1:])
        np.testing.assert_allclose(one.learning_rates, rates[: len(one.learning_rates)], rtol=1e-6)
        np.testing.assert_allclose(explorations(one), -3.0 + left[:-1], atol=1e-6)
        facts = json.loads((one.directory / "config.json").read_text())["resumed_from"]
        assert (facts["timesteps"], facts["seconds"]) == (begun * SAMPLES, begun / 2.0)
        assert facts["budget_left"] == pytest.approx(left[0], abs=1e-6)
    card = load_policy(third.directory).card
    assert (card["timesteps"], card["seconds"], card["budget_left"]) == (ROLLOUTS * SAMPLES, 6.0, 0.0)
    rows = np.arange(1, ROLLOUTS // ROWS_EVERY + 1)
    np.testing.assert_array_equal(column(third, "timesteps"), rows * ROWS_EVERY * SAMPLES)
    np.testing.assert_allclose(column(third, "seconds"), rows, atol=1e-3)


def test_rest_of_a_training_that_continues_a_complete_one_is_resumed(run, watched, tmp_path, monkeypatch):
    """As much again, of which 4 of 12 rollouts are used; the schedules stay at their ends."""
    parent, shown = Parent.load(run.directory), []
    monkeypatch.setattr(training_recorder.ProgressLine, "__call__", lambda line, share, note: shown.append(share))
    again = watched().train(tmp_path / "again", parent.resumed({}), parent)
    steps = np.arange(1, ROLLOUTS * N_STEPS + 1) / (ROLLOUTS * N_STEPS)
    np.testing.assert_allclose(shown, np.minimum(steps, 0.99), err_msg="the share of its own budget")
    assert column(again, "timesteps")[-1] == 2 * ROLLOUTS * SAMPLES
    rest = resume(watched(), again, "00008s", tmp_path / "rest")
    assert len(rest.rewards) == (ROLLOUTS - 4) * N_STEPS
    np.testing.assert_allclose(rest.learning_rates, 0.1 * LEARNING_RATE)
    assert load_policy(rest.directory).card["timesteps"] == 2 * ROLLOUTS * SAMPLES


def resume(watched, run, checkpoint, runs):
    """Go on from a run's checkpoint with the rest of its budget."""
    parent = Parent.load(run.directory / "checkpoints" / checkpoint)
    return watched.train(runs, parent.resumed({}), parent)
