"""Least squares with a rough error: a search that escapes local minima, and robust confidence intervals.

The error of a simulated recording is smooth except for jumps: in one physics step a motor at its limit brakes or does
not, and the joint then moves differently for a tenth of a second. A gradient does not show what is behind a jump, and a
finite difference across a jump looks like a steep slope. The search therefore draws candidates from the likely range of
the parameters, and derivatives are medians of differences over several neighbouring steps.
"""

from collections.abc import Callable
from typing import Any, Final

import numpy as np

from quadruped_env.utils.arrays import Floats

Residuals = Callable[[Floats], Floats]
"""Points (n, P) -> residuals (n, T, S) of T measurements of S signals."""

_STEPS: Final = (0.02, 0.005)
"""Steps of the finite differences in the search, used in turn, relative to the coordinate."""
_LEAST: Final = 0.5
"""Coordinate above which steps are relative; coordinates are near 1."""
_SHARES: Final = (1.0, 0.7, 0.5, 0.35, 0.25, 0.12, 0.06)
"""Fractions of a Gauss-Newton step that are tried."""
_DRAWS: Final = 4
"""Random candidates per round and parameter."""
_WIDEST: Final = 60.0
"""Maximum spread of candidates, in standard errors, which jumps make look smaller than they are."""
_AT_ONCE: Final = 16
_ROUNDS: Final = 24
_PATIENCE: Final = 3
"""Rounds without gain after which the search ends."""
_GAIN: Final = 1e-4
"""Minimum relative decrease of the error that counts as gain."""
_FINE_STEP: Final = 0.005
_FINE_STEPS: Final = 4
"""Steps to each side of the optimum; the derivative is the median of their differences."""
_BLOCKS: Final = (0.25, 1.0)
"""Lengths of the time blocks within which residuals may be correlated, s."""
_LEVEL: Final = 0.975


def search(residuals: Residuals, start: Floats, low: Floats, high: Floats, tell: Any) -> Floats:
    """Search for the best point (P,) from a start, within bounds; `tell` is called in every round."""
    rng = np.random.default_rng(0)
    point = start
    draws = _DRAWS * len(start)
    waited = 0
    for number in range(_ROUNDS):
        step = _STEPS[number % len(_STEPS)] * np.maximum(np.abs(point), _LEAST)
        up, down = np.minimum(point + step, high), np.maximum(point - step, low)
        ends = np.concatenate([point + np.diag(up - point), point + np.diag(down - point), point[None]])
        left = residuals(ends)
        count, signals = left.shape[1], int(left[-1].any(axis=0).sum())
        left = left.reshape(len(ends), -1)
        size = len(point)
        jacobian = ((left[:size] - left[size:-1]) / (up - down)[:, None]).T
        error = float(left[-1] @ left[-1])
        newton, spread = _newton(jacobian, left[-1])
        spread *= np.sqrt(error / max(count * signals, 1))
        factors = np.exp(rng.uniform(0.0, np.log(_WIDEST), (draws, 1)))
        drawn = rng.uniform(0.0, 1.0, (draws, 1)) * newton + factors * (rng.normal(size=(draws, size)) @ spread.T)
        candidates = point + np.concatenate([np.outer(_SHARES, newton), drawn])
        # Limited to half and double: a candidate along a poorly determined direction may be anywhere.
        candidates = np.clip(candidates, np.maximum(0.5 * point, low), np.minimum(2.0 * np.maximum(point, 0.1), high))
        # A few at a time, because the residuals of all candidates for a long recording take a gigabyte.
        parts = np.split(candidates, range(_AT_ONCE, len(candidates), _AT_ONCE))
        errors = np.concatenate([(residuals(part) ** 2).sum(axis=(1, 2)) for part in parts])
        best = int(errors.argmin())
        waited = 0 if errors[best] < (1.0 - _GAIN) * error else waited + 1
        if errors[best] < error:
            point = candidates[best]
        tell()
        if waited == _PATIENCE:
            break
    return point


def derivatives(residuals: Residuals, point: Floats, low: Floats, high: Floats) -> tuple[Floats, Floats]:
    """Return the derivatives (T, S, P) of the residuals at a point, robust against jumps, and the residuals (T, S)."""
    places = np.arange(-_FINE_STEPS, _FINE_STEPS + 1)
    columns = []
    step = _FINE_STEP * np.maximum(np.abs(point), _LEAST)
    for i in range(len(point)):
        points = np.tile(point, (len(places), 1))
        points[:, i] = np.clip(point[i] + places * step[i], low[i], high[i])
        left = residuals(points)
        if i == 0:
            here = left[_FINE_STEPS]
        differences = np.diff(points[:, i])
        moved = differences > 0.0
        columns.append(np.median(np.diff(left, axis=0)[moved] / differences[moved, None, None], axis=0))
    return np.stack(columns, axis=-1), here


def half_widths(jacobian: Floats, left: Floats, times: Floats, joints: int, kinds: int) -> tuple[Floats, Floats]:
    """Return half-widths (P,) of 95 % intervals under white noise, and of robust 95 % intervals.

    The first show which parameters the recording determines: they are infinite for a parameter without influence. Real
    residuals are not white noise: they are correlated over time, between the signals of a joint and between joints,
    and joints differ. The second are therefore the widest of several sandwich estimates, each of which assumes that
    residuals are independent between different groups of measurements (time blocks of each joint, time blocks, joints;
    https://doi.org/10.3368/jhr.50.2.317), plus the step to the optimum of a smooth error.

    Args:
        jacobian: derivatives of the residuals (T, S, P).
        left: residuals (T, S).
        times: times of the measurements, s (T,).
        joints: number of joints; signals are in the order of `SIGNALS`, then of the joints.
        kinds: number of kinds of joints, each with its own parameters.
    """
    from scipy.stats import t as student

    size = jacobian.shape[-1]
    known = np.abs(jacobian).sum(axis=(0, 2)) > 0.0
    flat, rest = jacobian[:, known].reshape(-1, size), left[:, known].ravel()
    scale = np.linalg.norm(flat, axis=0)
    if not scale.all():
        return (np.where(scale > 0.0, np.nan, np.inf),) * 2
    values, vectors = np.linalg.eigh((flat / scale).T @ (flat / scale))
    if values[0] < 1e-12 * values[-1]:
        return (np.where(np.abs(vectors[:, 0]) > 1e-6, np.inf, np.nan),) * 2
    inverse = vectors / values @ vectors.T / np.outer(scale, scale)
    degrees = max(len(rest) - size, 1)
    widths = [student.ppf(_LEVEL, degrees) * np.sqrt(np.diag(inverse) * (rest @ rest) / degrees)]
    # Scores of each measurement, (T, signals, joints, P), summed over the signals of a joint.
    scores = (jacobian * left[..., None]).reshape(len(left), -1, joints, size).sum(axis=1)
    for seconds in _BLOCKS:
        block = (times / seconds).astype(np.intp)
        sums = np.zeros((block.max() + 1, joints, size))
        np.add.at(sums, block, scores)
        widths.append(_clustered(inverse, sums.reshape(-1, size), joints * len(sums) - 1))
        if len(sums) > size:
            widths.append(_clustered(inverse, sums.sum(axis=1), len(sums) - 1))
    moving = int(np.count_nonzero(np.abs(scores).sum(axis=(0, 2))))
    # A parameter of one of two kinds affects half of the joints, of three a third.
    widths.append(_clustered(inverse, scores.sum(axis=0), max(moving // kinds - 1, 1)))
    newton = inverse @ (flat.T @ rest)
    return widths[0], np.max(widths, axis=0) + np.abs(newton)


def _clustered(inverse: Floats, sums: Floats, degrees: int) -> Floats:
    """Return half-widths from the sums of scores (G, P) over mutually independent groups."""
    from scipy.stats import t as student

    spread = sums @ inverse
    result: Floats = student.ppf(_LEVEL, degrees) * np.sqrt((spread**2).sum(axis=0))
    return result


def _newton(jacobian: Floats, left: Floats) -> tuple[Floats, Any]:
    """Return a Gauss-Newton step (P,), and a root (P, P) of the inverse of the squared Jacobian."""
    scale = np.maximum(np.linalg.norm(jacobian, axis=0), 1e-12)
    values, vectors = np.linalg.eigh((jacobian / scale).T @ (jacobian / scale))
    values = np.maximum(values, 1e-9 * values[-1])
    root = vectors / np.sqrt(values) / scale[:, None]
    return -root @ (root.T @ (jacobian.T @ left)), root
