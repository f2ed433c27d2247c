"""Choices in the viewer besides sources (terrain, disturbances), names of robots, offered controls and the legend."""

import itertools

import numpy as np
import pytest
from viewing import DT, now, robot

from quadruped_env import QuadrupedError, SinusoidalGait
from quadruped_env.evaluation.recorded_episode import publish
from quadruped_env.gait import COMMANDED
from quadruped_env.policies.files import SHIPPED
from quadruped_env.report import palette
from quadruped_env.robot import MINI_QUADRUPED
from quadruped_env.simulation import find_terrain, flat
from quadruped_env.viewer.panel_text import legend
from quadruped_env.viewer.viewed_robot import Offered
from quadruped_env.viewer.viewer_scene import OVERLAYS

SHOWN = dict.fromkeys(OVERLAYS, True)


# --- the terrain


def test_a_terrain_is_chosen_with_its_level_and_every_robot_begins_on_it(control):
    controller = control("policy flat", "gait trot")
    assert controller.terrain == controller.view().terrain == flat
    controller.set_command(0.3, 0.0)
    for _ in range(10):
        controller.advance(0.1)
    controller.set_terrain("stairs", 6)
    assert controller.view().terrain == controller.terrain == find_terrain("stairs").variant(level=6)
    assert controller.view().time == 0.0
    assert controller.robots == ("policy flat", "gait trot")
    assert controller.command == (0.3, 0.0)
    for index in range(2):
        assert robot(controller, index).terrain.level == 6
        heights = robot(controller, index).task.simulation.height_field
        # The steps of level 6 are 33 mm high.
        assert np.ptp(heights.points()[..., 2]) >= 0.033
        assert now(controller, index).time == 0.0
    # A robot that is added stands on the same ground.
    controller.set_source(2, "stand still")
    assert robot(controller, 2).terrain == controller.terrain
    controller.set_terrain("flat")
    assert {robot(controller, index).terrain for index in range(3)} == {flat}


def test_robots_on_uneven_ground_start_next_to_each_other_on_the_ground(control):
    controller = control("stand still", "stand still")
    for change in (("stand still", 2), (None, 1), ("gait trot", 2)):
        controller.set_source(change[1], change[0])
        controller.set_terrain("stairs", 8)
        robots = controller._robots
        places = [one.data.qpos[:2] for one in robots]
        for one, other in itertools.combinations(places, 2):
            assert np.linalg.norm(one - other) > 0.59
        for one in robots:
            field = one.task.simulation.height_field
            feet = one.history[-1].foot_position
            assert (feet[:, 2] - one.robot.foot_radius >= field.at(feet) - 1e-6).all()
        controller.set_terrain("flat")
        assert all((robot.data.qpos[:2] == 0.0).all() for robot in controller._robots)


def test_a_terrain_that_cannot_be_used_changes_nothing(control, monkeypatch):
    controller = control("policy flat")
    controller.set_terrain("slope", 2)
    controller.advance(DT)
    before = controller.view()
    for name, level, message in (
        ("moon", None, "'moon' is unknown"),
        ("hills", 3, "it has no levels"),
        ("slope", 11, "from 1 to 10; found 11"),
    ):
        with pytest.raises(QuadrupedError, match=message):
            controller.set_terrain(name, level)
        assert controller.terrain == find_terrain("slope").variant(level=2)
        assert controller.view().time == before.time

    def fail(*_):
        raise QuadrupedError("cannot be made")

    with monkeypatch.context() as patch:
        patch.setattr("quadruped_env.viewer.view_controller.TaskRobot", fail)
        with pytest.raises(QuadrupedError, match="cannot be made"):
            controller.set_terrain("stairs", 1)
    controller.set_source(1, "stand still")
    assert {robot(controller, index).terrain.name for index in range(2)} == {"slope"}


# --- names, controls and the legend


def test_robots_have_names_that_differ(control):
    controller = control("policy flat", "gait trot", "policy flat")
    assert controller.names == ("policy flat", "gait trot", "policy flat (2)")
    assert tuple(shown.name for shown in controller.view().robots) == controller.names
    controller.set_source(0, "gait pace")
    assert controller.names == ("gait pace", "gait trot", "policy flat")


def test_the_command_is_offered_if_a_robot_follows_it(control, tmp_path):
    path = tmp_path / "walk.csv"
    publish(SinusoidalGait.preset("trot"), 1.0, 50.0).save(path)
    controller = control(asked=[str(path)])
    follows = {}
    for name in controller.sources:
        controller.set_source(0, name)
        follows[name] = controller.offered.command
        assert controller.view().robots[0].follows_command is follows[name]
    assert {name for name, command in follows.items() if command} == {
        *(f"policy {name}" for name in SHIPPED),
        *(f"gait {name}" for name in COMMANDED),
    }
    controller.set_source(0, "gait article")
    controller.set_source(1, "gait tuned")
    assert controller.offered == Offered()
    controller.set_source(1, None)
    assert controller.offered == Offered(command=False)


def test_legend_names_every_colour_of_the_scene():
    found = legend(MINI_QUADRUPED, Offered(), SHOWN)
    assert {meaning: [colour for _, colour, _ in marks] for meaning, marks in found.items()} == {
        "commanded velocity and turn": [palette.COMMANDED],
        "measured velocity and turn": [palette.ACTUAL],
        "contact forces": [palette.CONTACT],
        "push": [palette.PUSH],
        "paths of the feet": list(palette.leg_colours(MINI_QUADRUPED).values()),
        "front of the robot": [palette.FRONT],
    }
    assert [name for _, _, name in found["paths of the feet"]] == list(MINI_QUADRUPED.leg_names)
