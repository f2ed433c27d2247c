"""Message types for DDS: name and structure, with CDR bytes that are passed through unchanged.

The bytes come from `quadruped_env.ros`, which also writes bags. The structure is declared, as the library needs it, but
not announced to peers: two that both announce it request the nested types from each other, and CycloneDDS 11 and Fast
DDS 3 (ROS 2 Kilted) do not understand each other's answers, so that no message arrives of a type that contains another
type or a sequence. A peer that gets no structure compares the type names, as every release of Fast DDS, Cyclone DDS and
ROS 2 can. ROS 2's own comparison, the type hash in the user data, does not depend on it.
"""

import ctypes
from functools import cache
from typing import Any, Final

from quadruped_env.live.middleware.dds import import_dds
from quadruped_env.ros import Field, message_type

_OPERATIONS: Final = (
    "version arg free zero_samples realloc_samples free_samples equal hash type_id type_map type_info derive_sertype "
    "get_serialized_size serialize_into"
)


@cache
def wire_type(type_name: str) -> Any:
    """Make the `cyclonedds` class of a message type; an instance holds the CDR bytes of one message as `data`.

    Args:
        type_name: `package/msg/Type`.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the type is unknown.
    """
    import_dds()
    from cyclonedds.idl import IdlStruct, annotations, make_idl_struct

    class Carrier(IdlStruct):
        def __init__(self, data: bytes) -> None:
            self.data = data

        def serialize(self, *_: Any, **__: Any) -> bytes:
            return self.data

        @classmethod
        def deserialize(cls, data: bytes, *_: Any, **__: Any) -> Any:
            return cls(data)

        # Called for the samples that report that a publisher has left.
        deserialize_key = deserialize

    kind = message_type(type_name)
    fields = {field.name: _member(field) for field in kind.fields}
    # cyclonedds replaces every dot by `::`.
    scoped = kind.dds_name.replace("::", ".")
    made = make_idl_struct(scoped.rpartition(".")[2], scoped, fields, dataclassify=False, bases=(Carrier,))
    return annotations.final(made)


def _member(field: Field) -> Any:
    from cyclonedds.idl import types

    if field.is_message:
        base = wire_type(field.base)
    else:
        base = {"string": str, "bool": bool}.get(field.base) or getattr(types, field.base)
    if not field.many:
        return base
    return types.sequence[base] if field.count is None else types.array[base, field.count]


class _Operations(ctypes.Structure):
    """`struct ddsi_sertype_ops` of CycloneDDS: the functions of a type. Its layout depends on `version`."""

    _fields_ = [(name, ctypes.c_void_p) for name in _OPERATIONS.split()]


class _Type(ctypes.Structure):
    """The beginning of `struct ddsi_sertype`."""

    _fields_ = [("operations", ctypes.POINTER(_Operations))]


_KEPT: Final[list[_Operations]] = []
"""Function tables kept alive, because CycloneDDS may use a type until the process ends."""


def withhold_type_information(topic: Any) -> bool:
    """Stop publishers and subscriptions created later with a topic from announcing its structure.

    CycloneDDS itself needs the structure while it creates the topic, and has no setting for this.

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
