"""Sweeps from the program to the results: bits of the policies, lost drivers and lost nodes, sockets."""

import json
import os
import signal

import psutil
import pytest
import sweeps
from sweeps import LONG, ONE_MACHINE, TINY, alive, assert_each_finished_once, only, result, rows, runs_of, started
from trainings import train
from waiting import status_of, wait_until

pytest.importorskip("ray")
pytestmark = pytest.mark.slow

LOOPBACK = {"127.0.0.1", "::1", "::ffff:127.0.0.1"}


def test_policies_have_the_bits_of_the_training_program_and_ray_listens_on_loopback_alone(tmp_path):
    arguments = ("--seeds", 2, "--cores-per-trial", os.cpu_count(), "--score", "none", *TINY, "-o", tmp_path / "sweeps")
    log = tmp_path / "log"
    with started(*arguments, output=log) as (process, family):
        wait_until(lambda: runs_of(only(tmp_path / "sweeps"), 0), log.read_text, process)
        assert len(family.update()) > 4, "Ray's processes"
        listening = family.listening()
        assert status_of(process) == 0, log.read_text()
    assert listening, "Ray's sockets"
    assert listening <= LOOPBACK
    folder = only(tmp_path / "sweeps")
    assert_each_finished_once(folder, 2)
    for seed in range(2):
        by_hand = train(tmp_path / "runs", *TINY, "--seed", seed)
        (own,) = runs_of(folder, seed)
        assert (own / "policy.safetensors").read_bytes() == (by_hand / "policy.safetensors").read_bytes()


def test_sweep_whose_driver_is_killed_goes_on_from_its_files(tmp_path):
    arguments = ("--seeds", 3, "--cores", 1, "--score", "none", *LONG, "-o", tmp_path / "sweeps")
    log = tmp_path / "log"
    with started(*arguments, output=log) as (process, family):
        folder = wait_until(lambda: only(tmp_path / "sweeps"), log.read_text, process)
        wait_until(lambda: result(folder, 0) and runs_of(folder, 1), log.read_text, process)
        family.update()
        assert family.trials(), "the process of a trial"
        process.send_signal(signal.SIGKILL)
        status_of(process)
        # Ray's agents may live for a minute longer.
        wait_until(lambda: not any(alive(trial) for trial in family.trials()), "the end of the trials")
    first = (folder / "trials" / "0000" / "result.json").read_bytes()
    assert result(folder, 1) is None
    said = sweeps.run("--resume", folder)
    assert "2 of 3 trials to run" in said
    assert_each_finished_once(folder, 3)
    assert (folder / "trials" / "0000" / "result.json").read_bytes() == first
    assert [len(runs_of(folder, number)) for number in range(3)] == [1, 2, 1]
    # A sweep that is complete starts no Ray.
    assert "trials to run" not in sweeps.run("--resume", folder)


def test_sweep_that_is_interrupted_ends_ray_and_says_how_to_go_on(tmp_path):
    arguments = ("--seeds", 2, "--cores", 1, "--score", "none", *LONG, "-o", tmp_path / "sweeps")
    log = tmp_path / "log"
    with started(*arguments, output=log) as (process, family):
        wait_until(lambda: runs_of(only(tmp_path / "sweeps"), 0), log.read_text, process)
        family.update()
        process.send_signal(signal.SIGINT)
        assert status_of(process) == 130, log.read_text()
        wait_until(lambda: not any(alive(trial) for trial in family.trials()), "the end of the trials")
    folder = only(tmp_path / "sweeps")
    assert result(folder, 1) is None
    assert f"--resume {folder}" in log.read_text()


def test_trials_of_a_node_that_is_killed_are_finished_once(nodes, tmp_path):
    address, kill_one = nodes
    arguments = ("--seeds", 3, "--address", address, "--score", "none", *LONG, "-o", tmp_path / "sweeps")
    log = tmp_path / "log"
    with started(*arguments, output=log, **ONE_MACHINE) as (process, _):
        folder = wait_until(lambda: only(tmp_path / "sweeps"), log.read_text, process)

        def both_nodes_train():
            return sum(bool(runs_of(folder, number)) and result(folder, number) is None for number in range(3)) == 2

        wait_until(both_nodes_train, log.read_text, process)
        kill_one()
        # The remaining node runs one trial after another: a deadline for each, not for all.
        for finished in range(1, 4):
            wait_until(
                lambda finished=finished: sum(result(folder, number) is not None for number in range(3)) >= finished,
                log.read_text,
                process,
            )
        assert status_of(process) == 0, log.read_text()
    assert log.read_text().count("its process or node was lost; it begins again") == 1
    assert_each_finished_once(folder, 3)
    again = [len(runs_of(folder, number)) for number in range(3)]
    assert sorted(again) == [1, 1, 2]


def test_search_with_asha_scores_stops_and_reports(tmp_path):
    pytest.importorskip("optuna")
    space = ("--vary", "learning_rate=1e-9..1e-2:log", "--vary", "hidden=8,16x16")
    search = ("--search", "optuna", "--trials", 4, "--scheduler", "asha", "--rungs", 1)
    said = sweeps.run(*space, *search, *TINY, "-o", tmp_path)
    folder = only(tmp_path)
    table = rows(folder)
    assert len(table) == 4
    assert {row["state"] for row in table} <= {"finished", "stopped"}
    for row in table:
        assert (row["score"] != "") == (row["state"] == "finished")
        assert (folder / "trials" / f"{int(row['trial']):04d}" / "scores.csv").is_file()
    document = json.loads((folder / "results.json").read_text())
    best = max((row for row in table if row["score"]), key=lambda row: float(row["score"]))
    assert document["best"]["trial"] == int(best["trial"])
    assert "score 0." in said
    page = (folder / "report.html").read_text()
    assert "learning_rate" in page


def test_no_process_of_ray_is_left():
    def of_sweeps(process):
        return str(sweeps.SCRIPT) in sweeps.name_of(process)

    def none_is_left():
        return not any(of_sweeps(process) for process in psutil.process_iter())

    # Not at once: another worker of pytest may run a sweep now.
    wait_until(none_is_left, "the end of every process of a sweep", interval=0.5)
