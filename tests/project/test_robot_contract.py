"""No code outside `robot/` knows a robot: its numbers and names come from a `Robot` that is passed down."""

import ast
import re

from paths import ROOT

PACKAGE = ROOT / "quadruped_env"

ENTRY_POINTS = {
    "__init__.py": "public names of the built-in robot",
    "control/live_controller.py": "robot of controllers that are not policies",
    "control/task_file.py": "robot of the built-in task; a task file may import it",
    "envs/specification.py": "tables in the docstring of the environment",
    "evaluation/baseline.py": "default of a public function",
    "evaluation/recorded_episode.py": "default of a public function",
    "gait/gaits.py": "default of the public gaits",
    "gait/gait_presets.py": "the robot on which the presets were tuned",
    "identification/identify.py": "default of a public function",
    "live/nodes/controller.py": "the order of joints in its help",
    "live/simulated.py": "default of a public class",
    "policies/by_name.py": "default of a public function",
    "policies/files.py": "policies that name no robot",
    "replay/motors_file.py": "default of a public function",
    "replay/replay.py": "default of a public function",
    "simulation/batch_simulation.py": "default of a public class",
    "simulation/model.py": "default of a public function",
    "simulation/single_simulation.py": "default of a public class",
    "task/randomization/randomization_presets.py": "the robot for which the presets' ranges are",
    "trajectory/formats/mapped_csv.py": "names of the columns of a CSV without a map",
    "trajectory/joint_trajectory.py": "default of public methods",
    "viewer/view_controller.py": "default of a public class",
}
"""Modules that name the built-in robot, and why."""

# Constants of the package `robot` that hold neither numbers nor names of a robot.
NEUTRAL = {"CORNERS", "JOINT_KINDS", "MAX_DELAY", "MOTOR_PRESETS", "ODOMETRY_FRAME", "SERVO_ERRORS"}

# Position of the robot among the arguments.
NEEDS_ROBOT = {
    "BatchSimulation": 3,
    "CommandedGait.preset": 1,
    "SimulatedRobot": 2,
    "SingleSimulation": 1,
    "SinusoidalGait.preset": 1,
    "TaskRobot": 2,
    "ViewController": 3,
    "build_model": 3,
    "identify": 9,
    "in_joint_order": 0,
    "play": 4,
    "read_motors": 1,
    "replay": 5,
    "run_baseline": 6,
}
"""Functions whose default is the built-in robot: the package itself always says which robot."""

PARTS = re.compile(r"(?<![\w/])(base_link|[LR][FH]_(hip|knee|leg|foot)\w*)")

MODULES = {
    path.relative_to(PACKAGE).as_posix(): ast.parse(path.read_text())
    for path in sorted(PACKAGE.rglob("*.py"))
    if path.relative_to(PACKAGE).parts[0] != "robot"
}


def imported(tree):
    """Names that a module imports from the package `robot`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and re.match(r"quadruped_env\.robot(\.|$)", node.module or ""):
            yield from (alias.name for alias in node.names)


def calls(tree):
    """Calls by the last two names of the function."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            yield ".".join(ast.unparse(node.func).split(".")[-2:]), node


def test_modules_import_no_numbers_or_names_of_a_robot():
    for name, tree in MODULES.items():
        allowed = NEUTRAL | ({"MINI_QUADRUPED"} if name in ENTRY_POINTS else set())
        if name == "__init__.py":
            allowed |= {"JOINT_NAMES", "LEG_NAMES"}
        constants = {constant for constant in imported(tree) if constant.isupper()}
        assert constants <= allowed, f"{name}: take them from the Robot that is passed down"


def test_modules_say_which_robot_they_mean():
    for module, tree in MODULES.items():
        for name, call in calls(tree):
            for function, position in NEEDS_ROBOT.items():
                if name == function or name.endswith(f".{function}"):
                    named = any(keyword.arg in ("robot", None) for keyword in call.keywords)
                    assert named or len(call.args) > position, f"{module}:{call.lineno}: {name} without a robot"


def test_modules_name_no_part_of_a_robot():
    for name, tree in MODULES.items():
        docstrings = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        for node in ast.walk(tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docstrings:
                assert not PARTS.search(node.value), f"{name}:{node.lineno}: {node.value!r}"


def test_every_entry_point_names_the_built_in_robot():
    for name in ENTRY_POINTS.keys() - {"__init__.py"}:
        assert "MINI_QUADRUPED" in set(imported(MODULES[name])), name
