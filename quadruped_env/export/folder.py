"""The folder of an exported policy, ready for a model hub: written completely or not at all."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.policy import CARD_FILE, TENSORS_FILE
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.comparison import Command, compare
from quadruped_env.evaluation.subject import Subject
from quadruped_env.export.card import CARD_PAGE, card_page
from quadruped_env.export.evaluation_results import evaluation_of
from quadruped_env.export.manifest import FORMAT, GRAPH_FILE, MANIFEST_FILE, files_of, manifest
from quadruped_env.export.onnx_graph import policy_graph
from quadruped_env.export.onnx_interface import PolicyInterface
from quadruped_env.export.runtime import largest_difference
from quadruped_env.policies import Policy
from quadruped_env.reporting.films.video import prepare_video, save_film
from quadruped_env.reporting.pages.page import without_nan
from quadruped_env.reporting.pages.pictures import filmed
from quadruped_env.training.run_directory import PROGRESS_FILE
from quadruped_env.utils.documents import read_json
from quadruped_env.utils.files import unwritable, whole, write_json
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
    subject: Subject,
    output: Path,
    with_film: bool = False,
    overwrite: bool = False,
    progress: Progress | None = None,
) -> Export:
    """Write a policy's folder: ONNX graph, manifest, page, the policy's own files, and the robot's models.

    The graph is run on ONNX Runtime and compared with the policy before anything is written.

    Args:
        subject: policy to export, with its run and the place of its evaluation.
        output: the folder.
        with_film: whether to film the robot.
        overwrite: whether to replace an earlier export.
        progress: called with the fraction of the film that is rendered.

    Raises:
        MissingExtraError: if a library of the extra `export`, or with a film of `report`, is not installed.
        QuadrupedError: if the folder exists, the policy cannot be exported, or a file cannot be written.
    """
    subject.policy.check_is_data("export")
    check_output(output, overwrite)
    policy, interface = subject.policy, PolicyInterface(subject.policy)
    graph = policy_graph(interface, policy.robot.name)
    difference = largest_difference(interface, graph)
    contents = {GRAPH_FILE: graph, **policy.files(), **_robot_files(policy), **_learning_curve(subject)}
    document = manifest(policy, interface, subject.name, evaluation_of(subject), difference)
    with whole(output) as part:
        part.mkdir()
        if with_film:
            _film(policy, part / FILM_FILE, progress)
            contents[FILM_FILE] = (part / FILM_FILE).read_bytes()
        page = card_page(interface, document, FILM_FILE if with_film else None, [*contents, MANIFEST_FILE])
        contents[CARD_PAGE] = page.encode()
        for name, content in contents.items():
            (part / name).write_bytes(content)
        full: dict[str, Any] = without_nan(plain({**document, **_checksums(contents)}))
        write_json(part / MANIFEST_FILE, full)
    return Export(output, full, (*contents, MANIFEST_FILE))


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


def _is_export(folder: Path) -> bool:
    try:
        document = read_json(folder / MANIFEST_FILE)
    except QuadrupedError:
        return False
    return isinstance(document, dict) and document.get("format") == FORMAT


def _robot_files(policy: Policy) -> dict[str, bytes]:
    return {"robot.urdf": policy.robot.urdf.encode(), "robot.xml": policy.robot.mjcf.encode()}


def _learning_curve(subject: Subject) -> dict[str, bytes]:
    path = subject.progress_file
    return {} if path is None else {PROGRESS_FILE: path.read_bytes()}


def _checksums(contents: Mapping[str, bytes]) -> dict[str, Any]:
    files = files_of(contents)
    return {"weights_sha256": files[TENSORS_FILE]["sha256"], "policy_file": CARD_FILE, "files": files}


def _film(policy: Policy, path: Path, progress: Progress | None) -> None:
    prepare_video(path)
    comparison = compare(policy, num_seeds=1, seconds=FILM_SECONDS, commands=FILM_COMMANDS)
    save_film(path, filmed(comparison), progress)
