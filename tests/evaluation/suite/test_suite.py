"""The suite from a policy to its results: end to end with few episodes, comparability, score, and damaged files."""

import copy
import json
from dataclasses import replace

import numpy as np
import pytest
from comparisons import random_policy

from benchmarks.shipping import reference_row
from quadruped_env import QuadrupedError
from quadruped_env.evaluation.suite.measured_controller import MeasuredController
from quadruped_env.evaluation.suite.suite import (
    COMPONENTS,
    check_comparable,
    check_results,
    read_references,
    read_results,
    references_for,
    run_suite,
    score_table,
)
from quadruped_env.evaluation.suite.suite_definition import full_suite, quick_suite
from quadruped_env.policies import ZeroController
from quadruped_env.robot import MotorConfig
from quadruped_env.task import TaskConfig, TerminationConfig

QUICK = quick_suite()


@pytest.fixture(scope="module")
def result():
    """Quick results of a standing robot, and the progress that was reported."""
    done = []
    return run_suite(MeasuredController("standing", ZeroController(), TaskConfig()), QUICK, done.append), done


def test_quick_suite_measures_every_part(result):
    document, done = result
    assert document["suite"] == QUICK.identity
    assert document["definition"] == QUICK.to_dict()
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert done == sorted(done)
    assert done[-1] == 1.0
    assert len(done) > 100
    check_results(document, "results")


def test_a_standing_robot_scores_where_it_should(result):
    document, _ = result
    components = document["score"]["components"]
    assert list(components) == list(COMPONENTS)
    assert components["commands"] == pytest.approx(1 / 12)  # the command to stand
    assert components["gait"] == 0.0
    assert components["transients"] == 0.0
    assert components["pushes"] > 0.5
    assert components["disturbances"] == 0.0
    assert components["terrain"] == 0.0
    assert components["recovery"] == 1.0
    assert document["score"]["total"] == pytest.approx(np.mean(list(components.values())))
    assert document["commands"]["dead_zone"] == {"forwards": 0.6, "backwards": 0.3, "left": 0.8, "right": 0.8}
    assert document["transients"]["emergency_stop"]["stopping_distance"]["mean"] == pytest.approx(0.0, abs=1e-3)


def test_results_are_reproducible(result):
    again = run_suite(MeasuredController("standing", ZeroController(), TaskConfig()), QUICK)
    for part in COMPONENTS:
        assert again[part] == result[0][part]


@pytest.mark.parametrize(
    ("field", "value", "words"),
    [
        ("version", 2, r"suite.version is 1 in one and 2 in the other; evaluate both with the same version"),
        ("quick", False, r"suite.quick is True in one and False .* a quick result is never comparable"),
        ("sha256", "0" * 64, r"suite.sha256 is .* the definitions of the suite differ"),
        ("name", "other", r"suite.name is 'mq-eval' in one and 'other'"),
    ],
)
def test_results_of_another_suite_are_refused(result, field, value, words):
    other = copy.deepcopy(result[0])
    other["suite"][field] = value
    with pytest.raises(QuadrupedError, match=rf"^a and b cannot be compared: {words}"):
        check_comparable({"a": result[0], "b": other})


@pytest.mark.parametrize(
    ("field", "value"), [("impratio", 10.0), ("cone", 0), ("robot", {"name": "other", "sha256": "1"})]
)
def test_results_of_another_robot_or_physics_are_refused(result, field, value):
    other = copy.deepcopy(result[0])
    other["conditions"][field] = value
    with pytest.raises(QuadrupedError, match=rf"a and b cannot be compared: conditions.{field} is .* same robot"):
        check_comparable({"a": result[0], "b": other})
    del other["conditions"][field]
    with pytest.raises(QuadrupedError, match=rf"conditions.{field}"):
        check_comparable({"a": result[0], "b": other})
    check_comparable({"a": result[0], "b": copy.deepcopy(result[0])})


def test_files_of_results_are_read_and_damaged_ones_named(result, tmp_path):
    path = tmp_path / "suite.json"
    path.write_text(json.dumps(result[0]))
    assert read_results(path) == result[0]
    for damage in ({}, {"suite": {"name": "mq-eval"}}, [1, 2], {**result[0], "score": {"total": 1.0}}):
        path.write_text(json.dumps(damage))
        with pytest.raises(QuadrupedError, match=r"suite.json: lacks the results of the suite .*--suite"):
            read_results(path)
    path.write_text(json.dumps({**result[0], "terrain": 3}))
    with pytest.raises(QuadrupedError, match=r"suite.json: lacks the part 'terrain'"):
        read_results(path)
    broken = copy.deepcopy(result[0])
    broken["score"]["components"]["gait"] = None
    path.write_text(json.dumps(broken))
    with pytest.raises(QuadrupedError, match=r"suite.json: its score is not complete"):
        read_results(path)
    with pytest.raises(QuadrupedError, match="no such file"):
        read_results(tmp_path / "nowhere.json")


def test_reference_rows_count_only_where_they_are_comparable(result, tmp_path):
    row = reference_row(result[0])
    path = tmp_path / "references.json"
    assert read_references(path) == []
    path.write_text(json.dumps({"rows": [row]}))
    rows = read_references(path)
    assert rows == [row]
    assert references_for(result[0], rows) == [row]
    other = copy.deepcopy(row)
    other["suite"]["sha256"] = "0"
    assert references_for(result[0], [other]) == []
    other = copy.deepcopy(row)
    other["conditions"]["impratio"] = 10.0
    assert references_for(result[0], [other]) == []
    table = score_table([row, result[0]])
    assert table.splitlines()[0].split() == ["score", *COMPONENTS]
    assert table.splitlines()[1].split()[:2] == ["standing", f"{row['score']['total']:.3f}"]
    path.write_text(json.dumps({"rows": [{"name": "x"}]}))
    with pytest.raises(QuadrupedError, match=r"references.json: row 1: lacks"):
        read_references(path)
    for damage in ([], {"row": []}, {"rows": 3}):
        path.write_text(json.dumps(damage))
        with pytest.raises(QuadrupedError, match=r"references.json: expected a list 'rows'; .*suite_references.py"):
            read_references(path)


def test_shipped_reference_rows_belong_to_this_suite():
    for row in read_references():
        assert row["suite"] == full_suite().identity


def test_task_of_the_suite_does_not_depend_on_how_a_policy_was_trained():
    """Physics, falls, terrain and randomization of a policy's task do not count; its action and observation do."""
    policy = random_policy(
        "residual",
        motor=MotorConfig(delay=0.03),
        termination=TerminationConfig(max_tilt=3.0, max_trunk_force=1e9),
        clock_frequency=3.0,
    )
    hard = replace(policy.config.randomized("hard").on_terrain("rough"))
    strange = MeasuredController.of_policy(policy, "strange")
    plain = MeasuredController.of_policy(random_policy("residual", clock_frequency=3.0), "plain")
    for measured in (strange, replace(strange, config=hard)):
        assert measured.task([(0.9, 2.0)]) == plain.task([(0.9, 2.0)])
    config = strange.task([(0.9, 2.0)], {"friction": (0.3, 0.3)})
    assert config.action.mode == "residual"
    assert config.clock_frequency == 3.0
    assert config.motor == config.robot.motors
    assert config.termination.max_tilt == 1.0
    assert config.randomization.friction == (0.3, 0.3)
    assert config.randomization.payload is None
    assert config.ground.name == "flat"
    assert config.command.forward_velocity[1] == 0.9
    assert config.command.yaw_rate[1] == 2.0
