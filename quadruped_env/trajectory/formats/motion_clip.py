"""Motion clips in JSON: frames of numbers at an even time, as in motion imitation (DeepMimic, AMP, Laikago and A1).

    {"LoopMode": "Wrap", "FrameDuration": 0.01667, "Frames": [[x, y, z, qx, qy, qz, qw, joint, ...], ...]}

A clip does not name its numbers. With `names`, a frame holds the joints alone, or the base's pose (7 numbers) and then
the joints; for other frames a column map gives each joint its column by number.
"""

from collections.abc import Iterator
from typing import Final

import numpy as np

from quadruped_env.errors import short
from quadruped_env.ros.timestamps import NS_PER_SECOND
from quadruped_env.trajectory.file_reading import Reading
from quadruped_env.trajectory.rows import Rows
from quadruped_env.utils.documents import read_json

DURATION: Final = "FrameDuration"
_POSE: Final = 7
"""Numbers of the base's position and quaternion."""


def read(reading: Reading) -> Iterator[Rows]:
    """The frames of a clip, not validated. Raises a QuadrupedError if it is damaged, or its joints are not named."""
    reading.row_name = "frame"
    document = read_json(reading.path, "name a motion clip or a file of joint states")
    duration, frames = (document.get(key) for key in (DURATION, "Frames")) if isinstance(document, dict) else (0, 0)
    if isinstance(duration, bool) or not isinstance(duration, (int, float)) or not 1e-6 <= duration <= 1e6:
        raise reading.error(None, f"{DURATION}: expected a time from 1e-6 to 1e6 s; found {short(duration)}")
    try:
        table = np.array(frames)
    except ValueError:  # lists of different lengths
        table = np.empty(0)
    if table.ndim != 2 or table.dtype.kind not in "if":
        raise reading.error(None, f"Frames: expected lists of as many numbers each; found {short(frames)}")
    reading.rows = len(table)
    names, columns = _columns(reading, table.shape[1])
    values = {kind: table[:, indices].astype(np.float64) for kind, indices in columns.items()}
    stamps = np.rint(np.arange(len(table)) * (duration * NS_PER_SECOND)).astype(np.int64)
    yield Rows(np.arange(len(table)), stamps, names, values)


def _columns(reading: Reading, width: int) -> tuple[tuple[str, ...], dict[str, list[int]]]:
    """The joints, and kind -> their columns."""
    given, names = reading.options.columns, reading.options.names
    if given is not None:
        found: dict[str, list[int]] = {}
        for kind, columns in given.columns.items():
            for column in (columns[name] for name in given.joints):
                if not isinstance(column, int) or column > width:
                    raise reading.error(
                        None, f"{given.name}: a frame holds {width} numbers without names; found column {short(column)}"
                    )
                found.setdefault(kind, []).append(column - 1)
        return given.joints, found
    if names is not None and width - len(names) in {0, _POSE}:
        return names, {"position": list(range(width - len(names), width))}
    problem = "which have no names" if names is None else f"and {len(names)} names"
    raise reading.error(
        None,
        f"a motion clip with frames of {width} numbers, {problem}: name the joints in their order (--names), of which "
        f"there are {width}, or {max(width - _POSE, 0)} after the base's position and quaternion; or give the columns "
        f"by number (--columns FILE)",
    )
