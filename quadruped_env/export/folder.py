"""The folder of an exported policy, ready for a model hub: written completely or not at all."""

import hashlib
import os
import warnings
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.conditions import SIDEWAYS, Command, commands_for
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.evaluation.results import CardResults, StoredEvaluation, card_results
from quadruped_env.export.c_source import c_files
from quadruped_env.export.card import CARD_PAGE, card_page
from quadruped_env.export.golden_trace import TRACE_FILE, csv_text, golden_trace, trace_fields
from quadruped_env.export.manifest import (
    CONTROLLERS_FILE,
    FORMAT,
    GRAPH_FILE,
    MANIFEST_FILE,
    PAGE_FILE,
    manifest,
    metadata,
)
from quadruped_env.export.onnx_graph import policy_graph
from quadruped_env.export.onnx_interface import PolicyInterface
from quadruped_env.export.runtime import largest_difference
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE
from quadruped_env.report.films.video import prepare_video, save_film
from quadruped_env.report.pages.clips import filmed
from quadruped_env.report.pages.page import METRICS_FILE, without_nan
from quadruped_env.robot.ros2_control import controllers_yaml
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.documents import fitted, read_json
from quadruped_env.utils.files import shown_argument, unwritable, whole, write_json
from quadruped_env.utils.plain import plain
from quadruped_env.utils.progress import Progress

FILM_FILE: Final = "film.webp"
FILM_SECONDS: Final = 5.0
"""Length of the filmed episodes, s, of which a part of each is shown."""
FILM_COMMANDS: Final[tuple[Command, ...]] = ((0.4, 0.0), (0.0, 0.5), (-0.2, 0.0))
"""Velocity commands of the film, m/s and rad/s."""


@dataclass(frozen=True)
class Export:
    """An exported policy."""

    folder: Path
    manifest: dict[str, Any]
    files: tuple[str, ...]
    """Names of the files in the folder."""


def export_policy(
    evaluated: EvaluatedPolicy,
    output: Path,
    with_film: bool = False,
    overwrite: bool = False,
    progress: Progress | None = None,
    with_c: bool = False,
    write_page: Callable[[Path], object] | None = None,
) -> Export:
    """Write a policy's folder: ONNX graph, golden trace, manifest, page, the policy's own files, the robot's models.

    The graph is run on ONNX Runtime and compared with the policy before anything is written.

    Args:
        evaluated: policy to export, with its run and the place of its evaluation.
        output: the folder.
        with_film: whether to film the robot.
        overwrite: whether to replace an earlier export.
        progress: called with the fraction of the film that is rendered.
        with_c: whether to write the policy as C, too.
        write_page: writes the page that walks at a path, for a hub; None: no page.

    Raises:
        MissingExtraError: if a library of the extra `export`, or with a film of `report`, is not installed.
        QuadrupedError: if the folder exists, the policy cannot be exported, or a file cannot be written.
    """
    evaluated.policy.check_is_data("export")
    check_output(output, overwrite)
    policy = evaluated.policy.with_card(_published(evaluated.policy.card))
    interface = PolicyInterface(policy)
    graph = policy_graph(interface, policy.robot.name, metadata(policy, interface))
    difference = largest_difference(interface, graph)
    fields, trace = trace_fields(interface), golden_trace(interface)
    contents = {GRAPH_FILE: graph, TRACE_FILE: csv_text(fields, trace).encode(), **policy.files()}
    contents |= {"robot.urdf": policy.robot.description.encode(), "robot.xml": policy.robot.simulated_mjcf.encode()}
    contents[CONTROLLERS_FILE] = controllers_yaml(policy.robot.joint_names, policy.robot.base_name).encode()
    if evaluated.progress_file is not None:
        contents[PROGRESS_FILE] = evaluated.progress_file.read_bytes()
    on_card, found = results_of(evaluated)
    evaluation = None if found is None else _published(found)
    document = manifest(policy, interface, evaluated.name, evaluation, difference, on_card.get("learning"))
    if with_c:
        contents |= c_files(interface, evaluated.name)
    with whole(output) as part:
        part.mkdir()
        if write_page is not None:
            write_page(part / PAGE_FILE)
            contents[PAGE_FILE] = (part / PAGE_FILE).read_bytes()
        if with_film:
            prepare_video(part / FILM_FILE)
            sideways = SIDEWAYS[:1] if policy.robot.moves_sideways else ()
            commands = commands_for(policy.robot, (*FILM_COMMANDS, *sideways))
            comparison = compare(policy, num_seeds=1, seconds=FILM_SECONDS, commands=commands)
            save_film(part / FILM_FILE, filmed(comparison), progress)
            contents[FILM_FILE] = (part / FILM_FILE).read_bytes()
        page = card_page(interface, document, FILM_FILE if with_film else None, [*contents, MANIFEST_FILE])
        contents[CARD_PAGE] = page.encode()
        for name, content in contents.items():
            (part / name).parent.mkdir(exist_ok=True)
            (part / name).write_bytes(content)
        full: dict[str, Any] = without_nan(plain({**document, **_checksums(contents)}))
        write_json(part / MANIFEST_FILE, full)
    return Export(output, full, (*contents, MANIFEST_FILE))


def _published(document: Mapping[str, Any]) -> dict[str, Any]:
    """Return a card, or results, whose command line names no directories."""
    commands = {name: str(document[name]) for name in ("command", "command_line") if document.get(name)}
    shown = {name: [shown_argument(one, names_only=True) for one in text.split()] for name, text in commands.items()}
    return {**document, **{name: " ".join(words) for name, words in shown.items()}}


def check_output(output: Path, overwrite: bool = False) -> None:
    """Check that a folder may be written, before any long computation.

    Only an empty directory or an earlier export is ever replaced.

    Raises:
        QuadrupedError: if something else is there, or an export and `overwrite` is false.
    """
    try:
        if not os.path.lexists(output) or (output.is_dir() and not any(output.iterdir())):
            return
    except OSError as error:
        raise unwritable(output, error) from error
    if not output.is_dir() or not _is_export(output):
        raise QuadrupedError(f"{output}: exists already and is not an exported policy; name another place")
    if not overwrite:
        raise QuadrupedError(f"{output}: exists already; name another place, or ask to overwrite it (--overwrite)")


def results_of(evaluated: EvaluatedPolicy) -> tuple[CardResults, dict[str, Any] | None]:
    """Return the results on the card, and the evaluation in the policy's output directory, else on the card, or None.

    Raises:
        QuadrupedError: if the file of the metrics is no JSON.

    Warns:
        QuadrupedWarning: if results belong to another policy, or have another form; they are left out.
    """
    path, policy = evaluated.output / METRICS_FILE, evaluated.policy
    results = card_results(policy.card, policy.source)
    if path.is_file():
        document, fix = read_json(path, "evaluate the policy again"), "it is left out; evaluate the policy again"
        try:
            known = fitted(document, StoredEvaluation, str(path), fix)
        except QuadrupedError as error:
            warnings.warn(str(error), QuadrupedWarning, stacklevel=3)
        else:
            if known["policy"].get("card") == without_nan(policy.card):
                own = {name: value for name, value in known.items() if name not in ("policy", "controllers")}
                return results, without_nan({**own, **known["controllers"]["policy"]})
            problem = "is the evaluation of another policy, so it is left out; evaluate this one to export its results"
            warnings.warn(f"{path}: {problem}", QuadrupedWarning, stacklevel=3)
    return results, without_nan({name: value for name, value in results.items() if name != "learning"}) or None


def _is_export(folder: Path) -> bool:
    try:
        document = read_json(folder / MANIFEST_FILE)
    except QuadrupedError:
        return False
    return isinstance(document, dict) and document.get("format") == FORMAT


def _checksums(contents: Mapping[str, bytes]) -> dict[str, Any]:
    files = {
        name: {"sha256": hashlib.sha256(content).hexdigest(), "bytes": len(content)}
        for name, content in contents.items()
    }
    return {"weights_sha256": files[TENSORS_FILE]["sha256"], "policy_file": CARD_FILE, "files": files}
