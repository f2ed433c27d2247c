"""Content of the page that walks, as JSON: the policy's graph, the robot on each terrain, and a walk to compare with.

The programs that read it are in `tools/page/src`.
"""

import base64
import re
from dataclasses import replace
from typing import Any, Final

import mujoco
import numpy as np

from quadruped_env._version import __version__
from quadruped_env.control.observations import OBSERVATIONS
from quadruped_env.control.steering import key_steps
from quadruped_env.errors import QuadrupedError
from quadruped_env.export.onnx_graph import Graph
from quadruped_env.export.onnx_interface import PolicyInterface
from quadruped_env.policies.policy import Policy
from quadruped_env.report.palette import leg_colours
from quadruped_env.robot.motors import SERVO_ERRORS
from quadruped_env.robot.readings import sensor_columns
from quadruped_env.robot.robot import Robot
from quadruped_env.robot.units import scale_of
from quadruped_env.simulation import SingleSimulation, Terrain, Tiles, flat
from quadruped_env.simulation.built_in_terrains import terrain_scale
from quadruped_env.simulation.model import build_spec, lay_ground
from quadruped_env.task import Task, TaskConfig
from quadruped_env.walking_page.learning import learning_document

SIZE: Final = 16.0
"""Longest side of a terrain on the page, for the built-in robot, m: larger ones would make the file large."""
SECONDS: Final = 10.0
"""Length of the walk that the page repeats, s."""
_SPEED: Final = 0.8
"""Forward velocity of that walk, as a part of the largest command."""
_LEVELS: Final = 2**16 - 1
"""Heights are whole numbers up to this one."""
_MAX_FILES: Final = 8_000_000
"""Largest size of all files of a robot's model, bytes."""
_ENV: Final = np.zeros(1, dtype=np.intp)


def check_exportable(policy: Policy) -> None:
    """Check that a page can run a policy.

    Raises:
        QuadrupedError: if it is code, or observes more than this package's own readings; the message names what.
    """
    policy.check_is_data("page")
    own = [entry.name for entry in policy.fields if not any(entry is other for other in OBSERVATIONS)]
    if own:
        raise QuadrupedError(
            f"page: the policy observes {', '.join(own)} of the task's own file, which is Python; a page can run "
            f"policies that observe only {', '.join(entry.name for entry in OBSERVATIONS)}"
        )


def page_document(policy: Policy, name: str) -> dict[str, Any]:
    """Return the content of a policy's page, of plain values.

    Args:
        policy: the policy.
        name: name to show.

    Raises:
        QuadrupedError: as `check_exportable`.
    """
    check_exportable(policy)
    config, robot = policy.config, policy.robot
    reference, terrains = _reference(policy, config), _terrains(config)
    # In the order of the command; the last one only for a robot that walks sideways.
    ranges = [list(entry.range) for entry in config.commands[: policy.control.num_velocities]]
    return {
        "name": name,
        "versions": {"mini_quadruped": __version__, "mujoco": mujoco.__version__},
        "policy": graph_document(Graph.of(interface := PolicyInterface(policy)), interface),
        "gait": _gait(policy),
        "learning": learning_document(config),
        "control": {
            "timestep": config.control_timestep,
            "command_rate": list(policy.control.command_rate),
            **dict(zip(("forward", "turn", "lateral"), ranges, strict=False)),
            "key_steps": list(key_steps(robot)),
        },
        "terrain": config.ground.name if any(config.ground.name == terrain.name for terrain in terrains) else flat.name,
        "robot": {
            "name": robot.name,
            "base": robot.base_name,
            "mass": robot.total_mass,
            "height": robot.stance_height,
            "scale": scale_of("m", robot),
            "friction": reference["friction"],
            "foot_radius": robot.foot_radius,
            "contact": config.reward.contact_threshold,
            "decimation": config.decimation,
            "start": reference["start"],
            "columns": {
                field: [columns.start, columns.stop] for field, columns in sensor_columns(robot.model, robot).items()
            },
            "servo": _servo(config),
            "files": _files(robot),
            "legs": [
                {"name": leg, "colour": colour, "site": site}
                for (leg, colour), site in zip(leg_colours(robot).items(), robot.foot_sites, strict=True)
            ],
        },
        "terrains": [_terrain(terrain, config) for terrain in terrains],
        "reference": reference,
    }


def graph_document(graph: Graph, interface: PolicyInterface) -> dict[str, Any]:
    """Return a graph as plain values: nodes as (operator, inputs, output), constants as base64 of float32 by rows.

    It keeps the inputs and outputs of the interface that the graph has.
    """
    written = {output for _, _, output, _ in graph.nodes}
    read = {name for _, names, _, _ in graph.nodes for name in names}
    return {
        "nodes": [(operator, names, output) for operator, names, output, _ in graph.nodes],
        "constants": {
            name: base64.b64encode(values.astype("<f4").tobytes()).decode() for name, values in graph.constants.items()
        },
        "inputs": {entry.name: entry.width for entry in interface.inputs if entry.name in read},
        "outputs": [entry.name for entry in interface.outputs if entry.name in written],
    }


def _gait(policy: Policy) -> dict[str, Any] | None:
    """Return the graph of the scripted gait alone: the policy's or the default one; None for robots without one."""
    action = replace(policy.control.action, mode="residual")
    interface = PolicyInterface(replace(policy, control=replace(policy.control, action=action)))
    try:
        return graph_document(Graph.of_gait(interface), interface)
    except QuadrupedError:  # the gaits are for legs of two joints, one in each corner
        return None


def _servo(config: TaskConfig) -> dict[str, list[float]] | None:
    """Return the errors of the servos of all joints, rad; None if they have none."""
    errors = config.motor.servo_errors(config.robot.joint_kinds)
    if not any(values.any() for values in errors):
        return None
    return {name: values.tolist() for name, values in zip(SERVO_ERRORS, errors, strict=True)}


def _files(robot: Robot) -> dict[str, str]:
    """Return the files of a robot's model as base64 by name.

    Raises:
        QuadrupedError: if they are larger than `_MAX_FILES`.
    """
    files = robot.assets or {}
    if (total := sum(map(len, files.values()))) > _MAX_FILES:
        largest = max(files, key=lambda name: len(files[name]))
        raise QuadrupedError(
            f"the page holds up to {_MAX_FILES / 1e6:g} MB of files of a robot's model, and the model of "
            f"{robot.name!r} has {total / 1e6:.1f} MB, of which {largest!r} has {len(files[largest]) / 1e6:.1f} MB; "
            f"give the robot without meshes that do not collide, or with coarser ones"
        )
    return {name: base64.b64encode(content).decode() for name, content in files.items()}


def _terrains(config: TaskConfig) -> list[Terrain]:
    """Return the terrains to choose from, the policy's own in its own shape."""
    ground, found = config.ground, []
    for terrain in config.definition.terrains:
        if isinstance(terrain, Tiles):
            continue
        scale = terrain_scale(terrain, config.robot)
        shape = ground if ground.name == terrain.name else terrain.variant(scale=scale)
        found.append(replace(shape, size=min(shape.size, SIZE)))
    return found


def _terrain(terrain: Terrain, config: TaskConfig) -> dict[str, Any]:
    """Return a terrain's MJCF with the robot, and the heights that belong into its height field."""
    heights = terrain.heights()
    lowest, span = float(heights.min()), float(np.ptp(heights))
    spec = build_spec(config.physics_timestep, config.motor, flat, config.robot)
    if span > 0.0:
        # MuJoCo would take a second to write all heights as text, and the page has them as numbers.
        lay_ground(spec, np.array([[lowest, lowest + span]] * 2), terrain.extent)
    spec.compile()  # without which MuJoCo writes no XML
    rows, columns = heights.shape
    xml = re.sub(r'nrow="2" ncol="2" elevation="[^"]*"', f'nrow="{rows}" ncol="{columns}"', spec.to_xml())
    found: dict[str, Any] = {"name": terrain.name, "xml": xml}
    if span > 0.0:
        levels = np.rint((heights - lowest) / span * _LEVELS).astype("<u2")
        found["heights"] = {
            "shape": heights.shape,
            "extent": terrain.extent,
            "lowest": lowest,
            "span": span,
            "data": base64.b64encode(levels.tobytes()).decode(),
        }
    return found


def _reference(policy: Policy, config: TaskConfig) -> dict[str, Any]:
    """Return start, command and end of a walk straight ahead on the plane in Python, without randomization."""
    config, robot = config.without_randomization().on_terrain(flat), policy.robot
    simulation = SingleSimulation(config.compiled_model(), robot)
    task = Task(simulation, config)
    velocity = [round(_SPEED * config.commands[0].range[1], 2), *[0.0] * (policy.control.num_velocities - 1)]
    start = [0.0, 0.0, robot.stance_height, 1.0, 0.0, 0.0, 0.0, *robot.stance.tolist()]
    task.reset(_ENV, seeds=[0], command=velocity)
    task.place(_ENV, np.array([start]), np.zeros((1, robot.num_velocities)))
    # Otherwise the episode's phase is random.
    task.control.reset(_ENV, 0.0, task.control.commands.copy())
    observation = task.observe()
    steps = round(SECONDS / config.control_timestep)
    for _ in range(steps):
        observation = task.step(policy.predict(observation)).observation
    # In a contact the larger friction of the two counts.
    colliding = (simulation.model.geom_contype | simulation.model.geom_conaffinity) > 0
    friction = float(simulation.model.geom_friction[colliding, 0].max())
    end = simulation.data.qpos[:7].tolist()
    return {"start": start, "friction": friction, "command": velocity, "steps": steps, "end": end}
