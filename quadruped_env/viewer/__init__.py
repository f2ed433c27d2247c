"""Live viewer in the browser, on top of a controller that does not depend on the browser."""

from quadruped_env.viewer.server import LOOPBACK, PORT
from quadruped_env.viewer.show import Show, open_show
from quadruped_env.viewer.snapshot import RobotView, View
from quadruped_env.viewer.view_controller import ViewController
from quadruped_env.viewer.viewer_recording import RESULTS

__all__ = ["LOOPBACK", "PORT", "RESULTS", "RobotView", "Show", "View", "ViewController", "open_show"]
