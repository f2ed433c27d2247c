"""Networks with random weights."""

import torch


def perturb(model, scale=0.2):
    """Add noise to a model's parameters; a symmetric network stays symmetric."""
    with torch.no_grad():
        for parameter in model.policy.parameters():
            parameter.add_(scale * torch.randn_like(parameter))
    if hasattr(model.policy, "project"):
        model.policy.project()
