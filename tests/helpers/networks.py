"""Networks with random weights."""

import torch

from quadruped_env.control.symmetry import MirrorMap


def perturb(model, scale=0.2):
    """Add noise to a model's parameters; a symmetric network stays symmetric."""
    with torch.no_grad():
        for parameter in model.policy.parameters():
            parameter.add_(scale * torch.randn_like(parameter))
    if hasattr(model.policy, "project"):
        model.policy.project()


def assert_symmetric(model):
    """The mean action of mirrored observations is the mirrored mean action."""
    seen = torch.randn(20, model.policy.actor_width)
    mirror = MirrorMap.of(model.env.task.control.layout)
    mirrored = seen[:, torch.tensor(mirror.observation_order.copy())] * torch.tensor(mirror.observation_sign)
    with torch.inference_mode():
        actions, of_mirrored = (model.policy.get_distribution(inputs).mode() for inputs in (seen, mirrored))
    assert actions.abs().max() > 1e-3
    torch.testing.assert_close(of_mirrored, actions[:, torch.tensor(mirror.action_order.copy())])
