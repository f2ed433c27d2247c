"""tools/mutation.py: the sample of planted bugs, and their score."""

import json

import mutation
import pytest

from quadruped_env.errors import QuadrupedError

RESULTS = {
    "quadruped_env.task.task.xǁTaskǁstep__mutmut_1": 1,
    "quadruped_env.task.task.xǁTaskǁstep__mutmut_2": 0,
    "quadruped_env.task.draws.x_mixed__mutmut_1": 36,
    "quadruped_env.task.draws.x_mixed__mutmut_2": 33,
    "quadruped_env.gait.waves.x_joint_phases__mutmut_1": 37,
    "quadruped_env.gait.waves.x_joint_phases__mutmut_2": None,
}


@pytest.fixture
def folder(tmp_path):
    """A folder as mutmut leaves it."""
    for package in ("task", "gait"):
        path = tmp_path / "quadruped_env" / package / "all.py.meta"
        path.parent.mkdir(parents=True)
        of_package = {name: code for name, code in RESULTS.items() if f".{package}." in name}
        path.write_text(json.dumps({"exit_code_by_key": of_package}))
    return tmp_path


def test_results_are_those_of_all_files(folder):
    assert mutation.read_results(folder) == RESULTS
    with pytest.raises(QuadrupedError, match="holds no planted bugs; run 'make mutate' first"):
        mutation.read_results(folder / "quadruped_env" / "control")


def test_score_counts_what_was_tried_and_names_the_survivors():
    assert mutation.score(RESULTS) == [
        "| package | tried | killed | score | 95 % interval |",
        "|---|---|---|---|---|",
        # Wilson's interval of 1 in 1, 2 in 4 and 3 in 5.
        "| gait | 1 | 1 | 100.0% | 20.7% to 100.0% |",
        "| task | 4 | 2 | 50.0% | 15.0% to 85.0% |",
        "| all | 5 | 3 | 60.0% | 23.1% to 88.2% |",
        "",
        "survived: quadruped_env.task.task.xǁTaskǁstep__mutmut_2",
        "not reached: quadruped_env.task.draws.x_mixed__mutmut_2",
    ]
    with pytest.raises(QuadrupedError, match="no bug has been tried"):
        mutation.score(dict.fromkeys(RESULTS))


def test_sample_has_every_bug_with_the_same_chance():
    names = sorted(RESULTS)
    assert mutation.chosen(RESULTS, 6, 3) == names
    assert mutation.chosen(RESULTS, 2, 3) == mutation.chosen(RESULTS, 2, 3)
    counts = {name: sum(name in mutation.chosen(RESULTS, 2, seed) for seed in range(600)) for name in names}
    # Binomial with p = 1/3: 200 with a standard deviation of 11.5.
    assert all(abs(count - 200) < 5 * 11.5 for count in counts.values())
    for number in (0, 7):
        with pytest.raises(QuadrupedError, match=f"expected 1 to 6; found {number}"):
            mutation.chosen(RESULTS, number, 0)
