"""Gradients of small multilayer perceptrons, written out.

For networks as small as these, autograd's bookkeeping and many small operations take longer than the matrix products.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import Final, NamedTuple

import torch


class _Activation(NamedTuple):
    """An activation function, in place, and the product of a gradient with its derivative, in place.

    The derivative is a function of the output y. Both may overwrite the last argument.
    """

    apply: Callable[[torch.Tensor, torch.Tensor], torch.Tensor]
    pull_back: Callable[[torch.Tensor, torch.Tensor, torch.Tensor], torch.Tensor]


def _elu(x: torch.Tensor, scratch: torch.Tensor) -> torch.Tensor:
    # In less time than torch's own, which finds expm1; less than 1e-7 lies between them.
    return torch.maximum(x, torch.clamp(x, max=0.0, out=scratch).exp_().sub_(1.0), out=x)


def _elu_pull_back(gradient: torch.Tensor, y: torch.Tensor, scratch: torch.Tensor) -> torch.Tensor:
    return gradient.mul_(torch.clamp(y, max=0.0, out=scratch).add_(1.0))


_ACTIVATIONS: Final[dict[type[torch.nn.Module], _Activation]] = {
    torch.nn.ELU: _Activation(_elu, _elu_pull_back),
    torch.nn.ReLU: _Activation(lambda x, _: x.relu_(), lambda gradient, y, _: gradient.mul_(y > 0.0)),
    torch.nn.Tanh: _Activation(
        lambda x, _: x.tanh_(), lambda gradient, y, scratch: gradient.addcmul_(gradient, y.square(), value=-1.0)
    ),
}


class _Buffers(NamedTuple):
    """Arrays that exist once: to get new memory takes as long as to fill it."""

    hidden: list[torch.Tensor]
    """Activations of each hidden layer (N, width)."""
    gradients: list[torch.Tensor]
    """Gradients by them (N, width)."""
    scratch: list[torch.Tensor]
    """Of the same shapes."""


class Perceptron:
    """A multilayer perceptron of torch's modules; call its methods without autograd.

    Args:
        modules: linear layers, with one kind of activation function between them: ELU with a scale of 1, ReLU or Tanh.
    """

    def __init__(self, modules: Iterable[torch.nn.Module]) -> None:
        modules = list(modules)
        self._layers = [module for module in modules if isinstance(module, torch.nn.Linear)]
        (kind,) = {type(module) for module in modules} - {torch.nn.Linear}
        self._activation = _ACTIVATIONS[kind]
        self._buffers = _Buffers([], [], [])
        self._capacity = 0
        self._inputs = torch.empty(0)

    def __call__(self, inputs: torch.Tensor) -> torch.Tensor:
        """Outputs (N, out) of inputs (N, in), to which `backward` refers."""
        *hidden, last = self._layers
        self._inputs = inputs
        buffers = self._of_size(len(inputs))
        for layer, output, scratch in zip(hidden, buffers.hidden, buffers.scratch, strict=True):
            torch.addmm(layer.bias, inputs, layer.weight.t(), out=output)
            inputs = self._activation.apply(output, scratch)
        return torch.addmm(last.bias, inputs, last.weight.t())

    def backward(self, gradient: torch.Tensor) -> None:
        """Put the gradient of every parameter into its existing `grad`, for that of the last outputs (N, out)."""
        buffers = self._of_size(len(gradient))
        for index in range(len(self._layers) - 1, -1, -1):
            layer = self._layers[index]
            assert isinstance(layer.weight.grad, torch.Tensor)
            assert isinstance(layer.bias.grad, torch.Tensor)
            inputs = buffers.hidden[index - 1] if index else self._inputs
            torch.mm(gradient.t(), inputs, out=layer.weight.grad)
            torch.sum(gradient, 0, out=layer.bias.grad)
            if index:
                below = torch.mm(gradient, layer.weight, out=buffers.gradients[index - 1])
                gradient = self._activation.pull_back(below, inputs, buffers.scratch[index - 1])

    def _of_size(self, size: int) -> _Buffers:
        """The first rows of the arrays, which grow with the largest number of samples so far."""
        if size > self._capacity:
            self._capacity = size
            widths = [layer.out_features for layer in self._layers[:-1]]
            with torch.inference_mode(mode=False):  # of which the arrays would be a part for ever
                self._buffers = _Buffers(*([torch.empty(size, width) for width in widths] for _ in range(3)))
        return _Buffers(*([array[:size] for array in arrays] for arrays in self._buffers))


class Projection(NamedTuple):
    """Projection on values whose entries are, up to their sign, equal in pairs: half the sum with the mirror image."""

    order: torch.Tensor
    """Index of each entry's mirror image in the flat values, of the values' shape"""
    half: torch.Tensor
    """Half of the sign of the mirror image, of the values' shape"""

    def __call__(self, values: torch.Tensor) -> torch.Tensor:
        """Projected values, of the same shape."""
        return torch.take(values, self.order).mul_(self.half).add_(values, alpha=0.5)


Tied = tuple[torch.nn.Parameter, Projection]
"""A parameter whose mirror images are the same, and the projection that keeps them so"""


class FlatGradient:
    """One array that holds the gradients of several parameters.

    Args:
        parameters: the parameters.
        tied: those of them whose gradients are projected.
    """

    def __init__(self, parameters: Iterable[torch.nn.Parameter], tied: Sequence[Tied]) -> None:
        self._parameters = list(parameters)
        sizes = [parameter.numel() for parameter in self._parameters]
        self.values = torch.zeros(sum(sizes))
        """All gradients (P,)."""
        parts = zip(self._parameters, self.values.split(sizes), strict=True)
        self._parts = [part.view_as(parameter) for parameter, part in parts]
        # The projection of a free parameter does not change it: it is its own mirror image.
        whole = Projection(torch.arange(len(self.values)), torch.full_like(self.values, 0.5))
        projections = {id(parameter): projection for parameter, projection in tied}
        first = 0
        for parameter, order, half in zip(
            self._parameters, whole.order.split(sizes), whole.half.split(sizes), strict=True
        ):
            if id(parameter) in projections:
                order[:] = first + projections[id(parameter)].order.reshape(-1)
                half[:] = projections[id(parameter)].half.reshape(-1)
            first += parameter.numel()
        self._projection = whole if tied else None

    def attach(self) -> None:
        """Make the parts of the array the `grad` of the parameters."""
        for parameter, part in zip(self._parameters, self._parts, strict=True):
            parameter.grad = part

    def project(self) -> None:
        """Project the gradients of the tied parameters."""
        if self._projection is not None:
            self.values.copy_(self._projection(self.values))

    def limit(self, max_norm: float) -> None:
        """Scale the gradients so that their norm is `max_norm` or less, as `torch.nn.utils.clip_grad_norm_` does."""
        self.values.mul_((max_norm / (self.values.norm() + 1e-6)).clamp(max=1.0))
