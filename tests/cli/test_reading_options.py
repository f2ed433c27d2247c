"""The flags of the command line are the fields of `ReadOptions`."""

import argparse
import dataclasses
import math

import pytest

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.cli.common_options import add_reading_options, reading_options
from quadruped_env.trajectory import JointRule, ReadOptions


def parsed(*arguments):
    parser = argparse.ArgumentParser()
    add_reading_options(parser)
    return reading_options(parser.parse_args([*map(str, arguments)]))


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["--topic", "/a"], {"topic": "/a"}),
        (["--names", "a,b"], {"names": ("a", "b")}),
        (["--unit", "deg"], {"unit": "deg"}),
        (["--stamps", "log"], {"stamps": "log"}),
        (["--ignore", "velocity,effort"], {"ignore": ["velocity", "effort"]}),
        (["--stamps", "0.02"], {"stamps": "0.02"}),
        (["--unwrap"], {"unwrap": 2 * math.pi}),
        (["--unwrap", "3"], {"unwrap": 3.0}),
        (["--repair", "sort,drop"], {"repair": ["sort", "drop"]}),
    ],
)
def test_arguments_with_a_flag_change_its_option(arguments, expected):
    assert ReadOptions(**parsed(*arguments)) == ReadOptions(**expected)


def test_arguments_with_maps_read_their_files(tmp_path):
    path = tmp_path / "maps.toml"
    path.write_text('[columns]\nstamp = "t"\npositions = ["a"]\n\n[joints.b]\nsource = "a"\n')
    options = ReadOptions(**parsed("--columns", path, "--map", path))
    assert (options.columns.stamp, options.columns.positions) == ("t", ["a"])
    assert options.joint_map.rules == {"b": JointRule("a")}
    assert {"columns", "joint_map"} < {field.name for field in dataclasses.fields(ReadOptions)}


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"unit": "turn"}, "unit: expected rad or deg; found 'turn'"),
        ({"repair": ["polish"]}, "repair: expected merge or sort or drop or despike or salvage; found 'polish'"),
        ({"stamps": "now"}, r"stamps: expected one of header, log, or the time .* s; found 'now'"),
        ({"unwrap": -1}, r"unwrap: expected an angle from 0\.01 to 1000 rad; found -1"),
        ({"ignore": ["position"]}, r"ignore: expected velocity or effort; found 'position'"),
    ],
)
def test_invalid_options_are_named(options, message):
    with pytest.raises(QuadrupedError, match=message):
        JointTrajectory.load("a.csv", **options)
