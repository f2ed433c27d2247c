import numpy as np
import pytest

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.gait import PRESETS


def test_article_preset_is_the_articles_formula():
    phases = [0.0, 0.5, 3.14, 3.64, 1.57, 2.07, 4.71, 5.21]
    gait = SinusoidalGait.preset("article")
    for t in (0.0, 0.05, 1.0, 123.45):
        expected = [
            0.4 * np.sin(2.0 * t + p) if i % 2 == 0 else 0.3 * np.cos(2.0 * t + p) - 0.3 for i, p in enumerate(phases)
        ]
        np.testing.assert_allclose(gait.positions(t), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", PRESETS)
def test_velocities_are_the_derivative_of_positions(name):
    gait = SinusoidalGait.preset(name)
    t = np.linspace(0, 3, 50)
    h = 1e-6
    numeric = (gait.positions(t + h) - gait.positions(t - h)) / (2 * h)
    np.testing.assert_allclose(gait.velocities(t), numeric, atol=1e-7)


def test_unknown_preset_names_the_valid_ones():
    with pytest.raises(QuadrupedError, match=r"'gallop'.*article, trot, walk, bound, pace, tuned"):
        SinusoidalGait.preset("gallop")
