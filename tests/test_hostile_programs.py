"""Programs that are given documents with a damaged or unknown field: status 0, or one line that says what to fix."""

import copy
import dataclasses
import functools
import itertools
import json
import math
import os
import shutil
import traceback
import warnings

import numpy as np
import pytest
from comparisons import TINY
from hanging import bounded
from sweep_files import SUITE_RESULTS, write_sweep

from quadruped_env import api
from quadruped_env.cli import common_options, train, view
from quadruped_env.cli.main import main
from quadruped_env.errors import QuadrupedWarning
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.evaluated_policy import find_policy
from quadruped_env.evaluation.learning_gain import learning_gain
from quadruped_env.evaluation.suite.suite import RESULTS_FILE as SUITE_FILE
from quadruped_env.export import PolicyInterface, folder
from quadruped_env.export.golden_trace import golden_trace
from quadruped_env.export.onnx_graph import policy_graph
from quadruped_env.policies.files import shipped_directory
from quadruped_env.policies.policy_data import CARD_FILE, config_hash
from quadruped_env.reporting.pages import evaluation_report, run_comparison, sweep_report
from quadruped_env.reporting.pages.page import METRICS_FILE
from quadruped_env.reporting.pages.suite_section import write_results
from quadruped_env.scale import ray_connection
from quadruped_env.scale.sweep import sweep_driver
from quadruped_env.scale.sweep.search import Proposals
from quadruped_env.scale.sweep.sweep_driver import TrialBook
from quadruped_env.sim2sim import engines, transfer
from quadruped_env.sim2sim import transfer_results as sim2sim
from quadruped_env.sim2sim.transfer import Transfer
from quadruped_env.training import TrainConfig
from quadruped_env.training.run_directory import CONFIG_FILE, PROGRESS_FILE, RESUME_FILE
from quadruped_env.viewer import show
from quadruped_env.walking_page import html_file
from quadruped_env.walking_page.document import page_document

pytest.importorskip("onnxruntime", reason="ONNX Runtime is not installed: pip install -e '.[export]'")
pytest.importorskip("matplotlib", reason="the report's libraries are not installed: pip install -e '.[report]'")

VALUES = {
    "null": None, "true": True, "text": "x", "NaN": math.nan, "negative": -1, "huge": 10**300, "zero": 0,
    "list": [[1]], "table": {"x": 1}, "empty": {},
}  # fmt: skip
"""Values in place of those of a document; a field is also left out, and one that no version has is added."""
SAMPLE = 4
"""Variants of each document in the default tests."""
MANY = int(os.environ.get("MUTATIONS", "40"))
"""The same in the slow tests; with more, `MUTATIONS=5000 pytest -m slow tests/test_hostile_programs.py`."""


def places(value, at=()):
    """Paths of the values in a document; of entries with equal types, that of one."""
    entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    yield at
    for key, entry in {form(entry): (key, entry) for key, entry in reversed(list(entries))}.values():
        yield from places(entry, (*at, key))


def form(value):
    """The types in a value as text."""
    if isinstance(value, dict):
        return str({key: form(entry) for key, entry in value.items()})
    return str([form(entry) for entry in value]) if isinstance(value, list) else type(value).__name__


def variants(document):
    """All damaged variants of a document: path, kind of damage."""
    for path in places(document):
        for kind in (*VALUES, *(["left out"] if path else []), "unknown field"):
            if kind != "unknown field" or isinstance(at(document, path), dict):
                yield path, kind


def at(document, path):
    return functools.reduce(lambda value, key: value[key], path, document)


def damaged(document, path, kind):
    """A copy of a document with one kind of damage at a path."""
    changed = {"": copy.deepcopy(document)}
    parent, key = (at(changed[""], path[:-1]), path[-1]) if path else (changed, "")
    if kind == "left out":
        del parent[key]
    elif kind == "unknown field":
        parent[key]["no version has this"] = {"deep": [1, {"x": None}]}
    else:
        parent[key] = copy.deepcopy(VALUES[kind])
    return changed[""]


@functools.cache
def evaluation():
    """A small evaluation of the shipped policy, and its gain."""
    policy = find_policy("flat").policy
    return compare(policy, num_seeds=1, seconds=3.0, commands=TINY[:2]), learning_gain(policy, 2, 4.0)


@functools.cache
def exported():
    """Graph, golden trace and content of the page of the shipped policy."""
    policy = find_policy("flat").policy
    interface = PolicyInterface(policy)
    return policy_graph(interface, "flat"), golden_trace(interface), page_document(policy, "flat")


@pytest.fixture(scope="module")
def sound(tmp_path_factory):
    """A run with all documents that programs write next to a policy, an export and a sweep."""
    directory = tmp_path_factory.mktemp("sound")
    run = shutil.copytree(shipped_directory("flat"), directory / "runs" / "walker")
    card = json.loads((run / CARD_FILE).read_text())
    training = dataclasses.asdict(TrainConfig(action_mode=card["action_mode"]))
    (run / CONFIG_FILE).write_text(json.dumps({"training": training, "task": card["config"]}))
    (run / RESUME_FILE).touch()
    evaluated = find_policy(str(run))
    with pytest.MonkeyPatch.context() as patch:
        without_computing(patch)
        patch.chdir(directory)
        assert main(["evaluate", str(run), "--no-video"]) == 0
        write_results(evaluated, {name: part for name, part in SUITE_RESULTS.items() if name != "policy"}, "")
        sim2sim.save(small_transfer(), evaluated, "")
        assert main(["export", str(run), "-o", str(directory / "export"), "--c-int8"]) == 0
    for page in ("walk.html", "report.html"):
        (run / "evaluation" / page).unlink()
    shutil.copytree(run, directory / "runs" / "other")
    write_sweep(directory).path.rename(directory / "sweep")
    for trial in (directory / "sweep").glob("trials/*/run"):
        shutil.copy(run / PROGRESS_FILE, trial)
    return directory


def without_computing(patch):
    """Replace what takes long and reads no document."""
    (comparison, gain), (graph, trace, content) = evaluation(), exported()
    patch.setattr(common_options, "compared", lambda policies, _: several(comparison, policies))
    patch.setattr(common_options, "gain_of", lambda *_: gain)
    patch.setattr(api, "compare", lambda policy, *_, **__: several(comparison, policy))
    patch.setattr(api, "gain_beside", lambda *_: gain)
    for module in (evaluation_report, run_comparison):
        patch.setattr(module, "_figures", lambda *_: [])
    patch.setattr(evaluation_report.plots, "episode", lambda *_: "<svg/>")
    patch.setattr(evaluation_report, "scene", lambda _: {"missing": "no scene"})
    patch.setattr(folder, "policy_graph", lambda *_: graph)
    patch.setattr(folder, "golden_trace", lambda *_: trace)
    patch.setattr(folder, "largest_difference", lambda *_: 1e-6)
    patch.setattr(folder, "int8_loss", lambda _: None)
    patch.setattr(folder, "prepare_video", lambda *_: None)
    patch.setattr(folder, "compare", lambda *_, **__: comparison)
    patch.setattr(folder, "filmed", lambda _: [])
    patch.setattr(folder, "save_film", lambda path, *_: path.write_bytes(b""))
    patch.setattr(html_file, "page_document", lambda *_: content)
    patch.setattr(transfer, "run_transfer", lambda *_, **__: small_transfer())
    patch.setattr(engines, "check_drake", lambda: None)
    patch.setattr(sweep_driver, "run_sweep", finish)
    patch.setattr(ray_connection, "check_installed", lambda _: None)
    patch.setattr(train, "launch", lambda *_: None)
    patch.setattr(show, "Show", lambda controller, *_: controller.close())
    patch.setattr(view, "run_show", lambda *_: 0)


def several(comparison, policies):
    """The comparison as one of several policies, which all have the results of the first."""
    if not isinstance(policies, dict):
        return comparison
    others = {"tuned", "article", "zero"}
    return dataclasses.replace(
        comparison,
        **{
            part: {name: values[name if name in others else "policy"] for name in (*policies, *others)}
            for part, values in (("rollouts", comparison.rollouts), ("values", comparison.values))
        },
    )


def small_transfer():
    """Results of three controllers in two engines."""
    shape, names = (2, 2), ("policy", "tuned", "zero")
    values = {name: np.full(shape, 0.2) for name in ("forward_velocity", "yaw_rate", "base_height")}
    both = {**values, "fallen": np.zeros(shape)}
    settings = tuple({"name": name, "version": "4", "timestep": 0.005} for name in ("MuJoCo", "Drake"))
    commands = dict.fromkeys(names, ((0.3, 0.0), (0.3, 0.5)))
    return Transfer(commands, (1, 2), 5.0, settings, dict.fromkeys(names, (both, both)))


def finish(sweep, make, address, cores, say):
    """Go on with a sweep without training."""
    book = TrialBook(sweep, make, Proposals(sweep.config), say)
    while book.begin() is not None:
        pass
    return True


def write_hash(run):
    """Make a damaged config pass the check of its hash."""
    card = json.loads((run / CARD_FILE).read_text())
    if isinstance(card, dict) and "config" in card:
        (run / CARD_FILE).write_text(json.dumps({**card, "config_sha256": config_hash(card["config"])}))


RUN = "runs/walker"
EXPORT = ("export", RUN, "-o", "out")
PROGRAMS = {
    CARD_FILE: [
        EXPORT,
        (*EXPORT, "--hub", "--c-int8"),
        ("evaluate", RUN, "--no-video", "-o", "out"),
        ("compare", RUN, "flat", "--no-video", "-o", "out"),
        ("page", RUN, "-o", "out.html"),
        ("view", RUN),
        ("sim2sim", RUN, "-o", "out"),
        ("train", "--resume", RUN),
    ],
    CONFIG_FILE: [("compare", RUN, "runs/other", "--suite", "--no-video", "-o", "out"), ("train", "--resume", RUN)],
    f"evaluation/{METRICS_FILE}": [EXPORT, (*EXPORT, "--hub")],
    f"evaluation/{sim2sim.RESULTS_FILE}": [("evaluate", RUN, "--no-video")],
    f"evaluation/{SUITE_FILE}": [("compare", RUN, "runs/other", "--suite", "--no-video", "-o", "out")],
    "../../export/manifest.json": [("check-export", "export"), ("export", RUN, "-o", "export", "--overwrite")],
    "../../sweep/sweep.json": [("sweep", "--resume", "sweep")],
    "../../sweep/trials/0001/trial.json": [("sweep", "--resume", "sweep")],
    "../../sweep/trials/0001/result.json": [("sweep", "--resume", "sweep")],
    "../../sweep/trials/0001/run/evaluation/suite.json": [("sweep", "--resume", "sweep")],
}
"""Document -> programs that read it."""


def failure(arguments, capsys):
    """Wrong end of a program in words; None if it ends well or with one line of an error."""
    capsys.readouterr()
    try:
        with bounded(), warnings.catch_warnings():
            warnings.simplefilter("always", QuadrupedWarning)
            status = main([*arguments])
    except Exception:
        return traceback.format_exc()
    lines = capsys.readouterr().err.splitlines()
    failure.said = [line for line in lines if line != "no scene"]
    prefix = f"mini-quadruped {arguments[0]}: "
    errors = [line for line in failure.said if not line.startswith(f"{prefix}warning: ")]
    # A check-export that ran, and found a difference, ends with 1.
    differs = (arguments[0], status) == ("check-export", 1)
    ended = errors == [] if status == 0 or differs else len(errors) == 1 and errors[0].startswith(f"{prefix}error: ")
    return None if ended and (status in (0, 2) or differs) else f"status {status}: {lines}"


@pytest.mark.parametrize("name", PROGRAMS)
@pytest.mark.parametrize("count", [SAMPLE, pytest.param(MANY, marks=pytest.mark.slow)], ids=["sample", "many"])
def test_program_with_a_damaged_document_ends_well_or_with_one_line(sound, tmp_path, monkeypatch, capsys, name, count):
    without_computing(monkeypatch)
    if count == SAMPLE:
        monkeypatch.setattr(sweep_report, "_figures", lambda *_: [])
    every = list(variants(json.loads((sound / RUN / name).read_text())))
    chosen = [every[number] for number in np.random.default_rng(0).permutation(len(every))[:count]]
    programs = itertools.cycle(PROGRAMS[name])
    for path, kind, command in [
        *((None, "sound", command) for command in PROGRAMS[name]),
        *((path, kind, next(programs)) for path, kind in chosen),
    ]:
        place = shutil.copytree(sound, tmp_path / "place")
        monkeypatch.chdir(place)
        if path is not None:
            file = place / RUN / name
            file.write_text(json.dumps(damaged(json.loads(file.read_text()), path, kind)))
        if name == CARD_FILE:
            write_hash(place / RUN)
            shutil.rmtree(place / RUN / "evaluation")  # so that the results on the card are used
        found = failure(command, capsys)
        if found is None and kind == "sound":
            found = failure.said or None  # not even a warning
        assert found is None, f"{name}: {kind} at {path}: {' '.join(command)}: {found}"
        monkeypatch.chdir(tmp_path)
        shutil.rmtree(place)
