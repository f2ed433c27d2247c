"""From single messages to rows: the same joints in the same order, and arrays of the right length."""

from array import array
from collections.abc import Iterator
from itertools import chain, islice
from typing import Final

import numpy as np

from quadruped_env.errors import short
from quadruped_env.ros.robot_messages import RawJointState
from quadruped_env.trajectory.reading import Reading, salvaged
from quadruped_env.trajectory.rows import TORQUE_ONLY, Rows
from quadruped_env.utils.arrays import Floats

_MESSAGES_TO_KNOW_ALL: Final = 1000
"""Messages at the beginning in which every joint of a robot that sends several has come."""
_MAX_SKEW: Final = 1.5
"""Time between the joints of one row, in periods of the slowest message."""


def assembled(messages: Iterator[tuple[int, list[RawJointState]]], reading: Reading, is_text: bool) -> Rows | None:
    """Return the rows of messages; None without a usable one.

    The first usable message decides which joints there are, and whether there are velocities and efforts.

    Args:
        messages: number in the file, and joint states of the message.
        reading: of the file.
        is_text: whether the file is text, which has no checksums.

    Raises:
        QuadrupedError: if a message does not match the others and is not to be left out.
    """
    states = _single(messages, reading)
    if reading.repairs("merge"):
        states = _merged(states, reading)
    builder = _Builder(reading)
    for number, state in salvaged(states, reading, is_text):
        reading.rows += 1
        problem = builder.add(number, state)
        if problem is not None:
            if not reading.repairs("drop"):
                merge = ", merge the messages of several drivers (--repair merge)" if "joint '" in problem else ""
                raise reading.error(number, f"{problem}; fix it{merge}, or leave such messages out (--repair drop)")
            reading.left_out[problem] += 1
    return builder.rows()


def _single(
    messages: Iterator[tuple[int, list[RawJointState]]], reading: Reading
) -> Iterator[tuple[int, RawJointState]]:
    """Yield the joint states one by one; the points of a trajectory end where the next one begins."""
    planned: list[tuple[int, RawJointState]] = []
    for number, states in messages:
        if states:
            kept = [one for one in planned if one[1].stamp < states[0].stamp]
            reading.counted["points that a later trajectory replaced"] += len(planned) - len(kept)
            yield from kept
            planned = []
        if len(states) == 1:
            yield number, states[0]
        else:
            planned += [(number, state) for state in states]
    yield from planned


def _merged(messages: Iterator[tuple[int, RawJointState]], reading: Reading) -> Iterator[tuple[int, RawJointState]]:
    """Yield whole joint states from messages with some of the joints each: one whenever all joints have come again.

    It has the timestamp of the newest message. Joints that are too far apart are left out.
    """
    head = list(islice(messages, _MESSAGES_TO_KNOW_ALL))
    stamps: dict[tuple[str, ...], list[int]] = {}
    for _, state in head:
        stamps.setdefault(state.names, []).append(state.stamp)
    names = tuple(dict.fromkeys(chain.from_iterable(stamps)))
    periods = [float(np.median(np.diff(times))) for times in stamps.values() if len(times) > 2]
    limit = _MAX_SKEW * max(periods, default=np.inf)
    reading.note(f"merged {len(stamps)} kinds of messages: {len(names)} joints")
    columns = {name: i for i, name in enumerate(names)}
    values = np.full((3, len(names)), np.nan)
    times = np.full(len(names), -1, np.int64)
    for number, state in chain(head, messages):
        order = [columns.get(name, -1) for name in state.names]
        arrays = state[2:]
        if not order or min(order) < 0 or any(len(given) not in {0, len(order)} for given in arrays):
            yield number, state
            continue
        for row, given in zip(values, arrays, strict=True):
            row[order] = given if len(given) else np.nan
        times[order] = state.stamp
        if (times < 0).any():
            continue
        if times.max() - times.min() <= limit:
            kinds = [row.copy() if np.isfinite(row).any() else np.empty(0) for row in values]
            yield number, RawJointState(int(times.max()), names, *kinds)
        else:
            reading.rows += 1
            reading.left_out["the joints' messages are over 1.5 periods apart"] += 1
        times[:] = -1


class _Builder:
    """Collects messages that match each other."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading
        self._names: tuple[str, ...] = ()
        self._kinds: tuple[str, ...] = ()
        self._orders: dict[tuple[str, ...], list[int] | None] = {}
        """Names in a message -> indices of the joints in its arrays; None if they are in order"""
        self._numbers, self._stamps = array("q"), array("q")
        self._values: dict[str, array[float]] = {}

    def add(self, number: int, state: RawJointState) -> str | None:
        """Add a message. Returns None, or the problem for which it was not added."""
        names = state.names
        if not len(state.position) and len(state.effort):
            return TORQUE_ONLY
        if names not in self._orders:
            problem = self._add_names(names, len(state.position))
            if problem is not None:
                return problem
        order = self._orders[names]
        count = len(self._names)
        if len(state.position) != count:
            return f"{count} names and {len(state.position)} positions"
        values = {"position": state.position, "velocity": _known(state.velocity), "effort": state.effort}
        for kind in self._reading.options.ignore:
            values[kind] = np.empty(0)
        for kind, found in values.items():
            if len(found) not in {0, count}:
                return f"{count} names and {len(found)} {'velocities' if kind == 'velocity' else 'efforts'}"
        kinds = tuple(kind for kind, found in values.items() if len(found))
        if not self._kinds:
            self._kinds = kinds
            self._values = {kind: array("d") for kind in kinds}
        elif kinds != self._kinds:
            odd = min(set(kinds) ^ set(self._kinds))
            there, before = ("has", "lack") if odd in kinds else ("lacks", "have")
            return f"it {there} the {odd} that the messages before it {before}"
        for kind in kinds:
            found = values[kind]
            self._values[kind].frombytes((found if order is None else found[order]).tobytes())
        self._numbers.append(number)
        self._stamps.append(state.stamp)
        return None

    def _add_names(self, names: tuple[str, ...], positions: int) -> str | None:
        """Add names that no message had before. Returns None, or the problem with them."""
        given = self._reading.options.names
        actual = names or given or ()
        if not names and positions and given is None:
            return f"{positions} positions and no names: give the joints in their order (--names)"
        if not actual or not all(actual):
            return f"{positions} positions and {len(actual)} names, of which {actual.count('')} are empty"
        if len(set(actual)) < len(actual):
            repeated = next(name for i, name in enumerate(actual) if name in actual[:i])
            return f"joint {short(repeated)} is named twice"
        if not self._names:
            self._names = actual
        if set(actual) != set(self._names):
            other = min(set(actual) ^ set(self._names))
            there, before = ("has", "lack") if other in actual else ("lacks", "have")
            return f"it {there} joint {short(other)}, which the messages before it {before}"
        self._orders[names] = None if actual == self._names else [actual.index(name) for name in self._names]
        return None

    def rows(self) -> Rows | None:
        """Return the messages that were added, without a copy; None if there are none."""
        if not self._numbers:
            return None
        shape = len(self._numbers), len(self._names)
        values = {kind: np.frombuffer(numbers).reshape(shape) for kind, numbers in self._values.items()}
        return Rows(np.frombuffer(self._numbers, np.int64), np.frombuffer(self._stamps, np.int64), self._names, values)


def _known(values: Floats) -> Floats:
    """Return the numbers, or an empty array if all are NaN, which some publishers send for unmeasured velocities."""
    return np.empty(0) if len(values) and np.isnan(values).all() else values
