"""Running shows of the viewer, and access to the state of their robots."""

import threading
from contextlib import contextmanager

import numpy as np

from quadruped_env.policies import find_controllers
from quadruped_env.viewer import Show, ViewController

DT = 0.02


@contextmanager
def showing(directory, *names, asked=()):
    """A show that runs in a thread of its own."""
    sources, chosen = find_controllers(asked, runs=directory / "runs")
    controller = ViewController(sources, names or chosen, directory / "results")
    show = Show(controller, port=0)
    thread = threading.Thread(target=show.run)
    thread.start()
    try:
        yield show
    finally:
        show.stop()
        thread.join()
        show.close()


def robot(controller, index=0):
    return controller._robots[index]


def now(controller, index=0):
    return controller.view().robots[index].now


def throw_on_the_back(controller):
    data = robot(controller).data
    data.qpos[2:7] = [0.1, 0.0, 1.0, 0.0, 0.0]


def joint_targets(controller, steps):
    """The joint targets (steps, 8) of the next control steps."""
    targets = []
    for _ in range(steps):
        controller.step()
        targets.append(robot(controller).data.ctrl.copy())
    return np.array(targets)
