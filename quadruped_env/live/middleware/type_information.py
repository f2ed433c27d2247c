"""Publishers and subscriptions that announce no XTypes type information.

Two DDS peers that both announce the structure of their type compare the two, and request the nested types from each
other. CycloneDDS 11 and Fast DDS 3 (ROS 2 Kilted) do not understand each other's answers: no message arrives of any
type that contains another type or a sequence. A peer that gets no structure compares the type names instead, as every
release of Fast DDS, Cyclone DDS and ROS 2 can. ROS 2's own comparison, the type hash in the user data, does not depend
on it.
"""

import ctypes
from typing import Any, Final

_OPERATIONS: Final = (
    "version arg free zero_samples realloc_samples free_samples equal hash type_id type_map type_info derive_sertype "
    "get_serialized_size serialize_into"
)


class _Operations(ctypes.Structure):
    """`struct ddsi_sertype_ops` of CycloneDDS: the functions of a type. Its layout depends on `version`."""

    _fields_ = [(name, ctypes.c_void_p) for name in _OPERATIONS.split()]


class _Type(ctypes.Structure):
    """The beginning of `struct ddsi_sertype`."""

    _fields_ = [("operations", ctypes.POINTER(_Operations))]


_KEPT: Final[list[_Operations]] = []
"""Function tables kept alive, because CycloneDDS may use a type until the process ends."""


def withhold_type_information(topic: Any) -> bool:
    """Stop publishers and subscriptions created later with a topic from announcing type information.

    CycloneDDS itself needs the information while it creates the topic, and has no setting for this.

    Args:
        topic: a `cyclonedds` topic without publishers and subscriptions.

    Returns:
        True on success, False for a CycloneDDS release with another layout of type descriptions.
    """
    from cyclonedds.internal import DDS

    library = DDS._dll_handle
    found = ctypes.POINTER(_Type)()
    get_type = getattr(library, "dds_get_entity_sertype", None)
    version = getattr(library, "ddsi_sertype_v0", None)
    if get_type is None or version is None or get_type(topic._ref, ctypes.byref(found)) != 0:
        return False
    operations = found.contents.operations.contents
    if operations.version != ctypes.cast(version, ctypes.c_void_p).value:
        return False
    # Each topic needs its own table, because CycloneDDS merges types with identical tables.
    own = _Operations.from_buffer_copy(operations)
    own.type_id = own.type_map = own.type_info = None
    _KEPT.append(own)
    found.contents.operations = ctypes.pointer(own)
    return True
