"""What it looks like, live: a browser viewer over a controller that knows no browser."""

from quadruped_env.viewer.controller import RobotView, View, ViewController
from quadruped_env.viewer.gaits import GaitSettings
from quadruped_env.viewer.server import LOOPBACK, PORT
from quadruped_env.viewer.show import Pace, Show, open_show
from quadruped_env.viewer.sources import Source, find_sources
from quadruped_env.viewer.take import RESULTS

__all__ = [
    "LOOPBACK",
    "PORT",
    "RESULTS",
    "GaitSettings",
    "Pace",
    "RobotView",
    "Show",
    "Source",
    "View",
    "ViewController",
    "find_sources",
    "open_show",
]
