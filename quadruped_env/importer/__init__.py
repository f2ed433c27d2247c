"""Reader of four-legged robots from URDF, xacro and MJCF, and writer of their task files."""

from quadruped_env.importer.description import Finding
from quadruped_env.importer.imported_robot import ImportedRobot, import_robot

__all__ = ["Finding", "ImportedRobot", "import_robot"]
