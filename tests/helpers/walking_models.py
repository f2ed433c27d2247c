"""Models of PPO that walk about as their gait, and what has changed in them."""

import torch
from settings import settings

from quadruped_env.envs import make_sb3_vec_env
from quadruped_env.training import TrainConfig
from quadruped_env.training.sb3_models import make_model

ENVS = 16


def walking(asymmetric_critic=False, num_envs=ENVS, symmetric=True, **randomization):
    """A model that walks about as its gait, in envs that have begun."""
    config = settings(randomization=randomization)
    env = make_sb3_vec_env(num_envs, seed=3, config=config, action_mode="residual", privileged=asymmetric_critic)
    training = {"num_envs": num_envs, "batch_size": 64, "hidden": (16, 16), "asymmetric_critic": asymmetric_critic}
    training["symmetric"] = symmetric
    model = make_model(TrainConfig(**training), env)
    env.reset()
    return model


def states(model):
    return [model.env.task.get_state(env_id) for env_id in range(model.env.num_envs)]


def parameters(model):
    return {name: value.clone() for name, value in model.policy.state_dict().items()}


def changed_parts(before, model):
    return {name.split(".")[0] for name, value in parameters(model).items() if not torch.equal(value, before[name])}
