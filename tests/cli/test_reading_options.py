"""One table of reading options: Python's keywords and the flags of the command line are those of `ReadOptions`."""

import argparse
import dataclasses
import inspect
import math

import pytest

from quadruped_env import JointTrajectory, QuadrupedError
from quadruped_env.cli.common_options import add_reading_options, reading_options
from quadruped_env.trajectory import JointRule
from quadruped_env.trajectory.read_options import FLAGS, ReadOptions

FIELDS = {field.name: field for field in dataclasses.fields(ReadOptions)}
GIVEN = {
    "topic": "/a",
    "columns": "columns.toml",
    "joint_map": "joints.toml",
    "names": ["a", "b"],
    "degrees": True,
    "stamps": "log",
    "ignore": ["effort"],
    "unwrap": 3.0,
    "despike": True,
    "merge": True,
    "sort": True,
    "drop": True,
    "salvage": True,
}
"""A value other than the default for every option."""


def parsed(*arguments):
    parser = argparse.ArgumentParser()
    add_reading_options(parser)
    return reading_options(parser.parse_args([*map(str, arguments)]))


def test_load_has_the_keywords_and_defaults_of_the_table():
    parameters = inspect.signature(JointTrajectory.load).parameters.values()
    keywords = {one.name: one.default for one in parameters if one.kind is inspect.Parameter.KEYWORD_ONLY}
    assert keywords.pop("progress") is None
    assert keywords == {name: field.default for name, field in FIELDS.items()}
    assert list(dict.fromkeys(arguments["dest"] for arguments in FLAGS.values())) == list(FIELDS)


def test_load_passes_every_option_on(monkeypatch):
    passed = {}

    def of(**given):
        passed.update(given)
        raise QuadrupedError("enough")

    monkeypatch.setattr(ReadOptions, "of", of)
    assert set(GIVEN) == set(FIELDS)
    with pytest.raises(QuadrupedError, match="enough"):
        JointTrajectory.load("a.csv", **GIVEN)
    assert passed == GIVEN


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["--topic", "/a"], {"topic": "/a"}),
        (["--names", "a,b"], {"names": ("a", "b")}),
        (["--degrees"], {"degrees": True}),
        (["--radians"], {"degrees": False}),
        (["--stamps", "log"], {"stamps": "log"}),
        (["--ignore", "velocity", "--ignore", "effort"], {"ignore": ("velocity", "effort")}),
        (["--stamps", "0.02"], {"stamps": "0.02"}),
        (["--unwrap"], {"unwrap": 2 * math.pi}),
        (["--unwrap", "3"], {"unwrap": 3.0}),
        (["--despike"], {"despike": True}),
        (["--merge"], {"merge": True}),
        (["--sort"], {"sort": True}),
        (["--drop"], {"drop": True}),
        (["--salvage"], {"salvage": True}),
    ],
)
def test_arguments_with_a_flag_change_its_option(arguments, expected):
    assert ReadOptions.of(**parsed(*arguments)) == ReadOptions(**expected)


def test_arguments_with_maps_read_their_files(tmp_path):
    path = tmp_path / "maps.toml"
    path.write_text('[columns]\nstamp = "t"\npositions = ["a"]\n\n[joints.b]\nsource = "a"\n')
    options = ReadOptions.of(**parsed("--columns", path, "--map", path))
    assert (options.columns.stamp, options.columns.positions) == ("t", ["a"])
    assert options.joint_map.rules == {"b": JointRule("a")}


def test_arguments_of_both_units_are_refused(capsys):
    with pytest.raises(SystemExit):
        parsed("--degrees", "--radians")
    assert "not allowed with" in capsys.readouterr().err
