"""A user's own algorithm and policy class: trained by the program, recorded, and executed only where they are named."""

import argparse
import json

import pytest
from trainings import SMALL, STEPS, assert_complete, learn

from quadruped_env import QuadrupedError
from quadruped_env.cli import train
from quadruped_env.training import TrainConfig
from quadruped_env.training.resume import Parent
from quadruped_env.training.run_directory import CONFIG_FILE

FILE = """
from stable_baselines3 import PPO, SAC
from stable_baselines3.common.on_policy_algorithm import OnPolicyAlgorithm
from stable_baselines3.ppo import MlpPolicy


class MyPPO(PPO):
    def train(self):
        super().train()
        self.logger.record("train/mine", 1.0)


class Narrow(PPO):
    def __init__(self, policy, env, n_steps=1, batch_size=1, learning_rate=1.0, **_):
        super().__init__(policy, env, n_steps=n_steps, batch_size=batch_size, learning_rate=learning_rate)


class MySAC(SAC):
    pass


class MyPolicy(MlpPolicy):
    pass


class Doubled(MlpPolicy):
    def _predict(self, observation, deterministic=False):
        return 2.0 * super()._predict(observation, deterministic) + 0.1


class Other:
    pass
"""


@pytest.fixture
def path(tmp_path):
    file = tmp_path / "mine.py"
    file.write_text(FILE)
    return file


def config(path, algo="MyPPO", policy="MyPolicy", **changes):
    chosen = {"algo": f"{path}:{algo}", "policy": f"{path}:{policy}" if policy else ""}
    changes = {"asymmetric_critic": False, **changes}
    return TrainConfig(timesteps=2 * STEPS, checkpoint_seconds=1e6, **SMALL | chosen | changes)


@pytest.mark.parametrize("policy", ["MyPolicy", ""])
def test_training_records_the_classes_and_is_resumed_with_their_files(path, tmp_path, policy):
    run = learn(tmp_path / "runs", config(path, policy=policy))
    made = assert_complete(run) if not policy else None
    document = json.loads((run / CONFIG_FILE).read_text())
    assert document["training"]["algo"] == "mine.py:MyPPO"
    assert document["training"]["policy"] == ("mine.py:MyPolicy" if policy else "")
    assert document["user_code"]["algo"]["name"] == "mine.py"
    assert str(path.parent) not in (run / CONFIG_FILE).read_text()
    assert made is None or made.card["algo"] == "mine.py:MyPPO"
    parent = Parent.load(run)
    with pytest.raises(QuadrupedError, match=r"--algo: \S+ was trained with 'mine.py:MyPPO', whose file is not"):
        parent.resumed({})
    named = {"algo": f"{path}:MyPPO", **({"policy": f"{path}:MyPolicy"} if policy else {}), "timesteps": STEPS}
    with pytest.raises(QuadrupedError, match=r"--algo: found 'mine.py:MySAC'; .* has 'mine.py:MyPPO'"):
        parent.resumed({**named, "algo": f"{path}:MySAC"})
    again = parent.resumed(named)
    assert parent.code_changes(again) == ""
    assert Parent.load(learn(tmp_path / "again", again, run)).timesteps == 3 * STEPS
    path.write_text(FILE + "\n# another version\n")
    assert parent.code_changes(again) == "the code of mine.py differs from the run's"


def test_program_takes_the_defaults_of_the_algorithm_that_a_class_is_derived_from(asked, path):
    own, plain = asked("--algo", f"{path}:MySAC"), asked("--algo", "sac")
    assert (own.name, own.buffer_size, own.num_envs) == ("mysac", plain.buffer_size, plain.num_envs)
    own, plain = asked("--recipe", "rough", "--algo", f"{path}:MyPPO"), asked("--recipe", "rough")
    assert (own.name, own.num_envs, own.batch_size) == ("myppo", plain.num_envs, plain.batch_size)
    with_policy = asked("--policy", f"{path}:MyPolicy")
    assert (with_policy.algo, with_policy.asymmetric_critic) == ("ppo", False)


def test_class_gets_the_settings_that_it_takes(path, tmp_path):
    assert learn(tmp_path / "runs", config(path, "Narrow")).is_dir()


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"algo": "Nothing"}, r"--algo: \S+mine.py defines no class 'Nothing'; write --algo FILE.py:CLASS"),
        ({"algo": "Other"}, r"--algo: Other is not derived from an algorithm of Stable-Baselines3 or sb3-contrib"),
        ({"policy": "MyPPO"}, r"--policy: MyPPO is not derived from a policy class of Stable-Baselines3"),
        ({"policy": "Doubled"}, r"Doubled computes its action in a way of its own.*two methods, reset and predict"),
        (
            {"asymmetric_critic": True},
            r"--asymmetric-critic: the actor of MyPolicy .*choose --no-asymmetric-critic",
        ),
    ],
)
def test_class_that_does_not_fit_is_refused_before_the_training(path, tmp_path, changes, message):
    with pytest.raises(QuadrupedError, match=message):
        learn(tmp_path / "runs", config(path, **changes))
    assert not (tmp_path / "runs").exists()


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"policy": "MlpPolicy"}, r"--policy: expected FILE.py:CLASS; found 'MlpPolicy'"),
    ],
)
def test_settings_that_exclude_each_other_execute_nothing(changes, message):
    with pytest.raises(QuadrupedError, match=message):
        TrainConfig(**changes)


def test_config_of_a_run_executes_nothing(path, tmp_path):
    run = learn(tmp_path / "runs", config(path, policy=""))
    path.write_text("raise SystemExit('executed')")
    assert Parent.load(run).config.algo == "mine.py:MyPPO"
    parser = argparse.ArgumentParser()
    train.add_arguments(parser)
    with pytest.raises(QuadrupedError, match="whose file is not executed automatically"):
        train.run(parser.parse_args(["--resume", str(run)]), argparse.Namespace(line="train"))
