"""Runs ROS 2 launch files without ROS 2: there are no wheels of `launch` and `launch_ros`.

The classes here have the names, arguments and rules of those that the project's launch files use, as in Humble and
later; any other argument is a TypeError. Nothing is started: `started` returns what would be.
"""

import contextlib
import os
import runpy
import sys
import types
from dataclasses import dataclass, field
from pathlib import Path

import yaml


@dataclass
class Started:
    """One process that a launch file starts."""

    executable: str
    """Package and executable of a node (`rviz2/rviz2`), or the program of a plain process"""
    arguments: list[str]
    environment: dict[str, str]
    """Variables that the launch file has set before"""
    parameters: dict[str, object] = field(default_factory=dict)


@dataclass
class Context:
    directory: Path
    configurations: dict[str, str]
    environment: dict[str, str] = field(default_factory=dict)
    started: list[Started] = field(default_factory=list)

    def text(self, value):
        """A substitution, a string, or a sequence of both, as text."""
        if isinstance(value, str):
            return value
        if isinstance(value, (list, tuple)):
            return "".join(self.text(part) for part in value)
        return value.perform(self)


class LaunchDescription:
    def __init__(self, initial_entities=None):
        self.entities = list(initial_entities or [])

    def visit(self, context):
        for entity in self.entities:
            condition = getattr(entity, "condition", None)
            if condition is None or condition.holds(context):
                entity.execute(context)


class LaunchConfiguration:
    def __init__(self, variable_name, *, default=None):
        self.name, self.default = variable_name, default

    def perform(self, context):
        value = context.configurations.get(self.name, self.default)
        assert value is not None, f"launch configuration {self.name!r} does not exist"
        return context.text(value)


class EnvironmentVariable:
    def __init__(self, name, *, default_value=None):
        self.name, self.default = name, default_value

    def perform(self, context):
        value = {**os.environ, **context.environment}.get(self.name, self.default)
        assert value is not None, f"environment variable {self.name} is not set"
        return context.text(value)


class PathJoinSubstitution:
    def __init__(self, substitutions):
        self.parts = substitutions

    def perform(self, context):
        return os.path.join(*[context.text(part) for part in self.parts])


class ThisLaunchFileDir:
    def perform(self, context):
        return str(context.directory)


class IfCondition:
    def __init__(self, predicate_expression):
        self.expression = predicate_expression

    def holds(self, context):
        return {"true": True, "1": True, "false": False, "0": False}[context.text(self.expression).strip().lower()]


class DeclareLaunchArgument:
    def __init__(self, name, *, default_value=None, description=None, choices=None):
        assert isinstance(default_value, str) is False or choices is None or default_value in choices
        self.name, self.default, self.description, self.choices = name, default_value, description, choices

    def execute(self, context):
        if self.name not in context.configurations:
            if self.default is None:
                raise RuntimeError(f"Required launch argument {self.name!r} was not provided: {self.description}")
            context.configurations[self.name] = context.text(self.default)
        value = context.configurations[self.name]
        if self.choices is not None and value not in self.choices:
            raise RuntimeError(f"Argument {self.name!r}: {value!r} is not valid; valid are {self.choices}")


class SetEnvironmentVariable:
    def __init__(self, name, value):
        self.name, self.value = name, value

    def execute(self, context):
        context.environment[context.text(self.name)] = context.text(self.value)


class Shutdown:
    def __init__(self, *, reason="reason not given"):
        self.reason = reason


class ExecuteProcess:
    def __init__(self, *, cmd, name=None, output="log", on_exit=None, condition=None):
        assert output in ("log", "screen", "both", "own_log", "full")
        assert on_exit is None or isinstance(on_exit, Shutdown)
        self.command, self.name, self.condition = cmd, name, condition

    def execute(self, context):
        command = [context.text(part) for part in self.command]
        context.started.append(Started(command[0], command[1:], dict(context.environment)))


class Node:
    def __init__(
        self, *, executable, package=None, name=None, parameters=None, arguments=None, output="log", condition=None
    ):
        assert output in ("log", "screen", "both", "own_log", "full")
        assert parameters is None or isinstance(parameters, list)
        self.executable = f"{package}/{executable}"
        self.parameters, self.arguments, self.condition = parameters or [], arguments or [], condition

    def execute(self, context):
        arguments = [context.text(argument) for argument in self.arguments]
        given = {name: evaluated(value, context) for one in self.parameters for name, value in one.items()}
        context.started.append(Started(self.executable, arguments, dict(context.environment), given))


class ParameterValue:
    def __init__(self, value, *, value_type=None):
        self.value, self.value_type = value, value_type


def evaluated(value, context):
    """A parameter as `launch_ros` gives it to a node: text without a type is read as YAML."""
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, ParameterValue) and value.value_type is str:
        return context.text(value.value)
    return yaml.safe_load(context.text(value.value if isinstance(value, ParameterValue) else value))


class PythonLaunchDescriptionSource:
    def __init__(self, launch_file_path):
        self.path = launch_file_path


class IncludeLaunchDescription:
    def __init__(self, launch_description_source, *, launch_arguments=None):
        self.source, self.arguments = launch_description_source, launch_arguments or ()

    def execute(self, context):
        for name, value in self.arguments:
            context.configurations[name] = context.text(value)
        path = Path(context.text(self.source.path))
        outer, context.directory = context.directory, path.parent
        runpy.run_path(str(path))["generate_launch_description"]().visit(context)
        context.directory = outer


@contextlib.contextmanager
def _modules(share):
    """The modules that launch files import; `share` is where every package's files lie."""
    contents = {
        "launch": {"LaunchDescription": LaunchDescription},
        "launch.actions": {
            one.__name__: one
            for one in (
                DeclareLaunchArgument,
                ExecuteProcess,
                IncludeLaunchDescription,
                SetEnvironmentVariable,
                Shutdown,
            )
        },
        "launch.conditions": {"IfCondition": IfCondition},
        "launch.launch_description_sources": {"PythonLaunchDescriptionSource": PythonLaunchDescriptionSource},
        "launch.substitutions": {
            one.__name__: one
            for one in (EnvironmentVariable, LaunchConfiguration, PathJoinSubstitution, ThisLaunchFileDir)
        },
        "launch_ros": {},
        "launch_ros.actions": {"Node": Node},
        "launch_ros.parameter_descriptions": {"ParameterValue": ParameterValue},
        "ament_index_python": {},
        "ament_index_python.packages": {"get_package_share_directory": lambda name: str(share)},
    }
    before = {name: sys.modules.get(name) for name in contents}
    for name, members in contents.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module


def started(path, share, **arguments):
    """The processes that a launch file starts, in its order.

    Args:
        path: of the launch file.
        share: what `get_package_share_directory` returns.
        arguments: as of `ros2 launch`, name:=value.
    """
    context = Context(path.parent, dict(arguments))
    with _modules(share):
        runpy.run_path(str(path))["generate_launch_description"]().visit(context)
    return context.started
