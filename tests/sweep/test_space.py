"""The fields of a sweep that vary: their text, their files, their draws and their errors."""

import math

import numpy as np
import pytest

from quadruped_env import QuadrupedError
from quadruped_env.sweep.search_space import Dimension, of_dict, parse_dimension, read_space
from quadruped_env.task import TaskConfig

TASK = TaskConfig().to_dict()
SLIP = "task.reward.weights.foot_slip"


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("learning_rate=1e-4..1e-2:log", Dimension("learning_rate", 1e-4, 1e-2, log=True)),
        ("n_epochs=2..8", Dimension("n_epochs", 2, 8)),
        ("hidden=64x64,128x128x32", Dimension("hidden", choices=((64, 64), (128, 128, 32)))),
        ("activation=elu,tanh", Dimension("activation", choices=("elu", "tanh"))),
        ("symmetric=true,false", Dimension("symmetric", choices=(True, False))),
        ("gamma=0.98,0.99", Dimension("gamma", choices=(0.98, 0.99))),
        (f"{SLIP}=-1..0", Dimension(SLIP, -1.0, 0.0)),
        (
            "task.command.yaw_rate=[-0.4,0.4],[-0.8,0.8]",
            Dimension("task.command.yaw_rate", choices=((-0.4, 0.4), (-0.8, 0.8))),
        ),
        (
            "task.randomization.friction=[0.6,1.0],[0.4,1.2],null",
            Dimension("task.randomization.friction", choices=((0.6, 1.0), (0.4, 1.2), None)),
        ),
    ],
)
def test_text_gives_the_dimension_which_survives_json(text, dimension):
    found = parse_dimension(text, TASK)
    assert found == dimension
    assert found.whole == (dimension.field == "n_epochs")
    assert of_dict(found.field, found.to_dict()) == found


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("learning_rat=1..2", r"--vary learning_rat: unknown field 'learning_rat'; similar fields: learning_rate"),
        ("task.reward.weights.foot_slpi=-1..0", r"unknown field .*similar fields: task\.reward\.weights\.foot_slip"),
        ("xyz=1..2", r"unknown field 'xyz'; fields of the training: recipe, .*begin with 'task\.'"),
        ("task.reward.weights=1..2", r"found a section; name one of its fields, such as task\.reward\.weights\.track"),
        (
            "learning_rate=1e-2..1e-4",
            r"lower to the higher end; found 0\.01\.\.0\.0001; swap the ends: 0\.0001\.\.0\.01",
        ),
        ("learning_rate=0..1:log", r"a logarithmic range needs ends above 0; found 0"),
        ("learning_rate=a..1", r"--vary learning_rate: low: expected a number; found 'a'"),
        ("n_epochs=1.5..3", r"--vary n_epochs: low: expected a whole number; found 1\.5"),
        ("symmetric=1,0", r"expected true or false; found 1"),
        ("hidden=64..128", r"found a range, but the field is not a number \(default: 128x128\); give choices"),
        ("gamma=0.9", r"expected two or more choices, or a range LOW\.\.HIGH; found 0\.9; set a single value"),
        ("gamma=0.9,0.9", r"the choice 0\.9 is found twice"),
        ("gamma=0.9..0.99:exp", r"expected ':log' or nothing after the range; found 'exp'"),
        ("gamma", r"--vary: expected FIELD=LOW\.\.HIGH.*found 'gamma'"),
        ("seed=0..8", r"--vary seed: this field cannot vary: the number of seeds is set with --seeds"),
        ("seconds=10..20", r"this field cannot vary: .*vary timesteps"),
    ],
)
def test_bad_text_is_an_error_with_the_fix(text, message):
    with pytest.raises(QuadrupedError, match=message):
        parse_dimension(text, TASK)


def test_draws_of_ranges_have_their_law():
    generator = np.random.default_rng(0)
    log = np.array([parse_dimension("learning_rate=1e-4..1e-2:log", TASK).draw(generator) for _ in range(4000)])
    assert log.min() >= 1e-4
    assert log.max() <= 1e-2
    # Half of the draws lie below the geometric mean of the ends: 4 standard deviations of 4000 draws.
    assert abs(np.mean(log < 1e-3) - 0.5) < 4 * math.sqrt(0.25 / 4000)
    whole = [parse_dimension("n_epochs=2..5", TASK).draw(generator) for _ in range(400)]
    assert set(whole) == {2, 3, 4, 5}
    assert all(isinstance(value, int) for value in whole)
    linear = np.array([parse_dimension(f"{SLIP}=-1..0", TASK).draw(generator) for _ in range(4000)])
    assert abs(linear.mean() + 0.5) < 4 * math.sqrt(1 / 12 / 4000)
    choices = [parse_dimension("hidden=8,16", TASK).draw(generator) for _ in range(100)]
    assert set(choices) == {(8,), (16,)}


TOML = """
learning_rate = { low = 1e-4, high = 1e-2, log = true }
hidden = { choices = [[64, 64], [128, 128]] }
"task.command.yaw_rate" = { choices = [[-0.4, 0.4], [-0.8, 0.8]] }

[task.reward.weights]
foot_slip = { low = -1.0, high = 0.0 }
"""


def test_file_gives_the_dimensions_of_its_tables(tmp_path):
    path = tmp_path / "space.toml"
    path.write_text(TOML)
    assert [str(dimension) for dimension in read_space(path, TASK)] == [
        "learning_rate=0.0001..0.01:log",
        "hidden=64x64,128x128",
        "task.command.yaw_rate=[-0.4, 0.4],[-0.8, 0.8]",
        f"{SLIP}=-1..0",
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("learning_rat = {low = 1.0, high = 2.0}", r"space\.toml: learning_rat: unknown field .*learning_rate"),
        ("gamma = {low = 0.99, high = 0.9}", r"space\.toml: gamma: expected a range.*swap the ends"),
        ("gamma = {choices = [0.9, 0.99], low = 0.9}", r"gamma: expected choices = \[\.\.\.\] alone"),
        ("", r"space\.toml: expected a table of fields"),
        ("gamma = [", r"space\.toml: not valid TOML"),
    ],
)
def test_bad_file_is_an_error_that_names_it(tmp_path, text, message):
    path = tmp_path / "space.toml"
    path.write_text(text)
    with pytest.raises(QuadrupedError, match=message):
        read_space(path, TASK)
