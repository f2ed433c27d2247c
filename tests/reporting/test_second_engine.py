"""The section of a policy's report on a second engine, which needs the results alone, not the engine."""

import json

import pytest
from report_page import Page

from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.reporting.pages.evaluation_report import write_report
from quadruped_env.sim2sim import MuJoCo, run_transfer, transfer_results

TITLE = "In a second physics engine"


@pytest.fixture(scope="module")
def evaluated(run_directory):
    return find_policy(str(run_directory))


@pytest.fixture(scope="module")
def transfer(evaluated):
    return run_transfer(
        evaluated.policy, [(0.3, 0.0), (0.0, 0.0)], 2, 2.0, there=MuJoCo(cone="elliptic", friction=0.35)
    )


def text_of(report):
    return " ".join(" ".join(Page(report.read_text()).text).replace("\N{NO-BREAK SPACE}", " ").split())


def test_report_shows_the_results_of_the_policy_and_leaves_out_those_of_another(
    evaluated, transfer, comparison, without_figures
):
    path = transfer_results.save(transfer, evaluated, "python evaluate/sim2sim.py runs/<name> --seeds 2")
    report, _, _ = write_report(evaluated, comparison, "python evaluate/policy.py runs/<name>", with_video=False)
    shown = text_of(report)
    section = shown[shown.index(TITLE) : shown.index("The worst episodes")]
    for sentence in (*transfer_results.verdict(transfer), *transfer_results.conditions(transfer)):
        assert sentence in section
    for table in transfer_results.tables(transfer):
        assert table.label in section
        for row in table.rows:
            assert " ".join(row) in section
    assert "friction 0.35" in section
    assert "python evaluate/sim2sim.py runs/<name> --seeds 2" in section

    document = json.loads(path.read_text())
    document["policy"]["weights_sha256"] = "0" * 64
    path.write_text(json.dumps(document))
    with pytest.warns(UserWarning, match=r"sim2sim\.json: is of another policy"):
        report, _, _ = write_report(evaluated, comparison, "python evaluate/policy.py runs/<name>", with_video=False)
    assert TITLE not in text_of(report)
