"""The controls in the browser. Each one only passes its value to the `ViewController`."""

import math
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, Final

from quadruped_env.errors import QuadrupedError
from quadruped_env.gait.gait_settings import AMPLITUDES, FREQUENCIES
from quadruped_env.simulation.terrain import LEVELS
from quadruped_env.viewer.panel_text import key_html, keys_html, legend_html, status_html
from quadruped_env.viewer.snapshot import View
from quadruped_env.viewer.view_controller import MAX_PUSH, MAX_ROBOTS, SPEEDS, ViewController
from quadruped_env.viewer.viewed_robot import RANDOMIZATIONS
from quadruped_env.viewer.viewer_scene import CONTACT_FORCES, VELOCITIES, Scene

if TYPE_CHECKING:
    import viser

NONE: Final = "none"
NO_LEVEL: Final = "default"
ROBOTS: Final = ("Robot", "Compare with", "And with")
"""Labels of the lists of sources."""
PAUSE, RESUME, STEP, RESET = "Pause", "Resume", "Step", "Reset"
RECORD, SAVE = "Record", "Stop and save"
_SLIDERS: Final = ("Forward, m/s", "Turn left, rad/s", "To the left, m/s")
"""Labels of the velocities' sliders."""

_WIDTH: Final = 310
"""Panel width, pixels."""
# viser fades a scene in when its light has been loaded. On a slow machine the page's own light is loaded during the
# fade of viser's default light, which ends the fade and leaves the scene pale.
_UNFADED: Final = "<style>canvas[data-engine] { opacity: 1 !important }</style>"


class Panel:
    """The control panel of the viewer, which acts on a controller, and shows and hides overlays of a scene."""

    def __init__(self, server: "viser.ViserServer", controller: ViewController, scene: Scene) -> None:
        self._server = server
        self._controller = controller
        self._scene = scene
        # Held while controls are changed or handled: by browser callbacks and by the show's updates.
        self._lock = threading.RLock()
        self._setting = False
        self._shown_command = controller.command
        gui = server.gui
        gui.main_panel.dock_right()
        gui.main_panel.set_width(_WIDTH)
        gui.add_html(key_html(controller.robot) + _UNFADED)
        self._status = gui.add_html("")
        self._clock_buttons = gui.add_button_group("", (PAUSE, STEP, RESET))
        self._on(self._clock_buttons, lambda: self._press(self._clock_buttons.value))
        self._record = gui.add_button(RECORD, color="red", icon="player-record")
        self._on(self._record, self._toggle_recording)
        tabs = gui.add_tab_group()
        self._sources: list[Any] = []
        with tabs.add_tab("Drive"):
            if not controller.available.sources:
                self._add_gait()
            self._add_command()
            self._add_push()
            if controller.available.sources:
                self._add_playback()
        if controller.available.sources:
            with tabs.add_tab("Robots"):
                self._add_robots()
                self._add_gait()
                self._add_episodes()
        with tabs.add_tab("Show"):
            self._add_overlays()
        self._legend = gui.add_html("")
        self._keys = gui.add_html("")
        self._add_keys()
        self._show_offered()
        self._show_robots()

    def tell(self, message: str, bad: bool = False) -> None:
        """Show a notification in every browser."""
        for client in self._server.get_clients().values():
            client.add_notification(
                "Not possible" if bad else "MiniQuadruped",
                message,
                color="red" if bad else "blue",
                auto_close_seconds=12.0,
            )

    def update(self, view: View) -> None:
        """Show the current state."""
        _set(self._status, "content", status_html(view))
        _set(self._clock_buttons, "options", (RESUME if view.paused else PAUSE, STEP, RESET))
        _set(self._record, "label", RECORD if view.recorded is None else SAVE)
        if self._server.get_clients():
            for message in self._controller.messages():
                self.tell(message)
        # Do not block the show while a browser callback takes long.
        if self._lock.acquire(blocking=False):
            try:
                self._show_offered()
                self._show_command()
                if self._sources and self._controller.names != self._shown_names:
                    self._show_robots()
                if self._sources and self._controller.terrain != self._shown_terrain:
                    self._show_terrain()
                if self._controller.gait != self._shown_gait:
                    self._show_gait()
            finally:
                self._lock.release()

    # --- controls

    def _add_command(self) -> None:
        self._command_folder = self._server.gui.add_folder("Command")
        with self._command_folder:
            self._velocities = [
                self._server.gui.add_slider(label, min=entry.range[0], max=entry.range[1], step=0.01, initial_value=v)
                for label, entry, v in zip(
                    _SLIDERS, self._controller.command_ranges, self._controller.command, strict=False
                )
            ]
        for slider in self._velocities:
            self._on(slider, self._command)

    def _add_push(self) -> None:
        gui = self._server.gui
        self._push_folder = gui.add_folder("Disturb")
        with self._push_folder:
            self._direction = gui.add_slider(
                "To, degrees", min=-180, max=180, step=5, initial_value=90,
                hint="0 is forwards, 90 to the left, -90 to the right, 180 backwards.",
            )  # fmt: skip
            self._strength = gui.add_slider("Strength, m/s", min=0.0, max=MAX_PUSH, step=0.05, initial_value=0.5)
            self._on(gui.add_button("Push", icon="arrow-big-right"), self._push)

    def _add_playback(self) -> None:
        with self._server.gui.add_folder("Playback"):
            speed = self._server.gui.add_slider("Speed", min=SPEEDS[0], max=SPEEDS[1], step=0.1, initial_value=1.0)
        self._on(speed, lambda: self._controller.set_speed(speed.value))

    def _add_robots(self) -> None:
        gui, names = self._server.gui, tuple(self._controller.sources)
        with gui.add_folder("Side by side"):
            self._sources = [
                gui.add_dropdown(label, names if not i else (NONE, *names))
                for i, label in enumerate(ROBOTS[:MAX_ROBOTS])
            ]
            hint = "The robot that camera, plots and recordings follow"
            self._watched = gui.add_dropdown("Watch", self._controller.names, hint=hint)
        for index, dropdown in enumerate(self._sources):
            self._on(dropdown, partial(self._choose, index))
        self._on(self._watched, self._watch)

    def _add_gait(self) -> None:
        gui = self._server.gui
        self._gait_folder = gui.add_folder("Scripted gait")
        with self._gait_folder:
            (low, high), (slow, fast) = AMPLITUDES, FREQUENCIES
            amplitude = gui.add_slider("Amplitude", min=low, max=high, step=0.05, initial_value=1.0)
            frequency = gui.add_slider("Frequency, Hz", min=slow, max=fast, step=0.05, initial_value=slow)
            phases = [
                gui.add_slider(f"Phase {leg}, cycles", min=0.0, max=1.0, step=0.01, initial_value=0.0)
                for leg in self._controller.robot.leg_names
            ]
        self._amplitude, self._frequency, self._phases = amplitude, frequency, phases
        self._on(amplitude, lambda: self._set_gait(amplitude=amplitude.value))
        self._on(frequency, lambda: self._set_gait(frequency=frequency.value))
        for slider in phases:
            self._on(slider, lambda: self._set_gait(phases=tuple(each.value for each in phases)))

    def _add_episodes(self) -> None:
        gui, terrain = self._server.gui, self._controller.terrain
        names = tuple(entry.name for entry in self._controller.terrains)
        levels = (NO_LEVEL, *(str(level) for level in range(1, LEVELS + 1)))
        with gui.add_folder("Episodes"):
            # A policy's own terrain may be one that cannot be chosen again.
            self._terrain = gui.add_dropdown("Terrain", tuple(dict.fromkeys((*names, terrain.name))))
            self._level = gui.add_dropdown("Level", levels, hint=f"From 1 to {LEVELS}, which is the hardest.")
            choice = gui.add_dropdown("Randomize", tuple(RANDOMIZATIONS), initial_value=self._controller.randomization)
            restart = gui.add_checkbox("Stand up after a fall", self._controller.restart_after_fall)
        self._show_terrain()
        self._on(self._terrain, self._choose_terrain)
        self._on(self._level, self._choose_terrain)
        self._on(choice, lambda: self._controller.set_randomization(choice.value))
        self._on(restart, lambda: setattr(self._controller, "restart_after_fall", restart.value))

    def _add_overlays(self) -> None:
        gui = self._server.gui
        self._overlays = {name: gui.add_checkbox(name.capitalize(), True) for name in self._scene.visible}
        for name, box in self._overlays.items():
            self._on(box, partial(self._show_overlay, name, box))
        follow = gui.add_checkbox("Camera follows", True)
        self._on(follow, lambda: setattr(self._scene, "follow", follow.value))

    def _add_keys(self) -> None:
        sideways = (
            ("Sideways to the left", "Q", lambda: self._steer(lambda: self._controller.nudge(0, 0, 1))),
            ("Sideways to the right", "E", lambda: self._steer(lambda: self._controller.nudge(0, 0, -1))),
        )
        for label, key, action in (
            ("Faster", "arrowup", lambda: self._steer(lambda: self._controller.nudge(1, 0))),
            ("Slower, backwards", "arrowdown", lambda: self._steer(lambda: self._controller.nudge(-1, 0))),
            ("Turn left", "arrowleft", lambda: self._steer(lambda: self._controller.nudge(0, 1))),
            ("Turn right", "arrowright", lambda: self._steer(lambda: self._controller.nudge(0, -1))),
            *(sideways if self._controller.robot.moves_sideways else ()),
            ("Stand", "0", lambda: self._steer(lambda: self._controller.set_command(0.0, 0.0))),
            ("Pause or resume", "space", lambda: self._press(PAUSE)),
            ("One step", "N", lambda: self._press(STEP)),
            ("Reset", "R", lambda: self._press(RESET)),
            ("Push", "P", self._push),
            ("Record or save", "V", self._toggle_recording),
        ):
            self._server.gui.add_command(label, hotkey=key).on_trigger(self._guarded(action))

    # --- actions

    def _press(self, button: str) -> None:
        if not self._controller.offered.sources:
            return
        actions = {STEP: self._controller.step, RESET: self._controller.reset}
        actions.get(button, self._controller.toggle_pause)()

    def _toggle_recording(self) -> None:
        if self._record.label == RECORD:
            self._controller.start_recording()
            self._record.label = SAVE
        else:
            self._controller.stop_recording()
            self._record.label = RECORD

    def _command(self) -> None:
        self._shown_command = self._controller.set_command(*(slider.value for slider in self._velocities))

    def _steer(self, change: Callable[[], object]) -> None:
        if self._controller.offered.command:
            change()
            self._show_command()

    def _show_overlay(self, name: str, box: Any) -> None:
        self._scene.visible[name] = box.value

    def _push(self) -> None:
        if not self._controller.offered.push:
            return
        direction = math.radians(self._direction.value)
        self._controller.push(direction, self._strength.value)
        self._scene.show_push(direction, self._strength.value)

    def _choose_terrain(self) -> None:
        level = None if self._level.value == NO_LEVEL or not self._has_levels() else int(self._level.value)
        try:
            self._controller.set_terrain(self._terrain.value, level)
        finally:
            self._show_terrain()

    def _has_levels(self) -> bool:
        """Return True if the chosen terrain has levels."""
        return any(entry.hardest for entry in self._controller.terrains if entry.name == self._terrain.value)

    def _choose(self, index: int) -> None:
        name = self._sources[index].value
        try:
            if name != NONE or index < len(self._controller.robots):
                self._controller.set_source(index, None if name == NONE else name)
        finally:
            self._show_robots()

    def _watch(self) -> None:
        self._controller.watch(self._controller.names.index(self._watched.value))
        self._show_gait()

    def _set_gait(self, **changes: Any) -> None:
        gait = self._controller.gait
        if gait is not None:
            self._controller.set_gait(replace(gait, **changes))
            self._shown_gait = self._controller.gait

    # --- displayed values

    def _show_command(self) -> None:
        """Set the sliders to the command, if it was changed elsewhere."""
        command = self._controller.command
        if command == self._shown_command:
            return
        self._shown_command = command
        with self._without_actions():
            for slider, velocity in zip(self._velocities, command, strict=True):
                slider.value = velocity

    def _show_offered(self) -> None:
        """Hide controls without an effect."""
        offered = self._controller.offered
        _set(self._clock_buttons, "visible", offered.sources)
        _set(self._command_folder, "visible", offered.command)
        _set(self._push_folder, "visible", offered.push)
        _set(self._overlays[CONTACT_FORCES], "visible", offered.motion)
        _set(self._overlays[VELOCITIES], "visible", offered.motion or offered.command)
        _set(self._keys, "content", keys_html(self._controller.robot, offered))
        _set(self._legend, "content", legend_html(self._controller.robot, offered, self._scene.visible))

    def _show_terrain(self) -> None:
        """Set the lists to the terrain of the robots."""
        terrain = self._shown_terrain = self._controller.terrain
        with self._without_actions():
            _set(self._terrain, "value", terrain.name)
            _set(self._level, "value", NO_LEVEL if terrain.level is None else str(terrain.level))
            _set(self._level, "visible", self._has_levels())

    def _show_robots(self) -> None:
        names, distinct = self._controller.robots, self._controller.names
        self._shown_names = distinct
        if self._sources:
            with self._without_actions():
                for index, dropdown in enumerate(self._sources):
                    _set(dropdown, "value", names[index] if index < len(names) else NONE)
                _set(self._watched, "options", distinct)
                _set(self._watched, "value", distinct[self._controller.view().watched])
        self._show_gait()

    def _show_gait(self) -> None:
        gait = self._shown_gait = self._controller.gait
        self._gait_folder.visible = gait is not None
        if gait is None:
            return
        with self._without_actions():
            self._amplitude.value, self._frequency.value = gait.amplitude, gait.frequency
            for slider, phase in zip(self._phases, gait.phases, strict=True):
                slider.value = phase

    @contextmanager
    def _without_actions(self) -> Iterator[None]:
        """Return a context in which changed values of controls do not trigger their actions."""
        self._setting = True
        try:
            yield
        finally:
            self._setting = False

    def _on(self, control: Any, action: Callable[[], object]) -> None:
        """Run an action when a control is used."""
        guarded = self._guarded(action)
        (control.on_click if hasattr(control, "on_click") else control.on_update)(guarded)

    def _guarded(self, action: Callable[[], object]) -> Callable[[Any], None]:
        def run(_: Any) -> None:
            with self._lock:
                if self._setting:
                    return
                try:
                    action()
                except QuadrupedError as error:
                    self.tell(str(error), bad=True)

        return run


def _set(control: Any, name: str, value: Any) -> None:
    """Set a property if it differs, since browsers redraw it whenever it is set."""
    if getattr(control, name) != value:
        setattr(control, name, value)
