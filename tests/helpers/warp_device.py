"""The device on which tests run MuJoCo Warp: the first GPU where there is one, otherwise Warp's CPU device."""

from importlib.util import find_spec


def _found() -> bool:
    if find_spec("torch") is None or find_spec("warp") is None:
        return False
    import torch

    return torch.cuda.is_available()


DEVICE = "cuda" if _found() else "cpu"
"""Warp's name of the device."""
TRAINING_DEVICE = "cuda" if DEVICE == "cuda" else "warp-cpu"
"""`--device` of a training on it."""
