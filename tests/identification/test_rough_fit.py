"""Least squares on an error with jumps: the search, the derivatives and the intervals of an identification."""

import numpy as np
import pytest

from quadruped_env.identification.rough_least_squares import derivatives, half_widths, search

TRUTH = np.array([1.2, 0.8])
LOW, HIGH = np.full(2, 0.02), np.full(2, 50.0)
TIMES = np.arange(300) * 0.01
JOINTS, KINDS = 8, 3
JOINT_KINDS = 2


def design(seed=0):
    """Derivatives (T, S, 2) of signals that are linear in two numbers, smooth over time."""
    rng = np.random.default_rng(seed)
    phases = rng.uniform(0.0, 6.0, (JOINTS * KINDS, 2))
    return np.sin(2.0 * np.pi * TIMES[:, None, None] * (0.7 + phases / 6.0) + phases)


def noise(rng, correlation):
    """Noise (T, S) of standard deviation 1, white or first-order autoregressive."""
    white = rng.normal(size=(len(TIMES), JOINTS * KINDS))
    result = white.copy()
    for row in range(1, len(TIMES)):
        result[row] = correlation * result[row - 1] + np.sqrt(1.0 - correlation**2) * white[row]
    return result


def with_jump(at, size):
    """Residuals that are linear but for a jump of some measurements where the first number passes a place."""
    matrix = design()

    def residuals(points):
        left = np.einsum("tsp,np->nts", matrix, points - TRUTH)
        left[:, 100:110, 0] += np.where(points[:, 0] > at, size, 0.0)[:, None]
        return left

    return residuals


class TestSearch:
    def test_search_behind_a_jump_finds_the_optimum(self):
        """Where the search begins, the jump makes the error smaller than it is on the way to the optimum."""
        rounds = []
        found = search(with_jump(at=1.25, size=-6.0), np.array([1.3, 0.85]), LOW, HIGH, lambda: rounds.append(1))
        np.testing.assert_allclose(found, TRUTH, atol=2e-3)
        assert rounds

    def test_search_stays_within_the_bounds(self):
        found = search(with_jump(at=9.0, size=0.0), np.array([1.4, 1.0]), np.array([1.3, 0.02]), HIGH, lambda: None)
        assert found[0] == pytest.approx(1.3, abs=1e-3)


class TestDerivatives:
    @pytest.mark.parametrize("at", [1.1995, 1.2005, 1.21])
    def test_derivatives_next_to_a_jump_are_those_of_the_smooth_part(self, at):
        jacobian, left = derivatives(with_jump(at, size=5.0), TRUTH, LOW, HIGH)
        np.testing.assert_allclose(jacobian, design(), atol=1e-9)
        assert np.count_nonzero(left) == (10 if at < TRUTH[0] else 0)

    def test_derivatives_on_a_bound_are_taken_from_one_side(self):
        jacobian, _ = derivatives(with_jump(at=9.0, size=0.0), TRUTH, TRUTH, HIGH)
        np.testing.assert_allclose(jacobian, design(), atol=1e-9)


class TestHalfWidths:
    @staticmethod
    def estimated(seed, correlation, scale=None):
        """Errors of the least-squares estimates, and the half-widths of their intervals."""
        rng = np.random.default_rng(seed)
        matrix = design()
        flat = matrix.reshape(-1, 2)
        disturbance = noise(rng, correlation)
        if scale is not None:
            disturbance *= scale
        step = np.linalg.lstsq(flat, -disturbance.ravel(), rcond=None)[0]
        left = disturbance + matrix @ step
        return np.abs(step), half_widths(matrix, left, TIMES, JOINTS, JOINT_KINDS)[1]

    @pytest.mark.parametrize("correlation", [0.0, 0.9])
    def test_half_widths_of_white_and_of_correlated_noise_hold(self, correlation):
        covered = []
        for seed in range(60):
            errors, widths = self.estimated(seed, correlation)
            covered += (errors <= widths).tolist()
        assert np.mean(covered) >= 0.92

    def test_half_widths_of_white_noise_are_not_much_wider_than_the_classical_ones(self):
        _, widths = self.estimated(0, 0.0)
        flat = design().reshape(-1, 2)
        classical = 1.96 * np.sqrt(np.diag(np.linalg.inv(flat.T @ flat)))
        assert (widths < 3.0 * classical).all()
        assert (widths > 0.9 * classical).all()

    def test_half_widths_do_not_count_signals_that_were_not_measured(self):
        matrix = design()
        left = noise(np.random.default_rng(1), 0.0)
        left[:, JOINTS:] = 0.0
        measured_only = half_widths(matrix[:, :JOINTS], left[:, :JOINTS], TIMES, JOINTS, JOINT_KINDS)
        matrix[:, JOINTS:] = 0.0
        np.testing.assert_allclose(half_widths(matrix, left, TIMES, JOINTS, JOINT_KINDS), measured_only)

    def test_half_widths_of_an_estimate_next_to_the_optimum_reach_to_it(self):
        matrix = design()
        left = noise(np.random.default_rng(1), 0.0) + matrix @ np.array([0.3, 0.0])
        white, widths = half_widths(matrix, left, TIMES, JOINTS, JOINT_KINDS)
        assert widths[0] > 0.25
        assert white[0] < 0.1

    def test_half_widths_of_an_undetermined_number_are_infinite(self):
        matrix = design()
        matrix[..., 1] = 0.0
        for widths in half_widths(matrix, noise(np.random.default_rng(0), 0.0), TIMES, JOINTS, JOINT_KINDS):
            assert np.isinf(widths[1])
        matrix[..., 1] = -2.0 * matrix[..., 0]
        assert np.isinf(half_widths(matrix, noise(np.random.default_rng(0), 0.0), TIMES, JOINTS, JOINT_KINDS)).all()
