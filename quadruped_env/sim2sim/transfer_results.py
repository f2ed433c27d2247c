"""Results of a policy in two engines: table, verdict, and the file that an evaluation report reads."""

import hashlib
import math
import warnings
from pathlib import Path
from typing import Final, Literal, NamedTuple, TypedDict

from quadruped_env.errors import QuadrupedError, QuadrupedWarning
from quadruped_env.evaluation.evaluated_policy import EvaluatedPolicy
from quadruped_env.policies.policy_data import TENSORS_FILE
from quadruped_env.sim2sim.transfer import TARGETS, StoredTransfer, Transfer
from quadruped_env.utils.documents import fitted, read_json
from quadruped_env.utils.files import write_json
from quadruped_env.utils.provenance import circumstances
from quadruped_env.utils.text_table import text_table

RESULTS_FILE: Final = "sim2sim.json"
FORMAT_VERSION: Final = 1  # as in `StoredResults`

_LABELS: Final = {"policy": "Trained policy", "tuned": "Searched gait", "zero": "Standing still"}
_VELOCITIES: Final = {"forward_velocity": "forward velocity", "yaw_rate": "yaw rate"}
_NOTHING: Final = "-"


_LEFT_OUT: Final = "it is left out; run sim2sim again"


class StoredPolicy(TypedDict):
    """The policy of the results."""

    weights_sha256: str


class StoredResults(StoredTransfer):
    """The file of the results."""

    format_version: Literal[1]
    command_line: str
    policy: StoredPolicy


class Table(NamedTuple):
    """One controller's results as text, one row per command."""

    label: str
    header: tuple[str, ...]
    rows: list[tuple[str, ...]]

    def text(self) -> str:
        """The table as plain text."""
        return f"{self.label}\n{text_table([self.header, *self.rows], left=0)}"


def tables(transfer: Transfer) -> list[Table]:
    """The results of each controller: the mean of each quantity in both engines, and what is lost."""
    here, there = (str(engine["name"]) for engine in transfer.engines)
    velocities = (f"m/s {here}", there, "loss", f"rad/s {here}", there, "loss")
    header = ("m/s, rad/s", *velocities, f"height mm {here}", there, f"falls {here}", there)
    found = []
    for controller, commands in transfer.commands.items():
        rows = []
        for i, (forward, yaw_rate) in enumerate(commands):
            cells = [f"{forward:g}, {yaw_rate:g}"]
            for velocity in TARGETS:
                cells += [_shown(value, 3) for value in transfer.means(controller, velocity, i)]
                cells.append(_percent(transfer.loss(controller, velocity, i)))
            cells += [_shown(1000.0 * value, 0) for value in transfer.means(controller, "base_height", i)]
            cells += [f"{int(engine['fallen'][i].sum())}" for engine in transfer.values[controller]]
            rows.append(tuple(cells))
        found.append(Table(_LABELS[controller], header, rows))
    return found


def verdict(transfer: Transfer) -> tuple[str, ...]:
    """The targets, one sentence each, for the policy; the first is the conclusion."""
    here, there = (str(engine["name"]) for engine in transfer.engines)
    carries_over = transfer.carries_over()
    sentences = [f"The policy {'carries' if carries_over else 'does not carry'} over to {there}."]
    if carries_over is None:
        forward, yaw_rate = transfer.not_followed("policy")[0]
        sentences = [
            f"Whether the policy carries over to {there} is open: in {here} it does not follow the command of "
            f"{forward:g} m/s and {yaw_rate:g} rad/s."
        ]
    for velocity, target in TARGETS.items():
        found = transfer.largest_loss("policy", velocity)
        if found is not None:
            loss, (forward, yaw_rate) = found
            judged = "reached" if loss <= target else "missed"
            sentences.append(
                f"Largest loss of {_VELOCITIES[velocity]} against {here}: {_percent(loss)}, at {forward:g} m/s and "
                f"{yaw_rate:g} rad/s; target {_percent(target)}: {judged}."
            )
    episodes = transfer.values["policy"][0]["fallen"].size
    first, second = transfer.falls("policy")
    sentences.append(f"Falls in {episodes} episodes: {first} in {here}, {second} in {there}.")
    return tuple(sentences)


def conditions(transfer: Transfer) -> tuple[str, ...]:
    """Engine and settings in words, one sentence per engine."""
    return tuple(
        f"{engine['name']} {engine['version']}: "
        + ", ".join(
            f"{name.replace('_', ' ')} {value:g}" if isinstance(value, float) else f"{name.replace('_', ' ')} {value}"
            for name, value in engine.items()
            if name not in ("name", "version")
        )
        + "."
        for engine in transfer.engines
    )


def save(transfer: Transfer, evaluated: EvaluatedPolicy, command_line: str) -> Path:
    """Write the results into the policy's output directory, and return the file; an earlier one is replaced."""
    path = evaluated.output / RESULTS_FILE
    document = {
        "format_version": FORMAT_VERSION,
        **circumstances(command_line),
        "policy": {"name": evaluated.name, "weights_sha256": _weights(evaluated)},
        "verdict": list(verdict(transfer)),
        **transfer.to_dict(),
    }
    write_json(path, document)
    return path


def load(evaluated: EvaluatedPolicy) -> tuple[Transfer, str] | None:
    """The results in the policy's output directory and the command that made them; None if this policy has none.

    Warns:
        QuadrupedWarning: if the file is damaged, of another version, or of another policy.
    """
    path = evaluated.output / RESULTS_FILE
    if not path.is_file():
        return None
    try:
        document = fitted(read_json(path, _LEFT_OUT), StoredResults, str(path), _LEFT_OUT)
        if document["policy"]["weights_sha256"] != _weights(evaluated):
            raise QuadrupedError(f"{path}: is of another policy; {_LEFT_OUT}")
        try:
            return Transfer.from_dict(document), document["command_line"]
        except QuadrupedError as error:
            raise QuadrupedError(f"{path}: {error}; {_LEFT_OUT}") from error
    except QuadrupedError as error:
        warnings.warn(str(error), QuadrupedWarning, stacklevel=2)
    return None


def _weights(evaluated: EvaluatedPolicy) -> str:
    """SHA-256 of the policy's weights, as in its own file."""
    return hashlib.sha256(evaluated.policy.files()[TENSORS_FILE]).hexdigest()


def _shown(value: float, digits: int) -> str:
    return f"{value:z.{digits}f}" if math.isfinite(value) else _NOTHING


def _percent(share: float) -> str:
    return f"{100.0 * share:z.1f} %" if math.isfinite(share) else _NOTHING
