"""A policy as C99 for a microcontroller: one header and one source that need math.h, and a sketch of the loop.

Weights, observation scaling, gait clock, history, scripted gait and limits are tables; the code around them is below,
and a policy gets the parts that it needs. It computes in float32, as the ONNX graph does.
"""

import json
from importlib import resources
from typing import Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quadruped_env._version import __version__
from quadruped_env.control import observations
from quadruped_env.control.clock import CommandedFrequency
from quadruped_env.control.live_controller import Safety
from quadruped_env.control.velocity_command import VELOCITY, moving_threshold
from quadruped_env.export import onnx_interface as graph_io
from quadruped_env.export.onnx_interface import Input, PolicyInterface
from quadruped_env.export.quantization import as_int8
from quadruped_env.robot import Robot

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
"""Activation functions of policies, equal to those of `control.activations`."""

_HEADER: Final = """\
/* A policy for a robot: readings in SI units to joint targets in rad, once every POLICY_TIMESTEP.

   C99 and math.h, no allocation, no state but what the caller keeps in a policy_memory. Do not compile it with
   -ffast-math: NaN means "not observed yet" in the history, and marks readings that cannot be used. */
"""

_FUNCTIONS: Final = """\
/* Begin: the robot stands in the stance. */
void policy_reset(policy_memory *memory);

/* One control step. The requested velocities (m/s, rad/s) are clipped to the policy's range, and followed at its rate.
   Returns 1, or 0 if a reading or a requested velocity is NaN: then memory and joint_target stay as they are. */
int policy_step(const policy_readings *readings, const float requested[POLICY_COMMANDS], policy_memory *memory,
                float joint_target[POLICY_JOINTS]);

/* The graph of policy.onnx: memory->command is an input, the rest of the memory is replaced by the outputs. */
void policy_graph(const policy_readings *readings, policy_memory *memory, float joint_target[POLICY_JOINTS]);

/* Move joint positions towards a target, within the joints' ranges and at most at a speed (rad/s) in one control step.
   Returns 1 if they are there. */
int policy_approach(const float target[POLICY_JOINTS], float speed, float joint_position[POLICY_JOINTS]);
"""

_CLIP: Final = """
/* NaN stays NaN. */
static float clip(float value, float low, float high)
{
    return value < low ? low : value > high ? high : value;
}

static float approached(float from, float to, float largest)
{
    return from + clip(to - from, -largest, largest);
}

/* Columns of the observation from `at` on; returns the next one. */
static int put(float *observation, int at, const float *values, int count)
{
    for (int i = 0; i < count; i++, at++)
        observation[at] = clip((values[i] - offset[at]) * scale[at], -bound[at], bound[at]);
    return at;
}

static float activate(float x)
{
    return ACTIVATE;
}
"""

_DENSE: Final = """
static void dense(const float *weight, const float *bias, const float *in, int inputs, float *out, int outputs)
{
    for (int o = 0; o < outputs; o++, weight += inputs) {
        float sum = bias[o];
        for (int i = 0; i < inputs; i++)
            sum += weight[i] * in[i];
        out[o] = sum;
    }
}
"""

_DENSE_INT8: Final = """
/* Weights are steps of their output: 8 bits, while inputs and sums are float. */
static void dense(const int8_t *weight, const float *step, const float *bias, const float *in, int inputs, float *out,
                  int outputs)
{
    for (int o = 0; o < outputs; o++, weight += inputs) {
        float sum = 0.0f;
        for (int i = 0; i < inputs; i++)
            sum += (float)weight[i] * in[i];
        out[o] = bias[o] + step[o] * sum;
    }
}
"""

_LOCATE: Final = """
/* Interval of increasing knots in which x lies, or the first or last one, and the fraction of it below x. */
static float locate(const float *knots, int count, float x, int *interval)
{
    int i = 0;
    while (i < count - 2 && x > knots[i + 1])
        i++;
    *interval = i;
    return clip((x - knots[i]) / (knots[i + 1] - knots[i]), 0.0f, 1.0f);
}
"""

_CLOCK: Final = """
/* Sine and cosine of the phase, 0 where standing is commanded. */
static void gait_clock(const policy_memory *memory, float clock[2])
{
    const float *command = memory->command;
    float moving = fabsf(command[0]) > moving_threshold[0] || fabsf(command[1]) > moving_threshold[1] ? 1.0f : 0.0f;
    clock[0] = moving * sinf(memory->gait_phase);
    clock[1] = moving * cosf(memory->gait_phase);
}
"""

_FREQUENCY: Final = """
/* Advance of the gait clock in this step, rad. */
static float phase_step(const float command[POLICY_COMMANDS])
{
    int i;
    float speed = fabsf(command[0]) + TURN_ARM * fabsf(command[1]);
    float part = locate(clock_speeds, CLOCK_KNOTS, speed, &i);
    return PHASE_STEP * (clock_frequencies[i] + part * (clock_frequencies[i + 1] - clock_frequencies[i]));
}
"""

_GAIT: Final = """
/* Part of the scripted gait's table (sine, cosine or offset; straight, turn or side) at a speed, rad. */
static float wave(int table, int interval, float part, int joint)
{
    const float *below = gait_waves + (table * GAIT_KNOTS + interval) * POLICY_JOINTS + joint;
    return below[0] + part * (below[POLICY_JOINTS] - below[0]);
}

/* Joint positions of the scripted gait; it fades into the stance towards a command of zero. */
static void scripted_gait(const float command[POLICY_COMMANDS], float phase, float joint_position[POLICY_JOINTS])
{
    float forward = fabsf(command[0]) / WHOLE_STEPS_FORWARD, turning = fabsf(command[1]) / WHOLE_STEPS_TURNING;
    float fade = clip(forward > turning ? forward : turning, 0.0f, 1.0f);
    float size = sqrtf(clip(fabsf(command[1]), 0.0f, LARGEST_YAW_RATE) * LARGEST_YAW_RATE);
    float side = command[1] < 0.0f ? -size : size;
    int interval;
    float part = locate(gait_speeds, GAIT_KNOTS, command[0], &interval);
    for (int j = 0; j < POLICY_JOINTS; j++) {
        float whole[3];
        for (int k = 0; k < 3; k++)
            whole[k] = wave(k, interval, part, j) + size * wave(3 + k, interval, part, j)
                + side * wave(6 + k, interval, part, j);
        float angle = phase + joint_phases[j];
        float swing = whole[0] * sinf(angle) + whole[1] * cosf(angle);
        joint_position[j] = policy_stance[j] + fade * (swing + whole[2] - policy_stance[j]);
    }
}
"""

_STEP: Final = """
int policy_step(const policy_readings *readings, const float requested[POLICY_COMMANDS], policy_memory *memory,
                float joint_target[POLICY_JOINTS])
{
    policy_memory next = *memory;
    float target[POLICY_JOINTS];
    for (int i = 0; i < POLICY_COMMANDS; i++)
        next.command[i] = approached(memory->command[i], clip(requested[i], policy_command_low[i],
                                     policy_command_high[i]), policy_command_rate[i] * POLICY_TIMESTEP);
    policy_graph(readings, &next, target);
    for (int j = 0; j < POLICY_JOINTS; j++)
        if (!isfinite(target[j]))
            return 0;
    for (int j = 0; j < POLICY_JOINTS; j++)
        joint_target[j] = target[j];
    *memory = next;
    return 1;
}

int policy_approach(const float target[POLICY_JOINTS], float speed, float joint_position[POLICY_JOINTS])
{
    int there = 1;
    for (int j = 0; j < POLICY_JOINTS; j++) {
        float within = clip(target[j], policy_lower[j], policy_upper[j]);
        float largest = clip(speed, 0.0f, policy_velocity_limit[j]) * POLICY_TIMESTEP;
        float next = approached(joint_position[j], within, largest);
        joint_position[j] = clip(next, policy_lower[j], policy_upper[j]);
        there = there && fabsf(within - next) < 1e-4f;
    }
    return there;
}
"""


def c_files(interface: PolicyInterface, name: str, int8: bool = False) -> dict[str, bytes]:
    """Header, source and sketch of a policy, by their paths in the exported folder.

    Args:
        interface: inputs and outputs of the policy.
        name: name of the policy.
        int8: whether weights have 8 bits in place of float32 (`quantization.as_int8`).
    """
    texts = {
        HEADER_FILE: _header(interface, name),
        SOURCE_FILE: _source(interface, int8),
        SKETCH_FILE: _sketch(interface.policy.robot),
    }
    return {path: text.encode() for path, text in texts.items()}


def readings_of(interface: PolicyInterface) -> list[Input]:
    """Inputs that a caller gives in every step; the others are part of the memory."""
    own = (graph_io.COMMAND, graph_io.LAST_ACTION, graph_io.GAIT_PHASE, graph_io.HISTORY)
    return [entry for entry in interface.inputs if entry.name not in own]


def _sketch(robot: Robot) -> str:
    """The sketch, with a servo for each joint."""
    text = resources.files("quadruped_env.export").joinpath(SKETCH_FILE).read_text(encoding="utf-8")
    servos = (f"    {{{i}, 1.0f, 1500.0f}}, /* {_comment(name)} */" for i, name in enumerate(robot.joint_names))
    return text.replace("    /* one line per joint */", "\n".join(servos))


def _header(interface: PolicyInterface, name: str) -> str:
    policy, robot = interface.policy, interface.policy.robot
    safety, readings = Safety.of(robot), readings_of(interface)
    macros = [
        ("POLICY_NAME", json.dumps(name), ""),
        ("POLICY_ROBOT", json.dumps(robot.name), ""),
        ("POLICY_MADE_BY", json.dumps(f"mini-quadruped {__version__}"), ""),
        ("POLICY_JOINTS", str(robot.num_joints), ""),
        ("POLICY_COMMANDS", str(VELOCITY), "forward velocity, m/s, and yaw rate, rad/s"),
        ("POLICY_TIMESTEP", _number(policy.control.timestep), "s"),
        *((f"POLICY_READS_{entry.name.upper()}", str(entry.width), "numbers") for entry in readings),
        ("POLICY_RAMP_SPEED", _number(safety.ramp_speed), "rad/s, on the way to the stance"),
        ("POLICY_SETTLE", _number(safety.settle), "s in the stance before the first step"),
        ("POLICY_MAX_TILT", _number(safety.max_tilt), "rad; beyond it, switch the motors off"),
        ("POLICY_COMMAND_TIMEOUT", _number(safety.command_timeout), "s without a command, then request 0 and 0"),
        ("POLICY_HOLD_AFTER", _number(safety.hold_after), "s without readings, then hold the targets"),
        ("POLICY_LIMP_AFTER", _number(safety.limp_after), "s without readings, then switch the motors off"),
    ]
    memory = [
        f"    float command[POLICY_COMMANDS]; /* {_comment('on its way to the requested one')} */",
        "    float last_action[POLICY_JOINTS]; /* in [-1, 1] */",
    ]
    if interface.has_clock:
        memory.append("    float gait_phase; /* rad */")
    if interface.history_width:
        memory.append(
            f"    float observation_history[{interface.history_width}]; /* scaled, the latest first; NaN: none yet */"
        )
    constants = ("stance", "lower", "upper", "velocity_limit")
    return "\n".join(
        [
            _HEADER,
            "#ifndef POLICY_H\n#define POLICY_H\n\n#ifdef __FAST_MATH__",
            '#error "policy.c needs NaN: compile it without -ffast-math and -Ofast"\n#endif\n',
            '#ifdef __cplusplus\nextern "C" {\n#endif\n',
            *(f"#define {macro} {value}" + (f" /* {text} */" if text else "") for macro, value, text in macros),
            "\n/* Readings of one step, in the base frame: x forward, y left, z up. */\ntypedef struct {",
            *(
                f"    float {entry.name}[POLICY_READS_{entry.name.upper()}]; "
                f"/* {_comment(f'{entry.unit}: {entry.description}')} */"
                for entry in readings
            ),
            *([] if readings else ["    char none;"]),
            "} policy_readings;\n\n/* What the policy keeps from one step to the next. */\ntypedef struct {",
            *memory,
            "} policy_memory;\n\n/* Joints in the order of all arrays; rad and rad/s. */",
            "extern const char *const policy_joint_names[POLICY_JOINTS];",
            *(f"extern const float policy_{constant}[POLICY_JOINTS];" for constant in constants),
            *(f"extern const float policy_command_{part}[POLICY_COMMANDS];" for part in ("low", "high", "rate")),
            "",
            _FUNCTIONS,
            "#ifdef __cplusplus\n}\n#endif\n\n#endif\n",
        ]
    )


def _source(interface: PolicyInterface, int8: bool) -> str:
    policy, robot, layout = interface.policy, interface.policy.robot, interface.layout
    low, high = np.transpose([entry.range for entry in policy.control.commands[:VELOCITY]])
    names = ",\n    ".join(map(json.dumps, robot.joint_names))
    parts = [
        '#include "policy.h"\n\n#include <math.h>',
        "#include <stdint.h>\n" if int8 else "",
        f"const char *const policy_joint_names[POLICY_JOINTS] = {{\n    {names}}};",
        _table("policy_stance", robot.stance, exported=True),
        _table("policy_lower", robot.joint_position_low, exported=True),
        _table("policy_upper", robot.joint_position_high, exported=True),
        _table("policy_velocity_limit", robot.velocity_limit, exported=True),
        _table("policy_command_low", low, exported=True),
        _table("policy_command_high", high, exported=True),
        _table("policy_command_rate", policy.control.command_rate, exported=True),
        "\n/* Columns of the observation: clip((reading - offset) * scale, -bound, bound). */",
        _table("offset", interface.offsets),
        _table("scale", layout.scale),
        _table("bound", layout.high),
    ]
    for i, (weight, bias) in enumerate(zip(policy.weights, policy.biases, strict=True)):
        parts.append(f"\n/* Layer {i}: {weight.shape[0]} inputs of each of {weight.shape[1]} outputs in turn. */")
        if int8:
            steps, step = as_int8(weight)
            parts += [_table(f"weight_{i}", steps.T), _table(f"step_{i}", step)]
        else:
            parts.append(_table(f"weight_{i}", weight.T))
        parts.append(_table(f"bias_{i}", bias))
    parts += [*_gait_tables(interface), _code(interface, int8)]
    return "\n".join(part for part in parts if part) + _STEP


def _gait_tables(interface: PolicyInterface) -> list[str]:
    """Tables of the gait clock and the scripted gait."""
    parts, gait, frequency = [], interface.gait, interface.frequency
    if observations.gait_clock in interface.policy.fields:
        parts += ["", _table("moving_threshold", moving_threshold(interface.policy.robot))]
    if interface.has_clock and isinstance(frequency, CommandedFrequency):
        parts += [
            f"#define CLOCK_KNOTS {len(frequency.speeds)}",
            f"#define TURN_ARM {_number(frequency.turn_arm)}",
            f"#define PHASE_STEP {_number(interface.phase_step(1.0))}",
            _table("clock_speeds", frequency.speeds),
            _table("clock_frequencies", frequency.frequencies),
        ]
    if gait is not None:
        waves = [*gait.straight, *gait.turn, *gait.side]
        forward, turning = gait.whole_steps
        parts += [
            f"\n#define GAIT_KNOTS {len(gait.speeds)}",
            f"#define WHOLE_STEPS_FORWARD {_number(forward)}",
            f"#define WHOLE_STEPS_TURNING {_number(turning)}",
            f"#define LARGEST_YAW_RATE {_number(gait.largest_yaw_rate)}",
            _table("gait_speeds", gait.speeds),
            _table("joint_phases", interface.joint_phases),
            _table("gait_waves", np.array(waves)),
        ]
    return parts


def _code(interface: PolicyInterface, int8: bool) -> str:
    """Functions that the policy needs, up to `policy_graph`."""
    policy = interface.policy
    layers = range(len(policy.weights))
    clock = observations.gait_clock in policy.fields
    varying = interface.has_clock and isinstance(interface.frequency, CommandedFrequency)
    code = _CLIP.replace("ACTIVATE", _ACTIVATIONS[policy.activation])
    if len(policy.weights) == 1:
        code = code[: code.index("\nstatic float activate")]
    code += _DENSE_INT8 if int8 else _DENSE
    code += _LOCATE if varying or interface.gait is not None else ""
    code += (_CLOCK if clock else "") + (_FREQUENCY if varying else "") + (_GAIT if interface.gait is not None else "")
    first = [graph_io.COMMAND, graph_io.LAST_ACTION]
    lines = [f"float observation[{policy.weights[0].shape[0]}];", "int at = 0;"]
    lines += ["float clock[2];", "gait_clock(memory, clock);"] if clock else []
    for entry in policy.fields:
        source = "memory->" if entry.name in first else "readings->"
        value = "clock" if entry is observations.gait_clock else f"{source}{entry.name}"
        lines.append(f"at = put(observation, at, {value}, {entry.width(policy.robot)});")
    lines += [] if readings_of(interface) else ["(void)readings;"]
    past, every = f"memory->{graph_io.HISTORY}[i]", f"for (int i = 0; i < {interface.history_width}; i++)"
    if interface.history_width:
        lines += [
            f"{every}\n    observation[at + i] = isnan({past}) ? observation[i % at] : {past};",
            f"{every}\n    {past} = observation[i];",
        ]
    else:
        lines.append("(void)at;")
    values = "observation"
    for i in layers:
        inputs, outputs = policy.weights[i].shape
        table = f"weight_{i}, step_{i}" if int8 else f"weight_{i}"
        lines += [
            f"float layer_{i}[{outputs}];",
            f"dense({table}, bias_{i}, {values}, {inputs}, layer_{i}, {outputs});",
        ]
        if i < layers[-1]:
            lines.append(f"for (int i = 0; i < {outputs}; i++)\n    layer_{i}[i] = activate(layer_{i}[i]);")
        values = f"layer_{i}"
    joints = "for (int j = 0; j < POLICY_JOINTS; j++)"
    bounded = f"tanhf({values}[j])" if policy.output == "tanh" else f"clip({values}[j], -1.0f, 1.0f)"
    lines.append(f"{joints}\n    memory->last_action[j] = {bounded};")
    if interface.has_clock:
        frequency = interface.frequency
        step = (
            "phase_step(memory->command)"
            if isinstance(frequency, CommandedFrequency)
            else _number(interface.phase_step(frequency))
        )
        lines.append(f"memory->gait_phase = fmodf(memory->gait_phase + {step}, {_number(2.0 * np.pi)});")
    if interface.gait is None:
        nominal = "policy_stance[j]"
    else:
        lines += ["float nominal[POLICY_JOINTS];", "scripted_gait(memory->command, memory->gait_phase, nominal);"]
        nominal = "nominal[j]"
    change = f"{nominal} + {_number(policy.control.action.scale)} * memory->last_action[j]"
    lines.append(f"{joints}\n    joint_target[j] = clip({change}, policy_lower[j], policy_upper[j]);")
    body = "\n".join(lines).replace("\n", "\n    ")
    reset = ["static const policy_memory zero;", "*memory = zero;"]
    if interface.history_width:
        reset.append(f"{every}\n        {past} = NAN;")
    return (
        f"{code}\nvoid policy_reset(policy_memory *memory)\n{{\n    " + "\n    ".join(reset) + "\n}\n"
        "\nvoid policy_graph(const policy_readings *readings, policy_memory *memory, "
        f"float joint_target[POLICY_JOINTS])\n{{\n    {body}\n}}\n"
    )


def _table(name: str, values: ArrayLike, exported: bool = False) -> str:
    """A constant array, of float or, for integers, of int8_t."""
    array: NDArray[np.generic] = np.asarray(values)
    integers = np.issubdtype(array.dtype, np.integer)
    numbers = [str(value) if integers else _number(float(value)) for value in array.ravel().tolist()]
    rows = [", ".join(numbers[i : i + _PER_LINE]) for i in range(0, len(numbers), _PER_LINE)]
    kind = f"{'' if exported else 'static '}const {'int8_t' if integers else 'float'}"
    return f"{kind} {name}[{len(numbers)}] = {{\n    " + ",\n    ".join(rows) + "};"


def _number(value: float) -> str:
    """A float32 as C writes it, with as few digits as tell it from its neighbours."""
    text = str(np.float32(value))
    return "INFINITY" if text == "inf" else f"{text}f"


def _comment(text: str) -> str:
    """Text that cannot end the comment that it is in."""
    return text.replace("*/", "* /")
