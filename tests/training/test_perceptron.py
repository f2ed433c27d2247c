"""Gradients of perceptrons, written out, against autograd."""

import itertools

import numpy as np
import pytest
import torch

from quadruped_env.training.perceptron import FlatGradient, Perceptron, Projection

NN = torch.nn


def network(activation, widths=(5, 6, 4, 3)):
    torch.manual_seed(0)
    layers = [NN.Linear(*pair) for pair in itertools.pairwise(widths)]
    modules = [module for layer in layers[:-1] for module in (layer, activation())]
    return NN.Sequential(*modules, layers[-1])


def attached(sequential):
    """The perceptron of torch's modules, whose parameters have room for their gradients."""
    FlatGradient(sequential.parameters(), []).attach()
    return Perceptron(sequential)


@pytest.mark.parametrize("widths", [(5, 1, 3), (5, 6, 3), (5, 6, 4, 3)])
@pytest.mark.parametrize("activation", [NN.ELU, NN.ReLU, NN.Tanh])
def test_outputs_and_gradients_are_those_of_autograd(activation, widths):
    sequential = network(activation, widths)
    inputs, weights = 2.0 * torch.randn(9, 5), torch.randn(9, 3)
    outputs = sequential(inputs)
    (outputs * weights).sum().backward()
    expected = [parameter.grad.clone() for parameter in sequential.parameters()]
    perceptron = attached(sequential)
    with torch.no_grad():
        torch.testing.assert_close(perceptron(inputs), outputs, rtol=1e-5, atol=1e-6)
        perceptron.backward(weights)
    for parameter, gradient in zip(sequential.parameters(), expected, strict=True):
        torch.testing.assert_close(parameter.grad, gradient, rtol=1e-4, atol=1e-5)


def test_elu_of_any_number_is_torchs():
    perceptron = Perceptron([one := NN.Linear(1, 1), NN.ELU(), other := NN.Linear(1, 1)])
    for layer in (one, other):
        layer.weight.data.fill_(1.0)
        layer.bias.data.zero_()
    x = torch.tensor([[-1e30], [-100.0], [-1.0], [-1e-3], [-1e-12], [0.0], [1e-12], [0.7], [1e30]])
    with torch.no_grad():
        np.testing.assert_allclose(perceptron(x), NN.functional.elu(x), rtol=1e-6, atol=1e-7)


def test_batches_of_any_sizes_follow_each_other_in_and_out_of_inference_mode():
    sequential = network(NN.ELU)
    perceptron = attached(sequential)
    for size, mode in ((4, torch.inference_mode), (7, torch.inference_mode), (7, torch.no_grad), (2, torch.no_grad)):
        inputs = torch.randn(size, 5)
        with mode():
            first = perceptron(inputs)
            perceptron(inputs + 1.0)  # does not change what was returned
            torch.testing.assert_close(first, sequential(inputs))
    with torch.no_grad():
        perceptron(inputs)
        perceptron.backward(torch.ones(2, 3))
    torch.testing.assert_close(sequential[-1].bias.grad, torch.full((3,), 2.0))


def test_gradient_of_a_tied_parameter_is_half_the_sum_with_its_mirror_image():
    free, tied = NN.Parameter(torch.zeros(2)), NN.Parameter(torch.zeros(2, 2))
    projection = Projection(torch.tensor([[3, 2], [1, 0]]), torch.tensor([[0.5, -0.5], [-0.5, 0.5]]))
    gradient = FlatGradient([free, tied], [(tied, projection)])
    gradient.attach()
    free.grad[:] = torch.tensor([10.0, 20.0])
    tied.grad[:] = torch.tensor([[1.0, 2.0], [4.0, 7.0]])
    gradient.project()
    assert free.grad.tolist() == [10.0, 20.0]
    assert tied.grad.tolist() == [[4.0, -1.0], [1.0, 4.0]]
    torch.testing.assert_close(gradient.values, torch.tensor([10.0, 20.0, 4.0, -1.0, 1.0, 4.0]))


@pytest.mark.parametrize(("most", "expected"), [(1.0, [0.6, 0.8]), (10.0, [3.0, 4.0])])
def test_norm_of_the_gradient_is_limited(most, expected):
    parameter = NN.Parameter(torch.zeros(2))
    gradient = FlatGradient([parameter], [])
    gradient.attach()
    parameter.grad[:] = torch.tensor([3.0, 4.0])
    gradient.limit(most)
    assert parameter.grad.tolist() == pytest.approx(expected, rel=1e-6)
