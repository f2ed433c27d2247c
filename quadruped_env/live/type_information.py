"""Publishers and subscriptions that announce no XTypes type information.

Two DDS peers that both announce the structure of their type compare the two, and ask each other for the types that it
holds. CycloneDDS 11 and Fast DDS 3 (ROS 2 Kilted) do not understand each other's answers: nothing arrives for any type
that holds another type or a sequence. A peer that gets no structure compares the type names instead, as every release
of Fast DDS, Cyclone DDS and ROS 2 can. ROS 2's own comparison, the type hash in the user data, does not depend on it.
"""

import ctypes
from typing import Any, Final


class _Operations(ctypes.Structure):
    """`struct ddsi_sertype_ops` of CycloneDDS: the functions of a type. Its layout goes with `version`."""

    _fields_ = [
        (name, ctypes.c_void_p)
        for name in (
            "version",
            "arg",
            "free",
            "zero_samples",
            "realloc_samples",
            "free_samples",
            "equal",
            "hash",
            "type_id",
            "type_map",
            "type_info",
            "derive_sertype",
            "get_serialized_size",
            "serialize_into",
        )
    ]


class _Type(ctypes.Structure):
    """The beginning of `struct ddsi_sertype`."""

    _fields_ = [("operations", ctypes.POINTER(_Operations))]


_KEPT: Final[list[_Operations]] = []
"""CycloneDDS may use a type for as long as the process lives."""


def withhold_type_information(topic: Any) -> bool:
    """Let the publishers and subscriptions that are made of a topic from now on announce no type information.

    CycloneDDS itself needs the information while the topic is made, and has no setting for this.

    Args:
        topic: of `cyclonedds`; before anything is made of it.

    Returns:
        Whether that was possible: False for a CycloneDDS that describes types in another way.
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
    # A table of its own for each topic: CycloneDDS merges types whose tables are the same.
    own = _Operations.from_buffer_copy(operations)
    own.type_id = own.type_map = own.type_info = None
    _KEPT.append(own)
    found.contents.operations = ctypes.pointer(own)
    return True
