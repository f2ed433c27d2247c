"""Activation functions of policies in NumPy, equal to PyTorch's with their default arguments to 1e-6."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Final

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float32]
Activation = Callable[[Array], Array]

_SELU_SCALE, _SELU_ALPHA = np.float32(1.0507009873554805), np.float32(1.6732632423543772)
_HALF, _ROOT_HALF = np.float32(0.5), np.float32(np.sqrt(0.5))
_ERF: Final = tuple(map(np.float32, (0.254829592, -0.284496736, 1.421413741, -1.453152027, 1.061405429)))
"""Coefficients of erf, Abramowitz and Stegun 7.1.26: 1.5e-7 off."""


def _sigmoid(x: Array) -> Array:
    small = np.exp(-np.abs(x))
    return (np.exp(np.minimum(x, 0.0)) / (1.0 + small)).astype(np.float32)


def _softplus(x: Array) -> Array:
    return np.maximum(x, 0.0) + np.log1p(np.exp(-np.abs(x)))


def _erf(x: Array) -> Array:
    t = 1.0 / (1.0 + np.float32(0.3275911) * np.abs(x))
    a1, a2, a3, a4, a5 = _ERF
    return np.sign(x) * (1.0 - ((((a5 * t + a4) * t + a3) * t + a2) * t + a1) * t * np.exp(-x * x))


ACTIVATIONS: Final[Mapping[str, Activation]] = MappingProxyType(
    {
        "tanh": np.tanh,
        "elu": lambda x: np.maximum(x, 0.0) + np.expm1(np.minimum(x, 0.0)),
        "relu": lambda x: np.maximum(x, 0.0),
        "leaky_relu": lambda x: np.where(x < 0.0, np.float32(0.01) * x, x),
        "silu": lambda x: x * _sigmoid(x),
        "gelu": lambda x: _HALF * x * (1.0 + _erf(_ROOT_HALF * x)),
        "softplus": _softplus,
        "selu": lambda x: _SELU_SCALE * (np.maximum(x, 0.0) + _SELU_ALPHA * np.expm1(np.minimum(x, 0.0))),
        "sigmoid": _sigmoid,
        "mish": lambda x: x * np.tanh(_softplus(x)),
    }
)
"""Activation functions between layers, by name."""
BY_CLASS: Final = MappingProxyType({name.replace("_", ""): name for name in ACTIVATIONS} | {"swish": "silu"})
"""Name by the lower case of torch's module or ONNX's operator."""
OUTPUTS: Final[Mapping[str, Activation]] = MappingProxyType(
    {"clip": lambda x: np.minimum(np.maximum(x, -1.0), 1.0), "tanh": np.tanh}
)
"""Functions that bring the last layer's values into [-1, 1], by name."""
