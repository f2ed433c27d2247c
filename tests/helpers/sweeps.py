"""Small sweeps run by the program, and the processes that Ray starts for them."""

import contextlib
import csv
import json
import subprocess
import sys

import psutil
from paths import ROOT, importing
from waiting import DEADLINE, wait_until

SCRIPT = ROOT / "train" / "sweep.py"
TINY = ("--timesteps", "2048", "--num-envs", "16", "--n-steps", "16", "--batch-size", "64")
LONG = ("--timesteps", "40000", *TINY[2:])
"""Trainings that last several seconds on any machine."""
ONE_MACHINE = {"RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER": "0", "RAY_USAGE_STATS_ENABLED": "0"}
"""Environment variables with which all of Ray's processes listen on loopback alone."""


def command(*arguments):
    return [sys.executable, str(SCRIPT), *map(str, arguments)]


def run(*arguments, status=0, **environment):
    """Run the program to its end; its output."""
    done = subprocess.run(
        command(*arguments),
        capture_output=True,
        text=True,
        check=False,
        timeout=4 * DEADLINE,
        env={**importing(), **environment},
    )
    assert done.returncode == status, done.stdout + done.stderr
    return done.stdout


@contextlib.contextmanager
def started(*arguments, output, **environment):
    """The program, running; in the end it and every process of its Ray have ended."""
    with output.open("w") as file:
        process = subprocess.Popen(
            command(*arguments), stdout=file, stderr=subprocess.STDOUT, text=True, env={**importing(), **environment}
        )
        seen = Family(process.pid)
        try:
            yield process, seen
        finally:
            seen.update()
            process.kill()
            process.wait()
            seen.kill()


class Family:
    """A process and all of its descendants, also those whose parent has ended."""

    def __init__(self, pid):
        self.root = psutil.Process(pid)
        self.members = {self.root}

    def update(self):
        with contextlib.suppress(psutil.NoSuchProcess):
            self.members.update(self.root.children(recursive=True))
        return self.members

    def listening(self):
        """Addresses on which any of them listens."""
        found = set()
        for member in self.update():
            with contextlib.suppress(psutil.NoSuchProcess):
                found.update(c.laddr.ip for c in member.net_connections("inet") if c.status == psutil.CONN_LISTEN)
        return found

    def trials(self):
        """Processes that run trials."""
        return [member for member in self.members if name_of(member).startswith("ray::ImplicitFunc")]

    def kill(self):
        """End all of them that still run."""
        for member in self.members:
            with contextlib.suppress(psutil.NoSuchProcess):
                member.kill()
        wait_until(lambda: not any(alive(member) for member in self.members), "the end of Ray's processes")


def alive(process):
    with contextlib.suppress(psutil.NoSuchProcess):
        return process.is_running() and process.status() != psutil.STATUS_ZOMBIE
    return False


def name_of(process):
    with contextlib.suppress(psutil.NoSuchProcess, psutil.ZombieProcess):
        return " ".join(process.cmdline())
    return ""


def only(directory):
    """The one sweep in a directory of sweeps; None before there is one."""
    found = [file.parent for file in directory.glob("*/sweep.json")]
    assert len(found) < 2
    return found[0] if found else None


def rows(folder):
    """Rows of results.csv."""
    with (folder / "results.csv").open() as file:
        return list(csv.DictReader(file))


def result(folder, number):
    """result.json of a trial; None without one."""
    path = folder / "trials" / f"{number:04d}" / "result.json"
    return json.loads(path.read_text()) if path.is_file() else None


def runs_of(folder, number):
    """Run directories of a trial; none before the sweep exists."""
    return (
        []
        if folder is None
        else sorted(path.parent for path in (folder / "trials" / f"{number:04d}").glob("2*/progress.csv"))
    )


def assert_each_finished_once(folder, count):
    """Check that every trial is finished, in one row of the results, with a whole policy."""
    from quadruped_env.policies import load_policy

    table = rows(folder)
    assert [row["trial"] for row in table] == [str(number) for number in range(count)]
    assert {row["state"] for row in table} == {"finished"}
    for row in table:
        assert load_policy(folder / row["run"]).card["seed"] == int(row["seed"])
        assert row["run"].endswith(result(folder, int(row["trial"]))["run"])
