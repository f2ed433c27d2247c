"""Export of policies: an ONNX graph from sensor readings to joint targets, a manifest, and a folder for a model hub."""

from quadruped_env.export.folder import Export, export_policy
from quadruped_env.export.manifest import MANIFEST_FILE
from quadruped_env.export.onnx_interface import PolicyInterface

__all__ = ["MANIFEST_FILE", "Export", "PolicyInterface", "export_policy"]
