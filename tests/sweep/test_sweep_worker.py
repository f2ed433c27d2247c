"""A worker: what is a result and what is not, and trials that go on from a checkpoint."""

import errno
import json
import shutil
import signal

import pytest
from sweeps import finish, make_sweep, policies, start_worker, stub_score, stub_training, work
from trainings import learn
from waiting import output_of, wait_until

from quadruped_env import QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.sweep import worker
from quadruped_env.sweep.folder import Sweep
from quadruped_env.task import BUILT_IN
from quadruped_env.training.resume import Parent
from quadruped_env.utils.files import unwritable

LONG = {"timesteps": 10**9, "checkpoint_seconds": 0.2}


def full_disk():
    try:
        raise OSError(errno.ENOSPC, "No space left on device")
    except OSError as error:
        raise unwritable("policy.json", error) from error


def full_disk_within_another_error():
    try:
        raise OSError(errno.ENOSPC, "No space left on device")
    except OSError:
        raise RuntimeError("failed writing file")  # noqa: B904  # as torch does


def raising(error):
    def train(config, directory):
        raise error

    return train


@pytest.mark.parametrize(
    "train",
    [
        lambda config, directory: full_disk(),
        lambda config, directory: full_disk_within_another_error(),
        raising(MemoryError()),
        raising(RuntimeError("DefaultCPUAllocator: can't allocate memory: you tried to allocate 9 bytes")),
        raising(FileNotFoundError(errno.ENOENT, "gone", "trials")),
        raising(ImportError("no module named torch")),
    ],
    ids=["disk", "disk and torch", "memory", "memory of torch", "folder", "library"],
)
def test_fault_of_the_machine_is_never_a_result_and_ends_the_worker_with_status_1(tmp_path, monkeypatch, capsys, train):
    sweep = make_sweep(tmp_path, seeds=2)
    stub_training(monkeypatch, train)
    assert main(["sweep", "--work", str(sweep.path)]) == 1
    assert sweep.open_trials() == [0, 1]
    captured = capsys.readouterr()
    (line,) = captured.err.splitlines()
    assert line.startswith("mini-quadruped sweep: error: ")
    assert "open trials: 2 of 2; go on with:" in captured.out
    stub_training(monkeypatch, lambda config, directory: None)
    work(sweep)
    assert sweep.open_trials() == []


def test_folder_that_is_lost_in_a_training_is_no_result(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path)
    stub_training(monkeypatch, lambda config, directory: shutil.rmtree(sweep.path))
    with pytest.raises((QuadrupedError, OSError)):
        work(sweep)
    assert not sweep.path.exists()


@pytest.mark.parametrize("error", [ValueError("actions are NaN"), QuadrupedError("weights are not finite")])
def test_error_of_the_training_is_a_failed_result_with_status_1_until_it_is_retried(
    tmp_path, monkeypatch, capsys, error
):
    sweep = make_sweep(tmp_path, seeds=2)

    def train(config, directory):
        if config.seed == 1:
            raise error

    stub_training(monkeypatch, train)
    monkeypatch.setattr("quadruped_env.sweep.report.write_report", lambda sweep: sweep.path)
    assert main(["sweep", "--work", str(sweep.path)]) == 1
    assert [sweep.result(number)["state"] for number in range(2)] == ["finished", "failed"]
    assert str(error) in sweep.result(1)["error"]
    assert "Traceback" in sweep.result(1)["traceback"]
    assert "1 of 2 seeds, 1 failed" in capsys.readouterr().out
    stub_training(monkeypatch, lambda config, directory: None)
    assert main(["sweep", "--work", str(sweep.path)]) == 1, "it is still there"
    assert main(["sweep", "--work", str(sweep.path), "--retry-failed"]) == 0
    assert sweep.result(1)["state"] == "finished"


def test_values_that_do_not_fit_together_fail_alone_and_count_as_the_zero_action(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path, "batch_size=16,4096")
    stub_score(monkeypatch)
    said = work(sweep)
    states = {sweep.result(number)["values"]["batch_size"]: sweep.result(number) for number in range(2)}
    assert [states[size]["state"] for size in (16, 4096)] == ["finished", "failed"]
    assert states[4096]["score"]["total"] == 0.1
    assert "batch_size: 4096 is more than the 32 samples" in states[4096]["error"]
    assert any("batch_size=4096: failed: training.batch_size: 4096" in line for line in said)


def test_score_of_the_zero_action_is_that_of_the_failed_task_or_of_the_sweeps(tmp_path, monkeypatch):
    measured = []

    def run_suite(controller, suite):
        measured.append((controller.controller.action_mode, controller.config.clock_frequency))
        return {"score": 0.3}

    monkeypatch.setattr(worker, "run_suite", run_suite)
    sweep = make_sweep(tmp_path)
    base = sweep.config({}, 0)
    own = sweep.config({"action_mode": "position", "task.clock_frequency": 3.0}, 0)
    impossible = sweep.config({"task.clock_frequency": -3.0}, 0)
    assert [worker.score_of_zero_action(config, base, None) for config in (own, None, impossible)] == [0.3] * 3
    assert measured[0] == ("position", 3.0)
    assert measured[1] == measured[2] == ("residual", measured[1][1])


@pytest.mark.parametrize("number", [signal.SIGTERM, pytest.param(signal.SIGINT, marks=pytest.mark.slow)])
def test_signal_ends_a_worker_with_the_line_that_goes_on_and_its_trial_goes_on_from_the_checkpoint(
    tmp_path, monkeypatch, number
):
    sweep = make_sweep(tmp_path, training=LONG)
    with start_worker(sweep) as process:
        run = wait_until(lambda: next(sweep.trial(0).glob("2*/progress.csv"), None), alive=process).parent
        wait_until(lambda: len((run / "progress.csv").read_text().splitlines()) > 1, alive=process)
        process.send_signal(number)
        out, err = output_of(process)
    assert process.returncode == 128 + number, err
    assert "stopped; go on with:  " in out
    assert f"sweep --work {sweep.path}" in out
    assert "Traceback" not in err
    assert sweep.open_trials() == [0]
    before = Parent.load(run)
    shorten(sweep, before.timesteps + 320)
    stub_score(monkeypatch)
    said = work(Sweep.open(sweep.path))
    assert said[0] == f"trial 0: goes on from its checkpoint at {before.timesteps:,} steps"
    assert "and 2 starts" in said[-1]
    assert sweep.result(0)["timesteps"] == before.timesteps + 320
    undisturbed = learn(tmp_path / "by hand", before.resumed({"timesteps": 320}), before)
    assert policies(sweep, 0)[sorted(policies(sweep, 0))[-1]] == (undisturbed / "policy.safetensors").read_bytes()


def shorten(sweep, timesteps):
    """Give a sweep another budget, so that the rest of a trial takes no time."""
    path = sweep.path / "sweep.json"
    document = json.loads(path.read_text())
    document["training"]["timesteps"] = timesteps
    path.write_text(json.dumps(document))


@pytest.mark.parametrize("budget", [{}, {"seconds": 0.3}])
def test_trial_whose_training_is_complete_is_only_scored(tmp_path, monkeypatch, budget):
    sweep = make_sweep(tmp_path, training=budget)
    stub_score(monkeypatch)
    work(sweep)
    before = policies(sweep, 0)
    (sweep.trial(0) / "result.json").unlink()  # as after a signal while it was scored
    (card,) = sweep.trial(0).glob("2*/policy.json")
    document = json.loads(card.read_text())
    document["card"]["seconds"] += 1000.0
    card.write_text(json.dumps(document))
    work(sweep)
    assert policies(sweep, 0) == before
    assert sweep.result(0)["starts"] == 1
    assert sweep.result(0)["seconds"] >= 1000.0, "the time of the training counts"


def test_trial_goes_on_from_the_run_with_most_steps_whatever_the_clocks_say(tmp_path):
    sweep = make_sweep(tmp_path)
    first = learn(sweep.trial(0), sweep.config({}, 0))
    second = learn(sweep.trial(0), sweep.config({}, 0), Parent.load(first))
    behind = second.rename(second.with_name("20000101-000000-ppo"))
    assert worker._checkpoint(sweep.trial(0), BUILT_IN).directory == behind


def test_policy_of_a_trial_has_the_bits_of_a_training_by_hand(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path, training={"seed": 5})
    stub_score(monkeypatch)
    work(sweep)
    by_hand = learn(tmp_path / "by hand", sweep.config({}, 5))
    assert list(policies(sweep, 0).values()) == [(by_hand / "policy.safetensors").read_bytes()]


@pytest.mark.parametrize("names", [("20260101-ppo", "20260102-ppo"), ("20260102-ppo", "20260101-ppo")])
def test_share_of_an_open_trial_counts_from_its_first_run_whatever_the_clocks_say(tmp_path, names):
    directory = tmp_path / "t"
    assert worker.share_done(directory) == 0.0
    for name, row, timesteps in zip(names, ("250", "500"), (1000, 750), strict=True):
        (directory / name).mkdir(parents=True)
        config = {"training": {"timesteps": timesteps, "seconds": None}}
        (directory / name / "config.json").write_text(json.dumps(config))
        (directory / name / "progress.csv").write_text(f"timesteps,seconds\n{row},1\n")
    (directory / "latest").symlink_to("20260102-ppo")
    assert worker.share_done(directory) == 0.5


def test_task_file_is_copied_and_executed_only_where_it_is_trusted(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    stub_score(monkeypatch)
    file = tmp_path / "mine.py"
    terms = "from quadruped_env.task import reward\n@reward(1.0)\ndef mine(context):\n    return context.base_height\n"
    (tmp_path / "mine.xml").write_text(MINI_QUADRUPED.mjcf)
    file.write_text(
        "import dataclasses, pathlib\nfrom quadruped_env.robot import MINI_QUADRUPED\n"
        "ROBOT = dataclasses.replace(MINI_QUADRUPED, name='mine', mjcf=pathlib.Path(__file__).with_name('mine.xml'))\n"
        + terms
    )
    options = ("--timesteps", "32", "--num-envs", "4", "--n-steps", "8", "--batch-size", "16")
    assert main(["sweep", "--task", "mine.py", *options, "--workers", "0"]) == 0
    file.unlink()
    (tmp_path / "mine.xml").unlink()
    (path,) = (tmp_path / "sweeps").iterdir()
    assert f"sweep --work sweeps/{path.name} --trust-task" in capsys.readouterr().out
    assert main(["sweep", "--work", str(path)]) == 1
    assert "not executed automatically: check the file, then give --trust-task" in capsys.readouterr().err
    assert main(["sweep", "--work", str(path), "--trust-task"]) == 0
    assert Sweep.open(path).result(0)["state"] == "finished"
    (path / "task.py").write_text("raise SystemExit")
    with pytest.raises(QuadrupedError, match=r"task\.py"):
        Sweep.open(path).definition(trusted=True)


def test_worker_of_another_version_does_no_trial(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path)
    (sweep.path / "worker.json").write_text(json.dumps({"python": "0.1"}))
    trained = []
    stub_training(monkeypatch, lambda config, directory: trained.append(config.seed))
    with pytest.raises(QuadrupedError, match=r"the sweep's first worker has python 0\.1"):
        work(sweep)
    assert trained == []


def test_result_of_one_that_is_finished_is_not_done_again(tmp_path, monkeypatch):
    sweep = make_sweep(tmp_path, seeds=2)
    finish(sweep, 0, 0.9)
    trained = []
    stub_training(monkeypatch, lambda config, directory: trained.append(config.seed))
    work(sweep)
    assert trained == [1]
