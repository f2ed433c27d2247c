"""The C form of a policy: compiled with all warnings, and equal to ONNX Runtime; its sketch with simulated devices."""

import csv
import ctypes
import dataclasses
import math
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import second_robot
import twelve_joints
from comparisons import random_policy
from test_golden_trace import POLICIES as TRACED
from test_graph import POLICIES, TERMS, own_policy

from quadruped_env.cli.main import main
from quadruped_env.control.joint_command import INVALID_TIMEOUT
from quadruped_env.control.live_controller import Safety
from quadruped_env.export import PolicyInterface, runtime
from quadruped_env.export.c_source import FOLDER, HEADER_FILE, c_files, readings_of
from quadruped_env.export.golden_trace import golden_trace
from quadruped_env.export.onnx_graph import policy_graph
from quadruped_env.policies import load_policy

pytest.importorskip("onnxruntime", reason="ONNX Runtime is not installed: pip install -e '.[export]'")
pytestmark = pytest.mark.skipif(shutil.which("gcc") is None, reason="there is no C compiler: install gcc")

STUBS = Path(__file__).parents[1] / "helpers" / "arduino"
WARNINGS = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Werror")
TOLERANCE = 1e-5
STATE = ("command", "last_action", "gait_phase", "observation_history")


def compiler(*arguments, **options):
    done = subprocess.run([*map(str, arguments)], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, done.stderr
    return done.stdout


class Compiled:
    """The C form of a policy as a library: structures are arrays of float32, in the order of their members."""

    def __init__(self, policy, folder, name="test", flags=("-O2",)):
        self.policy, self.interface = policy, PolicyInterface(policy)
        for path, content in c_files(self.interface, name).items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(content)
        library = folder / "policy.so"
        # Not the processor's wider registers: their sums could be rounded differently from one machine to another.
        source = folder / FOLDER / "policy.c"
        compiled = folder / "policy.o"
        compiler("gcc", "-std=c99", *WARNINGS, *flags, "-fPIC", "-c", source, "-o", compiled)
        # Without the flags: with some, gcc adds start-up code that rounds subnormal numbers to zero in this process.
        compiler("gcc", "-shared", compiled, "-o", library, "-lm")
        self.library = ctypes.CDLL(str(library))
        symbols = compiler("nm", "-D", "--undefined-only", library)
        assert not {"malloc", "calloc", "realloc", "free"} & set(symbols.split())
        self.velocities, joints = policy.control.num_velocities, policy.robot.num_joints
        self.memory_parts = np.cumsum([self.velocities, joints, 1])
        """Ends of the members of the memory before the last one."""
        self.memory_width = self.memory_parts[-1] + self.interface.history_width

    def call(self, function, *arguments):
        pointers = [a.ctypes.data_as(ctypes.c_void_p) if isinstance(a, np.ndarray) else a for a in arguments]
        return getattr(self.library, function)(*pointers)

    def graph(self, inputs):
        """Outputs of the ONNX graph for its inputs (N, width), by `policy_graph`."""
        samples, joints = len(next(iter(inputs.values()))), self.policy.robot.num_joints
        readings = [inputs[entry.name] for entry in readings_of(self.interface)]
        readings = np.ascontiguousarray(np.concatenate([*readings, np.zeros((samples, 1), np.float32)], axis=1))
        memory = [inputs.get("command", np.zeros((samples, self.velocities), np.float32))]
        memory.append(inputs.get("last_action", np.zeros((samples, joints), np.float32)))
        memory.append(inputs.get("gait_phase", np.zeros((samples, 1), np.float32)))
        memory.append(inputs.get("observation_history", np.zeros((samples, 0), np.float32)))
        memory = np.ascontiguousarray(np.concatenate(memory, axis=1))
        target = np.empty((samples, joints), np.float32)
        for row in range(samples):
            self.call("policy_graph", readings[row], memory[row], target[row])
        parts = np.split(memory, self.memory_parts, axis=1)
        return {
            "joint_target": target,
            "action": parts[1],
            "next_gait_phase": parts[2],
            "next_observation_history": parts[3],
        }


def without_clock(policy):
    kept = tuple(entry for entry in policy.fields if entry.name not in ("gait_clock", "command"))
    weights = (policy.weights[0][: 3 * 31], policy.weights[1])
    return dataclasses.replace(policy, weights=weights, fields=kept, output="tanh")


@pytest.mark.parametrize("name", [*POLICIES, "own fields", "no clock, tanh"])
def test_c_equals_onnx_runtime(name, tmp_path):
    if name in POLICIES:
        policy = POLICIES[name]()
    else:
        policy = own_policy(tmp_path, TERMS)
        if name == "no clock, tanh":
            policy = without_clock(policy)
    samples = 10_000 if name == "shipped" else 2_000
    compiled = Compiled(policy, tmp_path)
    inputs = runtime.random_inputs(compiled.interface, samples)
    if "command" in inputs:  # some near the end of standing
        inputs["command"][1::5] = np.random.default_rng(1).uniform(-0.04, 0.04, inputs["command"][1::5].shape)
        inputs["command"][2::5] *= 2.5  # some beyond the gait's largest yaw rate
    expected = runtime.run(runtime.session_of(policy_graph(compiled.interface, "test")), inputs)
    found = compiled.graph(inputs)
    assert max(runtime.difference(name, found[name], value).max() for name, value in expected.items()) < TOLERANCE
    assert np.ptp(expected["joint_target"], axis=0).min() > 0.05


@pytest.mark.parametrize("name", TRACED)
def test_step_is_that_of_the_golden_trace_and_leaves_out_what_is_nan(name, tmp_path):
    policy = TRACED[name](tmp_path)
    compiled, joints = Compiled(policy, tmp_path), policy.robot.num_joints
    trace = golden_trace(compiled.interface)
    readings = np.concatenate([trace[entry.name] for entry in readings_of(compiled.interface)], axis=1)
    requests = trace.get("requested_command", np.zeros((len(readings), compiled.velocities), np.float32))
    memory, target = np.full(compiled.memory_width, 7.0, np.float32), np.empty(joints, np.float32)
    compiled.call("policy_reset", memory)
    for step, requested in enumerate(requests):
        before = memory.copy(), target.copy()
        missing = np.where(np.arange(readings.shape[1]) == step % 22, np.float32(np.nan), readings[step])
        assert compiled.call("policy_step", missing, requested, memory, target) == 0
        np.testing.assert_array_equal(memory, before[0])
        np.testing.assert_array_equal(target, before[1])
        assert compiled.call("policy_step", readings[step], requested, memory, target) == 1
        # The two differ by rounding, which comes back through the last action.
        np.testing.assert_allclose(target, trace["joint_target"][step], rtol=0, atol=1e-4)
        kept = dict(zip(STATE, np.split(memory, compiled.memory_parts), strict=True))
        for field, later in zip(STATE, (0, 1, 1, 1), strict=True):
            if field in trace and step + later < len(requests):
                assert runtime.difference(field, kept[field], trace[field][step + later]).max() < 1e-4
    # Velocities are clipped to the range, and never change faster than the rate.
    low, high = np.transpose([entry.range for entry in policy.control.commands[: compiled.velocities]])
    rate = np.multiply(policy.control.command_rate, policy.control.timestep)
    compiled.call("policy_reset", memory)
    for step in range(1, 80):
        signs = np.array([-1.0, 1.0, -1.0])[: compiled.velocities]
        assert compiled.call("policy_step", readings[0], np.float32(9.0 * signs), memory, target) == 1
        np.testing.assert_allclose(memory[: len(signs)], np.clip(signs * step * rate, low, high), atol=1e-5)


def test_header_has_the_limits_of_the_live_controller():
    policy = load_policy("flat")
    header = c_files(PolicyInterface(policy), "flat")[HEADER_FILE].decode()
    found = {name: float(value) for name, value in re.findall(r"#define POLICY_(\w+) ([\d.]+)f? ", header)}
    safety, control = Safety.of(policy.robot), policy.control
    names = ("RAMP_SPEED", "SETTLE", "MAX_TILT", "COMMAND_TIMEOUT", "HOLD_AFTER", "LIMP_AFTER")
    expected = {name: getattr(safety, name.lower()) for name in names}
    expected |= {"INVALID_AFTER": INVALID_TIMEOUT, "TIMESTEP": control.timestep, "COMMANDS": 2}
    expected["HISTORY"] = (control.observation_history - 1) * PolicyInterface(policy).layout.width
    assert {name: found[name] for name in expected} == pytest.approx(expected)


def test_joint_positions_approach_a_target_at_the_speed_within_the_ranges(tmp_path):
    compiled, robot = Compiled(load_policy("flat"), tmp_path), load_policy("flat").robot
    position = (robot.joint_position_low - 1.0).astype(np.float32)
    target = np.full(8, 9.0, np.float32)
    expected = np.float32(robot.joint_position_low)
    assert compiled.call("policy_approach", target, ctypes.c_float(1.0), position) == 0
    np.testing.assert_allclose(position, expected, atol=1e-6)
    assert compiled.call("policy_approach", target, ctypes.c_float(1.0), position) == 0
    np.testing.assert_allclose(position, expected + 0.02, atol=1e-6)
    assert compiled.call("policy_approach", target, ctypes.c_float(math.inf), position) == 0
    np.testing.assert_allclose(position, expected + 0.02 + 0.02 * robot.velocity_limit, atol=1e-6)
    for _ in range(200):
        there = compiled.call("policy_approach", target, ctypes.c_float(5.0), position)
    assert there == 1
    np.testing.assert_allclose(position, robot.joint_position_high, atol=1e-4)
    names = (ctypes.c_char_p * 8).in_dll(compiled.library, "policy_joint_names")
    assert [name.decode() for name in names] == list(robot.joint_names)


LEVEL, STILL = (0, 0, 8192), (0, 0, 0)


def sketch(policy, folder):
    """Compile the sketch with the stubs; returns a function from periods to rows of output, and the log."""
    compiled = Compiled(policy, folder)
    source, program = folder / FOLDER, folder / "sketch"
    policy_object = folder / "policy.o"
    compiler("gcc", "-std=c99", *WARNINGS, "-O2", "-c", source / "policy.c", "-o", policy_object)
    code = ["-x", "c++", source / f"{FOLDER}.ino", STUBS / "main.cpp", "-x", "none", policy_object]
    compiler("g++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-I", STUBS, "-I", source, *code, "-o", program)

    def run(periods):
        lines = (" ".join(map(str, (answers, *f, *w, text))) for answers, f, w, text in periods)
        done = subprocess.run([program], input="\n".join(lines) + "\n", capture_output=True, text=True, check=True)
        return np.array([line.split() for line in done.stdout.splitlines()], dtype=int), done.stderr

    return compiled, run


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no C++ compiler: install g++")
def test_sketch_walks_as_the_policy_does_and_switches_the_servos_off(tmp_path):
    policy = load_policy("flat")
    compiled, run = sketch(policy, tmp_path)
    command = [(1, LEVEL, STILL, "0.3 0.5")]
    wait, still = [(1, LEVEL, STILL, "-")], [(0, LEVEL, STILL, "-")]
    walking = command * 100
    turned_over = [(1, (0, 8192, 0), (6000, 0, 0), "0.3 0.5")] * 60
    rows, log = run([*wait * 60, *walking, *still * 80, *wait * 60, *walking, *turned_over, *wait * 400, *command * 5,
                     (1, LEVEL, STILL, "x"), *wait * 5])  # fmt: skip
    off, pulses = rows[:, 0] == 1, rows[:, 1:]
    before, walk, silent, again, fallen = np.split(np.arange(len(rows)), [60, 160, 240, 400, 460])[:5]
    assert off[before].all()
    assert not off[walk].any()
    # As many steps of the policy, with the servos as the sketch models them.
    memory, target, robot = np.empty(compiled.memory_width, np.float32), np.empty(8, np.float32), policy.robot
    compiled.call("policy_reset", memory)
    settle = int(np.flatnonzero((pulses[walk] != pulses[walk[0]]).any(axis=1))[0])
    assert settle in (25, 26), "the robot stands in its stance for 0.5 s"
    sent, servo = robot.stance.copy(), robot.stance.copy()
    for row in walk:
        earlier = servo
        servo = earlier + np.clip(sent - earlier, -0.1, 0.1)
        if row >= walk[settle]:
            readings = np.float32([0.0, 0.0, -1.0, *STILL, *servo, *((servo - earlier) / 0.02)])
            assert compiled.call("policy_step", readings, np.float32([0.3, 0.5]), memory, target) == 1
            sent = sent + np.clip(target - sent, -0.02 * robot.velocity_limit, 0.02 * robot.velocity_limit)
        microseconds = np.clip(1500.0 + 636.6 * sent, 500.0, 2500.0)
        np.testing.assert_allclose(pulses[row], microseconds * 4096 / 20000, atol=0.6)
    assert np.ptp(pulses[walk[settle:]], axis=0).min() > 5, "every joint moves"
    # Without the IMU it holds its targets for a second, and then it is limp until the next command.
    assert (pulses[silent[:45]] == pulses[walk[-1]]).all()
    assert not off[silent[:49]].any()
    assert off[silent[52:]].all()
    assert off[again[:60]].all()
    assert not off[again[60:]].any()
    assert off[fallen[-1]]
    assert off[-1]
    assert [line for line in log.splitlines() if line.startswith("limp")] == [
        "limp: no readings", "limp: fallen", "limp: asked to stop",
    ]  # fmt: skip


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no C++ compiler: install g++")
def test_sketch_reads_a_third_number_as_the_velocity_to_the_left(tmp_path):
    compiled, run = sketch(random_policy("residual", twelve_joints.ROBOT), tmp_path)
    lines = {text: run([(1, LEVEL, STILL, "-")] * 60 + [(1, LEVEL, STILL, text)] * 60) for text in ("0 0", "0 0 0.1")}
    (standing, _), (sideways, log) = lines.values()
    assert "limp" not in log
    assert standing.shape == (120, 1 + compiled.policy.robot.num_joints)
    settled = 60 + 26
    np.testing.assert_array_equal(standing[:settled], sideways[:settled])
    rolls = [1 + joints[0] for joints in compiled.policy.robot.leg_joints]
    assert np.ptp(standing[settled:, rolls], axis=0).max() < 4
    assert np.ptp(sideways[settled:, rolls], axis=0).min() > 4
    lines = [(1, LEVEL, STILL, text) for text, count in (("-", 60), ("0 0 0.1", 60), ("0 0", 80)) for _ in range(count)]
    again, _ = run(lines)
    assert np.ptp(again[-20:, rolls], axis=0).max() < 4, "without a third number it stands"
    _, log = run([(1, LEVEL, STILL, "-")] * 60 + [(1, LEVEL, STILL, "0.1")] * 5)
    assert "limp: asked to stop" in log


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no C++ compiler: install g++")
def test_sketch_whose_policy_gives_nan_holds_its_targets_and_then_switches_the_servos_off(tmp_path):
    policy = load_policy("flat")
    # No program exports it: it stands for memory that is damaged.
    policy = dataclasses.replace(policy, weights=tuple(weight * np.float32(1e20) for weight in policy.weights))
    _, run = sketch(policy, tmp_path)
    rows, log = run([*[(1, LEVEL, STILL, "-")] * 60, *[(1, LEVEL, STILL, "0.3 0.5")] * 60])
    moved = rows[60:]
    limp = int(np.flatnonzero(moved[:, 0])[0])
    assert limp in range(35, 40), "0.5 s in the stance, and 0.2 s of invalid targets"
    assert (moved[:limp] == moved[0]).all()
    assert "limp: no valid joint targets" in log


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no C++ compiler: install g++")
def test_sketch_with_a_field_that_nobody_fills_does_not_move_and_has_the_robots_joints(tmp_path):
    policy = own_policy(tmp_path, TERMS)
    _, run = sketch(policy, tmp_path)
    rows, log = run([(1, LEVEL, STILL, "0.3 0")] * 60)
    assert "limp: no readings" in log
    assert (rows[:, 0] == 1).all()
    text = c_files(PolicyInterface(POLICIES["other robot, position"]()), "other")[f"{FOLDER}/{FOLDER}.ino"].decode()
    names = [f"{{{i}, 1.0f, 1500.0f}}, /* {name} */" for i, name in enumerate(second_robot.ROBOT.joint_names)]
    assert [line.strip() for line in text.splitlines() if "1500.0f}" in line] == names


AWKWARD = 'läufer 🤖 */ /* ??/ "x" \\'
FIELDS = f"""
from quadruped_env.task import observation

def field(unit):
    return observation(unit=unit, mirror=(1.0,), scale=5.0, bound=0.9)

@field("m")
def double(readings, control):
    {AWKWARD!r}
    return readings.base_position[:, 2:]

@field("*/ int")
def größe(readings, control):
    "Line one /* not closed"
    return readings.base_position[:, 2:]

@field("m")
def grüße(readings, control):
    "高度。"
    return readings.base_position[:, 2:]
"""


def test_c_of_a_policy_with_names_that_c_does_not_allow_compiles_and_keeps_its_name(tmp_path):
    policy = own_policy(tmp_path, FIELDS, widths=3 * 37)
    compiled = Compiled(policy, tmp_path, name=AWKWARD)
    inputs = runtime.random_inputs(compiled.interface, 100)
    expected = runtime.run(runtime.session_of(policy_graph(compiled.interface, "test")), inputs)
    np.testing.assert_allclose(compiled.graph(inputs)["joint_target"], expected["joint_target"], atol=TOLERANCE)
    header = (tmp_path / FOLDER / "policy.h").read_text()
    assert [f"float {name}[" in header for name in ("double_", "gr__e", "高度")] == [True, True, False]
    assert "高度。 */" in header
    source = tmp_path / FOLDER / "name.c"
    source.write_text('#include <stdio.h>\n#include "policy.h"\nint main(void) { puts(POLICY_NAME); return 0; }\n')
    compiler("gcc", "-std=c99", *WARNINGS, source, "-o", tmp_path / "name")
    assert compiler(tmp_path / "name") == f"{AWKWARD}\n"


FINITE = "without -ffast-math, -Ofast, -ffinite-math-only and /fp:fast"
FLAGS = {
    ("-O2",): None,
    ("-O3", "-fno-signed-zeros", "-fno-trapping-math", "-fassociative-math", "-freciprocal-math"): None,
    ("-O2", "-funsafe-math-optimizations"): None,
    ("-O2", "-ffast-math"): FINITE,
    ("-Ofast",): FINITE,
    ("-O2", "-ffinite-math-only"): FINITE,
    ("-O2", "-funsafe-math-optimizations", "-ffinite-math-only"): FINITE,
    ("-O2", "-D_M_FP_FAST"): FINITE,
}


@pytest.mark.parametrize("flags", FLAGS, ids=" ".join)
def test_c_compiled_without_nan_is_an_error_and_with_other_fast_math_it_is_the_policy(tmp_path, flags):
    if FLAGS[flags] is not None:
        with pytest.raises(AssertionError, match=FLAGS[flags]):
            Compiled(load_policy("flat"), tmp_path, flags=flags)
        return
    compiled = Compiled(load_policy("flat"), tmp_path, flags=flags)
    trace = golden_trace(compiled.interface)
    readings = np.concatenate([trace[entry.name] for entry in readings_of(compiled.interface)], axis=1)
    memory, target = np.empty(compiled.memory_width, np.float32), np.empty(8, np.float32)
    compiled.call("policy_reset", memory)
    for step, requested in enumerate(trace["requested_command"]):
        missing = np.where(np.arange(readings.shape[1]) == step % 22, np.float32(np.nan), readings[step])
        assert compiled.call("policy_step", missing, requested, memory, target) == 0
        assert compiled.call("policy_step", readings[step], requested, memory, target) == 1
        np.testing.assert_allclose(target, trace["joint_target"][step], rtol=0, atol=1e-4)


def test_program_writes_a_loop_in_c_that_its_golden_trace_checks(tmp_path, capsys):
    folder, policy = tmp_path / "flat", load_policy("flat")
    assert main(["export", "flat", "--c", "-o", str(folder)]) == 0
    compiled = Compiled(policy, tmp_path / "c", name="flat")
    for name in ("policy.c", "policy.h", "firmware.ino"):
        assert (folder / FOLDER / name).read_bytes() == (tmp_path / "c" / FOLDER / name).read_bytes()
    with (folder / "golden_trace.csv").open(newline="") as file:
        rows = [{name: float(text) for name, text in row.items()} for row in csv.DictReader(file)]
    memory, target = np.empty(compiled.memory_width, np.float32), np.empty(8, np.float32)
    compiled.call("policy_reset", memory)
    lines = ["step," + ",".join(f"joint_target_{i}" for i in range(8))]
    for step, row in enumerate(rows):
        names = [f"{entry.name}_{i}" for entry in readings_of(compiled.interface) for i in range(entry.width)]
        requested = np.float32([row["requested_command_0"], row["requested_command_1"]])
        assert compiled.call("policy_step", np.float32([row[name] for name in names]), requested, memory, target) == 1
        lines.append(",".join(map(str, (step, *target.tolist()))))
    mine = tmp_path / "mine.csv"
    mine.write_text("\n".join(lines))
    capsys.readouterr()
    assert main(["check-export", str(folder), "--trace", str(mine)]) == 0
    assert capsys.readouterr().out.startswith("mine.csv: equal; ")
