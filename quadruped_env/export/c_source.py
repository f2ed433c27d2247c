"""A policy as C99 for a microcontroller: one header and one source that need math.h, and a sketch of the loop.

The code is in the folder `firmware`; weights, observation scaling, gait clock, scripted gait and limits are tables that
are put into it. It computes in float32, as the ONNX graph does.
"""

import re
from collections.abc import Iterable
from importlib import resources
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from quadruped_env._version import __version__
from quadruped_env.control import observations
from quadruped_env.control.joint_command import INVALID_TIMEOUT
from quadruped_env.control.live_controller import Safety
from quadruped_env.control.velocity_command import moving_threshold
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import Input, PolicyInterface

FOLDER: Final = "firmware"
"""Folder of the files, and name of the sketch: Arduino's tools want them to be the same."""
HEADER_FILE: Final = f"{FOLDER}/policy.h"
SOURCE_FILE: Final = f"{FOLDER}/policy.c"
SKETCH_FILE: Final = f"{FOLDER}/{FOLDER}.ino"

_PER_LINE: Final = 12
"""Numbers per line of a table."""

_ACTIVATIONS: Final = {
    "tanh": "tanhf(x)",
    "elu": "x < 0.0f ? expm1f(x) : x",
    "relu": "x < 0.0f ? 0.0f : x",
    "leaky_relu": "x < 0.0f ? 0.01f * x : x",
    "silu": "x / (1.0f + expf(-x))",
    "gelu": "0.5f * x * (1.0f + erff(0.70710678f * x))",
    "softplus": "(x < 0.0f ? 0.0f : x) + log1pf(expf(-fabsf(x)))",
    "selu": "1.05070099f * (x < 0.0f ? 1.67326324f * expm1f(x) : x)",
    "sigmoid": "1.0f / (1.0f + expf(-x))",
    "mish": "x * tanhf((x < 0.0f ? 0.0f : x) + log1pf(expf(-fabsf(x))))",
}
"""Activation functions of policies, equal to `policies.activations`."""
_SIDEWAYS: Final = {
    "/* fade sideways */": ("", "\n    fade = clip(fabsf(command[2]) / WHOLE_STEPS_SIDEWAYS, fade, 1.0f);"),
    "/* wave sideways */": ("", "\n                + command[2] * wave(9 + k, interval, part, j)"),
    "/* turn size */": (
        "sqrtf(clip(fabsf(command[1]), 0.0f, LARGEST_YAW_RATE) * LARGEST_YAW_RATE)",
        "clip(fabsf(command[1]), 0.0f, LARGEST_YAW_RATE)",
    ),
}
"""Code of a scripted gait without and with a lateral velocity, by its place."""
_READ: Final = {
    2: (
        'int numbers = sscanf(line, "%f %f", &requested[0], &requested[1]);',
        "stop_asked = numbers != 2 || !isfinite(requested[0] + requested[1]);",
    ),
    3: (
        "requested[2] = 0.0f; /* a third number is the velocity to the left, m/s */",
        'int numbers = sscanf(line, "%f %f %f", &requested[0], &requested[1], &requested[2]);',
        "stop_asked = numbers < 2 || !isfinite(requested[0] + requested[1] + requested[2]);",
    ),
}
"""Code that reads a line of a number of velocities."""
_KEYWORDS: Final = frozenset(
    """auto bool break case char class const continue default delete do double else enum extern float for goto if inline
    int long new operator private public register restrict return short signed sizeof static struct switch template this
    throw try typedef union unsigned using virtual void volatile while""".split()  # noqa: SIM905
)
"""Words that C, or the C++ of the sketch, reserves."""


def c_files(interface: PolicyInterface, name: str) -> dict[str, bytes]:
    """Return the header, source and sketch of a policy of some name, by their paths in the exported folder."""
    readings = [
        f"float {member}[POLICY_READS_{member.upper()}]; /* {_comment(f'{entry.unit}: {entry.description}')} */"
        for entry, member in _members(interface)
    ]
    servos = [
        f"{{{i}, 1.0f, 1500.0f}}, /* {_comment(name)} */" for i, name in enumerate(interface.policy.robot.joint_names)
    ]
    velocities, sideways = len(interface.velocities), interface.gait is not None and interface.gait.lateral is not None
    parts = {
        HEADER_FILE: {
            "/* constants */": _constants(interface, name),
            "/* readings */": "\n    ".join(readings or ["char none;"]),
        },
        SOURCE_FILE: {
            "/* tables */": _tables(interface),
            "/* observe */": _observe(interface),
            "/* moves */": " || ".join(f"fabsf(command[{i}]) > moving_threshold[{i}]" for i in range(velocities)),
            **{place: codes[sideways] for place, codes in _SIDEWAYS.items()},
        },
        SKETCH_FILE: {
            "/* one line per joint */": "\n    ".join(servos),
            "/* read velocities */": "\n            ".join(_READ[velocities]),
        },
    }
    files = {}
    for path, texts in parts.items():
        code = resources.files("quadruped_env.export").joinpath(path).read_text(encoding="utf-8")
        for place, text in texts.items():
            code = code.replace(place, text)
        files[path] = code.encode()
    return files


def readings_of(interface: PolicyInterface) -> list[Input]:
    """Return the inputs that a caller gives in every step; the others are part of the memory."""
    own = (graph_io.COMMAND, graph_io.LAST_ACTION, graph_io.GAIT_PHASE, graph_io.HISTORY)
    return [entry for entry in interface.inputs if entry.name not in own]


def _members(interface: PolicyInterface) -> list[tuple[Input, str]]:
    """Return the readings of a step, each with the name of its member in C: the field's name, as far as C allows it."""
    members: dict[str, Input] = {}
    for entry in readings_of(interface):
        member = name = re.sub(r"[^a-zA-Z0-9_]", "_", entry.name) + ("_" if entry.name in _KEYWORDS else "")
        while member.upper() in map(str.upper, members):
            member = f"{name}_{len(members)}"
        members[member] = entry
    return [(entry, member) for member, entry in members.items()]


def _constants(interface: PolicyInterface, name: str) -> str:
    """Return the macros of the header."""
    policy, robot = interface.policy, interface.policy.robot
    safety = Safety.of(robot)
    velocities = [f"{entry.name.replace('_', ' ')}, {entry.unit}" for entry in interface.velocities]
    idle = f"{', '.join('0' for _ in velocities[1:])} and 0"
    macros = [
        ("NAME", _text(name), ""),
        ("ROBOT", _text(robot.name), ""),
        ("MADE_BY", _text(f"mini-quadruped {__version__}"), ""),
        ("JOINTS", str(robot.num_joints), ""),
        ("COMMANDS", str(len(velocities)), f"{', '.join(velocities[:-1])}, and {velocities[-1]}"),
        ("TIMESTEP", _number(policy.control.timestep), "s"),
        ("HISTORY", str(interface.history_width), "numbers"),
        *((f"READS_{member.upper()}", str(entry.width), "numbers") for entry, member in _members(interface)),
        ("RAMP_SPEED", _number(safety.ramp_speed), "rad/s, on the way to the stance"),
        ("SETTLE", _number(safety.settle), "s in the stance before the first step"),
        ("MAX_TILT", _number(safety.max_tilt), "rad; beyond it, switch the motors off"),
        ("COMMAND_TIMEOUT", _number(safety.command_timeout), f"s without a command, then request {idle}"),
        ("HOLD_AFTER", _number(safety.hold_after), "s without readings, then hold the targets"),
        ("LIMP_AFTER", _number(safety.limp_after), "s without readings, then switch the motors off"),
        ("INVALID_AFTER", _number(INVALID_TIMEOUT), "s without valid joint targets, then switch the motors off"),
    ]
    return "\n".join(
        f"#define POLICY_{macro} {value}" + (f" /* {text} */" if text else "") for macro, value, text in macros
    )


def _tables(interface: PolicyInterface) -> str:
    """Return the tables and macros of the source."""
    policy, robot, layout = interface.policy, interface.policy.robot, interface.layout
    gait = interface.gait
    low, high = np.transpose([entry.range for entry in interface.velocities])
    widths = [policy.weights[0].shape[0], *(len(bias) for bias in policy.biases)]
    macros: dict[str, str] = {
        "PRESENT": f"{layout.width} /* columns of the observation of this step */",
        "LAYERS": str(len(policy.weights)),
        "WIDEST": str(max(widths)),
        "ACTIVATE": _ACTIVATIONS[policy.activation],
        "BOUNDED(x)": "tanhf(x)" if policy.output == "tanh" else "clip(x, -1.0f, 1.0f)",
        "ACTION_SCALE": _number(policy.control.action.scale),
    }
    tables: dict[str, ArrayLike] = {"offset": interface.offsets, "scale": layout.scale, "bound": layout.high}
    layers = []
    for i, (weight, bias) in enumerate(zip(policy.weights, policy.biases, strict=True)):
        # The inputs of one output are next to each other.
        tables |= {f"weight_{i}": weight.T, f"bias_{i}": bias}
        layers.append(f"{{{weight.shape[0]}, {weight.shape[1]}, weight_{i}, bias_{i}}}")
    if observations.gait_clock in policy.fields:
        macros["OBSERVES_CLOCK"] = ""
        tables["moving_threshold"] = moving_threshold(robot)
    if interface.has_clock:
        macros["TURN"] = _number(2.0 * np.pi)
        macros["PHASE_STEP"] = _number(interface.phase_step)
    if gait is not None:
        macros |= {"GAIT_KNOTS": str(len(gait.speeds)), "LARGEST_YAW_RATE": _number(gait.largest_yaw_rate)}
        steps = zip(("FORWARD", "TURNING", "SIDEWAYS"), gait.whole_steps, strict=False)
        macros |= {f"WHOLE_STEPS_{name}": _number(step) for name, step in steps}
        waves = np.array([*gait.straight, *gait.turn, *gait.side, *([] if gait.lateral is None else gait.lateral)])
        tables |= {"gait_speeds": gait.speeds, "joint_phases": interface.joint_phases, "gait_waves": waves}
    exported = {
        "stance": robot.stance,
        "lower": robot.joint_position_low,
        "upper": robot.joint_position_high,
        "velocity_limit": robot.velocity_limit,
        "command_low": low,
        "command_high": high,
        "command_rate": policy.control.command_rate,
    }
    return "\n".join(
        [
            *(f"#define {macro} {value}".rstrip() for macro, value in macros.items()),
            f"const char *const policy_joint_names[POLICY_JOINTS] = {_list(map(_text, robot.joint_names), 1)};",
            *(_table(f"const float policy_{table}", values) for table, values in exported.items()),
            *(_table(f"static const float {table}", values) for table, values in tables.items()),
            "static const struct layer {\n    int inputs, outputs;\n    const float *weight, *bias;",
            f"}} layers[LAYERS] = {_list(layers, 1)};",
        ]
    )


def _observe(interface: PolicyInterface) -> str:
    """Return the function that writes the observation of one step."""
    lines = ["int at = 0;", "(void)readings;", "(void)memory;"]
    members = {entry.name: f"readings->{member}" for entry, member in _members(interface)}
    for entry in interface.policy.fields:
        width = entry.width(interface.policy.robot)
        put = f"put(observation, at, {members.get(entry.name, f'memory->{entry.name}')}, {width})"
        lines.append(f"at = {'put_clock(observation, at, memory)' if entry is observations.gait_clock else put};")
    head = "static void observe(const policy_readings *readings, const policy_memory *memory, float *observation)"
    return f"{head}\n{{\n    " + "\n    ".join([*lines, "(void)at;"]) + "\n}"


def _table(name: str, values: ArrayLike) -> str:
    """Return a constant array."""
    numbers = [_number(float(value)) for value in np.ravel(values)]
    return f"{name}[{len(numbers)}] = {_list(numbers)};"


def _list(texts: Iterable[str], per_line: int = _PER_LINE) -> str:
    entries = list(texts)
    rows = [", ".join(entries[i : i + per_line]) for i in range(0, len(entries), per_line)]
    return "{\n    " + ",\n    ".join(rows) + "}"


def _number(value: float) -> str:
    """Return a float32 as C writes it, with as few digits as tell it from its neighbours."""
    text = str(np.float32(value))
    return "INFINITY" if text == "inf" else f"{text}f"


def _text(text: str) -> str:
    """Return a text of any characters as a literal in C: its UTF-8 bytes, those beyond ASCII as octal numbers."""
    plain = {*range(32, 127)} - {*b'"\\?'}
    return '"' + "".join(chr(byte) if byte in plain else f"\\{byte:03o}" for byte in text.encode()) + '"'


def _comment(text: str) -> str:
    """Return text that cannot end the comment that it is in, nor begin another one or a new line."""
    visible = "".join(character if character.isprintable() else " " for character in text)
    return visible.replace("*/", "* /").replace("/*", "/ *").replace("\\", "/").rstrip("/")
