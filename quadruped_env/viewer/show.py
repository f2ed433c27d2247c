"""The viewer: a `ViewController` in real time, its scene, controls and plots in every connected browser."""

import math
import os
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Final

from quadruped_env.control.velocity_command import out_of_range
from quadruped_env.errors import QuadrupedError
from quadruped_env.evaluation.conditions import Command
from quadruped_env.policies import Agent, find_controllers
from quadruped_env.policies.choices import RUNS
from quadruped_env.policies.policy import task_definition
from quadruped_env.simulation import Terrain, find_terrain
from quadruped_env.task import BUILT_IN, load_task_file
from quadruped_env.training.run_directory import CONFIG_FILE
from quadruped_env.utils.files import LATEST
from quadruped_env.viewer.access import page_address
from quadruped_env.viewer.live_plots import Plots
from quadruped_env.viewer.panel import Panel
from quadruped_env.viewer.server import LOOPBACK, PORT, import_viser, start_server, stop_server
from quadruped_env.viewer.snapshot import View
from quadruped_env.viewer.view_controller import ViewController
from quadruped_env.viewer.viewer_recording import RESULTS
from quadruped_env.viewer.viewer_scene import Scene

TICK: Final = 0.02
"""Loop period, one control step at normal speed, s."""
TICKS_PER_FRAME: Final = 2
TICKS_PER_PLOT: Final = 5


class Show:
    """A running viewer of a controller, which `close` also closes; arguments and errors as in `open_show`."""

    def __init__(
        self, controller: ViewController, host: str = LOOPBACK, port: int = PORT, allowed_hosts: Sequence[str] = ()
    ) -> None:
        self.controller = controller
        self._host = host
        self._stop = threading.Event()
        self._server = start_server(host, port, allowed_hosts)
        self._scene = Scene(self._server, controller.model(), controller.robot, controller.terrain)
        self.panel = Panel(self._server, controller, self._scene)
        self._plots = Plots(self._server, controller.command_ranges, controller.robot, controller.available.sources)
        self._server.on_client_disconnect(lambda _: self._left())
        self.draw(controller.view())

    @property
    def port(self) -> int:
        """Port that the server listens on."""
        return self._server.get_port()

    @property
    def address(self) -> str:
        """URL of the page for a browser on this machine."""
        return page_address(self._host, self.port)

    def clients(self) -> list[Any]:
        """Return the connected browsers, as viser client handles."""
        return list(self._server.get_clients().values())

    def draw(self, view: View) -> None:
        """Draw a view: scene, panel and plots."""
        self._draw_scene(view)
        self.panel.update(view)
        self._plots.update(view)

    def _draw_scene(self, view: View) -> None:
        if view.terrain != self._scene.terrain:
            self._scene.set_ground(self.controller.model(), view.terrain)
        self._scene.update(view)

    def run(self, seconds: float = math.inf) -> None:
        """Play in real time until `stop` is called, or for a time."""
        start = last = time.perf_counter()
        ticks = 0
        while not self._stop.is_set() and last - start < seconds:
            now = time.perf_counter()
            self.controller.advance(now - last)
            last = now
            if ticks % TICKS_PER_FRAME == 0:
                view = self.controller.view()
                self._draw_scene(view)
                if ticks % (TICKS_PER_FRAME * TICKS_PER_PLOT) == 0:
                    self.panel.update(view)
                    self._plots.update(view)
            ticks += 1
            late = time.perf_counter() - start - ticks * TICK
            if late > TICK:
                # Skip the missed ticks; the controller itself catches up.
                ticks += int(late / TICK)
            self._stop.wait(max(0.0, -late))

    def stop(self) -> None:
        """Make `run` return; may be called from a signal handler."""
        self._stop.set()

    def close(self) -> None:
        """Save the current recording and stop the server."""
        self.controller.close()
        stop_server(self._server)

    def _left(self) -> None:
        """End the recording when the last browser disconnects, since no user is left to end it."""
        if not self.clients():
            self.controller.stop_recording()


def open_show(
    asked: Sequence[str | Agent] = (),
    command: Command = (0.4, 0.0),
    host: str = LOOPBACK,
    port: int = PORT,
    results: Path = RESULTS,
    task_file: Path | None = None,
    terrain: str | Terrain | None = None,
    trust_task: bool = False,
    allowed_hosts: Sequence[str] = (),
) -> Show:
    """Open a show of the requested sources, ready to run.

    Args:
        asked: up to three of: a run's directory, a shipped policy, a scripted gait, a Python file of a policy, a file
            of joint states, or an object with the two methods of `Agent`. By default the latest run, or else the
            shipped policy.
        command: initial forward velocity in m/s, yaw rate in rad/s, and for robots that move sideways lateral velocity
            in m/s.
        host: the address to listen on.
        port: the first port to try; 0 takes any free port.
        results: directory for recordings.
        task_file: Python file of the terms or the robot that the runs were trained with; it is executed.
        terrain: a terrain, or the name of one, built-in or of that file; None: the ground of the first robot's task.
        trust_task: execute the copies of such files that these runs keep, instead of `task_file`.
        allowed_hosts: further hosts under which browsers reach the page, such as `localhost:9000` for a forwarded port.

    Raises:
        MissingExtraError: if viser or mjviser is not installed.
        QuadrupedError: if a requested source cannot be used, the command is out of range, or there is no such terrain.
    """
    import_viser()
    definition = BUILT_IN if task_file is None else load_task_file(task_file)
    if trust_task:
        asked = asked or [str(RUNS / LATEST)]
        run = next((source for source in map(str, asked) if os.path.exists(Path(source, CONFIG_FILE))), None)
        definition = BUILT_IN if run is None else task_definition(run, trust_task=True)
    ground = find_terrain(terrain, definition.terrains) if isinstance(terrain, str) else terrain
    sources, chosen = find_controllers(asked, task_file=task_file, trust_task=trust_task, robot=definition.robot)
    controller = ViewController(sources, chosen, results, definition.robot, ground, definition.terrains)
    try:
        if outside := out_of_range(command, controller.command_ranges):
            raise QuadrupedError(f"command: {outside}; give a command in this range")
        controller.set_command(*command)
        return Show(controller, host, port, allowed_hosts)
    except BaseException:
        controller.close()
        raise
